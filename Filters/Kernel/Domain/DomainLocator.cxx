// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "DomainLocator.h"

#include "../Predicates/Predicates.h"

#include <algorithm> // for clamp, max, min, sort, unique
#include <cmath>     // for abs, sqrt

namespace biting
{

namespace
{

constexpr Id CrowdedCell = 12; // segments above which a cell is divided
// Of a segment, while its top cell is divided: else a fan of n spokes would cost n^2.
constexpr std::size_t MostCopies = 24;
constexpr int GreatestDepth = 12;    // 4^12 divisions: finer than double coordinates ask for
constexpr double MostTopCells = 8.0; // that a segment meets, on average
constexpr double CellMargin = 1e-6;  // of a cell's size: cells overlap by more than rounding
constexpr Id LeastCells = 4096;

// Long segments side by side would be filed in too many cells.
double LeastCellSize(const Domain& domain)
{
  double length = 0.0;
  for (Id segment = 0; segment < domain.NumberOfSegments(); ++segment)
  {
    const Point2 direction =
      domain.Vertices[domain.Ends[segment]] - domain.Vertices[domain.Starts[segment]];
    length += std::abs(direction.X) + std::abs(direction.Y);
  }
  return length / (MostTopCells * std::max(LeastCells, domain.NumberOfSegments()));
}

/// Whether the segment passes through the box, or by it within the resolution and CellMargin.
bool PassesBox(const Domain& domain, Id segment, const Box2& box)
{
  const Point2& a = domain.Vertices[domain.Starts[segment]];
  const Point2& b = domain.Vertices[domain.Ends[segment]];
  Box2 grown = box;
  grown.Grow(CellMargin * box.Width() + domain.Resolution);
  const Point2 direction = b - a;
  const double reach =
    0.5 * (std::abs(direction.X) * grown.Height() + std::abs(direction.Y) * grown.Width());
  return grown.Meets(Box2::Around(a, b)) &&
    std::abs(Cross(direction, grown.Center() - a)) <= reach * (1.0 + CellMargin);
}

/// Whether the segment crosses pq, whose ends are not on it, exactly. An end on the line pq counts
/// as left of it, for both segments that share that end: so a point is inside where an odd number
/// of boundary segments separates it from one outside.
bool Separates(const Domain& domain, Id segment, const Point2& p, const Point2& q)
{
  const Point2& a = domain.Vertices[domain.Starts[segment]];
  const Point2& b = domain.Vertices[domain.Ends[segment]];
  return (Orient2D(a, b, p) > 0) != (Orient2D(a, b, q) > 0) &&
    (Orient2D(p, q, a) >= 0) != (Orient2D(p, q, b) >= 0);
}

} // namespace

DomainLocator::DomainLocator(const Domain& domain, Pulse& pulse)
  : Geometry(domain)
{
  this->MakeGrid(pulse);
  this->SetReferences(pulse);
  const Id numberOfTopCells = this->Columns * this->Rows;
  for (Id cell = 0; cell < numberOfTopCells && pulse.Beat(1); ++cell)
  {
    const Id count = this->Cells[cell].NumberOfSegments;
    if (count > CrowdedCell)
    {
      this->MostEntries = this->Segments.size() + MostCopies * static_cast<std::size_t>(count);
      this->Divide(cell, this->TopBox(cell % this->Columns, cell / this->Columns), 0, pulse);
    }
  }
}

bool DomainLocator::IsInside(const Point2& p) const
{
  if (!this->Geometry.Bounds.Contains(p))
  {
    return false;
  }
  double u = (p.X - this->Origin.X) / this->CellSize;
  double v = (p.Y - this->Origin.Y) / this->CellSize;
  const Id column = ClampedIndex(u, this->Columns);
  const Id row = ClampedIndex(v, this->Rows);
  const Cell* cell = &this->Cells[row * this->Columns + column];
  u -= column;
  v -= row;
  while (cell->FirstChild != NoId)
  {
    u *= Division;
    v *= Division;
    const Id childColumn = ClampedIndex(u, Division);
    const Id childRow = ClampedIndex(v, Division);
    cell = &this->Cells[cell->FirstChild + childRow * Division + childColumn];
    u -= childColumn;
    v -= childRow;
  }
  bool isInside = cell->ReferenceIsInside;
  for (Id k = 0; k < cell->NumberOfSegments; ++k)
  {
    const Id segment = this->Segments[cell->FirstSegment + k];
    if (IsOnSegment(p, this->Geometry.Vertices[this->Geometry.Starts[segment]],
          this->Geometry.Vertices[this->Geometry.Ends[segment]]))
    {
      return false;
    }
    isInside ^= Separates(this->Geometry, segment, cell->Reference, p);
  }
  return isInside;
}

void DomainLocator::MakeGrid(Pulse& pulse)
{
  const Box2& bounds = this->Geometry.Bounds;
  const double width = std::max(bounds.Width(), 1e-3 * bounds.Height());
  const double height = std::max(bounds.Height(), 1e-3 * bounds.Width());
  const double wanted = std::max(LeastCells, 2 * this->Geometry.NumberOfSegments());
  this->CellSize = std::max(std::sqrt(width * height / wanted), LeastCellSize(this->Geometry));
  this->Origin = bounds.Low;
  this->Columns = static_cast<Id>(width / this->CellSize) + 1;
  this->Rows = static_cast<Id>(height / this->CellSize) + 1;
  this->Cells.resize(static_cast<std::size_t>(this->Columns) * this->Rows);
  this->FileSegments(pulse);
}

// Counts first, so that the segments of a cell lie together without a list of its own.
void DomainLocator::FileSegments(Pulse& pulse)
{
  const auto fileAll = [this, &pulse](const auto& file)
  {
    for (Id segment = 0; segment < this->Geometry.NumberOfSegments() && pulse.Beat(); ++segment)
    {
      if (this->Geometry.IsBoundary[segment])
      {
        this->VisitTopCells(segment, [segment, &file](Cell& cell) { file(cell, segment); });
      }
    }
  };
  fileAll([](Cell& cell, Id) { ++cell.NumberOfSegments; });
  Id count = 0;
  for (Cell& cell : this->Cells)
  {
    cell.FirstSegment = count;
    count += cell.NumberOfSegments;
    cell.NumberOfSegments = 0;
  }
  this->Segments.resize(count);
  fileAll([this](Cell& cell, Id segment)
    { this->Segments[cell.FirstSegment + cell.NumberOfSegments++] = segment; });
}

// Row by row, so that a long slanted segment costs the cells it meets, not those of its box.
template <typename Visit>
void DomainLocator::VisitTopCells(Id segment, const Visit& visit)
{
  Point2 a = this->Geometry.Vertices[this->Geometry.Starts[segment]];
  Point2 b = this->Geometry.Vertices[this->Geometry.Ends[segment]];
  if (b.Y < a.Y)
  {
    std::swap(a, b);
  }
  const auto column = [this](double x)
  { return ClampedIndex((x - this->Origin.X) / this->CellSize, this->Columns); };
  const double margin = CellMargin * this->CellSize;
  const Id firstRow = ClampedIndex((a.Y - margin - this->Origin.Y) / this->CellSize, this->Rows);
  const Id lastRow = ClampedIndex((b.Y + margin - this->Origin.Y) / this->CellSize, this->Rows);
  for (Id row = firstRow; row <= lastRow; ++row)
  {
    const double low = this->Origin.Y + row * this->CellSize - margin;
    const double high = low + this->CellSize + 2.0 * margin;
    const double height = b.Y - a.Y;
    const double from = height > 0.0 ? std::clamp((low - a.Y) / height, 0.0, 1.0) : 0.0;
    const double to = height > 0.0 ? std::clamp((high - a.Y) / height, 0.0, 1.0) : 1.0;
    const double x0 = a.X + from * (b.X - a.X);
    const double x1 = a.X + to * (b.X - a.X);
    const Id lastColumn = column(std::max(x0, x1) + margin);
    for (Id c = column(std::min(x0, x1) - margin); c <= lastColumn; ++c)
    {
      visit(this->Cells[static_cast<std::size_t>(row) * this->Columns + c]);
    }
  }
}

// Left of the grid is outside; each row is walked from reference point to reference point.
void DomainLocator::SetReferences(Pulse& pulse)
{
  std::vector<Id> between;
  for (Id row = 0; row < this->Rows && pulse.Beat(static_cast<std::size_t>(this->Columns)); ++row)
  {
    Cell outside;
    const Box2 firstBox = this->TopBox(0, row);
    outside.Reference = { firstBox.Low.X - this->CellSize, firstBox.Center().Y };
    const Cell* previous = &outside;
    for (Id column = 0; column < this->Columns; ++column)
    {
      Cell& cell = this->Cells[row * this->Columns + column];
      cell.Reference = this->FreePoint(this->TopBox(column, row), cell);
      cell.ReferenceIsInside = previous->ReferenceIsInside;
      if (previous->NumberOfSegments > 0 || cell.NumberOfSegments > 0)
      {
        this->CollectSegments(*previous, cell, between);
        for (const Id segment : between)
        {
          cell.ReferenceIsInside ^=
            Separates(this->Geometry, segment, previous->Reference, cell.Reference);
        }
      }
      previous = &cell;
    }
  }
}

// Each once.
void DomainLocator::CollectSegments(const Cell& a, const Cell& b, std::vector<Id>& segments) const
{
  segments.clear();
  for (const Cell* cell : { &a, &b })
  {
    const auto first = this->Segments.begin() + cell->FirstSegment;
    segments.insert(segments.end(), first, first + cell->NumberOfSegments);
  }
  std::sort(segments.begin(), segments.end());
  segments.erase(std::unique(segments.begin(), segments.end()), segments.end());
}

void DomainLocator::Divide(Id cell, const Box2& box, int depth, Pulse& pulse)
{
  const Id firstChild = static_cast<Id>(this->Cells.size());
  this->Cells.resize(this->Cells.size() + Division * Division);
  this->Cells[cell].FirstChild = firstChild;
  const Cell parent = this->Cells[cell];
  const Point2 size{ box.Width() / Division, box.Height() / Division };
  const double least = Division * Division * this->Geometry.Resolution;
  for (Id k = 0; k < Division * Division; ++k)
  {
    const Point2 low = box.Low + Point2{ k % Division * size.X, k / Division * size.Y };
    const Box2 childBox{ low, low + size };
    if (!pulse.Beat(static_cast<std::size_t>(parent.NumberOfSegments)))
    {
      return;
    }
    this->MakeChild(firstChild + k, childBox, parent);
    const Id count = this->Cells[firstChild + k].NumberOfSegments;
    // A crowd that meets in one vertex cannot be divided: give up on it soon.
    const int childDepth = depth + (count < parent.NumberOfSegments ? 1 : 4);
    const bool isWorthwhile = count > CrowdedCell && childDepth < GreatestDepth &&
      this->Segments.size() < this->MostEntries && std::min(size.X, size.Y) > least;
    if (isWorthwhile)
    {
      this->Divide(firstChild + k, childBox, childDepth, pulse);
    }
  }
}

void DomainLocator::MakeChild(Id child, const Box2& box, const Cell& parent)
{
  Cell cell;
  cell.FirstSegment = static_cast<Id>(this->Segments.size());
  for (Id k = 0; k < parent.NumberOfSegments; ++k)
  {
    const Id segment = this->Segments[parent.FirstSegment + k];
    if (PassesBox(this->Geometry, segment, box))
    {
      this->Segments.push_back(segment);
    }
  }
  cell.NumberOfSegments = static_cast<Id>(this->Segments.size()) - cell.FirstSegment;
  cell.Reference = this->FreePoint(box, cell);
  cell.ReferenceIsInside = parent.ReferenceIsInside;
  for (Id k = 0; k < parent.NumberOfSegments; ++k)
  {
    cell.ReferenceIsInside ^= Separates(
      this->Geometry, this->Segments[parent.FirstSegment + k], parent.Reference, cell.Reference);
  }
  this->Cells[child] = cell;
}

// A point of the box on no line through one of the cell's segments, so that Separates is decided.
Point2 DomainLocator::FreePoint(const Box2& box, const Cell& cell) const
{
  Point2 p = box.Center();
  for (int attempt = 1; attempt < 16; ++attempt)
  {
    bool isFree = true;
    for (Id k = 0; k < cell.NumberOfSegments && isFree; ++k)
    {
      const Id segment = this->Segments[cell.FirstSegment + k];
      isFree = Orient2D(this->Geometry.Vertices[this->Geometry.Starts[segment]],
                 this->Geometry.Vertices[this->Geometry.Ends[segment]], p) != 0;
    }
    if (isFree)
    {
      return p;
    }
    const double step = attempt / 32.0;
    p = { box.Low.X + (0.5 + 0.71 * step) * box.Width(),
      box.Low.Y + (0.5 - 0.93 * step) * box.Height() };
  }
  return p;
}

Box2 DomainLocator::TopBox(Id column, Id row) const
{
  Box2 box;
  box.Low = { this->Origin.X + column * this->CellSize, this->Origin.Y + row * this->CellSize };
  box.High = { box.Low.X + this->CellSize, box.Low.Y + this->CellSize };
  return box;
}

} // namespace biting
