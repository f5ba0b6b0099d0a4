// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

// What comes along with a drawing and a source: values of cells, values of points.

#include "FilterTesting.h"

#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <cmath>      // for distances
#include <functional> // for what is expected
#include <set>        // for what is there

using namespace testing_filters;

namespace
{

void AddPolygon(vtkPolyData* data, const std::vector<Place>& places)
{
  std::vector<vtkIdType> ids;
  ids.reserve(places.size());
  for (const Place& place : places)
  {
    ids.push_back(data->GetPoints()->InsertNextPoint(place.data()));
  }
  data->GetPolys()->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
}

void AddTexts(vtkPolyData* data, const char* name, const std::vector<const char*>& texts)
{
  vtkNew<vtkStringArray> array;
  array->SetName(name);
  for (const char* text : texts)
  {
    array->InsertNextValue(text);
  }
  data->GetCellData()->AddArray(array);
}

/// A square of 8 with squares of 6 and of 2 inside, each of two arrays.
vtkSmartPointer<vtkPolyData> NestedSquares()
{
  auto data = EmptyInput();
  AddPolygon(data, Rectangle(0, 0, 8, 8));
  AddPolygon(data, Rectangle(3, 3, 5, 5));
  AddPolygon(data, Rectangle(1, 1, 7, 7));
  AddArray<vtkIntArray>(data->GetCellData(), "Tag", { 10, 30, 20 });
  AddTexts(data, "Name", { "sea", "island", "lake" });
  return data;
}

vtkSmartPointer<vtkBitingMesher> MesherOf(vtkPolyData* data, double spacing)
{
  auto mesher = vtkSmartPointer<vtkBitingMesher>::New();
  mesher->SetInputData(data);
  mesher->SetUniformSpacing(spacing);
  return mesher;
}

/// Compares the text of an array at each triangle with that of the middle of the triangle.
void ExpectAtMiddles(vtkPolyData* mesh, const char* name,
  const std::function<std::string(double x, double y)>& expected)
{
  vtkAbstractArray* array = mesh->GetCellData()->GetAbstractArray(name);
  ASSERT_NE(array, nullptr) << name;
  ASSERT_GT(mesh->GetNumberOfCells(), 0);
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    mesh->GetCellPoints(cell, corners);
    Place middle{};
    for (vtkIdType k = 0; k < 3; ++k)
    {
      middle[0] += mesh->GetPoint(corners->GetId(k))[0] / 3.0;
      middle[1] += mesh->GetPoint(corners->GetId(k))[1] / 3.0;
    }
    ASSERT_EQ(array->GetVariantValue(cell * array->GetNumberOfComponents()).ToString(),
      expected(middle[0], middle[1]))
      << middle[0] << " " << middle[1];
  }
}

bool IsWithin(double low, double high, double x, double y)
{
  return low < x && x < high && low < y && y < high;
}

} // namespace

TEST(BitingMesherValues, OfCellsAreOnTheTrianglesOfTheirArea)
{
  auto data = EmptyInput();
  AddPolygon(data, Rectangle(0, 0, 1, 3));
  AddPolygon(data, Rectangle(1, 0, 4, 3));
  AddArray<vtkDoubleArray>(data->GetCellData(), "Conductivity", { 0.5, 2.5 });
  AddArray<vtkDoubleArray>(data->GetCellData(), "MinimumAngle", { 1, 2 });
  AddTexts(data, "Name", { "west", "east" });
  data->GetCellData()->SetActiveGlobalIds("Conductivity");
  for (const bool isKept : { false, true })
  {
    const auto mesher = MesherOf(data, 0.4);
    mesher->SetKeepCellEdges(isKept);
    mesher->Update();
    vtkPolyData* mesh = mesher->GetOutput();
    ExpectAtMiddles(mesh, "Name", [](double x, double) { return x < 1 ? "west" : "east"; });
    ExpectAtMiddles(mesh, "Conductivity", [](double x, double) { return x < 1 ? "0.5" : "2.5"; });
    EXPECT_EQ(mesh->GetCellData()->GetGlobalIds(), nullptr);
    EXPECT_GT(mesh->GetCellData()->GetArray("MinimumAngle")->GetRange()[0], 10) << "ours";
  }
}

TEST(BitingMesherValues, OfNestedCellsAreThoseOfTheInnermostByEvenOddAndOfTheLastInAUnion)
{
  const auto mesher = MesherOf(NestedSquares(), 0.4);
  Messages messages(mesher);
  mesher->Update();
  ExpectAtMiddles(mesher->GetOutput(), "Name",
    [](double x, double y) { return IsWithin(3, 5, x, y) ? "island" : "sea"; });
  mesher->SetDomainRuleToUnion();
  mesher->Update();
  const auto uppermost = [](double x, double y) { return IsWithin(1, 7, x, y) ? "20" : "10"; };
  ExpectAtMiddles(mesher->GetOutput(), "Tag", uppermost);
  mesher->SetDomainRuleToOuterMinusOthers();
  mesher->Update();
  ExpectAtMiddles(mesher->GetOutput(), "Tag", [](double, double) { return "10"; });
}

TEST(BitingMesherValues, OfLoopsOfLinesAreOnEdgesOnly)
{
  auto data = UnitSquare();
  AddArray<vtkIntArray>(data->GetCellData(), "Tag", { 7 });
  const auto mesher = MesherOf(data, 0.2);
  mesher->Update();
  EXPECT_EQ(mesher->GetOutput()->GetCellData()->GetAbstractArray("Tag"), nullptr);
  EXPECT_NE(mesher->GetOutput(1)->GetCellData()->GetAbstractArray("Tag"), nullptr);
}

// A disk in a square: a coarse interface leaves middles of triangles to the other polygon.
TEST(BitingMesherValues, AreThoseOfTheRegionBesideASimplifiedInterface)
{
  auto data = EmptyInput();
  AddPolygon(data, Rectangle(-3, -3, 3, 3));
  std::vector<Place> disk;
  constexpr int Corners = 200;
  for (int k = 0; k < Corners; ++k)
  {
    const double angle = 2.0 * 3.14159265358979 * k / Corners;
    disk.push_back({ 2.0 * std::cos(angle), 2.0 * std::sin(angle), 0.0 });
  }
  AddPolygon(data, disk);
  AddArray<vtkIntArray>(data->GetCellData(), "Tag", { 1, 2 });
  const auto mesher = MesherOf(data, 1.0);
  mesher->SetDomainRuleToUnion();
  mesher->SetRegionArray("Tag");
  mesher->SetBoundaryTolerance(0.5);
  mesher->Update();
  vtkCellData* cells = mesher->GetOutput()->GetCellData();
  std::set<std::pair<double, double>> pairs;
  for (vtkIdType cell = 0; cell < mesher->GetOutput()->GetNumberOfCells(); ++cell)
  {
    pairs.emplace(
      cells->GetArray("RegionId")->GetTuple1(cell), cells->GetArray("Tag")->GetTuple1(cell));
  }
  EXPECT_EQ(pairs.size(), 2u);
}

namespace
{

/// x + 2 y, its sign as a whole number, and twice a vector of floats, at the points of `source`.
void AddFields(vtkDataSet* source)
{
  vtkNew<vtkDoubleArray> depth;
  vtkNew<vtkIntArray> side;
  vtkNew<vtkFloatArray> flow;
  vtkNew<vtkDoubleArray> spacing;
  depth->SetName("Depth");
  side->SetName("Side");
  flow->SetName("Flow");
  spacing->SetName("Spacing");
  flow->SetNumberOfComponents(2);
  for (vtkIdType point = 0; point < source->GetNumberOfPoints(); ++point)
  {
    const double* place = source->GetPoint(point);
    const double value = place[0] + 2.0 * place[1];
    depth->InsertNextValue(value);
    side->InsertNextValue(value > 1.5 ? 1 : -1);
    flow->InsertNextTuple2(value, -value);
    spacing->InsertNextValue(0.2);
  }
  for (vtkDataArray* array : { static_cast<vtkDataArray*>(depth), static_cast<vtkDataArray*>(side),
         static_cast<vtkDataArray*>(flow), static_cast<vtkDataArray*>(spacing) })
  {
    source->GetPointData()->AddArray(array);
  }
}

/// Over [0, width] x [-1, 2] at level z.
vtkSmartPointer<vtkImageData> ImageSource(double width, double z = 0.0, int layers = 1)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(9, 13, layers);
  image->SetOrigin(0, -1, z);
  image->SetSpacing(width / 8.0, 0.25, 1.0);
  AddFields(image);
  return image;
}

vtkSmartPointer<vtkUnstructuredGrid> AsCells(vtkDataSet* source)
{
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (vtkIdType point = 0; point < source->GetNumberOfPoints(); ++point)
  {
    points->InsertNextPoint(source->GetPoint(point));
  }
  grid->SetPoints(points);
  for (vtkIdType cell = 0; cell < source->GetNumberOfCells(); ++cell)
  {
    vtkNew<vtkIdList> corners;
    source->GetCellPoints(cell, corners);
    grid->InsertNextCell(source->GetCellType(cell), corners);
  }
  AddFields(grid);
  return grid;
}

/// The unit square with a source that reaches to x = width; all values are right.
void ExpectTransferred(vtkDataObject* source, double width, double tolerance = 1e-12)
{
  const auto mesher = MesherOf(UnitSquare(), 0.1);
  mesher->SetInputDataObject(1, source);
  Messages messages(mesher);
  mesher->Update();
  EXPECT_TRUE(messages.Errors.empty());
  vtkPolyData* mesh = mesher->GetOutput();
  vtkPointData* data = mesh->GetPointData();
  for (const char* name : { "Depth", "Side", "Flow", "vtkValidPointMask" })
  {
    ASSERT_NE(data->GetArray(name), nullptr) << name;
  }
  EXPECT_NE(vtkFloatArray::SafeDownCast(data->GetArray("Flow")), nullptr);
  ASSERT_GT(mesh->GetNumberOfPoints(), 50);
  for (vtkIdType point = 0; point < mesh->GetNumberOfPoints(); ++point)
  {
    const double x = std::min(mesh->GetPoint(point)[0], width);
    const double value = x + 2.0 * mesh->GetPoint(point)[1];
    ASSERT_NEAR(data->GetArray("Depth")->GetTuple1(point), value, tolerance);
    ASSERT_NEAR(data->GetArray("Flow")->GetComponent(point, 1), -value, 1e-6);
    ASSERT_EQ(std::abs(data->GetArray("Side")->GetTuple1(point)), 1.0);
    ASSERT_EQ(data->GetArray("vtkValidPointMask")->GetTuple1(point),
      mesh->GetPoint(point)[0] <= width + 1e-9 ? 1.0 : 0.0);
  }
  EXPECT_LT(data->GetArray("Spacing")->GetRange()[1], 0.11) << "ours";
}

} // namespace

TEST(BitingMesherValues, OfSourcesOfAllKindsAreInterpolatedAtTheVertices)
{
  for (const double width : { 1.0, 0.5 })
  {
    ExpectTransferred(ImageSource(width), width);
    ExpectTransferred(AsCells(ImageSource(width)), width);
    ExpectTransferred(AsCells(ImageSource(width, -0.5, 2)), width);
  }
}

TEST(BitingMesherValues, OfBlocksOfASourceAreThoseOfTheBlockAround)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  const auto image = ImageSource(0.5);
  const auto other = AsCells(ImageSource(0.25));
  for (vtkIdType point = 0; point < other->GetNumberOfPoints(); ++point)
  {
    double place[3];
    other->GetPoint(point, place);
    other->GetPoints()->SetPoint(point, place[0] + 0.5, place[1], place[2]);
  }
  AddFields(other);
  blocks->SetBlock(0, image);
  blocks->SetBlock(1, other);
  ExpectTransferred(blocks, 0.75);
}

TEST(BitingMesherValues, OfASourceWithAMaskAreThoseOfItsValidPart)
{
  const auto image = ImageSource(1.0);
  vtkNew<vtkUnsignedCharArray> mask;
  mask->SetName("vtkValidPointMask");
  for (vtkIdType point = 0; point < image->GetNumberOfPoints(); ++point)
  {
    const bool isValid = image->GetPoint(point)[0] <= 0.5;
    mask->InsertNextValue(isValid ? 1 : 0);
    if (!isValid)
    {
      image->GetPointData()->GetArray("Depth")->SetTuple1(point, -1e30);
      image->GetPointData()->GetArray("Flow")->SetTuple2(point, -1e30, 1e30);
    }
  }
  image->GetPointData()->AddArray(mask);
  ExpectTransferred(image, 0.5);
}

TEST(BitingMesherValues, OfASourceStayThereWhereNotAskedFor)
{
  const auto mesher = MesherOf(UnitSquare(), 0.1);
  mesher->SetInputDataObject(1, ImageSource(1.0));
  mesher->TransferSourceArraysOff();
  mesher->Update();
  EXPECT_EQ(mesher->GetOutput()->GetPointData()->GetArray("Depth"), nullptr);
  EXPECT_EQ(mesher->GetOutput()->GetPointData()->GetArray("vtkValidPointMask"), nullptr);
}
