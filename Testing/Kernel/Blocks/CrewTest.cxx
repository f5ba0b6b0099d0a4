// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

// Blocks that several processes share: here they do their work one after the other.

#include "../Support/MeshShapes.h"
#include "../Support/PolylineShapes.h"
#include "../Support/SameMesh.h"

#include "Base/Crew.h"
#include "BitingMesh.h"

#include <gtest/gtest.h>

#include <algorithm>  // for min
#include <functional> // for work
#include <utility>    // for move
#include <vector>     // for bytes

namespace biting
{

namespace
{

using Bytes = std::vector<char>;

/// One of those that are not the first.
class Helper : public Crew
{
public:
  Helper(int own, int size)
    : Number(own)
    , Count(size)
  {
  }

  int Size() const override { return this->Count; }
  int Own() const override { return this->Number; }
  Bytes Receive(int, Monitor&) override { return {}; }
  void Call() override { ADD_FAILURE() << "only the first calls"; }
  void Send(const Bytes& bytes) override
  {
    EXPECT_TRUE(this->Sent.empty());
    this->Sent = bytes;
  }

  Bytes Sent;

private:
  int Number;
  int Count;
};

/// The first one. The others do all of their work when it calls.
class First : public Crew
{
public:
  First(int size, std::function<void(Crew&)> work, std::function<void(int, Bytes&)> spoil)
    : Mail(static_cast<std::size_t>(size))
    , Work(std::move(work))
    , Spoil(std::move(spoil))
  {
  }

  int Size() const override { return static_cast<int>(this->Mail.size()); }
  int Own() const override { return 0; }
  void Send(const Bytes&) override { ADD_FAILURE() << "the first sends nothing"; }

  void Call() override
  {
    ++this->NumberOfCalls;
    for (int member = 1; member < this->Size(); ++member)
    {
      Helper helper(member, this->Size());
      this->Work(helper);
      this->NumberOfBytes += helper.Sent.size();
      this->Spoil(member, helper.Sent);
      this->Mail[static_cast<std::size_t>(member)] = helper.Sent;
    }
  }

  Bytes Receive(int member, Monitor&) override
  {
    return std::move(this->Mail[static_cast<std::size_t>(member)]);
  }

  int NumberOfCalls = 0;
  std::size_t NumberOfBytes = 0; ///< that the others sent

private:
  std::vector<Bytes> Mail;
  std::function<void(Crew&)> Work;
  std::function<void(int, Bytes&)> Spoil;
};

void KeepAll(int, Bytes&) {}

struct Outcome
{
  BitingMesh Mesh;
  ProblemList Problems;
  int NumberOfCalls = 0;
  std::size_t NumberOfBytes = 0;
};

BitingMeshOptions Options(std::int64_t verticesPerBlock)
{
  BitingMeshOptions options;
  options.Spacing = UniformSpacing(0.012);
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

Outcome MeshBy(int members, const BitingMeshOptions& options,
  const std::function<void(int, Bytes&)>& spoil = KeepAll)
{
  const auto help = [&options](Crew& crew)
  {
    ProblemList problems;
    const BitingMesh mesh = MakeBitingMesh(Drawing(), options, problems, NoMonitor(), crew);
    EXPECT_TRUE(mesh.Points.empty());
  };
  First first(members, help, spoil);
  Outcome outcome;
  outcome.Mesh = MakeBitingMesh(Drawing(), options, outcome.Problems, NoMonitor(), first);
  outcome.NumberOfCalls = first.NumberOfCalls;
  outcome.NumberOfBytes = first.NumberOfBytes;
  return outcome;
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
    ExpectSame(shared.Mesh, alone);
    // They have done their share, and sent about 115 bytes a vertex.
    const double bytes = 115.0 * static_cast<double>(alone.Points.size());
    const double share = 1.0 - 1.0 / std::min(members, static_cast<int>(alone.NumberOfBlocks));
    EXPECT_GT(static_cast<double>(shared.NumberOfBytes), 0.7 * share * bytes) << members;
    EXPECT_LT(static_cast<double>(shared.NumberOfBytes), 1.5 * share * bytes) << members;
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
    ExpectSame(shared.Mesh, alone);
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
    ExpectSame(shared.Mesh, alone.Mesh);
  }
}

} // namespace biting
