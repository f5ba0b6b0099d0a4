// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingPieceTransfer_h
#define BitingPieceTransfer_h

#include "../vtkBitingCompat.h" // for the ABI namespace

VTK_ABI_NAMESPACE_BEGIN
class vtkMultiProcessController;
class vtkPolyData;
VTK_ABI_NAMESPACE_END

namespace biting
{

/// Sends a mesh of triangles to another rank, which calls ReceivePiece: points, triangles, and
/// arrays of numbers on both, as they are in memory, of any size. Null: there is nothing to send.
/// Returns whether it has arrived: on both sides false where one of them has too little memory.
bool SendPiece(vtkMultiProcessController* controller, int toRank, vtkPolyData* piece);

/// Fills `output`, which is empty where nothing has arrived.
bool ReceivePiece(vtkMultiProcessController* controller, int fromRank, vtkPolyData* output);

} // namespace biting

#endif
