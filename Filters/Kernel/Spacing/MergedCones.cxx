// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "MergedCones.h"

#include <algorithm> // for reverse

namespace biting
{
namespace
{

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
  bool Extend(const Node& next, double slope)
  {
    const Point2 toEnd = this->End.Place - this->Start.Place;
    const Point2 toNext = next.Place - this->Start.Place;
    const double share = Dot(toEnd, toNext) / Dot(toNext, toNext);
    const double rise = this->End.Value - this->Start.Value;
    const double error = this->Error + slope * Length(toEnd - share * toNext) +
      std::abs(rise - share * (next.Value - this->Start.Value));
    const double least = std::min({ this->Start.Value, this->End.Value, next.Value });
    if (!(share >= 0.0 && share <= 1.0 && error <= 0.5 * MergingTolerance * least))
    {
      return false;
    }
    *this = { this->Start, next, error };
    return true;
  }
};

/// Leaves out cones above the one that was kept last; then the same in the other direction.
void DropHigh(double slope, std::vector<SegmentCone>& cones, Pulse& pulse)
{
  for (int direction = 0; direction < 2; ++direction)
  {
    std::size_t kept = 0;
    for (std::size_t k = 0; k < cones.size() && pulse.Beat(1); ++k)
    {
      const SegmentCone cone = cones[k];
      const double most = 1.0 + 0.5 * MergingTolerance;
      const bool isHigh = kept > 0 && cones[kept - 1](cone.Start, slope) <= most * cone.Value &&
        cones[kept - 1](cone.End(), slope) <= most * (cone.Value + cone.Slope * cone.Length);
      if (!isHigh)
      {
        cones[kept++] = cone;
      }
    }
    cones.resize(kept);
    std::reverse(cones.begin(), cones.end());
  }
}

} // namespace

std::vector<SegmentCone> MergeCones(
  const SegmentSource& source, double scale, double slope, Pulse& pulse)
{
  std::vector<SegmentCone> cones;
  const auto finish = [&cones, slope](const Piece& piece)
  {
    cones.emplace_back(
      piece.Start.Place, piece.End.Place, piece.Start.Value, piece.End.Value, slope);
  };
  const auto nodeOf = [&source, scale](std::size_t end)
  {
    const auto point = static_cast<std::size_t>(source.Segments[end]);
    return Node{ source.Points[point], scale * source.Values[point] };
  };
  const std::size_t count = source.Segments.size() / 2;
  if (count == 0)
  {
    return cones;
  }
  Piece piece{ nodeOf(0), nodeOf(1) };
  for (std::size_t segment = 1; segment < count && pulse.Beat(); ++segment)
  {
    const Node start = nodeOf(2 * segment);
    const Node end = nodeOf(2 * segment + 1);
    const bool isNext = start.Place == piece.End.Place && start.Value == piece.End.Value;
    if (!isNext || !piece.Extend(end, slope))
    {
      finish(piece);
      piece = { start, end };
    }
  }
  finish(piece);
  DropHigh(slope, cones, pulse);
  return cones;
}

} // namespace biting
