// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingCutTree_h
#define BitingCutTree_h

#include "../Base/Ids.h"
#include "../Base/Point.h"
#include "CutFrame.h"

#include <vector> // for the nodes

namespace biting
{

/// A kd-tree over the plane, in a frame; node 0 is the root. Without nodes: nothing is cut.
struct CutTree
{
  struct Node
  {
    bool IsVertical = true; ///< the line that divides it
    double At = 0.0;
    Id Children = NoId;    ///< the lower one, the other follows; NoId: a leaf
    Id Leaf = NoId;        ///< number of the leaf
    double Vertices = 0.0; ///< of the mesh, expected
  };

  CutFrame Frame;
  std::vector<Node> Nodes;
  Id NumberOfLeaves = 0;

  /// The node that is the leaf at p.
  Id NodeAt(const Point2& p) const
  {
    const Point2 place = this->Frame.To(p);
    Id node = 0;
    while (this->Nodes[node].Children != NoId)
    {
      const double x = this->Nodes[node].IsVertical ? place.X : place.Y;
      node = this->Nodes[node].Children + (x < this->Nodes[node].At ? 0 : 1);
    }
    return node;
  }
};

/// Deals the leaves to `parts`: returns the part of each leaf, by its number. The leaves of a part
/// follow each other in the tree, so that they lie together, and have about as many expected
/// vertices as those of others; with more parts than leaves some have none. Depends on the tree.
std::vector<Id> DealLeaves(const CutTree& tree, Id parts);

} // namespace biting

#endif
