// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "VertexEstimate.h"

#include "../Base/Pulse.h"

#include <algorithm> // for min, max
#include <array>     // for quarters
#include <cmath>     // for ceil, log
#include <limits>    // for infinity
#include <numeric>   // for accumulate
#include <vector>    // for the cells to do

namespace biting
{

namespace
{

constexpr int FirstDivision = 6;      // cells along the longer side
constexpr int CoarseDepth = 2;        // halvings of a first cell that is coarse
constexpr double CoarseWidth = 1.5;   // of such a cell, in units of f
constexpr int BorderDepth = 4;        // halvings of one that is partly outside
constexpr int GreatestDepth = 16;     // halvings at all
constexpr double GreatestRatio = 1.5; // of f within a cell
constexpr double LeastShare = 0.01;   // of a vertex, that a cell may hold, to be worth a division
constexpr double LeastDoubt =
  0.004; // of the integral, that a cell may be wrong by, to be worth one
constexpr double DoubtOnBorder = 0.3; // of what a cell may hold: the area is known
constexpr double LeastCells = 2048.0;
constexpr double GreatestCells = 100000.0;
constexpr double CellsPerVertex = 16.0;      // between these limits: a small mesh asks for no more
constexpr double SegmentPanel = 3.0;         // of a segment, in spacings
constexpr double NearlyLevel = 1e-3;         // growth of f in a panel, as a share of it
constexpr double MostPanels = 64.0;          // along a segment
constexpr double MostPanelsInAll = 300000.0; // but at least one a segment

struct Sample
{
  double Inside = 0.0;  ///< area
  double Density = 0.0; ///< integral over the cell
  double Doubt = 0.0;   ///< by how much that may be wrong; 0 where it needs no division
};

struct Cell
{
  Box2 Box;
  int Depth;
  Sample Values;
  double AtCenter = 0.0;                 ///< f there; 0 where it was not asked
  std::array<double, 4> AtQuarters = {}; ///< f at their centres
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

// By how much the sample of a cell may be wrong, whose spacings are from `least` to `greatest`.
double DoubtOf(const Cell& cell, const DomainLocator& locator, double least, double greatest)
{
  const double area = cell.Box.Width() * cell.Box.Height();
  const double most = area / (least * least);
  if (!(most > LeastShare))
  {
    return 0.0;
  }
  const bool isCoarse = cell.Depth < CoarseDepth && cell.Box.Width() > CoarseWidth * least;
  const bool isSteep = cell.Depth < GreatestDepth && greatest > GreatestRatio * least;
  const bool mayBeDivided = isCoarse || isSteep || cell.Depth < BorderDepth;
  const bool isClear = mayBeDivided && locator.IsClear(cell.Box);
  if (!mayBeDivided || (isClear && cell.Values.Inside == 0.0))
  {
    return 0.0;
  }
  const double steepness = isSteep ? most - area / (greatest * greatest) : 0.0;
  return isCoarse ? std::numeric_limits<double>::infinity()
                  : std::max(steepness, isClear ? 0.0 : DoubtOnBorder * most);
}

// f is not asked where the whole cell is outside.
void TakeSample(const DomainLocator& locator, const Spacing& spacing, Cell& cell)
{
  const double area = 0.25 * cell.Box.Width() * cell.Box.Height();
  const std::array<Box2, 4> quarters = Quarters(cell.Box);
  std::array<bool, 4> areInside = {};
  for (std::size_t k = 0; k < quarters.size(); ++k)
  {
    areInside[k] = locator.IsInside(quarters[k].Center());
    cell.Values.Inside += areInside[k] ? area : 0.0;
  }
  if (cell.Values.Inside == 0.0 && locator.IsClear(cell.Box))
  {
    return;
  }
  double least = cell.AtCenter > 0.0 ? cell.AtCenter : spacing(cell.Box.Center());
  double greatest = least;
  for (std::size_t k = 0; k < quarters.size(); ++k)
  {
    const double f = spacing(quarters[k].Center());
    cell.AtQuarters[k] = f;
    least = std::min(least, f);
    greatest = std::max(greatest, f);
    cell.Values.Density += areInside[k] ? area / (f * f) : 0.0;
  }
  cell.Values.Doubt = DoubtOf(cell, locator, least, greatest);
}

std::vector<Cell> FirstCells(const Box2& bounds)
{
  const double size = std::max(bounds.Width(), bounds.Height()) / FirstDivision;
  const int columns = static_cast<int>(bounds.Width() / size) + 1;
  const int rows = static_cast<int>(bounds.Height() / size) + 1;
  std::vector<Cell> cells;
  for (int k = 0; k < columns * rows; ++k)
  {
    Cell cell{ {}, 0, {}, 0.0, {} };
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

// Adaptive quadrature of 1/f^2, one level after the other, so that where the number of cells ends
// the division, it ends evenly.
class Quadrature
{
public:
  Quadrature(const DomainLocator& locator, const Spacing& spacing, Monitor& monitor)
    : Locator(locator)
    , F(spacing)
    , Beats(monitor)
  {
  }

  void Run(std::vector<Cell> cells)
  {
    while (!cells.empty() && !this->Beats.HasStopped())
    {
      double waiting = 0.0;
      for (std::size_t k = 0; k < cells.size() && this->Beats.Beat(); ++k)
      {
        this->Beats.SetFraction(this->NumberOfCells++ / GreatestCells);
        TakeSample(this->Locator, this->F, cells[k]);
        waiting += cells[k].Values.Density;
      }
      cells = this->Divide(cells, this->Density + waiting);
    }
  }

  // The area is known: what the samples make of it corrects the integral, so that a sliver is not
  // lost. Negative where no sample is inside.
  double Mean() const { return this->Area > 0.0 ? this->Density / this->Area : -1.0; }

  Pulse& Progress() { return this->Beats; }

private:
  // The quarters of those that are worth it; the others are done.
  std::vector<Cell> Divide(const std::vector<Cell>& cells, double whole)
  {
    const double most = std::min(std::max(LeastCells, CellsPerVertex * whole), GreatestCells);
    std::vector<Cell> next;
    for (const Cell& cell : cells)
    {
      const bool hasRoom = this->NumberOfCells + static_cast<double>(next.size()) < most;
      if (hasRoom && cell.Values.Doubt > LeastDoubt * whole)
      {
        const std::array<Box2, 4> quarters = Quarters(cell.Box);
        for (std::size_t k = 0; k < quarters.size(); ++k)
        {
          next.push_back({ quarters[k], cell.Depth + 1, {}, cell.AtQuarters[k], {} });
        }
        continue;
      }
      this->Density += cell.Values.Density;
      this->Area += cell.Values.Inside;
    }
    return next;
  }

  const DomainLocator& Locator;
  const Spacing& F;
  Pulse Beats;
  double NumberOfCells = 0.0;
  double Density = 0.0; ///< integral over the cells that are done
  double Area = 0.0;    ///< of these, inside
};

// How 1/f is integrated along a segment.
struct SegmentRule
{
  double AtStart = 0.0; ///< f
  double AtEnd = 0.0;
  double Panels = 1.0;
};

// Most segments begin where the one before ends.
std::vector<SegmentRule> MakeRules(const Domain& domain, const Spacing& spacing, Pulse& pulse)
{
  std::vector<SegmentRule> rules;
  rules.reserve(domain.Starts.size());
  Id last = NoId;
  double atLast = 0.0;
  for (Id segment = 0; segment < domain.NumberOfSegments() && pulse.Beat(); ++segment)
  {
    const Id start = domain.Starts[segment];
    const double atStart = start == last ? atLast : spacing(domain.Vertices[start]);
    last = domain.Ends[segment];
    atLast = spacing(domain.Vertices[last]);
    const double length = Distance(domain.Vertices[start], domain.Vertices[last]);
    const double panels = length / (SegmentPanel * std::min(atStart, atLast));
    rules.push_back({ atStart, atLast, std::max(1.0, std::min(MostPanels, panels)) });
  }
  return rules;
}

// Of 1/f, between two places where it is known and linear between: small at one of them, as at the
// tip of a cone, it would outweigh all else if 1/f were linear.
double MeanInverse(double first, double last)
{
  const double growth = last - first;
  return std::abs(growth) > NearlyLevel * first ? std::log(last / first) / growth
                                                : 2.0 / (first + last);
}

// Of 1/f along a segment.
double IntegrateInverse(const Domain& domain, Id segment, const SegmentRule& rule, int panels,
  const Spacing& spacing, Pulse& pulse)
{
  const Point2& a = domain.Vertices[domain.Starts[segment]];
  const Point2& b = domain.Vertices[domain.Ends[segment]];
  double sum = 0.0;
  double last = rule.AtStart;
  for (int k = 1; k <= panels && pulse.Beat(); ++k)
  {
    const double next = k < panels
      ? spacing(a + static_cast<double>(k) / static_cast<double>(panels) * (b - a))
      : rule.AtEnd;
    sum += MeanInverse(last, next);
    last = next;
  }
  return sum / panels * Distance(a, b);
}

} // namespace

double IntegrateDensity(
  const Domain& domain, const DomainLocator& locator, const Spacing& spacing, Monitor& monitor)
{
  if (spacing.IsUniform())
  {
    const double f = spacing(domain.Bounds.Center());
    return domain.Area / (f * f);
  }
  Quadrature quadrature(locator, spacing, monitor);
  quadrature.Run(FirstCells(domain.Bounds));
  const double mean = quadrature.Mean() >= 0.0
    ? quadrature.Mean()
    : MeanDensityOfSegments(domain, spacing, quadrature.Progress());
  return mean * domain.Area;
}

double EstimateDivisionPoints(
  const Domain& domain, const Spacing& spacing, double partLength, Monitor& monitor)
{
  Pulse pulse(monitor);
  const std::vector<SegmentRule> rules = MakeRules(domain, spacing, pulse);
  const double panels = std::accumulate(rules.begin(), rules.end(), 0.0,
    [](double sum, const SegmentRule& rule) { return sum + rule.Panels; });
  const double share = std::min(1.0, MostPanelsInAll / panels);
  double points = 0.0;
  for (std::size_t k = 0; k < rules.size() && pulse.Beat(); ++k)
  {
    pulse.SetFraction(static_cast<double>(k) / static_cast<double>(rules.size()));
    const int count = static_cast<int>(std::ceil(share * rules[k].Panels));
    const double parts =
      IntegrateInverse(domain, static_cast<Id>(k), rules[k], count, spacing, pulse) / partLength;
    points += std::max(0.0, parts - 1.0);
  }
  return points;
}

} // namespace biting
