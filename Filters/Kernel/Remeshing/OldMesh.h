// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingOldMesh_h
#define BitingOldMesh_h

#include "../Base/Ids.h"
#include "../Base/Monitor.h"
#include "../Base/Point.h"
#include "../Base/Problem.h"

#include <cstdint>    // for flags
#include <functional> // for the comparison of tags
#include <vector>     // for the arrays

namespace biting
{

/// A triangle mesh as it comes from outside, in its plane.
struct RemeshInput
{
  std::vector<Point2> Points;
  std::vector<Id> Corners; ///< three a triangle, of any orientation
  std::vector<Id> Regions; ///< one a triangle: where they differ is an interface; empty: all alike
  std::vector<Id> LineStarts; ///< of edges that stay edges, with their tags
  std::vector<Id> LineEnds;
  std::vector<Id> LineCells;              ///< the cell of each line, for the output
  std::function<bool(Id, Id)> AreAlike;   ///< whether two such cells may become one; empty: all may
  std::vector<std::uint8_t> IsFixed;      ///< one a vertex: it stays; empty: none
  std::vector<std::uint8_t> IsFrozen;     ///< one a triangle: it stays; empty: none
  std::vector<std::uint8_t> IsFrozenLine; ///< one a line: its edge stays; empty: none

  // For messages: what the vertices and triangles are in the input. Empty: the same.
  std::vector<std::int64_t> PointIds;
  std::vector<std::int64_t> CellIds;

  /// Vertices that are no further apart, or off a line, are meant to be one, or on it.
  double Rounding = 0.0;
};

/// Positive where the three corners are counterclockwise.
inline double AreaOfTriangle(const std::vector<Point2>& points, const Id* corners)
{
  const Point2& a = points[corners[0]];
  return 0.5 * Cross(points[corners[1]] - a, points[corners[2]] - a);
}

/// A valid triangle mesh with adjacency, and what of it must stay. Corners and Neighbors as in
/// Triangulation, three slots a triangle.
struct OldMesh
{
  static constexpr Id Untagged = 0;

  std::vector<Point2> Points; ///< all of the input; some may be in no triangle
  std::vector<Id> Corners;
  std::vector<Id> Neighbors;
  std::vector<Id> Marks; ///< of each slot: NoId, Untagged, or 1 + the line that covers the edge
  std::vector<Id> Regions;
  std::vector<std::uint8_t> IsFixed;
  std::vector<std::uint8_t> IsFrozen;
  std::vector<Id> Origins;              ///< of each triangle: the one of the input; empty: the same
  std::vector<std::uint8_t> IsRepaired; ///< one a triangle: it has other corners now; empty: none
  std::vector<Id> RepairedVertices;     ///< where flat triangles went with nothing in their place
  bool IsWelded = false;                ///< whether vertices of free edges were made one
  std::vector<Id> LineCells;
  std::vector<std::uint8_t> IsFrozenLine; ///< one a line, or none
  std::function<bool(Id, Id)> AreAlike;
  double Rounding = 0.0;
  double Area = 0.0;

  Id NumberOfVertices() const { return static_cast<Id>(this->Points.size()); }
  Id NumberOfTriangles() const { return static_cast<Id>(this->Corners.size() / 3); }
  Id Start(Id slot) const { return this->Corners[slot % 3 == 2 ? slot - 2 : slot + 1]; }
  Id End(Id slot) const { return this->Corners[slot % 3 == 0 ? slot + 2 : slot - 1]; }

  /// Those of edges of one triangle.
  std::vector<Id> FreeSlots() const
  {
    std::vector<Id> slots;
    for (Id slot = 0; slot < static_cast<Id>(this->Corners.size()); ++slot)
    {
      if (this->Neighbors[slot] == NoId)
      {
        slots.push_back(slot);
      }
    }
    return slots;
  }

  /// Their ends, some of them twice.
  std::vector<Id> VerticesOfFreeEdges() const
  {
    std::vector<Id> vertices;
    for (const Id slot : this->FreeSlots())
    {
      vertices.push_back(this->Start(slot));
      vertices.push_back(this->End(slot));
    }
    return vertices;
  }

  /// Whether an edge with this mark must stay one.
  bool IsFrozenEdge(Id mark) const
  {
    return mark > Untagged && !this->IsFrozenLine.empty() && this->IsFrozenLine[mark - 1] != 0;
  }

  /// Whether edges with these marks may become one.
  bool HaveEqualTags(Id mark, Id other) const
  {
    if (mark <= Untagged || other <= Untagged)
    {
      return (mark > Untagged) == (other > Untagged);
    }
    const Id cell = this->LineCells[mark - 1];
    const Id otherCell = this->LineCells[other - 1];
    return cell == otherCell || !this->AreAlike || this->AreAlike(cell, otherCell);
  }

  /// The same edge in the triangle across it, which there is.
  Id Across(Id slot) const
  {
    const Id end = this->End(slot);
    Id across = 3 * this->Neighbors[slot];
    while (this->Start(across) != end)
    {
      ++across;
    }
    return across;
  }
};

/// Reads `input`:
/// - Vertices of free edges that are not further apart than `nearest` are made one, with their
///   lines (ProblemCode::DuplicatePoints where they are at the same place, else NearPoints). The
///   lower number stays, and is fixed where one of them was. Its place is that of one that is
///   fixed, a corner of a frozen triangle, or an end of a frozen line, if there is such.
/// - Where vertices hang on a free edge, to rounding, its triangle is divided
///   (ProblemCode::Touches, HangingVertices.h).
/// - Flat triangles are mended (ProblemCode::FlatTriangles, FlatTriangles.h): those that are
///   divided are frozen no more.
/// - Triangles are turned counterclockwise.
/// - Edges of one triangle, or between regions, or on lines are marked. A line along a side that
///   was divided stays on what is there instead. A line that is no edge is dropped
///   (ProblemCode::OutsideInterfaces).
///
/// Refused with ProblemCode::OutOfRange are coordinates that the predicates cannot handle (ids:
/// point), and with ProblemCode::BadTriangles (ids: cell) is what is no mesh: no triangle with an
/// area, an edge of more than two triangles, two triangles on the same side of an edge, and
/// triangles that overlap: the free edges, as a drawing, bound less than the triangles have
/// together. The areas may differ by 1e-13 of themselves and, where free edges meet or nearly meet
/// other than in common ends, by strips of 8 roundings along all of them. Cost O(n) in the
/// triangles and O(m log m) in the free edges.
OldMesh ReadOldMesh(
  const RemeshInput& input, double nearest, ProblemList& problems, Monitor& monitor);

} // namespace biting

#endif
