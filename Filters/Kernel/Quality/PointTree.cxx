// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "PointTree.h"

#include "../Base/Box2.h"
#include "../Base/Tasks.h"

#include <algorithm> // for nth_element
#include <utility>   // for move, pair

namespace biting
{

namespace
{

// Ranges of at most this many items are searched one by one.
constexpr std::size_t LeafSize = 8;

// The monitor is asked before each division of more items than this.
constexpr std::size_t LeastLongStep = 4096;

// Many items are divided so many times, then what comes of that is built as tasks.
constexpr int LevelsOfTasks = 3;

double Coordinate(const Point2& p, bool isX)
{
  return isX ? p.X : p.Y;
}

std::size_t MiddleOf(std::size_t first, std::size_t last)
{
  return first + (last - first) / 2;
}

} // namespace

PointTree::PointTree(std::vector<Item> items, Pulse& pulse)
  : Items(std::move(items))
  , IsByX(this->Items.size(), 0)
{
  std::vector<std::pair<std::size_t, std::size_t>> parts{ { 0, this->Items.size() } };
  const int levels = this->Items.size() > StepsPerTask ? LevelsOfTasks : 0;
  for (int level = 0; level < levels; ++level)
  {
    const PulsePart dividing(pulse, 0.0, 0.0);
    DoTasks(pulse, parts.size(),
      [this, &parts](std::size_t k, Monitor&) { this->Divide(parts[k].first, parts[k].second); });
    std::vector<std::pair<std::size_t, std::size_t>> halves;
    for (const auto& [first, last] : parts)
    {
      halves.emplace_back(first, MiddleOf(first, last));
      halves.emplace_back(MiddleOf(first, last) + 1, last);
    }
    parts = std::move(halves);
  }
  DoTasks(pulse, parts.size(),
    [this, &parts](std::size_t k, Monitor& monitor)
    {
      Pulse own(monitor);
      this->Build(parts[k].first, parts[k].second, own);
    });
}

void PointTree::Build(std::size_t first, std::size_t last, Pulse& pulse)
{
  const std::size_t size = last - first;
  if (size > LeafSize && (size > LeastLongStep ? pulse.Ask() : pulse.Beat()))
  {
    this->Divide(first, last);
    this->Build(first, MiddleOf(first, last), pulse);
    this->Build(MiddleOf(first, last) + 1, last, pulse);
  }
}

void PointTree::Divide(std::size_t first, std::size_t last)
{
  const bool isByX = this->IsWide(first, last);
  const auto isBefore = [isByX](const Item& left, const Item& right)
  { return Coordinate(left.Place, isByX) < Coordinate(right.Place, isByX); };
  const auto at = [this](std::size_t i)
  { return this->Items.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(first), at(MiddleOf(first, last)), at(last), isBefore);
  this->IsByX[MiddleOf(first, last)] = isByX;
}

bool PointTree::IsWide(std::size_t first, std::size_t last) const
{
  Box2 box;
  for (std::size_t i = first; i < last; ++i)
  {
    box.Add(this->Items[i].Place);
  }
  return box.Width() >= box.Height();
}

double PointTree::NearestSquaredDistance(const Point2& place, Id name, double limit) const
{
  Query query{ place, name, limit };
  this->Search(0, this->Items.size(), query);
  return query.Best;
}

const PointTree::Item* PointTree::Nearest(const Point2& place, double limit) const
{
  Query query{ place, NoId, limit };
  this->Search(0, this->Items.size(), query);
  return query.Nearest;
}

void PointTree::Search(std::size_t first, std::size_t last, Query& query) const
{
  if (last - first <= LeafSize)
  {
    for (std::size_t i = first; i < last; ++i)
    {
      this->Consider(this->Items[i], query);
    }
    return;
  }
  const std::size_t middle = MiddleOf(first, last);
  const bool isByX = this->IsByX[middle] != 0;
  const double ahead =
    Coordinate(query.Place, isByX) - Coordinate(this->Items[middle].Place, isByX);
  const bool isLow = ahead < 0.0;
  this->Search(isLow ? first : middle + 1, isLow ? middle : last, query);
  if (ahead * ahead < query.Best)
  {
    this->Consider(this->Items[middle], query);
    this->Search(isLow ? middle + 1 : first, isLow ? last : middle, query);
  }
}

void PointTree::Consider(const Item& item, Query& query) const
{
  const Point2 offset = item.Place - query.Place;
  const double squaredDistance = Dot(offset, offset);
  if (squaredDistance < query.Best && item.Name != query.Name)
  {
    query.Best = squaredDistance;
    query.Nearest = &item;
  }
}

} // namespace biting
