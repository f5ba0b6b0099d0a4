// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Predicates/Predicates.h"
#include "RawMesh.h"
#include "Relaxation/DelaunayMesh.h"
#include "Relaxation/EdgeOperations.h"
#include "Relaxation/MeshExchange.h"

#include <gtest/gtest.h>

#include <utility> // for move

namespace biting
{

namespace
{

/// A mesh at work, with the one that it was read from.
struct Workshop
{
  explicit Workshop(RawMesh raw)
    : Raw(std::move(raw))
    , Mesh(this->Raw.Domain, this->Raw.Spacing)
  {
    this->Mesh.IsDivided.assign(this->Raw.Domain.NumberOfSegments(), 1);
    SilentMonitor monitor;
    Pulse pulse(monitor);
    this->Rest = this->Raw.Mesh;
    this->Origins = ReadMesh(this->Rest, this->Mesh, pulse);
  }

  Workshop(const Workshop&) = delete;

  /// The mesh as it is now.
  RelaxationMesh Written() const
  {
    RelaxationMesh written = this->Rest;
    DelaunayMesh mesh = this->Mesh;
    SilentMonitor monitor;
    Pulse pulse(monitor);
    WriteMesh(mesh, this->Origins, written, pulse);
    return written;
  }

  std::string Violation(bool isDelaunay) const
  {
    return biting::Violation(this->Raw.Domain, this->Written(), isDelaunay);
  }

  RawMesh Raw;
  RelaxationMesh Rest; ///< of the mesh of Raw, once it is read
  DelaunayMesh Mesh;
  std::vector<Id> Origins;
};

bool IsFlippable(const MutableMesh& mesh, Id edge)
{
  const Id twin = mesh.Twins[edge];
  if (twin == NoId || mesh.Marks[edge] != NoId)
  {
    return false;
  }
  const Point2& apex = mesh.Points[mesh.Corners[edge]];
  const Point2& other = mesh.Points[mesh.Corners[twin]];
  return Orient2D(apex, mesh.Points[mesh.Origin(edge)], other) > 0 &&
    Orient2D(apex, other, mesh.Points[mesh.Target(edge)]) > 0;
}

void OperateAnywhere(MutableMesh& mesh, Dice& dice)
{
  const Id edge = dice.Below(mesh.NumberOfEdges());
  if (!mesh.IsEdge(edge))
  {
    return;
  }
  switch (dice.Below(4))
  {
    case 0:
      SplitEdge(mesh, edge);
      break;
    case 1:
      CollapseEdge(mesh, edge);
      break;
    default:
      if (IsFlippable(mesh, edge))
      {
        mesh.Flip(edge);
      }
  }
}

struct Snapshot
{
  explicit Snapshot(const MutableMesh& mesh)
    : Points(mesh.Points)
    , Spacings(mesh.Spacings)
    , Ids{ mesh.Segments, mesh.VertexEdges, mesh.Degrees, mesh.Corners, mesh.Twins, mesh.Marks,
      mesh.Regions }
  {
  }

  bool operator==(const Snapshot& other) const
  {
    return HaveSameBytes(this->Points, other.Points) &&
      HaveSameBytes(this->Spacings, other.Spacings) && this->Ids == other.Ids;
  }

  std::vector<Point2> Points;
  std::vector<double> Spacings;
  std::vector<std::vector<Id>> Ids;
};

void ExpectDegreesCounted(const MutableMesh& mesh)
{
  std::vector<Id> degrees(mesh.Points.size(), 0);
  for (const Id corner : mesh.Corners)
  {
    if (corner != NoId)
    {
      ++degrees[corner];
    }
  }
  for (Id vertex = 0; vertex < mesh.NumberOfVertices(); ++vertex)
  {
    if (mesh.IsAlive(vertex))
    {
      ASSERT_EQ(degrees[vertex], mesh.Degrees[vertex]);
      ASSERT_EQ(mesh.Corners[mesh.VertexEdges[vertex]], vertex);
    }
    else
    {
      ASSERT_EQ(degrees[vertex], 0);
    }
  }
}

} // namespace

TEST(MutableMesh, StaysValidWhateverIsDone)
{
  std::uint64_t seed = 0;
  for (RawMesh& raw : AllRawMeshes())
  {
    Workshop shop(std::move(raw));
    Dice dice(++seed);
    for (int step = 0; step < 2000; ++step)
    {
      OperateAnywhere(shop.Mesh, dice);
      if (step % 100 == 0)
      {
        ASSERT_EQ(shop.Violation(false), "");
        ExpectDegreesCounted(shop.Mesh);
      }
    }
  }
}

TEST(MutableMesh, CollapsesAllThatIsNotBound)
{
  for (RawMesh& raw : AllRawMeshes())
  {
    Workshop shop(std::move(raw));
    for (int round = 0; round < 20; ++round)
    {
      for (Id edge = 0; edge < shop.Mesh.NumberOfEdges(); ++edge)
      {
        if (shop.Mesh.IsEdge(edge))
        {
          CollapseEdge(shop.Mesh, edge);
        }
      }
    }
    ASSERT_EQ(shop.Violation(false), "");
    ExpectDegreesCounted(shop.Mesh);
    const Id left = static_cast<Id>(shop.Written().Points.size());
    EXPECT_LE(left, shop.Raw.Domain.NumberOfVertices() + 3);
  }
}

TEST(MutableMesh, IsTheSameAfterATrialThatIsNotKept)
{
  std::uint64_t seed = 100;
  for (RawMesh& raw : AllRawMeshes())
  {
    Workshop shop(std::move(raw));
    Dice dice(++seed);
    for (int trial = 0; trial < 100; ++trial)
    {
      const Snapshot before(shop.Mesh);
      shop.Mesh.BeginTrial();
      for (int step = 0; step < 20; ++step)
      {
        OperateAnywhere(shop.Mesh, dice);
      }
      shop.Mesh.EndTrial(trial % 10 == 0);
      ASSERT_TRUE(trial % 10 == 0 || Snapshot(shop.Mesh) == before);
    }
    EXPECT_EQ(shop.Violation(false), "");
  }
}

TEST(MutableMesh, KeepsSlidingVerticesOnTheirSegments)
{
  Workshop shop(Plate());
  const Domain& domain = shop.Raw.Domain;
  Dice dice(5);
  for (Id segment = 0; segment < domain.NumberOfSegments(); ++segment)
  {
    const Point2& start = domain.Vertices[domain.Starts[segment]];
    const Point2& end = domain.Vertices[domain.Ends[segment]];
    const Point2 direction = (1.0 / Distance(start, end)) * (end - start);
    for (int k = 0; k < 20; ++k)
    {
      const Point2 place = shop.Mesh.PlaceOnSegment(segment, { dice.Unit(), dice.Unit() });
      EXPECT_LE(std::abs(Cross(direction, place - start)), 0.5 * domain.Resolution);
    }
  }
}

TEST(MutableMesh, ReadsAndWritesTheSameMesh)
{
  for (RawMesh& raw : AllRawMeshes())
  {
    const RelaxationMesh before = raw.Mesh;
    Workshop shop(std::move(raw));
    const RelaxationMesh after = shop.Written();
    EXPECT_TRUE(AreSame(before, after));
  }
}

} // namespace biting
