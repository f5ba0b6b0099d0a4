// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingSmallLoops_h
#define BitingSmallLoops_h

#include "../Base/Box.h"
#include "../Base/Ids.h"
#include "../Base/Pulse.h"
#include "../Domain/Domain.h"
#include "DomainChains.h"
#include "VertexTree.h"

#include <functional> // for spacing
#include <vector>     // for the arrays

namespace biting
{

/// A closed chain without junctions that may be left out.
struct SmallLoop
{
  Id Chain = NoId;
  Box2 Bounds;
  double Area = 0.0; ///< that it encloses
};

/// Finds the closed chains whose larger extent along the axes is below `size` times the least f at
/// their vertices. A loop around an inside of the domain counts only if nothing else lies in it, a
/// loop around an outside only if all that lies in it goes, too. Where all chains are closed the
/// largest of them stays. By extent, the smallest first.
class SmallLoopFinder
{
public:
  /// `chains` of the domain, made without regard to tags.
  SmallLoopFinder(const Domain& domain, const DomainChains& chains, Pulse& pulse);

  std::vector<SmallLoop> Find(
    double size, const std::function<double(const Point2&)>& spacing, Pulse& pulse);

private:
  SmallLoop Measure(Id chain) const;
  double LeastSpacing(Id chain, const std::function<double(const Point2&)>& spacing) const;
  bool CanGo(const SmallLoop& loop);
  bool HasInsideWithin(Id chain) const;
  bool IsWithin(Id vertex, Id chain) const;
  const Point2& At(Id slot) const { return this->Drawing.Vertices[this->Chains.Vertices[slot]]; }

  const Domain& Drawing;
  const DomainChains& Chains;
  VertexTree Tree;
  std::vector<Id> Loops;          ///< closed chain at each vertex; NoId where there is none
  std::vector<std::uint8_t> Goes; ///< of each chain
};

} // namespace biting

#endif
