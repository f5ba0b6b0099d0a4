// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingVertexGrid_h
#define BitingVertexGrid_h

#include "../Base/Ids.h"
#include "../Base/Point.h"

#include <cstddef> // for size_t
#include <cstdint> // for keys
#include <vector>  // for the table

namespace biting
{

/// Finds the vertex within a small distance of a place. Constant cost, unless vertices are crowded.
///
/// A hash table of the cells of a grid, with a chain of vertices at each entry. Cells are so much
/// larger than the distance that nearly always one of them is looked at.
class VertexGrid
{
public:
  /// The grid refers to `points`, which may grow. Differences along x and y count `stretch` times,
  /// which is at least 1.
  VertexGrid(const std::vector<Point2>& points, double reach, const Point2& stretch = { 1.0, 1.0 });

  /// Files the points that have been added since the last call.
  void Update();

  /// The filed vertex nearest to `place` within reach, the smallest number among equals; or NoId.
  Id Find(const Point2& place) const;

private:
  void Grow();
  void File(Id vertex);
  std::size_t EntryOf(double column, double row) const;

  const std::vector<Point2>& Points;
  double Reach;
  Point2 Stretch;
  double CellSize;
  std::vector<Id> Heads; ///< of the chain at each entry of the table; as many as a power of two
  std::vector<Id> Nexts; ///< of each vertex in its chain
};

} // namespace biting

#endif
