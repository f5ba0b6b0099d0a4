// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingVertexGrid_h
#define BitingVertexGrid_h

#include "../Base/Ids.h"
#include "../Base/Point2.h"

#include <cstdint>       // for cell keys
#include <unordered_map> // for the cells
#include <vector>        // for points

namespace biting
{

/// Finds the vertex within a small distance of a place. Constant cost.
class VertexGrid
{
public:
  /// The grid refers to `points`, which may grow.
  VertexGrid(const std::vector<Point2>& points, double reach);

  /// Files the points that have been added since the last call.
  void Update();

  /// The filed vertex nearest to `place` within reach, the smallest number among equals; or NoId.
  Id Find(const Point2& place) const;

private:
  const std::vector<Point2>& Points;
  double Reach;
  std::unordered_multimap<std::uint64_t, Id> Cells;
};

} // namespace biting

#endif
