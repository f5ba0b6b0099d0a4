// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SourcesTesting.h"

#include <gtest/gtest.h>

#include <algorithm> // for max, min
#include <limits>    // for NaN

using namespace testing_filters;

TEST(BitingMesherBoundaryArray, HoldsOnTheBoundaryAndGrowsByGradation)
{
  auto input = UnitSquare();
  AddArray<vtkFloatArray>(input->GetPointData(), "Spacing", { 0.0625, 0.0625, 0.0625, 0.0625 });
  vtkNew<vtkBitingMesher> mesher;
  mesher->SetInputData(input);
  mesher->SetGradation(0.25);
  ExpectSpacing(
    mesher,
    [](const Place& place)
    {
      const double inside =
        std::min(std::min(place[0], 1.0 - place[0]), std::min(place[1], 1.0 - place[1]));
      return 0.0625 + 0.25 * inside;
    },
    0.02);
}

TEST(BitingMesherBoundaryArray, HoldsAtEmbeddedPoints)
{
  auto input = UnitSquare();
  AddVertex(input, { 0.5, 0.5, 0.0 });
  AddArray<vtkDoubleArray>(input->GetPointData(), "Spacing", { 0.2, 0.2, 0.2, 0.2, 0.01 });
  vtkNew<vtkBitingMesher> mesher;
  mesher->SetInputData(input);
  ExpectSpacing(
    mesher,
    [](const Place& place)
    {
      const double inside =
        std::min(std::min(place[0], 1.0 - place[0]), std::min(place[1], 1.0 - place[1]));
      return std::min(0.2 + 0.3 * inside, 0.01 + 0.3 * std::hypot(place[0] - 0.5, place[1] - 0.5));
    },
    0.02);
}

namespace
{

// The sides of the unit square, one line each: bottom, right, top, left.
vtkSmartPointer<vtkPolyData> FourSides(const std::vector<double>& sizes)
{
  auto data = EmptyInput();
  AddChain(data, { { 0, 0, 0 }, { 1, 0, 0 } }, false);
  AddChain(data, { { 1, 0, 0 }, { 1, 1, 0 } }, false);
  AddChain(data, { { 1, 1, 0 }, { 0, 1, 0 } }, false);
  AddChain(data, { { 0, 1, 0 }, { 0, 0, 0 } }, false);
  AddArray<vtkDoubleArray>(data->GetCellData(), "Size", sizes);
  return data;
}

// Two squares of side 1, as polygons.
vtkSmartPointer<vtkPolyData> TwoPolygons(const std::vector<double>& sizes)
{
  auto data = EmptyInput();
  const std::vector<Place> places{ { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 2, 1, 0 }, { 1, 1, 0 },
    { 0, 1, 0 } };
  for (const Place& place : places)
  {
    data->GetPoints()->InsertNextPoint(place.data());
  }
  data->GetPolys()->InsertNextCell({ 0, 1, 4, 5 });
  data->GetPolys()->InsertNextCell({ 1, 2, 3, 4 });
  AddArray<vtkDoubleArray>(data->GetCellData(), "Size", sizes);
  return data;
}

vtkSmartPointer<vtkBitingMesher> MesherBySize(vtkPolyData* input)
{
  auto mesher = vtkSmartPointer<vtkBitingMesher>::New();
  mesher->SetInputData(input);
  mesher->SetUniformSpacing(0.25);
  mesher->SetLimitByFeatureSize(false);
  mesher->SetBoundarySpacingArray(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "Size");
  return mesher;
}

} // namespace

TEST(BitingMesherCellArray, IsTheSizeAlongLinesWhereItIsAboveZero)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto mesher = MesherBySize(FourSides({ 0.02, 0.0, nan, 0.0 }));
  const auto wanted = [](const Place& place) { return std::min(0.25, 0.02 + 0.3 * place[1]); };
  ExpectSpacing(mesher, wanted, 0.05);
  vtkNew<vtkBitingMesher> other;
  other->SetInputData(mesher->GetInput());
  other->SetUniformSpacing(0.25);
  other->SetLimitByFeatureSize(false);
  other->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Size");
  ExpectSpacing(other, wanted, 0.05);
}

TEST(BitingMesherCellArray, IsTheSizeAnywhereInPolygonsAndGrowsOutside)
{
  const auto mesher = MesherBySize(TwoPolygons({ 0.03, 0.0 }));
  ExpectSpacing(
    mesher,
    [](const Place& place) { return std::min(0.25, 0.03 + 0.3 * std::max(0.0, place[0] - 1.0)); },
    0.06);
}

// A refinement region: a polygon that is an interface, in a domain.
TEST(BitingMesherCellArray, IsTheSizeAnywhereInPolygonsThatAreInterfaces)
{
  auto input = EmptyInput();
  for (const auto& places : { Rectangle(0, 0, 4, 4), Rectangle(1, 1, 2, 3) })
  {
    input->GetPolys()->InsertNextCell(4);
    for (const Place& place : places)
    {
      input->GetPolys()->InsertCellPoint(input->GetPoints()->InsertNextPoint(place.data()));
    }
  }
  AddArray<vtkIntArray>(input->GetCellData(), "Kind", { 0, 1 });
  AddArray<vtkDoubleArray>(input->GetCellData(), "Size", { 0.0, 0.05 });
  ExpectSpacing(
    MesherBySize(input),
    [](const Place& place)
    {
      const double x = std::max({ 1.0 - place[0], place[0] - 2.0, 0.0 });
      const double y = std::max({ 1.0 - place[1], place[1] - 3.0, 0.0 });
      return std::min(0.25, 0.05 + 0.3 * std::hypot(x, y));
    },
    0.06);
}

TEST(BitingMesherCellArray, OfZerosAsksForNothing)
{
  const auto mesher = MesherBySize(FourSides({ 0.0, 0.0, 0.0, 0.0 }));
  ExpectSpacing(mesher, [](const Place&) { return 0.25; });
}

TEST(BitingMesherCellArray, OfNegativeOrInfiniteSizesIsRefused)
{
  const auto mesher = MesherBySize(FourSides({ 0.1, -1.0, 0.1, 0.0 }));
  EXPECT_TRUE(Has(RefusalOf(mesher), "(1): cell 1 with -1."));
  const auto infinite =
    MesherBySize(FourSides({ 0.1, std::numeric_limits<double>::infinity(), 0.1, 0.0 }));
  EXPECT_TRUE(Has(RefusalOf(infinite), "negative or infinite (1): cell 1 with inf."));
}

TEST(BitingMesherCellArray, OfSizesFarBelowThoseOfCellsIsRefusedSoon)
{
  const auto mesher = MesherBySize(TwoPolygons({ 1e-300, 0.1 }));
  EXPECT_TRUE(Has(RefusalOf(mesher), "far below those of cells"));
}

TEST(BitingMesherCellArray, IsTakenBesideAPointArrayOfItsNameWhereItIsAskedFor)
{
  auto input = FourSides({ 0.05, 0.05, 0.05, 0.05 });
  AddArray<vtkDoubleArray>(input->GetPointData(), "Size", std::vector<double>(8, 0.1));
  const auto mesher = MesherBySize(input);
  mesher->Update();
  const vtkIdType ofCells = mesher->GetOutput()->GetNumberOfPoints();
  mesher->SetBoundarySpacingArray(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Size");
  mesher->Update();
  EXPECT_GT(ofCells, 2 * mesher->GetOutput()->GetNumberOfPoints());
}

TEST(BitingMesherArrays, MayHaveOtherNames)
{
  auto source = vtkSmartPointer<vtkImageData>::New();
  source->SetDimensions(2, 2, 1);
  AddLinearSpacing(source, "Size");
  const auto mesher = MesherWith(source);
  mesher->SetInputArrayToProcess(1, 1, 0, Points, "Size");
  ExpectSpacing(mesher, Linear);
}

TEST(BitingMesherArrays, MayBeTheActiveScalars)
{
  auto source = vtkSmartPointer<vtkImageData>::New();
  source->SetDimensions(2, 2, 1);
  AddLinearSpacing(source, "Size");
  source->GetPointData()->SetActiveScalars("Size");
  const auto mesher = MesherWith(source);
  mesher->SetInputArrayToProcess(1, 1, 0, Points, vtkDataSetAttributes::SCALARS);
  ExpectSpacing(mesher, Linear);
}

TEST(BitingMesherArrays, AreSwitchedOffByTheNameNone)
{
  auto input = UnitSquare();
  AddArray<vtkDoubleArray>(input->GetPointData(), "Spacing", { 0.0, 0.0, 0.0, 0.0 });
  for (const char* name : { "None", "" })
  {
    vtkNew<vtkBitingMesher> mesher;
    mesher->SetInputData(input);
    mesher->SetUniformSpacing(0.25);
    mesher->SetInputArrayToProcess(0, 0, 0, Points, name);
    ExpectSpacing(mesher, [](const Place&) { return 0.25; });
  }
}

TEST(BitingMesherArrays, ThatAreMissingAreRefused)
{
  const auto mesher = MesherWith(Image(6, 7, 1));
  mesher->SetInputArrayToProcess(0, 0, 0, Points, "Size");
  EXPECT_TRUE(Has(RefusalOf(mesher), "The input has no point array named Size"));
  mesher->SetInputArrayToProcess(0, 0, 0, Points, "Spacing");
  mesher->SetInputArrayToProcess(1, 1, 0, Points, "Other");
  EXPECT_TRUE(Has(RefusalOf(mesher), "The spacing source has no point array named Other"));
  mesher->SetInputArrayToProcess(1, 1, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "Spacing");
  EXPECT_TRUE(Has(RefusalOf(mesher), "must be point data. Cell Data to Point Data makes it"));
}

TEST(BitingMesherArrays, OfCellsAreToldOfWithAWayOut)
{
  const auto source = Image(6, 7, 1);
  AddArray<vtkDoubleArray>(source->GetCellData(), "OfCells", std::vector<double>(30, 0.1));
  const auto mesher = MesherWith(source);
  mesher->SetInputArrayToProcess(1, 1, 0, Points, "OfCells");
  EXPECT_TRUE(Has(RefusalOf(mesher), "no point array named OfCells. Cell Data to Point Data"));
  source->GetPointData()->Initialize();
  AddArray<vtkDoubleArray>(source->GetCellData(), "Spacing", std::vector<double>(30, 0.1));
  mesher->SetInputArrayToProcess(1, 1, 0, Points, "Spacing");
  Messages messages(mesher);
  mesher->Update();
  ASSERT_EQ(messages.Warnings.size(), 1u);
  EXPECT_TRUE(Has(messages.Warnings.front(), "is not used"));
  EXPECT_TRUE(Has(messages.Warnings.front(), "Cell Data to Point Data"));
}

TEST(BitingMesherArrays, ThatNobodyChoseMayBeMissingButNotSilentlyOnASource)
{
  vtkNew<vtkImageData> source;
  source->SetDimensions(2, 2, 1);
  const auto mesher = MesherWith(source);
  Messages messages(mesher);
  mesher->Update();
  EXPECT_NEAR(AreaOf(mesher->GetOutput()), 1.0, 1e-12);
  ASSERT_EQ(messages.Warnings.size(), 1u);
  EXPECT_TRUE(Has(messages.Warnings.front(), "The spacing source is not used"));
  // ParaView always chooses: it has this name as its default.
  mesher->SetInputArrayToProcess(1, 1, 0, Points, "Spacing");
  mesher->Update();
  EXPECT_EQ(messages.Warnings.size(), 2u);
  mesher->SetInputArrayToProcess(1, 1, 0, Points, "None");
  mesher->Update();
  EXPECT_EQ(messages.Warnings.size(), 2u);
}

TEST(BitingMesherArrays, ThatAreTheOnlyScalarOfTheSourceAreTaken)
{
  const auto image = Image(6, 7, 1);
  image->GetPointData()->GetArray("Spacing")->SetName("EdgeLength");
  const auto mesher = MesherWith(image);
  Messages messages(mesher);
  ExpectSpacing(mesher, Linear);
  EXPECT_TRUE(messages.Warnings.empty());
  AddArray<vtkDoubleArray>(image->GetPointData(), "Other", std::vector<double>(42, 1.0));
  mesher->Modified();
  mesher->Update();
  EXPECT_EQ(messages.Warnings.size(), 1u);
}
