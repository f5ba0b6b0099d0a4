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
/// value outside. Values[i + j * XNodes.size()] is at (XNodes[i], YNodes[j]). A node whose value is
/// NaN is a hole: it takes the value of the nearest node that has one. Without nodes: no source.
struct GridSource
{
  std::vector<double> XNodes; ///< ascending, at least one
  std::vector<double> YNodes; ///< ascending, at least one
  std::vector<double> Values;
};

/// A spacing given on triangles: linear on each, the value of the nearest border point outside.
/// Triangles without an area, and those with a corner value that is NaN, are holes: they count as
/// outside. Points without triangles are refused; without points: no source.
struct TriangulatedSource
{
  std::vector<Point2> Points;
  std::vector<double> Values; ///< one a point
  std::vector<Id> Triangles;  ///< three point ids each, any orientation
};

/// A spacing given at the ends of segments: linear along them, inwards the Lipschitz extension
/// min_i(f_i + g |x - x_i|). A point source is a segment with equal ends. Without segments: no
/// source.
///
/// The extension is the largest g-Lipschitz function that is nowhere above the given values: where
/// these are steeper than g, or a segment nearby asks for less, it is below them. It is kept to
/// within 1.25 % of its value, 0.1 % in the mean, over the bounds of the domain; beyond these it is
/// that of the nearest point of the bounds. With gradation 0, g is the largest slope along the segments; where all are
/// level and equal, f is their value everywhere; where all are level but differ, g is the default.
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
/// everywhere. Constant cost per evaluation, but for points outside of a triangulated source, where
/// it is logarithmic. Evaluation changes nothing, so any number of threads may evaluate at once.
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

/// Prepares f over `bounds` (the box of the domain). Where f cannot be, `problems` has the reasons
/// and the result is 1 everywhere: ProblemCode::BadSpacing
/// - with the point id of the source, its place, and a detail like "value -3 in the grid source",
///   for each value that is zero, negative or not finite (a NaN of a segment source; elsewhere it is
///   a hole, unless there is nothing else), also after scaling, and each position not finite;
/// - without ids, and a detail that names the parameter, where an option is negative or not finite,
///   Scale is zero, or Minimum is above Maximum.
/// ProblemCode::Aborted where the monitor asked to stop.
Spacing MakeSpacing(
  const SpacingOptions& options, const Box2& bounds, ProblemList& problems, Monitor& monitor);

} // namespace biting

#endif
