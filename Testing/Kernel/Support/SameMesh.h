// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingSameMesh_h
#define BitingSameMesh_h

#include "BitingMesh.h"

#include <gtest/gtest.h>

#include <cstring> // for memcmp
#include <vector>  // for arrays

namespace biting
{

inline void ExpectSame(const MeshQuality& quality, const MeshQuality& other)
{
  EXPECT_EQ(quality.NearestNeighborDistance, other.NearestNeighborDistance);
  EXPECT_EQ(quality.Conformity, other.Conformity);
  EXPECT_EQ(quality.MinimumAngle, other.MinimumAngle);
  EXPECT_EQ(quality.RadiusEdgeRatio, other.RadiusEdgeRatio);
  EXPECT_EQ(quality.AspectRatio, other.AspectRatio);
  EXPECT_EQ(quality.SmallestAngle, other.SmallestAngle);
  EXPECT_EQ(quality.LargestRadiusEdgeRatio, other.LargestRadiusEdgeRatio);
  EXPECT_EQ(quality.SmallestConformity, other.SmallestConformity);
  EXPECT_EQ(quality.MeanConformity, other.MeanConformity);
  EXPECT_EQ(quality.MeanRelativeLength, other.MeanRelativeLength);
  EXPECT_EQ(quality.ShareOfEdgesInBand, other.ShareOfEdgesInBand);
}

/// To the last byte.
inline void ExpectSame(const BitingMesh& mesh, const BitingMesh& other)
{
  ASSERT_EQ(mesh.Points.size(), other.Points.size());
  for (std::size_t i = 0; i < mesh.Points.size(); ++i)
  {
    ASSERT_TRUE(mesh.Points[i] == other.Points[i]) << i;
  }
  EXPECT_EQ(mesh.Spacing, other.Spacing);
  EXPECT_EQ(mesh.BiteOrders, other.BiteOrders);
  EXPECT_EQ(mesh.Kinds, other.Kinds);
  EXPECT_EQ(mesh.OriginalPoints, other.OriginalPoints);
  EXPECT_EQ(mesh.Corners, other.Corners);
  EXPECT_EQ(mesh.Neighbors, other.Neighbors);
  EXPECT_EQ(mesh.Regions, other.Regions);
  EXPECT_EQ(mesh.EdgeStarts, other.EdgeStarts);
  EXPECT_EQ(mesh.EdgeEnds, other.EdgeEnds);
  EXPECT_EQ(mesh.EdgeCells, other.EdgeCells);
  EXPECT_EQ(mesh.EdgeIsBoundary, other.EdgeIsBoundary);
  EXPECT_EQ(mesh.UsedLipschitz, other.UsedLipschitz);
  ExpectSame(mesh.Quality, other.Quality);
}

/// NaN and signs of zero too.
template <typename Value>
bool HaveSameBytes(const std::vector<Value>& a, const std::vector<Value>& b)
{
  return a.size() == b.size() &&
    (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(Value)) == 0);
}

inline void ExpectSameTopology(const BitingMesh& a, const BitingMesh& b)
{
  EXPECT_TRUE(HaveSameBytes(a.BiteOrders, b.BiteOrders));
  EXPECT_TRUE(HaveSameBytes(a.Kinds, b.Kinds));
  EXPECT_TRUE(HaveSameBytes(a.OriginalPoints, b.OriginalPoints));
  EXPECT_TRUE(HaveSameBytes(a.Corners, b.Corners));
  EXPECT_TRUE(HaveSameBytes(a.Neighbors, b.Neighbors));
  EXPECT_TRUE(HaveSameBytes(a.Regions, b.Regions));
  EXPECT_TRUE(HaveSameBytes(a.EdgeStarts, b.EdgeStarts));
  EXPECT_TRUE(HaveSameBytes(a.EdgeEnds, b.EdgeEnds));
  EXPECT_TRUE(HaveSameBytes(a.EdgeCells, b.EdgeCells));
  EXPECT_TRUE(HaveSameBytes(a.EdgeIsBoundary, b.EdgeIsBoundary));
  EXPECT_TRUE(HaveSameBytes(a.Bites.Orders, b.Bites.Orders));
  EXPECT_TRUE(HaveSameBytes(a.Bites.Phases, b.Bites.Phases));
}

} // namespace biting

#endif
