// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingSourceSpacing_h
#define BitingSourceSpacing_h

#include "../../Kernel/Spacing/Spacing.h"
#include "../Drawing/PlaneFrame.h"
#include "../Run/ProblemReport.h"
#include "SourceData.h"

#include <cstddef>    // for numbers of points
#include <functional> // for what is asked of places
#include <optional>   // for grids
#include <string>     // for the refusal
#include <vector>     // for nodes

namespace biting
{

/// The points of an image or a rectilinear grid of one layer along a plane that is axis-aligned:
/// that in column i and row j has the number i * Along + j * Across.
struct PlaneGrid
{
  std::vector<double> XNodes; ///< ascending
  std::vector<double> YNodes; ///< ascending
  std::size_t Along = 1;
  std::size_t Across = 1;
};

/// None for other data, and where cells are left out.
std::optional<PlaneGrid> GridOf(vtkDataSet* source, const PlaneFrame& frame);

/// Makes the chosen array of `source` a source of `options`, in the plane `frame`.
///
/// Images and rectilinear grids of one layer along the plane, which is axis-aligned, are taken as
/// grids. Of any other data, cells with an area are triangulated and projected into the plane, and
/// cells with a volume are split into tetrahedra and cut by it. Hidden and ghost cells, cells with
/// a hidden point, and cells without area are no source. Where cells may overlap the smallest value
/// counts. On the globe the source is in degrees, and becomes triangles (SourceOnGlobe). Values
/// that are zero, negative or infinite where `isWanted` says no are none, as NaN: fill values
/// outside of the domain; elsewhere zero and negative ones count as options.Minimum where that is
/// given. Reads the source without changing it. Returns why it cannot be used, empty where it can;
/// `places` gets the values that are no spacing. Where the monitor asks to stop nothing is refused,
/// and the options have no meaning.
std::string AddSourceSpacing(const SourceData& source, const PlaneFrame& frame,
  const std::function<bool(const Point2&)>& isWanted, SpacingOptions& options,
  ProblemPlaces& places, Monitor& monitor);

} // namespace biting

#endif
