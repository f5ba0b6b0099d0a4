// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "FilterTesting.h"
#include "MeshChecker.h"

#include <gtest/gtest.h>

using namespace testing_filters;

namespace
{

constexpr double Height = 0.4; // of the interface

/// A square of four lines with tags, divided by a fifth, and an embedded point.
vtkSmartPointer<vtkPolyData> DividedSquare()
{
  auto data = EmptyInput();
  const std::vector<Place> corners{ { 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 }, { 1.0, Height, 0.0 },
    { 1.0, 1.0, 0.0 }, { 0.0, 1.0, 0.0 }, { 0.0, Height, 0.0 } };
  AddVertex(data, { 0.7, 0.8, 0.0 });
  for (std::size_t k = 0; k < corners.size(); ++k)
  {
    AddChain(data, { corners[k], corners[(k + 1) % corners.size()] }, false);
  }
  AddChain(data, { corners[5], corners[2] }, false);
  AddArray<vtkIntArray>(data->GetCellData(), "Tag", { 0, 11, 12, 13, 14, 15, 16, 17 });
  return data;
}

vtkSmartPointer<vtkBitingMesher> MesherOf(vtkPolyData* input)
{
  auto mesher = vtkSmartPointer<vtkBitingMesher>::New();
  mesher->SetInputData(input);
  mesher->SetUniformSpacing(0.043);
  mesher->Update();
  return mesher;
}

/// In a plane that is not one of the axes'.
vtkSmartPointer<vtkPolyData> Tilted(vtkPolyData* flat)
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->DeepCopy(flat);
  for (vtkIdType point = 0; point < flat->GetNumberOfPoints(); ++point)
  {
    const Place p = PointOf(flat, point);
    data->GetPoints()->SetPoint(point, 0.6 * p[0] + 3.0, p[1] - 1.0, 0.8 * p[0]);
  }
  return data;
}

void ExpectInputPoints(vtkPolyData* mesh, vtkPolyData* input)
{
  vtkDataArray* ids = mesh->GetPointData()->GetArray("OriginalPointId");
  vtkDataArray* kinds = mesh->GetPointData()->GetArray("VertexKind");
  vtkIdType numberOfEmbedded = 0;
  std::vector<int> isThere(static_cast<std::size_t>(input->GetNumberOfPoints()), 0);
  for (vtkIdType point = 0; point < mesh->GetNumberOfPoints(); ++point)
  {
    const auto original = static_cast<vtkIdType>(ids->GetComponent(point, 0));
    if (original >= 0)
    {
      EXPECT_EQ(PointOf(mesh, point), PointOf(input, original));
      isThere[static_cast<std::size_t>(original)] = 1;
      numberOfEmbedded += kinds->GetComponent(point, 0) == 3.0 ? 1 : 0;
    }
  }
  // The two points of an end that two lines share are one vertex.
  int distinct = 0;
  for (const int count : isThere)
  {
    distinct += count;
  }
  EXPECT_EQ(distinct, 7);
  EXPECT_EQ(numberOfEmbedded, 1);
}

} // namespace

TEST(BitingMesherRelaxation, KeepsSegmentsTagsAndPointsOfTheInput)
{
  const auto input = DividedSquare();
  const auto mesher = MesherOf(input);
  vtkPolyData* mesh = mesher->GetOutput(0);
  vtkPolyData* edges = mesher->GetOutput(1);
  const MeshChecker checker(mesh);
  EXPECT_EQ(checker.CheckValidity(), "");
  EXPECT_EQ(checker.CheckArea(1.0, 1e-12), "");
  ExpectInputPoints(mesh, input);
  vtkDataArray* cells = edges->GetCellData()->GetArray("OriginalCellId");
  vtkDataArray* tags = edges->GetCellData()->GetArray("Tag");
  std::vector<double> lengths(8, 0.0);
  for (vtkIdType edge = 0; edge < edges->GetNumberOfCells(); ++edge)
  {
    vtkNew<vtkIdList> ends;
    edges->GetCellPoints(edge, ends);
    const Place a = PointOf(edges, ends->GetId(0));
    const Place b = PointOf(edges, ends->GetId(1));
    const auto cell = static_cast<std::size_t>(cells->GetComponent(edge, 0));
    EXPECT_EQ(tags->GetComponent(edge, 0), static_cast<double>(10 + cell));
    lengths[cell] += std::hypot(b[0] - a[0], b[1] - a[1]);
  }
  const double wanted[] = { 0.0, 1.0, Height, 1.0 - Height, 1.0, 1.0 - Height, Height, 1.0 };
  for (std::size_t cell = 0; cell < lengths.size(); ++cell)
  {
    EXPECT_NEAR(lengths[cell], wanted[cell], 1e-12) << cell;
  }
}

TEST(BitingMesherRelaxation, KeepsTheAreasOfRegions)
{
  const auto mesher = MesherOf(DividedSquare());
  vtkPolyData* mesh = mesher->GetOutput();
  vtkDataArray* regions = mesh->GetCellData()->GetArray("RegionId");
  double lower = 0.0;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    vtkNew<vtkIdList> ids;
    mesh->GetCellPoints(cell, ids);
    const Place a = PointOf(mesh, ids->GetId(0));
    const Place b = PointOf(mesh, ids->GetId(1));
    const Place c = PointOf(mesh, ids->GetId(2));
    const double area = 0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
    lower += regions->GetComponent(cell, 0) == 0.0 ? area : 0.0;
  }
  EXPECT_NEAR(lower, Height, 1e-12);
}

TEST(BitingMesherRelaxation, KeepsInputPointsBitForBitInAnyPlane)
{
  const auto input = Tilted(DividedSquare());
  ExpectInputPoints(MesherOf(input)->GetOutput(), input);
}

TEST(BitingMesherRelaxation, GivesTheSameBytesAgain)
{
  const auto first = MesherOf(DividedSquare());
  const auto second = MesherOf(DividedSquare());
  EXPECT_TRUE(AreSame(first->GetOutput(0), second->GetOutput(0)));
  EXPECT_TRUE(AreSame(first->GetOutput(1), second->GetOutput(1)));
}

TEST(BitingMesherRelaxation, MakesTheSmallestAngleLarger)
{
  const auto mesher = MesherOf(DividedSquare());
  const double relaxed = Figure(mesher->GetOutput(), "SmallestAngle");
  mesher->RelaxationOff();
  mesher->Update();
  const double raw = Figure(mesher->GetOutput(), "SmallestAngle");
  EXPECT_GT(relaxed, raw + 3.0);
}

TEST(BitingMesherRelaxation, DoesNothingWhereTheNumberOfBitesIsLimited)
{
  const auto mesher = MesherOf(DividedSquare());
  mesher->SetMaximumNumberOfBites(200);
  mesher->Update();
  vtkNew<vtkPolyData> stopped;
  stopped->DeepCopy(mesher->GetOutput());
  mesher->RelaxationOff();
  mesher->Update();
  EXPECT_TRUE(AreSame(stopped, mesher->GetOutput()));
}
