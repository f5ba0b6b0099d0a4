// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "FilterTesting.h"

#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkRectilinearGrid.h"
#include "vtkStructuredGrid.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <functional>

using namespace testing_filters;

namespace
{

constexpr int Points = vtkDataObject::FIELD_ASSOCIATION_POINTS;

// The spacing that every source here carries: linear, so that every interpolation is exact.
double Linear(const Place& place)
{
  return 0.05 + 0.1 * place[0] + 0.05 * place[1];
}

void AddLinearSpacing(vtkDataSet* data, const char* name = "Spacing")
{
  std::vector<double> values;
  for (vtkIdType point = 0; point < data->GetNumberOfPoints(); ++point)
  {
    Place place;
    data->GetPoint(point, place.data());
    values.push_back(Linear(place));
  }
  AddArray<vtkDoubleArray>(data->GetPointData(), name, values);
}

vtkSmartPointer<vtkImageData> Image(int nx, int ny, int nz)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(nx, ny, nz);
  image->SetSpacing(1.0 / (nx - 1), 1.0 / (ny - 1), nz > 1 ? 1.0 / (nz - 1) : 1.0);
  AddLinearSpacing(image);
  return image;
}

vtkSmartPointer<vtkPoints> PointsOf(vtkDataSet* data)
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  for (vtkIdType point = 0; point < data->GetNumberOfPoints(); ++point)
  {
    points->InsertNextPoint(data->GetPoint(point));
  }
  return points;
}

vtkSmartPointer<vtkDataSet> RectilinearGrid()
{
  auto grid = vtkSmartPointer<vtkRectilinearGrid>::New();
  vtkNew<vtkDoubleArray> nodes;
  for (const double node : { 0.0, 0.1, 0.3, 0.7, 1.0 })
  {
    nodes->InsertNextValue(node);
  }
  grid->SetDimensions(5, 5, 1);
  grid->SetXCoordinates(nodes);
  grid->SetYCoordinates(nodes);
  AddLinearSpacing(grid);
  return grid;
}

vtkSmartPointer<vtkDataSet> StructuredGrid()
{
  auto grid = vtkSmartPointer<vtkStructuredGrid>::New();
  grid->SetDimensions(6, 7, 1);
  grid->SetPoints(PointsOf(Image(6, 7, 1)));
  AddLinearSpacing(grid);
  return grid;
}

// The cells of an image as polygons: quads, or triangles where `isSplit`.
vtkSmartPointer<vtkDataSet> Polygons(bool isSplit)
{
  const auto image = Image(6, 7, 1);
  auto data = EmptyInput();
  data->SetPoints(PointsOf(image));
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < image->GetNumberOfCells(); ++cell)
  {
    image->GetCellPoints(cell, ids);
    const vtkIdType corner[4] = { ids->GetId(0), ids->GetId(1), ids->GetId(3), ids->GetId(2) };
    if (isSplit)
    {
      data->GetPolys()->InsertNextCell({ corner[0], corner[1], corner[2] });
      data->GetPolys()->InsertNextCell({ corner[0], corner[2], corner[3] });
    }
    else
    {
      data->GetPolys()->InsertNextCell(4, corner);
    }
  }
  AddLinearSpacing(data);
  return data;
}

// Tetrahedra about the plane z = 0: the six of each cube of a lattice in [0, 1] x [0, 1] x [low,
// high].
vtkSmartPointer<vtkDataSet> Tetrahedra(double low, double high)
{
  constexpr int Size = 4;
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  const auto id = [](int i, int j, int k)
  { return static_cast<vtkIdType>(i + Size * (j + Size * k)); };
  for (int k = 0; k < 3; ++k)
  {
    for (int j = 0; j < Size; ++j)
    {
      for (int i = 0; i < Size; ++i)
      {
        points->InsertNextPoint(i / (Size - 1.0), j / (Size - 1.0), low + 0.5 * k * (high - low));
      }
    }
  }
  grid->SetPoints(points);
  const int steps[6][3] = { { 0, 1, 2 }, { 0, 2, 1 }, { 1, 0, 2 }, { 1, 2, 0 }, { 2, 0, 1 },
    { 2, 1, 0 } };
  for (int cube = 0; cube < 2 * (Size - 1) * (Size - 1); ++cube)
  {
    for (const auto& step : steps)
    {
      int at[3] = { cube % (Size - 1), cube / (Size - 1) % (Size - 1),
        cube / ((Size - 1) * (Size - 1)) };
      vtkIdType tetrahedron[4] = { id(at[0], at[1], at[2]) };
      for (int corner = 1; corner < 4; ++corner)
      {
        ++at[step[corner - 1]];
        tetrahedron[corner] = id(at[0], at[1], at[2]);
      }
      grid->InsertNextCell(VTK_TETRA, 4, tetrahedron);
    }
  }
  AddLinearSpacing(grid);
  return grid;
}

// Meshes the unit square at height z with a source.
vtkSmartPointer<vtkBitingMesher> MesherWith(vtkDataSet* source, double z = 0.0)
{
  auto mesher = vtkSmartPointer<vtkBitingMesher>::New();
  mesher->SetInputData(UnitSquare(z));
  mesher->SetSpacingSourceData(source);
  return mesher;
}

// Expects the spacing of the mesh to be `expected` at every vertex.
void ExpectSpacing(vtkBitingMesher* mesher, const std::function<double(const Place&)>& expected,
  double tolerance = 1e-9)
{
  mesher->Update();
  vtkPolyData* mesh = mesher->GetOutput();
  vtkDataArray* spacing = mesh->GetPointData()->GetArray("Spacing");
  ASSERT_TRUE(spacing);
  ASSERT_GT(mesh->GetNumberOfPoints(), 4);
  for (vtkIdType point = 0; point < mesh->GetNumberOfPoints(); ++point)
  {
    const double wanted = expected(PointOf(mesh, point));
    ASSERT_NEAR(spacing->GetComponent(point, 0), wanted, tolerance * wanted);
  }
}

std::string RefusalOf(vtkBitingMesher* mesher)
{
  Messages messages(mesher);
  mesher->Update();
  EXPECT_EQ(messages.Errors.size(), 1u);
  EXPECT_TRUE(AreAllEmpty(mesher));
  return messages.Errors.empty() ? "" : messages.Errors.front();
}

} // namespace

TEST(BitingMesherSource, OfEveryKindIsInterpolatedLinearly)
{
  ExpectSpacing(MesherWith(Image(6, 7, 1)), Linear);
  ExpectSpacing(MesherWith(RectilinearGrid()), Linear);
  ExpectSpacing(MesherWith(StructuredGrid()), Linear);
  ExpectSpacing(MesherWith(Polygons(false)), Linear);
  ExpectSpacing(MesherWith(Polygons(true)), Linear);
  ExpectSpacing(MesherWith(Tetrahedra(-0.4, 0.3)), Linear);
  ExpectSpacing(MesherWith(Image(5, 5, 4), 0.3), Linear);
}

TEST(BitingMesherSource, OfOneLayerCountsAtAnyHeight)
{
  ExpectSpacing(MesherWith(Image(6, 7, 1), 3.0), Linear);
  ExpectSpacing(MesherWith(Polygons(true), 3.0), Linear);
}

TEST(BitingMesherSource, WithFacesInThePlaneIsCutThere)
{
  ExpectSpacing(MesherWith(Tetrahedra(0.0, 1.0)), Linear);
  ExpectSpacing(MesherWith(Tetrahedra(-1.0, 0.0)), Linear);
  ExpectSpacing(MesherWith(Tetrahedra(-1.0, 1.0)), Linear);
}

TEST(BitingMesherSource, InATurnedPlaneIsReadInThatPlane)
{
  // The square in the plane x = 2, with y and z as coordinates, and an image there.
  auto input = EmptyInput();
  AddChain(input, { { 2, 0, 0 }, { 2, 1, 0 }, { 2, 1, 1 }, { 2, 0, 1 } }, true);
  vtkNew<vtkImageData> image;
  image->SetDimensions(1, 5, 3);
  image->SetSpacing(1.0, 0.25, 0.5);
  AddLinearSpacing(image);
  vtkNew<vtkBitingMesher> mesher;
  mesher->SetInputData(input);
  mesher->SetSpacingSourceData(image);
  ExpectSpacing(mesher, [](const Place& place) { return Linear({ 0.0, place[1], place[2] }); });
}

TEST(BitingMesherSource, ThatDoesNotCoverTheDomainGoesOnWithItsBorder)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(2, 2, 1);
  image->SetSpacing(0.5, 1.0, 1.0);
  AddLinearSpacing(image);
  ExpectSpacing(MesherWith(image),
    [](const Place& place) {
      return Linear({ std::min(place[0], 0.5), place[1], 0.0 });
    });
}

TEST(BitingMesherSource, MayHoldVerticesAndLinesOfOnePoint)
{
  const auto polygons = Polygons(true);
  auto* source = vtkPolyData::SafeDownCast(polygons);
  source->GetVerts()->InsertNextCell({ 0 });
  source->GetLines()->InsertNextCell({ 1 });
  ExpectSpacing(MesherWith(source), Linear);
}

TEST(BitingMesherSource, WithHiddenPolygonsBesideVerticesIsReadElsewhere)
{
  const auto polygons = Polygons(true);
  auto* source = vtkPolyData::SafeDownCast(polygons);
  source->GetVerts()->InsertNextCell({ 0 });
  vtkUnsignedCharArray* ghosts = source->AllocateCellGhostArray();
  ghosts->SetValue(1, vtkDataSetAttributes::HIDDENCELL);
  ghosts->SetValue(2, vtkDataSetAttributes::HIDDENCELL);
  source->GetPointData()->GetArray("Spacing")->SetComponent(0, 0, -1.0);
  const auto mesher = MesherWith(source);
  Messages messages(mesher);
  mesher->Update();
  EXPECT_TRUE(messages.Errors.empty());
  EXPECT_GT(mesher->GetOutput()->GetNumberOfCells(), 100);
}

TEST(BitingMesherSource, IsNotReadWhereCellsAreHidden)
{
  const auto image = Image(3, 3, 1);
  image->AllocateCellGhostArray()->SetValue(0, vtkDataSetAttributes::HIDDENCELL);
  image->GetPointData()->GetArray("Spacing")->SetComponent(0, 0, -1.0);
  const auto mesher = MesherWith(image);
  Messages messages(mesher);
  mesher->Update();
  EXPECT_TRUE(messages.Errors.empty());
  EXPECT_GT(mesher->GetOutput()->GetNumberOfCells(), 100);
}

TEST(BitingMesherSource, MayHaveHolesOfNaN)
{
  const auto image = Image(9, 9, 1);
  image->GetPointData()->GetArray("Spacing")->SetComponent(40, 0, std::nan(""));
  const auto mesher = MesherWith(image);
  Messages messages(mesher);
  mesher->Update();
  EXPECT_TRUE(messages.Errors.empty());
  EXPECT_NEAR(AreaOf(mesher->GetOutput()), 1.0, 1e-12);
}

TEST(BitingMesherSource, IsNotChangedByTheFilter)
{
  const auto source = Polygons(true);
  const vtkMTimeType time = source->GetMTime();
  MesherWith(source)->Update();
  EXPECT_EQ(source->GetMTime(), time);
}

TEST(BitingMesherSource, AndUniformSpacingGiveTheirMinimum)
{
  const auto mesher = MesherWith(Image(6, 7, 1));
  mesher->SetUniformSpacing(0.1);
  ExpectSpacing(mesher, [](const Place& place) { return std::min(Linear(place), 0.1); });
}

TEST(BitingMesherSpacing, IsScaledThenClamped)
{
  const auto mesher = MesherWith(Image(6, 7, 1));
  mesher->SetSpacingScale(0.5);
  mesher->SetMinimumSpacing(0.04);
  mesher->SetMaximumSpacing(0.08);
  ExpectSpacing(
    mesher, [](const Place& place) { return std::min(std::max(0.5 * Linear(place), 0.04), 0.08); });
}

TEST(BitingMesherSpacing, IsTwoPercentOfTheDiagonalWhereNothingIsGiven)
{
  vtkNew<vtkBitingMesher> mesher;
  mesher->SetInputData(UnitSquare());
  ExpectSpacing(mesher, [](const Place&) { return 0.02 * std::sqrt(2.0); });
}

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
  EXPECT_TRUE(Has(RefusalOf(mesher), "must be point data"));
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

TEST(BitingMesherSource, ThatCannotBeUsedIsRefusedInWords)
{
  EXPECT_TRUE(Has(RefusalOf(MesherWith(Tetrahedra(1.0, 2.0))), "does not meet the plane"));
  auto points = EmptyInput();
  AddVertex(points, { 0.5, 0.5, 0.0 });
  AddLinearSpacing(points);
  EXPECT_TRUE(Has(RefusalOf(MesherWith(points)), "no visible cells with an area"));
  auto empty = EmptyInput();
  AddLinearSpacing(empty);
  EXPECT_TRUE(Has(RefusalOf(MesherWith(empty)), "no cells to interpolate in"));
  auto upright = EmptyInput();
  for (const Place& place : { Place{ 0, 0, 0 }, Place{ 1, 0, 0 }, Place{ 1, 0, 1 } })
  {
    upright->GetPoints()->InsertNextPoint(place.data());
  }
  upright->GetPolys()->InsertNextCell({ 0, 1, 2 });
  AddLinearSpacing(upright);
  EXPECT_TRUE(Has(RefusalOf(MesherWith(upright)), "no area in the plane"));
}

TEST(BitingMesherSource, WithBadValuesIsRefusedWithTheirPoints)
{
  for (const double bad : { 0.0, -3.0, HUGE_VAL })
  {
    const auto image = Image(6, 7, 1);
    image->GetPointData()->GetArray("Spacing")->SetComponent(8, 0, bad);
    image->GetPointData()->GetArray("Spacing")->SetComponent(9, 0, bad);
    const std::string refusal = RefusalOf(MesherWith(image));
    EXPECT_TRUE(Has(refusal, "(2): point 8 with")) << refusal;
    EXPECT_TRUE(Has(refusal, "at (0.4, 0.16666666666")) << refusal;
  }
  vtkNew<vtkImageData> source;
  source->SetDimensions(2, 2, 1);
  vtkNew<vtkDoubleArray> vectors;
  vectors->SetName("Spacing");
  vectors->SetNumberOfComponents(3);
  vectors->SetNumberOfTuples(4);
  source->GetPointData()->AddArray(vectors);
  EXPECT_TRUE(Has(RefusalOf(MesherWith(source)), "has 3 components"));
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

TEST(BitingMesherSource, MayHaveFillValuesOutsideOfTheDomain)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(5, 4, 1);
  image->SetOrigin(0.0, -1.0, 0.0);
  image->SetSpacing(0.25, 1.0, 1.0);
  AddArray<vtkDoubleArray>(image->GetPointData(), "Spacing",
    { -9999.0, 0.0, HUGE_VAL, -9999.0, -1.0, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1,
      -9999.0, -9999.0, -9999.0, -9999.0, -9999.0 });
  const auto mesher = MesherWith(image);
  Messages messages(mesher);
  ExpectSpacing(mesher, [](const Place&) { return 0.1; });
  EXPECT_TRUE(messages.Errors.empty());
  EXPECT_TRUE(messages.Warnings.empty());
}

TEST(BitingMesherSource, ThatLiesElsewhereIsToldOfWithShareAndPlace)
{
  const auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(6, 6, 1);
  image->SetSpacing(0.1, 0.2, 1.0);
  AddArray<vtkDoubleArray>(image->GetPointData(), "Spacing", std::vector<double>(36, 0.1));
  const auto mesher = MesherWith(image);
  Messages messages(mesher);
  mesher->Update();
  ASSERT_EQ(messages.Warnings.size(), 1u);
  EXPECT_TRUE(Has(messages.Warnings[0], "The spacing source does not cover 4"))
    << messages.Warnings[0];
  EXPECT_TRUE(Has(messages.Warnings[0], "near (")) << messages.Warnings[0];
  image->SetOrigin(100.0, 0.0, 0.0);
  mesher->Update();
  ASSERT_EQ(messages.Warnings.size(), 2u);
  EXPECT_TRUE(Has(messages.Warnings[1], "does not cover 1e+02 %") ||
    Has(messages.Warnings[1], "does not cover 100 %"))
    << messages.Warnings[1];
}

TEST(BitingMesherSource, OfSeveralBlocksIsOneSource)
{
  const auto whole = Image(6, 7, 1);
  vtkNew<vtkMultiBlockDataSet> blocks;
  int extents[2][6] = { { 0, 2, 0, 6, 0, 0 }, { 2, 5, 0, 6, 0, 0 } };
  for (unsigned int block = 0; block < 2; ++block)
  {
    vtkNew<vtkImageData> part;
    part->SetExtent(extents[block]);
    part->SetOrigin(vtkImageData::SafeDownCast(whole)->GetOrigin());
    part->SetSpacing(vtkImageData::SafeDownCast(whole)->GetSpacing());
    AddLinearSpacing(part);
    blocks->SetBlock(block, part);
  }
  const auto mesher = MesherWith(whole);
  mesher->Update();
  vtkNew<vtkPolyData> expected;
  expected->DeepCopy(mesher->GetOutput());
  mesher->SetSpacingSourceData(blocks);
  mesher->Update();
  EXPECT_TRUE(AreSame(mesher->GetOutput(), expected));
  // Of different kinds, with a block that has no spacing.
  blocks->SetBlock(1, Polygons(true));
  blocks->SetBlock(2, UnitSquare());
  ExpectSpacing(mesher, Linear);
}
