// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingBallTree_h
#define BitingBallTree_h

#include "../../Base/Box.h"
#include "../../Base/Ids.h"
#include "../../Base/Numbers.h"

#include <algorithm> // for max
#include <array>     // for distances
#include <cstddef>   // for indices
#include <cstdint>   // for counts
#include <vector>    // for the arrays

namespace biting
{

/// A bite, or a ball at the boundary. No later center lies in its guard.
struct GuardedBall
{
  Point3 Center;
  double Radius = 0.0; ///< of a ball; half of the diagonal of a cube
  double Guard = 0.0;  ///< radius of the guard; of a cube half of its side: less than the bite's
  Id Frame = NoId;     ///< of a cube: the number of its axes; NoId: a ball
};

/// Finds balls of any sizes at a place or near a ball: an octree whose leaves list the balls that
/// meet them. A leaf is no larger than LargestLeaf radii of any ball in it, so that bites put some
/// 30 balls into a leaf. Cost: a walk down the tree for a place; constant for the neighbors of a
/// ball.
class BallTree
{
public:
  explicit BallTree(const Box3& bounds)
    : Root{ 0, bounds.Center(),
      0.5 * std::max({ bounds.Size(0), bounds.Size(1), bounds.Size(2), 1e-300 }) }
  {
    this->Blocks.push_back({});
  }

  const GuardedBall& At(Id ball) const { return this->Items[static_cast<std::size_t>(ball)]; }
  Id Size() const { return static_cast<Id>(this->Items.size()); }

  void Add(const GuardedBall& ball)
  {
    const Id id = this->Size();
    this->Items.push_back(ball);
    this->LastVisits.push_back(id);
    this->VisitLeaves(
      ball, this->LargestFor(ball), [this, id](Id node) { this->Prepend(node, id); });
  }

  /// Calls visit(id, other) for all balls that meet `ball`, then adds `ball`.
  template <typename Visit>
  void Add(const GuardedBall& ball, const Visit& visit)
  {
    const Id id = this->Size();
    this->Items.push_back(ball);
    this->LastVisits.push_back(id);
    this->NumberFound = 0;
    this->VisitLeaves(ball, this->LargestFor(ball),
      [this, id](Id node)
      {
        this->Collect(node, id);
        this->Prepend(node, id);
      });
    this->VisitFound(ball, visit);
  }

  /// Calls visit(id, other) for all others that meet the ball.
  template <typename Visit>
  void VisitNear(Id ball, const Visit& visit)
  {
    const Id number = -2 - ball; // the number of no visit by Add
    this->LastVisits[static_cast<std::size_t>(ball)] = number;
    this->NumberFound = 0;
    const GuardedBall own = this->At(ball);
    this->VisitLeaves(own, Infinity, [this, number](Id node) { this->Collect(node, number); });
    this->VisitFound(own, visit);
  }

  /// Whether isGuarded(ball) holds for a ball of number >= `first` in the leaf of the place.
  template <typename IsGuarded>
  bool HasAt(const Point3& place, Id first, const IsGuarded& isGuarded) const
  {
    for (Id id = this->LeafAt(place); id != 0; id = this->BlockAt(id).Next)
    {
      const Block& block = this->BlockAt(id);
      for (std::size_t k = block.Count; k-- > 0;)
      {
        if (block.Balls[k] < first || isGuarded(this->At(block.Balls[k])))
        {
          return block.Balls[k] >= first; // the latest are first
        }
      }
    }
    return false;
  }

private:
  static constexpr double LargestLeaf = 2.8;

  /// Leaves are not cut below this share of half the side of the root.
  static constexpr double LeastShare = 1e-9;

  /// Of a walk: seven cubes wait on each of 31 levels, and eight on the last one.
  static constexpr std::size_t MostFront = 256;

  struct Cube
  {
    Id Node;
    Point3 Middle;
    double HalfSide;
  };

  /// A part of the list of a leaf: a line of a cache. The latest ball is the last one of the first
  /// block.
  struct Block
  {
    std::array<Id, 14> Balls;
    std::uint32_t Count;
    Id Next; ///< 0: none
  };

  double LargestFor(const GuardedBall& ball) const
  {
    return std::max(LargestLeaf * ball.Radius, LeastShare * this->Root.HalfSide);
  }

  const Block& BlockAt(Id block) const { return this->Blocks[static_cast<std::size_t>(block)]; }
  Id& NodeAt(Id node) { return this->Nodes[static_cast<std::size_t>(node)]; }

  /// The first block of the leaf of a place.
  Id LeafAt(const Point3& place) const
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
    return ~node;
  }

  /// Adds the balls of a leaf to Found that this visit has not met. Without branches, so that the
  /// processor waits for many balls at a time.
  void Collect(Id node, Id number)
  {
    for (Id id = ~this->NodeAt(node); id != 0; id = this->BlockAt(id).Next)
    {
      const Block& block = this->BlockAt(id);
      if (this->Found.size() < this->NumberFound + block.Balls.size())
      {
        this->Found.resize(2 * (this->NumberFound + block.Balls.size()));
      }
      Id* const found = this->Found.data();
      Id* const lastVisits = this->LastVisits.data();
      const std::size_t balls = block.Count;
      std::size_t count = this->NumberFound;
      for (std::size_t k = 0; k < balls; ++k)
      {
        const Id ball = block.Balls[k];
        found[count] = ball;
        count += lastVisits[ball] != number ? 1 : 0;
        lastVisits[ball] = number;
      }
      this->NumberFound = count;
    }
  }

  template <typename Visit>
  void VisitFound(const GuardedBall& ball, const Visit& visit)
  {
    std::size_t count = 0;
    for (std::size_t k = 0; k < this->NumberFound; ++k)
    {
      const Id id = this->Found[k];
      const GuardedBall& other = this->At(id);
      const Point3 way = other.Center - ball.Center;
      const double reach = ball.Radius + other.Radius;
      this->Found[count] = id;
      count += Dot(way, way) < reach * reach ? 1 : 0;
    }
    for (std::size_t k = 0; k < count; ++k)
    {
      visit(this->Found[k], this->At(this->Found[k]));
    }
  }

  /// An empty one.
  Id NewBlock(Id next)
  {
    Id block = this->FirstFree;
    if (block == 0)
    {
      block = static_cast<Id>(this->Blocks.size());
      this->Blocks.push_back({});
    }
    this->FirstFree = this->BlockAt(block).Next;
    this->Blocks[static_cast<std::size_t>(block)].Count = 0;
    this->Blocks[static_cast<std::size_t>(block)].Next = next;
    return block;
  }

  /// Adds the ball to the list of a leaf.
  void Prepend(Id node, Id ball)
  {
    const Id head = ~this->NodeAt(node);
    if (head == 0 || this->BlockAt(head).Count == Block().Balls.size())
    {
      this->NodeAt(node) = ~this->NewBlock(head);
    }
    Block& block = this->Blocks[static_cast<std::size_t>(~this->NodeAt(node))];
    block.Balls[block.Count++] = ball;
  }

  /// Calls visit(node) for the leaves that the ball meets; those larger than `largest` are cut.
  template <typename Visit>
  void VisitLeaves(const GuardedBall& ball, double largest, const Visit& visit)
  {
    Cube* const front = this->Front.data();
    std::size_t size = 1;
    front[0] = this->Root;
    while (size > 0)
    {
      const Cube cube = front[--size];
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
          front[size++] = Child(cube, first, child);
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
    Id next = 0;
    for (Id id = ~this->NodeAt(cube.Node); id != 0; id = next)
    {
      Block& block = this->Blocks[static_cast<std::size_t>(id)];
      this->Moved.insert(this->Moved.end(), block.Balls.rend() - block.Count, block.Balls.rend());
      next = block.Next;
      block.Next = this->FirstFree;
      this->FirstFree = id;
    }
    const Id first = static_cast<Id>(this->Nodes.size());
    this->Nodes.resize(this->Nodes.size() + 8, ~0);
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
  std::vector<Id> LastVisits;  ///< of balls: the number of the last visit that came there
  std::vector<Id> Nodes{ ~0 }; ///< the first of eight children, or a leaf: ~ its first block
  std::vector<Block> Blocks;   ///< the first one stands for none
  Id FirstFree = 0;            ///< of the blocks that no leaf has
  std::array<Cube, MostFront> Front{}; ///< of the walk
  std::vector<Id> Moved;
  std::vector<Id> Found; ///< by a visit, then anything
  std::size_t NumberFound = 0;
};

} // namespace biting

#endif
