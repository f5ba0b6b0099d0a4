// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "../Support/MeshRun.h"
#include "../Support/MeshShapes.h"
#include "../Support/RemeshLaws.h"
#include "BitingRemesh.h"

#include <gtest/gtest.h>

#include <algorithm> // for min
#include <cmath>     // for abs
#include <cstddef>   // for sizes

namespace biting
{

namespace
{

RemeshInput SquareInput(double spacing)
{
  BitingMeshOptions options;
  options.Spacing.Uniform = spacing;
  return RemeshInputOf(
    RunMesh(PolylineBuilder().Box(0.0, 0.0, 1.0, 1.0).Lines(), options).Mesh, 1e-15);
}

bool IsInSquare(const Point2& point)
{
  return std::min({ point.X, point.Y, 1.0 - point.X, 1.0 - point.Y }) > 0.0;
}

/// Of the vertices within the square.
double ShareOfOldOnes(const BitingMesh& mesh)
{
  int inner = 0;
  int old = 0;
  for (std::size_t vertex = 0; vertex < mesh.Points.size(); ++vertex)
  {
    const bool isInner = IsInSquare(mesh.Points[vertex]);
    inner += isInner ? 1 : 0;
    old += isInner && mesh.OriginalPoints[vertex] != NoId ? 1 : 0;
  }
  return static_cast<double>(old) / inner;
}

// Where f changes from one old vertex to the next, hardly any is kept at first.
TEST(InnerPlaces, AreTakenByNewVerticesWhereAFineMeshGetsCoarser)
{
  const RemeshInput input = SquareInput(0.01);
  RemeshOptions options;
  options.Spacing.Gradation = 0.3;
  for (const Point2& point : input.Points)
  {
    options.Values.push_back(0.02 + 0.3 * std::abs(point.X - 0.5));
  }
  const auto meshWith = [&input, &options](RemeshPreference preference)
  {
    options.Preference = preference;
    ProblemList problems;
    const RemeshResult result = Remesh(input, options, problems, NoMonitor());
    EXPECT_EQ(RemeshLaws(input, result).Violation(), "");
    EXPECT_GT(result.Mesh.Quality.SmallestAngle, 30.0);
    return result.Mesh;
  };
  const double share = ShareOfOldOnes(meshWith(RemeshPreference::Balanced));
  EXPECT_GT(share, 0.4);
  EXPECT_LT(ShareOfOldOnes(meshWith(RemeshPreference::Shape)), 0.75 * share);
}

} // namespace

} // namespace biting
