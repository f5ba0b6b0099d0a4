// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingBitesToPolyData_h
#define BitingBitesToPolyData_h

#include "../Kernel/BitingMesh.h"
#include "../vtkBitingCompat.h" // for the ABI namespace
#include "PlaneFrame.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkPolyData;
VTK_ABI_NAMESPACE_END

namespace biting
{

/// Fills `output` with the bites of `mesh` as polygons, one a bite, in their order, and with the
/// front that is left as lines. Lines come before polygons in the order of cells.
void BitesToPolyData(const BitingMesh& mesh, const PlaneFrame& frame, vtkPolyData* output);

/// The outline of the squares `first` to `end` - 1 of `bites`, which share their centre,
/// counterclockwise. For drawing: corners within rounding of another square may be left out.
std::vector<Point2> OutlineOfSquares(const Bites& bites, Id first, Id end);

} // namespace biting

#endif
