// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingWholeFromPieces_h
#define BitingWholeFromPieces_h

#include "../../vtkBitingCompat.h" // for the ABI namespace

#include "vtkSmartPointer.h" // for data objects

#include <array>  // for extents
#include <vector> // for pieces

VTK_ABI_NAMESPACE_BEGIN
class vtkDataObject;
class vtkDataSet;
VTK_ABI_NAMESPACE_END

namespace biting
{

using Pieces = std::vector<vtkSmartPointer<vtkDataObject>>;

/// One data object of the pieces of one, in the order of ranks; pieces may be null.
///
/// Where one piece has everything, it is the whole as it is. Else images, rectilinear and
/// structured grids that tile their common extent become one of these; other datasets become one
/// polydata, or one unstructured grid, of their cells. Blocks of trees are put together one by one,
/// and what parts of a partitioned dataset several pieces have become one part.
/// Ghost cells go; hidden ones stay hidden, whether or not all pieces have ghost arrays. What
/// several pieces have counts once: cells of the same global id, or, without such, of the same
/// type with the same points; points at the same place. Cells and points are in the order of
/// their global ids where they have some, else cells are in that of the pieces, and points in the
/// order in which cells use them; points that no cell uses go. Polyhedra are only appended.
vtkSmartPointer<vtkDataObject> WholeFromPieces(const Pieces& pieces);

/// One image, rectilinear or structured grid of `pieces`, which are of one such class; with the
/// arrays that all of them have. Null where they are not, lie on different axes, or leave gaps in
/// the box of their extents. Where pieces overlap, the first counts; ghost cells count where no
/// other is.
vtkSmartPointer<vtkDataSet> StructuredFromPieces(
  const std::vector<vtkSmartPointer<vtkDataSet>>& pieces);

/// The extent of an image, a rectilinear or a structured grid; false for other data.
bool FindExtent(vtkDataSet* piece, std::array<int, 6>& extent);

} // namespace biting

#endif
