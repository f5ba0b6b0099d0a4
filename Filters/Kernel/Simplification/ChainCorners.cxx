// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "ChainCorners.h"

#include "../Base/Numbers.h"

#include <algorithm> // for max, min, sort
#include <cmath>     // for acos, round, sqrt
#include <cstdint>   // for flags

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
  {
  }

  std::vector<Id> Find(Pulse& pulse);

private:
  struct Corner
  {
    double Turning;
    Id Slot;
  };

  double RadiusAt(Id slot) const
  {
    return RadiusInTolerances * this->View.Tolerances[this->Chains.Vertices[slot]];
  }
  const Point2& At(Id slot) const { return this->Drawing.Vertices[this->Chains.Vertices[slot]]; }
  double TurningAt(Id slot) const;
  Point2 FindExit(Id slot, const std::vector<Id>& links) const;
  void Suppress(Id slot, const std::vector<Id>& links, std::vector<std::uint8_t>& isSeen) const;

  const Domain& Drawing;
  const DomainChains& Chains;
  const CornerView& View;
};

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
  const Point2 before = this->At(slot) - this->FindExit(slot, this->Chains.Previous);
  const Point2 after = this->FindExit(slot, this->Chains.Nexts) - this->At(slot);
  const double least = LeastViewInRadii * this->RadiusAt(slot);
  if (!(Length(before) > least && Length(after) > least))
  {
    return 0.0; // a small loop, or near an end
  }
  const double cosine = Dot(before, after) / (Length(before) * Length(after));
  return DegreesPerRadian * std::acos(std::max(-1.0, std::min(1.0, cosine)));
}

// Where the chain leaves the circle around the slot first, along the links; its end, where it ends
// before.
Point2 CornerFinder::FindExit(Id slot, const std::vector<Id>& links) const
{
  const Point2& center = this->At(slot);
  const double radius = this->RadiusAt(slot);
  Id inner = slot;
  Id outer = links[slot];
  int steps = 0;
  while (links[outer] != NoId && outer != slot && ++steps < MostSteps &&
    !(Distance(center, this->At(outer)) > radius))
  {
    inner = outer;
    outer = links[outer];
  }
  const Point2 offset = this->At(inner) - center;
  const Point2 along = this->At(outer) - this->At(inner);
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
