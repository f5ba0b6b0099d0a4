// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Globe.h"

#include "../../Kernel/Base/Box.h"
#include "../../Kernel/Base/Numbers.h"
#include "../../Kernel/Quality/ExactSum.h"
#include "../../Kernel/Spacing/Spacing.h"
#include "../Run/ProblemReport.h"
#include "PolylinesFromDrawing.h"

#include <algorithm>  // for max, min, reverse
#include <array>      // for sums
#include <cmath>      // for angles
#include <functional> // for questions
#include <map>        // for divided lines
#include <optional>   // for the spacing, if it is asked
#include <utility>    // for pair

namespace biting
{

namespace
{

constexpr double FarthestDegrees = 170.0;

const double* PlaceAmong(const double* coordinates, Id point)
{
  return coordinates + 3 * static_cast<std::size_t>(point);
}

bool IsPole(const double* degrees)
{
  return std::abs(degrees[1]) >= 90.0;
}

// Zero where it is of rounding alone.
Point3 MeanDirection(const double* coordinates, const std::vector<Id>& points)
{
  constexpr double LeastLength = 1e-6;
  std::array<ExactSum, 3> sums; // of numbers that are not negative
  for (const Id point : points)
  {
    const Point3 direction = DirectionOf(PlaceAmong(coordinates, point));
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      sums[axis].Add(1.0 + direction[axis]);
    }
  }
  const auto count = static_cast<double>(points.size());
  const Point3 mean{ sums[0].Value() / count - 1.0, sums[1].Value() / count - 1.0,
    sums[2].Value() / count - 1.0 };
  const double length = std::sqrt(Dot(mean, mean));
  return length > LeastLength ? (1.0 / length) * mean : Point3{};
}

// About which longitudes are mapped back.
double LongitudeFor(const double* coordinates, const std::vector<Id>& points,
  const std::vector<Id>& ends, const Point3& middle)
{
  double low = Infinity;
  double high = -Infinity;
  for (const Id point : points)
  {
    const double* place = PlaceAmong(coordinates, point);
    low = IsPole(place) ? low : std::min(low, place[0]);
    high = IsPole(place) ? high : std::max(high, place[0]);
  }
  const bool isBeyond = low < -180.0 || high > 180.0;
  const double given = !isBeyond || low > high ? 0.0
    : low >= 0.0 && high <= 360.0              ? 180.0
                                               : 0.5 * (low + high);
  const auto isTorn = [coordinates, &ends, &middle](double longitude)
  {
    const PlaneFrame frame = PlaneFrame::OnGlobe(middle, longitude, 0.0);
    for (std::size_t k = 0; k < ends.size(); k += 2)
    {
      const double* a = PlaceAmong(coordinates, ends[k]);
      const double* b = PlaceAmong(coordinates, ends[k + 1]);
      if (!IsPole(a) && !IsPole(b) &&
        std::abs(frame.TurnedLongitude(a[0]) - frame.TurnedLongitude(b[0])) > 180.0)
      {
        return true;
      }
    }
    return false;
  };
  const double longitude = DegreesOf(middle).X;
  const double own = isBeyond || longitude >= 0.0 ? longitude : longitude + 360.0;
  const bool meetsItself = high - low > 360.0 - 1e-9; // parts that were cut at the jump
  return (meetsItself || isTorn(given)) && !isTorn(own) ? own : given;
}

// A line that is straight in degrees.
struct DegreesLine
{
  Point3 Start;
  Point3 Span;

  DegreesLine(const double* start, const double* end)
    : Start{ IsPole(start) ? end[0] : start[0], start[1], start[2] }
    , Span{ IsPole(start) || IsPole(end) ? 0.0 : std::remainder(end[0] - start[0], 360.0),
      end[1] - start[1], end[2] - start[2] }
  {
  }

  Point3 operator()(double share) const { return this->Start + share * this->Span; }
};

class LineDivider
{
public:
  LineDivider(const SpacingOptions* spacing, PlanarInput& input, Monitor& monitor)
    : Options(spacing)
    , Input(input)
    , Listener(monitor)
    , Beats(monitor)
    , Noise(4.0 * input.Chains.Rounding.X)
  {
    if (spacing)
    {
      const double least = spacing->Scale * LeastGiven(*spacing);
      this->Least = std::isfinite(least) ? std::max(least, spacing->Minimum) : 0.0;
      this->Least = spacing->Maximum > 0.0 ? std::min(this->Least, spacing->Maximum) : this->Least;
    }
  }

  void Run();

private:
  struct Part
  {
    double Begin;
    double End;
    Point2 Start;
    Point2 Stop;
    int Depth;
  };

  const std::vector<Id>& Between(Id start, Id end);
  void Divide(const DegreesLine& line, const Part& part, std::vector<double>& shares);
  bool IsStraight(const Part& part, double deviation);
  double SpacingAt(const Point2& place);
  Id AddPoint(const DegreesLine& line, Id start, Id end, double share);
  Point2 InPlane(const Point3& degrees) const { return this->Input.Frame.ToPlane(degrees.Data()); }

  const SpacingOptions* Options;
  PlanarInput& Input;
  Monitor& Listener;
  Pulse Beats;
  const double Noise; ///< what rounding may make of a straight line
  double Least = 0.0; ///< no f is below it
  std::optional<Spacing> F;
  std::map<std::pair<Id, Id>, std::vector<Id>> Known; ///< of lines that several cells share
  std::vector<Id> Along;
};

void LineDivider::Run()
{
  Polylines& chains = this->Input.Chains;
  std::vector<Id> connectivity;
  connectivity.reserve(chains.Connectivity.size());
  std::vector<Id> offsets{ 0 };
  offsets.reserve(chains.Offsets.size());
  for (std::size_t chain = 0; chain < chains.Kinds.size(); ++chain)
  {
    const bool arePoints = chains.Kinds[chain] == ChainKind::EmbeddedPoint;
    for (Id k = chains.Offsets[chain]; k < chains.Offsets[chain + 1] && this->Beats.Beat(); ++k)
    {
      if (k > chains.Offsets[chain] && !arePoints)
      {
        const std::vector<Id>& added =
          this->Between(chains.Connectivity[k - 1], chains.Connectivity[k]);
        connectivity.insert(connectivity.end(), added.begin(), added.end());
      }
      connectivity.push_back(chains.Connectivity[k]);
    }
    offsets.push_back(static_cast<Id>(connectivity.size()));
  }
  chains.Connectivity = std::move(connectivity);
  chains.Offsets = std::move(offsets);
}

// The same points for both directions.
const std::vector<Id>& LineDivider::Between(Id start, Id end)
{
  const double* first = this->Input.Place(start);
  const double* last = this->Input.Place(end);
  const bool isTurned = std::lexicographical_compare(last, last + 3, first, first + 3);
  const Id low = isTurned ? end : start;
  const Id high = isTurned ? start : end;
  this->Along.clear();
  const auto known = this->Known.find({ low, high });
  if (known != this->Known.end())
  {
    this->Along = known->second;
  }
  else
  {
    const DegreesLine line(this->Input.Place(low), this->Input.Place(high));
    std::vector<double> shares;
    this->Divide(line, { 0.0, 1.0, this->InPlane(line(0.0)), this->InPlane(line(1.0)), 0 }, shares);
    for (const double share : shares)
    {
      this->Along.push_back(this->AddPoint(line, low, high, share));
    }
    if (!this->Along.empty())
    {
      this->Known[{ low, high }] = this->Along;
    }
  }
  if (isTurned)
  {
    std::reverse(this->Along.begin(), this->Along.end());
  }
  return this->Along;
}

// By halves. Looks at three places, as a line may cross its chord in the middle.
void LineDivider::Divide(const DegreesLine& line, const Part& part, std::vector<double>& shares)
{
  constexpr int MostHalvings = 12;
  const Point2 chord = part.Stop - part.Start;
  const double length = Length(chord);
  double deviation = 0.0;
  for (const double share : { 0.25, 0.5, 0.75 })
  {
    const double at = part.Begin + share * (part.End - part.Begin);
    const Point2 offset = this->InPlane(line(at)) - part.Start;
    deviation =
      std::max(deviation, length > 0.0 ? std::abs(Cross(chord, offset)) / length : Length(offset));
  }
  if (part.Depth == MostHalvings || this->IsStraight(part, deviation))
  {
    return;
  }
  const double half = 0.5 * (part.Begin + part.End);
  const Point2 middle = this->InPlane(line(half));
  this->Divide(line, { part.Begin, half, part.Start, middle, part.Depth + 1 }, shares);
  shares.push_back(half);
  this->Divide(line, { half, part.End, middle, part.Stop, part.Depth + 1 }, shares);
}

// Enough so, or not longer than an edge of the mesh. f is asked for only where it may matter.
bool LineDivider::IsStraight(const Part& part, double deviation)
{
  const double length = Distance(part.Start, part.Stop);
  if (!this->Options)
  {
    return deviation <= std::max(DeviationInLength * length, this->Noise);
  }
  if (deviation <= std::max(DeviationInSpacing * this->Least, this->Noise))
  {
    return true;
  }
  const double f = this->SpacingAt(Midpoint(part.Start, part.Stop));
  return deviation <= DeviationInSpacing * f || length <= LongestEdge * f;
}

// Infinite where it cannot be: that is refused later.
double LineDivider::SpacingAt(const Point2& place)
{
  if (!this->F)
  {
    const Polylines& chains = this->Input.Chains;
    const Box2 bounds = Box2::Around(chains.Points, chains.Connectivity);
    ProblemList problems;
    this->F.emplace(MakeSpacing(*this->Options, bounds, problems, this->Listener));
    this->Least = problems.HasErrors() ? Infinity : this->Least;
  }
  return this->Least == Infinity ? Infinity : (*this->F)(place);
}

Id LineDivider::AddPoint(const DegreesLine& line, Id start, Id end, double share)
{
  PlanarInput& input = this->Input;
  const Point3 degrees = line(share);
  const Id point = static_cast<Id>(input.Chains.Points.size());
  input.Chains.Points.push_back(this->InPlane(degrees));
  input.Coordinates->InsertNextTypedTuple(degrees.Data());
  input.IsUsed.push_back(1);
  input.Divisions.push_back({ start, end, share });
  return point;
}

} // namespace

Point3 DirectionOf(const double* degrees)
{
  if (IsPole(degrees))
  {
    return { 0.0, 0.0, degrees[1] < 0.0 ? -1.0 : 1.0 };
  }
  const double reduced = std::remainder(degrees[0], 360.0);
  const double longitude = (reduced == -180.0 ? 180.0 : reduced) / DegreesPerRadian;
  const double latitude = degrees[1] / DegreesPerRadian;
  return { std::cos(latitude) * std::cos(longitude), std::cos(latitude) * std::sin(longitude),
    std::sin(latitude) };
}

Point2 DegreesOf(const Point3& direction)
{
  const double longitude = DegreesPerRadian * std::atan2(direction.Y, direction.X);
  return { longitude >= 180.0 ? longitude - 360.0 : longitude,
    DegreesPerRadian * std::atan2(direction.Z, std::hypot(direction.X, direction.Y)) };
}

std::string FitGlobe(const double* coordinates, const std::vector<Id>& points,
  const std::vector<Id>& ends, PlaneFrame& frame)
{
  std::string refusal =
    RefuseWhereNot([](const double* place) { return std::abs(place[1]) <= 90.0; }, points,
      coordinates, "Latitudes are between -90 and 90 degrees; points beyond",
      "Set Coordinates to Plane where x and y are no degrees.");
  if (!refusal.empty() || points.empty())
  {
    return refusal;
  }
  const Point3 north{ 0.0, 0.0, 1.0 };
  const Point3 mean = MeanDirection(coordinates, points);
  const double least = std::cos(FarthestDegrees / DegreesPerRadian);
  for (const Point3& middle : { mean, north, -1.0 * north })
  {
    const auto isNear = [&middle, least](const double* place)
    { return Dot(middle, DirectionOf(place)) >= least; };
    const Point2 degrees = DegreesOf(middle);
    const std::string far = RefuseWhereNot(isNear, points, coordinates,
      "The drawing goes around the globe: points more than 170 degrees from its middle, " +
        PlaceText({ degrees.X, degrees.Y, 0.0 }),
      "Divide the drawing.");
    const bool isNone = middle == Point3();
    if (!isNone && far.empty())
    {
      const double* first = PlaceAmong(coordinates, points.front());
      const double longitude = LongitudeFor(coordinates, points, ends, middle);
      frame = PlaneFrame::OnGlobe(middle, longitude, first[2]);
      return {};
    }
    refusal = refusal.empty() && !isNone ? far : refusal;
  }
  return refusal;
}

void DivideLines(const SpacingOptions* spacing, PlanarInput& input, Monitor& monitor)
{
  if (input.MayDivide)
  {
    LineDivider(spacing, input, monitor).Run();
  }
}

void ToMetres(const PlaneFrame& frame, const std::vector<Point2>& points,
  std::vector<double>& spacing, MeshQuality& quality)
{
  for (std::size_t vertex = 0; vertex < points.size() && frame.IsOnGlobe(); ++vertex)
  {
    const double stretch = frame.StretchAt(points[vertex]);
    spacing[vertex] /= stretch;
    quality.NearestNeighborDistance[vertex] /= stretch;
  }
}

void EndOnGlobe(const PlanarInput& input, std::int64_t numberOfPoints, BitingMesh& mesh)
{
  ToMetres(input.Frame, mesh.Points, mesh.Spacing, mesh.Quality);
  for (std::size_t vertex = 0; vertex < mesh.Points.size() && !input.Divisions.empty(); ++vertex)
  {
    if (mesh.OriginalPoints[vertex] >= numberOfPoints)
    {
      mesh.OriginalPoints[vertex] = NoId;
      mesh.Kinds[vertex] =
        mesh.Kinds[vertex] == VertexKind::Input ? VertexKind::Boundary : mesh.Kinds[vertex];
    }
  }
}

} // namespace biting
