// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "EvenOddArea.h"

#include "Base/Box.h"
#include "ExactSigns.h"
#include "WholeNumbers.h"

#include <algorithm> // for sort
#include <cmath>     // for abs
#include <limits>    // for epsilon

namespace biting
{

namespace
{

/// Places along a segment are counted in 2^-PlaceBits of it.
constexpr int PlaceBits = 256;
constexpr int BlurBits = 200;

/// Shorter pieces are left out: their ends, each less than 1 off, may not be in order.
constexpr int LeastPiece = 4;

/// A segment from left to right; also in whole numbers, relative to the low corner of the drawing's
/// box.
struct DirectedSegment
{
  Point2 Left;
  Point2 Right;
  WholePoint Start;
  WholePoint Along;
};

/// The even-odd area as a sum over all pieces of segments between places where they meet: of the
/// area below a piece, taken as positive where an odd number of segments lies below the piece.
/// Upright segments have none below them, and lie below nothing.
///
/// Of segments on top of each other those that come before count as below, so that equal pieces
/// cancel in pairs. How many lie below is asked at the middle of a piece, which is a place in whole
/// numbers: the answer is exact. The ends of pieces are rounded by less than 2^-PlaceBits of their
/// segment; each moves the area by no more than that part of the box, twice. There are fewer than
/// 2^40 ends.
class PieceSum
{
public:
  explicit PieceSum(const Drawing& drawing);

  Rational Area() const;

private:
  void Add(const Point2& left, const Point2& right);
  std::vector<Whole> Ends(const DirectedSegment& segment) const;
  void AddMeetings(
    const DirectedSegment& segment, const DirectedSegment& other, std::vector<Whole>& ends) const;
  bool HasOddBelow(const DirectedSegment& segment, const Whole& doubledPlace) const;
  bool IsBelow(const DirectedSegment& other, const DirectedSegment& segment, const Point2& about,
    const Whole& doubledPlace) const;
  bool IsExactlyBelow(
    const DirectedSegment& other, const DirectedSegment& segment, const Whole& doubledPlace) const;

  std::vector<DirectedSegment> Segments;
  int Unit = GreatestUnit; ///< an exponent of 2
  WholePoint Origin;
  double Rounding; ///< above that of a place which is computed in double arithmetic
};

Box2 BoxOf(const Drawing& drawing)
{
  Box2 box;
  for (const DrawnSegment& segment : drawing.Segments)
  {
    box.Add(segment.Start);
    box.Add(segment.End);
  }
  return box;
}

PieceSum::PieceSum(const Drawing& drawing)
  : Rounding(8.0 * std::numeric_limits<double>::epsilon() * drawing.Largest)
{
  for (const DrawnSegment& segment : drawing.Segments)
  {
    this->Unit = std::min({ this->Unit, UnitOf(segment.Start), UnitOf(segment.End) });
  }
  this->Origin = ToWhole(BoxOf(drawing).Low, this->Unit);
  for (const DrawnSegment& segment : drawing.Segments)
  {
    if (segment.Bounds)
    {
      const bool isForward = segment.Start.X < segment.End.X;
      this->Add(isForward ? segment.Start : segment.End, isForward ? segment.End : segment.Start);
    }
  }
}

void PieceSum::Add(const Point2& left, const Point2& right)
{
  const WholePoint start = ToWhole(left, this->Unit);
  this->Segments.push_back(
    { left, right, start - this->Origin, ToWhole(right, this->Unit) - start });
}

/// Below a piece from s to t of the segment a + t d lies d.X (a.Y (t - s) + d.Y (t^2 - s^2) / 2).
Rational PieceSum::Area() const
{
  Whole sum = 0;
  for (const DirectedSegment& segment : this->Segments)
  {
    const std::vector<Whole> ends = this->Ends(segment);
    for (std::size_t k = 1; k < ends.size(); ++k)
    {
      const Whole length = ends[k] - ends[k - 1];
      if (length < LeastPiece)
      {
        continue;
      }
      const Whole doubledPlace = ends[k] + ends[k - 1];
      const Whole doubledHeight =
        (segment.Start.Y << (PlaceBits + 1)) + segment.Along.Y * doubledPlace;
      const Whole below = segment.Along.X * doubledHeight * length;
      sum += this->HasOddBelow(segment, doubledPlace) ? below : Whole(-below);
    }
  }
  const int unit = 2 * this->Unit - 2 * PlaceBits - 1;
  return unit < 0 ? Rational(sum, Whole(1) << -unit) : Rational(sum << unit);
}

/// Of its pieces, sorted.
std::vector<Whole> PieceSum::Ends(const DirectedSegment& segment) const
{
  std::vector<Whole> ends{ Whole(0), Whole(1) << PlaceBits };
  for (const DirectedSegment& other : this->Segments)
  {
    const bool areApart = other.Right.X < segment.Left.X || segment.Right.X < other.Left.X ||
      std::max(other.Left.Y, other.Right.Y) < std::min(segment.Left.Y, segment.Right.Y) ||
      std::max(segment.Left.Y, segment.Right.Y) < std::min(other.Left.Y, other.Right.Y);
    if (&other != &segment && !areApart)
    {
      this->AddMeetings(segment, other, ends);
    }
  }
  std::sort(ends.begin(), ends.end());
  return ends;
}

bool IsStrictlyBetween(double x, double low, double high)
{
  return low < x && x < high;
}

/// Ends of the other on the segment, and where the two cross within both.
void PieceSum::AddMeetings(
  const DirectedSegment& segment, const DirectedSegment& other, std::vector<Whole>& ends) const
{
  const int left = ExactOrientation(segment.Left, segment.Right, other.Left);
  const int right = ExactOrientation(segment.Left, segment.Right, other.Right);
  const auto addEnd = [this, &segment, &ends](const Point2& end)
  {
    if (IsStrictlyBetween(end.X, segment.Left.X, segment.Right.X))
    {
      const Whole along = ToWhole(end.X, this->Unit) - this->Origin.X - segment.Start.X;
      ends.push_back((along << PlaceBits) / segment.Along.X);
    }
  };
  if (left == 0)
  {
    addEnd(other.Left);
  }
  if (right == 0)
  {
    addEnd(other.Right);
  }
  const int start = ExactOrientation(other.Left, other.Right, segment.Left);
  const int end = ExactOrientation(other.Left, other.Right, segment.Right);
  if (left * right < 0 && start * end < 0)
  {
    const Whole slope = Cross(segment.Along, other.Along);
    const Whole along = Cross(other.Start - segment.Start, other.Along);
    ends.push_back((along << PlaceBits) / slope);
  }
}

/// Below the place on the segment, which is given in halves of places.
bool PieceSum::HasOddBelow(const DirectedSegment& segment, const Whole& doubledPlace) const
{
  const double place = doubledPlace.convert_to<double>() * std::ldexp(1.0, -PlaceBits - 1);
  const Point2 about = segment.Left + place * (segment.Right - segment.Left);
  bool isOdd = false;
  for (const DirectedSegment& other : this->Segments)
  {
    isOdd ^= &other != &segment && this->IsBelow(other, segment, about, doubledPlace);
  }
  return isOdd;
}

/// Asks numbers in double arithmetic first. A cross product of differences is off by no more than 8
/// roundings of the longer of the two; `about` is off by less than this->Rounding.
bool PieceSum::IsBelow(const DirectedSegment& other, const DirectedSegment& segment,
  const Point2& about, const Whole& doubledPlace) const
{
  if (about.X < other.Left.X - this->Rounding || about.X > other.Right.X + this->Rounding)
  {
    return false;
  }
  const Point2 along = other.Right - other.Left;
  const double side = Cross(along, about - other.Left);
  const double bound = 4.0 * this->Rounding * (std::abs(along.X) + std::abs(along.Y));
  const bool isWithin =
    IsStrictlyBetween(about.X, other.Left.X + this->Rounding, other.Right.X - this->Rounding);
  return isWithin && std::abs(side) > bound ? side > 0.0
                                            : this->IsExactlyBelow(other, segment, doubledPlace);
}

bool PieceSum::IsExactlyBelow(
  const DirectedSegment& other, const DirectedSegment& segment, const Whole& doubledPlace) const
{
  const WholePoint offset = segment.Start - other.Start;
  const Whole x = (offset.X << (PlaceBits + 1)) + segment.Along.X * doubledPlace;
  const Whole y = (offset.Y << (PlaceBits + 1)) + segment.Along.Y * doubledPlace;
  if (x < 0 || x >= other.Along.X << (PlaceBits + 1))
  {
    return false;
  }
  const int side = Whole(other.Along.X * y - other.Along.Y * x).sign();
  return side > 0 || (side == 0 && &other < &segment);
}

double BoundaryLength(const Drawing& drawing)
{
  double length = 0.0;
  for (const DrawnSegment& segment : drawing.Segments)
  {
    length += segment.Bounds ? Distance(segment.Start, segment.End) : 0.0;
  }
  return length;
}

} // namespace

EvenOddArea MeasureEvenOddArea(const Drawing& drawing)
{
  if (drawing.Segments.empty())
  {
    return {};
  }
  const double length = BoundaryLength(drawing);
  return { PieceSum(drawing).Area(), drawing.Slack() * (length + drawing.Slack()) };
}

EvenOddArea SumOfFaces(const Drawing& drawing)
{
  EvenOddArea sum;
  for (const std::vector<DrawnSegment>& face : FacesOf(drawing))
  {
    const EvenOddArea area = MeasureEvenOddArea(drawing.Of(face));
    sum.Area += area.Area;
    sum.Tolerance += area.Tolerance;
  }
  return sum;
}

Rational Blur(const Drawing& drawing)
{
  const Box2 box = BoxOf(drawing);
  if (box.IsEmpty())
  {
    return 0;
  }
  return Rational(box.Width()) * Rational(box.Height()) / Rational(Whole(1) << BlurBits);
}

Rational EnclosedArea(const std::vector<std::pair<Point2, Point2>>& edges)
{
  int unit = GreatestUnit;
  for (const auto& edge : edges)
  {
    unit = std::min({ unit, UnitOf(edge.first), UnitOf(edge.second) });
  }
  Whole doubled = 0;
  for (const auto& edge : edges)
  {
    doubled += Cross(ToWhole(edge.first, unit), ToWhole(edge.second, unit));
  }
  unit = 2 * unit - 1;
  return unit < 0 ? Rational(doubled, Whole(1) << -unit) : Rational(doubled << unit);
}

} // namespace biting
