// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Remeshing/HangingVertices.h"
#include "../Support/MeshShapes.h"
#include "../Support/RemeshLaws.h"
#include "BitingRemesh.h"

#include <gtest/gtest.h>

namespace biting
{

namespace
{

constexpr double RoundingOfSlits = 1e-14;

/// Squares in two triangles each, `count` by `count` of them, turned; with every other triangle
/// turned over.
void AddGrid(const Point2& corner, double size, int count, double degrees, RemeshInput& input)
{
  const auto first = static_cast<Id>(input.Points.size());
  const Point2 along = UnitVector(degrees);
  for (int j = 0; j <= count; ++j)
  {
    for (int i = 0; i <= count; ++i)
    {
      const double x = corner.X + size * i / count;
      const double y = corner.Y + size * j / count;
      input.Points.push_back({ along.X * x - along.Y * y, along.Y * x + along.X * y });
    }
  }
  for (int j = 0; j < count; ++j)
  {
    for (int i = 0; i < count; ++i)
    {
      const Id a = first + j * (count + 1) + i;
      const Id d = a + count + 1;
      input.Corners.insert(input.Corners.end(), { a, a + 1, d + 1, a, d, d + 1 });
    }
  }
}

RemeshInput TwoGrids(int one, int other, double shift, double degrees)
{
  RemeshInput input;
  input.Rounding = RoundingOfSlits;
  AddGrid({ 0.0, 0.0 }, 1.0, one, degrees, input);
  AddGrid({ 1.0, shift }, 1.0, other, degrees, input);
  return input;
}

double LengthOfBoundary(const BitingMesh& mesh)
{
  double length = 0.0;
  for (std::size_t k = 0; k < mesh.EdgeStarts.size(); ++k)
  {
    const double edge = Distance(mesh.Points[mesh.EdgeStarts[k]], mesh.Points[mesh.EdgeEnds[k]]);
    length += mesh.EdgeIsBoundary[k] ? edge : 0.0;
  }
  return length;
}

} // namespace

// Meshes side by side become one, where their vertices are not the same, nor their edges.
TEST(HangingVertices, AreVerticesOfWhatIsMadeOfTheMesh)
{
  for (const auto& [one, other] : { std::make_pair(2, 4), std::make_pair(3, 4), { 1, 40 } })
  {
    for (const double shift : { 0.0, 0.3 })
    {
      for (const double degrees : { 0.0, 20.0, 77.0, 200.0 })
      {
        const RemeshInput input = TwoGrids(one, other, shift, degrees);
        RemeshOptions options;
        options.Values.assign(input.Points.size(), 0.2);
        ProblemList problems;
        const RemeshResult result = Remesh(input, options, problems, NoMonitor());
        ASSERT_FALSE(problems.HasErrors());
        EXPECT_EQ(RemeshLaws(input, result).Violation(), "");
        EXPECT_GE(problems.Count(ProblemCode::Touches), 1);
        EXPECT_NEAR(LengthOfBoundary(result.Mesh), 6.0 + 2.0 * shift, 1e-9);
        EXPECT_GT(result.Mesh.Quality.SmallestAngle, 25.0);
      }
    }
  }
}

TEST(HangingVertices, AreToldByTheirCellsAndPoints)
{
  RemeshInput input = TwoGrids(1, 2, 0.0, 0.0);
  for (Id triangle = 0; triangle < 10; ++triangle)
  {
    input.CellIds.push_back(100 + triangle);
  }
  for (std::size_t point = 0; point < input.Points.size(); ++point)
  {
    input.PointIds.push_back(static_cast<std::int64_t>(200 + point));
  }
  input.Regions = { 1, 1, 2, 2, 2, 2, 2, 2, 2, 2 };
  input.LineStarts = { 1 };
  input.LineEnds = { 3 };
  input.LineCells = { 7 };
  ProblemList problems;
  const OldMesh mesh = ReadOldMesh(input, 0.0, problems, NoMonitor());
  EXPECT_FALSE(problems.Has(ProblemCode::FlatTriangles));
  ASSERT_EQ(problems.Count(ProblemCode::Touches), 1);
  for (const ProblemGroup& group : problems.Groups())
  {
    if (group.Code == ProblemCode::Touches)
    {
      EXPECT_EQ(group.First[0].Ids, (std::vector<std::int64_t>{ 100, 207 }));
    }
  }
  EXPECT_EQ(mesh.NumberOfTriangles(), 11);
  EXPECT_EQ(std::count(mesh.Regions.begin(), mesh.Regions.end(), 1), 3);
  EXPECT_EQ(std::count(mesh.Marks.begin(), mesh.Marks.end(), 1), 4); // both parts of the line
  EXPECT_DOUBLE_EQ(mesh.Area, 2.0);
}

} // namespace biting
