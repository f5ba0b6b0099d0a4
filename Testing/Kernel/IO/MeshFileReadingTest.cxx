// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "IO/MeshFile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <sstream>

namespace biting
{

namespace
{

using Reader = ReadingResult (*)(std::istream&, MeshFile&);

/// A file of which is read what it says; `Said` are all sentences.
struct Reading
{
  MeshFile Mesh;
  std::string Reason;
  std::string Said;

  Reading(Reader reader, const std::string& text)
  {
    std::istringstream stream(text);
    const ReadingResult result = reader(stream, this->Mesh);
    this->Reason = result.Reason;
    for (const std::string& remark : result.Remarks)
    {
      this->Said += remark;
    }
  }

  bool Says(const std::string& text) const { return this->Said.find(text) != std::string::npos; }

  std::vector<std::int64_t> Regions() const
  {
    std::vector<std::int64_t> numbers;
    for (const std::size_t region : this->Mesh.RegionOfCell)
    {
      numbers.push_back(this->Mesh.Regions[region].Number);
    }
    return numbers;
  }

  std::vector<std::int64_t> Tags() const
  {
    std::vector<std::int64_t> numbers;
    for (const std::size_t tag : this->Mesh.TagOfSide)
    {
      numbers.push_back(this->Mesh.Tags[tag].Number);
    }
    return numbers;
  }
};

using Triangles = std::vector<std::array<std::int64_t, 3>>;
using Edges = std::vector<std::array<std::int64_t, 2>>;
using Numbers = std::vector<std::int64_t>;

const std::string Square = "4\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n";

std::string Gmsh2(
  const std::string& elements, const std::string& nodes = "$Nodes\n" + Square + "$EndNodes\n")
{
  return "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n2 5 \"all\"\n1 6 \"shore\"\n"
         "$EndPhysicalNames\n" +
    nodes + "$Elements\n" + elements + "$EndElements\n";
}

std::string SU2(const std::string& elements, const std::string& markers)
{
  return "NDIME= 2\n" + elements + "NPOIN= 5\n0 0\n2 0\n2 2\n0 2\n.5 .5\n" + markers;
}

// Two rows of three nodes, which a weir may divide.
std::string ADCIRC(const std::string& boundary, const std::string& first = "1 0 0 5\n")
{
  return "grid\n2 6\n" + first +
    "2 1 0 5\n3 1 1 5\n4 1.1 0 5\n5 2 0 5\n6 1.1 1 5\n1 3 1 2 3\n2 3 4 5 6\n" + boundary;
}

} // namespace

TEST(MeshFileReading, GmshListsACellOnceForEachGroupWhichIsSaid)
{
  const Reading read(ReadGmsh,
    Gmsh2("5\n1 2 2 2 9 1 2 3\n2 2 2 5 9 2 3 1\n3 2 2 5 9 1 3 4\n4 1 2 1 9 1 2\n5 1 2 6 9 2 1\n"));
  EXPECT_EQ(read.Mesh.Triangles, (Triangles{ { 0, 1, 2 }, { 0, 2, 3 } }));
  EXPECT_EQ(read.Regions(), (Numbers{ 2, 5 }));
  EXPECT_EQ(read.Mesh.Edges, (Edges{ { 0, 1 } }));
  EXPECT_EQ(read.Tags(), (Numbers{ 1 }));
  EXPECT_TRUE(read.Says("edges in shore (1), triangles in all (1)")) << read.Said;
}

TEST(MeshFileReading, TheGroupOfARepeatedCellIsTheFirstThatItHas)
{
  const Reading read(ReadGmsh, Gmsh2("2\n1 2 2 0 9 1 2 3\n2 2 2 5 9 1 2 3\n"));
  EXPECT_EQ(read.Regions(), (Numbers{ 5 }));
  EXPECT_TRUE(read.Says("listed once more"));
}

TEST(MeshFileReading, NamesOfGroupsAreNoNamesOfEntities)
{
  const Reading read(ReadGmsh, Gmsh2("1\n1 2 2 0 5 1 2 3\n"));
  EXPECT_EQ(read.Regions(), (Numbers{ 5 }));
  EXPECT_EQ(read.Mesh.Regions[0].Name, "");
}

TEST(MeshFileReading, QuadsAreTwoTrianglesByTheBetterDiagonal)
{
  const std::string quads = "NELEM= 2\n9 0 1 2 3 0\n9 0 1 4 3 1\n";
  const Reading read(ReadSU2, SU2(quads, "NMARK= 0\n"));
  EXPECT_EQ(read.Mesh.Triangles, (Triangles{ { 0, 1, 2 }, { 0, 2, 3 }, { 0, 1, 4 }, { 0, 4, 3 } }));
  EXPECT_TRUE(read.Says("2 quads are divided"));
}

TEST(MeshFileReading, QuadsWithACornerTwiceAreTriangles)
{
  const Reading read(ReadSU2, SU2("NELEM= 3\n9 0 0 1 2\n9 0 2 2 3\n9 1 2 4 1\n", "NMARK= 0\n"));
  EXPECT_EQ(read.Mesh.Triangles, (Triangles{ { 0, 1, 2 }, { 0, 2, 3 }, { 1, 2, 4 } }));
}

TEST(MeshFileReading, QuadsWhoseSidesCrossAreErrorsWithTheLine)
{
  const Reading read(ReadSU2, SU2("NELEM= 1\n9 0 2 1 3\n", "NMARK= 0\n"));
  EXPECT_EQ(read.Reason, "Line 3: the sides of a quad cross each other, or it has no area.");
}

TEST(MeshFileReading, OfCellsOfOrderTwoTheCornersAreRead)
{
  const std::string nodes =
    "$Nodes\n9\n1 0 0 0\n11 .5 0 0\n2 1 0 0\n12 1 .5 0\n3 1 1 0\n13 .5 1 0\n"
    "4 0 1 0\n14 0 .5 0\n15 .5 .5 0\n$EndNodes\n";
  const Reading triangles(ReadGmsh,
    Gmsh2("3\n1 9 2 5 1 1 2 3 11 12 15\n2 9 2 5 1 1 3 4 15 13 14\n3 8 2 6 1 1 2 11\n", nodes));
  EXPECT_EQ(triangles.Mesh.Triangles, (Triangles{ { 0, 1, 2 }, { 0, 2, 3 } }));
  EXPECT_EQ(triangles.Mesh.Edges, (Edges{ { 0, 1 } }));
  EXPECT_EQ(triangles.Mesh.Points.size(), 4U);
  EXPECT_EQ(triangles.Mesh.Points[2], (std::array<double, 3>{ 1, 1, 0 }));
  EXPECT_TRUE(triangles.Says("3 cells are of order 2"));
  for (const char* quad :
    { "1 10 2 5 1 1 2 3 4 11 12 13 14 15\n", "1 16 2 5 1 1 2 3 4 11 12 13 14\n" })
  {
    const Reading read(ReadGmsh, Gmsh2("1\n" + std::string(quad), nodes));
    EXPECT_EQ(read.Mesh.Triangles.size(), 2U) << read.Reason;
    EXPECT_EQ(read.Mesh.Edges.size(), 0U);
  }
}

TEST(MeshFileReading, ParametersOfNodesArePassedOver)
{
  const Reading read(ReadGmsh,
    Gmsh2("1\n1 2 2 5 9 1 2 3\n",
      "$ParametricNodes\n3\n1 0 0 0 1 7 .25\n2 1 0 0 0 3\n3 1 1 0 2 9 .5 "
      ".5\n$EndParametricNodes\n"));
  EXPECT_EQ(read.Mesh.Triangles.size(), 1U) << read.Reason;
}

TEST(MeshFileReading, PartsOfEntitiesHaveTheirGroups)
{
  const std::string begin = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n2 5 \"all\"\n"
                            "$EndPhysicalNames\n$Entities\n0 0 1 0\n1 0 0 0 1 1 0 1 5 0\n"
                            "$EndEntities\n$PartitionedEntities\n2\n1\n7 1\n0 0 2 0\n";
  const std::string end =
    "$EndPartitionedEntities\n$Nodes\n1 4 1 4\n2 2 0 4\n1\n2\n3\n4\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n"
    "$EndNodes\n$Elements\n2 2 1 2\n2 2 2 1\n1 1 2 3\n2 3 2 1\n2 1 3 4\n$EndElements\n";
  const std::string box = " 0 0 0 1 1 0 ";
  const Reading named(
    ReadGmsh, begin + "2 2 1 1 1" + box + "2 5 8 0\n3 2 1 1 2" + box + "1 5 0\n" + end);
  EXPECT_EQ(named.Regions(), (Numbers{ 5, 5 })) << named.Reason;
  EXPECT_EQ(named.Mesh.Regions[0].Name, "all");
  EXPECT_TRUE(named.Says("triangles in 8 (1)"));
  const Reading unnamed(
    ReadGmsh, begin + "2 2 1 1 1" + box + "0 0\n3 2 1 1 2" + box + "0 0\n" + end);
  EXPECT_EQ(unnamed.Regions(), (Numbers{ 1, 1 })) << unnamed.Reason;
}

TEST(MeshFileReading, MarkersOfNumbersThatAreTooLargeAreNumberedFromOneOn)
{
  const std::string cells = "NELEM= 2\n5 0 1 2\n5 0 2 3\n";
  const auto markers = [](const std::string& a, const std::string& b)
  {
    return "NMARK= 2\nMARKER_TAG= " + a + "\nMARKER_ELEMS= 1\n3 0 1\nMARKER_TAG= " + b +
      "\nMARKER_ELEMS= 1\n3 1 2\n";
  };
  EXPECT_EQ(
    Reading(ReadSU2, SU2(cells, markers("7", "2147483647"))).Tags(), (Numbers{ 7, 2147483647 }));
  for (const char* name : { "2147483648", "99999999999999999999", "08", "8 ", "-8", "8a" })
  {
    const Reading read(ReadSU2, SU2(cells, markers("7", name)));
    const bool isNumber = std::string(name) == "8 ";
    EXPECT_EQ(read.Tags(), (isNumber ? Numbers{ 7, 8 } : Numbers{ 1, 2 })) << name;
    EXPECT_EQ(read.Mesh.Tags[1].Name, isNumber ? "8" : name);
  }
}

TEST(MeshFileReading, ASecondMarkerOfAnEdgeIsSaidAndOneOfTheSameNameIsTheSame)
{
  const std::string cells = "NELEM= 2\n5 0 1 2\n5 0 2 3\n";
  const std::string marker = "MARKER_ELEMS= 1\n3 0 1\n";
  const Reading read(ReadSU2,
    SU2(cells,
      "NMARK= 3\nMARKER_TAG= a\n" + marker + "MARKER_TAG= b\n" + marker +
        "MARKER_TAG= a\nMARKER_ELEMS= 1\n3 1 2\n"));
  EXPECT_EQ(read.Tags(), (Numbers{ 1, 1 })) << read.Reason;
  EXPECT_TRUE(read.Says("edges in b (1)"));
}

TEST(MeshFileReading, EdgesThatAreNoSideAreSaid)
{
  const Reading read(ReadSU2,
    SU2("NELEM= 2\n5 0 1 2\n5 0 2 3\n", "NMARK= 1\nMARKER_TAG= a\nMARKER_ELEMS= 1\n3 1 3\n"));
  EXPECT_TRUE(read.Says("1 edge is no side of a triangle"));
}

TEST(MeshFileReading, NumbersOfFortranAreRead)
{
  const Reading read(ReadADCIRC, ADCIRC("", "1,1.5D+02 ,-2d0, +1.E1 a word\n"));
  ASSERT_EQ(read.Mesh.Points.size(), 6U) << read.Reason;
  EXPECT_EQ(read.Mesh.Points[0], (std::array<double, 3>{ 150, -2, 0 }));
  EXPECT_EQ(read.Mesh.Depths[0], 10);
  EXPECT_TRUE(read.Says("no boundaries"));
}

TEST(MeshFileReading, NumbersThatDoNotEndAreErrorsWithTheLine)
{
  for (const char* node :
    { "1 1.5.2 0 5\n", "1 0,,5 6\n", "1 3*0\n", "1 0 0 5!\n", "1.0 0 0 5\n", "1 0 0 1e999\n",
      "1 0 0 nan\n", "1 0 0 0x10\n", "1 0 0 5;\n", "99999999999999999999 0 0 5\n" })
  {
    EXPECT_EQ(Reading(ReadADCIRC, ADCIRC("0\n0\n0\n0\n", node)).Reason,
      "Line 3 is not what it should be: a node.")
      << node;
  }
}

TEST(MeshFileReading, BothSidesOfWeirsHaveATag)
{
  for (const std::string type : { "4", "24", "5", "25", "64" })
  {
    const std::string pipes = type == "5" || type == "25" ? " .5 .1 .2" : "";
    const Reading read(ReadADCIRC,
      ADCIRC("0\n0\n1\n4\n2 " + type + "\n2 4 1.5 1 1" + pipes + "\n3 6 1.5 1 1" + pipes + "\n"));
    EXPECT_EQ(read.Mesh.Edges, (Edges{ { 1, 2 }, { 3, 5 } })) << read.Reason;
    EXPECT_EQ(read.Mesh.Tags[0].Name, "land, type " + type);
    EXPECT_TRUE(read.Says("heights")) << read.Said;
    EXPECT_FALSE(read.Says("the file says")) << read.Said;
  }
}

TEST(MeshFileReading, HeightsOfBarriersAreSaid)
{
  for (const std::string type : { "3", "13", "23" })
  {
    const Reading read(ReadADCIRC, ADCIRC("0\n0\n1\n2\n2 " + type + "\n2 1.5 1\n3 1.5 1\n"));
    EXPECT_EQ(read.Mesh.Edges, (Edges{ { 1, 2 } })) << read.Reason;
    EXPECT_TRUE(read.Says("heights"));
  }
  EXPECT_NE(Reading(ReadADCIRC, ADCIRC("0\n0\n1\n2\n2 -1\n2\n3\n")).Reason, "");
  EXPECT_NE(Reading(ReadADCIRC, ADCIRC("0\n0\n1\n2\n2 24\n2\n3\n")).Reason, "");
}

TEST(MeshFileReading, NumbersOfNodesThatAreNotThoseOfBoundariesAreSaid)
{
  EXPECT_TRUE(Reading(ReadADCIRC, ADCIRC("1\n3\n2\n1\n2\n0\n0\n")).Says("the file says 3"));
  EXPECT_FALSE(Reading(ReadADCIRC, ADCIRC("1\n2\n2\n1\n2\n0\n0\n")).Says("the file says"));
  EXPECT_TRUE(Reading(ReadADCIRC, ADCIRC("0\n0\n0\n0\nrest\n")).Says("from line 15 on"));
}

TEST(MeshFileReading, SectionsThatDoNotEndAreErrors)
{
  const std::string text = Gmsh2("1\n1 2 2 5 9 1 2 3\n");
  const std::string cut = text.substr(0, text.find("$EndElements"));
  EXPECT_EQ(Reading(ReadGmsh, cut).Reason, "The file ends where there should be $EndElements.");
  EXPECT_EQ(Reading(ReadGmsh, text + "$NodeData\n1\n").Reason,
    "The file ends where there should be $EndNodeData.");
}

TEST(MeshFileReading, CardsOfSMSMayComeInAnyOrderAndStringsGoOnInTheNext)
{
  const std::string nodes = "ND 1 0 0 -5\nND 2 1 0 2.5\nND 5 1 1 0\nND 4 0 1 1e1\n";
  const std::string cells = "E4Q 1 1 2 5 4 3\n";
  const Reading read(ReadSMS,
    "MESH2D\nMESHNAME \"a b\"\n" + nodes + cells +
      "NS 1 2\nNS 5 -4 9\nNS 4 -1\nMAT 3 \"the sand\"\nGM \"Mesh\"\n");
  EXPECT_EQ(read.Reason, "");
  EXPECT_EQ(read.Mesh.Triangles.size(), 2U);
  EXPECT_EQ(read.Mesh.Regions[0].Name, "the sand");
  EXPECT_EQ(read.Regions(), (std::vector<std::int64_t>{ 3, 3 }));
  EXPECT_EQ(read.Mesh.Depths, (std::vector<double>{ 5, -2.5, 0, -10 }));
  EXPECT_EQ(read.Mesh.Edges, (Edges{ { 0, 1 }, { 1, 2 }, { 2, 3 }, { 3, 0 } }));
  EXPECT_EQ(read.Tags(), (std::vector<std::int64_t>{ 9, 9, 9, 2 }));
  EXPECT_TRUE(read.Says("left out: 1.")) << read.Said;
  for (const std::string text :
    { "NS 1 2\n", "NS 1 0 -2\n", "NS 1 -2 0\n", "NS 1 -3\n", "E6T 1 1 2 5 4 1 2\n", "ND 7 0 0\n",
      "ND 1 2 0 0\n", "E3T 2 1 2\n", "E3T 2 1 2 5 x\n", "MAT sand\n" })
  {
    EXPECT_NE(Reading(ReadSMS, "MESH2D\n" + cells + nodes + text).Reason, "") << text;
  }
  EXPECT_NE(Reading(ReadSMS, cells + nodes).Reason, "");
}

} // namespace biting
