// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingProducedEdges_h
#define BitingProducedEdges_h

#include "../../vtkBitingCompat.h" // for the ABI namespace

VTK_ABI_NAMESPACE_BEGIN
class vtkAlgorithm;
class vtkDataSet;
class vtkPolyData;
VTK_ABI_NAMESPACE_END

namespace biting
{

/// The boundary edges of the filter of ours from which the first input of `consumer` comes, by
/// whatever filters in between; null where there is none.
vtkPolyData* FindProducedEdges(vtkAlgorithm* consumer);

/// Whether each point of the edges is the point of the mesh that its `MeshPointId` names.
bool AreEdgesOf(vtkPolyData* edges, vtkDataSet* mesh);

/// FindProducedEdges, where these are edges of `mesh`, the input of `consumer`, and it has no lines
/// of its own; else null.
vtkPolyData* FindTaggedEdges(vtkAlgorithm* consumer, vtkDataSet* mesh);

} // namespace biting

#endif
