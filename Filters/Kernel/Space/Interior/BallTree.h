// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingBallTree_h
#define BitingBallTree_h

#include "../../Base/Box.h"
#include "../../Base/Ids.h"

#include <algorithm> // for max
#include <array>     // for distances
#include <cstddef>   // for indices
#include <vector>    // for the arrays

namespace biting
{

/// What a ball takes: no later center is within its guard, and its sphere has candidates.
struct GuardedBall
{
  Point3 Center;
  double Radius = 0.0;
  double Guard = 0.0; ///< no more than the radius
};

/// Balls of any sizes, to be found by what they meet: an octree whose leaves list the balls that
/// meet them. A leaf is no larger than LargestLeaf radii of any ball in it, so that a leaf has some
/// 30 balls that are spread as bites. Cost: a walk down the tree for a place; constant for the
/// neighbors of a ball.
class BallTree
{
public:
  explicit BallTree(const Box3& bounds)
    : Root{ 0, bounds.Center(),
      0.5 * std::max({ bounds.Size(0), bounds.Size(1), bounds.Size(2), 1e-300 }) }
  {
  }

  const std::vector<GuardedBall>& Balls() const { return this->Items; }
  const GuardedBall& At(Id ball) const { return this->Items[static_cast<std::size_t>(ball)]; }
  Id Size() const { return static_cast<Id>(this->Items.size()); }

  /// Calls visit(other) for all that may meet it, some more than once, then adds it.
  template <typename Visit>
  void Add(const GuardedBall& ball, const Visit& visit)
  {
    const Id id = this->Size();
    this->Items.push_back(ball);
    const double largest = std::max(LargestLeaf * ball.Radius, LeastShare * this->Root.HalfSide);
    this->VisitLeaves(ball, largest,
      [this, id, &visit](Id node)
      {
        this->VisitLeaf(node, visit);
        this->Prepend(node, id);
      });
  }

  /// Calls visit(other) for all that may meet it, some more than once.
  template <typename Visit>
  void VisitNear(const GuardedBall& ball, const Visit& visit)
  {
    this->VisitLeaves(ball, 2.0 * this->Root.HalfSide * (1.0 + LeastShare),
      [this, &visit](Id node) { this->VisitLeaf(node, visit); });
  }

  /// Whether the guard of a ball with number `first` or later has the place.
  bool IsGuarded(const Point3& place, Id first) const
  {
    for (Id entry = this->HeadAt(place); entry != NoId; entry = this->Next(entry))
    {
      const Id id = this->Entries[static_cast<std::size_t>(entry)].Ball;
      if (id < first)
      {
        return false; // the latest are first in lists
      }
      const GuardedBall& ball = this->At(id);
      const Point3 apart = place - ball.Center;
      if (Dot(apart, apart) < ball.Guard * ball.Guard)
      {
        return true;
      }
    }
    return false;
  }

private:
  static constexpr double LargestLeaf = 1.4;

  /// Leaves are not cut below this share of the whole.
  static constexpr double LeastShare = 1e-9;

  struct Cube
  {
    Id Node;
    Point3 Middle;
    double HalfSide;
  };

  struct Entry
  {
    Id Ball;
    Id Next;
  };

  /// Leaves have the complement of 1 + their first entry.
  static Id LeafOf(Id entry) { return ~(entry + 1); }
  static Id HeadOf(Id leaf) { return ~leaf - 1; }
  Id Next(Id entry) const { return this->Entries[static_cast<std::size_t>(entry)].Next; }
  Id& NodeAt(Id node) { return this->Nodes[static_cast<std::size_t>(node)]; }

  Id HeadAt(const Point3& place) const
  {
    Id node = this->Nodes.front();
    Point3 middle = this->Root.Middle;
    double step = 0.5 * this->Root.HalfSide;
    while (node >= 0)
    {
      Id child = 0;
      for (std::size_t d = 0; d < 3; ++d)
      {
        const bool isHigh = place[d] >= middle[d];
        child += isHigh ? Id(1) << d : 0;
        middle[d] += isHigh ? step : -step;
      }
      step *= 0.5;
      node = this->Nodes[static_cast<std::size_t>(node + child)];
    }
    return HeadOf(node);
  }

  template <typename Visit>
  void VisitLeaf(Id node, const Visit& visit) const
  {
    for (Id entry = HeadOf(this->Nodes[static_cast<std::size_t>(node)]); entry != NoId;
         entry = this->Next(entry))
    {
      visit(this->Entries[static_cast<std::size_t>(entry)].Ball);
    }
  }

  void Prepend(Id node, Id ball)
  {
    this->Entries.push_back({ ball, HeadOf(this->NodeAt(node)) });
    this->NodeAt(node) = LeafOf(static_cast<Id>(this->Entries.size()) - 1);
  }

  /// Calls visit(node) for the leaves that the ball meets; those larger than `largest` are cut.
  template <typename Visit>
  void VisitLeaves(const GuardedBall& ball, double largest, const Visit& visit)
  {
    this->Front.assign(1, this->Root);
    while (!this->Front.empty())
    {
      const Cube cube = this->Front.back();
      this->Front.pop_back();
      if (this->NodeAt(cube.Node) < 0 && 2.0 * cube.HalfSide > largest)
      {
        this->Split(cube);
      }
      const Id first = this->NodeAt(cube.Node);
      if (first < 0)
      {
        visit(cube.Node);
        continue;
      }
      const std::array<bool, 8> isMet = ChildrenMet(cube, ball);
      for (Id child = 0; child < 8; ++child)
      {
        if (isMet[static_cast<std::size_t>(child)])
        {
          this->Front.push_back(Child(cube, first, child));
        }
      }
    }
  }

  static Cube Child(const Cube& cube, Id first, Id child)
  {
    const double step = 0.5 * cube.HalfSide;
    Point3 middle = cube.Middle;
    for (std::size_t d = 0; d < 3; ++d)
    {
      middle[d] += ((child >> d) & 1) != 0 ? step : -step;
    }
    return { first + child, middle, step };
  }

  static std::array<bool, 8> ChildrenMet(const Cube& cube, const GuardedBall& ball)
  {
    std::array<std::array<double, 2>, 3> apart2{}; // along axes, from the lower and upper halves
    for (std::size_t d = 0; d < 3; ++d)
    {
      const double offset = ball.Center[d] - cube.Middle[d];
      const double low = std::max({ offset, -cube.HalfSide - offset, 0.0 });
      const double high = std::max({ -offset, offset - cube.HalfSide, 0.0 });
      apart2[d] = { low * low, high * high };
    }
    std::array<bool, 8> isMet{};
    for (std::size_t child = 0; child < 8; ++child)
    {
      isMet[child] = apart2[0][child & 1] + apart2[1][(child >> 1) & 1] + apart2[2][child >> 2] <=
        ball.Radius * ball.Radius;
    }
    return isMet;
  }

  void Split(const Cube& cube)
  {
    this->Moved.clear();
    this->VisitLeaf(cube.Node, [this](Id ball) { this->Moved.push_back(ball); });
    const Id first = static_cast<Id>(this->Nodes.size());
    this->Nodes.resize(this->Nodes.size() + 8, LeafOf(NoId));
    this->NodeAt(cube.Node) = first;
    for (std::size_t k = this->Moved.size(); k-- > 0;)
    {
      const std::array<bool, 8> isMet = ChildrenMet(cube, this->At(this->Moved[k]));
      for (Id child = 0; child < 8; ++child)
      {
        if (isMet[static_cast<std::size_t>(child)])
        {
          this->Prepend(first + child, this->Moved[k]);
        }
      }
    }
  }

  Cube Root;
  std::vector<GuardedBall> Items;
  std::vector<Id> Nodes{ LeafOf(NoId) }; ///< the first of eight children, or a leaf
  std::vector<Entry> Entries;
  std::vector<Cube> Front; ///< of the walk
  std::vector<Id> Moved;
};

} // namespace biting

#endif
