// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "BitingScheme.h"

#include "BitingState.h"
#include "EdgeProtection.h"
#include "EdgeShields.h"
#include "FrontTrace.h"
#include "InteriorBiting.h"
#include "VertexProtection.h"

#include <utility> // for move

namespace biting
{

namespace
{

// c_b for a mean edge length f, and vertices per integral of 1/f^2 then, measured: corners over
// uniform and graded fields, bisectors where f is level (elsewhere see ReachFactor.h).
constexpr double SquareCornerConstant = 0.77;
constexpr double SquareCornerSweepConstant = 0.80;
constexpr double SquareBisectorConstant = 0.824;
constexpr double CircleCornerConstant = 0.91;
constexpr double CircleBisectorConstant = 0.995;
constexpr double VerticesPerDensity = 1.21;

constexpr double SquareTolerance = 0.9;
constexpr double CircleTolerance = 0.8;

} // namespace

double AutomaticBitingConstant(const BitingOptions& options)
{
  const bool isCircle = options.Shape == BiteShape::Circle;
  if (options.Placement == Placement::Bisectors)
  {
    return isCircle ? CircleBisectorConstant : SquareBisectorConstant;
  }
  const bool isSweep = options.Order == FrontOrder::LargestY;
  const double square = isSweep ? SquareCornerSweepConstant : SquareCornerConstant;
  return isCircle ? CircleCornerConstant : square;
}

double AutomaticTolerance(const BitingOptions& options)
{
  if (options.Placement == Placement::Corners)
  {
    return 1.0;
  }
  return options.Shape == BiteShape::Circle ? CircleTolerance : SquareTolerance;
}

double EstimateNumberOfVertices(double integratedDensity, const BitingOptions& options)
{
  const double length = UsedBitingConstant(options) / AutomaticBitingConstant(options);
  return VerticesPerDensity * integratedDensity / (length * length);
}

BitingResult BiteDomain(const Domain& domain, const DomainLocator& locator, const Spacing& spacing,
  double expectedVertices, const BitingOptions& options, Monitor& monitor)
{
  BitingState state(domain, locator, spacing, expectedVertices, options, monitor);
  AddDomainVertices(state);
  ProtectVertices(state);
  ShieldEdges(state);
  ProtectEdges(state);
  InteriorBiting interior(state);
  interior.Run();
  const bool isStopped = state.Result.End == BitingEnd::Complete && !state.MayBite();
  if (options.KeepFront && isStopped)
  {
    state.Result.Front = TraceFront(domain, locator, state.Placed, state.Grid, state.Progress);
    state.Step();
  }
  state.Grid.Release(state.Progress);
  interior.Release(state.Progress);
  ReleaseInSteps(state.Progress, state.PlacedSpacings);
  if (state.Result.Triangulated.IsWhole())
  {
    InsertLate(state.Result.Points, options.Phi, state.Result.Triangulated, state.Progress);
  }
  state.Result.Segments.resize(state.Result.Points.size(), NoId);
  return std::move(state.Result);
}

} // namespace biting
