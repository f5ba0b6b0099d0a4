// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "BoundaryProtection.h"

#include "../Base/PointOnSegment.h"
#include "BiteOutline.h" // for Depth
#include "EdgeDivision.h"
#include "Orientation.h"
#include "SharpCorners.h"

#include <algorithm> // for all_of, max, min
#include <cstddef>   // for sizes
#include <cstdint>   // for the limit
#include <iterator>  // for begin, end
#include <numeric>   // for iota

namespace biting
{

namespace
{

// For circles: one bite a vertex.
VertexAxes WithoutAxes(Id numberOfVertices)
{
  VertexAxes none;
  none.Axes.resize(numberOfVertices);
  none.Offsets.resize(static_cast<std::size_t>(numberOfVertices) + 1);
  std::iota(none.Offsets.begin(), none.Offsets.end(), 0);
  return none;
}

// How near centres on one edge may be, in half-widths.
double LeastPart(const BitingOptions& options)
{
  const bool isExact = options.Placement == Placement::Corners || options.Tolerance == 1.0;
  const double balanced = EdgeDivider::BalancedPart * options.PartLength / options.BitingConstant;
  return isExact ? EdgeDivider::LeastPart
                 : std::min(balanced, options.Tolerance * EdgeDivider::LeastPart);
}

void ProtectEdge(Id segment, const SharpCorners& corners, EdgeDivider& divider,
  DivisionPoints& division, BitingState& state)
{
  const Id start = state.Geometry.Starts[segment];
  const Id end = state.Geometry.Ends[segment];
  const Point2 a = state.Geometry.Vertices[start];
  const Point2 b = state.Geometry.Vertices[end];
  const auto limit = state.Options.MaximumNumberOfVertices - state.Result.Points.size();
  divider.TellEnds(a, state.Result.Spacings[start], b, state.Result.Spacings[end]);
  if (!divider.Divide(a, b, corners.ShellsOn(segment), static_cast<Id>(limit), division))
  {
    state.Result.End = state.ReasonNotToDivide();
    return;
  }
  const Point2 axis = 1.0 / Distance(a, b) * (b - a);
  Id last = start;
  for (std::size_t k = 0; k < division.Parameters.size() && state.MayBite(); ++k)
  {
    const double spacing = division.Spacings[k];
    const Point2 place = PointOnSegment(a, b, division.Parameters[k], spacing);
    const Id vertex = state.AddVertex(place, spacing, segment);
    state.Bite(vertex, axis, 1.0, BitePhase::EdgeProtection);
    state.AddEdge(last, vertex, segment);
    last = vertex;
    state.FinishBite();
  }
  state.AddEdge(last, end, segment);
}

// Of the parts of an edge that is not divided: their least length and the wanted one, in units of
// c_b f. Where long edges meet short ones, smaller shields leave thinner triangles on the edges,
// and larger ones thinner triangles beside these.
constexpr double LeastShieldLength = 1.7;
constexpr double ShieldLength = 2.6;
constexpr double ShieldOverlap = 1.0625;    // of neighbours: their common border lies inside both
constexpr std::int64_t FewShields = 200000; // for which no limit of vertices is meant

// Whether the rectangle about the line from `first` to `last`, reaching `across` to both sides,
// lies in one of the squares of an input vertex.
bool IsWithinBite(const Point2& first, const Point2& last, Id vertex, const Point2& across,
  const BitingState& state)
{
  const Point2 corners[4] = { first + across, first - across, last + across, last - across };
  for (Id bite = state.Axes.Offsets[vertex]; bite < state.Axes.Offsets[vertex + 1]; ++bite)
  {
    const auto isInside = [&state, bite](const Point2& p)
    { return Depth(state.Placed, bite, p) >= 0.0; };
    if (std::all_of(std::begin(corners), std::end(corners), isInside))
    {
      return true;
    }
  }
  return false;
}

// Whether the bites of the segment's ends cover the square about `center` that reaches `along` to
// the middle of a side: each half of it lies in one of them.
bool IsHeld(Id segment, const Point2& center, const Point2& along, const BitingState& state)
{
  const Point2 across = Perpendicular(along);
  const Id start = state.Geometry.Starts[segment];
  const Id end = state.Geometry.Ends[segment];
  const auto isHeld = [&center, &across, start, end, &state](const Point2& side)
  {
    return IsWithinBite(side, center, start, across, state) ||
      IsWithinBite(side, center, end, across, state);
  };
  return isHeld(center - along) && isHeld(center + along);
}

void ShieldPart(Id segment, double from, double to, BitingState& state)
{
  const Point2& a = state.Geometry.Vertices[state.Geometry.Starts[segment]];
  const Point2& b = state.Geometry.Vertices[state.Geometry.Ends[segment]];
  const double length = Distance(a, b);
  const double halfWidth = 0.5 * ShieldOverlap * (to - from) * length;
  const Point2 center = a + 0.5 * (from + to) * (b - a);
  const Point2 axis = 1.0 / length * (b - a);
  if (state.MayBite() && !IsHeld(segment, center, halfWidth * axis, state))
  {
    state.AddBite(center, axis, halfWidth, state.F(center), BitePhase::EdgeProtection);
    state.FinishBite();
  }
}

void ShieldEdge(Id segment, EdgeDivider& divider, DivisionPoints& division, BitingState& state)
{
  const Point2& a = state.Geometry.Vertices[state.Geometry.Starts[segment]];
  const Point2& b = state.Geometry.Vertices[state.Geometry.Ends[segment]];
  const std::int64_t limit =
    std::max(state.Options.MaximumNumberOfVertices, FewShields) - state.Placed.Size();
  divider.TellEnds(a, state.Result.Spacings[state.Geometry.Starts[segment]], b,
    state.Result.Spacings[state.Geometry.Ends[segment]]);
  if (!divider.Divide(a, b, static_cast<Id>(std::max<std::int64_t>(limit, 0)), division))
  {
    state.Result.End = state.ReasonNotToDivide();
    return;
  }
  // Where f is steep, rounding may exchange neighbours.
  division.Parameters.push_back(1.0);
  double last = 0.0;
  for (const double parameter : division.Parameters)
  {
    if (parameter > last)
    {
      ShieldPart(segment, last, parameter, state);
      last = parameter;
    }
  }
}

} // namespace

void AddDomainVertices(BitingState& state)
{
  state.Reserve();
  for (const Point2& vertex : state.Geometry.Vertices)
  {
    state.AddVertex(vertex, state.F(vertex), NoId);
    state.Step();
  }
}

void ProtectVertices(BitingState& state)
{
  state.Axes = state.Options.Shape == BiteShape::Circle
    ? WithoutAxes(state.Geometry.NumberOfVertices())
    : OrientVertexBites(state.Geometry, state.Progress);
  for (Id vertex = 0; vertex < state.Geometry.NumberOfVertices() && state.MayBite(); ++vertex)
  {
    for (Id k = state.Axes.Offsets[vertex]; k < state.Axes.Offsets[vertex + 1]; ++k)
    {
      state.Bite(vertex, state.Axes.Axes[k], 1.0, BitePhase::VertexProtection);
    }
    state.FinishBite();
  }
}

void ProtectEdges(BitingState& state)
{
  if (!state.DividesSegments())
  {
    return;
  }
  const SharpCorners corners(state.Geometry, state.Result.Spacings, state.F,
    state.Options.PartLength, static_cast<Id>(state.Options.MaximumNumberOfVertices),
    state.Progress);
  EdgeDivider divider(state.F, state.Options.BitingConstant, state.Options.PartLength,
    state.Progress, LeastPart(state.Options));
  DivisionPoints division;
  for (Id segment = 0; segment < state.Geometry.NumberOfSegments(); ++segment)
  {
    if (state.IsPreserved(segment))
    {
      continue;
    }
    if (state.MayBite())
    {
      ProtectEdge(segment, corners, divider, division, state);
    }
    else
    {
      state.AddEdge(state.Geometry.Starts[segment], state.Geometry.Ends[segment], segment);
    }
  }
}

void ShieldEdges(BitingState& state)
{
  EdgeDivider divider(state.F, LeastShieldLength * state.Options.BitingConstant,
    ShieldLength * state.Options.BitingConstant, state.Progress);
  DivisionPoints division;
  for (Id segment = 0; segment < state.Geometry.NumberOfSegments(); ++segment)
  {
    if (!state.IsPreserved(segment))
    {
      continue;
    }
    state.AddEdge(state.Geometry.Starts[segment], state.Geometry.Ends[segment], segment);
    if (state.MayBite())
    {
      ShieldEdge(segment, divider, division, state);
    }
  }
}

} // namespace biting
