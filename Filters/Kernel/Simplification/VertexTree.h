// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingVertexTree_h
#define BitingVertexTree_h

#include "../Base/Box.h"
#include "../Base/Ids.h"
#include "../Base/Point.h"
#include "../Base/Pulse.h"

#include <array>   // for corners
#include <cstdint> // for flags
#include <vector>  // for the arrays

namespace biting
{

/// Vertices of the plane that go one by one: which of those that are left lies in a triangle?
/// A balanced tree of boxes, those without a vertex left passed over. Built in
/// O(n log n); a removal costs O(1) on average, a question the boxes along the triangle's border,
/// and the way to it from a vertex nearby: short for a small triangle.
class VertexTree
{
public:
  /// Refers to `points`. Where the monitor wants to stop it is unfinished, not to be asked.
  VertexTree(const std::vector<Point2>& points, Pulse& pulse);

  void Remove(Id vertex);

  /// One of the vertices that are left in the closed triangle, decided exactly, none of `passed`;
  /// NoId where there is none. Precondition: corners are counterclockwise. The search begins at the
  /// first of `passed`.
  Id FindIn(const std::array<Point2, 3>& corners, const std::array<Id, 3>& passed) const;

  /// Calls visit(vertex) for each vertex that is left in the closed box.
  template <typename Visitor>
  void VisitIn(const Box2& box, const Visitor& visit) const;

private:
  /// Nodes lie in preorder: the first child follows its parent, Next is the node after the subtree.
  struct Node
  {
    Box2 Box;
    Box2 Cell;    ///< all vertices strictly within it are the node's
    Id Count = 0; ///< of its vertices, or children, that are left
    Id Parent = NoId;
    Id Next = NoId;
    Id First = 0; ///< of its items
    Id Last = 0;  ///< one past
  };

  void Build(Id first, Id last, const Box2& cell, Id parent, Pulse& pulse);
  void BuildChildren(Id node, Pulse& pulse);
  Id FindNodeAround(const Box2& box, Id vertex) const;
  bool IsLeaf(Id node) const { return this->Nodes[node].Next == node + 1; }

  const std::vector<Point2>& Points;
  std::vector<Id> Items; ///< vertices
  std::vector<Node> Nodes;
  std::vector<Id> Leaves;           ///< of each vertex
  std::vector<std::uint8_t> IsLeft; ///< of each vertex
};

template <typename Visitor>
void VertexTree::VisitIn(const Box2& box, const Visitor& visit) const
{
  const Id end = static_cast<Id>(this->Nodes.size());
  for (Id node = 0; node < end;)
  {
    const Node& here = this->Nodes[node];
    if (here.Count == 0 || !here.Box.Meets(box))
    {
      node = here.Next;
      continue;
    }
    for (Id i = here.First; this->IsLeaf(node) && i < here.Last; ++i)
    {
      const Id vertex = this->Items[i];
      if (this->IsLeft[vertex] && box.Contains(this->Points[vertex]))
      {
        visit(vertex);
      }
    }
    ++node;
  }
}

} // namespace biting

#endif
