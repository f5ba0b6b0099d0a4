// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

// Blocks that several processes share: here each is a thread.

#include "../Support/MeshShapes.h"
#include "../Support/PolylineShapes.h"
#include "../Support/SameMesh.h"

#include "Base/Crew.h"
#include "BitingMesh.h"
#include "Blocks/ByteStream.h"
#include "ThreadCrew.h"

#include <gtest/gtest.h>

#include <algorithm>  // for max, min
#include <array>      // for corners
#include <cmath>      // for abs
#include <cstdint>    // for ids
#include <functional> // for work
#include <new>        // for bad_alloc
#include <string>     // for violations
#include <utility>    // for move
#include <vector>     // for bytes

namespace biting
{

namespace
{

void KeepAll(int, Bytes&) {}

struct Outcome
{
  BitingMesh Mesh; ///< put together, where it is in pieces
  std::vector<BitingMesh> Pieces;
  ProblemList Problems;
  int NumberOfCalls = 0;
  std::size_t NumberOfBytes = 0;
};

BitingMeshOptions Options(std::int64_t verticesPerBlock, double spacing = 0.012)
{
  BitingMeshOptions options;
  options.Spacing = UniformSpacing(spacing);
  options.VerticesPerBlock = verticesPerBlock;
  return options;
}

Polylines Drawing()
{
  return PolylineBuilder()
    .Box(0.0, 0.0, 1.0, 1.0)
    .Loop(RegularPolygon({ 0.5, 0.5 }, 0.2, 40))
    .Chain({ { 0.0, 0.125 }, { 1.0, 0.125 } })
    .Lines();
}

template <typename Value>
void Place(const std::vector<Value>& from, const std::vector<std::int64_t>& ids,
  const std::vector<std::uint8_t>& areForeign, std::vector<Value>& to)
{
  for (std::size_t k = 0; k < ids.size(); ++k)
  {
    const std::size_t id = static_cast<std::size_t>(ids[k]);
    to.resize(std::max(to.size(), id + 1));
    if (areForeign[k] == 0)
    {
      to[id] = from[k];
    }
  }
}

/// Each vertex and triangle as that member has it whose own it is. Without neighbors.
BitingMesh Unite(const std::vector<BitingMesh>& pieces)
{
  BitingMesh whole = pieces[0];
  whole.Corners.clear();
  whole.Neighbors.clear();
  for (const BitingMesh& piece : pieces)
  {
    const std::vector<std::int64_t>& points = piece.Piece.PointIds;
    const std::vector<std::uint8_t>& foreign = piece.Piece.ForeignPoints;
    const auto place = [&points, &foreign, &piece, &whole](auto member)
    { Place(piece.*member, points, foreign, whole.*member); };
    place(&BitingMesh::Points);
    place(&BitingMesh::Spacing);
    place(&BitingMesh::BiteOrders);
    place(&BitingMesh::Kinds);
    place(&BitingMesh::OriginalPoints);
    Place(piece.Quality.NearestNeighborDistance, points, foreign,
      whole.Quality.NearestNeighborDistance);
    Place(piece.Quality.Conformity, points, foreign, whole.Quality.Conformity);
    std::vector<std::array<Id, 3>> corners;
    for (std::size_t slot = 0; slot < piece.Corners.size(); slot += 3)
    {
      corners.push_back({});
      for (std::size_t k = 0; k < 3; ++k)
      {
        corners.back()[k] =
          static_cast<Id>(points[static_cast<std::size_t>(piece.Corners[slot + k])]);
      }
    }
    const std::vector<std::int64_t>& triangles = piece.Piece.TriangleIds;
    std::vector<std::array<Id, 3>> all;
    for (std::size_t slot = 0; slot < whole.Corners.size(); slot += 3)
    {
      all.push_back({ whole.Corners[slot], whole.Corners[slot + 1], whole.Corners[slot + 2] });
    }
    Place(corners, triangles, piece.Piece.Levels, all);
    whole.Corners.clear();
    for (const std::array<Id, 3>& own : all)
    {
      whole.Corners.insert(whole.Corners.end(), own.begin(), own.end());
    }
    Place(piece.Regions, triangles, piece.Piece.Levels, whole.Regions);
    Place(piece.Quality.MinimumAngle, triangles, piece.Piece.Levels, whole.Quality.MinimumAngle);
    Place(
      piece.Quality.RadiusEdgeRatio, triangles, piece.Piece.Levels, whole.Quality.RadiusEdgeRatio);
    Place(piece.Quality.AspectRatio, triangles, piece.Piece.Levels, whole.Quality.AspectRatio);
  }
  const BitingMesh& border = *pieces[0].Border;
  const auto idOf = [&border](Id vertex)
  { return static_cast<Id>(border.Piece.PointIds[static_cast<std::size_t>(vertex)]); };
  for (std::size_t edge = 0; edge < border.EdgeStarts.size(); ++edge)
  {
    whole.EdgeStarts.push_back(idOf(border.EdgeStarts[edge]));
    whole.EdgeEnds.push_back(idOf(border.EdgeEnds[edge]));
  }
  whole.EdgeCells = border.EdgeCells;
  whole.EdgeIsBoundary = border.EdgeIsBoundary;
  whole.Piece = MeshPiece();
  return whole;
}

Outcome MeshBy(int members, const BitingMeshOptions& options,
  const std::function<void(int, Bytes&)>& spoil = KeepAll, Monitor& monitor = NoMonitor())
{
  const auto help = [&options](Crew& crew)
  {
    ProblemList problems;
    return MakeBitingMesh(Drawing(), options, problems, NoMonitor(), crew);
  };
  First first(members, help, spoil);
  Outcome outcome;
  try
  {
    outcome.Mesh = MakeBitingMesh(Drawing(), options, outcome.Problems, monitor, first);
  }
  catch (const std::bad_alloc&)
  {
    first.End();
    throw;
  }
  first.End();
  outcome.NumberOfCalls = first.NumberOfCalls;
  outcome.NumberOfBytes = first.NumberOfBytes;
  if (outcome.Mesh.Piece.IsPart)
  {
    outcome.Pieces.push_back(outcome.Mesh);
    for (int member = 1; member < members; ++member)
    {
      outcome.Pieces.push_back(first.Of(member).Piece);
    }
    outcome.Mesh = Unite(outcome.Pieces);
  }
  return outcome;
}

// Stops when it is told.
class ToldMonitor : public Monitor
{
public:
  bool Advance(double) override { return !this->IsTold; }
  void BeginStage(const char*) override {}

  bool IsTold = false;
};

// What the check of a piece says, and the area of its own triangles.
Bytes ReportOf(const std::string& violation, double doubledArea)
{
  ByteWriter writer;
  writer.Put(std::vector<char>(violation.begin(), violation.end()));
  writer.Put(doubledArea);
  writer.Put(std::abs(doubledArea));
  return std::move(writer.Bytes);
}

/// But for the neighbors, which pieces do not have.
void ExpectSameWhole(const BitingMesh& mesh, BitingMesh alone)
{
  alone.Neighbors.clear();
  BitingMesh whole = mesh;
  whole.Neighbors.clear();
  ExpectSame(whole, alone);
}

} // namespace

TEST(Crew, TheMeshIsTheSameToTheLastByteForAnyNumberOfMembers)
{
  const BitingMesh alone = MeshBy(1, Options(500)).Mesh;
  ASSERT_GE(alone.NumberOfBlocks, 8);
  for (const int members : { 2, 3, 4, 50 })
  {
    const Outcome shared = MeshBy(members, Options(500));
    EXPECT_EQ(shared.NumberOfCalls, 1);
    ExpectSameWhole(shared.Mesh, alone);
    EXPECT_EQ(shared.Pieces.size(), static_cast<std::size_t>(members));
  }
}

/// Only what lies around the cuts is sent to the first, about 115 bytes a vertex.
TEST(Crew, BlocksStayWithThoseThatMadeThem)
{
  const BitingMeshOptions options = Options(8000, 0.004);
  const BitingMesh alone = MeshBy(1, options).Mesh;
  ASSERT_GE(alone.NumberOfBlocks, 8);
  for (const int members : { 2, 3 })
  {
    const Outcome shared = MeshBy(members, options);
    ASSERT_EQ(shared.Pieces.size(), static_cast<std::size_t>(members));
    ExpectSameWhole(shared.Mesh, alone);
    const double vertices = static_cast<double>(alone.Points.size());
    EXPECT_LT(static_cast<double>(shared.NumberOfBytes), 0.5 * 115.0 * vertices);
    for (const BitingMesh& piece : shared.Pieces)
    {
      EXPECT_LT(static_cast<double>(piece.Points.size()), 1.4 * vertices / members);
    }
  }
}

/// Vertices, triangles and what is measured of them are the same in all pieces that have them.
TEST(Crew, GhostsAreAsTheirOwnersHaveThem)
{
  for (const int levels : { 0, 1, 2 })
  {
    SCOPED_TRACE(levels);
    BitingMeshOptions options = Options(6000, 0.005);
    options.GhostLevels = levels;
    const Outcome shared = MeshBy(3, options);
    ASSERT_EQ(shared.Pieces.size(), 3u);
    for (const BitingMesh& piece : shared.Pieces)
    {
      std::vector<int> counts(3, 0);
      for (std::size_t triangle = 0; triangle < piece.Regions.size(); ++triangle)
      {
        const std::size_t id = static_cast<std::size_t>(piece.Piece.TriangleIds[triangle]);
        ++counts.at(piece.Piece.Levels[triangle]);
        EXPECT_EQ(piece.Quality.MinimumAngle[triangle], shared.Mesh.Quality.MinimumAngle[id]);
        EXPECT_EQ(piece.Regions[triangle], shared.Mesh.Regions[id]);
      }
      for (int level = 0; level < 3; ++level)
      {
        EXPECT_EQ(counts[static_cast<std::size_t>(level)] > 0, level <= levels);
      }
      for (std::size_t vertex = 0; vertex < piece.Points.size(); ++vertex)
      {
        const std::size_t id = static_cast<std::size_t>(piece.Piece.PointIds[vertex]);
        EXPECT_EQ(piece.Quality.NearestNeighborDistance[vertex],
          shared.Mesh.Quality.NearestNeighborDistance[id]);
        EXPECT_EQ(piece.Points[vertex], shared.Mesh.Points[id]);
        EXPECT_EQ(piece.Kinds[vertex], shared.Mesh.Kinds[id]);
      }
    }
  }
}

/// What it holds cannot be made again by then.
TEST(Crew, AMemberThatIsLostAfterItsCollarsIsAnError)
{
  for (int round = 1; round < 3; ++round)
  {
    int number = 0;
    const auto lose = [&number, round](int member, Bytes& bytes)
    {
      if (member == 1 && number++ == round)
      {
        bytes.clear();
      }
    };
    EXPECT_THROW(MeshBy(3, Options(500), lose), std::bad_alloc) << round;
  }
}

TEST(Crew, WhereTheFirstIsStoppedAllAreAndNobodyWaits)
{
  for (int round = 0; round < 2; ++round)
  {
    ToldMonitor monitor;
    int number = 0;
    const auto stop = [&monitor, &number, round](int member, Bytes&)
    { monitor.IsTold = monitor.IsTold || (member == 1 && number++ == round); };
    const Outcome shared = MeshBy(3, Options(500), stop, monitor);
    EXPECT_TRUE(monitor.IsTold) << round;
    EXPECT_TRUE(shared.Problems.Has(ProblemCode::Aborted)) << round;
    EXPECT_TRUE(shared.Mesh.Points.empty()) << round;
  }
}

/// A piece that fails, or areas that do not add up, are known to all; one block is made then.
TEST(Crew, WhatOnePieceViolatesTheWholeDoes)
{
  const BitingMesh whole = MeshBy(1, Options(0)).Mesh;
  for (const bool isArea : { false, true })
  {
    int number = 0;
    const auto report = [&number, isArea](int member, Bytes& bytes)
    {
      if (member == 1 && number++ == 1)
      {
        bytes = isArea ? ReportOf("", 0.25) : ReportOf("it does not fit", 0.0);
      }
    };
    Outcome shared = MeshBy(3, Options(500), report);
    EXPECT_EQ(shared.Mesh.BlocksViolation.find(isArea ? "the area is" : "it does not fit"), 0u);
    EXPECT_TRUE(shared.Pieces.empty());
    ExpectSameWhole(shared.Mesh, whole);
  }
}

TEST(Crew, WhatDoesNotArriveOrIsOfOtherBlocksTheFirstMakesItself)
{
  const BitingMesh alone = MeshBy(1, Options(500)).Mesh;
  const std::vector<std::function<void(int, Bytes&)>> spoils{ //
    [](int, Bytes& bytes) { bytes.clear(); },
    [](int member, Bytes& bytes) { bytes.resize(member == 1 ? bytes.size() / 2 : bytes.size()); },
    [](int member, Bytes& bytes) { bytes[0] = static_cast<char>(bytes[0] + member % 2); },
    [](int, Bytes& bytes) { bytes.push_back(0); }, [](int, Bytes& bytes) { bytes.resize(5); }
  };
  for (std::size_t k = 0; k < spoils.size(); ++k)
  {
    SCOPED_TRACE(k);
    const Outcome shared = MeshBy(3, Options(500), spoils[k]);
    EXPECT_FALSE(shared.Problems.HasErrors());
    ExpectSameWhole(shared.Mesh, alone);
  }
}

TEST(Crew, WithoutBlocksNobodyIsCalled)
{
  const Outcome whole = MeshBy(3, Options(0));
  EXPECT_EQ(whole.NumberOfCalls, 0);
  ExpectSame(whole.Mesh, MeshBy(1, Options(0)).Mesh);
  BitingMeshOptions refused = Options(500);
  refused.Spacing = UniformSpacing(-1.0);
  EXPECT_EQ(MeshBy(3, refused).NumberOfCalls, 0);
}

// The estimate is near enough: a limit just below the vertices is met only where they are counted.
TEST(Crew, SeveralHaveWhatIsTooMuchForOne)
{
  BitingMeshOptions options = Options(8000, 0.004);
  const BitingMesh alone = MeshBy(1, options).Mesh;
  options.MostVerticesOfProcess = 3 * static_cast<std::int64_t>(alone.Points.size()) / 5;
  EXPECT_EQ(MeshBy(1, options).Problems.Count(ProblemCode::TooManyVertices), 1);
  for (const int members : { 2, 3 })
  {
    const Outcome shared = MeshBy(members, options);
    EXPECT_FALSE(shared.Problems.HasErrors());
    EXPECT_EQ(shared.Pieces.size(), static_cast<std::size_t>(members));
    ExpectSameWhole(shared.Mesh, alone);
  }
}

/// Nobody is called where a share alone is too much; where collars are, those who wait go home.
TEST(Crew, WhatIsTooMuchForSeveralIsRefusedOnce)
{
  BitingMeshOptions options = Options(8000, 0.004);
  const std::int64_t vertices = static_cast<std::int64_t>(MeshBy(1, options).Mesh.Points.size());
  options.MostVerticesOfProcess = vertices / 3;
  const Outcome shares = MeshBy(2, options);
  EXPECT_EQ(shares.Problems.Count(ProblemCode::TooManyVertices), 1);
  EXPECT_EQ(shares.NumberOfCalls, 0);
  EXPECT_TRUE(shares.Mesh.Points.empty());
  options.VerticesPerBlock = 500;
  options.MostVerticesOfProcess = 3 * vertices / 5;
  const Outcome collars = MeshBy(3, options);
  EXPECT_EQ(collars.Problems.Count(ProblemCode::TooManyVertices), 1);
  EXPECT_EQ(collars.NumberOfCalls, 1);
  EXPECT_TRUE(collars.Mesh.Points.empty());
}

TEST(Crew, TooManyVerticesAreRefusedAsByOneMember)
{
  BitingMeshOptions options = Options(500);
  const Id vertices = static_cast<Id>(MeshBy(1, options).Mesh.Points.size());
  for (const double share : { 0.9, 0.97, 0.99, 1.0, 1.03 })
  {
    options.MaximumNumberOfVertices = static_cast<std::int64_t>(share * vertices);
    const Outcome alone = MeshBy(1, options);
    const Outcome shared = MeshBy(3, options);
    EXPECT_EQ(shared.Problems.HasErrors(), alone.Problems.HasErrors()) << share;
    EXPECT_EQ(shared.Problems.Count(ProblemCode::TooManyVertices),
      alone.Problems.Count(ProblemCode::TooManyVertices));
    ExpectSameWhole(shared.Mesh, alone.Mesh);
  }
}

} // namespace biting
