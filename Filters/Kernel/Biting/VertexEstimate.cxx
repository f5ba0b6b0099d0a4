// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "VertexEstimate.h"

#include "../Base/Pulse.h"

#include <algorithm> // for min, max
#include <array>     // for samples
#include <vector>    // for the cells to do

namespace biting
{

namespace
{

constexpr int FirstDivision = 24;     // cells along the longer side
constexpr int GreatestDepth = 14;     // halvings of these
constexpr int BorderDepth = 2;        // halvings of a cell that is partly outside
constexpr double GreatestRatio = 1.5; // of f within a cell
constexpr double LeastShare = 0.01;   // of a vertex, that a cell may hold, to be worth a division
constexpr int GreatestCells = 100000;
constexpr double MostPanels = 64.0; // along a segment

struct Cell
{
  Box2 Box;
  int Depth;
};

struct Sample
{
  double Inside = 0.0;  ///< share of the cell
  double Density = 0.0; ///< mean over the cell, 0 outside
  bool IsFine = true;   ///< needs no division
};

std::array<Box2, 4> Quarters(const Box2& box)
{
  const Point2 middle = box.Center();
  std::array<Box2, 4> quarters;
  for (int k = 0; k < 4; ++k)
  {
    quarters[k].Low = { k % 2 ? middle.X : box.Low.X, k / 2 ? middle.Y : box.Low.Y };
    quarters[k].High = { k % 2 ? box.High.X : middle.X, k / 2 ? box.High.Y : middle.Y };
  }
  return quarters;
}

Sample TakeSample(const Cell& cell, const DomainLocator& locator, const Spacing& spacing)
{
  Sample sample;
  double least = spacing(cell.Box.Center());
  double greatest = least;
  for (const Box2& quarter : Quarters(cell.Box))
  {
    const Point2 p = quarter.Center();
    const double f = spacing(p);
    least = std::min(least, f);
    greatest = std::max(greatest, f);
    if (locator.IsInside(p))
    {
      sample.Inside += 0.25;
      sample.Density += 0.25 / (f * f);
    }
  }
  const bool isWorthwhile = cell.Box.Width() * cell.Box.Height() > LeastShare * least * least;
  const bool isSteep = greatest > GreatestRatio * least && cell.Depth < GreatestDepth;
  const bool isBorder = cell.Depth < BorderDepth && isWorthwhile && !locator.IsClear(cell.Box);
  sample.IsFine = !isWorthwhile || !(isBorder || isSteep);
  return sample;
}

std::vector<Cell> FirstCells(const Box2& bounds)
{
  const double size = std::max(bounds.Width(), bounds.Height()) / FirstDivision;
  const int columns = static_cast<int>(bounds.Width() / size) + 1;
  const int rows = static_cast<int>(bounds.Height() / size) + 1;
  std::vector<Cell> cells;
  for (int k = 0; k < columns * rows; ++k)
  {
    Cell cell{ {}, 0 };
    cell.Box.Low = { bounds.Low.X + k % columns * size, bounds.Low.Y + k / columns * size };
    cell.Box.High = { cell.Box.Low.X + size, cell.Box.Low.Y + size };
    cells.push_back(cell);
  }
  return cells;
}

// Where no sample is inside.
double MeanDensityOfSegments(const Domain& domain, const Spacing& spacing, Pulse& pulse)
{
  double sum = 0.0;
  for (Id segment = 0; segment < domain.NumberOfSegments() && pulse.Beat(); ++segment)
  {
    const double f = spacing(
      Midpoint(domain.Vertices[domain.Starts[segment]], domain.Vertices[domain.Ends[segment]]));
    sum += 1.0 / (f * f);
  }
  return sum / std::max(1, domain.NumberOfSegments());
}

} // namespace

// Coarse cells first, so that where the number of cells ends the division, it ends evenly. The area
// is known: what the samples make of it corrects the integral, so that a sliver is not lost.
double IntegrateDensity(
  const Domain& domain, const DomainLocator& locator, const Spacing& spacing, Monitor& monitor)
{
  Pulse pulse(monitor);
  std::vector<Cell> cells = FirstCells(domain.Bounds);
  double integral = 0.0;
  double area = 0.0;
  for (std::size_t k = 0; k < cells.size() && pulse.Beat(); ++k)
  {
    pulse.SetFraction(static_cast<double>(k) / GreatestCells / 4.0);
    const Cell cell = cells[k];
    const Sample sample = TakeSample(cell, locator, spacing);
    if (sample.IsFine || cells.size() > GreatestCells)
    {
      const double size = cell.Box.Width() * cell.Box.Height();
      integral += sample.Density * size;
      area += sample.Inside * size;
      continue;
    }
    for (const Box2& quarter : Quarters(cell.Box))
    {
      cells.push_back({ quarter, cell.Depth + 1 });
    }
  }
  const double mean = area > 0.0 ? integral / area : MeanDensityOfSegments(domain, spacing, pulse);
  return mean * domain.Area;
}

double EstimateDivisionPoints(
  const Domain& domain, const Spacing& spacing, double partLength, Monitor& monitor)
{
  Pulse pulse(monitor);
  double points = 0.0;
  for (Id segment = 0; segment < domain.NumberOfSegments() && pulse.Beat(); ++segment)
  {
    pulse.SetFraction(static_cast<double>(segment) / domain.NumberOfSegments());
    const Point2& a = domain.Vertices[domain.Starts[segment]];
    const Point2& b = domain.Vertices[domain.Ends[segment]];
    const double length = Distance(a, b);
    const double least = std::min(spacing(a), spacing(b));
    const int panels = static_cast<int>(std::max(1.0, std::min(MostPanels, length / least)));
    double density = 0.0;
    for (int k = 0; k < panels && pulse.Beat(); ++k)
    {
      density += 1.0 / spacing(a + (k + 0.5) / panels * (b - a));
    }
    points += std::max(0.0, density / panels * length / partLength - 1.0);
  }
  return points;
}

} // namespace biting
