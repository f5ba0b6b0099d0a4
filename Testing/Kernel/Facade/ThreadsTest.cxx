// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

// The number of threads is no parameter of the mesh.

#include "../Support/MeshRun.h"
#include "../Support/MeshShapes.h"
#include "../Support/PolylineShapes.h"
#include "../Support/SameMesh.h"
#include "../Support/TestThreads.h"

#include <gtest/gtest.h>

#include <cmath> // for sqrt

namespace biting
{

namespace
{

BitingMesh MeshWith(int numberOfThreads, double spacing)
{
  BitingMeshOptions options;
  options.Spacing = UniformSpacing(spacing);
  const Polylines drawing = PolylineBuilder()
                              .Box(0.0, 0.0, 1.0, 1.0)
                              .Loop(RegularPolygon({ 0.5, 0.5 }, 0.2, 40))
                              .Chain({ { 0.0, 0.125 }, { 1.0, 0.125 } })
                              .Lines();
  ProblemList problems;
  MonitorWithThreads monitor(numberOfThreads);
  BitingMesh mesh = MakeBitingMesh(drawing, options, problems, monitor);
  EXPECT_FALSE(problems.HasErrors());
  return mesh;
}

} // namespace

TEST(Threads, MeshesAreTheSameToTheLastByteForAnyNumberOfThem)
{
  const double spacing = std::sqrt(1.0 / 40000.0);
  const BitingMesh alone = MeshWith(1, spacing);
  for (const int numberOfThreads : { 2, 3, 8 })
  {
    ExpectSame(MeshWith(numberOfThreads, spacing), alone);
  }
}

} // namespace biting
