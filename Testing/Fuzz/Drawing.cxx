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
  this->Result.SeamNoise = this->Input.SeamNoise;
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
      this->Result.Segments.push_back(
        { this->At(k - 1), this->At(k), static_cast<Id>(chain), this->Input.Cells[chain],
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

} // namespace

double Drawing::Slack() const
{
  return SlackInUlp * std::numeric_limits<double>::epsilon() * this->Largest + this->SeamNoise;
}

Drawing Drawing::Of(const std::vector<DrawnSegment>& segments) const
{
  Drawing part;
  part.Segments = segments;
  part.Largest = this->Largest;
  part.SeamNoise = this->SeamNoise;
  return part;
}

Drawing ReadDrawing(const Polylines& input)
{
  return DrawingReader(input).Read();
}

std::vector<std::vector<DrawnSegment>> FacesOf(const Drawing& drawing)
{
  std::vector<std::vector<DrawnSegment>> faces;
  for (const DrawnSegment& segment : drawing.Segments)
  {
    if (segment.Face != NoId)
    {
      if (faces.empty() || faces.back().front().Face != segment.Face)
      {
        faces.emplace_back();
      }
      faces.back().push_back(segment);
    }
  }
  return faces;
}

} // namespace biting
