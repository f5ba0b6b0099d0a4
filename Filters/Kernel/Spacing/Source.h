// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingSource_h
#define BitingSource_h

#include "../Base/Box.h"
#include "../Base/Pulse.h"
#include "ValueRange.h"

#include <algorithm>  // for max
#include <array>      // for places
#include <cmath>      // for sqrt
#include <cstddef>    // for dimensions
#include <functional> // for what is given
#include <vector>     // for low places

namespace biting
{

/// A place, and the spacing given there: scaled and clamped.
template <std::size_t D>
struct LowPlace
{
  Point<D> At{};
  double Value = 0.0;
};

/// A spacing that is given on cells: a grid, triangles, tetrahedra. To add a kind of source, derive
/// from this.
template <std::size_t D>
class Source
{
public:
  struct Sample
  {
    double Value;
    bool IsInside; ///< else nothing is given there; the value is that of the nearest border
  };

  virtual ~Source() = default;

  /// What is given at x. Called from any number of threads at once.
  virtual Sample At(const Point<D>& x) const = 0;

  /// The places from which the spacing grows by more than `slope`: of each cell that is steeper,
  /// the corners, and places on its edges (in space: on its faces) whose distance is at most half
  /// of the value there. A place may be left out where another one of the same edge is lower by
  /// more than `slope` times their distance.
  virtual std::vector<LowPlace<D>> LowPlaces(
    double slope, const ValueRange& range, Pulse& pulse) const = 0;

  /// Whether values may jump outside of the source, though no cell is steep.
  virtual bool MayJumpOutside() const { return false; }

protected:
  Source() = default;
  Source(const Source&) = default;
  Source(Source&&) noexcept = default;
  Source& operator=(const Source&) = default;
  Source& operator=(Source&&) noexcept = default;
};

/// What is given at a place by all sources, scaled and clamped.
template <std::size_t D>
using GivenAt = std::function<typename Source<D>::Sample(const Point<D>&)>;

/// How many places are listed on each of so many edges: a mesh that needs more on all of them would
/// be refused.
inline double MostPlacesOnEdge(std::size_t edges)
{
  constexpr double MostInAll = 1 << 18;
  constexpr double Least = 16.0;
  return std::max(Least, MostInAll / static_cast<double>(edges + 1));
}

/// Lists at most so many places on the edge from a to b of a steep cell, the ends apart, for
/// Source::LowPlaces.
template <std::size_t D>
void AddPlacesOnEdge(const LowPlace<D>& a, const LowPlace<D>& b, double slope, double most,
  std::vector<LowPlace<D>>& places)
{
  const double length = Distance<D>(a.At, b.At);
  const double rise = b.Value - a.Value;
  if (rise < 0.0 || (rise == 0.0 && b.At < a.At))
  {
    AddPlacesOnEdge(b, a, slope, most, places);
    return;
  }
  if (rise > slope * length)
  {
    return;
  }
  constexpr double Step = 0.4; // of the value
  const double leastStep = length / most;
  for (double along = std::max(Step * a.Value, leastStep); along < length - 0.5 * Step * b.Value;)
  {
    const double weight = along / length;
    LowPlace<D> place;
    for (std::size_t d = 0; d < D; ++d)
    {
      place.At[d] = (1.0 - weight) * a.At[d] + weight * b.At[d];
    }
    place.Value = a.Value + weight * rise;
    places.push_back(place);
    along += std::max(Step * place.Value, leastStep);
  }
}

} // namespace biting

#endif
