// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

// A program of its own, as it counts all that is allocated.

#include "../../Benchmark/CountedMemory.h"
#include "../Support/PolylineShapes.h"
#include "BitingMesh.h"

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

} // namespace

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
