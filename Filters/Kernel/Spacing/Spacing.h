// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingSpacing_h
#define BitingSpacing_h

#include "../Base/Box.h"
#include "../Base/Ids.h"
#include "../Base/Monitor.h"
#include "../Base/Point.h"
#include "../Base/Problem.h"

#include <cstdint>    // for masks
#include <functional> // for floors
#include <memory>     // for shared sources
#include <variant>    // for kinds of sources
#include <vector>     // for the arrays

namespace biting
{

/// k of SpacingOptions::Curvature: by how much lengths of the plane at x exceed those given.
inline double StretchAt(const Point2& x, double curvature)
{
  return curvature == 0.0 ? 1.0 : 1.0 + curvature * Dot(x, x);
}

/// A spacing given on a regular or rectilinear grid: bilinear between its nodes, the nearest border
/// value outside. Values[i + j * XNodes.size()] is at (XNodes[i], YNodes[j]). A node whose value is
/// NaN is a hole: it takes the value of the nearest node that has one. Without nodes: no source.
struct GridSource
{
  std::vector<double> XNodes; ///< ascending, at least one
  std::vector<double> YNodes; ///< ascending, at least one
  std::vector<double> Values;

  bool IsEmpty() const { return this->Values.empty(); }
};

/// A spacing given on triangles: linear on each, the value of the nearest border point outside.
/// Triangles without an area, and those with a corner value that is NaN, are holes: they count as
/// outside. Points without triangles are refused; without points: no source.
struct TriangulatedSource
{
  std::vector<Point2> Points;
  std::vector<double> Values; ///< one a point
  std::vector<Id> Triangles;  ///< three point ids each, any orientation

  /// Whether triangles may overlap: then the smallest value counts. Else the value of any triangle
  /// at the place counts, which takes less time.
  bool MayOverlap = false;

  /// Whether the domain is just where the triangles are: then f outside, which is asked for by
  /// rounding only, need not keep the gradation.
  bool CoversDomain = false;

  /// Whether the values keep the gradation as they are: then f is just as they say.
  bool IsGraded = false;

  bool IsEmpty() const { return this->Triangles.empty(); }
};

/// A spacing given at the ends of segments: linear along them, inwards the Lipschitz extension
/// min_i(f_i + g |x - x_i|). A point source is a segment with equal ends. Without segments: no
/// source.
///
/// The extension is the largest g-Lipschitz function that is nowhere above the given values: where
/// these are steeper than g, or a segment nearby asks for less, it is below them. With gradation 0,
/// g is the largest slope along the segments, up to that by which the smallest value grows to the
/// largest one over a distance of itself; where all are level and equal, f is their value
/// everywhere; where all are level but differ, g is the default.
struct SegmentSource
{
  std::vector<Point2> Points;
  std::vector<double> Values; ///< one a point
  std::vector<Id> Segments;   ///< two point ids each

  bool IsEmpty() const { return this->Segments.empty(); }

  /// Adds a segment with two points of its own, or a point source where these are equal.
  void Add(const Point2& start, const Point2& end, double startValue, double endValue)
  {
    const auto point = static_cast<Id>(this->Points.size());
    this->Points.insert(this->Points.end(), { start, end });
    this->Values.insert(this->Values.end(), { startValue, endValue });
    this->Segments.insert(this->Segments.end(), { point, point + 1 });
  }

  /// Adds the segments of another source that was filled by Add.
  void Join(const SegmentSource& other)
  {
    for (std::size_t k = 0; k < other.Points.size(); k += 2)
    {
      this->Add(other.Points[k], other.Points[k + 1], other.Values[k], other.Values[k + 1]);
    }
  }
};

/// A source of any kind, not null. A kind has Values and IsEmpty, which says that it is no source.
/// To add a kind: Filters/README.md, "How to add".
using GivenSource = std::variant<std::shared_ptr<const GridSource>,
  std::shared_ptr<const TriangulatedSource>, std::shared_ptr<const SegmentSource>>;

/// The segments and embedded points of a domain, whose local feature size caps f (the control
/// spacing of the paper, section 2.1). On a segment f is at most
/// - the distance d, through the domain, to the nearest segment or point that shares no end with
///   it, so that one layer of triangles fits into a channel; with n = CellsAcross above 1 also
///   d g / (2 exp(g n / 2) - 2), d to segments that face it, as f grows with g from both walls.
///   Segments face each other where their lines are within 45 degrees, the way from one to the
///   other is within 45 degrees of its normal, and the domain lies between. This cap is at least
///   min(given / 4, f by the lengths in Drawn), so that slits and thin walls do not become a
///   multitude of triangles, unless the drawing before simplification asked for them;
/// - 1.4 times its length, so that a short segment is one edge, for about three vertices a segment.
///   This cap is at least 2^-23 min(given, size of the drawing), the resolution of floats: around
///   a segment that short f grows over about 50 / g^2 vertices on each side;
/// and never less than Minimum asks for. Segments that meet do not count for each other, whatever
/// their angle. From there f grows with the gradation (the default, where that is 0).
struct FeatureSource
{
  std::vector<Point2> Points;
  std::vector<Id> Starts; ///< of each segment, a point id
  std::vector<Id> Ends;   ///< a point on no segment is given as one whose ends are equal
  std::vector<std::uint8_t> LeftInside; ///< 1: the domain lies left of start -> end
  std::vector<std::uint8_t> RightInside;

  /// Triangles across channels and walls: at least 1.
  int CellsAcross = 1;

  /// True: the cap for the distance has no lower bound but Minimum.
  bool IsDownToMinimum = false;

  /// Where a drawing was simplified: its segments as they were, each with its length at both ends.
  /// May be null.
  std::shared_ptr<const SegmentSource> Drawn;

  /// About how many pieces of length f / 2 the segments may have. Beyond that number capping stops:
  /// a mesh that fine is refused later, and the refusal should come soon.
  double MostPieces = std::numeric_limits<double>::infinity();

  /// The length of existing edges at a place. May be empty. The cap for the distance is at least
  /// 1.4 times that length: where the given f is already capped, as in remeshing, a quarter of it
  /// would be less with each run.
  std::function<double(const Point2&)> Floor;
};

class Spacing;

/// How fine the mesh shall be, as the user gives it: the minimum of what is given, times Scale,
/// clamped, capped by the feature size, and of that the largest function below it that is Lipschitz
/// with the constant Gradation: min over y of f(y) + g |x - y|, distances in the plane, also across
/// holes.
///
/// The plane may be the stereographic one of a sphere of radius R, which touches it at the origin.
/// Then Curvature is 1 / (4 R^2), what is given is in lengths of the sphere (along segments: in
/// lengths of the plane), and f in lengths of the plane: k(x) = 1 + Curvature |x|^2 times as
/// large. The gradation limits f in the plane; the slope on the sphere differs from that by at most
/// sqrt(k - 1) f / R.
struct SpacingOptions
{
  double Uniform = 0.0; ///< 0: none; where nothing else is given, 2 % of the diagonal of the domain
  double Scale = 1.0;
  double Minimum = 0.0;   ///< 0: no bound
  double Maximum = 0.0;   ///< 0: no bound
  double Gradation = 0.3; ///< g; 0 = as given
  std::vector<GivenSource> Sources;

  std::shared_ptr<const FeatureSource> Features; ///< may be null: no limit by feature size

  /// May be null. Not a source: where it asks for more than all the sources, f is raised, last of
  /// all, to max_i(f_i - g |x - x_i|) with f_i the values along its segments. Its values are meant
  /// as they are, neither scaled nor clamped. With gradation 0, g is the default.
  std::shared_ptr<const SegmentSource> Floor;

  double Curvature = 0.0; ///< 0: the plane itself, no sphere
};

/// The spacing f(x), in input length units: the edge length wanted at x. Positive and finite
/// everywhere. Constant cost per evaluation, except for points outside of a triangulated source and
/// near a floor, where it is about logarithmic. Evaluation changes nothing, so any number of
/// threads may evaluate at once.
///
/// Exact: f is never above what is given, never above Maximum, never below Minimum. Where what is
/// given is nowhere steeper than g, f is as given.
/// Tolerance: f is within 5 % of the largest g-Lipschitz function below what is given at 99 % of
/// all places, and within 10 % anywhere in the bounds it was prepared for. Where the given values
/// change within less than f / 2, the lowest of them counts. Where Gradation is above 1, f may be
/// further above.
/// Preparation: MakeSpacing.
class Spacing
{
public:
  Spacing();
  ~Spacing();
  Spacing(Spacing&&) noexcept;
  Spacing& operator=(Spacing&&) noexcept;

  double operator()(const Point2& x) const;

  /// f as it would be without SpacingOptions::Features. At logarithmic cost.
  double BeforeFeatures(const Point2& x) const;

  /// The largest slope of the given data that was seen while it was read (0 for uniform).
  double GivenLipschitz() const;

  /// True where f is one constant everywhere.
  bool IsUniform() const;

private:
  friend Spacing MakeSpacing(const SpacingOptions&, const Box2&, ProblemList&, Monitor&);
  struct Implementation;
  class Preparation;
  std::unique_ptr<const Implementation> Data;
};

/// Prepares f over `bounds` (the box of the domain). Where f cannot be, `problems` has the reasons
/// and the result is 1 everywhere: ProblemCode::BadSpacing
/// - with the point id of the source, its place, and a detail like "value -3 in the grid source",
///   for each value that is zero, negative or not finite (a NaN of a segment source; elsewhere it
///   is a hole, unless there is nothing else), also after scaling, and each position not finite
///   (a positive fill value, up to the largest double, is no problem, and limits nothing);
/// - without ids, and a detail that names the parameter, where an option is negative or not finite,
///   Scale is zero, or Minimum is above Maximum.
/// ProblemCode::Aborted where the monitor asked to stop.
Spacing MakeSpacing(
  const SpacingOptions& options, const Box2& bounds, ProblemList& problems, Monitor& monitor);

/// Adds these problems, except that for a source in which no triangle has an area and three values.
/// True if none was added. Also false if the monitor asks to stop.
bool CheckSpacing(
  const SpacingOptions& options, ProblemList& problems, Monitor& monitor = NoMonitor());

/// The least of all values given, before they are scaled; infinite where there is none.
double LeastGiven(const SpacingOptions& options);

} // namespace biting

#endif
