// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "IO/MeshFile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <sstream>

namespace biting
{

namespace
{

constexpr std::size_t Width = 7;

/// A square of cells of two triangles, those that `areThere` has by column and row. The tags of
/// edges are chosen by `tagOf`, a function of their loop and of their number on it.
template <typename AreThere, typename TagOf>
MeshFile LatticeOf(
  const AreThere& areThere, const std::vector<std::string>& tags, const TagOf& tagOf)
{
  MeshFile mesh;
  for (std::size_t k = 0; k < Width * Width; ++k)
  {
    mesh.Points.push_back({ double(k % Width), double(k / Width), 0.0 });
  }
  for (std::int64_t j = 0; j + 1 < std::int64_t(Width); ++j)
  {
    for (std::int64_t i = 0; i + 1 < std::int64_t(Width); ++i)
    {
      const std::int64_t a = j * std::int64_t(Width) + i;
      const std::int64_t c = a + std::int64_t(Width) + 1;
      if (areThere(i, j))
      {
        mesh.Triangles.push_back({ a, a + 1, c });
        mesh.Triangles.push_back({ a, c, c - 1 });
      }
    }
  }
  mesh.RegionOfCell.assign(mesh.Triangles.size(), 0);
  mesh.Regions = { { 1, "" } };
  for (const std::string& name : tags)
  {
    mesh.Tags.push_back({ std::int64_t(mesh.Tags.size()) + 1, name });
  }
  std::size_t loop = 0;
  for (const BoundaryPath& path :
    BoundaryPaths(mesh, std::vector<std::size_t>(mesh.Tags.size() + 1)))
  {
    for (std::size_t k = 1; k < path.Vertices.size(); ++k)
    {
      mesh.Edges.push_back({ path.Vertices[k - 1], path.Vertices[k] });
      mesh.TagOfSide.push_back(tagOf(loop, k - 1));
    }
    ++loop;
  }
  return mesh;
}

/// With an island in the middle of each nine cells.
template <typename TagOf>
MeshFile Lattice(const std::vector<std::string>& tags, const TagOf& tagOf)
{
  return LatticeOf(
    [](std::int64_t i, std::int64_t j) { return i % 3 != 1 || j % 3 != 1; }, tags, tagOf);
}

std::array<std::int64_t, 2> Sorted(std::array<std::int64_t, 2> edge)
{
  std::sort(edge.begin(), edge.end());
  return edge;
}

/// Writes and reads; expects each edge of the boundary once, open where its tag is the first one.
/// Returns the text.
std::string ExpectEdgesBack(const MeshFile& mesh)
{
  std::vector<bool> areOpen(mesh.Tags.size(), false);
  areOpen[0] = true;
  std::stringstream stream;
  WriteADCIRC(mesh, areOpen, stream);
  MeshFile back;
  const ReadingResult result = ReadADCIRC(stream, back);
  EXPECT_EQ(result.Reason, "");
  EXPECT_TRUE(result.Remarks.empty());
  std::map<std::array<std::int64_t, 2>, bool> expected;
  for (std::size_t k = 0; k < mesh.Edges.size(); ++k)
  {
    expected[Sorted(mesh.Edges[k])] = mesh.TagOfSide[k] == 0;
  }
  std::map<std::array<std::int64_t, 2>, bool> found;
  for (std::size_t k = 0; k < back.Edges.size(); ++k)
  {
    found[Sorted(back.Edges[k])] = back.Tags[back.TagOfSide[k]].Number == 1;
  }
  EXPECT_EQ(back.Edges.size(), mesh.Edges.size());
  EXPECT_EQ(found, expected);
  return stream.str();
}

const std::vector<std::string> Tags{ "sea", "land" };

std::string OpenTags(const std::string& names, const std::vector<std::string>& tags)
{
  const MeshFile mesh =
    Lattice(tags, [&tags](std::size_t, std::size_t k) { return k % (tags.size() - 1); });
  std::vector<bool> areOpen;
  const std::string unknown = FindOpenTags(mesh, names, areOpen);
  std::string text = unknown.empty() ? "" : "no " + unknown;
  for (std::size_t tag = 0; unknown.empty() && tag < tags.size(); ++tag)
  {
    text += areOpen[tag] ? "[" + tags[tag] + "]" : "";
  }
  return text;
}

} // namespace

TEST(MeshFileWriting, ADCIRCHasEachEdgeOnceWhereverLoopsAreOpen)
{
  for (std::size_t first = 0; first <= 8; ++first)
  {
    for (std::size_t loops = 1; loops < 32; ++loops)
    {
      ExpectEdgesBack(Lattice(Tags,
        [first, loops](std::size_t loop, std::size_t k)
        { return (loops >> loop) % 2 == 1 && k >= first && k < first + 3 ? 0 : 1; }));
    }
  }
}

TEST(MeshFileWriting, ADCIRCHasNoOpenBoundaryThatIsALoop)
{
  for (std::size_t loops = 1; loops < 32; ++loops)
  {
    const std::string text = ExpectEdgesBack(Lattice(
      Tags, [loops](std::size_t loop, std::size_t) { return (loops >> loop) % 2 == 1 ? 0 : 1; }));
    std::istringstream lines(text.substr(text.find(" = number of open") - 1));
    std::string line;
    std::size_t count = 0;
    lines >> count;
    std::getline(lines, line);
    std::getline(lines, line);
    EXPECT_EQ(count % 2, 0U);
    for (; count > 0; --count)
    {
      std::size_t size = 0;
      lines >> size;
      std::vector<int> nodes(size);
      for (int& node : nodes)
      {
        lines >> node;
      }
      EXPECT_NE(nodes.front(), nodes.back());
    }
  }
}

TEST(MeshFileWriting, ADCIRCHasEachEdgeOnceWhereLoopsTouch)
{
  for (unsigned seed = 1; seed <= 300; ++seed)
  {
    std::mt19937 random(seed);
    ExpectEdgesBack(LatticeOf([&random](std::int64_t i, std::int64_t j)
      { return (i == 0 && j == 0) || random() % 2 == 0; },
      Tags, [&random](std::size_t, std::size_t) { return random() % 4 == 0 ? 1 : 0; }));
  }
}

TEST(MeshFileWriting, ClockwiseTrianglesAreTurned)
{
  MeshFile mesh = Lattice(Tags, [](std::size_t loop, std::size_t) { return loop == 0 ? 0 : 1; });
  const auto wanted = mesh.Triangles;
  for (auto& triangle : mesh.Triangles)
  {
    std::swap(triangle[1], triangle[2]);
  }
  OrientUpwards(mesh);
  EXPECT_EQ(mesh.Triangles, wanted);
  EXPECT_TRUE(IsBoundaryClosed(mesh));
  mesh.Triangles.push_back(mesh.Triangles.front());
  EXPECT_FALSE(IsBoundaryClosed(mesh));
}

TEST(MeshFileWriting, OpenTagsAreWordsOrTagsWithBlanksAndCommas)
{
  EXPECT_EQ(OpenTags("", { "1", "2", "3" }), "");
  EXPECT_EQ(OpenTags(" 2,1 ", { "1", "2", "3" }), "[1][2]");
  EXPECT_EQ(OpenTags("open sea", { "open sea", "c", "none" }), "[open sea]");
  EXPECT_EQ(OpenTags("open sea,c", { "open", "sea", "open sea", "c", "none" }), "[open sea][c]");
  EXPECT_EQ(OpenTags("open c sea", { "open", "sea", "open sea", "c", "none" }), "[open][sea][c]");
  EXPECT_EQ(OpenTags("a, b", { "a, b", "b", "none" }), "[a, b]");
  EXPECT_EQ(OpenTags("12", { "1", "2", "none" }), "no 12");
  EXPECT_EQ(OpenTags("1 99", { "1", "2", "none" }), "no 99");
  EXPECT_EQ(OpenTags("none", { "1", "2", "none" }), "no none"); // on no edge of the boundary
}

TEST(MeshFileWriting, EdgesWithoutATagAreAMarkerOfTheirOwn)
{
  MeshFile mesh = Lattice({ "boundary", "wall" }, [](std::size_t, std::size_t k) { return k % 2; });
  mesh.Edges.pop_back();
  mesh.TagOfSide.pop_back();
  std::stringstream stream;
  WriteSU2(mesh, stream);
  MeshFile back;
  EXPECT_EQ(ReadSU2(stream, back).Reason, "");
  ASSERT_EQ(back.Tags.size(), 3U);
  EXPECT_EQ(back.Tags[2].Name, "boundary_");
}

TEST(MeshFileWriting, SMSHasDepthsMaterialsAndEachTaggedEdgeOnce)
{
  for (unsigned seed = 1; seed <= 100; ++seed)
  {
    std::mt19937 random(seed);
    MeshFile mesh = LatticeOf([&random](std::int64_t i, std::int64_t j)
      { return (i == 0 && j == 0) || random() % 3 > 0; },
      Tags, [&random](std::size_t, std::size_t) { return random() % 8 == 0 ? 1 : 0; });
    mesh.Edges.push_back({ mesh.Triangles[0][0], mesh.Triangles[0][2] }); // an interface
    mesh.TagOfSide.push_back(1);
    mesh.Regions = { { 3, "the sand" }, { 7, "" } };
    for (std::size_t& region : mesh.RegionOfCell)
    {
      region = random() % 2;
    }
    mesh.RegionOfCell[0] = 0;
    for (std::size_t k = 0; k < mesh.Points.size(); ++k)
    {
      mesh.Depths.push_back(k == 0 ? 0.0 : 0.1 * double(random() % 1000) - 30.0);
    }
    std::stringstream stream;
    WriteSMS(mesh, stream);
    MeshFile back;
    const ReadingResult result = ReadSMS(stream, back);
    EXPECT_EQ(result.Reason, "");
    EXPECT_TRUE(result.Remarks.empty());
    EXPECT_EQ(back.Points, mesh.Points);
    EXPECT_EQ(back.Depths, mesh.Depths);
    EXPECT_EQ(back.Triangles, mesh.Triangles);
    for (std::size_t k = 0; k < mesh.Triangles.size(); ++k)
    {
      const MeshGroup& region = back.Regions[back.RegionOfCell[k]];
      EXPECT_EQ(region.Number, mesh.Regions[mesh.RegionOfCell[k]].Number);
      EXPECT_EQ(region.Name, mesh.Regions[mesh.RegionOfCell[k]].Name);
    }
    std::map<std::array<std::int64_t, 2>, std::int64_t> expected;
    std::map<std::array<std::int64_t, 2>, std::int64_t> found;
    for (std::size_t k = 0; k < mesh.Edges.size(); ++k)
    {
      expected[Sorted(mesh.Edges[k])] = mesh.Tags[mesh.TagOfSide[k]].Number;
    }
    for (std::size_t k = 0; k < back.Edges.size(); ++k)
    {
      found[Sorted(back.Edges[k])] = back.Tags[back.TagOfSide[k]].Number;
    }
    EXPECT_EQ(back.Edges.size(), mesh.Edges.size());
    EXPECT_EQ(found, expected);
  }
}

} // namespace biting
