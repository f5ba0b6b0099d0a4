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

/// The input of the filter as the kernel takes it, with its plane and its coordinates in space.
/// Chains and points keep the ids of the input; points that no cell uses lie at the plane's origin.
struct PlanarInput
{
  /// A point that divides the line between two points of lower ids (Globe.h).
  struct Division
  {
    Id Start;
    Id End;
    double Share;
  };

  Polylines Chains;
  PlaneFrame Frame;
  vtkSmartPointer<vtkDoubleArray> Coordinates; ///< of the input, in space
  std::vector<std::uint8_t> IsUsed;            ///< one a point
  std::vector<Id> UsedPoints;                  ///< ascending
  bool IsOnGlobe = false;                      ///< x and y are degrees; set before it is read
  bool MayDivide = true;                       ///< lines on the globe; set before
  std::vector<Division> Divisions;             ///< the last points of Chains

  const double* Place(Id point) const { return this->Coordinates->GetPointer(3 * point); }
};

/// How far a point may lie from the plane, relative to the diagonal of the input's box; but no
/// nearer than the rounding of its coordinates (CoordinateRounding.h).
constexpr double PlanarTolerance = 1e-6;

/// Reads the cells of `drawing` as chains, block by block in the order of cells, and fits the
/// plane.
///
/// Lines are chains of automatic kind; two-dimensional cells are faces, strips a face for each
/// triangle; each point of a vertex cell is an embedded point. A numeric cell array `Kind` of the
/// block replaces the kind of lines, and makes interfaces (1) or embedded points (2) of faces. Left
/// out are hidden and duplicated cells, cells with a hidden point, faces of less than three points,
/// and empty cells. On the globe the plane is that of FitGlobe, whose refusals count, and lines are
/// divided (DivideLines). Faces are of one region where the cell array `regionArray` is equal, all
/// of one where it is empty or "None".
///
/// Returns a refusal, empty where the drawing can be read: of a cell with a volume or of an unknown
/// kind, of points that do not exist, of more points or cells than 32-bit ids can number.
/// Coordinates that are not finite, or off the plane, worst first, are added to `problems`. Where
/// the monitor asks to stop the result has no meaning.
std::string PolylinesFromDrawing(const Drawing& drawing, const std::string& regionArray,
  PlanarInput& result, ProblemList& problems, Monitor& monitor);

} // namespace biting

#endif
