// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "CorpusIndex.h"
#include "FilterTesting.h"
#include "Kernel/Base/Box.h"
#include "MeshChecker.h"

#include "vtkDataSetReader.h"
#include "vtkStringArray.h"

#include <gtest/gtest.h>

#include <iostream>
#include <map>
#include <set>

using namespace testing_filters;

namespace
{

constexpr vtkIdType MostPoints = 2500; // of an input: the larger ones take seconds

vtkSmartPointer<vtkBitingMesher> MesherOf(vtkPolyData* input, double spacing)
{
  auto mesher = vtkSmartPointer<vtkBitingMesher>::New();
  mesher->SetInputData(input);
  mesher->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "None");
  mesher->SetUniformSpacing(spacing);
  mesher->PreserveBoundaryOn();
  return mesher;
}

vtkSmartPointer<vtkPolyData> ReadPolyData(const std::string& path)
{
  vtkNew<vtkDataSetReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  return vtkPolyData::SafeDownCast(reader->GetOutput());
}

biting::Point2 InPlane(vtkPolyData* data, vtkIdType point)
{
  const Place place = PointOf(data, point);
  return { place[0], place[1] };
}

// The places of input points that lie on the segment, its start and end among them.
std::set<biting::Point2> PlacesOn(
  vtkPolyData* input, const biting::Point2& start, const biting::Point2& end)
{
  biting::Box2 box;
  box.Add(start);
  box.Add(end);
  std::set<biting::Point2> places;
  for (vtkIdType point = 0; point < input->GetNumberOfPoints(); ++point)
  {
    const biting::Point2 place = InPlane(input, point);
    if (box.Contains(place) && biting::Orient2D(start, end, place) == 0)
    {
      places.insert(place);
    }
  }
  return places;
}

// Into how many segments the input divides each of its lines and polygons, by cell id: those
// without a length are none, and a point of the input that lies on a segment divides it.
std::map<vtkIdType, vtkIdType> SegmentsOfCells(vtkPolyData* input)
{
  std::map<vtkIdType, vtkIdType> counts;
  vtkNew<vtkIdList> ids;
  vtkIdType cell = input->GetNumberOfVerts();
  for (vtkCellArray* cells : { input->GetLines(), input->GetPolys() })
  {
    for (vtkIdType k = 0; k < cells->GetNumberOfCells(); ++k, ++cell)
    {
      cells->GetCellAtId(k, ids);
      if (cells == input->GetPolys())
      {
        ids->InsertNextId(ids->GetId(0));
      }
      for (vtkIdType point = 1; point < ids->GetNumberOfIds(); ++point)
      {
        const auto places =
          PlacesOn(input, InPlane(input, ids->GetId(point - 1)), InPlane(input, ids->GetId(point)));
        counts[cell] += static_cast<vtkIdType>(places.size()) - 1;
      }
    }
  }
  return counts;
}

std::map<vtkIdType, vtkIdType> EdgesOfCells(vtkPolyData* edges)
{
  std::map<vtkIdType, vtkIdType> counts;
  vtkDataArray* cells = edges->GetCellData()->GetArray("OriginalCellId");
  for (vtkIdType edge = 0; edge < edges->GetNumberOfCells(); ++edge)
  {
    ++counts[static_cast<vtkIdType>(cells->GetComponent(edge, 0))];
  }
  return counts;
}

vtkIdType VerticesOfKind(vtkPolyData* mesh, double kind)
{
  vtkDataArray* kinds = mesh->GetPointData()->GetArray("VertexKind");
  vtkIdType count = 0;
  for (vtkIdType point = 0; point < mesh->GetNumberOfPoints(); ++point)
  {
    count += kinds->GetComponent(point, 0) == kind ? 1 : 0;
  }
  return count;
}

// A square of four polylines with 1, 2, 4 and 8 segments and tags of two types.
vtkSmartPointer<vtkPolyData> TaggedSquare()
{
  auto input = EmptyInput();
  const std::vector<Place> corners = Rectangle(0.0, 0.0, 1.0, 1.0);
  for (std::size_t side = 0; side < 4; ++side)
  {
    const Place& a = corners[side];
    const Place& b = corners[(side + 1) % 4];
    const int segments = 1 << side;
    std::vector<Place> places;
    for (int k = 0; k <= segments; ++k)
    {
      const double t = static_cast<double>(k) / segments;
      places.push_back({ (1.0 - t) * a[0] + t * b[0], (1.0 - t) * a[1] + t * b[1], 0.0 });
    }
    AddChain(input, places, false);
  }
  AddArray<vtkIntArray>(input->GetCellData(), "Tag", { 7.0, -3.0, 11.0, 5.0 });
  vtkNew<vtkStringArray> names;
  names->SetName("Name");
  for (const char* name : { "inlet", "wall", "outlet", "open" })
  {
    names->InsertNextValue(name);
  }
  input->GetCellData()->AddArray(names);
  return input;
}

} // namespace

TEST(BitingMesherPreserveBoundary, IsOffUnlessAsked)
{
  const auto mesher = MesherOf(UnitSquare(), 0.1);
  EXPECT_TRUE(mesher->GetPreserveBoundary());
  mesher->Update();
  EXPECT_EQ(mesher->GetOutput(1)->GetNumberOfCells(), 4);
  mesher->PreserveBoundaryOff();
  mesher->RelaxationOff(); // which may let vertices come and go
  mesher->Update();
  EXPECT_EQ(mesher->GetOutput(1)->GetNumberOfCells(), 40);
  EXPECT_FALSE(vtkSmartPointer<vtkBitingMesher>::New()->GetPreserveBoundary());
}

TEST(BitingMesherPreserveBoundary, KeepsTagsAndIdsOfEverySegment)
{
  const auto input = TaggedSquare();
  const auto mesher = MesherOf(input, 0.05);
  Messages messages(mesher);
  mesher->Update();
  ASSERT_TRUE(messages.Errors.empty());
  vtkPolyData* edges = mesher->GetOutput(1);
  EXPECT_EQ(EdgesOfCells(edges), SegmentsOfCells(input));
  EXPECT_EQ(VerticesOfKind(mesher->GetOutput(), 1.0), 0);
  vtkDataArray* cells = edges->GetCellData()->GetArray("OriginalCellId");
  vtkDataArray* tags = edges->GetCellData()->GetArray("Tag");
  auto* names = vtkStringArray::SafeDownCast(edges->GetCellData()->GetAbstractArray("Name"));
  auto* inputNames = vtkStringArray::SafeDownCast(input->GetCellData()->GetAbstractArray("Name"));
  ASSERT_TRUE(tags && names);
  for (vtkIdType edge = 0; edge < edges->GetNumberOfCells(); ++edge)
  {
    const auto cell = static_cast<vtkIdType>(cells->GetComponent(edge, 0));
    EXPECT_EQ(
      tags->GetComponent(edge, 0), input->GetCellData()->GetArray("Tag")->GetComponent(cell, 0));
    EXPECT_EQ(names->GetValue(edge), inputNames->GetValue(cell));
  }
}

TEST(BitingMesherPreserveBoundary, ShowsShieldsAmongTheBitesOfEdges)
{
  const auto mesher = MesherOf(TaggedSquare(), 0.05);
  mesher->RelaxationOff();
  mesher->GenerateBitesOn();
  mesher->Update();
  vtkPolyData* bites = mesher->GetOutput(2);
  vtkDataArray* phases = bites->GetCellData()->GetArray("Phase");
  vtkIdType shields = 0;
  for (vtkIdType bite = 0; bite < bites->GetNumberOfCells(); ++bite)
  {
    shields += phases->GetComponent(bite, 0) == 1.0 ? 1 : 0;
  }
  EXPECT_GT(shields, 0);
  EXPECT_EQ(bites->GetNumberOfPolys() - shields, mesher->GetOutput()->GetNumberOfPoints());
}

TEST(BitingMesherPreserveBoundary, HoldsInASpacingSourceOfAnyFineness)
{
  auto input = TaggedSquare();
  AddArray<vtkDoubleArray>(input->GetPointData(), "Spacing", std::vector<double>(19, 1e-3));
  const auto mesher = MesherOf(input, 0.0);
  mesher->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Spacing");
  for (const double scale : { 1.0, 0.1, 1e3 })
  {
    mesher->SetSpacingScale(scale);
    mesher->Update();
    EXPECT_EQ(EdgesOfCells(mesher->GetOutput(1)), SegmentsOfCells(input)) << scale;
    EXPECT_NEAR(AreaOf(mesher->GetOutput()), 1.0, 1e-12) << scale;
    EXPECT_LT(mesher->GetOutput()->GetNumberOfPoints(), 400) << scale;
  }
}

TEST(BitingMesherPreserveBoundary, HoldsForTheSharedCorpus)
{
  const auto entries = SharedEntries({ "V", "W" });
  if (entries.empty())
  {
    std::cout << "No shared inputs: nothing judged.\n";
  }
  for (const CorpusEntry& entry : entries)
  {
    const auto input = ReadPolyData(SharedInputs() + "/" + entry.File);
    if (input->GetNumberOfPoints() > MostPoints)
    {
      continue;
    }
    const auto mesher = MesherOf(input, entry.Spacing);
    Messages messages(mesher);
    mesher->Update();
    ASSERT_TRUE(messages.Errors.empty()) << entry.File << ": " << messages.Errors.front();
    vtkPolyData* mesh = mesher->GetOutput();
    EXPECT_NEAR(AreaOf(mesh), entry.Area, 1e-9 * entry.Area) << entry.File;
    if (messages.Warnings.empty())
    {
      EXPECT_EQ(EdgesOfCells(mesher->GetOutput(1)), SegmentsOfCells(input)) << entry.File;
      EXPECT_EQ(VerticesOfKind(mesh, 1.0), 0) << entry.File;
    }
  }
}
