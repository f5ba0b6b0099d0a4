// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingBitesToPolyData_h
#define BitingBitesToPolyData_h

#include "../../Kernel/Base/Pulse.h"
#include "../../Kernel/BitingMesh.h"
#include "../../vtkBitingCompat.h" // for the ABI namespace
#include "../Drawing/PlaneFrame.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkPolyData;
VTK_ABI_NAMESPACE_END

namespace biting
{

/// Fills `output` with the bites of `mesh` as polygons, one a bite, in their order, and with the
/// front that is left as lines. A circle is drawn as a regular polygon with 32 corners on it. Lines
/// come before polygons in the order of cells. On abort `output` has no meaning.
void BitesToPolyData(
  const BitingMesh& mesh, const PlaneFrame& frame, vtkPolyData* output, Pulse& pulse);

/// The outline of the bite that is made of the entries `first` to `end` - 1 of `bites`: squares
/// that share their centre, or one circle; counterclockwise. For drawing: corners within rounding
/// of another square may be left out.
std::vector<Point2> OutlineOfBite(const Bites& bites, Id first, Id end);

} // namespace biting

#endif
