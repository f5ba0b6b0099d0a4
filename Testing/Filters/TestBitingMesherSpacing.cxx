// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SourcesTesting.h"

#include "vtkMultiBlockDataSet.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

using namespace testing_filters;

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

TEST(BitingMesherSource, WithAGhostArrayThatHidesNothingGivesTheSameBytes)
{
  const auto plain = Image(9, 9, 1);
  auto* values = plain->GetPointData()->GetArray("Spacing");
  values->SetComponent(40, 0, 0.02); // steep: a grid and triangles would differ
  const auto flagged = vtkSmartPointer<vtkImageData>::New();
  flagged->DeepCopy(plain);
  flagged->AllocateCellGhostArray();
  flagged->AllocatePointGhostArray()->SetValue(3, vtkDataSetAttributes::DUPLICATEPOINT);
  const auto expected = MesherWith(plain);
  const auto found = MesherWith(flagged);
  expected->Update();
  found->Update();
  EXPECT_TRUE(AreSame(expected->GetOutput(), found->GetOutput()));
}

// VTK hands out ids that are none for such a cell.
TEST(BitingMesherSource, MayHoldACellOfHighOrderWithPointsOfNoOrder)
{
  const auto source = Tetrahedra(-1.0, 1.0);
  auto* cells = vtkUnstructuredGrid::SafeDownCast(source);
  vtkNew<vtkIdList> points;
  for (vtkIdType point = 0; point < 50; ++point)
  {
    points->InsertNextId(point % cells->GetNumberOfPoints());
  }
  cells->InsertNextCell(VTK_LAGRANGE_HEXAHEDRON, points);
  const auto mesher = MesherWith(source);
  vtkObject::GlobalWarningDisplayOff(); // VTK complains
  mesher->Update();
  vtkObject::GlobalWarningDisplayOn();
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

TEST(BitingMesherSource, ThatCannotBeUsedIsRefusedInWords)
{
  EXPECT_TRUE(Has(RefusalOf(MesherWith(Tetrahedra(1.0, 2.0))), "does not meet the plane"));
  auto points = EmptyInput();
  AddVertex(points, { 0.5, 0.5, 0.0 });
  AddLinearSpacing(points);
  EXPECT_TRUE(Has(RefusalOf(MesherWith(points)),
    "no visible cells with an area or a volume. Delaunay 2D makes triangles of points."));
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

TEST(BitingMesherSource, WithZeroAndNegativeValuesHasTheMinimumSpacingThere)
{
  const auto wanted = Image(6, 7, 1);
  const auto given = Image(6, 7, 1);
  for (const vtkIdType point : { 8, 9, 20 })
  {
    wanted->GetPointData()->GetArray("Spacing")->SetComponent(point, 0, 0.125);
    given->GetPointData()->GetArray("Spacing")->SetComponent(point, 0, point == 8 ? 0.0 : -3.0);
  }
  const auto mesher = MesherWith(wanted);
  mesher->SetSpacingScale(0.5);
  mesher->SetMinimumSpacing(0.0625);
  mesher->Update();
  vtkNew<vtkPolyData> expected;
  expected->DeepCopy(mesher->GetOutput());
  mesher->SetSpacingSourceData(given);
  mesher->Update();
  EXPECT_GT(expected->GetNumberOfCells(), 50);
  EXPECT_TRUE(AreSame(mesher->GetOutput(), expected));
}

TEST(BitingMesherSpacing, OfTheInputThatIsZeroIsTheMinimumSpacing)
{
  vtkNew<vtkPolyData> square;
  square->ShallowCopy(UnitSquare());
  AddArray<vtkDoubleArray>(square->GetPointData(), "Spacing", { 0.1, 0.0, -1.0, 0.1 });
  vtkNew<vtkBitingMesher> mesher;
  mesher->SetInputData(square);
  EXPECT_TRUE(Has(RefusalOf(mesher), "zero, negative or not finite (2)"));
  mesher->SetMinimumSpacing(0.05);
  mesher->Update();
  vtkNew<vtkPolyData> expected;
  expected->DeepCopy(mesher->GetOutput());
  EXPECT_GT(expected->GetNumberOfCells(), 50);
  AddArray<vtkDoubleArray>(square->GetPointData(), "Spacing", { 0.1, 0.05, 0.05, 0.1 });
  square->Modified();
  mesher->Update();
  EXPECT_TRUE(AreSame(mesher->GetOutput(), expected));
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
  EXPECT_TRUE(Has(messages.Warnings[1], "does not cover 100 %")) << messages.Warnings[1];
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
