// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingPolylinesFromPolyData_h
#define BitingPolylinesFromPolyData_h

#include "../../Kernel/Base/Monitor.h"
#include "../../Kernel/Base/Problem.h"
#include "../../Kernel/Domain/Polylines.h"
#include "Drawing.h"
#include "PlaneFrame.h"

#include "vtkDoubleArray.h"  // for coordinates
#include "vtkSmartPointer.h" // for coordinates

#include <cstdint> // for flags
#include <string>  // for the refusal
#include <vector>  // for points

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

/// How far a point may lie from the plane, relative to the diagonal of the input's box; but no
/// nearer than the rounding of its coordinates (CoordinateRounding.h).
constexpr double PlanarTolerance = 1e-6;

/// Reads the cells of `drawing` as ChainReader.h says, and fits their plane. Faces are of one
/// region where the cell array `regionArray` is the same, or all of one where it is empty or
/// "None". Returns why the drawing cannot be read, as text, empty where it can; coordinates that
/// are not finite, or off the plane, worst first, are added to `problems`. Where the monitor asks
/// to stop the result has no meaning.
std::string PolylinesFromDrawing(const Drawing& drawing, const std::string& regionArray,
  PlanarInput& result, ProblemList& problems, Monitor& monitor);

} // namespace biting

#endif
