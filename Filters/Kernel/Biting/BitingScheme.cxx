// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "BitingScheme.h"

#include "BitingState.h"
#include "BoundaryProtection.h"
#include "FrontTrace.h"
#include "InteriorBiting.h"

#include <utility> // for move

namespace biting
{

namespace
{

// c_b for a mean edge length f (of squares at corners: FrontOrder.h), and vertices per integral of
// 1/f^2 then, measured: corners over uniform and graded fields, bisectors where f is level
// (elsewhere see BiteTriangle.h).
constexpr double SquareBisectorConstant = 0.824;
constexpr double CircleCornerConstant = 0.91;
constexpr double CircleBisectorConstant = 0.995;
constexpr double VerticesPerDensity = 1.21;

constexpr double SquareTolerance = 0.9;
constexpr double CircleTolerance = 0.8;

} // namespace

BitingOptions::BitingOptions(
  BiteShape shape, biting::Placement placement, FrontOrder order, double bitingConstant)
  : Shape(shape)
  , Placement(placement)
  , Order(order)
  , FollowSlope(bitingConstant == 0.0)
{
  const bool isCircle = shape == BiteShape::Circle;
  const bool isAtCorner = placement == Placement::Corners;
  const double square = isAtCorner ? RuleOf(order).CornerConstant : SquareBisectorConstant;
  const double circle = isAtCorner ? CircleCornerConstant : CircleBisectorConstant;
  const double automatic = isCircle ? circle : square;
  this->BitingConstant = bitingConstant > 0.0 ? bitingConstant : automatic;
  this->PartLength = this->BitingConstant / automatic;
  this->Tolerance = isAtCorner ? 1.0 : (isCircle ? CircleTolerance : SquareTolerance);
}

ConstraintEdges ConstraintsOf(const BitingResult& bites, const Domain& domain)
{
  ConstraintEdges constraints{ bites.EdgeStarts, bites.EdgeEnds, {} };
  constraints.IsBoundary.reserve(bites.EdgeSegments.size());
  for (const Id segment : bites.EdgeSegments)
  {
    constraints.IsBoundary.push_back(domain.IsBoundary[segment]);
  }
  return constraints;
}

double EstimateNumberOfVertices(double integratedDensity, double partLength)
{
  return VerticesPerDensity * integratedDensity / (partLength * partLength);
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
