// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingPieceBytes_h
#define BitingPieceBytes_h

#include "../../vtkBitingCompat.h" // for the ABI namespace

#include "vtkSmartPointer.h" // for data objects

#include <vector> // for bytes

VTK_ABI_NAMESPACE_BEGIN
class vtkDataObject;
VTK_ABI_NAMESPACE_END

namespace biting
{

/// Adds a data object to `bytes`: a dataset or a tree of datasets, which may be null. Nothing is
/// lost: names of blocks, extents and axes of images come back bit for bit. Equal data make equal
/// bytes. False where it is of another kind.
bool PackPiece(vtkDataObject* piece, std::vector<char>& bytes);

/// The data object that PackPiece made these bytes of.
vtkSmartPointer<vtkDataObject> UnpackPiece(const char* bytes);

} // namespace biting

#endif
