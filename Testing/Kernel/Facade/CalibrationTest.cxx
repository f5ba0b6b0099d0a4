// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Stages/Calibration.h"
#include "../Support/MeshRun.h"
#include "../Support/MeshShapes.h"
#include "Biting/VertexEstimate.h"

#include <gtest/gtest.h>

#include <vector> // for settings

namespace biting
{

namespace
{

double Calibrate(const Polylines& input, const SpacingOptions& spacingOptions,
  const BitingOptions& options = BitingOptions())
{
  const MadeDomain made = Make(input);
  Pulse unheard(NoMonitor());
  const DomainLocator locator(made.Domain, unheard);
  ProblemList problems;
  SilentMonitor monitor;
  const Spacing spacing = MakeSpacing(spacingOptions, made.Domain.Bounds, problems, monitor);
  const double density = IntegrateDensity(made.Domain, locator, spacing);
  return CalibrateBitingConstant(made.Domain, locator, spacing, density, options, monitor);
}

Polylines Square(double size)
{
  return PolylineBuilder().Box(0.0, 0.0, size, size).Lines();
}

Polylines Disc()
{
  return PolylineBuilder().Loop(RegularPolygon({ 0.5, 0.5 }, 0.5, 100)).Lines();
}

std::vector<BitingOptions> Settings()
{
  std::vector<BitingOptions> settings;
  for (const BiteShape shape : { BiteShape::Square, BiteShape::Circle })
  {
    for (const Placement placement : { Placement::Corners, Placement::Bisectors })
    {
      for (const FrontOrder order :
        { FrontOrder::Layers, FrontOrder::LargestY, FrontOrder::BestFirst })
      {
        settings.emplace_back(shape, placement, order);
      }
    }
  }
  return settings;
}

TEST(CalibrateBitingConstant, StaysWithinAFifthOfTheAutomaticConstant)
{
  for (const BitingOptions& options : Settings())
  {
    const double automatic = options.BitingConstant;
    for (double length : { 0.03, 0.001 })
    {
      for (const Polylines& input : { Square(1.0), Disc() })
      {
        const double constant = Calibrate(input, UniformSpacing(length), options);
        EXPECT_LE(constant, 1.2 * automatic);
        EXPECT_GE(constant, automatic / 1.2);
      }
    }
  }
}

TEST(CalibrateBitingConstant, TellsDomainsApart)
{
  const double square = Calibrate(Square(1.0), UniformSpacing(0.01));
  const double disc = Calibrate(Disc(), UniformSpacing(0.01));
  EXPECT_GT(square, disc);
}

TEST(CalibrateBitingConstant, LeavesSmallMeshesAlone)
{
  for (const BitingOptions& options : Settings())
  {
    EXPECT_EQ(Calibrate(Square(1.0), UniformSpacing(0.1), options), options.BitingConstant);
  }
}

TEST(CalibrateBitingConstant, DoesNotDependOnTheUnit)
{
  for (const BitingOptions& options : Settings())
  {
    EXPECT_EQ(Calibrate(Square(1.0), UniformSpacing(0.01), options),
      Calibrate(Square(0x1p20), UniformSpacing(0x1p20 * 0.01), options));
  }
}

TEST(CalibrateBitingConstant, GivesTheLengthsOfSmallMeshesToo)
{
  for (const double length : { 0.1, 0.06, 0.03, 0.015 })
  {
    BitingMeshOptions options;
    options.Spacing = UniformSpacing(length);
    options.Placement = Placement::Corners;
    EXPECT_NEAR(RunMesh(Square(1.0), options).Mesh.Quality.MeanRelativeLength, 1.0, 0.04) << length;
    EXPECT_NEAR(RunMesh(Disc(), options).Mesh.Quality.MeanRelativeLength, 1.0, 0.04) << length;
  }
}

// A trial at the size of the mesh would have 1e12 vertices, and never end.
TEST(CalibrateBitingConstant, AnswersWhateverTheSizeOfTheMesh)
{
  const double fine = Calibrate(Square(1.0), UniformSpacing(1e-6));
  const double coarse = Calibrate(Square(1.0), UniformSpacing(1e-2));
  EXPECT_NEAR(fine, coarse, 0.05 * coarse);
}

} // namespace

} // namespace biting
