// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Calibration.h"
#include "../Support/MeshShapes.h"
#include "Biting/VertexEstimate.h"

#include <gtest/gtest.h>

namespace biting
{

namespace
{

double Calibrate(const Polylines& input, const SpacingOptions& spacingOptions, FrontOrder order)
{
  const MadeDomain made = Make(input);
  const DomainLocator locator(made.Domain);
  ProblemList problems;
  SilentMonitor monitor;
  const Spacing spacing = MakeSpacing(spacingOptions, made.Domain.Bounds, problems, monitor);
  BitingOptions options;
  options.Order = order;
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

constexpr FrontOrder Orders[] = { FrontOrder::Layers, FrontOrder::LargestY };

TEST(CalibrateBitingConstant, StaysWithinAFifthOfTheAutomaticConstant)
{
  for (FrontOrder order : Orders)
  {
    const double automatic = AutomaticBitingConstant(order);
    for (double length : { 0.03, 0.01, 0.001 })
    {
      for (const Polylines& input : { Square(1.0), Disc() })
      {
        const double constant = Calibrate(input, UniformSpacing(length), order);
        EXPECT_LE(constant, 1.2 * automatic);
        EXPECT_GE(constant, automatic / 1.2);
      }
    }
  }
}

TEST(CalibrateBitingConstant, TellsDomainsApart)
{
  const double square = Calibrate(Square(1.0), UniformSpacing(0.01), FrontOrder::Layers);
  const double disc = Calibrate(Disc(), UniformSpacing(0.01), FrontOrder::Layers);
  EXPECT_GT(square, disc);
}

TEST(CalibrateBitingConstant, LeavesSmallMeshesAlone)
{
  for (FrontOrder order : Orders)
  {
    EXPECT_EQ(Calibrate(Square(1.0), UniformSpacing(0.1), order), AutomaticBitingConstant(order));
  }
}

TEST(CalibrateBitingConstant, DoesNotDependOnTheUnit)
{
  for (FrontOrder order : Orders)
  {
    EXPECT_EQ(Calibrate(Square(1.0), UniformSpacing(0.01), order),
      Calibrate(Square(0x1p20), UniformSpacing(0x1p20 * 0.01), order));
  }
}

// A trial at the size of the mesh would have 1e12 vertices, and never end.
TEST(CalibrateBitingConstant, AnswersWhateverTheSizeOfTheMesh)
{
  const double fine = Calibrate(Square(1.0), UniformSpacing(1e-6), FrontOrder::Layers);
  const double coarse = Calibrate(Square(1.0), UniformSpacing(1e-2), FrontOrder::Layers);
  EXPECT_NEAR(fine, coarse, 0.05 * coarse);
}

} // namespace

} // namespace biting
