// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "FilterTesting.h"

#include "vtkMeshConformity.h"

#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkTable.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <numeric> // for sums

using namespace testing_filters;

namespace
{

constexpr int Points = vtkDataObject::FIELD_ASSOCIATION_POINTS;

double ValueIn(vtkDataSetAttributes* data, const char* name, vtkIdType id)
{
  vtkDataArray* array = data->GetArray(name);
  return array ? array->GetComponent(id, 0) : -1.0;
}

double FigureOf(vtkDataSet* data, const char* name)
{
  vtkDataArray* array = data->GetFieldData()->GetArray(name);
  return array && array->GetNumberOfTuples() == 1 ? array->GetComponent(0, 0) : -1.0;
}

// The unit square as four triangles about its centre, point 4.
vtkSmartPointer<vtkPolyData> FourTriangles(double spacing = 0.5)
{
  auto data = EmptyInput();
  for (const Place& place : Rectangle(0.0, 0.0, 1.0, 1.0))
  {
    data->GetPoints()->InsertNextPoint(place.data());
  }
  data->GetPoints()->InsertNextPoint(0.5, 0.5, 0.0);
  for (vtkIdType k = 0; k < 4; ++k)
  {
    data->GetPolys()->InsertNextCell({ k, (k + 1) % 4, vtkIdType{ 4 } });
  }
  AddArray<vtkDoubleArray>(data->GetPointData(), "Spacing", std::vector<double>(5, spacing));
  return data;
}

vtkSmartPointer<vtkUnstructuredGrid> AsGrid(vtkPolyData* data)
{
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(data->GetPoints());
  grid->SetCells(VTK_TRIANGLE, data->GetPolys());
  grid->GetPointData()->ShallowCopy(data->GetPointData());
  return grid;
}

vtkSmartPointer<vtkImageData> ConstantImage(double spacing)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(2, 2, 1);
  AddArray<vtkDoubleArray>(image->GetPointData(), "Spacing", std::vector<double>(4, spacing));
  return image;
}

bool IsNothing(vtkMeshConformity* filter)
{
  return filter->GetOutput()->GetNumberOfPoints() == 0 &&
    filter->GetHistograms()->GetNumberOfRows() == 0;
}

std::string RefusalOf(vtkDataSet* input, vtkDataSet* source = nullptr)
{
  vtkNew<vtkMeshConformity> filter;
  Messages messages(filter);
  filter->SetInputData(input);
  filter->SetSpacingSourceData(source);
  filter->Update();
  EXPECT_EQ(messages.Errors.size(), 1u);
  EXPECT_TRUE(IsNothing(filter));
  return messages.Errors.empty() ? "" : messages.Errors.front();
}

std::string WarningOf(vtkDataSet* input)
{
  vtkNew<vtkMeshConformity> filter;
  Messages messages(filter);
  filter->SetInputData(input);
  filter->Update();
  EXPECT_TRUE(messages.Errors.empty());
  EXPECT_EQ(messages.Warnings.size(), 1u);
  EXPECT_GT(filter->GetOutput()->GetNumberOfPoints(), 0);
  return messages.Warnings.empty() ? "" : messages.Warnings.front();
}

double SumOf(vtkTable* table, const char* column)
{
  double sum = 0.0;
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    sum += ValueIn(table->GetRowData(), column, row);
  }
  return sum;
}

} // namespace

TEST(MeshConformity, MeasuresWhatIsKnownOfFourTriangles)
{
  vtkNew<vtkMeshConformity> filter;
  Messages messages(filter);
  filter->SetInputData(FourTriangles(0.6));
  filter->Update();
  vtkDataSet* mesh = filter->GetOutput();
  const double half = std::sqrt(0.5);
  for (vtkIdType point = 0; point < 5; ++point)
  {
    EXPECT_EQ(ValueIn(mesh->GetPointData(), "Spacing", point), 0.6);
    EXPECT_DOUBLE_EQ(ValueIn(mesh->GetPointData(), "NearestNeighborDistance", point), half);
    EXPECT_DOUBLE_EQ(ValueIn(mesh->GetPointData(), "Conformity", point), 0.6 / half);
  }
  for (vtkIdType cell = 0; cell < 4; ++cell)
  {
    EXPECT_DOUBLE_EQ(ValueIn(mesh->GetCellData(), "MinimumAngle", cell), 45.0);
    EXPECT_DOUBLE_EQ(ValueIn(mesh->GetCellData(), "RadiusEdgeRatio", cell), half);
    EXPECT_NEAR(ValueIn(mesh->GetCellData(), "AspectRatio", cell), 1.0 + std::sqrt(2.0), 1e-12);
  }
  EXPECT_EQ(FigureOf(mesh, "NumberOfVertices"), 5.0);
  EXPECT_EQ(FigureOf(mesh, "NumberOfTriangles"), 4.0);
  EXPECT_DOUBLE_EQ(FigureOf(mesh, "SmallestAngle"), 45.0);
  EXPECT_DOUBLE_EQ(FigureOf(mesh, "MeanRelativeLength"), (4.0 + 4.0 * half) / 8.0 / 0.6);
  EXPECT_DOUBLE_EQ(FigureOf(mesh, "ShareOfEdgesInBand"), 0.5);
  EXPECT_EQ(FigureOf(mesh, "GivenLipschitz"), 0.0);
  EXPECT_EQ(FigureOf(mesh, "UsedLipschitz"), 0.0);
  EXPECT_TRUE(messages.Errors.empty());
  EXPECT_TRUE(messages.Warnings.empty());
}

TEST(MeshConformity, MeasuresTetrahedraByTheirDihedralAngles)
{
  vtkNew<vtkUnstructuredGrid> grid;
  vtkNew<vtkPoints> points;
  for (const Place& place : { Place{ 1.0, 1.0, 1.0 }, Place{ 1.0, -1.0, -1.0 },
         Place{ -1.0, 1.0, -1.0 }, Place{ -1.0, -1.0, 1.0 }, Place{ 9.0, 9.0, 9.0 } })
  {
    points->InsertNextPoint(place.data());
  }
  grid->SetPoints(points);
  const vtkIdType corners[] = { 0, 1, 2, 3 };
  grid->InsertNextCell(VTK_TRIANGLE, 3, corners);
  grid->InsertNextCell(VTK_TETRA, 4, corners);
  const double length = std::sqrt(8.0);
  AddArray<vtkDoubleArray>(grid->GetPointData(), "Spacing", std::vector<double>(5, 2.0 * length));
  vtkNew<vtkMeshConformity> filter;
  Messages messages(filter);
  filter->SetInputData(grid);
  filter->Update();
  vtkDataSet* mesh = filter->GetOutput();
  EXPECT_NEAR(ValueIn(mesh->GetCellData(), "MinimumDihedralAngle", 1), 70.5287793655, 1e-8);
  EXPECT_TRUE(std::isnan(ValueIn(mesh->GetCellData(), "MinimumDihedralAngle", 0)));
  EXPECT_DOUBLE_EQ(ValueIn(mesh->GetPointData(), "Conformity", 2), 0.5);
  EXPECT_TRUE(std::isnan(ValueIn(mesh->GetPointData(), "Conformity", 4)));
  EXPECT_EQ(FigureOf(mesh, "NumberOfTetrahedra"), 1.0);
  EXPECT_EQ(FigureOf(mesh, "NumberOfVertices"), 4.0);
  EXPECT_EQ(FigureOf(mesh, "NumberOfSlivers"), 0.0);
  EXPECT_DOUBLE_EQ(FigureOf(mesh, "MeanRelativeLength"), 0.5);
  EXPECT_NEAR(SumOf(filter->GetHistograms(), "DihedralAnglePercent"), 100.0, 1e-9);
  EXPECT_TRUE(Has(filter->GetSummary(), "1 tetrahedra"));
  EXPECT_TRUE(messages.Errors.empty() && messages.Warnings.empty());
}

TEST(MeshConformity, JudgesAMeshAsTheMesherItself)
{
  vtkNew<vtkBitingMesher> mesher;
  mesher->SetInputData(UnitSquare());
  mesher->SetUniformSpacing(0.05);
  mesher->Update();
  vtkNew<vtkMeshConformity> filter;
  filter->SetInputConnection(mesher->GetOutputPort());
  filter->Update();
  vtkDataSet* mesh = filter->GetOutput();
  for (const char* name : { "Spacing", "NearestNeighborDistance", "Conformity", "BiteOrder" })
  {
    EXPECT_TRUE(AreSameBytes(
      mesh->GetPointData()->GetArray(name), mesher->GetOutput()->GetPointData()->GetArray(name)))
      << name;
  }
  for (const char* name : { "RegionId", "MinimumAngle", "RadiusEdgeRatio", "AspectRatio" })
  {
    EXPECT_TRUE(AreSameBytes(
      mesh->GetCellData()->GetArray(name), mesher->GetOutput()->GetCellData()->GetArray(name)))
      << name;
  }
  EXPECT_TRUE(AreSameArrays(mesher->GetOutput()->GetFieldData(), mesh->GetFieldData()));
}

TEST(MeshConformity, KeepsTheTypeAndEverythingOfTheInput)
{
  const auto grid = AsGrid(FourTriangles());
  AddArray<vtkDoubleArray>(grid->GetCellData(), "Tag", { 1, 2, 3, 4 });
  AddArray<vtkDoubleArray>(grid->GetFieldData(), "Time", { 7 });
  vtkNew<vtkMeshConformity> filter;
  filter->SetInputData(grid);
  filter->Update();
  vtkDataSet* mesh = filter->GetOutput();
  ASSERT_TRUE(vtkUnstructuredGrid::SafeDownCast(mesh));
  EXPECT_EQ(ValueIn(mesh->GetCellData(), "Tag", 2), 3.0);
  EXPECT_EQ(FigureOf(mesh, "Time"), 7.0);
  EXPECT_DOUBLE_EQ(FigureOf(mesh, "SmallestAngle"), 45.0);
  EXPECT_FALSE(grid->GetPointData()->HasArray("Conformity"));
}

TEST(MeshConformity, DoesNotDependOnThePlaneNorOnTheOrientation)
{
  auto input = FourTriangles();
  for (vtkIdType point = 0; point < 5; ++point)
  {
    const Place place = PointOf(input, point);
    input->GetPoints()->SetPoint(point, 5.0 + 0.6 * place[0], place[1], -3.0 + 0.8 * place[0]);
  }
  vtkNew<vtkCellArray> turned;
  for (vtkIdType k = 0; k < 4; ++k)
  {
    turned->InsertNextCell({ (k + 1) % 4, k, vtkIdType{ 4 } });
  }
  input->SetPolys(turned);
  vtkNew<vtkMeshConformity> filter;
  Messages messages(filter);
  filter->SetInputData(input);
  filter->Update();
  EXPECT_NEAR(FigureOf(filter->GetOutput(), "SmallestAngle"), 45.0, 1e-12);
  EXPECT_NEAR(FigureOf(filter->GetOutput(), "MeanConformity"), std::sqrt(0.5), 1e-12);
  EXPECT_TRUE(messages.Warnings.empty());
}

TEST(MeshConformity, TakesTheSpacingOfASourceWhereThereIsOne)
{
  vtkNew<vtkMeshConformity> filter;
  filter->SetInputData(FourTriangles(0.5));
  filter->SetSpacingSourceData(ConstantImage(std::sqrt(0.5)));
  filter->Update();
  EXPECT_DOUBLE_EQ(FigureOf(filter->GetOutput(), "SmallestConformity"), 1.0);
  EXPECT_DOUBLE_EQ(ValueIn(filter->GetOutput()->GetPointData(), "Spacing", 0), std::sqrt(0.5));
}

TEST(MeshConformity, MeasuresAnEdgeByTheSourceAtItsMiddle)
{
  // Bilinear, x y + 1: at the corners 1, 1, 2, 1; in the centre 1.25.
  const auto image = ConstantImage(1.0);
  image->GetPointData()->GetArray("Spacing")->SetComponent(3, 0, 2.0);
  vtkNew<vtkMeshConformity> filter;
  filter->SetInputData(FourTriangles());
  filter->SetSpacingSourceData(image);
  filter->Update();
  const double half = std::sqrt(0.5);
  const double expected =
    (2.0 + 2.0 / 1.5 + half * (1.0 / 1.0625 + 2.0 / 1.1875 + 1.0 / 1.5625)) / 8.0;
  EXPECT_NEAR(FigureOf(filter->GetOutput(), "MeanRelativeLength"), expected, 1e-12);
}

TEST(MeshConformity, TakesTheArrayThatWasChosen)
{
  const auto input = FourTriangles(0.5);
  AddArray<vtkFloatArray>(input->GetPointData(), "h", { 1, 1, 1, 1, 1 });
  vtkNew<vtkMeshConformity> filter;
  filter->SetInputData(input);
  filter->SetInputArrayToProcess(0, 0, 0, Points, "h");
  filter->Update();
  EXPECT_EQ(ValueIn(filter->GetOutput()->GetPointData(), "Spacing", 0), 1.0);
}

TEST(MeshConformity, FillsHistogramsThatAddUp)
{
  vtkNew<vtkMeshConformity> filter;
  filter->SetInputData(FourTriangles(0.5));
  filter->SetNumberOfBins(36);
  filter->Update();
  vtkTable* table = filter->GetHistograms();
  EXPECT_EQ(table->GetNumberOfRows(), 36);
  EXPECT_EQ(table->GetNumberOfColumns(), 6);
  for (const char* column : { "AnglePercent", "ConformityPercent", "RelativeLengthPercent" })
  {
    EXPECT_NEAR(SumOf(table, column), 100.0, 1e-9) << column;
  }
  EXPECT_EQ(ValueIn(table->GetRowData(), "Angle", 9), 47.5);
  EXPECT_NEAR(ValueIn(table->GetRowData(), "AnglePercent", 9) +
      ValueIn(table->GetRowData(), "AnglePercent", 8),
    200.0 / 3.0, 1e-9);
}

TEST(MeshConformity, PassesOverLinesVerticesAndUnusedPoints)
{
  auto input = FourTriangles();
  AddVertex(input, { 9.0, 9.0, 4.0 });
  AddChain(input, { { 0, 0, 1 }, { 1, 0, 2 } }, false);
  AddArray<vtkDoubleArray>(input->GetPointData(), "Spacing", std::vector<double>(8, 0.5));
  vtkNew<vtkMeshConformity> filter;
  Messages messages(filter);
  filter->SetInputData(input);
  filter->Update();
  vtkDataSet* mesh = filter->GetOutput();
  EXPECT_EQ(FigureOf(mesh, "NumberOfVertices"), 5.0);
  EXPECT_TRUE(std::isnan(ValueIn(mesh->GetPointData(), "Conformity", 5)));
  EXPECT_TRUE(std::isnan(ValueIn(mesh->GetCellData(), "MinimumAngle", 1)));
  EXPECT_DOUBLE_EQ(ValueIn(mesh->GetCellData(), "MinimumAngle", 2), 45.0);
  ASSERT_EQ(messages.Warnings.size(), 1u);
  EXPECT_TRUE(Has(messages.Warnings[0], "no triangle uses (3)"));
}

TEST(MeshConformity, PassesOverGhostCells)
{
  auto input = FourTriangles();
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  for (const int level : { 0, 0, 0, 1 })
  {
    ghosts->InsertNextValue(static_cast<unsigned char>(level));
  }
  input->GetCellData()->AddArray(ghosts);
  vtkNew<vtkMeshConformity> filter;
  filter->SetInputData(input);
  filter->Update();
  EXPECT_EQ(FigureOf(filter->GetOutput(), "NumberOfTriangles"), 3.0);
}

TEST(MeshConformity, WithoutASpacingMeasuresShapesAndSaysSo)
{
  auto input = FourTriangles();
  input->GetPointData()->Initialize();
  EXPECT_TRUE(Has(WarningOf(input), "no spacing"));
  vtkNew<vtkMeshConformity> filter;
  Messages messages(filter);
  filter->SetInputData(input);
  filter->Update();
  vtkDataSet* mesh = filter->GetOutput();
  EXPECT_DOUBLE_EQ(FigureOf(mesh, "SmallestAngle"), 45.0);
  EXPECT_TRUE(mesh->GetPointData()->HasArray("NearestNeighborDistance"));
  EXPECT_FALSE(mesh->GetPointData()->HasArray("Conformity"));
  EXPECT_FALSE(mesh->GetFieldData()->HasArray("MeanConformity"));
  EXPECT_EQ(filter->GetHistograms()->GetNumberOfColumns(), 2);
}

TEST(MeshConformity, WarnsOfWhatIsNoGoodMeshAndMeasuresIt)
{
  auto flat = FourTriangles();
  flat->GetPolys()->InsertNextCell({ vtkIdType{ 0 }, vtkIdType{ 4 }, vtkIdType{ 2 } });
  vtkNew<vtkMeshConformity> filter;
  Messages messages(filter);
  filter->SetInputData(flat);
  filter->Update();
  ASSERT_EQ(messages.Warnings.size(), 2u);
  EXPECT_TRUE(Has(messages.Warnings[0], "without area (1): cell 4 at (0, 0, 0)"));
  EXPECT_TRUE(Has(messages.Warnings[1], "more than two triangles (2)"));
  EXPECT_EQ(FigureOf(filter->GetOutput(), "SmallestAngle"), 0.0);
  EXPECT_TRUE(std::isinf(FigureOf(filter->GetOutput(), "LargestRadiusEdgeRatio")));

  auto folded = FourTriangles();
  folded->GetPolys()->ReplaceCellAtId(2, 3, std::vector<vtkIdType>{ 3, 2, 4 }.data());
  EXPECT_TRUE(Has(WarningOf(folded), "against the majority (1): cell 2"));

  auto torn = FourTriangles();
  torn->GetPoints()->InsertNextPoint(0.5, 0.5, 0.0);
  torn->GetPolys()->ReplaceCellAtId(2, 3, std::vector<vtkIdType>{ 2, 3, 5 }.data());
  AddArray<vtkDoubleArray>(torn->GetPointData(), "Spacing", std::vector<double>(6, 0.5));
  EXPECT_TRUE(Has(WarningOf(torn), "place of others (1): point 5 at (0.5, 0.5, 0)"));
}

TEST(MeshConformity, RefusesOtherCellsAndNamesTheFirst)
{
  auto input = FourTriangles();
  const std::vector<vtkIdType> corners{ 0, 1, 2, 3, 4 };
  input->GetPolys()->InsertNextCell(5, corners.data());
  EXPECT_TRUE(Has(RefusalOf(input), "Cell 4 is a vtkPolygon with 5 points"));
  const auto grid = AsGrid(FourTriangles());
  grid->InsertNextCell(VTK_POLYGON, 5, corners.data());
  EXPECT_TRUE(Has(RefusalOf(grid), "Cell 4 is a vtkPolygon with 5 points"));
  const auto crossing = AsGrid(FourTriangles());
  crossing->InsertNextCell(VTK_QUAD, 4, std::vector<vtkIdType>{ 0, 2, 1, 3 }.data());
  EXPECT_TRUE(Has(RefusalOf(crossing), "Cell 4 is a vtkQuad with 4 points"));
}

TEST(MeshConformity, RefusesWhatCannotBeMeasured)
{
  auto bent = FourTriangles();
  bent->GetPoints()->SetPoint(2, 1.0, 1.0, 0.5);
  EXPECT_TRUE(Has(RefusalOf(bent), "not planar"));
  auto endless = FourTriangles();
  endless->GetPoints()->SetPoint(3, 0.0, std::nan(""), 0.0);
  EXPECT_TRUE(Has(RefusalOf(endless), "not finite (1): point 3"));
  EXPECT_TRUE(Has(RefusalOf(FourTriangles(-1.0)), "zero, negative or not finite (5)"));
  EXPECT_TRUE(Has(RefusalOf(FourTriangles(std::nan(""))), "point 0"));
  EXPECT_TRUE(Has(RefusalOf(FourTriangles(), ConstantImage(0.0)), "zero, negative"));
  auto lines = UnitSquare();
  EXPECT_TRUE(Has(RefusalOf(lines), "no triangles"));
  lines->SetLines(vtkNew<vtkCellArray>());
  EXPECT_TRUE(Has(RefusalOf(lines), "no triangles"));
}

TEST(MeshConformity, RefusesSizesWhoseSquaresAreNoDoubles)
{
  for (const double scale : { 1e154, 1e-160 })
  {
    auto mesh = FourTriangles(0.5 * scale);
    for (vtkIdType point = 0; point < mesh->GetNumberOfPoints(); ++point)
    {
      Place place;
      mesh->GetPoint(point, place.data());
      mesh->GetPoints()->SetPoint(point, scale * place[0], scale * place[1], 0.0);
    }
    EXPECT_TRUE(Has(RefusalOf(mesh), "Scale the input.")) << scale;
  }
}

TEST(MeshConformity, OfAMissingArraySaysItsName)
{
  vtkNew<vtkMeshConformity> filter;
  Messages messages(filter);
  filter->SetInputData(FourTriangles());
  filter->SetInputArrayToProcess(0, 0, 0, Points, "h");
  filter->Update();
  ASSERT_EQ(messages.Errors.size(), 1u);
  EXPECT_TRUE(Has(messages.Errors[0], "no point array named h"));
  EXPECT_TRUE(IsNothing(filter));
}

TEST(MeshConformity, OfNothingIsNothing)
{
  vtkNew<vtkMeshConformity> filter;
  Messages messages(filter);
  filter->SetInputData(EmptyInput());
  filter->Update();
  EXPECT_TRUE(IsNothing(filter));
  filter->SetInputData(vtkNew<vtkUnstructuredGrid>());
  filter->Update();
  EXPECT_TRUE(IsNothing(filter));
  EXPECT_TRUE(messages.Errors.empty());
  EXPECT_TRUE(messages.Warnings.empty());
}

TEST(MeshConformity, LeavesNothingAfterAnAbortAndWorksAgain)
{
  vtkNew<vtkMeshConformity> filter;
  Messages messages(filter);
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback([](vtkObject* caller, unsigned long, void*, void*)
    { vtkAlgorithm::SafeDownCast(caller)->SetAbortExecute(1); });
  const unsigned long tag = filter->AddObserver(vtkCommand::ProgressEvent, stop);
  filter->SetInputData(FourTriangles());
  filter->Update();
  EXPECT_TRUE(IsNothing(filter));
  filter->RemoveObserver(tag);
  filter->Modified();
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 5);
  EXPECT_TRUE(messages.Errors.empty());
}
