// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "WideCells.h"

#include <cmath> // for circles

namespace biting
{
namespace
{

/// How far a chord may be from the arc it stands for, in f; at most so many chords a side of a cell.
constexpr double ChordError = 0.005;
constexpr double ChordsPerSide = 32.0;

constexpr double FullTurn = 6.283185307179586;

/// The bilinear interpolant of the corners of a cell, x from its low corner.
struct Patch
{
  Point2 Low;
  Point2 Size;
  std::array<double, 4> Corners;
  Point2 Origin;                   ///< of the places of bounds
  std::array<NodeBound, 4> Bounds; ///< of the corners

  double At(const Point2& x) const
  {
    const double u = x.X / this->Size.X;
    const double v = x.Y / this->Size.Y;
    return (1.0 - v) * ((1.0 - u) * this->Corners[0] + u * this->Corners[1]) +
      v * ((1.0 - u) * this->Corners[2] + u * this->Corners[3]);
  }
  Point2 Slope() const
  {
    return { (this->Corners[1] - this->Corners[0]) / this->Size.X,
      (this->Corners[2] - this->Corners[0]) / this->Size.Y };
  }
  double Twist() const
  {
    return (this->Corners[3] - this->Corners[2] - this->Corners[1] + this->Corners[0]) /
      (this->Size.X * this->Size.Y);
  }
  double Least() const { return *std::min_element(this->Corners.begin(), this->Corners.end()); }
  bool Contains(const Point2& x) const
  {
    return x.X >= 0.0 && x.Y >= 0.0 && x.X <= this->Size.X && x.Y <= this->Size.Y;
  }
};

/// Leaves the part of [start, end] for which low + t rise is in [0, size]; false if there is none.
bool Clip(double low, double rise, double size, double& start, double& end)
{
  if (rise == 0.0)
  {
    return low >= 0.0 && low <= size;
  }
  const double first = -low / rise;
  const double second = (size - low) / rise;
  start = std::max(start, std::min(first, second));
  end = std::min(end, std::max(first, second));
  return start < end;
}

Point2 PointOnCircle(const Point2& center, double radius, double angle)
{
  return { center.X + radius * std::cos(angle), center.Y + radius * std::sin(angle) };
}

/// The angles under which a point outside sees a cell: less than half a turn.
void AnglesAround(const Patch& patch, const Point2& center, double& start, double& turn)
{
  const Point2 toMiddle = 0.5 * patch.Size - center;
  const double middle = std::atan2(toMiddle.Y, toMiddle.X);
  double half = 0.0;
  for (const Point2& corner :
    { Point2{ 0.0, 0.0 }, Point2{ patch.Size.X, 0.0 }, Point2{ 0.0, patch.Size.Y }, patch.Size })
  {
    const Point2 toCorner = corner - center;
    half = std::max(half, std::abs(std::atan2(Cross(toMiddle, toCorner), Dot(toMiddle, toCorner))));
  }
  start = middle - half;
  turn = 2.0 * half;
}

/// Adds the part of a chord that is within the patch, unless what bounds a corner is below it:
/// as that is convex, at its ends is enough.
void AddChord(
  const Patch& patch, double gradation, const Point2& from, const Point2& to, ConeCollector& cones)
{
  double start = 0.0;
  double end = 1.0;
  const Point2 step = to - from;
  if (!Clip(from.X, step.X, patch.Size.X, start, end) ||
    !Clip(from.Y, step.Y, patch.Size.Y, start, end))
  {
    return;
  }
  const Point2 a = from + start * step;
  const Point2 b = from + end * step;
  const auto isBounded = [&patch, gradation, &a, &b](const NodeBound& bound)
  {
    return bound.Reaches(patch.Low + a - patch.Origin, patch.At(a), gradation) &&
      bound.Reaches(patch.Low + b - patch.Origin, patch.At(b), gradation);
  };
  if (std::none_of(patch.Bounds.begin(), patch.Bounds.end(), isBounded))
  {
    cones.AddSegment(patch.Low + a, patch.Low + b, patch.At(a), patch.At(b));
  }
}

/// The gradient is (Slope.X + Twist y, Slope.Y + Twist x): as long as the gradation on a circle.
void AddCircle(const Patch& patch, double gradation, ConeCollector& cones)
{
  const double side = std::max(patch.Size.X, patch.Size.Y);
  const double twist = std::abs(patch.Twist());
  if (!(twist * patch.Size.X * patch.Size.Y > ChordError * patch.Least()))
  {
    return;
  }
  const double radius = gradation / twist;
  const Point2 center{ -patch.Slope().Y / patch.Twist(), -patch.Slope().X / patch.Twist() };
  const double chord =
    std::max(std::sqrt(4.0 * ChordError * patch.Least() / twist), side / ChordsPerSide);
  double start = 0.0;
  double turn = FullTurn;
  if (!patch.Contains(center))
  {
    AnglesAround(patch, center, start, turn);
  }
  const double chords = std::ceil(radius * turn / chord);
  for (double step = 0.0; step < chords; step += 1.0)
  {
    AddChord(patch, gradation, PointOnCircle(center, radius, start + turn * step / chords),
      PointOnCircle(center, radius, start + turn * (step + 1.0) / chords), cones);
  }
}

} // namespace

WideCells::WideCells(
  const GridCells& cells, const std::vector<NodeBound>& bounds, ConeCollector& cones, Pulse& pulse)
  : Cells(cells)
  , Bounds(bounds)
  , Cones(cones)
  , Beats(pulse)
{
  this->Wide.reserve(bounds.size());
  for (Id row = 0; row < cells.Rows(); ++row)
  {
    for (Id column = 0; column < cells.Columns(); ++column)
    {
      this->Wide.push_back(this->IsWide(column, row));
      this->HasWide = this->HasWide || this->Wide.back();
    }
    pulse.Beat(4 * static_cast<std::size_t>(cells.Columns()));
  }
  this->MarkNodes();
}

void WideCells::MarkNodes()
{
  const std::size_t count = this->HasWide ? this->Wide.size() : 0;
  this->IsWideNode.assign(count, false);
  this->IsNear.assign(count, false);
  const auto mark = [this](Id column, Id row, Id before, std::vector<bool>& marks)
  {
    for (Id y = std::max(row - before, Id(0)); y <= this->Cells.Above(row); ++y)
    {
      for (Id x = std::max(column - before, Id(0)); x <= this->Cells.Right(column); ++x)
      {
        marks[static_cast<std::size_t>(this->Cells.Node(x, y))] = true;
      }
    }
  };
  for (Id node = 0; node < static_cast<Id>(count) && this->Beats.Beat(1); ++node)
  {
    const Id column = node % this->Cells.Columns();
    const Id row = node / this->Cells.Columns();
    if (this->Wide[static_cast<std::size_t>(node)])
    {
      mark(column, row, 0, this->IsWideNode);
    }
  }
  for (Id node = 0; node < static_cast<Id>(count) && this->Beats.Beat(1); ++node)
  {
    if (this->IsWideNode[static_cast<std::size_t>(node)])
    {
      mark(node % this->Cells.Columns(), node / this->Cells.Columns(), 1, this->IsNear);
    }
  }
}

bool WideCells::AddCones()
{
  for (Id row = 0; this->HasWide && row < this->Cells.Rows(); ++row)
  {
    for (Id column = 0; column < this->Cells.Columns(); ++column)
    {
      this->AddConesAt(column, row);
    }
    this->Beats.SetFraction(0.85 + 0.1 * row / this->Cells.Rows());
    if (!this->Beats.Beat(8 * static_cast<std::size_t>(this->Cells.Columns())))
    {
      return false;
    }
  }
  return !this->Beats.HasStopped();
}

bool WideCells::IsWide(Id column, Id row) const
{
  const Id right = this->Cells.Right(column);
  const Id above = this->Cells.Above(row);
  float least = this->BoundOf(this->Cells.Node(column, row)).Value;
  for (Id node : { this->Cells.Node(right, row), this->Cells.Node(column, above),
         this->Cells.Node(right, above) })
  {
    least = std::min(least, this->BoundOf(node).Value);
  }
  const double side = std::max(
    this->Cells.X(right) - this->Cells.X(column), this->Cells.Y(above) - this->Cells.Y(row));
  return this->Cells.Gradation() * side > WidestGrowth * least;
}

bool WideCells::IsWideCell(Id column, Id row) const
{
  return column >= 0 && row >= 0 &&
    this->Wide[static_cast<std::size_t>(this->Cells.Node(column, row))];
}

bool WideCells::IsWideAndSteep(Id column, Id row) const
{
  return this->IsWideCell(column, row) && this->Cells.IsSteep(column, row);
}

void WideCells::AddConesAt(Id column, Id row)
{
  if (this->IsNearWide(column, row))
  {
    this->AddPlaces(column, row);
  }
  const bool isSource = this->IsWideAndSteep(column, row);
  const bool hasRight = column + 1 < this->Cells.Columns();
  const bool hasAbove = row + 1 < this->Cells.Rows();
  if (hasRight && (isSource || this->IsWideAndSteep(column, row - 1)))
  {
    this->AddSide(column, row, column + 1, row);
  }
  if (hasAbove && (isSource || this->IsWideAndSteep(column - 1, row)))
  {
    this->AddSide(column, row, column, row + 1);
  }
  if (isSource && hasRight && hasAbove)
  {
    this->AddInside(column, row);
  }
}

void WideCells::AddSide(Id startColumn, Id startRow, Id endColumn, Id endRow)
{
  const Id a = this->Cells.Node(startColumn, startRow);
  const Id b = this->Cells.Node(endColumn, endRow);
  const Point2 start = this->Cells.Place(startColumn, startRow);
  const Point2 end = this->Cells.Place(endColumn, endRow);
  const auto isBounded = [&](const NodeBound& bound)
  {
    const Point2 origin = this->Cells.Place(0, 0);
    return bound.IsOfOther() &&
      bound.Reaches(start - origin, this->Cells.Given(a), this->Cells.Gradation()) &&
      bound.Reaches(end - origin, this->Cells.Given(b), this->Cells.Gradation());
  };
  if (!isBounded(this->BoundOf(a)) && !isBounded(this->BoundOf(b)))
  {
    this->Cones.AddSegment(start, end, this->Cells.Given(a), this->Cells.Given(b));
  }
}

/// The places that bound the low corner of a cell, from wherever they are; one that its neighbors
/// have too is theirs to add.
void WideCells::AddPlaces(Id column, Id row)
{
  const NodeBound& bound = this->BoundOf(this->Cells.Node(column, row));
  const auto isOf = [this, &bound](Id otherColumn, Id otherRow)
  {
    const NodeBound& other = this->BoundOf(this->Cells.Node(otherColumn, otherRow));
    return other.IsOfOther() && other.Place.X == bound.Place.X && other.Place.Y == bound.Place.Y;
  };
  const bool isKnown = (column > 0 && this->IsNearWide(column - 1, row) && isOf(column - 1, row)) ||
    (row > 0 && this->IsNearWide(column, row - 1) && isOf(column, row - 1));
  if (bound.IsOfOther() && !isKnown)
  {
    const Point2 offset{ bound.Place.X, bound.Place.Y };
    this->Cones.AddPoint(this->Cells.Place(0, 0) + offset, bound.Base);
  }
}

void WideCells::AddInside(Id column, Id row)
{
  Patch patch;
  patch.Low = this->Cells.Place(column, row);
  patch.Size = this->Cells.Place(column + 1, row + 1) - patch.Low;
  patch.Corners = this->Cells.Corners(column, row);
  patch.Origin = this->Cells.Place(0, 0);
  for (Id corner = 0; corner < 4; ++corner)
  {
    patch.Bounds[static_cast<std::size_t>(corner)] =
      this->BoundOf(this->Cells.Node(column + corner % 2, row + corner / 2));
  }
  AddCircle(patch, this->Cells.Gradation(), this->Cones);
}

} // namespace biting
