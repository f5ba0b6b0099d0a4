// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingPointTree_h
#define BitingPointTree_h

#include "../Base/Ids.h"
#include "../Base/Point2.h"
#include "../Base/Pulse.h"

#include <cstddef> // for positions
#include <cstdint> // for axes
#include <vector>  // for the arrays

namespace biting
{

/// A balanced k-d tree over points of the plane, for the nearest one. Build O(n log n) with the
/// points of each half in place, on the threads of the pulse; queries O(log n) for any distribution
/// of the points.
class PointTree
{
public:
  struct Item
  {
    Point2 Place;
    Id Name;
  };

  /// On abort it is incomplete and must not be asked.
  PointTree(std::vector<Item> items, Pulse& pulse);

  /// The squared distance from `place` to the nearest item not called `name`, or `limit` where none
  /// is nearer than that.
  double NearestSquaredDistance(const Point2& place, Id name, double limit) const;

  /// One of the items nearest to `place`, or null where no squared distance is below `limit`.
  const Item* Nearest(const Point2& place, double limit) const;

private:
  struct Query
  {
    Point2 Place;
    Id Name;
    double Best;
    const Item* Nearest = nullptr;
  };

  void Build(std::size_t first, std::size_t last, Pulse& pulse);
  void Divide(std::size_t first, std::size_t last);
  bool IsWide(std::size_t first, std::size_t last) const;
  void Search(std::size_t first, std::size_t last, Query& query) const;
  void Consider(const Item& item, Query& query) const;

  std::vector<Item> Items;         ///< the middle one of a range divides it
  std::vector<std::uint8_t> IsByX; ///< for the middle of each range: divided by x, else by y
};

} // namespace biting

#endif
