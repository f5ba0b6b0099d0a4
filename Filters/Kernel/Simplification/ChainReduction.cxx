// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "ChainReduction.h"

#include "../Base/Numbers.h"
#include "../Predicates/Predicates.h"
#include "ChainCorners.h"

#include <algorithm> // for lower_bound, sort
#include <array>     // for triangles
#include <cmath>     // for atan2
#include <cstddef>   // for ptrdiff_t
#include <cstdint>   // for bits
#include <cstring>   // for memcpy

namespace biting
{

namespace
{

// Degrees: about the smallest angle of meshes without sharp corners.
constexpr double SharpAngle = 36.0;

// Degrees: no such angle is made outside of the domain either. Rounding keeps vertices on its sides
// from being told apart.
constexpr double NeedleAngle = 0.01;

// Where more segments than this end, some angles are sharp in any case: 360 / SharpAngle.
constexpr std::ptrdiff_t MostEnds = 10;

double AngleBetween(const Point2& a, const Point2& b)
{
  return DegreesPerRadian * std::atan2(std::abs(Cross(a, b)), Dot(a, b));
}

// Classes of errors are powers of the fourth root of 2, down to this share of the tolerance. Errors
// of drawings on a grid are simple fractions of it: the factor keeps them, however rounded, off the
// borders between classes.
constexpr float LeastError = 1.0f / (1 << 24);
constexpr float OffBorders = 1.0371f;
constexpr int BitsBelowClass = 21; // of a float: two bits of its fraction count

// What differs by less of its size is equal, so that drawings may be turned and moved.
constexpr double Rounding = 1.0 / (1 << 26);

std::uint32_t BitsOf(float value)
{
  std::uint32_t bits = 0;
  std::memcpy(&bits, &value, sizeof(bits));
  return bits;
}

// Of an error of at most 1.
std::size_t ClassOf(double error)
{
  const float measured = std::max(LeastError, OffBorders * static_cast<float>(error));
  return (BitsOf(measured) - BitsOf(LeastError)) >> BitsBelowClass;
}

double SquaredDistance(const Point2& p, const Point2& start, const Point2& end)
{
  const Point2 along = end - start;
  const Point2 offset = p - start;
  const double squaredLength = Dot(along, along);
  const double share = squaredLength > 0.0 ? Dot(offset, along) / squaredLength : 0.0;
  const Point2 rest = share <= 0.0 ? offset : share >= 1.0 ? p - end : offset - share * along;
  return Dot(rest, rest);
}

Point2 MeanOf(const std::vector<Point2>& points)
{
  // Of differences, so that drawings far from the origin keep their digits.
  Point2 sum;
  for (const Point2& p : points)
  {
    sum = sum + (p - points.front());
  }
  return points.front() + (1.0 / static_cast<double>(points.size())) * sum;
}

// So little that only what lies on its border but for rounding comes into it.
std::array<Point2, 3> Enlarged(const Point2& a, const Point2& b, const Point2& c)
{
  const Point2 center = a + (1.0 / 3.0) * ((b - a) + (c - a));
  return { a + Rounding * (a - center), b + Rounding * (b - center), c + Rounding * (c - center) };
}

} // namespace

CornerGuard::CornerGuard(const Domain& domain, const DomainChains& chains)
  : Drawing(domain)
  , Chains(chains)
{
  for (Id slot = 0; slot < chains.NumberOfSlots(); ++slot)
  {
    if (chains.IsOpenEnd(slot))
    {
      this->Ends.emplace_back(chains.Vertices[slot], slot);
    }
  }
  std::sort(this->Ends.begin(), this->Ends.end());
}

std::vector<Id> CornerGuard::FindOtherSides(Id slot) const
{
  std::vector<Id> found;
  const Id previous = this->Chains.Previous[slot];
  const Id next = this->Chains.Nexts[slot];
  this->FindOtherSidesAt(previous, slot, next, found);
  this->FindOtherSidesAt(next, slot, previous, found);
  return found;
}

void CornerGuard::FindOtherSidesAt(Id near, Id slot, Id far, std::vector<Id>& found) const
{
  const auto add = [this, near, slot, far, &found](Id other)
  {
    if (this->IsSharpened(near, slot, far, other))
    {
      found.push_back(this->Chains.Vertices[other]);
    }
  };
  if (!this->Chains.IsOpenEnd(near))
  {
    const Id previous = this->Chains.Previous[near];
    add(previous == slot ? this->Chains.Nexts[near] : previous);
    return;
  }
  const Id vertex = this->Chains.Vertices[near];
  const auto first =
    std::lower_bound(this->Ends.begin(), this->Ends.end(), std::make_pair(vertex, Id{ 0 }));
  const auto last = std::lower_bound(first, this->Ends.end(), std::make_pair(vertex + 1, Id{ 0 }));
  for (auto end = first; last - first <= MostEnds && end != last; ++end)
  {
    if (end->second != near)
    {
      const Id next = this->Chains.Nexts[end->second];
      add(next != NoId ? next : this->Chains.Previous[end->second]);
    }
  }
}

// Whether the angle at the place of `near` with the place of `other` would be.
bool CornerGuard::IsSharpened(Id near, Id slot, Id far, Id other) const
{
  const Point2 side = this->At(other) - this->At(near);
  const Point2 before = this->At(slot) - this->At(near);
  const Point2 after = this->At(far) - this->At(near);
  const double angle = AngleBetween(after, side);
  return angle < SharpAngle - AngleStep && angle < AngleBetween(before, side) - AngleStep &&
    (angle < NeedleAngle || this->IsInside(near, slot, Cross(after, side) > 0.0));
}

// Whether the domain is on that side of the chain, walking from `near` to its neighbour `slot`.
bool CornerGuard::IsInside(Id near, Id slot, bool isLeft) const
{
  const bool isForth = this->Chains.Nexts[near] == slot;
  const Id first = isForth ? near : slot;
  const Id segment = this->Chains.Segments[first];
  const bool isAlong = this->Drawing.Starts[segment] == this->Chains.Vertices[first];
  const bool isLeftOfSegment = isLeft == (isForth == isAlong);
  return (isLeftOfSegment ? this->Drawing.LeftInside : this->Drawing.RightInside)[segment] != 0;
}

ChainReduction::ChainReduction(
  const Domain& domain, const std::vector<double>& tolerances, DomainChains& chains, Pulse& pulse)
  : Drawing(domain)
  , Tolerances(tolerances)
  , Chains(chains)
  , Left(domain.Vertices, pulse)
  , Corners(domain, chains)
  , Middle(MeanOf(domain.Vertices))
  , Size(domain.Bounds.Diagonal())
  , IsKept(chains.Vertices.size(), 0)
  , Errors(chains.Vertices.size(), Infinity)
  , Versions(chains.Vertices.size(), 0)
  , Offsets(chains.Vertices.size(), 0.0f)
  , FirstWaiters(domain.Vertices.size(), NoId)
  , Queues(ClassOf(1.0) + 1, Queue(IsLater{ this }))
  , FirstQueue(Queues.size())
{
  for (Id slot = 0; slot < chains.NumberOfSlots(); ++slot)
  {
    this->Offsets[slot] = static_cast<float>(Distance(this->Middle, this->At(slot)) / this->Size);
    this->IsKept[slot] = chains.IsOpenEnd(slot);
    if (this->IsChord(slot))
    {
      this->Chords.insert(this->ChordOf(slot));
    }
  }
}

bool ChainReduction::IsFirst(Id slot, Id other) const
{
  const float offset = this->Offsets[slot];
  const float otherOffset = this->Offsets[other];
  return offset != otherOffset ? offset < otherOffset : this->At(slot) < this->At(other);
}

void ChainReduction::ReduceTo(double share, Pulse& pulse)
{
  this->Limit = share;
  for (Id slot = 0; slot < this->Chains.NumberOfSlots() && pulse.Beat(); ++slot)
  {
    this->Measure(slot);
  }
  for (Candidate next = this->TakeFirst(); next.Slot != NoId && pulse.Beat(64);
       next = this->TakeFirst())
  {
    pulse.SetFraction(static_cast<double>(this->Removed) / this->Chains.NumberOfSlots());
    if (next.Version != this->Versions[next.Slot] || this->WouldCoincide(next.Slot))
    {
      continue;
    }
    const std::vector<Id> obstacles = this->FindObstacles(next.Slot);
    for (const Id obstacle : obstacles)
    {
      this->Wait(next.Slot, obstacle);
    }
    if (obstacles.empty())
    {
      this->Remove(next.Slot);
    }
  }
}

// Files the slot where it may go.
void ChainReduction::Measure(Id slot)
{
  if (this->IsKept[slot] || this->Chains.Goes[slot])
  {
    return;
  }
  ++this->Versions[slot];
  const double error = this->ErrorOf(slot);
  this->Errors[slot] = error;
  if (error <= this->Limit)
  {
    this->File(slot, error);
  }
}

// In tolerances; infinite where it is above the limit.
double ChainReduction::ErrorOf(Id slot) const
{
  const Id last = this->Chains.Nexts[slot];
  const Point2& start = this->At(this->Chains.Previous[slot]);
  const Point2& end = this->At(last);
  const double most = this->Limit * this->Limit;
  double squaredError = 0.0;
  for (Id between = this->Chains.Following(this->Chains.Previous[slot]); between != last;
       between = this->Chains.Following(between))
  {
    const double tolerance = this->Tolerances[this->Chains.Vertices[between]];
    squaredError = std::max(
      squaredError, SquaredDistance(this->At(between), start, end) / (tolerance * tolerance));
    if (!(squaredError <= most))
    {
      return Infinity;
    }
  }
  return std::sqrt(squaredError);
}

// Among errors of one class short segments come first, so that paths grow together by halves: each
// of their vertices is then measured a logarithmic number of times.
void ChainReduction::File(Id slot, double error)
{
  const double length =
    Distance(this->At(this->Chains.Previous[slot]), this->At(this->Chains.Nexts[slot]));
  const std::size_t errorClass = ClassOf(error);
  this->Queues[errorClass].push(
    { static_cast<float>(length / this->Size), this->Offsets[slot], slot, this->Versions[slot] });
  this->FirstQueue = std::min(this->FirstQueue, errorClass);
}

// NoId where there is none.
ChainReduction::Candidate ChainReduction::TakeFirst()
{
  while (this->FirstQueue < this->Queues.size() && this->Queues[this->FirstQueue].empty())
  {
    ++this->FirstQueue;
  }
  if (this->FirstQueue == this->Queues.size())
  {
    return { 0.0f, 0.0f, NoId, 0 };
  }
  const Candidate first = this->Queues[this->FirstQueue].top();
  this->Queues[this->FirstQueue].pop();
  return first;
}

// Whether what would be left is there already, or a loop would have less than three vertices.
bool ChainReduction::WouldCoincide(Id slot) const
{
  const Id previous = this->Chains.Previous[slot];
  const Id next = this->Chains.Nexts[slot];
  const Id chain = this->Chains.Chains[slot];
  if (this->Chains.IsClosed[chain])
  {
    return this->Chains.Left[chain] <= 3;
  }
  const bool isWhole = this->Chains.IsOpenEnd(previous) && this->Chains.IsOpenEnd(next);
  const Id first = this->Chains.Vertices[this->Chains.Firsts[chain]];
  const Id last = this->Chains.Vertices[this->Chains.Firsts[chain + 1] - 1];
  return (first == last && this->Chains.Left[chain] <= 4) ||
    (isWhole && this->Chords.count(std::minmax(first, last)) > 0);
}

// Vertices that are in the way: when one of them goes the slot may.
std::vector<Id> ChainReduction::FindObstacles(Id slot) const
{
  std::vector<Id> obstacles = this->Corners.FindOtherSides(slot);
  if (obstacles.empty())
  {
    const Id obstacle = this->FindObstacle(slot);
    obstacles.assign(obstacle == NoId ? 0 : 1, obstacle);
  }
  return obstacles;
}

// One within the triangles on both sides of what would be left, or NoId.
Id ChainReduction::FindObstacle(Id slot) const
{
  const Id previous = this->Chains.Previous[slot];
  const Id next = this->Chains.Nexts[slot];
  const int side = Orient2D(this->At(previous), this->At(slot), this->At(next));
  if (side == 0)
  {
    return NoId; // nothing is on the two segments
  }
  const Id first = side > 0 ? previous : next;
  const Id last = side > 0 ? next : previous;
  const Id obstacle = this->Left.FindIn({ this->At(first), this->At(slot), this->At(last) },
    { this->Chains.Vertices[first], this->Chains.Vertices[slot], this->Chains.Vertices[last] });
  return obstacle != NoId ? obstacle : this->FindObstacleBeyond(slot);
}

Id ChainReduction::FindObstacleBeyond(Id slot) const
{
  const Id previous = this->Chains.Previous[slot];
  const Id next = this->Chains.Nexts[slot];
  const Point2& start = this->At(previous);
  const Point2& end = this->At(next);
  const Point2 along = end - start;
  const Point2 offset = this->At(slot) - start;
  const double share = Dot(offset, along) / Dot(along, along);
  const Point2 foot = start + share * along;
  const Point2 across = foot - this->At(slot);
  if (!(Length(across) > Rounding * Length(along)))
  {
    return NoId; // the vertex is on the segment, but for rounding
  }
  const double height =
    this->Errors[slot] * this->Tolerances[this->Chains.Vertices[slot]] / Length(across);
  const Point2 beyond = foot + height * across;
  const int side = Orient2D(start, end, beyond);
  const int other = Orient2D(start, end, this->At(slot));
  if (side != -other) // rounded
  {
    return NoId;
  }
  return this->Left.FindIn(Enlarged(side > 0 ? start : end, side > 0 ? end : start, beyond),
    { this->Chains.Vertices[previous], this->Chains.Vertices[slot], this->Chains.Vertices[next] });
}

void ChainReduction::Wait(Id slot, Id obstacle)
{
  Id& first = this->FirstWaiters[obstacle];
  this->Waiters.push_back({ slot, this->Versions[slot], first });
  first = static_cast<Id>(this->Waiters.size()) - 1;
}

void ChainReduction::Remove(Id slot)
{
  const Id previous = this->Chains.Previous[slot];
  const Id next = this->Chains.Nexts[slot];
  const Id vertex = this->Chains.Vertices[slot];
  ++this->Versions[slot];
  this->Chains.Remove(slot);
  this->Left.Remove(vertex);
  ++this->Removed;
  if (this->IsChord(previous))
  {
    this->Chords.insert(this->ChordOf(previous));
  }
  this->Measure(previous);
  this->Measure(next);
  this->Wake(vertex);
}

// Those that were not measured since wait no longer.
void ChainReduction::Wake(Id vertex)
{
  for (Id waiter = this->FirstWaiters[vertex]; waiter != NoId; waiter = this->Waiters[waiter].Next)
  {
    const Waiting& waiting = this->Waiters[waiter];
    if (waiting.Version == this->Versions[waiting.Slot])
    {
      this->Measure(waiting.Slot);
    }
  }
}

// Whether the slot is the first of two that are all of an open chain.
bool ChainReduction::IsChord(Id slot) const
{
  const Id next = this->Chains.Nexts[slot];
  return this->Chains.Previous[slot] == NoId && this->Chains.Nexts[next] == NoId;
}

std::pair<Id, Id> ChainReduction::ChordOf(Id slot) const
{
  return std::minmax(
    { this->Chains.Vertices[slot], this->Chains.Vertices[this->Chains.Nexts[slot]] });
}

} // namespace biting
