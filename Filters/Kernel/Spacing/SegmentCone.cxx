// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SegmentCone.h"

#include "../Base/Numbers.h"

namespace biting
{
namespace
{

/// The slope with which the smallest value grows to the largest one over a distance of itself.
double SlopeWithinAnEdge(const SegmentSource& source)
{
  double least = Infinity;
  double most = 0.0;
  for (const Id point : source.Segments)
  {
    const double value = source.Values[point];
    least = std::min(least, value);
    most = std::max(most, value);
  }
  return (most - least) / least;
}

/// A place and the value there.
struct Node
{
  Point2 Place;
  double Value = 0.0;
};

/// What segments of a chain became.
struct Piece
{
  Node Start;
  Node End;
  double Error = 0.0; ///< how much f may have changed by that

  /// Makes `next` the end. False, and nothing has changed, where f would change too much: the old
  /// end goes to the same share of the longer piece, and what is before it goes no farther than it.
  bool Extend(const Node& next, double slope, double tolerance)
  {
    const Point2 toEnd = this->End.Place - this->Start.Place;
    const Point2 toNext = next.Place - this->Start.Place;
    const double share = Dot(toEnd, toNext) / Dot(toNext, toNext);
    const double rise = this->End.Value - this->Start.Value;
    const double error = this->Error + slope * Length(toEnd - share * toNext) +
      std::abs(rise - share * (next.Value - this->Start.Value));
    const double least = std::min({ this->Start.Value, this->End.Value, next.Value });
    if (!(share >= 0.0 && share <= 1.0 && error <= 0.5 * tolerance * least))
    {
      return false;
    }
    *this = { this->Start, next, error };
    return true;
  }
};

} // namespace

std::vector<SegmentCone> MakeCones(
  const SegmentSource& source, double scale, double gradation, Pulse& pulse, double tolerance)
{
  std::vector<SegmentCone> cones;
  const auto nodeOf = [&source, scale](std::size_t end)
  {
    const auto point = static_cast<std::size_t>(source.Segments[end]);
    return Node{ source.Points[point], scale * source.Values[point] };
  };
  for (std::size_t first = 0; first < source.Segments.size() && pulse.Beat();)
  {
    Piece piece{ nodeOf(first), nodeOf(first + 1) };
    for (first += 2; first < source.Segments.size() && pulse.Beat(); first += 2)
    {
      const Node start = nodeOf(first);
      const bool isNext = start.Place == piece.End.Place && start.Value == piece.End.Value;
      if (!isNext || !piece.Extend(nodeOf(first + 1), gradation, tolerance))
      {
        break;
      }
    }
    cones.emplace_back(
      piece.Start.Place, piece.End.Place, piece.Start.Value, piece.End.Value, gradation);
  }
  DropHigh(gradation, 0.5 * tolerance, cones, pulse);
  return cones;
}

double LargestSlope(const SegmentSource& source)
{
  double largest = 0.0;
  for (std::size_t first = 0; first + 1 < source.Segments.size(); first += 2)
  {
    const auto a = static_cast<std::size_t>(source.Segments[first]);
    const auto b = static_cast<std::size_t>(source.Segments[first + 1]);
    const double perLength = 1.0 / Distance(source.Points[a], source.Points[b]);
    const double slope = std::abs(source.Values[b] - source.Values[a]) * perLength;
    largest = std::isfinite(slope) ? std::max(largest, slope) : largest;
  }
  return largest;
}

double SlopeOfCones(const SegmentSource& source, double gradation)
{
  const double slope =
    gradation > 0.0 ? gradation : std::min(LargestSlope(source), SlopeWithinAnEdge(source));
  return slope > 0.0 ? slope : SpacingOptions().Gradation;
}

} // namespace biting
