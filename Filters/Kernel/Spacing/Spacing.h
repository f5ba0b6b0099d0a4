// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingSpacing_h
#define BitingSpacing_h

#include "../Base/Box2.h"
#include "../Base/Ids.h"
#include "../Base/Monitor.h"
#include "../Base/Point2.h"
#include "../Base/Problem.h"

#include <cstdint> // for masks
#include <memory>  // for shared sources
#include <vector>  // for the arrays

namespace biting
{

/// A spacing given on a regular or rectilinear grid: bilinear between its nodes, the nearest border
/// value outside. Values[i + j * XNodes.size()] is at (XNodes[i], YNodes[j]). A node that is not
/// finite is no source: see TriangulatedSource.
struct GridSource
{
  std::vector<double> XNodes; ///< ascending, at least one
  std::vector<double> YNodes; ///< ascending, at least one
  std::vector<double> Values;
};

/// A spacing given on triangles: linear on each, the nearest border value outside.
/// Triangles with a corner value that is not finite are no source.
struct TriangulatedSource
{
  std::vector<Point2> Points;
  std::vector<double> Values; ///< one a point
  std::vector<Id> Triangles;  ///< three point ids each, any orientation
};

/// A spacing given at the ends of segments: linear along them, inwards the Lipschitz extension
/// min_i(f_i + g |x - x_i|). A point source is a segment with equal ends.
struct SegmentSource
{
  std::vector<Point2> Points;
  std::vector<double> Values; ///< one a point
  std::vector<Id> Segments;   ///< two point ids each
};

/// How fine the mesh shall be, as the user gives it. See DESIGN "The spacing f(x)": the minimum of
/// what is given, times Scale, clamped.
struct SpacingOptions
{
  double Uniform = 0.0; ///< 0: none; where nothing else is given, 2 % of the diagonal of the domain
  double Scale = 1.0;
  double Minimum = 0.0;                                    ///< 0: no bound
  double Maximum = 0.0;                                    ///< 0: no bound
  double Gradation = 0.3;                                  ///< g, Lipschitz constant; 0 = as given
  std::shared_ptr<const GridSource> Grid;                  ///< may be null
  std::shared_ptr<const TriangulatedSource> Triangulation; ///< may be null
  std::shared_ptr<const SegmentSource> Segments;           ///< may be null
};

/// The spacing f(x), in input length units: the edge length wanted at x. Positive and finite
/// everywhere. Constant cost per evaluation; evaluation changes nothing, so any number of threads
/// may evaluate at once.
class Spacing
{
public:
  Spacing();
  ~Spacing();
  Spacing(Spacing&&) noexcept;
  Spacing& operator=(Spacing&&) noexcept;

  double operator()(const Point2& x) const;

  /// The largest slope of the given data that was seen while it was read (0 for uniform).
  double GivenLipschitz() const;

  /// True where f is one constant everywhere.
  bool IsUniform() const;

private:
  friend Spacing MakeSpacing(const SpacingOptions&, const Box2&, ProblemList&, Monitor&);
  struct Implementation;
  std::unique_ptr<const Implementation> Data;
};

/// Prepares f over `bounds` (the box of the domain). Values that are zero, negative or not finite
/// are refused: ProblemCode::BadSpacing with the point id of the source and its place.
Spacing MakeSpacing(
  const SpacingOptions& options, const Box2& bounds, ProblemList& problems, Monitor& monitor);

} // namespace biting

#endif
