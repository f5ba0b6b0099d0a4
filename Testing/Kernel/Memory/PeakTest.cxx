// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

// A program of its own, as it counts all that is allocated.

#include "../../Benchmark/CountedMemory.h"
#include "../Support/PolylineShapes.h"
#include "BitingMesh.h"
#include "Space/Meshing/SurfaceMesher.h"

#include <gtest/gtest.h>

#include <cmath> // for roots

namespace biting
{

namespace
{

// With a million vertices it is 220: there are fewer on the boundary, by which forecasts are high.
constexpr double MostBytesAVertex = 225.0;

// In one block the grid of all bites, 100 bytes a vertex, and their triangulation are there at the
// same time, as left-overs are looked for in both.
constexpr double MostBytesInOneBlock = 325.0;

constexpr double Vertices = 90000.0;

BitingMeshOptions SquareOptions()
{
  BitingMeshOptions options;
  options.Spacing.Uniform = std::sqrt(1.25 / Vertices);
  options.VerticesPerBlock = 0;
  return options;
}

double BytesAVertex(const BitingMeshOptions& options, Id leastBlocks = 1)
{
  const Polylines square = PolylineBuilder().Box(0.0, 0.0, 1.0, 1.0).Lines();
  ProblemList problems;
  const std::size_t before = BeginPeak();
  const BitingMesh mesh = MakeBitingMesh(square, options, problems, NoMonitor());
  const double bytes = static_cast<double>(PeakBytes() - before);
  EXPECT_GT(mesh.Points.size(), 0.9 * Vertices);
  EXPECT_GE(mesh.NumberOfBlocks, leastBlocks);
  return bytes / static_cast<double>(mesh.Points.size());
}

/// The surface of the unit cube.
SurfaceMesh Cube()
{
  SurfaceMesh cube;
  for (Id k = 0; k < 8; ++k)
  {
    cube.Points.push_back({ k % 2 + 0.0, k / 2 % 2 + 0.0, k / 4 + 0.0 });
    cube.PointIds.push_back(k);
  }
  cube.Corners = { 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3, 0, 2, 3,
    0, 3, 1, 4, 5, 7, 4, 7, 6 };
  for (Id cell = 0; cell < 12; ++cell)
  {
    cube.Cells.push_back(cell);
  }
  return cube;
}

} // namespace

TEST(Memory, OfASurfaceIsAtMost600BytesAVertex)
{
  constexpr double MostBytes = 600.0;
  constexpr double Size = 0.0186;
  ProblemList problems;
  const CheckedSurface surface = CheckSurface(Cube(), {}, problems, NoMonitor());
  SurfaceMesherOptions options;
  options.Spacing = [](const Point3&) { return Size; };
  const std::size_t before = BeginPeak();
  const BitingSurface mesh = MakeBitingSurface(surface, options, problems, NoMonitor());
  const double bytes = static_cast<double>(PeakBytes() - before);
  EXPECT_GT(mesh.Points.size(), 20000u);
  EXPECT_LE(bytes / static_cast<double>(mesh.Points.size()), MostBytes);
}

TEST(Memory, OfARawMeshIsAtMost325BytesAVertex)
{
  BitingMeshOptions options = SquareOptions();
  options.Relaxation = false;
  EXPECT_LE(BytesAVertex(options), MostBytesInOneBlock);
}

TEST(Memory, OfARelaxedMeshInOneBlockIsAtMost325BytesAVertex)
{
  EXPECT_LE(BytesAVertex(SquareOptions()), MostBytesInOneBlock);
}

TEST(Memory, OfAMeshOfBlocksIsAtMost225BytesAVertex)
{
  BitingMeshOptions options = SquareOptions();
  options.VerticesPerBlock = 10000;
  EXPECT_LE(BytesAVertex(options, 8), MostBytesAVertex);
}

} // namespace biting
