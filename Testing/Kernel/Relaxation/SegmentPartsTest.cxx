// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "RawMesh.h"
#include "Relaxation/EdgeOperations.h"

#include "Relaxation/SegmentParts.h"

#include <gtest/gtest.h>

#include <algorithm> // for max, max_element
#include <cmath>     // for sqrt

namespace biting
{

namespace
{

/// Equilateral triangle of which each side is `length` spacings long and one edge of the mesh.
Workshop SingleTriangle(double length)
{
  const double height = std::sqrt(0.75);
  return Workshop(
    RawMesh(PolylineBuilder().Loop({ { 0.0, 0.0 }, { 1.0, 0.0 }, { 0.5, height } }).Lines(),
      UniformSpacing(1.0 / length), 0.7, 0));
}

/// A square of which each side is `length` spacings long, with parts of at most two of them.
RawMesh BoxMesh(double length)
{
  return RawMesh(
    PolylineBuilder().Box(0.0, 0.0, 1.0, 1.0).Lines(), UniformSpacing(1.0 / length), 0.7, 200);
}

double Excess(double length)
{
  return std::max(0.73 - length, length - 1.37);
}

std::vector<double> LengthsOfParts(const MutableMesh& mesh)
{
  std::vector<double> lengths;
  for (Id edge = 0; edge < mesh.NumberOfEdges(); ++edge)
  {
    if (mesh.IsFirstHalf(edge) && mesh.Marks[edge] != NoId)
    {
      lengths.push_back(mesh.RelativeLength(edge));
    }
  }
  return lengths;
}

} // namespace

TEST(SegmentParts, WholeSegmentsAreHalvedOnlyWhereThatIsNearerToTheSpacing)
{
  for (const double length : { 0.3, 1.0, 1.3, 1.41, 1.42, 1.5, 1.9 })
  {
    const Workshop shop = SingleTriangle(length);
    const bool isTooLong = length > std::sqrt(2.0);
    for (Id edge = 0; edge < 3; ++edge)
    {
      EXPECT_EQ(IsTooLongPart(shop.Mesh, edge), isTooLong) << length;
      EXPECT_EQ(LeavesShortParts(shop.Mesh, edge), !isTooLong) << length;
      EXPECT_FALSE(LeavesLongPart(shop.Mesh, edge)) << length;
    }
  }
}

TEST(SegmentParts, CollapsesThatAreAllowedLeaveNoPartTooLong)
{
  int count = 0;
  for (RawMesh& raw : AllRawMeshes())
  {
    Workshop shop(std::move(raw));
    MutableMesh& mesh = shop.Mesh;
    for (Id edge = 0; edge < mesh.NumberOfEdges(); ++edge)
    {
      if (mesh.IsFirstHalf(edge) && mesh.Marks[edge] != NoId && !LeavesLongPart(mesh, edge))
      {
        const std::vector<double> before = LengthsOfParts(mesh);
        mesh.BeginTrial();
        const Id vertex = CollapseEdge(mesh, edge);
        const std::vector<double> after = LengthsOfParts(mesh);
        mesh.EndTrial(false);
        const double longest = *std::max_element(before.begin(), before.end());
        EXPECT_LE(
          *std::max_element(after.begin(), after.end()), std::max(longest, 1.01 * std::sqrt(2.0)));
        count += vertex != NoId ? 1 : 0;
      }
    }
  }
  EXPECT_GT(count, 0);
}

TEST(SegmentParts, SlidesLeavePartsWithinTheirLimitsOrNoWorse)
{
  Dice dice(3);
  for (RawMesh& raw : AllRawMeshes())
  {
    const Workshop shop(std::move(raw));
    const MutableMesh& mesh = shop.Mesh;
    for (Id vertex = 0; vertex < mesh.NumberOfVertices(); ++vertex)
    {
      Star star;
      if (mesh.Freedoms[vertex] != Freedom::Sliding || !star.Read(mesh, vertex))
      {
        continue;
      }
      const Id segment = mesh.Segments[vertex];
      const Point2 whole = mesh.Geometry.Vertices[mesh.Geometry.Ends[segment]] -
        mesh.Geometry.Vertices[mesh.Geometry.Starts[segment]];
      const double along = (4.0 * dice.Unit() - 2.0) * mesh.Spacings[vertex] / Length(whole);
      const double share = ShareOfSlide(mesh, vertex, star, along * whole);
      ASSERT_GE(share, 0.0);
      ASSERT_LE(share, 1.0);
      for (int k = 0; k < star.NumberOfTriangles; ++k)
      {
        const Id spoke = MutableMesh::Previous(star.Edges[k]);
        const double mean = 0.5 * (mesh.Spacings[vertex] + mesh.Spacings[star.Vertices[k]]);
        const double before = Length(star.Spokes[k]) / mean;
        const double after = Length(star.Spokes[k] - share * along * whole) / mean;
        EXPECT_TRUE(
          mesh.Marks[spoke] == NoId || Excess(after) <= std::max(0.0, Excess(before)) + 1e-9)
          << before << " " << after;
      }
    }
  }
}

// Some are out of it for the sake of an angle.
TEST(SegmentParts, OfRelaxedSquaresAreMostlyInTheBand)
{
  Id count = 0;
  Id outside = 0;
  for (double length = 0.8; length < 12.0; length *= 1.07)
  {
    RawMesh raw = BoxMesh(length);
    raw.Relax();
    for (const double part : LengthsOfParts(Workshop(std::move(raw)).Mesh))
    {
      ++count;
      outside += part < std::sqrt(0.5) || part > std::sqrt(2.0) ? 1 : 0;
    }
  }
  EXPECT_LT(50 * outside, count);
}

} // namespace biting
