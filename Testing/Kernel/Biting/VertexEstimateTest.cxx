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
  Pulse unheard(NoMonitor());
  const DomainLocator locator(made.Domain, unheard);
  ProblemList problems;
  SilentMonitor monitor;
  const Spacing spacing = MakeSpacing(options, made.Domain.Bounds, problems, monitor);
  return IntegrateDensity(made.Domain, locator, spacing);
}

Polylines Box(double width, double height)
{
  return PolylineBuilder().Box(0.0, 0.0, width, height).Lines();
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
  options.Sources.emplace_back(grid);
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
