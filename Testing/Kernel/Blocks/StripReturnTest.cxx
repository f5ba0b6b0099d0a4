// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "StripMeshes.h"

#include "Blocks/StripParts.h"
#include "Blocks/StripReturn.h"

#include <gtest/gtest.h>

#include <algorithm> // for min, is_sorted
#include <array>     // for triangles
#include <numeric>   // for iota
#include <set>       // for triangles in no order

namespace biting
{

namespace
{

// Each begins with its lowest corner.
std::set<std::array<Point2, 3>> TrianglesOf(const RelaxationMesh& mesh)
{
  std::set<std::array<Point2, 3>> triangles;
  for (std::size_t first = 0; first < mesh.Triangles.Corners.size(); first += 3)
  {
    std::array<Point2, 3> corners;
    for (std::size_t k = 0; k < 3; ++k)
    {
      corners[k] = mesh.Points[mesh.Triangles.Corners[first + k]];
    }
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    triangles.insert(corners);
  }
  return triangles;
}

std::vector<double> LengthsOfSegments(const Domain& domain, const RelaxationMesh& mesh)
{
  std::vector<double> lengths(domain.NumberOfSegments(), 0.0);
  for (std::size_t edge = 0; edge < mesh.EdgeStarts.size(); ++edge)
  {
    lengths[mesh.EdgeSegments[edge]] +=
      Distance(mesh.Points[mesh.EdgeStarts[edge]], mesh.Points[mesh.EdgeEnds[edge]]);
  }
  return lengths;
}

// Parts of so many triangles, taken from the mesh, relaxed or not, and returned.
StripChange TakeAndReturn(const RawMesh& raw, std::size_t most, bool areRelaxed, JoinedMesh& mesh)
{
  Pulse pulse(NoMonitor());
  const std::vector<std::uint8_t> touchesNone;
  StripSource source(raw.Domain, touchesNone, mesh, pulse);
  std::vector<RelaxedStrip> strips;
  for (TriangleList& part : DivideIntoParts(mesh.Triangles, mesh.Bites.Points.size(), most, pulse))
  {
    RelaxedStrip strip;
    strip.Strip = TakeStrip(source, std::move(part), pulse);
    strip.Origins.resize(strip.Strip.Vertices.size());
    std::iota(strip.Origins.begin(), strip.Origins.end(), 0);
    if (areRelaxed)
    {
      strip.Origins =
        Relax(strip.Strip.Border, raw.Spacing, { false }, strip.Strip.Mesh, NoMonitor()).Origins;
    }
    strips.push_back(std::move(strip));
  }
  return ReturnStrips(strips, mesh, pulse);
}

} // namespace

TEST(StripReturn, StripsThatStayAsTheyAreMakeTheSameMesh)
{
  for (const RawMesh& raw : AllRawMeshes())
  {
    JoinedMesh mesh = AsJoined(raw.Mesh);
    const StripChange change = TakeAndReturn(raw, 90, false, mesh);
    EXPECT_TRUE(change.IsWhole);
    EXPECT_TRUE(change.GoneVertices.empty());
    EXPECT_TRUE(std::is_sorted(change.Triangles.begin(), change.Triangles.end()));
    const RelaxationMesh returned = FromJoined(mesh);
    EXPECT_TRUE(AreSameBytes(returned.Points, raw.Mesh.Points));
    EXPECT_TRUE(AreSameBytes(returned.EdgeStarts, raw.Mesh.EdgeStarts));
    EXPECT_TRUE(AreSameBytes(returned.EdgeSegments, raw.Mesh.EdgeSegments));
    EXPECT_EQ(TrianglesOf(returned), TrianglesOf(raw.Mesh));
    EXPECT_EQ(Violation(raw.Domain, returned, true), "");
  }
}

/// Not one vertex of the domain moves, and all others keep their order.
TEST(StripReturn, RelaxedStripsMakeAMeshOfTheSameSegments)
{
  for (const RawMesh& raw : AllRawMeshes())
  {
    JoinedMesh mesh = AsJoined(raw.Mesh);
    const StripChange change = TakeAndReturn(raw, 90, true, mesh);
    const RelaxationMesh returned = FromJoined(mesh);
    EXPECT_EQ(Violation(raw.Domain, returned, true), "");
    for (std::size_t vertex = 0; vertex < raw.Domain.Vertices.size(); ++vertex)
    {
      EXPECT_TRUE(returned.Points[vertex] == raw.Domain.Vertices[vertex]);
    }
    std::vector<Id> kept = mesh.Bites.BiteOrders;
    kept.erase(std::remove(kept.begin(), kept.end(), NoId), kept.end());
    EXPECT_TRUE(std::is_sorted(kept.begin(), kept.end()));
    EXPECT_EQ(kept.size() + change.GoneVertices.size(), raw.Mesh.Points.size());
    const std::vector<double> before = LengthsOfSegments(raw.Domain, raw.Mesh);
    const std::vector<double> after = LengthsOfSegments(raw.Domain, returned);
    for (std::size_t segment = 0; segment < before.size(); ++segment)
    {
      EXPECT_NEAR(before[segment], after[segment], 1e-12);
    }
  }
}

} // namespace biting
