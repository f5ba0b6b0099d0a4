// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingPolylinesFromDrawing_h
#define BitingPolylinesFromDrawing_h

#include "../../Kernel/Base/Monitor.h"
#include "../../Kernel/Base/Problem.h"
#include "../../Kernel/Base/Pulse.h"
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

/// Reads the cells of `drawing` into `chains`, but for their points, in the order of the drawing:
/// verts, lines, polygons and strips of polydata, and the cells of other datasets as they come.
/// `regions` has a number for each cell, or is empty; `isUsed` gets 1 for points that chains use.
///
/// Lines are chains of automatic kind; two-dimensional cells are faces, strips a face for each
/// triangle; each point of a vertex cell is an embedded point. A numeric cell array `Kind` of the
/// block decides instead what a line is, and of faces whether they are interfaces (1) or embedded
/// points (2). Left out are hidden and duplicated cells, those with a hidden point, faces of less
/// than three points, and empty cells.
/// Returns why the drawing cannot be read, as text, empty where it can: a cell with a volume or of
/// an unknown kind, one whose points do not exist, more of anything than 32-bit ids can number.
std::string ReadChains(const Drawing& drawing, const std::vector<Id>& regions, Polylines& chains,
  std::vector<std::uint8_t>& isUsed, Pulse& pulse);

} // namespace biting

#endif
