// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingPolylinesFromPolyData_h
#define BitingPolylinesFromPolyData_h

#include "../Kernel/Base/Monitor.h"
#include "../Kernel/Base/Problem.h"
#include "../Kernel/Domain/Polylines.h"
#include "../vtkBitingCompat.h" // for the ABI namespace
#include "PlaneFrame.h"

#include "vtkDoubleArray.h"  // for coordinates
#include "vtkSmartPointer.h" // for coordinates

#include <cstdint> // for flags
#include <string>  // for the refusal
#include <vector>  // for points

VTK_ABI_NAMESPACE_BEGIN
class vtkPolyData;
VTK_ABI_NAMESPACE_END

namespace biting
{

/// The input of the filter as the kernel takes it, and what leads back to space.
/// Chains and points keep the ids of the input; points that no cell uses lie at the plane's origin.
struct PlanarInput
{
  Polylines Chains;
  PlaneFrame Frame;
  vtkSmartPointer<vtkDoubleArray> Coordinates; ///< of the input, in space
  std::vector<std::uint8_t> IsUsed;            ///< one a point
  std::vector<Id> UsedPoints;                  ///< ascending

  const double* Place(Id point) const { return this->Coordinates->GetPointer(3 * point); }
};

/// How far a point may lie from the plane, relative to the diagonal of the input's box.
constexpr double PlanarTolerance = 1e-6;

/// Reads `input`. Lines are chains; polygons are closed boundary chains; each point of a vertex cell
/// is an embedded point; triangle strips are left out. A numeric cell array `Kind` decides instead
/// what a line or polygon is. Returns why the input cannot be read, as text, empty where it can;
/// coordinates that are not finite, or off the plane, worst first, are added to `problems`. Where the
/// monitor asks to stop the result has no meaning.
std::string PolylinesFromPolyData(
  vtkPolyData* input, PlanarInput& result, ProblemList& problems, Monitor& monitor);

} // namespace biting

#endif
