// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "ChainCorners.h"

#include "../Base/Numbers.h"

#include <algorithm> // for max, min, sort
#include <cmath>     // for acos, round, sqrt
#include <cstdint>   // for flags
#include <utility>   // for pair

namespace biting
{

namespace
{

constexpr double RadiusInTolerances = 4.0;
constexpr double LeastViewInRadii = 0.5;
constexpr int MostSteps = 256; // along a chain that does not leave a circle

class CornerFinder
{
public:
  CornerFinder(const Domain& domain, const DomainChains& chains, const CornerView& view)
    : Drawing(domain)
    , Chains(chains)
    , View(view)
    , Beyond(chains.Vertices.size(), NoId)
  {
    this->JoinBoundaries();
  }

  std::vector<Id> Find(Pulse& pulse);

private:
  struct Corner
  {
    double Turning;
    Id Slot;
  };

  // On the way along chains.
  struct Step
  {
    Id Slot;
    bool IsForth;
  };

  void JoinBoundaries();
  Id Link(const Step& step) const
  {
    return (step.IsForth ? this->Chains.Nexts : this->Chains.Previous)[step.Slot];
  }
  bool IsLast(const Step& step) const
  {
    return this->Link(step) == NoId && this->Beyond[step.Slot] == NoId;
  }
  Step After(Step step) const;

  double RadiusAt(Id slot) const
  {
    return RadiusInTolerances * this->View.Tolerances[this->Chains.Vertices[slot]];
  }
  const Point2& At(Id slot) const { return this->Drawing.Vertices[this->Chains.Vertices[slot]]; }
  double TurningAt(Id slot) const;
  Point2 FindExit(Id slot, bool isForth) const;
  void Suppress(Id slot, const std::vector<Id>& links, std::vector<std::uint8_t>& isSeen) const;

  const Domain& Drawing;
  const DomainChains& Chains;
  const CornerView& View;
  std::vector<Id> Beyond; ///< of each slot: the other one where the boundary goes on
};

void CornerFinder::JoinBoundaries()
{
  std::vector<std::pair<Id, Id>> ends; // vertex and slot
  for (Id slot = 0; slot < this->Chains.NumberOfSlots(); ++slot)
  {
    const Id first = this->Chains.Firsts[this->Chains.Chains[slot]];
    if (this->Chains.IsOpenEnd(slot) && this->Drawing.IsBoundary[this->Chains.Segments[first]])
    {
      ends.emplace_back(this->Chains.Vertices[slot], slot);
    }
  }
  std::sort(ends.begin(), ends.end());
  for (std::size_t k = 0, next = 0; k < ends.size(); k = next)
  {
    const Id vertex = ends[k].first;
    for (next = k; next < ends.size() && ends[next].first == vertex;)
    {
      ++next;
    }
    if (next - k == 2 && !this->Drawing.HasPoint[vertex])
    {
      this->Beyond[ends[k].second] = ends[k + 1].second;
      this->Beyond[ends[k + 1].second] = ends[k].second;
    }
  }
}

CornerFinder::Step CornerFinder::After(Step step) const
{
  if (this->Link(step) == NoId)
  {
    step.Slot = this->Beyond[step.Slot];
    step.IsForth = this->Chains.Nexts[step.Slot] != NoId;
  }
  return { this->Link(step), step.IsForth };
}

// The sharpest first; each hides others near it.
std::vector<Id> CornerFinder::Find(Pulse& pulse)
{
  std::vector<Corner> corners;
  pulse.ForEach(this->Chains.Vertices.size(),
    [this, &corners](std::size_t place)
    {
      const Id slot = static_cast<Id>(place);
      if (!this->Chains.Goes[place] && !this->Chains.IsOpenEnd(slot))
      {
        const double turning = std::round(this->TurningAt(slot) / AngleStep) * AngleStep;
        if (turning >= this->View.Angle - AngleStep)
        {
          corners.push_back({ turning, slot });
        }
      }
    });
  std::sort(corners.begin(), corners.end(),
    [this](const Corner& a, const Corner& b) {
      return a.Turning != b.Turning ? a.Turning > b.Turning : this->View.IsFirst(a.Slot, b.Slot);
    });
  std::vector<std::uint8_t> isHidden(this->Chains.Vertices.size(), 0);
  std::vector<Id> found;
  for (const Corner& corner : corners)
  {
    if (!isHidden[corner.Slot])
    {
      found.push_back(corner.Slot);
      this->Suppress(corner.Slot, this->Chains.Nexts, isHidden);
      this->Suppress(corner.Slot, this->Chains.Previous, isHidden);
    }
  }
  return found;
}

double CornerFinder::TurningAt(Id slot) const
{
  const Point2 before = this->At(slot) - this->FindExit(slot, false);
  const Point2 after = this->FindExit(slot, true) - this->At(slot);
  const double least = LeastViewInRadii * this->RadiusAt(slot);
  if (!(Length(before) > least && Length(after) > least))
  {
    return 0.0; // a small loop, or near an end
  }
  const double cosine = Dot(before, after) / (Length(before) * Length(after));
  return DegreesPerRadian * std::acos(std::max(-1.0, std::min(1.0, cosine)));
}

// Where the chain leaves the circle around the slot first, forth or back; its end, where it ends
// before.
Point2 CornerFinder::FindExit(Id slot, bool isForth) const
{
  const Point2& center = this->At(slot);
  const double radius = this->RadiusAt(slot);
  Id inner = slot;
  Step outer = this->After({ slot, isForth });
  int steps = 0;
  while (!this->IsLast(outer) && outer.Slot != slot && ++steps < MostSteps &&
    !(Distance(center, this->At(outer.Slot)) > radius))
  {
    inner = outer.Slot;
    outer = this->After(outer);
  }
  const Point2 offset = this->At(inner) - center;
  const Point2 along = this->At(outer.Slot) - this->At(inner);
  const double a = Dot(along, along);
  const double b = Dot(offset, along);
  const double c = Dot(offset, offset) - radius * radius;
  const double share = (std::sqrt(std::max(0.0, b * b - a * c)) - b) / a;
  return this->At(inner) + std::max(0.0, std::min(1.0, share)) * along;
}

void CornerFinder::Suppress(
  Id slot, const std::vector<Id>& links, std::vector<std::uint8_t>& isHidden) const
{
  const Point2& center = this->At(slot);
  const double radius = this->RadiusAt(slot);
  int steps = 0;
  for (Id near = links[slot]; near != NoId && near != slot && ++steps < MostSteps &&
       !(Distance(center, this->At(near)) > radius);
       near = links[near])
  {
    isHidden[near] = 1;
  }
}

} // namespace

std::vector<Id> FindCorners(
  const Domain& domain, const DomainChains& chains, const CornerView& view, Pulse& pulse)
{
  return CornerFinder(domain, chains, view).Find(pulse);
}

} // namespace biting
