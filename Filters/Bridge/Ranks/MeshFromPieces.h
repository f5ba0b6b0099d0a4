// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingMeshFromPieces_h
#define BitingMeshFromPieces_h

#include "../../vtkBitingCompat.h" // for the ABI namespace

#include "vtkSmartPointer.h" // for datasets

#include <vector> // for pieces

VTK_ABI_NAMESPACE_BEGIN
class vtkDataSet;
VTK_ABI_NAMESPACE_END

namespace biting
{

/// One dataset with the cells of all pieces: a polydata of polydata, an unstructured grid of
/// others; with the arrays that all of them have.
///
/// Ghost cells go; a ghost array stays where it hides cells or points. A cell that an earlier
/// piece has is left out: that is one of the same global id, or, without such, of the same type
/// and places of points. A point at the place of an earlier piece's is that point. Cells are in
/// the order of their global ids, else of the pieces, points in that of theirs, else as cells use
/// them; points that no cell uses go. Polyhedra are only appended.
vtkSmartPointer<vtkDataSet> MeshFromPieces(const std::vector<vtkSmartPointer<vtkDataSet>>& pieces);

} // namespace biting

#endif
