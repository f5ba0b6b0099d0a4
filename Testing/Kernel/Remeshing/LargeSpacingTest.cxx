// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "../Support/MeshShapes.h"
#include "../Support/PolylineShapes.h"
#include "../Support/RemeshLaws.h"
#include "BitingMesh.h"
#include "BitingRemesh.h"

#include <gtest/gtest.h>

namespace biting
{

namespace
{

Polylines Plate()
{
  return PolylineBuilder()
    .Box(0.0, 0.0, 1.0, 1.0)
    .Loop(RegularPolygon({ 0.6, 0.6 }, 0.2, 24))
    .Loop(RegularPolygon({ 0.3, 0.3 }, 0.05, 12))
    .Lines();
}

BitingMesh MeshedTo(double spacing)
{
  BitingMeshOptions options;
  options.Spacing.Uniform = spacing;
  ProblemList problems;
  BitingMesh mesh = MakeBitingMesh(Plate(), options, problems, NoMonitor());
  EXPECT_FALSE(problems.HasErrors());
  return mesh;
}

BitingMesh RemeshedTo(const BitingMesh& mesh, double spacing)
{
  const RemeshInput input = RemeshInputOf(mesh, Rounding);
  RemeshOptions options;
  options.Values.assign(mesh.Points.size(), spacing);
  ProblemList problems;
  const RemeshResult result = Remesh(input, options, problems, NoMonitor());
  EXPECT_FALSE(problems.HasErrors());
  EXPECT_EQ(RemeshLaws(input, result).Violation(), "");
  return result.Mesh;
}

// Floats do not tell the sides of the plate from nothing beside such a spacing.
TEST(SpacingBeyondThePlate, LeavesItToItsFeaturesHoweverLargeItIs)
{
  const BitingMesh old = MeshedTo(0.05);
  const BitingMesh meshed = MeshedTo(10.0);
  const BitingMesh remeshed = RemeshedTo(old, 10.0);
  EXPECT_GT(remeshed.Quality.SmallestAngle, 25.0);
  for (const double spacing : { 1e5, 1e7, 1e10, 1e100 })
  {
    EXPECT_EQ(MeshedTo(spacing).Points.size(), meshed.Points.size()) << spacing;
    EXPECT_EQ(RemeshedTo(old, spacing).Points.size(), remeshed.Points.size()) << spacing;
  }
}

} // namespace

} // namespace biting
