// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "../Support/MeshShapes.h"
#include "Base/DistanceToSegment.h"
#include "Stages/PreparedInput.h"

#include <gtest/gtest.h>

#include <algorithm> // for min, max
#include <cmath>     // for nan
#include <limits>    // for infinity

namespace biting
{

namespace
{

constexpr double Gradation = 0.25;
constexpr double CarrierError = 0.0125; // of a segment source, relative

/// Sides of 1, 10 and 30 parts, and one vertex inside.
Domain UnevenSquare()
{
  const std::vector<Point2> places =
    DividedLoop({ { 0.0, 0.0 }, { 1.0, 0.0 }, { 1.0, 1.0 }, { 0.0, 1.0 } }, { 1, 10, 30, 10 });
  return Make(
    PolylineBuilder().Loop(places).Chain({ { 0.5, 0.5 } }, ChainKind::EmbeddedPoint).Lines())
    .Domain;
}

Spacing Follow(const Domain& domain, SpacingOptions options)
{
  options.Gradation = Gradation;
  ProblemList problems;
  SilentMonitor monitor;
  Spacing spacing = MakeSpacing(FollowSegments(options, domain), domain.Bounds, problems, monitor);
  EXPECT_TRUE(problems.Groups().empty());
  return spacing;
}

/// L of the header, segment by segment.
double LengthsAt(const Domain& domain, const Point2& p)
{
  double least = std::numeric_limits<double>::infinity();
  for (Id segment = 0; segment < domain.NumberOfSegments(); ++segment)
  {
    const Point2& a = domain.Vertices[domain.Starts[segment]];
    const Point2& b = domain.Vertices[domain.Ends[segment]];
    least = std::min(least, Distance(a, b) + Gradation * DistanceToSegment(p, a, b));
  }
  return least;
}

/// The lower bound of the header, point by point.
double FloorAt(const Domain& domain, const Point2& p)
{
  double greatest = 0.0;
  for (Id segment = 0; segment < domain.NumberOfSegments(); ++segment)
  {
    const Point2& a = domain.Vertices[domain.Starts[segment]];
    const Point2& b = domain.Vertices[domain.Ends[segment]];
    for (const Point2& y : { a, Midpoint(a, b), b })
    {
      greatest = std::max(greatest, LengthsAt(domain, y) - Gradation * Distance(p, y));
    }
  }
  return greatest;
}

std::vector<Point2> Places()
{
  TestNumbers numbers(11);
  std::vector<Point2> places;
  for (int k = 0; k < 500; ++k)
  {
    const double x = numbers.Unit();
    places.push_back({ x, numbers.Unit() });
  }
  return places;
}

TEST(FollowSegments, TakesTheLengthsWhereNothingElseIsGiven)
{
  const Domain domain = UnevenSquare();
  const Spacing spacing = Follow(domain, {});
  for (const Point2& p : Places())
  {
    const double lengths = LengthsAt(domain, p);
    ASSERT_NEAR(spacing(p), lengths, CarrierError * lengths);
  }
}

TEST(FollowSegments, KeepsWhatIsGivenBetweenItsBounds)
{
  const Domain domain = UnevenSquare();
  for (const double given : { 1e-3, 0.07, 0.2, 50.0 })
  {
    const Spacing spacing = Follow(domain, UniformSpacing(given));
    for (const Point2& p : Places())
    {
      const double wanted = std::max(std::min(given, LengthsAt(domain, p)), FloorAt(domain, p));
      ASSERT_NEAR(spacing(p), wanted, CarrierError * wanted) << given;
    }
  }
}

TEST(FollowSegments, DoesNotScaleTheLengths)
{
  const Domain domain = UnevenSquare();
  SpacingOptions options = UniformSpacing(0.3);
  const Spacing plain = Follow(domain, options);
  options.Scale = 3.0;
  options.Uniform = 0.1;
  const Spacing scaled = Follow(domain, options);
  for (const Point2& p : Places())
  {
    ASSERT_NEAR(scaled(p), plain(p), 2.0 * CarrierError * plain(p));
  }
}

TEST(FollowSegments, DoesNotLetAnEmbeddedPointBoundTheSpacing)
{
  const Domain domain = UnevenSquare();
  const Spacing spacing = Follow(domain, UniformSpacing(1e-3));
  EXPECT_LT(spacing({ 0.5, 0.5 }), 0.9 * LengthsAt(domain, { 0.5, 0.5 }));
}

TEST(FollowSegments, KeepsTheNumbersOfPointsOfASource)
{
  const Domain domain = UnevenSquare();
  SpacingOptions options = RadialSpacing({ 0.25, 0.5 }, -1.0, 0.2);
  ProblemList problems;
  SilentMonitor monitor;
  MakeSpacing(FollowSegments(options, domain), domain.Bounds, problems, monitor);
  ASSERT_EQ(problems.Groups().size(), 1u);
  const Problem& problem = problems.Groups().front().First.front();
  EXPECT_EQ(problem.Code, ProblemCode::BadSpacing);
  EXPECT_EQ(problem.Ids, std::vector<std::int64_t>{ 0 });
}

TEST(FollowSegments, LeavesRefusedParametersToBeRefused)
{
  const Domain domain = UnevenSquare();
  for (const double value : { -1.0, 0.0, std::nan(""), std::numeric_limits<double>::infinity() })
  {
    SpacingOptions options = UniformSpacing(0.1);
    options.Scale = value;
    ProblemList problems;
    SilentMonitor monitor;
    MakeSpacing(FollowSegments(options, domain), domain.Bounds, problems, monitor);
    EXPECT_TRUE(problems.Has(ProblemCode::BadSpacing)) << value;
    EXPECT_TRUE(problems.Groups().front().First.front().Ids.empty()) << value;
  }
}

} // namespace

} // namespace biting
