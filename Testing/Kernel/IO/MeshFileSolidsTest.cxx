// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

// Meshes of tetrahedra: what is written is read, and what would be a wrong file is not written.

#include "IO/MeshFile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <sstream>

namespace biting
{

namespace
{

using Place = std::array<double, 3>;

/// A cube of 3 x 3 x 3 cubes of six tetrahedra each, around their diagonals; two regions, with
/// triangles of tag `floor` below and `rock` between them.
MeshFile Brick()
{
  constexpr std::int64_t width = 4;
  MeshFile mesh;
  for (std::int64_t k = 0; k < width * width * width; ++k)
  {
    mesh.Points.push_back({ double(k % width) / 3.0, double(k / width % width) + 1e-9,
      double(k / width / width) - 1e6 });
  }
  mesh.Regions = { { 1, "Region 0" }, { 7, "rock" } };
  mesh.Tags = { { 1, "floor" }, { 5, "between" } };
  constexpr std::int64_t steps[] = { 1, width, width * width };
  for (std::int64_t cube = 0; cube < 27; ++cube)
  {
    const std::int64_t layer = cube / 9;
    const std::int64_t first = cube % 3 + cube / 3 % 3 * width + layer * width * width;
    std::array<std::size_t, 3> axes{ 0, 1, 2 };
    do
    {
      const std::int64_t b = first + steps[axes[0]];
      const std::int64_t c = b + steps[axes[1]];
      mesh.Tetrahedra.push_back({ first, b, c, c + steps[axes[2]] });
      mesh.RegionOfCell.push_back(layer == 0 ? 0 : 1);
      if (axes[2] == 2 && layer < 2)
      {
        mesh.Triangles.push_back({ first, b, c });
        mesh.TagOfSide.push_back(layer == 0 ? 0 : 1);
      }
    } while (std::next_permutation(axes.begin(), axes.end()));
  }
  EXPECT_EQ(OrientTetrahedra(mesh), mesh.Tetrahedra.size());
  return mesh;
}

double Volume(const MeshFile& mesh, const std::array<MeshFile::Vertex, 4>& corners)
{
  const Place& a = mesh.Points[static_cast<std::size_t>(corners[0])];
  std::array<Place, 3> sides{};
  for (std::size_t k = 0; k < 3; ++k)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      sides[k][axis] = mesh.Points[static_cast<std::size_t>(corners[k + 1])][axis] - a[axis];
    }
  }
  const auto& [u, v, w] = sides;
  return (u[0] * (v[1] * w[2] - v[2] * w[1]) + u[1] * (v[2] * w[0] - v[0] * w[2]) +
           u[2] * (v[0] * w[1] - v[1] * w[0])) /
    6.0;
}

/// Cells by the places of their corners, each with the number and name of its group.
template <typename Cells>
auto PlacedCells(const MeshFile& mesh, const Cells& cells, const std::vector<std::size_t>& ofCells,
  const std::vector<MeshGroup>& groups)
{
  std::multiset<std::pair<std::set<Place>, std::pair<std::int64_t, std::string>>> placed;
  for (std::size_t k = 0; k < cells.size(); ++k)
  {
    std::set<Place> places;
    for (const MeshFile::Vertex corner : cells[k])
    {
      places.insert(mesh.Points[static_cast<std::size_t>(corner)]);
    }
    const MeshGroup& group = groups[ofCells[k]];
    placed.insert({ places, { group.Number, group.Name } });
  }
  return placed;
}

auto PlacedTetrahedra(const MeshFile& mesh)
{
  return PlacedCells(mesh, mesh.Tetrahedra, mesh.RegionOfCell, mesh.Regions);
}

auto PlacedTriangles(const MeshFile& mesh)
{
  return PlacedCells(mesh, mesh.Triangles, mesh.TagOfSide, mesh.Tags);
}

const std::string FourNodes = "4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n";

} // namespace

TEST(MeshFileSolids, GmshGivesBackRegionsAndTags)
{
  const MeshFile mesh = Brick();
  std::stringstream stream;
  WriteGmsh(mesh, stream);
  MeshFile back;
  const ReadingResult result = ReadGmsh(stream, back);
  EXPECT_EQ(result.Reason, "");
  EXPECT_TRUE(result.Remarks.empty());
  EXPECT_EQ(PlacedTetrahedra(back), PlacedTetrahedra(mesh));
  EXPECT_EQ(PlacedTriangles(back), PlacedTriangles(mesh));
  EXPECT_TRUE(std::all_of(back.Tetrahedra.begin(), back.Tetrahedra.end(),
    [&back](const auto& corners) { return Volume(back, corners) > 0.0; }));
}

TEST(MeshFileSolids, SU2HasTheWholeBoundaryFromOutsideInMarkers)
{
  const MeshFile mesh = Brick();
  std::stringstream stream;
  WriteSU2(mesh, stream);
  MeshFile back;
  const ReadingResult result = ReadSU2(stream, back);
  EXPECT_EQ(result.Reason, "");
  EXPECT_TRUE(result.Remarks.empty());
  EXPECT_EQ(back.Points, mesh.Points);
  EXPECT_EQ(back.Tetrahedra, mesh.Tetrahedra);
  ASSERT_EQ(back.Tags.size(), 2U);
  EXPECT_EQ(back.Tags[0].Name, "floor");
  EXPECT_EQ(back.Tags[1].Name, "boundary");
  EXPECT_EQ(std::count(back.TagOfSide.begin(), back.TagOfSide.end(), 0U), 18);
  EXPECT_EQ(back.Triangles.size(), 6U * 18U);
  double volume = 0.0;
  MeshFile::Vertex top = 63;
  for (const auto& [a, b, c] : back.Triangles)
  {
    volume -= Volume(back, { a, b, c, top });
  }
  EXPECT_NEAR(volume, 9.0, 1e-5);
}

TEST(MeshFileSolids, TetrahedraAreTurnedAndThoseWithoutVolumeAreFound)
{
  MeshFile mesh = Brick();
  const auto wanted = mesh.Tetrahedra;
  for (auto& corners : mesh.Tetrahedra)
  {
    std::swap(corners[2], corners[3]);
  }
  EXPECT_EQ(OrientTetrahedra(mesh), mesh.Tetrahedra.size());
  EXPECT_EQ(mesh.Tetrahedra, wanted);
  EXPECT_TRUE(IsBoundaryClosed(mesh));
  mesh.Tetrahedra[5] = { 0, 1, 2, 4 };
  EXPECT_EQ(OrientTetrahedra(mesh), 5U);
}

TEST(MeshFileSolids, TetrahedraOnOneSideOfATriangleAreNoMesh)
{
  MeshFile mesh = Brick();
  std::array<MeshFile::Vertex, 4> other = mesh.Tetrahedra.front();
  std::replace(other.begin(), other.end(), other[3], MeshFile::Vertex{ 62 });
  mesh.Tetrahedra.push_back(other);
  EXPECT_EQ(OrientTetrahedra(mesh), mesh.Tetrahedra.size());
  EXPECT_FALSE(IsBoundaryClosed(mesh));
}

TEST(MeshFileSolids, WhatIsBesideTetrahedraIsSaid)
{
  MeshFile mesh;
  std::istringstream file("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n" + FourNodes +
    "$EndNodes\n$Elements\n5\n1 1 2 3 1 1 2\n2 2 2 4 1 1 2 3\n3 2 2 4 1 1 2 3\n"
    "4 3 2 4 1 1 2 3 4\n5 4 2 9 1 1 2 3 4\n$EndElements\n");
  const ReadingResult result = ReadGmsh(file, mesh);
  EXPECT_EQ(result.Reason.substr(0, 7), "Line 16"); // a quad whose sides cross
  for (const bool isQuad : { false, true })
  {
    mesh = MeshFile();
    std::istringstream more("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n5\n" +
      FourNodes.substr(2) + "5 1 1 0\n$EndNodes\n$Elements\n4\n1 1 2 3 1 1 2\n2 2 2 4 1 1 2 3\n" +
      (isQuad ? "3 3 2 4 1 1 2 5 3\n" : "3 2 2 4 1 2 3 1\n") + "4 4 2 9 1 1 2 3 4\n$EndElements\n");
    const ReadingResult said = ReadGmsh(more, mesh);
    EXPECT_EQ(said.Reason, "");
    ASSERT_EQ(said.Remarks.size(), isQuad ? 3U : 2U);
    EXPECT_EQ(said.Remarks[0], "1 edge is left out beside tetrahedra.");
    EXPECT_EQ(said.Remarks.back(),
      isQuad ? "2 triangles are no side of a tetrahedron."
             : "1 cell is listed once more, and read once.");
    EXPECT_EQ(mesh.Tetrahedra.size(), 1U);
    EXPECT_EQ(mesh.Triangles.size(), isQuad ? 3U : 1U);
    EXPECT_EQ(mesh.TagOfSide.size(), mesh.Triangles.size());
    EXPECT_EQ(mesh.Regions[0].Number, 9);
    EXPECT_EQ(mesh.Tags[0].Number, 4);
  }
}

TEST(MeshFileSolids, SU2WithoutMarkersIsReadWithARemark)
{
  std::istringstream file(
    "NDIME= 3\nNELEM= 1\n10 0 1 2 3 0\nNPOIN= 4\n0 0 0 0\n1 0 0 1\n0 1 0 2\n0 0 1 3\n");
  MeshFile mesh;
  const ReadingResult result = ReadSU2(file, mesh);
  EXPECT_EQ(result.Reason, "");
  EXPECT_EQ(result.Remarks.size(), 1U);
  EXPECT_EQ(mesh.Tetrahedra.size(), 1U);
}

TEST(MeshFileSolids, SU2ReadsOrderTwoAndTakesNoTetrahedraInThePlane)
{
  const std::string element = "NELEM= 1\n24 0 1 2 3 4 5 6 7 8 9\n";
  const std::string end = "NPOIN= 10\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n.5 0 0\n.5 .5 0\n0 .5 0\n"
                          "0 0 .5\n.5 0 .5\n0 .5 .5\nNMARK= 1\nMARKER_TAG= a\nMARKER_ELEMS= 1\n"
                          "22 0 1 2 4 5 6\n";
  MeshFile mesh;
  std::istringstream file("NDIME= 3\n" + element + end);
  EXPECT_EQ(ReadSU2(file, mesh).Reason, "");
  EXPECT_EQ(mesh.Points.size(), 4U);
  EXPECT_EQ(mesh.Triangles.size(), 1U);
  for (const std::string& text :
    { "NDIME= 2\n" + element + end, end + element + "NDIME= 3\n", "NDIME= 4\n" + element + end,
      "NDIME= 3\n" + element + end.substr(0, end.size() - 15) + "3 0 1\n" })
  {
    MeshFile none;
    std::istringstream other(text);
    EXPECT_NE(ReadSU2(other, none).Reason, "") << text;
  }
}

} // namespace biting
