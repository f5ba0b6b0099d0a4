// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SizeCells.h"

#include "../Base/Tasks.h"

#include <algorithm> // for min, max, sort
#include <utility>   // for pairs

namespace biting
{

template <std::size_t D>
SizeCells<D>::SizeCells(Point<D> low, Point<D> high, std::vector<LowPlace<D>> places, Pulse& pulse)
  : Places(std::move(places))
{
  for (const LowPlace<D>& place : this->Places)
  {
    for (std::size_t d = 0; d < D; ++d)
    {
      low[d] = std::min(low[d], place.At[d]);
      high[d] = std::max(high[d], place.At[d]);
    }
  }
  for (std::size_t d = 0; d < D; ++d)
  {
    this->Size = std::max(this->Size, high[d] - low[d]);
  }
  for (std::size_t d = 0; d < D; ++d)
  {
    this->Low[d] = low[d] + 0.5 * (high[d] - low[d]) - 0.5 * this->Size;
  }
  this->UnitLength = this->Size / (1u << MaximumLevel);
  this->SortPlaces(pulse);
  Cell root;
  root.LastPlace = static_cast<Id>(this->Places.size());
  this->FindLowest(root);
  for (int k = 0; k < Children; ++k)
  {
    Units at;
    for (std::size_t d = 0; d < D; ++d)
    {
      at[d] = ((k >> d) & 1) ? 1u << MaximumLevel : 0u;
    }
    root.Corners[static_cast<std::size_t>(k)] = this->FindCorner(at, NoId);
  }
  this->Cells.push_back(root);
}

template <std::size_t D>
Id SizeCells<D>::Cut(Id id)
{
  const auto first = static_cast<Id>(this->Cells.size());
  this->CellAt(id).FirstChild = first;
  const Cell parent = this->CellAt(id);
  this->Cells.resize(this->Cells.size() + Children);
  this->DealPlaces(parent, first);
  const std::uint32_t half = this->SideOf(parent) / 2;
  for (int child = 0; child < Children; ++child)
  {
    Cell& cell = this->CellAt(first + child);
    cell.Level = parent.Level + 1;
    for (std::size_t d = 0; d < D; ++d)
    {
      cell.Low[d] = parent.Low[d] + (((child >> d) & 1) ? half : 0u);
    }
    for (int k = 0; k < Children; ++k)
    {
      Units at = cell.Low;
      for (std::size_t d = 0; d < D; ++d)
      {
        at[d] += ((k >> d) & 1) ? half : 0u;
      }
      const Id corner =
        k == child ? parent.Corners[static_cast<std::size_t>(k)] : this->FindCorner(at, id);
      this->CellAt(first + child).Corners[static_cast<std::size_t>(k)] = corner;
      this->CornerAt(corner).Around[static_cast<std::size_t>(~k & (Children - 1))] = first + child;
    }
  }
  return first;
}

template <std::size_t D>
void SizeCells<D>::SortPlaces(Pulse& pulse)
{
  const std::size_t count = this->Places.size();
  std::vector<std::pair<std::uint64_t, Id>> order(count);
  ForEachAtOnce(pulse, count,
    [this, &order](std::size_t k) {
      order[k] = { this->MortonKey(this->Places[k].At), static_cast<Id>(k) };
    });
  std::sort(order.begin(), order.end());
  std::vector<LowPlace<D>> places;
  places.reserve(count);
  this->Keys.reserve(count);
  for (const auto& [key, number] : order)
  {
    const LowPlace<D>& place = this->Places[static_cast<std::size_t>(number)];
    if (places.empty() || place.At != places.back().At || place.Value < places.back().Value)
    {
      this->Keys.push_back(key);
      places.push_back(place);
    }
  }
  this->Places.swap(places);
}

template <std::size_t D>
std::uint64_t SizeCells<D>::MortonKey(const Point<D>& place) const
{
  constexpr auto last = static_cast<double>((1u << MaximumLevel) - 1);
  Units units;
  for (std::size_t d = 0; d < D; ++d)
  {
    const double unit = (place[d] - this->Low[d]) / this->UnitLength;
    units[d] = static_cast<std::uint32_t>(std::min(std::max(unit, 0.0), last));
  }
  std::uint64_t key = 0;
  for (int bit = MaximumLevel; bit-- > 0;)
  {
    for (std::size_t d = D; d-- > 0;)
    {
      key = 2 * key + ((units[d] >> bit) & 1);
    }
  }
  return key;
}

template <std::size_t D>
void SizeCells<D>::DealPlaces(const Cell& parent, Id first)
{
  const std::size_t shift = D * static_cast<std::size_t>(MaximumLevel - 1 - parent.Level);
  Id begin = parent.FirstPlace;
  for (int k = 0; k < Children; ++k)
  {
    Cell& child = this->CellAt(first + k);
    const auto isOfChild = [shift, k](std::uint64_t key)
    { return static_cast<int>((key >> shift) & (Children - 1)) == k; };
    child.FirstPlace = begin;
    child.LastPlace = static_cast<Id>(std::partition_point(this->Keys.begin() + begin,
                                        this->Keys.begin() + parent.LastPlace, isOfChild) -
      this->Keys.begin());
    begin = child.LastPlace;
    this->FindLowest(child);
  }
}

template <std::size_t D>
void SizeCells<D>::FindLowest(Cell& cell) const
{
  for (Id place = cell.FirstPlace; place < cell.LastPlace; ++place)
  {
    const bool isLower = cell.Lowest == NoId ||
      this->Places[static_cast<std::size_t>(place)].Value <
        this->Places[static_cast<std::size_t>(cell.Lowest)].Value;
    cell.Lowest = isLower ? place : cell.Lowest;
  }
}

/// A new one is remembered with the cell that it is made for.
template <std::size_t D>
Id SizeCells<D>::FindCorner(const Units& at, Id cell)
{
  const Id id = this->Table.Find(at);
  if (static_cast<std::size_t>(id) == this->Corners.size())
  {
    this->Corners.emplace_back().At = at;
    this->MadeFor.push_back(cell);
  }
  return id;
}

template <std::size_t D>
Id SizeCells<D>::LeafAt(Id id, int orthant)
{
  Corner& corner = this->CornerAt(id);
  Units inside = corner.At;
  for (std::size_t d = 0; d < D; ++d)
  {
    const bool isUp = (orthant >> d) & 1;
    if (corner.At[d] == (isUp ? 1u << MaximumLevel : 0u))
    {
      return NoId;
    }
    inside[d] -= isUp ? 0u : 1u;
  }
  Id& leaf = corner.Around[static_cast<std::size_t>(orthant)];
  while (this->CellAt(leaf).FirstChild > 0)
  {
    const int bit = MaximumLevel - 1 - this->CellAt(leaf).Level;
    Id child = 0;
    for (std::size_t d = 0; d < D; ++d)
    {
      child += static_cast<Id>((inside[d] >> bit) & 1) << d;
    }
    leaf = this->CellAt(leaf).FirstChild + child;
  }
  return leaf;
}

template class SizeCells<2>;
template class SizeCells<3>;

} // namespace biting
