// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

// Points of all kinds, inserted and removed one by one: the topology, the exact regularity, and
// that the triangulation is the one of the vertices left, however they came.

#include "../Predicates/PointFamilies3.h"
#include "SpacePoints.h"

#include <gtest/gtest.h>

#include <cstdlib> // for the wanted number of cases

namespace
{

using namespace space_test;
using biting::CheckTetMesh;
using biting::PointOutcome;
using biting::RegularTriangulation;
using predicates_test::Five;
using predicates_test::TruePowerTest;
using predicates_test::WeightedPoint;

/// BITING_SPACE_CASES asks for more.
int CasesOfFuzz()
{
  const char* wanted = std::getenv("BITING_SPACE_CASES");
  return wanted ? std::atoi(wanted) : 250;
}

struct FuzzPoint
{
  Point3 Place;
  double Weight = 0.0;
};

std::vector<FuzzPoint> RandomPoints(SpaceDice& dice, bool hasWeights)
{
  const auto kind = static_cast<PointKind>(dice.Below(NumberOfPointKinds));
  const int count = 1 + dice.Below(dice.Below(10) == 0 ? 200 : 40);
  const double scale = kind == PointKind::Tiny ? 1e-20 : 0.05 * dice.Unit();
  std::vector<FuzzPoint> points;
  for (int i = 0; i < count; ++i)
  {
    const auto kindOfThis = dice.Below(20) == 0 ? PointKind::Uniform : kind;
    const double weight = dice.Below(3) == 0 ? scale : scale * dice.Unit();
    points.push_back({ RandomPoint(kindOfThis, dice), hasWeights ? weight : 0.0 });
  }
  return points;
}

/// A triangulation, and which of the points its vertices are.
struct Built
{
  RegularTriangulation Triangulation;
  std::vector<FuzzPoint> Vertices;
};

Built Build(const std::vector<FuzzPoint>& points, bool hasWeights, SpaceDice& dice)
{
  Built built{ RegularTriangulation(hasWeights), {} };
  for (const FuzzPoint& point : points)
  {
    const Id hint = built.Vertices.empty() || dice.Below(2) == 0
      ? NoId
      : static_cast<Id>(dice.Below(static_cast<int>(built.Vertices.size())));
    const biting::PointInsertion result =
      built.Triangulation.Insert(point.Place, point.Weight, hint);
    if (result.What == PointOutcome::Duplicate)
    {
      EXPECT_EQ(built.Vertices[TetMesh::Index(result.Vertex)].Place, point.Place);
    }
    else
    {
      EXPECT_EQ(result.Vertex, static_cast<Id>(built.Vertices.size()));
      built.Vertices.push_back(point);
    }
  }
  return built;
}

std::vector<FuzzPoint> WithoutTwins(std::vector<FuzzPoint> points)
{
  std::stable_sort(points.begin(), points.end(),
    [](const FuzzPoint& a, const FuzzPoint& b) { return a.Place < b.Place; });
  points.erase(std::unique(points.begin(), points.end(),
                 [](const FuzzPoint& a, const FuzzPoint& b) { return a.Place == b.Place; }),
    points.end());
  return points;
}

WeightedPoint VertexOf(const TetMesh& mesh, Id vertex)
{
  return { mesh.PointAt(vertex), mesh.WeightAt(vertex) };
}

/// No vertex lies inside the sphere of any cell.
void ExpectEmptySpheres(const TetMesh& mesh)
{
  for (Id cell = 0; cell < mesh.NumberOfSlots(); ++cell)
  {
    const Id* c = &mesh.Corners[TetMesh::Index(4 * cell)];
    for (Id v = 0; v < mesh.NumberOfVertices() && mesh.IsTetrahedron(cell); ++v)
    {
      if (mesh.VertexCells[TetMesh::Index(v)] != NoId)
      {
        const Five five{ VertexOf(mesh, c[0]), VertexOf(mesh, c[1]), VertexOf(mesh, c[2]),
          VertexOf(mesh, c[3]), VertexOf(mesh, v) };
        EXPECT_LE(TruePowerTest(five), 0) << "cell " << cell << ", vertex " << v;
      }
    }
  }
}

/// Removes vertices, some or all; returns what is left.
std::vector<FuzzPoint> RemoveSome(Built& built, SpaceDice& dice)
{
  std::vector<Id> ids(built.Vertices.size());
  for (std::size_t k = 0; k < ids.size(); ++k)
  {
    ids[k] = static_cast<Id>(k);
  }
  dice.Shuffle(ids);
  std::vector<bool> isLeft(ids.size(), true);
  const int most = 1 + dice.Below(static_cast<int>(ids.size()));
  for (int k = 0; k < most; ++k)
  {
    built.Triangulation.Remove(ids[static_cast<std::size_t>(k)]);
    isLeft[TetMesh::Index(ids[static_cast<std::size_t>(k)])] = false;
    if (k % 4 == 0)
    {
      EXPECT_EQ(CheckTetMesh(built.Triangulation.Mesh(), true), "");
    }
  }
  std::vector<FuzzPoint> left;
  for (std::size_t k = 0; k < ids.size(); ++k)
  {
    if (isLeft[k])
    {
      left.push_back(built.Vertices[k]);
    }
  }
  return left;
}

void RunCase(unsigned long long seed)
{
  SpaceDice dice(seed);
  const bool hasWeights = dice.Below(2) == 0;
  std::vector<FuzzPoint> points = WithoutTwins(RandomPoints(dice, hasWeights));
  const std::vector<FuzzPoint> twice(points);
  const bool hasTwin = dice.Below(4) == 0;
  points.insert(points.end(), twice.begin(), twice.begin() + (hasTwin ? 1 : 0));
  dice.Shuffle(points);
  Built built = Build(points, hasWeights, dice);
  EXPECT_EQ(CheckTetMesh(built.Triangulation.Mesh(), true), "");
  dice.Shuffle(points);
  const Built again = Build(points, hasWeights, dice);
  EXPECT_EQ(PlacedCells(built.Triangulation.Mesh()), PlacedCells(again.Triangulation.Mesh()));
  EXPECT_EQ(
    built.Triangulation.HiddenVertices().size(), again.Triangulation.HiddenVertices().size());
  if (seed % 40 == 0 && built.Vertices.size() < 40)
  {
    ExpectEmptySpheres(built.Triangulation.Mesh());
  }
  if (hasTwin)
  {
    return; // which of the two is a vertex, and goes, depends on the order
  }
  const std::vector<FuzzPoint> left = RemoveSome(built, dice);
  EXPECT_EQ(CheckTetMesh(built.Triangulation.Mesh(), true), "");
  EXPECT_EQ(PlacedCells(built.Triangulation.Mesh()),
    PlacedCells(Build(left, hasWeights, dice).Triangulation.Mesh()));
}

} // namespace

TEST(RegularTriangulation, IsThatOfItsVerticesHoweverTheyCameAndWent)
{
  const char* first = std::getenv("BITING_SPACE_FIRST");
  const int begin = first ? std::atoi(first) : 0;
  for (int k = begin; k < begin + CasesOfFuzz() && !HasFailure(); ++k)
  {
    SCOPED_TRACE(k);
    RunCase(static_cast<unsigned long long>(k));
  }
}
