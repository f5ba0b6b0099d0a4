// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "FilterTesting.h"

#include "vtkDataObject.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <sstream>

using namespace testing_filters;

namespace
{

template <typename ArrayType>
bool HasArray(vtkFieldData* data, const char* name, vtkIdType size)
{
  auto* array = ArrayType::SafeDownCast(data->GetAbstractArray(name));
  return array && array->GetNumberOfComponents() == 1 && array->GetNumberOfTuples() == size;
}

vtkSmartPointer<vtkBitingMesher> MesherOf(vtkPolyData* input)
{
  auto mesher = vtkSmartPointer<vtkBitingMesher>::New();
  mesher->SetInputData(input);
  mesher->SetUniformSpacing(0.1);
  mesher->GenerateBitesOn();
  mesher->Update();
  return mesher;
}

} // namespace

TEST(BitingMesherPorts, AreTwoInAndFourOut)
{
  vtkNew<vtkBitingMesher> mesher;
  EXPECT_EQ(mesher->GetNumberOfInputPorts(), 2);
  EXPECT_EQ(mesher->GetNumberOfOutputPorts(), 4);
  vtkInformation* source = mesher->GetInputPortInformation(1);
  EXPECT_TRUE(source->Get(vtkAlgorithm::INPUT_IS_OPTIONAL()));
  EXPECT_STREQ(source->Get(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE()), "vtkDataSet");
  EXPECT_STREQ(mesher->GetInputPortInformation(0)->Get(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE()),
    "vtkDataSet");
}

TEST(BitingMesherParameters, HaveTheDefaultsThatTheDocumentationStates)
{
  vtkNew<vtkBitingMesher> mesher;
  EXPECT_EQ(mesher->GetUniformSpacing(), 0.0);
  EXPECT_EQ(mesher->GetSpacingScale(), 1.0);
  EXPECT_EQ(mesher->GetMinimumSpacing(), 0.0);
  EXPECT_EQ(mesher->GetMaximumSpacing(), 0.0);
  EXPECT_EQ(mesher->GetGradation(), 0.3);
  EXPECT_TRUE(mesher->GetRepairInput());
  EXPECT_EQ(mesher->GetMergeTolerance(), 0.0);
  EXPECT_EQ(mesher->GetEndTolerance(), 0.01);
  EXPECT_EQ(mesher->GetDomainRule(), vtkBitingMesher::EVEN_ODD);
  EXPECT_FALSE(mesher->GetPreserveBoundary());
  EXPECT_EQ(mesher->GetBiteShape(), vtkBitingMesher::SQUARE);
  EXPECT_EQ(mesher->GetBitingConstant(), 0.0);
  EXPECT_EQ(mesher->GetPlacement(), vtkBitingMesher::BISECTORS);
  EXPECT_EQ(mesher->GetFrontOrder(), vtkBitingMesher::LAYERS);
  EXPECT_EQ(mesher->GetMaximumNumberOfBites(), -1);
  EXPECT_EQ(mesher->GetPhi(), 1.0);
  EXPECT_TRUE(mesher->GetRelaxation());
  EXPECT_EQ(mesher->GetMaximumNumberOfVertices(), 20000000);
  EXPECT_EQ(mesher->GetNumberOfThreads(), 0);
  EXPECT_FALSE(mesher->GetGenerateBites());
}

TEST(BitingMesherParameters, AreAllPrinted)
{
  vtkNew<vtkBitingMesher> mesher;
  mesher->SetFrontOrderToLargestY();
  mesher->SetBiteShapeToSquare();
  mesher->SetPlacementToCorners();
  std::ostringstream text;
  mesher->Print(text);
  for (const char* name :
    { "UniformSpacing: 0", "SpacingScale: 1", "MinimumSpacing: 0", "MaximumSpacing: 0",
      "Gradation: 0.3", "RepairInput: on", "MergeTolerance: 0", "DomainRule: 0",
      "EndTolerance: 0.01", "PreserveBoundary: off", "BiteShape: 0", "BitingConstant: 0",
      "Placement: 0", "FrontOrder: 1", "MaximumNumberOfBites: -1", "Phi: 1", "Relaxation: on",
      "MaximumNumberOfVertices: 20000000", "NumberOfThreads: 0", "GenerateBites: off" })
  {
    EXPECT_TRUE(Has(text.str(), name)) << name;
  }
}

TEST(BitingMesherParameters, BisectorsMakeBetterTrianglesOfSquaresAndOfCircles)
{
  const auto meanSmallestAngle = [](vtkBitingMesher* mesher)
  {
    mesher->SetUniformSpacing(0.03);
    mesher->Update();
    vtkDataArray* angles = mesher->GetOutput(0)->GetCellData()->GetArray("MinimumAngle");
    double sum = 0.0;
    for (vtkIdType cell = 0; cell < angles->GetNumberOfTuples(); ++cell)
    {
      sum += angles->GetComponent(cell, 0);
    }
    return sum / static_cast<double>(angles->GetNumberOfTuples());
  };
  const auto mesher = MesherOf(UnitSquare());
  mesher->RelaxationOff();
  for (const int shape : { vtkBitingMesher::SQUARE, vtkBitingMesher::CIRCLE })
  {
    mesher->SetBiteShape(shape);
    mesher->SetPlacementToCorners();
    const double corners = meanSmallestAngle(mesher);
    mesher->SetPlacementToBisectors();
    EXPECT_GT(meanSmallestAngle(mesher), corners + 2.0);
    mesher->SetFrontOrderToBestFirst();
    EXPECT_GT(meanSmallestAngle(mesher), corners + 2.0);
    mesher->SetFrontOrderToLayers();
  }
}

TEST(BitingMesherBites, CirclesAreDrawnAsPolygonsWith32Corners)
{
  const auto mesher = MesherOf(UnitSquare());
  mesher->SetBiteShapeToCircle();
  mesher->RelaxationOff();
  mesher->GenerateBitesOn();
  mesher->Update();
  vtkPolyData* bites = mesher->GetOutput(2);
  ASSERT_EQ(bites->GetNumberOfPolys(), mesher->GetOutput(0)->GetNumberOfPoints());
  EXPECT_EQ(bites->GetPolys()->GetNumberOfConnectivityIds(), 32 * bites->GetNumberOfPolys());
}

TEST(BitingMesherMesh, CarriesTheDocumentedArrays)
{
  const auto mesher = MesherOf(UnitSquare());
  vtkPolyData* mesh = mesher->GetOutput(0);
  const vtkIdType points = mesh->GetNumberOfPoints();
  const vtkIdType cells = mesh->GetNumberOfCells();
  ASSERT_GT(cells, 100);
  EXPECT_EQ(cells, mesh->GetNumberOfPolys());
  EXPECT_EQ(mesh->GetPointData()->GetNumberOfArrays(), 6);
  EXPECT_TRUE(HasArray<vtkDoubleArray>(mesh->GetPointData(), "Spacing", points));
  EXPECT_TRUE(HasArray<vtkDoubleArray>(mesh->GetPointData(), "NearestNeighborDistance", points));
  EXPECT_TRUE(HasArray<vtkDoubleArray>(mesh->GetPointData(), "Conformity", points));
  EXPECT_TRUE(HasArray<vtkIntArray>(mesh->GetPointData(), "BiteOrder", points));
  EXPECT_TRUE(HasArray<vtkUnsignedCharArray>(mesh->GetPointData(), "VertexKind", points));
  EXPECT_TRUE(HasArray<vtkIdTypeArray>(mesh->GetPointData(), "OriginalPointId", points));
  EXPECT_EQ(mesh->GetCellData()->GetNumberOfArrays(), 4);
  EXPECT_TRUE(HasArray<vtkIntArray>(mesh->GetCellData(), "RegionId", cells));
  EXPECT_TRUE(HasArray<vtkDoubleArray>(mesh->GetCellData(), "MinimumAngle", cells));
  EXPECT_TRUE(HasArray<vtkDoubleArray>(mesh->GetCellData(), "RadiusEdgeRatio", cells));
  EXPECT_TRUE(HasArray<vtkDoubleArray>(mesh->GetCellData(), "AspectRatio", cells));
}

TEST(BitingMesherMesh, CarriesItsSummaryAsFieldData)
{
  const auto mesher = MesherOf(UnitSquare());
  vtkPolyData* mesh = mesher->GetOutput(0);
  EXPECT_EQ(Figure(mesh, "NumberOfVertices"), static_cast<double>(mesh->GetNumberOfPoints()));
  EXPECT_EQ(Figure(mesh, "NumberOfTriangles"), static_cast<double>(mesh->GetNumberOfCells()));
  EXPECT_GT(Figure(mesh, "SmallestAngle"), 10.0);
  EXPECT_LT(Figure(mesh, "LargestRadiusEdgeRatio"), 3.0);
  EXPECT_GT(Figure(mesh, "SmallestConformity"), 0.3);
  EXPECT_GT(Figure(mesh, "MeanConformity"), 0.6);
  EXPECT_NEAR(Figure(mesh, "MeanRelativeLength"), 1.0, 0.15);
  EXPECT_GT(Figure(mesh, "ShareOfEdgesInBand"), 0.7);
  EXPECT_EQ(Figure(mesh, "NumberOfSharpCornerTriangles"), 0.0);
  EXPECT_EQ(Figure(mesh, "GivenLipschitz"), 0.0);
  EXPECT_EQ(Figure(mesh, "UsedLipschitz"), 0.0);
  for (const char* name :
    { "RepairedDuplicatePoints", "RepairedZeroLengthSegments", "RepairedDuplicateSegments",
      "RepairedCrossings", "RepairedTouches", "DroppedOutsidePoints", "DroppedOutsideInterfaces" })
  {
    EXPECT_EQ(Figure(mesh, name), 0.0) << name;
  }
}

TEST(BitingMesherBoundaryEdges, CarryTheDocumentedArrays)
{
  const auto mesher = MesherOf(UnitSquare());
  vtkPolyData* mesh = mesher->GetOutput(0);
  vtkPolyData* edges = mesher->GetOutput(1);
  const vtkIdType cells = edges->GetNumberOfCells();
  ASSERT_GT(cells, 20);
  EXPECT_EQ(cells, edges->GetNumberOfLines());
  EXPECT_TRUE(HasArray<vtkIdTypeArray>(edges->GetCellData(), "OriginalCellId", cells));
  EXPECT_TRUE(HasArray<vtkUnsignedCharArray>(edges->GetCellData(), "Kind", cells));
  ASSERT_TRUE(
    HasArray<vtkIdTypeArray>(edges->GetPointData(), "MeshPointId", edges->GetNumberOfPoints()));
  vtkDataArray* meshIds = edges->GetPointData()->GetArray("MeshPointId");
  for (vtkIdType point = 0; point < edges->GetNumberOfPoints(); ++point)
  {
    const auto meshId = static_cast<vtkIdType>(meshIds->GetComponent(point, 0));
    EXPECT_EQ(PointOf(edges, point), PointOf(mesh, meshId));
  }
}

TEST(BitingMesherBites, AreOnePolygonEachInOrder)
{
  const auto mesher = MesherOf(UnitSquare());
  mesher->RelaxationOff();
  mesher->Update();
  vtkPolyData* bites = mesher->GetOutput(2);
  EXPECT_EQ(bites->GetNumberOfPolys(), mesher->GetOutput(0)->GetNumberOfPoints());
  EXPECT_EQ(bites->GetNumberOfLines(), 0);
  ASSERT_TRUE(
    HasArray<vtkUnsignedCharArray>(bites->GetCellData(), "Phase", bites->GetNumberOfCells()));
  ASSERT_TRUE(HasArray<vtkIntArray>(bites->GetCellData(), "BiteOrder", bites->GetNumberOfCells()));
  vtkDataArray* phase = bites->GetCellData()->GetArray("Phase");
  for (vtkIdType cell = 0; cell < bites->GetNumberOfCells(); ++cell)
  {
    EXPECT_EQ(bites->GetCellData()->GetArray("BiteOrder")->GetComponent(cell, 0),
      static_cast<double>(cell));
    EXPECT_GE(phase->GetComponent(cell, 0), cell == 0 ? 0 : phase->GetComponent(cell - 1, 0));
  }
  EXPECT_EQ(phase->GetComponent(3, 0), 0.0);
  EXPECT_EQ(phase->GetComponent(4, 0), 1.0);
}

TEST(BitingMesherBites, LeaveAFrontWhereBitingIsStopped)
{
  vtkNew<vtkBitingMesher> mesher;
  mesher->SetInputData(UnitSquare());
  mesher->SetUniformSpacing(0.1);
  mesher->SetMaximumNumberOfBites(60);
  mesher->GenerateBitesOn();
  mesher->Update();
  vtkPolyData* bites = mesher->GetOutput(2);
  EXPECT_EQ(bites->GetNumberOfPolys(), 60);
  ASSERT_GT(bites->GetNumberOfLines(), 0);
  vtkDataArray* phase = bites->GetCellData()->GetArray("Phase");
  vtkDataArray* order = bites->GetCellData()->GetArray("BiteOrder");
  for (vtkIdType line = 0; line < bites->GetNumberOfLines(); ++line)
  {
    EXPECT_EQ(phase->GetComponent(line, 0), 3.0);
    EXPECT_EQ(order->GetComponent(line, 0), -1.0);
  }
}

TEST(BitingMesherBites, AreEmptyUnlessTheyAreAskedFor)
{
  vtkNew<vtkBitingMesher> mesher;
  mesher->SetInputData(UnitSquare());
  mesher->Update();
  EXPECT_TRUE(IsEmpty(mesher->GetOutput(2)));
}
