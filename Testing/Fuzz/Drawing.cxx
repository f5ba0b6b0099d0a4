// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Drawing.h"

#include <algorithm> // for sort
#include <cmath>     // for abs
#include <limits>    // for epsilon
#include <map>       // for ends

namespace biting
{

namespace
{

/// Most rounds of resolution need no more than two, and each moves by 4 ulp.
constexpr double SlackInUlp = 32.0;
constexpr double CountsAsZero = 1e-70;

using Wide = long double;

/// A segment from left to right, relative to a point of the drawing; not upright.
struct SlopedSegment
{
  Wide X0;
  Wide Y0;
  Wide X1;
  Wide Y1;

  Wide Slope() const { return (this->Y1 - this->Y0) / (this->X1 - this->X0); }
  Wide At(Wide x) const { return this->Y0 + (x - this->X0) * this->Slope(); }
};

Point2 Flushed(const Point2& p)
{
  const auto flush = [](double x) { return std::abs(x) < CountsAsZero ? 0.0 : x; };
  return { flush(p.X), flush(p.Y) };
}

class DrawingReader
{
public:
  explicit DrawingReader(const Polylines& input)
    : Input(input)
  {
  }

  Drawing Read();

private:
  void ReadChain(std::size_t chain);
  void ReadSegments(std::size_t chain);
  Point2 At(Id place) const;
  bool HasEvenEnds() const;

  const Polylines& Input;
  Drawing Result;
  bool HasOpenAutomaticChain = false;
};

Drawing DrawingReader::Read()
{
  this->Result.HasFaces = std::find(this->Input.Kinds.begin(), this->Input.Kinds.end(),
                            ChainKind::Face) != this->Input.Kinds.end();
  for (std::size_t chain = 0; chain < this->Input.Kinds.size(); ++chain)
  {
    this->ReadChain(chain);
  }
  this->Result.IsExplicit = !this->HasOpenAutomaticChain && this->HasEvenEnds();
  return this->Result;
}

void DrawingReader::ReadChain(std::size_t chain)
{
  for (Id k = this->Input.Offsets[chain]; k < this->Input.Offsets[chain + 1]; ++k)
  {
    const Point2 p = this->At(k);
    this->Result.Largest = std::max({ this->Result.Largest, std::abs(p.X), std::abs(p.Y) });
    if (this->Input.Kinds[chain] == ChainKind::EmbeddedPoint)
    {
      this->Result.Points.push_back(p);
    }
  }
  if (this->Input.Kinds[chain] != ChainKind::EmbeddedPoint)
  {
    this->ReadSegments(chain);
  }
}

void DrawingReader::ReadSegments(std::size_t chain)
{
  const Id first = this->Input.Offsets[chain];
  const Id end = this->Input.Offsets[chain + 1];
  const bool isClosed = first < end && this->At(first) == this->At(end - 1);
  const ChainKind kind = this->Input.Kinds[chain];
  const bool isAutomatic = kind == ChainKind::Automatic && !this->Result.HasFaces;
  this->HasOpenAutomaticChain |= isAutomatic && !isClosed;
  for (Id k = first + 1; k < end; ++k)
  {
    if (this->At(k - 1) != this->At(k))
    {
      this->Result.Segments.push_back({ this->At(k - 1), this->At(k), this->Input.Cells[chain],
        kind == ChainKind::Boundary || kind == ChainKind::Face || (isAutomatic && isClosed),
        kind == ChainKind::Face ? static_cast<Id>(chain) : NoId,
        this->Input.Regions.empty() ? 0 : this->Input.Regions[chain] });
    }
  }
}

Point2 DrawingReader::At(Id place) const
{
  const Id point = this->Input.Connectivity[static_cast<std::size_t>(place)];
  return Flushed(this->Input.Points[static_cast<std::size_t>(point)]);
}

/// Whether an even number of bounding segments ends at each place.
bool DrawingReader::HasEvenEnds() const
{
  std::map<Point2, bool> isOdd;
  for (const DrawnSegment& segment : this->Result.Segments)
  {
    isOdd[segment.Start] ^= segment.Bounds;
    isOdd[segment.End] ^= segment.Bounds;
  }
  return std::none_of(isOdd.begin(), isOdd.end(), [](const auto& end) { return end.second; });
}

std::vector<SlopedSegment> SlopedSegments(const Drawing& drawing)
{
  std::vector<SlopedSegment> sloped;
  for (const DrawnSegment& segment : drawing.Segments)
  {
    if (segment.Bounds && segment.Start.X != segment.End.X)
    {
      const Point2 origin = drawing.Segments.front().Start;
      const bool isForward = segment.Start.X < segment.End.X;
      const Point2& left = isForward ? segment.Start : segment.End;
      const Point2& right = isForward ? segment.End : segment.Start;
      sloped.push_back({ Wide(left.X) - origin.X, Wide(left.Y) - origin.Y, Wide(right.X) - origin.X,
        Wide(right.Y) - origin.Y });
    }
  }
  return sloped;
}

/// All ends, and where two segments cross.
std::vector<Wide> SlabBorders(const std::vector<SlopedSegment>& segments)
{
  std::vector<Wide> borders;
  for (const SlopedSegment& a : segments)
  {
    borders.push_back(a.X0);
    borders.push_back(a.X1);
    for (const SlopedSegment* b = &a + 1; b != segments.data() + segments.size(); ++b)
    {
      const Wide low = std::max(a.X0, b->X0);
      const Wide high = std::min(a.X1, b->X1);
      const Wide gapLow = a.At(low) - b->At(low);
      const Wide gapHigh = a.At(high) - b->At(high);
      if (low < high && ((gapLow < 0 && gapHigh > 0) || (gapLow > 0 && gapHigh < 0)))
      {
        borders.push_back(low + (high - low) * (gapLow / (gapLow - gapHigh)));
      }
    }
  }
  std::sort(borders.begin(), borders.end());
  borders.erase(std::unique(borders.begin(), borders.end()), borders.end());
  return borders;
}

/// How high the even-odd region is at x, among segments that pass the whole slab.
Wide HeightWithin(
  const std::vector<SlopedSegment>& segments, Wide left, Wide right, std::vector<Wide>& heights)
{
  heights.clear();
  for (const SlopedSegment& segment : segments)
  {
    if (segment.X0 <= left && segment.X1 >= right)
    {
      heights.push_back(segment.At(left + (right - left) / 2));
    }
  }
  std::sort(heights.begin(), heights.end());
  Wide height = 0;
  Wide sign = -1;
  for (const Wide y : heights)
  {
    height += sign * y;
    sign = -sign;
  }
  return height;
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

double Drawing::Slack() const
{
  return SlackInUlp * std::numeric_limits<double>::epsilon() * this->Largest;
}

Drawing ReadDrawing(const Polylines& input)
{
  return DrawingReader(input).Read();
}

EvenOddArea MeasureEvenOddArea(const Drawing& drawing)
{
  const std::vector<SlopedSegment> segments = SlopedSegments(drawing);
  const std::vector<Wide> borders = SlabBorders(segments);
  std::vector<Wide> heights;
  Wide area = 0;
  for (std::size_t k = 1; k < borders.size(); ++k)
  {
    area +=
      HeightWithin(segments, borders[k - 1], borders[k], heights) * (borders[k] - borders[k - 1]);
  }
  const double length = BoundaryLength(drawing);
  const double rounding = static_cast<double>(segments.size()) *
    static_cast<double>(std::numeric_limits<Wide>::epsilon()) * length * length;
  return { static_cast<double>(area), drawing.Slack() * (length + drawing.Slack()) + rounding };
}

EvenOddArea SumOfFaces(const Drawing& drawing)
{
  EvenOddArea sum;
  for (std::size_t first = 0; first < drawing.Segments.size();)
  {
    Drawing face;
    face.Largest = drawing.Largest;
    std::size_t end = first;
    for (; end < drawing.Segments.size() &&
         drawing.Segments[end].Face == drawing.Segments[first].Face;
         ++end)
    {
      face.Segments.push_back(drawing.Segments[end]);
    }
    if (drawing.Segments[first].Face != NoId)
    {
      const EvenOddArea area = MeasureEvenOddArea(face);
      sum.Area += area.Area;
      sum.Tolerance += area.Tolerance;
    }
    first = end;
  }
  return sum;
}

} // namespace biting
