// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingVertexTree_h
#define BitingVertexTree_h

#include "../Base/BoxTree.h"
#include "../Predicates/Predicates.h"

#include <array>   // for corners
#include <cstdint> // for flags

namespace biting
{

/// Vertices of the plane that go one by one: which of those that are left lies in a triangle, or in
/// a box? A question costs the boxes that the triangle's box meets, and the vertices in it, gone
/// ones too.
class VertexTree
{
public:
  /// Where the monitor wants to stop it is unfinished, not to be asked.
  VertexTree(const std::vector<Point2>& points, Pulse& pulse)
    : Tree(ItemsOf(points), pulse)
    , IsLeft(points.size(), 1)
  {
  }

  void Remove(Id vertex) { this->IsLeft[vertex] = 0; }

  /// One of the vertices that are left in the closed triangle, decided exactly, none of `passed`;
  /// NoId where there is none. Precondition: corners are counterclockwise.
  Id FindIn(const std::array<Point2, 3>& corners, const std::array<Id, 3>& passed) const
  {
    Box2 box = Box2::Around(corners[0], corners[1]);
    box.Add(corners[2]);
    Id found = NoId;
    this->Tree.AllOf(box,
      [this, &corners, &passed, &found](const Item& item)
      {
        const bool isPassed = !this->IsLeft[item.Vertex] ||
          std::find(passed.begin(), passed.end(), item.Vertex) != passed.end();
        found = !isPassed && IsIn(corners, item.Place) ? item.Vertex : NoId;
        return found == NoId;
      });
    return found;
  }

  /// Calls visit(vertex) for each vertex that is left in the closed box.
  template <typename Visitor>
  void VisitIn(const Box2& box, const Visitor& visit) const
  {
    this->Tree.AllOf(box,
      [this, &visit](const Item& item)
      {
        if (this->IsLeft[item.Vertex])
        {
          visit(item.Vertex);
        }
        return true;
      });
  }

private:
  struct Item
  {
    Point2 Place;
    Id Vertex = NoId;

    // For a BoxTree.
    Box2 Box() const { return { this->Place, this->Place }; }
    double Least() const { return 0.0; }
  };

  static std::vector<Item> ItemsOf(const std::vector<Point2>& points)
  {
    std::vector<Item> items;
    items.reserve(points.size());
    for (const Point2& point : points)
    {
      items.push_back({ point, static_cast<Id>(items.size()) });
    }
    return items;
  }

  static bool IsIn(const std::array<Point2, 3>& corners, const Point2& p)
  {
    return Orient2D(corners[0], corners[1], p) >= 0 && Orient2D(corners[1], corners[2], p) >= 0 &&
      Orient2D(corners[2], corners[0], p) >= 0;
  }

  BoxTree<Item> Tree;
  std::vector<std::uint8_t> IsLeft; ///< of each vertex
};

} // namespace biting

#endif
