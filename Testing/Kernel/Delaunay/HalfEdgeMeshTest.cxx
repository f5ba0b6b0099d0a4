// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Delaunay/HalfEdgeMesh.h"

#include <gtest/gtest.h>

namespace biting
{

namespace
{

/// Without vertices: places for marks alone.
HalfEdgeMesh Triangles(Id count)
{
  HalfEdgeMesh mesh;
  mesh.Corners.assign(4 * static_cast<std::size_t>(count), 0);
  mesh.Twins.assign(mesh.Corners.size(), NoId);
  mesh.NumberOfTriangles = count;
  return mesh;
}

} // namespace

TEST(HalfEdgeMesh, HasTheMarksThatWereSet)
{
  HalfEdgeMesh mesh = Triangles(100);
  std::vector<Id> expected(mesh.Corners.size(), NoId);
  for (Id step = 0; step < 1000; ++step)
  {
    const Id edge = HalfEdgeMesh::FirstEdge(step * 7 % 41) + step % 3;
    const Id mark = step % 4 == 0 ? NoId : step;
    mesh.SetMark(edge, mark);
    expected[edge] = mark;
  }
  for (Id triangle = 0; triangle < mesh.NumberOfTriangles; ++triangle)
  {
    bool hasSome = false;
    for (Id k = 0; k < 3; ++k)
    {
      const Id edge = HalfEdgeMesh::FirstEdge(triangle) + k;
      EXPECT_EQ(mesh.Mark(edge), expected[edge]);
      hasSome = hasSome || expected[edge] != NoId;
    }
    EXPECT_TRUE(mesh.HasMarks(triangle) || !hasSome);
  }
}

TEST(HalfEdgeMesh, KeepsNoPlaceForTrianglesWithoutMarks)
{
  HalfEdgeMesh mesh = Triangles(10);
  mesh.SetMark(8, NoId);
  EXPECT_FALSE(mesh.HasMarks(2));
  EXPECT_TRUE(mesh.Marks.empty());
  mesh.SetMark(8, 5);
  EXPECT_TRUE(mesh.HasMarks(2));
  EXPECT_FALSE(mesh.HasMarks(1));
  EXPECT_EQ(mesh.Mark(9), NoId) << "of the same triangle";
}

} // namespace biting
