// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SourceCover.h"

#include "../Run/ProblemReport.h"

#include <algorithm> // for clamp, max, min
#include <array>     // for corners
#include <cmath>     // for abs, ceil, sqrt
#include <limits>    // for infinity

namespace biting
{

namespace
{

constexpr double MostSquaresAlongASide = 1024.0;

// The longest step between nodes at an end of the axis. Along an axis with one node a grid has no
// end.
double StepAtEnds(const std::vector<double>& nodes)
{
  const std::size_t size = nodes.size();
  return size < 2 ? std::numeric_limits<double>::infinity()
                  : std::max(nodes[1] - nodes[0], nodes[size - 1] - nodes[size - 2]);
}

// As wide as the points of a triangulation lie apart in the mean: twice as many triangles as
// points.
double MeanStep(const TriangulatedSource& source)
{
  double area = 0.0;
  for (std::size_t k = 0; k < source.Triangles.size(); k += 3)
  {
    const Point2& a = source.Points[source.Triangles[k]];
    const Point2& b = source.Points[source.Triangles[k + 1]];
    const Point2& c = source.Points[source.Triangles[k + 2]];
    area += 0.5 * std::abs(Cross(b - a, c - a));
  }
  return std::sqrt(
    6.0 * area / static_cast<double>(std::max<std::size_t>(source.Triangles.size(), 1)));
}

Box2 Widened(const Box2& box, double x, double y)
{
  Box2 wide;
  wide.Add({ box.Low.X - x, box.Low.Y - y });
  wide.Add({ box.High.X + x, box.High.Y + y });
  return wide;
}

void AddTriangle(const Point2& a, const Point2& b, const Point2& c, std::int64_t number,
  const SourceCover& cover, UncoveredPart& part)
{
  const double area = std::abs(Cross(b - a, c - a));
  const Point2 middle = a + (1.0 / 3.0) * ((b - a) + (c - a));
  part.WholeArea += area;
  if (!cover.Covers(middle))
  {
    part.Place = number < part.FirstTriangle ? middle : part.Place;
    part.FirstTriangle = std::min(number, part.FirstTriangle);
    part.Area += area;
  }
}

// The warning that says so; the place in space.
std::string UncoveredText(double share, const Point3& place)
{
  return "The spacing source does not cover " + Figure(100.0 * share, share < 0.995 ? 2 : 3) +
    " % of the domain, as near " + PlaceText(place) +
    ": there the nearest value of its border is used. Both must be in the same coordinates.";
}

} // namespace

SourceCover::SourceCover(const SpacingOptions& options)
{
  for (const GivenSource& source : options.Sources)
  {
    std::visit([this](const auto& given) { this->Cover(*given); }, source);
  }
}

void SourceCover::Cover(const GridSource& grid)
{
  this->HasSource = true;
  const Box2 box = Box2::Around(Point2{ grid.XNodes.front(), grid.YNodes.front() },
    Point2{ grid.XNodes.back(), grid.YNodes.back() });
  this->Bounds = Widened(box, StepAtEnds(grid.XNodes), StepAtEnds(grid.YNodes));
}

void SourceCover::Cover(const TriangulatedSource& source)
{
  this->HasSource = !source.Points.empty();
  const double step = MeanStep(source);
  this->Bounds = Widened(Box2::Around(source.Points), step, step);
  const double side = std::max(this->Bounds.Width(), this->Bounds.Height());
  this->SquareSize = std::max(step, side / MostSquaresAlongASide);
  if (!this->HasSource || !(this->SquareSize > 0.0))
  {
    return;
  }
  this->Columns = static_cast<std::size_t>(std::ceil(this->Bounds.Width() / this->SquareSize)) + 1;
  this->Rows = static_cast<std::size_t>(std::ceil(this->Bounds.Height() / this->SquareSize)) + 1;
  this->IsMarked.assign(this->Columns * this->Rows, 0);
  for (std::size_t k = 0; k < source.Triangles.size(); k += 3)
  {
    const std::array<Id, 3> corners{ source.Triangles[k], source.Triangles[k + 1],
      source.Triangles[k + 2] };
    this->Mark(Widened(Box2::Around(source.Points, corners), step, step));
  }
}

void SourceCover::Mark(const Box2& box)
{
  for (std::size_t row = this->Row(box.Low.Y); row <= this->Row(box.High.Y); ++row)
  {
    for (std::size_t column = this->Column(box.Low.X); column <= this->Column(box.High.X); ++column)
    {
      this->IsMarked[row * this->Columns + column] = 1;
    }
  }
}

std::size_t SourceCover::Column(double x) const
{
  const double column = (x - this->Bounds.Low.X) / this->SquareSize;
  return static_cast<std::size_t>(std::clamp(column, 0.0, static_cast<double>(this->Columns - 1)));
}

std::size_t SourceCover::Row(double y) const
{
  const double row = (y - this->Bounds.Low.Y) / this->SquareSize;
  return static_cast<std::size_t>(std::clamp(row, 0.0, static_cast<double>(this->Rows - 1)));
}

bool SourceCover::Covers(const Point2& place) const
{
  if (!this->HasSource)
  {
    return true;
  }
  const bool isInBounds = place.X >= this->Bounds.Low.X && place.X <= this->Bounds.High.X &&
    place.Y >= this->Bounds.Low.Y && place.Y <= this->Bounds.High.Y;
  return isInBounds &&
    (this->IsMarked.empty() ||
      this->IsMarked[this->Row(place.Y) * this->Columns + this->Column(place.X)] != 0);
}

void UncoveredPart::Join(const UncoveredPart& other)
{
  this->WholeArea += other.WholeArea;
  this->Area += other.Area;
  if (other.FirstTriangle < this->FirstTriangle)
  {
    this->FirstTriangle = other.FirstTriangle;
    this->Place = other.Place;
  }
}

UncoveredPart FindUncovered(const BitingMesh& mesh, const SpacingOptions& options)
{
  const SourceCover cover(options);
  UncoveredPart part;
  for (std::size_t triangle = 0; triangle < mesh.Regions.size(); ++triangle)
  {
    if (!mesh.Piece.IsPart || mesh.Piece.Levels[triangle] == 0)
    {
      const Id* corners = mesh.Corners.data() + 3 * triangle;
      const auto number =
        mesh.Piece.IsPart ? mesh.Piece.TriangleIds[triangle] : static_cast<std::int64_t>(triangle);
      AddTriangle(mesh.Points[corners[0]], mesh.Points[corners[1]], mesh.Points[corners[2]], number,
        cover, part);
    }
  }
  return part;
}

std::string UncoveredWarning(const UncoveredPart& part, const PlaneFrame& frame)
{
  return part.WholeArea > 0.0 && part.Area > 0.0
    ? UncoveredText(part.Area / part.WholeArea, frame.ToSpace(part.Place))
    : "";
}

std::string UncoveredWarning(const std::vector<Point2>& points, const std::vector<Id>& corners,
  const SpacingOptions& options, const PlaneFrame& frame)
{
  const SourceCover cover(options);
  UncoveredPart part;
  for (std::size_t k = 0; k < corners.size(); k += 3)
  {
    AddTriangle(points[corners[k]], points[corners[k + 1]], points[corners[k + 2]],
      static_cast<std::int64_t>(k / 3), cover, part);
  }
  return UncoveredWarning(part, frame);
}

} // namespace biting
