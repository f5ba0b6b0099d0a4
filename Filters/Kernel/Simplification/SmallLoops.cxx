// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SmallLoops.h"

#include "../Domain/AreaSum.h"
#include "../Predicates/Predicates.h"

#include <algorithm> // for all_of, max, min, sort
#include <cmath>     // for abs
#include <limits>    // for infinity
#include <set>       // for what lies within

namespace biting
{

namespace
{

double ExtentOf(const SmallLoop& loop)
{
  return std::max(loop.Bounds.Width(), loop.Bounds.Height());
}

// In an order that does not depend on numbers.
bool IsSmaller(const SmallLoop& a, const SmallLoop& b)
{
  return ExtentOf(a) != ExtentOf(b) ? ExtentOf(a) < ExtentOf(b)
    : a.Area != b.Area              ? a.Area < b.Area
                                    : a.Bounds.Low < b.Bounds.Low;
}

} // namespace

SmallLoopFinder::SmallLoopFinder(const Domain& domain, const DomainChains& chains, Pulse& pulse)
  : Drawing(domain)
  , Chains(chains)
  , Tree(domain.Vertices, pulse)
  , Loops(domain.Vertices.size(), NoId)
  , Goes(chains.IsClosed.size(), 0)
{
  for (Id slot = 0; slot < chains.NumberOfSlots(); ++slot)
  {
    const Id chain = chains.Chains[slot];
    this->Loops[chains.Vertices[slot]] = chains.IsClosed[chain] ? chain : NoId;
  }
}

std::vector<SmallLoop> SmallLoopFinder::Find(
  double size, const std::function<double(const Point2&)>& spacing, Pulse& pulse)
{
  std::vector<SmallLoop> loops;
  for (Id chain = 0; chain < this->Chains.NumberOfChains(); ++chain)
  {
    if (this->Chains.IsClosed[chain])
    {
      loops.push_back(this->Measure(chain));
    }
  }
  const bool areAll = loops.size() == this->Chains.IsClosed.size();
  std::sort(loops.begin(), loops.end(), IsSmaller);
  const std::size_t most = areAll && !loops.empty() ? loops.size() - 1 : loops.size();
  std::vector<SmallLoop> small;
  for (std::size_t k = 0; k < most && pulse.Beat(256); ++k)
  {
    const SmallLoop& loop = loops[k];
    if (ExtentOf(loop) < size * this->LeastSpacing(loop.Chain, spacing) && this->CanGo(loop))
    {
      this->Goes[loop.Chain] = 1;
      small.push_back(loop);
    }
  }
  return small;
}

SmallLoop SmallLoopFinder::Measure(Id chain) const
{
  const Id first = this->Chains.Firsts[chain];
  SmallLoop loop{ chain, {}, 0.0 };
  AreaSum sum(this->At(first));
  for (Id slot = first; slot < this->Chains.Firsts[chain + 1]; ++slot)
  {
    loop.Bounds.Add(this->At(slot));
    sum.Add(this->At(slot), this->At(this->Chains.Following(slot)));
  }
  loop.Area = std::abs(sum.Area());
  return loop;
}

double SmallLoopFinder::LeastSpacing(
  Id chain, const std::function<double(const Point2&)>& spacing) const
{
  double least = std::numeric_limits<double>::infinity();
  for (Id slot = this->Chains.Firsts[chain]; slot < this->Chains.Firsts[chain + 1]; ++slot)
  {
    least = std::min(least, spacing(this->At(slot)));
  }
  return least;
}

bool SmallLoopFinder::CanGo(const SmallLoop& loop)
{
  const bool mustBeEmpty = this->HasInsideWithin(loop.Chain);
  bool canGo = true;
  std::set<Id> seen{ loop.Chain };
  this->Tree.VisitIn(loop.Bounds,
    [this, &loop, &seen, &canGo, mustBeEmpty](Id vertex)
    {
      const Id other = this->Loops[vertex];
      const bool isNew = other == NoId || seen.insert(other).second;
      const bool matters = mustBeEmpty || other == NoId || !this->Goes[other];
      canGo = canGo && !(isNew && matters && this->IsWithin(vertex, loop.Chain));
    });
  return canGo;
}

// Whether the domain lies on the inner side of the loop.
bool SmallLoopFinder::HasInsideWithin(Id chain) const
{
  const Id first = this->Chains.Firsts[chain];
  const Id last = this->Chains.Firsts[chain + 1];
  Id lowest = first;
  for (Id slot = first; slot < last; ++slot)
  {
    lowest = this->At(slot) < this->At(lowest) ? slot : lowest;
  }
  const Id next = this->Chains.Following(lowest);
  const Id previous = lowest == first ? last - 1 : lowest - 1;
  const bool isLeft = Orient2D(this->At(previous), this->At(lowest), this->At(next)) > 0;
  const Id segment = this->Chains.Segments[lowest];
  const bool isAlong = this->Drawing.Starts[segment] == this->Chains.Vertices[lowest];
  return isLeft == isAlong ? this->Drawing.LeftInside[segment] != 0
                           : this->Drawing.RightInside[segment] != 0;
}

// By the parity of segments above the vertex, which lies on none.
bool SmallLoopFinder::IsWithin(Id vertex, Id chain) const
{
  const Point2& p = this->Drawing.Vertices[vertex];
  bool isWithin = false;
  for (Id slot = this->Chains.Firsts[chain]; slot < this->Chains.Firsts[chain + 1]; ++slot)
  {
    const Point2& a = this->At(slot);
    const Point2& b = this->At(this->Chains.Following(slot));
    const bool spans = (a.X <= p.X) != (b.X <= p.X);
    if (spans)
    {
      isWithin ^= Orient2D(a.X < b.X ? a : b, a.X < b.X ? b : a, p) < 0;
    }
  }
  return isWithin;
}

} // namespace biting
