// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "EdgeProtection.h"

#include "../Base/PointOnSegment.h"
#include "EdgeDivision.h"
#include "SharpCorners.h"

#include <algorithm> // for min

namespace biting
{

namespace
{

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

} // namespace

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

} // namespace biting
