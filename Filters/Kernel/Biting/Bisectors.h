// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingBisectors_h
#define BitingBisectors_h

#include "../Base/Ids.h"
#include "../Base/Point.h"
#include "BiteGrid.h"
#include "BiteOutline.h" // for Gauge
#include "Bites.h"

#include <algorithm> // for max
#include <array>     // for the neighbours
#include <cstddef>   // for their number
#include <utility>   // for intervals

namespace biting
{

/// A point of the front at equal distances from two bites.
struct BisectorPoint
{
  Point2 Place;
  Id Neighbor = NoId;  ///< the other bite
  double Misfit = 0.0; ///< of the triangle with the two centres: 0 where its sides are as wanted
};

/// Where the line offset + t direction runs inside a bite about the origin, as an interval of t: it
/// ends before it begins where the line misses the bite.
std::pair<double, double> InsideOf(
  const Point2& axis, double halfWidth, const Point2& offset, const Point2& direction);

/// Finds the points of the front where the bisector of two bites leaves both.
///
/// A bite may sit anywhere on the front, as far as the theory of the paper goes (section 4 needs
/// only that no centre lies in an earlier bite and that nothing is left uncovered). Where the
/// bisector of the centres a and b leaves both bites is a point of the front, unless a third bite
/// covers it, and with a and b it makes an isosceles triangle. Circles of equal radius meet there;
/// squares with half-width sqrt(3)/2 and centres 1 apart, turned to their bond, make the triangular
/// lattice and nothing else.
///
/// Squares are then shifted to where f asks for them (BiteTriangle.h).
///
/// Where more than 64 bites of the boundary crowd about one of them, its points are left out: each
/// of them would be looked for in the crowd, and hardly one is a point of the front.
///
/// Inner bites cover only their concentric core, `tolerance` times as wide: a good place is not
/// given up for one that an inner bite just reaches. Bites on the boundary cover all of themselves,
/// so that no vertex comes near the middle of an edge.
class Bisectors
{
public:
  /// How far apart the centres may be, in units of the wanted length.
  static constexpr double GreatestBond = 1.4;

  /// `lengthPerHalfWidth`: the wanted distance of neighbours, in half-widths of bites. `tolerance`:
  /// in (0, 1]. `slack`: how far inside of a bite, as a length, a point still lies on its outline.
  /// Grid and bites must outlive this object; the grid's near reach must be
  /// GreatestBond lengthPerHalfWidth.
  Bisectors(const Bites& bites, const BiteGrid& grid, double lengthPerHalfWidth, double tolerance,
    double slack);

  /// Calls visit(BisectorPoint) for those of `bite` with bites nearer than GreatestBond, by the
  /// length at the other one, that none of these covers. Others may, and they may lie outside of
  /// the domain.
  template <typename Visit>
  void VisitPoints(Id bite, Visit&& visit);

  /// Whether a bite covers p. Where none does its neighbours are at hand for VisitPoints of the
  /// next bite, should it be there. Not to be called within a visit.
  bool IsCovered(const Point2& p);

  /// Whether a bite after `birth` does, and would if p were moved by about half of its half-width.
  bool IsDeep(const Point2& p, Id birth) const;

  /// Whether this one does.
  bool IsCoveredBy(Id bite, const Point2& p) const;

private:
  static constexpr double TieTolerance =
    1e-12; // of a half-width: a point this near a side lies on it
  // Of what is left of a core as small as the rounding of places: each bite takes something away.
  static constexpr double LeastCore = 0.5;
  static constexpr double DeepShare = 0.4;         // of a core
  static constexpr std::size_t MostNeighbors = 64; // more than there are where f follows the domain

  // A bite by value, so that pairs read nothing else.
  struct Neighbor
  {
    Id Bite;
    Point2 Center;
    Point2 Axis;
    double HalfWidth;
    double Core; ///< half-width of what it covers
  };

  // Of the points over a bond, in units of the bond: left of it, and right of it, negative. 0:
  // none.
  struct Heights
  {
    double Left;
    double Right;
  };

  template <typename Stop>
  bool Gather(const Point2& p, Stop&& stopsAt);
  void SetBite(Id bite);
  bool IsFull() const { return this->NumberOfNeighbors == MostNeighbors; }
  bool IsCrowded() const;
  Neighbor MakeNeighbor(Id bite) const;
  double CoreOf(Id bite) const;
  Heights HeightsOver(const Neighbor& other, const Point2& bond) const;
  double Misfit(const Neighbor& other, const Point2& bond, double height) const;
  template <typename Visit>
  void VisitPair(const Neighbor& other, Visit&& visit) const;
  static bool Covers(const Neighbor& neighbor, const Point2& p)
  {
    return GaugeOf(neighbor.Axis, p - neighbor.Center) < neighbor.Core;
  }
  bool IsCoveredNearby(const Point2& p) const;

  const Bites& All;
  const BiteGrid& Grid;
  double LengthPerHalfWidth;
  double Tolerance;
  double Slack;
  Neighbor Bite; ///< the bite at hand

  // Of it, or of the next one, if it comes to Next.
  std::array<Neighbor, MostNeighbors> Neighbors;
  std::size_t NumberOfNeighbors = 0;
  Point2 Next;
  Id NextBite = NoId; ///< NoId: there is none
};

inline bool Bisectors::IsCoveredBy(Id bite, const Point2& p) const
{
  return Gauge(this->All, bite, p) < this->CoreOf(bite);
}

inline double Bisectors::CoreOf(Id bite) const
{
  const bool isInner = this->All.Phases[bite] == BitePhase::Interior;
  const double tolerance = isInner ? this->Tolerance : 1.0;
  const double core = (1.0 - TieTolerance) * tolerance * this->All.HalfWidths[bite];
  return std::max(core - this->Slack, LeastCore * core);
}

template <typename Visit>
void Bisectors::VisitPoints(Id bite, Visit&& visit)
{
  this->SetBite(bite);
  if (this->IsCrowded())
  {
    return;
  }
  for (std::size_t k = 0; k < this->NumberOfNeighbors; ++k)
  {
    this->VisitPair(this->Neighbors[k], visit);
  }
}

template <typename Visit>
void Bisectors::VisitPair(const Neighbor& other, Visit&& visit) const
{
  const Point2 bond = other.Center - this->Bite.Center;
  const Heights heights = this->HeightsOver(other, bond);
  const Point2 middle = this->Bite.Center + 0.5 * bond;
  const auto visitPoint = [this, &other, &bond, &middle, &visit](double height)
  {
    const Point2 place = middle + height * Perpendicular(bond);
    if (height != 0.0 && !this->IsCoveredNearby(place))
    {
      visit(BisectorPoint{ place, other.Bite, this->Misfit(other, bond, height) });
    }
  };
  visitPoint(heights.Left);
  visitPoint(heights.Right);
}

} // namespace biting

#endif
