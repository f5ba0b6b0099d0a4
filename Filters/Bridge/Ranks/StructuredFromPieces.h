// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingStructuredFromPieces_h
#define BitingStructuredFromPieces_h

#include "../../vtkBitingCompat.h" // for the ABI namespace

#include "vtkSmartPointer.h" // for datasets

#include <array>  // for extents
#include <vector> // for pieces

VTK_ABI_NAMESPACE_BEGIN
class vtkDataSet;
VTK_ABI_NAMESPACE_END

namespace biting
{

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
