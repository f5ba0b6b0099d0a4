// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Relaxation/EdgeOperations.h"
#include "RawMesh.h"

#include <gtest/gtest.h>

namespace biting
{

namespace
{

TEST(SplitEdge, PutsAVertexOfFourTrianglesOnTheMiddle)
{
  for (RawMesh& raw : AllRawMeshes())
  {
    Workshop shop(std::move(raw));
    MutableMesh& mesh = shop.Mesh;
    const Id count = mesh.NumberOfEdges();
    for (Id edge = 0; edge < count; edge += 29)
    {
      if (mesh.IsEdge(edge) && mesh.Twins[edge] != NoId && mesh.Marks[edge] == NoId)
      {
        const Point2 middle =
          Midpoint(mesh.Points[mesh.Origin(edge)], mesh.Points[mesh.Target(edge)]);
        const Id vertex = SplitEdge(mesh, edge);
        ASSERT_NE(vertex, NoId);
        EXPECT_EQ(mesh.Points[vertex], middle);
        EXPECT_EQ(mesh.Degrees[vertex], 4);
        EXPECT_EQ(mesh.Freedoms[vertex], Freedom::Free);
      }
    }
    EXPECT_EQ(shop.Violation(false), "");
  }
}

TEST(CollapseEdge, LeavesTheEndThatIsMoreBoundWhereItIs)
{
  int number = 0;
  for (RawMesh& raw : AllRawMeshes())
  {
    Workshop shop(std::move(raw));
    MutableMesh& mesh = shop.Mesh;
    for (Id edge = 0; edge < mesh.NumberOfEdges(); edge += 31)
    {
      const bool isBetween = mesh.IsEdge(edge) &&
        mesh.Freedoms[mesh.Origin(edge)] == Freedom::Free &&
        mesh.Freedoms[mesh.Target(edge)] == Freedom::Fixed;
      const Id bound = isBetween ? mesh.Target(edge) : NoId;
      const Point2 place = isBetween ? mesh.Points[bound] : Point2{};
      const Id kept = isBetween ? CollapseEdge(mesh, edge) : NoId;
      if (kept != NoId)
      {
        EXPECT_EQ(kept, bound);
        EXPECT_EQ(mesh.Points[kept], place);
        ++number;
      }
    }
    EXPECT_EQ(shop.Violation(false), "");
  }
  EXPECT_GT(number, 0);
}

} // namespace

} // namespace biting
