// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SpatialOrder.h"

#include "../Base/Box.h"
#include "../Base/SortInSteps.h"

#include <algorithm>  // for max, min
#include <array>      // for cells
#include <cstddef>    // for size_t
#include <cstdint>    // for keys
#include <functional> // for less

namespace biting
{

namespace
{

/// A run order[Begin .. End-1] that is still to be sorted.
struct Run
{
  std::size_t Begin = 0;
  std::size_t End = 0;

  std::size_t Size() const { return this->End - this->Begin; }
};

/// Along the curve, and the position in `points` in the low half.
using Key = std::uint64_t;
constexpr int IndexBits = 32;

/// Cells of the curve along each axis of a run's box, less one: 16 bits in the plane and 10 in
/// space, so a place on the curve has 32 or 30.
template <std::size_t D>
constexpr double LastCell = D == 2 ? 65535.0 : 1023.0;

/// Runs no longer than this stay in any order: a walk across them is as short.
constexpr std::size_t LeastRun = 4;

/// Rounds begin with at least this many points.
constexpr std::size_t LeastRound = 64;

/// Where steps end, as shares of the time: that of all, and that of one round.
constexpr double SplittingEnd = 0.2;
constexpr double BoxEnd = 0.1;
constexpr double KeysEnd = 0.4;
constexpr double SortEnd = 0.8;

/// Place on the Hilbert curve: level by level the cells are turned as the curve turns; then it is
/// the Gray code whose bits the axes share (J. Skilling, "Programming the Hilbert curve", 2004).
template <std::size_t D>
std::uint32_t HilbertPlace(std::array<std::uint32_t, D> cell)
{
  constexpr std::uint32_t TopBit = (static_cast<std::uint32_t>(LastCell<D>) + 1) / 2;
  for (std::uint32_t bit = TopBit; bit > 1; bit >>= 1)
  {
    for (std::uint32_t& x : cell)
    {
      const bool isSet = (x & bit) != 0;
      const std::uint32_t exchanged = isSet ? 0 : (cell[0] ^ x) & (bit - 1);
      cell[0] ^= isSet ? bit - 1 : exchanged;
      x ^= exchanged;
    }
  }
  for (std::size_t d = 1; d < D; ++d)
  {
    cell[d] ^= cell[d - 1];
  }
  std::uint32_t turned = 0;
  for (std::uint32_t bit = TopBit; bit > 1; bit >>= 1)
  {
    turned ^= (cell[D - 1] & bit) != 0 ? bit - 1 : 0;
  }
  std::uint32_t place = 0;
  for (std::uint32_t bit = TopBit; bit > 0; bit >>= 1)
  {
    for (const std::uint32_t x : cell)
    {
      place = 2 * place + (((x ^ turned) & bit) != 0 ? 1 : 0);
    }
  }
  return place;
}

/// The place of the cell in which a point lies that is so far from the low corner of the box.
template <std::size_t D>
Key PlaceOf(const Point<D>& offset, double scale)
{
  std::array<std::uint32_t, D> cell{};
  for (std::size_t d = 0; d < D; ++d)
  {
    cell[d] = static_cast<std::uint32_t>(std::min(offset[d] * scale, LastCell<D>));
  }
  return HilbertPlace(cell);
}

/// The round of a point, 0 the last: round r + 1 has a quarter of the points of round r.
std::size_t RoundOf(std::size_t index, std::size_t lastRound)
{
  std::uint64_t hash = (static_cast<std::uint64_t>(index) + 1u) * 0x9E3779B97F4A7C15ull;
  hash = (hash ^ (hash >> 32)) * 0xD1B54A32D192ED03ull;
  hash ^= hash >> 29;
  std::size_t round = 0;
  while (round < lastRound && (hash & 3u) == 0u)
  {
    hash >>= 2;
    ++round;
  }
  return round;
}

std::size_t LastRound(std::size_t numberOfPoints)
{
  std::size_t round = 0;
  while ((numberOfPoints >> (2 * (round + 1))) >= LeastRound)
  {
    ++round;
  }
  return round;
}

/// Fills `order` round by round, the smallest first; returns where each round lies.
std::vector<Run> SplitIntoRounds(std::vector<Id>& order, Pulse& pulse)
{
  const PulsePart part(pulse, 0.0, SplittingEnd);
  const std::size_t lastRound = LastRound(order.size());
  std::vector<std::size_t> ends(lastRound + 2, 0);
  pulse.ForEach(order.size(),
    [&ends, lastRound](std::size_t i) { ++ends[lastRound - RoundOf(i, lastRound) + 1]; });
  std::vector<Run> rounds;
  for (std::size_t r = 0; r <= lastRound; ++r)
  {
    ends[r + 1] += ends[r];
    rounds.push_back({ ends[r], ends[r + 1] });
  }
  pulse.ForEach(order.size(),
    [&order, &ends, lastRound](std::size_t i)
    { order[ends[lastRound - RoundOf(i, lastRound)]++] = static_cast<Id>(i); });
  return rounds;
}

/// Sorts runs along the curve; where many points share its last cell the run is sorted again,
/// relative to the box of its own points.
template <std::size_t D>
class CurveSorter
{
public:
  CurveSorter(const std::vector<Point<D>>& points, std::vector<Id>& order, Pulse& pulse)
    : Points(points)
    , Order(order)
    , Beats(pulse)
  {
  }

  void Sort(const Run& whole)
  {
    this->Pending.push_back(whole);
    while (!this->Pending.empty() && !this->Beats.HasStopped())
    {
      const Run run = this->Pending.back();
      this->Pending.pop_back();
      if (this->MakeKeys(run))
      {
        SortInSteps(this->Keys, std::less<>(), this->Beats);
        this->WriteBack(run);
      }
    }
  }

private:
  /// False where all points of the run coincide, and on abort.
  bool MakeKeys(const Run& run)
  {
    const Box<D> box = this->BoxOf(run);
    double size = 0.0;
    for (std::size_t d = 0; d < D; ++d)
    {
      size = std::max(size, box.Size(d));
    }
    if (!(size > 0.0))
    {
      return false;
    }
    const double scale = LastCell<D> / size;
    const PulsePart part(this->Beats, BoxEnd, KeysEnd);
    this->Keys.resize(run.Size());
    return this->Beats.ForEach(run.Size(),
      [this, &run, &box, scale](std::size_t i)
      {
        const Key place = PlaceOf(this->PointAt(run.Begin + i) - box.Low, scale);
        this->Keys[i] = (place << IndexBits) | static_cast<Key>(this->Order[run.Begin + i]);
      });
  }

  Box<D> BoxOf(const Run& run)
  {
    const PulsePart part(this->Beats, 0.0, BoxEnd);
    Box<D> box;
    this->Beats.ForEach(
      run.Size(), [this, &run, &box](std::size_t i) { box.Add(this->PointAt(run.Begin + i)); });
    return box;
  }

  void WriteBack(const Run& run)
  {
    const PulsePart part(this->Beats, SortEnd, 1.0);
    std::size_t begin = run.Begin;
    this->Beats.ForEach(run.Size(),
      [this, &run, &begin](std::size_t i)
      {
        const Key key = this->Keys[i];
        this->Order[run.Begin + i] = static_cast<Id>(key & 0xFFFFFFFFull);
        const bool isLast =
          i + 1 == run.Size() || (this->Keys[i + 1] >> IndexBits) != (key >> IndexBits);
        if (isLast)
        {
          this->Refine({ begin, run.Begin + i + 1 });
          begin = run.Begin + i + 1;
        }
      });
  }

  void Refine(const Run& run)
  {
    if (run.Size() > LeastRun)
    {
      this->Pending.push_back(run);
    }
  }

  const Point<D>& PointAt(std::size_t position) const
  {
    return this->Points[this->Order[position]];
  }

  const std::vector<Point<D>>& Points;
  std::vector<Id>& Order;
  Pulse& Beats;
  std::vector<Run> Pending;
  std::vector<Key> Keys;
};

} // namespace

template <std::size_t D>
std::vector<Id> SpatialOrder(const std::vector<Point<D>>& points, Pulse& pulse)
{
  std::vector<Id> order(points.size());
  CurveSorter<D> sorter(points, order, pulse);
  const std::vector<Run> rounds = SplitIntoRounds(order, pulse);
  const PulsePart sorting(pulse, SplittingEnd, 1.0);
  for (const Run& round : rounds)
  {
    const double count = static_cast<double>(points.size());
    const PulsePart part(pulse, round.Begin / count, round.End / count);
    sorter.Sort(round);
  }
  return order;
}

template std::vector<Id> SpatialOrder(const std::vector<Point2>& points, Pulse& pulse);
template std::vector<Id> SpatialOrder(const std::vector<Point3>& points, Pulse& pulse);

} // namespace biting
