// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SegmentExtension.h"

#include "SourceSlopes.h"

#include <utility> // for swap, exchange

namespace biting
{
namespace
{

SegmentCone MakeCone(Point2 start, Point2 end, double startValue, double endValue, double gradation)
{
  if (endValue < startValue)
  {
    std::swap(start, end);
    std::swap(startValue, endValue);
  }
  SegmentCone cone;
  cone.Start = start;
  cone.Value = startValue;
  const double length = Distance(start, end);
  const double steepness = (endValue - startValue) / (gradation * length);
  if (steepness < 1.0)
  {
    cone.Direction = { (end.X - start.X) / length, (end.Y - start.Y) / length };
    cone.Length = length;
    cone.Slope = steepness * gradation;
    cone.Lean = steepness / std::sqrt((1.0 - steepness) * (1.0 + steepness));
  }
  return cone;
}

double UsedGradation(const SegmentSource& source, double gradation)
{
  const double slope = gradation > 0.0 ? gradation : LargestSlope(source);
  return slope > 0.0 ? slope : SpacingOptions().Gradation;
}

std::vector<SegmentCone> MakeCones(const SegmentSource& source, double gradation, Pulse& pulse)
{
  std::vector<SegmentCone> cones;
  cones.reserve(source.Segments.size() / 2);
  for (std::size_t first = 0; first + 1 < source.Segments.size() && pulse.Beat(); first += 2)
  {
    const auto a = static_cast<std::size_t>(source.Segments[first]);
    const auto b = static_cast<std::size_t>(source.Segments[first + 1]);
    cones.push_back(
      MakeCone(source.Points[a], source.Points[b], source.Values[a], source.Values[b], gradation));
  }
  return cones;
}

BoxTree MakeTree(const std::vector<SegmentCone>& cones, Pulse& pulse)
{
  std::vector<BoxTree::Item> items(cones.size());
  for (std::size_t cone = 0; cone < cones.size(); ++cone)
  {
    items[cone].Box.Add(cones[cone].Start);
    items[cone].Box.Add(cones[cone].Start + cones[cone].Length * cones[cone].Direction);
    items[cone].Value = cones[cone].Value;
  }
  return BoxTree(items, pulse);
}

/// Puts cone order[i] at i, in place: there may be millions of them.
void Reorder(std::vector<Id> order, std::vector<SegmentCone>& cones)
{
  for (std::size_t first = 0; first < order.size(); ++first)
  {
    const SegmentCone moved = cones[first];
    std::size_t place = first;
    while (order[place] != NoId)
    {
      const auto from = static_cast<std::size_t>(std::exchange(order[place], NoId));
      cones[place] = from == first ? moved : cones[from];
      place = from;
    }
  }
}

} // namespace

SegmentExtension::SegmentExtension(const SegmentSource& source, double gradation, Monitor& monitor)
  : Slope(UsedGradation(source, gradation))
{
  Pulse pulse(monitor);
  this->Cones = MakeCones(source, this->Slope, pulse);
  this->File(pulse);
  std::vector<Id> lowest;
  for (Id cone = 0; cone < static_cast<Id>(this->Cones.size()) && pulse.Beat(64); ++cone)
  {
    if (!this->IsBounded(cone))
    {
      lowest.push_back(cone);
    }
  }
  if (lowest.size() < this->Cones.size())
  {
    this->KeepOnly(lowest);
    this->File(pulse);
  }
}

void SegmentExtension::File(Pulse& pulse)
{
  this->Tree = MakeTree(this->Cones, pulse);
  if (pulse.HasStopped())
  {
    this->Cones.clear();
    return;
  }
  Reorder(this->Tree.Order(), this->Cones);
}

void SegmentExtension::KeepOnly(const std::vector<Id>& ascending)
{
  std::size_t count = 0;
  for (const Id cone : ascending)
  {
    this->Cones[count++] = this->Cones[static_cast<std::size_t>(cone)];
  }
  this->Cones.resize(count);
}

/// A cone is convex, and linear along its own segment: another one that is lower at both ends of that
/// is lower along it, and so everywhere. Of equal cones the first one counts.
bool SegmentExtension::IsBounded(Id coneId) const
{
  const SegmentCone& cone = this->Cones[static_cast<std::size_t>(coneId)];
  const Point2 end = cone.Start + cone.Length * cone.Direction;
  const double endValue = cone.Value + cone.Slope * cone.Length;
  const auto isLower = [this, coneId](Id other, const Point2& x, double value)
  {
    const double otherValue = this->ConeAt(other, x);
    return otherValue < value || (otherValue == value && other < coneId);
  };
  const auto isBoundedBy = [&](Id other)
  {
    return other != coneId && isLower(other, cone.Start, cone.Value) &&
      (cone.Length == 0.0 || isLower(other, end, endValue));
  };
  bool isBounded = false;
  const double limit = std::nextafter(cone.Value, std::numeric_limits<double>::infinity());
  this->Tree.Search(this->Tree.Whole(), cone.Start, this->Slope, limit,
    [&isBounded, &isBoundedBy, limit](Id other, double)
    {
      isBounded = isBounded || isBoundedBy(other);
      return isBounded ? -std::numeric_limits<double>::infinity() : limit;
    });
  return isBounded;
}

LowestCone SegmentExtension::Evaluate(
  const Part& part, const Point2& x, const LowestCone& known, double slack) const
{
  LowestCone lowest = known;
  const double share = 1.0 - slack;
  this->Tree.Search(part, x, this->Slope, share * known.Value,
    [this, &x, &lowest, share](Id cone, double)
    {
      const double value = this->ConeAt(cone, x);
      if (value < lowest.Value)
      {
        lowest = { value, cone };
      }
      return share * lowest.Value;
    });
  return lowest;
}

void SegmentExtension::FindBelow(
  const Part& part, const Point2& x, double limit, std::size_t most, std::vector<Id>& found) const
{
  found.clear();
  this->Tree.Search(part, x, this->Slope, limit,
    [this, &x, limit, most, &found](Id cone, double)
    {
      if (found.size() < most && this->ConeAt(cone, x) <= limit)
      {
        found.push_back(cone);
      }
      return found.size() < most ? limit : 0.0;
    });
}

} // namespace biting
