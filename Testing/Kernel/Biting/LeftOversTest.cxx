// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Biting/LeftOvers.h"

#include "../Support/MeshShapes.h"
#include "../Support/PolylineShapes.h"
#include "Biting/BiteOutline.h"
#include "Biting/BoundaryProtection.h"

#include <gtest/gtest.h>

#include <algorithm> // for max

namespace biting
{

namespace
{

/// Bites of a circle's boundary, in crowds of hundreds.
class CrowdOfBites : public testing::TestWithParam<BiteShape>
{
protected:
  static constexpr double Length = 0.1;
  static constexpr int Sides = 4000;

  CrowdOfBites()
    : Made(Make(PolylineBuilder().Loop(RegularPolygon({ 0.0, 0.0 }, 1.0, Sides)).Lines()))
    , Locator(this->Made.Domain, this->Unheard)
    , F(Prepare())
    , Options(GetParam(), Placement::Bisectors)
  {
  }

  static Spacing Prepare()
  {
    SpacingOptions wanted;
    wanted.Uniform = Length;
    ProblemList problems;
    Box2 box;
    box.Add({ -1.0, -1.0 });
    box.Add({ 1.0, 1.0 });
    return MakeSpacing(wanted, box, problems, NoMonitor());
  }

  /// How deep p lies in any of the bites.
  static double DepthAt(const BitingState& state, const Point2& p)
  {
    double depth = -1.0;
    for (Id bite = 0; bite < state.Placed.Size(); ++bite)
    {
      depth = std::max(depth, Depth(state.Placed, bite, p));
    }
    return depth;
  }

  /// Bites where the object says so, until it says nothing more.
  static void BiteAll(LeftOvers& rest, BitingState& state)
  {
    for (std::vector<Point2> places = rest.FindPlaces(); !places.empty();
         places = rest.FindPlaces())
    {
      for (const Point2& place : places)
      {
        if (!(DepthAt(state, place) > state.Slack(0)))
        {
          const Id vertex = state.AddVertex(place, Length, NoId);
          state.Bite(vertex, { 1.0, 0.0 }, 1.0, BitePhase::Interior);
          state.FinishBite();
        }
      }
    }
  }

  const MadeDomain Made;
  Pulse Unheard{ NoMonitor() };
  const DomainLocator Locator;
  const Spacing F;
  const BitingOptions Options;
};

INSTANTIATE_TEST_SUITE_P(
  LeftOvers, CrowdOfBites, testing::Values(BiteShape::Square, BiteShape::Circle));

TEST_P(CrowdOfBites, LeavesNoPlaceOfTheDomainAndSquaresNothingInDoubt)
{
  BitingState state(
    this->Made.Domain, this->Locator, this->F, 2.0 * Sides, this->Options, NoMonitor());
  AddDomainVertices(state);
  ProtectVertices(state);
  ProtectEdges(state);
  LeftOvers rest(state);
  BiteAll(rest, state);
  TestNumbers numbers(11);
  for (int sample = 0; sample < 2000; ++sample)
  {
    const Point2 p{ 2.0 * numbers.Unit() - 1.0, 2.0 * numbers.Unit() - 1.0 };
    ASSERT_TRUE(!this->Locator.IsInside(p) || DepthAt(state, p) > -1e-12) << p.X << ' ' << p.Y;
  }
  EXPECT_TRUE(this->Options.Shape == BiteShape::Circle || rest.FindBites().empty());
}

TEST_P(CrowdOfBites, IsNotLookedAtAgainWhereNothingWasBitten)
{
  BitingState state(
    this->Made.Domain, this->Locator, this->F, 2.0 * Sides, this->Options, NoMonitor());
  AddDomainVertices(state);
  ProtectVertices(state);
  ProtectEdges(state);
  LeftOvers rest(state);
  int calls = 0;
  while (!rest.FindPlaces().empty() && calls < 2)
  {
    ++calls;
  }
  EXPECT_EQ(calls, 1);
}

} // namespace

} // namespace biting
