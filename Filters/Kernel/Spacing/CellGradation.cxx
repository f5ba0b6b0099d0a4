// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "CellGradation.h"

#include "../Base/Numbers.h"
#include "../Base/Tasks.h"

#include <algorithm> // for min, max
#include <cstdint>   // for marks
#include <queue>     // for the lowest first
#include <utility>   // for pairs

namespace biting
{
namespace
{

/// The size of a leaf, as a share of f: its diagonal is at most f. In a leaf f is off by at most
/// half of what it grows along the diagonal, so leaves are smaller where g is above .3. A g above 1
/// counts as 1.
double SizeOfLeaf(double gradation, std::size_t dimensions)
{
  constexpr double GrowthAcross = 0.3;
  return std::min(1.0, GrowthAcross / std::min(gradation, 1.0)) /
    std::sqrt(static_cast<double>(dimensions));
}

/// Where what is given jumps but no place is known to be low: as a share of that size.
constexpr double ShareOfJump = 0.5;

/// By less, as a share, nothing is lower than something else, nor is a function not linear.
constexpr double Slight = 0.02;

/// By less, as a share, an origin is not better than another one.
constexpr double SlightGain = 1e-3;

/// Origins at a distance h, e apart, miss those between them by about g e^2 / (8 h): by less than
/// this share of f, at the most.
constexpr double SlightMiss = 0.02;

/// With so many cells none is cut any more: then f is less accurate.
std::size_t MostCells(std::size_t places)
{
  constexpr std::size_t Least = 1 << 21;
  constexpr std::size_t Most = 1 << 24;
  return std::min(std::max(Least, 8 * places), Most);
}

/// Cuts cells in rounds, and lets origins spread after each.
template <std::size_t D>
class Grading
{
public:
  Grading(SizeCells<D>& cells, const GivenAt<D>& givenAt, bool hasGaps, const Box<D>& bounds,
    double gradation, Pulse& pulse)
    : Work(cells)
    , GivenValue(givenAt)
    , HasGaps(hasGaps)
    , Bounds(bounds)
    , Gradation(gradation)
    , LeafSize(SizeOfLeaf(gradation, D))
    , Beats(pulse)
  {
  }

  std::vector<std::uint8_t> Run()
  {
    this->Wait(0);
    this->ValueNewCorners();
    this->Spread();
    while (!this->Waiting.empty() && !this->Beats.HasStopped())
    {
      this->CutRound();
    }
    return this->FindAsGiven();
  }

private:
  using Cell = typename SizeCells<D>::Cell;
  using Corner = typename SizeCells<D>::Corner;
  using Units = typename SizeCells<D>::Units;
  static constexpr int Children = SizeCells<D>::Children;

  double Cone(const LowPlace<D>& low, const Point<D>& x) const
  {
    return low.Value + this->Gradation * Distance<D>(low.At, x);
  }
  double Cone(Id origin, const Point<D>& x) const
  {
    return this->Cone(this->Work.OriginAt(origin), x);
  }

  /// What the origins of a cell allow.
  double ConesOf(const Cell& cell, const Point<D>& x) const
  {
    double least = cell.Lowest != NoId ? this->Cone(cell.Lowest, x) : Infinity;
    for (const Id corner : cell.Corners)
    {
      least = std::min(least, this->Cone(this->Work.CornerAt(corner).Origin, x));
    }
    return least;
  }

  void CutRound()
  {
    std::vector<Id> waiting;
    waiting.swap(this->Waiting);
    const std::size_t most = MostCells(this->Work.Places.size());
    this->FirstNewCell = this->Work.Cells.size();
    for (const Id cell : waiting)
    {
      this->Work.CellAt(cell).IsWaiting = false;
      if (!this->Beats.Beat(64) || this->Work.CellAt(cell).FirstChild > 0)
      {
        continue;
      }
      if (this->Work.Cells.size() < most && this->NeedsCut(cell))
      {
        const Id first = this->Work.Cut(cell);
        for (int child = 0; child < Children; ++child)
        {
          this->Wait(first + child);
        }
      }
      else
      {
        this->OfferPlaces(this->Work.CellAt(cell));
      }
    }
    this->ValueNewCorners();
    this->Spread();
  }

  void Wait(Id cell)
  {
    if (!this->Work.CellAt(cell).IsWaiting)
    {
      this->Work.CellAt(cell).IsWaiting = true;
      this->Waiting.push_back(cell);
    }
  }

  bool NeedsCut(Id id) const
  {
    const Cell& cell = this->Work.CellAt(id);
    const bool hasPlaces = cell.Lowest != NoId;
    double least = hasPlaces ? this->Work.OriginAt(cell.Lowest).Value : Infinity;
    for (const Id corner : cell.Corners)
    {
      least = std::min(least, this->Work.CornerAt(corner).Size);
    }
    const Point<D> center = this->Work.CenterOf(cell);
    const double size = this->Work.SizeOf(cell);
    const double away = std::max(
      this->Bounds.DistanceTo(center) - 0.5 * std::sqrt(static_cast<double>(D)) * size, 0.0);
    const double allowed = least + this->Gradation * away;
    if (cell.Level == SizeCells<D>::MaximumLevel - 1 ||
      size <= ShareOfJump * this->LeafSize * allowed)
    {
      return false;
    }
    if (size > this->LeafSize * allowed &&
      (hasPlaces || cell.MustBeCut || this->MissesOrigins(cell, allowed)))
    {
      return true;
    }
    return !hasPlaces && this->HasJump(cell, center);
  }

  /// Where f is below what is given: whether others may be lower between the origins of corners.
  bool MissesOrigins(const Cell& cell, double allowed) const
  {
    std::array<LowPlace<D>, std::size_t(1) << D> origins;
    std::size_t count = 0;
    double nearest = Infinity;
    for (const Id id : cell.Corners)
    {
      const Corner& corner = this->Work.CornerAt(id);
      if (corner.Size < (1.0 - Slight) * corner.Given)
      {
        origins[count] = this->Work.OriginAt(corner.Origin);
        nearest = std::min(nearest, Distance<D>(origins[count].At, this->Work.PlaceOf(corner.At)));
        ++count;
      }
    }
    double square = 0.0;
    for (std::size_t a = 0; a < count; ++a)
    {
      for (std::size_t b = 0; b < a; ++b)
      {
        const double apart = Distance<D>(origins[a].At, origins[b].At);
        square = std::max(square, apart * apart);
      }
    }
    return this->Gradation * square > 8.0 * SlightMiss * allowed * nearest;
  }

  /// Whether what is extended from a border is not linear in a cell.
  bool HasJump(const Cell& cell, const Point<D>& center) const
  {
    bool isOutside = false;
    for (const Id corner : cell.Corners)
    {
      isOutside = isOutside || !this->Work.CornerAt(corner).IsInside;
    }
    if (!isOutside && !this->HasGaps)
    {
      return false;
    }
    const auto middle = this->GivenValue(center);
    if (!isOutside && middle.IsInside)
    {
      return false;
    }
    double sum = 0.0;
    double least = middle.Value;
    for (const Id id : cell.Corners)
    {
      const double value = this->Work.CornerAt(id).Given;
      sum += value;
      least = std::min(least, value);
    }
    return std::abs(sum / Children - middle.Value) > Slight * least ||
      this->IsBentOnSides(cell, Slight * least);
  }

  bool IsBentOnSides(const Cell& cell, double tolerance) const
  {
    for (int k = 0; k < Children; ++k)
    {
      for (std::size_t d = 0; d < D; ++d)
      {
        const int other = k | (1 << d);
        if (other != k)
        {
          const Corner& a = this->Work.CornerAt(cell.Corners[static_cast<std::size_t>(k)]);
          const Corner& b = this->Work.CornerAt(cell.Corners[static_cast<std::size_t>(other)]);
          Units middle = a.At;
          middle[d] += this->Work.SideOf(cell) / 2;
          const double value = this->GivenValue(this->Work.PlaceOf(middle)).Value;
          if (std::abs(0.5 * (a.Given + b.Given) - value) > tolerance)
          {
            return true;
          }
        }
      }
    }
    return false;
  }

  void ValueNewCorners()
  {
    const std::size_t first = this->Work.Corners.size() - this->Work.MadeFor.size();
    ForEachAtOnce(this->Beats, this->Work.MadeFor.size(),
      [this, first](std::size_t k)
      {
        Corner& corner = this->Work.Corners[first + k];
        const auto given = this->GivenValue(this->Work.PlaceOf(corner.At));
        corner.Given = given.Value;
        corner.IsInside = given.IsInside;
        corner.Size = given.Value;
        corner.Origin = ~static_cast<Id>(first + k);
      });
    for (std::size_t k = 0; k < this->Work.MadeFor.size(); ++k)
    {
      const auto id = static_cast<Id>(first + k);
      this->Moving.emplace(this->Work.CornerAt(id).Size, id);
      if (this->Work.MadeFor[k] != NoId)
      {
        for (const Id other : Cell(this->Work.CellAt(this->Work.MadeFor[k])).Corners)
        {
          const Id origin = this->Work.CornerAt(other).Origin;
          this->Offer(origin, this->Work.OriginAt(origin), id);
        }
      }
    }
    this->Work.MadeFor.clear();
    for (std::size_t k = this->FirstNewCell; k < this->Work.Cells.size(); ++k)
    {
      const Cell& cell = this->Work.Cells[k];
      for (int corner = 0; corner < Children && cell.Lowest != NoId; ++corner)
      {
        this->Offer(cell.Lowest, this->Work.OriginAt(cell.Lowest),
          cell.Corners[static_cast<std::size_t>(corner)]);
      }
    }
  }

  /// The lowest one was offered before.
  void OfferPlaces(Cell& cell)
  {
    if (cell.HasOffered || cell.LastPlace - cell.FirstPlace < 2)
    {
      return;
    }
    cell.HasOffered = true;
    for (Id place = cell.FirstPlace; place < cell.LastPlace; ++place)
    {
      for (const Id corner : cell.Corners)
      {
        this->Offer(place, this->Work.OriginAt(place), corner);
      }
    }
  }

  void Offer(Id origin, const LowPlace<D>& low, Id corner)
  {
    Corner& to = this->Work.CornerAt(corner);
    if (to.Origin == origin || to.Size <= low.Value)
    {
      return;
    }
    const double offered = this->Cone(low, this->Work.PlaceOf(to.At));
    if (offered < (1.0 - SlightGain) * to.Size)
    {
      to.Size = offered;
      to.Origin = origin;
      this->Moving.emplace(offered, corner);
    }
  }

  /// Origins go from corners to corners of the same leaves, until none is better anywhere.
  void Spread()
  {
    while (!this->Moving.empty() && this->Beats.Beat(64))
    {
      const auto [size, id] = this->Moving.top();
      this->Moving.pop();
      if (size == this->Work.CornerAt(id).Size)
      {
        const Id origin = this->Work.CornerAt(id).Origin;
        const LowPlace<D> low = this->Work.OriginAt(origin);
        for (int orthant = 0; orthant < Children; ++orthant)
        {
          const Id leaf = this->Work.LeafAt(id, orthant);
          if (leaf != NoId)
          {
            this->SpreadIn(leaf, id, orthant, low);
          }
        }
      }
    }
  }

  void SpreadIn(Id leaf, Id id, int orthant, const LowPlace<D>& low)
  {
    const Cell& cell = this->Work.CellAt(leaf);
    for (const Id other : cell.Corners)
    {
      this->Offer(this->Work.CornerAt(id).Origin, low, other);
    }
    const bool isOnSide = cell.Corners[static_cast<std::size_t>(~orthant & (Children - 1))] != id;
    if (isOnSide && !cell.MustBeCut && this->IsBelowBeside(cell, id, orthant))
    {
      this->Work.CellAt(leaf).MustBeCut = true;
    }
    this->Wait(leaf);
  }

  /// Whether the origin of a corner on a side of a leaf is lower than all of the leaf's, and what
  /// is given, at one of two places within the leaf: near the corner, or far from it.
  bool IsBelowBeside(const Cell& cell, Id id, int orthant) const
  {
    const Corner& corner = this->Work.CornerAt(id);
    const double size = this->Work.SizeOf(cell);
    if (size <= this->LeafSize * corner.Size)
    {
      return false;
    }
    for (const double step : { 0.5 * this->LeafSize * corner.Size, 0.25 * size })
    {
      Point<D> beside = this->Work.PlaceOf(corner.At);
      for (std::size_t d = 0; d < D; ++d)
      {
        beside[d] += ((orthant >> d) & 1) ? step : -step;
      }
      const double above = (1.0 - Slight) * this->ConesOf(cell, beside);
      const double below = this->Cone(corner.Origin, beside);
      if (below < above && below < (1.0 - Slight) * this->GivenValue(beside).Value)
      {
        return true;
      }
    }
    return false;
  }

  bool IsAsGiven(const Cell& cell) const
  {
    constexpr double Share = 1.0 - 0.25 * Slight;
    if (cell.Lowest != NoId)
    {
      return false;
    }
    for (const Id corner : cell.Corners)
    {
      if (this->Work.CornerAt(corner).Size < Share * this->Work.CornerAt(corner).Given)
      {
        return false;
      }
    }
    const Point<D> center = this->Work.CenterOf(cell);
    return this->ConesOf(cell, center) >= Share * this->GivenValue(center).Value;
  }

  /// Of each cell, whether it is a leaf where f is as given.
  std::vector<std::uint8_t> FindAsGiven()
  {
    std::vector<std::uint8_t> areAsGiven(this->Work.Cells.size(), 0);
    ForEachAtOnce(this->Beats, this->Work.Cells.size(),
      [this, &areAsGiven](std::size_t k)
      {
        const Cell& cell = this->Work.Cells[k];
        areAsGiven[k] = cell.FirstChild == 0 && this->IsAsGiven(cell) ? 1 : 0;
      });
    return areAsGiven;
  }

  SizeCells<D>& Work;
  const GivenAt<D>& GivenValue;
  const bool HasGaps;
  const Box<D>& Bounds;
  const double Gradation;
  const double LeafSize; ///< as a share of f
  Pulse& Beats;
  std::size_t FirstNewCell = 0;
  std::vector<Id> Waiting; ///< cells to be asked about

  using Entry = std::pair<double, Id>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> Moving;
};

} // namespace

template <std::size_t D>
std::vector<std::uint8_t> GradeCells(SizeCells<D>& cells, const GivenAt<D>& givenAt, bool hasGaps,
  const Box<D>& bounds, double gradation, Pulse& pulse)
{
  return Grading<D>(cells, givenAt, hasGaps, bounds, gradation, pulse).Run();
}

template std::vector<std::uint8_t> GradeCells(
  SizeCells<2>&, const GivenAt<2>&, bool, const Box<2>&, double, Pulse&);
template std::vector<std::uint8_t> GradeCells(
  SizeCells<3>&, const GivenAt<3>&, bool, const Box<3>&, double, Pulse&);

} // namespace biting
