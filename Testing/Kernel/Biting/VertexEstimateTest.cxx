// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Biting/VertexEstimate.h"
#include "../Support/MeshRun.h"
#include "../Support/MeshShapes.h"
#include "Biting/BitingScheme.h"

#include <gtest/gtest.h>

#include <cmath>   // for log, nextafter
#include <memory>  // for sources
#include <utility> // for pair
#include <vector>  // for cases

namespace biting
{

namespace
{

constexpr double Tolerance = 0.05; // as the header promises

double Integral(const Polylines& input, const SpacingOptions& options)
{
  const MadeDomain made = Make(input);
  const DomainLocator locator(made.Domain);
  ProblemList problems;
  SilentMonitor monitor;
  const Spacing spacing = MakeSpacing(options, made.Domain.Bounds, problems, monitor);
  return IntegrateDensity(made.Domain, locator, spacing);
}

Polylines Box(double width, double height)
{
  return PolylineBuilder().Box(0.0, 0.0, width, height).Lines();
}

TEST(IntegrateDensity, UniformIsAreaOverSquare)
{
  for (double length : { 1e-6, 0.1, 100.0 })
  {
    const double expected = 1.0 / (length * length);
    const SpacingOptions spacing = UniformSpacing(length);
    EXPECT_NEAR(Integral(Box(1.0, 1.0), spacing), expected, Tolerance * expected);
    EXPECT_NEAR(Integral(Box(100.0, 0.01), spacing), expected, Tolerance * expected);
    const double ring = 0.75 * 3.14159265 * expected;
    const Polylines input = PolylineBuilder()
                              .Loop(RegularPolygon({ 0.0, 0.0 }, 1.0, 400))
                              .Loop(RegularPolygon({ 0.0, 0.0 }, 0.5, 200))
                              .Lines();
    EXPECT_NEAR(Integral(input, spacing), ring, Tolerance * ring);
  }
}

TEST(IntegrateDensity, OfOneSpacingIsExact)
{
  EXPECT_DOUBLE_EQ(Integral(Box(4.0, 2.0), UniformSpacing(0.25)), 128.0);
}

TEST(IntegrateDensity, LinearHasItsClosedForm)
{
  for (double low : { 0.01, 0.1, 1.0 })
  {
    const double expected = 2.0 / (low * (low + 0.5 * 1.0));
    EXPECT_NEAR(
      Integral(Box(2.0, 1.0), LinearSpacing(low, 0.5, 1.0)), expected, Tolerance * expected);
  }
}

// 2 pi (log((a + g r) / a) - g r / (a + g r)) / g^2
TEST(IntegrateDensity, RadialHasItsClosedForm)
{
  const double radius = 1.0;
  const double growth = 0.3;
  for (double least : { 1e-3, 1e-2, 0.1 })
  {
    const double greatest = least + growth * radius;
    const double expected = 2.0 * 3.14159265 *
      (std::log(greatest / least) - growth * radius / greatest) / (growth * growth);
    const Polylines disc =
      PolylineBuilder().Loop(RegularPolygon({ 0.0, 0.0 }, radius, 300)).Lines();
    const double integral = Integral(disc, RadialSpacing({ 0.0, 0.0 }, least, growth));
    EXPECT_NEAR(integral, expected, Tolerance * expected) << least;
  }
}

// With `coarse` left of x = 0.7, `fine` right of it, and nothing between.
SpacingOptions JumpFrom(double coarse, double fine)
{
  auto grid = std::make_shared<GridSource>();
  grid->XNodes = { 0.0, 0.7, std::nextafter(0.7, 1.0), 1.0 };
  grid->YNodes = { 0.0, 1.0 };
  grid->Values = { coarse, coarse, fine, fine, coarse, coarse, fine, fine };
  SpacingOptions options;
  options.Grid = grid;
  options.Gradation = 0.0;
  return options;
}

TEST(IntegrateDensity, SeesBothSidesOfAJump)
{
  for (const auto& [coarse, fine] : std::vector<std::pair<double, double>>{
         { 0.3, 0.2 }, { 1.0, 0.1 }, { 0.1, 1e-3 }, { 1e-3, 0.1 } })
  {
    const double expected = 0.7 / (coarse * coarse) + 0.3 / (fine * fine);
    const double integral = Integral(Box(1.0, 1.0), JumpFrom(coarse, fine));
    EXPECT_NEAR(integral, expected, Tolerance * expected) << coarse << " " << fine;
  }
}

double DivisionPoints(const Domain& domain, const SpacingOptions& options)
{
  ProblemList problems;
  const Spacing spacing = MakeSpacing(options, domain.Bounds, problems, NoMonitor());
  return EstimateDivisionPoints(domain, spacing, 1.0);
}

TEST(EstimateDivisionPoints, AreNotManyForOneFineCorner)
{
  // Of 1 / (least + r) along the two sides at the corner; the others have no point within.
  for (const double least : { 1e-3, 1e-9, 1e-14 })
  {
    const Domain domain = Make(Box(1.0, 1.0)).Domain;
    const double points = DivisionPoints(domain, RadialSpacing({ 0.0, 0.0 }, least, 1.0));
    const double expected = 2.0 * (std::log(1.0 / least) - 1.0);
    EXPECT_NEAR(points, expected, 0.05 * expected) << least;
  }
}

TEST(EstimateNumberOfVertices, IsWithinAQuarterOfTheMesh)
{
  for (FrontOrder order : { FrontOrder::Layers, FrontOrder::LargestY })
  {
    for (double bitingConstant : { 0.0, 0.5, 0.7 })
    {
      BitingMeshOptions options;
      options.Spacing = LinearSpacing(0.01, 0.05, 1.0);
      options.BitingConstant = bitingConstant;
      options.Order = order;
      const BitingOptions biting(BiteShape::Square, Placement::Bisectors, order, bitingConstant);
      const double estimate =
        EstimateNumberOfVertices(Integral(Box(1.0, 1.0), options.Spacing), biting.PartLength);
      const double vertices = RunMesh(Box(1.0, 1.0), options).NumberOfVertices();
      EXPECT_NEAR(estimate, vertices, 0.25 * vertices) << bitingConstant;
    }
  }
}

} // namespace

} // namespace biting
