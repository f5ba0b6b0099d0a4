// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingRuleOracle_h
#define BitingRuleOracle_h

#include "Domain/Domain.h"

#include <algorithm> // for sort
#include <vector>    // for loops

/** What a domain is by each DomainRule, found by nothing but rays. */
namespace biting
{

using Loop = std::vector<Point2>;
using Loops = std::vector<Loop>;

/// The loops around a place, each by its parity along a ray upwards.
inline std::vector<Id> CoverOf(const Loops& loops, const Point2& place)
{
  std::vector<Id> cover;
  for (std::size_t k = 0; k < loops.size(); ++k)
  {
    bool isIn = false;
    for (std::size_t i = 0; i < loops[k].size(); ++i)
    {
      const Point2& a = loops[k][i];
      const Point2& b = loops[k][(i + 1) % loops[k].size()];
      const double y = a.Y + (place.X - a.X) / (b.X - a.X) * (b.Y - a.Y);
      isIn ^= (a.X < place.X) != (b.X < place.X) && y > place.Y;
    }
    if (isIn)
    {
      cover.push_back(static_cast<Id>(k));
    }
  }
  return cover;
}

/// The part of the domain at a place; NoId outside. `outer` is the largest loop.
inline Id PartAt(const Loops& loops, DomainRule rule, Id outer, const Point2& place)
{
  const std::vector<Id> cover = CoverOf(loops, place);
  switch (rule)
  {
    case DomainRule::Union:
      return cover.empty() ? NoId : cover.back();
    case DomainRule::OuterMinusOthers:
      return cover == std::vector<Id>{ outer } ? outer : NoId;
    default:
      return cover.size() % 2 != 0 ? 0 : NoId;
  }
}

/// The abscissae between which no edges begin, end or cross.
inline std::vector<double> Abscissae(const Loops& loops)
{
  std::vector<Point2> ends;
  for (const Loop& loop : loops)
  {
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      ends.push_back(loop[i]);
      ends.push_back(loop[(i + 1) % loop.size()]);
    }
  }
  std::vector<double> all;
  for (std::size_t i = 0; i < ends.size(); i += 2)
  {
    all.push_back(ends[i].X);
    for (std::size_t j = 0; j < i; j += 2)
    {
      const Point2 u = ends[i + 1] - ends[i];
      const Point2 v = ends[j + 1] - ends[j];
      const double t = Cross(ends[j] - ends[i], v) / Cross(u, v);
      if (t > 0.0 && t < 1.0)
      {
        all.push_back(ends[i].X + t * u.X);
      }
    }
  }
  std::sort(all.begin(), all.end());
  return all;
}

/// By slabs: in each the length of the domain along its middle times its width.
inline double AreaBy(const Loops& loops, DomainRule rule, Id outer)
{
  const std::vector<double> all = Abscissae(loops);
  double area = 0.0;
  for (std::size_t k = 0; k + 1 < all.size(); ++k)
  {
    const double x = 0.5 * (all[k] + all[k + 1]);
    std::vector<double> heights;
    for (const Loop& loop : loops)
    {
      for (std::size_t i = 0; i < loop.size(); ++i)
      {
        const Point2& a = loop[i];
        const Point2& b = loop[(i + 1) % loop.size()];
        if ((a.X < x) != (b.X < x))
        {
          heights.push_back(a.Y + (x - a.X) / (b.X - a.X) * (b.Y - a.Y));
        }
      }
    }
    std::sort(heights.begin(), heights.end());
    for (std::size_t i = 0; i + 1 < heights.size(); ++i)
    {
      const Point2 middle{ x, 0.5 * (heights[i] + heights[i + 1]) };
      area += PartAt(loops, rule, outer, middle) == NoId
        ? 0.0
        : (heights[i + 1] - heights[i]) * (all[k + 1] - all[k]);
    }
  }
  return area;
}

inline Id LargestOf(const Loops& loops)
{
  Id largest = 0;
  double most = 0.0;
  for (std::size_t k = 0; k < loops.size(); ++k)
  {
    const double area = AreaBy({ loops[k] }, DomainRule::EvenOdd, 0);
    largest = area > most ? static_cast<Id>(k) : largest;
    most = std::max(most, area);
  }
  return largest;
}

} // namespace biting

#endif
