// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "MergedCones.h"

#include <algorithm> // for reverse
#include <limits>    // for infinity

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

/// The straight piece that segments of a chain become. From its start, each node leaves a sector of
/// directions in which the piece passes near it, and an interval of slopes that are near its value.
class Piece
{
public:
  Piece(const Node& start, const Node& end, double slope)
    : Gradation(slope)
    , Start(start)
    , End(end)
  {
  }

  const Node& First() const { return this->Start; }
  const Node& Last() const { return this->End; }

  /// Makes `next` the end. False, and nothing has changed, where the old end would be too far off.
  bool Extend(const Node& next)
  {
    const double share = 0.25 * MergingTolerance;
    const Point2 toEnd = this->End.Place - this->Start.Place;
    const double length = Length(toEnd);
    const double room = share * std::min(this->Start.Value, this->End.Value);
    const double distance = room / this->Gradation; // of the old end from the piece
    const bool isAhead = Dot(toEnd, next.Place - this->End.Place) >= 0.0;
    const double rise = this->End.Value - this->Start.Value;
    const bool isAtStart = !(length > distance); // wherever the piece leads to, it passes near
    if (!isAhead || (isAtStart && std::abs(rise) > room))
    {
      return false;
    }
    Piece longer = *this;
    longer.End = next;
    if (!isAtStart)
    {
      const Point2 aside = (distance / length) * Perpendicular(toEnd);
      longer.Narrow(toEnd - aside, toEnd + aside);
      longer.LeastSlope = std::max(this->LeastSlope, (rise - room) / length);
      longer.MostSlope = std::min(this->MostSlope, (rise + room) / length);
    }
    if (!longer.IsNear())
    {
      return false;
    }
    *this = longer;
    return true;
  }

private:
  void Narrow(const Point2& right, const Point2& left)
  {
    this->Right = !this->HasSector || Cross(this->Right, right) > 0.0 ? right : this->Right;
    this->Left = !this->HasSector || Cross(left, this->Left) > 0.0 ? left : this->Left;
    this->HasSector = true;
  }

  /// Whether it passes near all its nodes.
  bool IsNear() const
  {
    const Point2 along = this->End.Place - this->Start.Place;
    const double slope = (this->End.Value - this->Start.Value) / Length(along);
    const bool isInSector =
      !this->HasSector || (Cross(this->Right, along) >= 0.0 && Cross(along, this->Left) >= 0.0);
    return isInSector && slope >= this->LeastSlope && slope <= this->MostSlope;
  }

  double Gradation;
  Node Start;
  Node End;
  bool HasSector = false;
  Point2 Right; ///< where the sector begins, counterclockwise
  Point2 Left;  ///< where it ends
  double LeastSlope = -std::numeric_limits<double>::infinity();
  double MostSlope = std::numeric_limits<double>::infinity();
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
      piece.First().Place, piece.Last().Place, piece.First().Value, piece.Last().Value, slope);
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
  Piece piece(nodeOf(0), nodeOf(1), slope);
  for (std::size_t segment = 1; segment < count && pulse.Beat(); ++segment)
  {
    const Node start = nodeOf(2 * segment);
    const Node end = nodeOf(2 * segment + 1);
    const bool isNext = start.Place == piece.Last().Place && start.Value == piece.Last().Value;
    if (!isNext || !piece.Extend(end))
    {
      finish(piece);
      piece = Piece(start, end, slope);
    }
  }
  finish(piece);
  DropHigh(slope, cones, pulse);
  return cones;
}

} // namespace biting
