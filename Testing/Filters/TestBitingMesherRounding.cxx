// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

// What the rounding of coordinates does not tell apart, and what it does.

#include "FilterTesting.h"

#include "vtkImageData.h"

#include <gtest/gtest.h>

using namespace testing_filters;

namespace
{

constexpr double Float1 = 0.1f; // needs all bits of a float
constexpr double Float2 = 0.7f; // so does this, in another binary order

vtkSmartPointer<vtkPolyData> Loop(int pointType, const std::vector<Place>& places)
{
  auto data = EmptyInput(pointType);
  AddChain(data, places, true);
  return data;
}

std::vector<Place> WithShortSegment(double length)
{
  return { { Float1, 0, 0 }, { Float2, 0, 0 }, { Float2, length, 0 }, { Float2, Float2, 0 },
    { Float1, Float2, 0 } };
}

// The warnings, and the errors after them.
std::vector<std::string> TextsOf(vtkPolyData* input, vtkBitingMesher* mesher)
{
  Messages messages(mesher);
  mesher->SetInputData(input);
  mesher->Update();
  messages.Warnings.insert(messages.Warnings.end(), messages.Errors.begin(), messages.Errors.end());
  return messages.Warnings;
}

vtkIdType NumberOfNearPoints(vtkPolyData* input, double mergeTolerance = 0.0)
{
  vtkNew<vtkBitingMesher> mesher;
  mesher->SetMergeTolerance(mergeTolerance);
  TextsOf(input, mesher);
  return static_cast<vtkIdType>(Figure(mesher->GetOutput(), "RepairedNearPoints"));
}

TEST(BitingMesherRounding, FloatsWithinTheirRoundingAreOnePointWithOneWarning)
{
  vtkNew<vtkBitingMesher> mesher;
  const auto texts = TextsOf(Loop(VTK_FLOAT, WithShortSegment(1e-17)), mesher);
  ASSERT_EQ(texts.size(), 1u);
  EXPECT_TRUE(Has(texts[0], "too near"));
  EXPECT_TRUE(Has(texts[0], " (1): point "));
  EXPECT_GT(Figure(mesher->GetOutput(), "SmallestAngle"), 25.0);
  EXPECT_EQ(mesher->GetOutput(vtkBitingMesher::PROBLEMS)->GetNumberOfPoints(), 1);
}

TEST(BitingMesherRounding, ShortSegmentsOfFloatsAboveTheirRoundingStay)
{
  EXPECT_EQ(NumberOfNearPoints(Loop(VTK_FLOAT, WithShortSegment(1e-6))), 0);
  EXPECT_EQ(NumberOfNearPoints(Loop(VTK_FLOAT, WithShortSegment(6e-7))), 1);
}

TEST(BitingMesherRounding, DoublesKeepAThousandMillionthOfTheirBox)
{
  EXPECT_EQ(NumberOfNearPoints(Loop(VTK_DOUBLE, WithShortSegment(1e-9))), 0);
}

TEST(BitingMesherRounding, DoublesThatHaveBeenFloatsCountAsFloats)
{
  EXPECT_EQ(NumberOfNearPoints(Loop(VTK_DOUBLE, WithShortSegment(0x1p-30))), 1);
}

TEST(BitingMesherRounding, DoublesOfFewDigitsCountAsDoubles)
{
  EXPECT_EQ(NumberOfNearPoints(Loop(VTK_DOUBLE,
              { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 0x1p-30, 0 }, { 1, 1, 0 }, { 0, 1, 0 } })),
    0);
  const double far = 13000000.0; // odd numbers of this size need 24 bits
  EXPECT_EQ(NumberOfNearPoints(Loop(VTK_DOUBLE,
              { { far + 1, -far, 0 }, { far + 3, -far - 1, 0 }, { far + 1, -far - 2, 0 } })),
    0);
}

/// The mesh's area of walls in a plan of floats at the easting and northing of a map.
double AreaOfFarWall(double x, double y, double width, double height)
{
  const double east = 412345.678;
  const double north = 6350123.4;
  auto plan = EmptyInput(VTK_FLOAT);
  AddChain(plan, Rectangle(east, north, east + 300.25, north + 200.5), true);
  AddChain(plan, Rectangle(east + x, north + y, east + x + width, north + y + height), true);
  vtkNew<vtkBitingMesher> mesher;
  mesher->SetUniformSpacing(20.0);
  TextsOf(plan, mesher);
  EXPECT_EQ(Figure(mesher->GetOutput(), "RepairedNearPoints"), 0.0);
  return 300.25 * 200.5 - AreaOf(mesher->GetOutput());
}

TEST(BitingMesherRounding, WallsOfAPlanInFloatsFarFromTheOriginStay)
{
  EXPECT_NEAR(AreaOfFarWall(50.0, 50.0, 100.0, 4.0), 400.0, 120.0);
  EXPECT_NEAR(AreaOfFarWall(50.0, 50.0, 100.0, 1.0), 100.0, 101.0);
  EXPECT_NEAR(AreaOfFarWall(50.0, 50.0, 4.0, 100.0), 400.0, 20.0);
  EXPECT_NEAR(AreaOfFarWall(50.0, 50.0, 0.25, 100.0), 25.0, 8.0);
}

TEST(BitingMesherRounding, FloatsThatAreWholeNumbersAreAsDrawn)
{
  EXPECT_EQ(NumberOfNearPoints(Loop(VTK_FLOAT,
              { { 0, 0, 0 }, { 16000000, 0, 0 }, { 16000000, 1, 0 }, { 16000000, 8000000, 0 } })),
    0);
}

TEST(BitingMesherRounding, MergeToleranceIsRelativeToTheDiagonal)
{
  const auto input = Loop(VTK_DOUBLE, WithShortSegment(1e-3));
  EXPECT_EQ(NumberOfNearPoints(input), 0);
  EXPECT_EQ(NumberOfNearPoints(input, 1e-3), 0); // the diagonal is 0.92
  EXPECT_EQ(NumberOfNearPoints(input, 1.2e-3), 1);
}

TEST(BitingMesherRounding, ATinyDrawingInFloatsIsPlanarWithinTheirRounding)
{
  const std::vector<Place> places{ { 0.499f, 0, 0 }, { 0.49901f, 0.001f, 0.0004f },
    { 0.49903f, 0, 0.002f }, { 0.49902f, -0.001f, 0.0016f } };
  std::vector<Place> moved = places;
  moved[2][0] += 6e-8;
  vtkNew<vtkBitingMesher> mesher;
  EXPECT_TRUE(TextsOf(Loop(VTK_FLOAT, moved), mesher).empty());
  EXPECT_GT(mesher->GetOutput()->GetNumberOfCells(), 0);
}

TEST(BitingMesherRounding, APlaneOfConstantZButForRoundingKeepsItsCoordinates)
{
  auto places = Rectangle(Float1, 0.0, Float2, 0.25, 0.3f);
  places[1][2] = std::nextafter(0.3f, 1.0f);
  vtkNew<vtkBitingMesher> mesher;
  EXPECT_TRUE(TextsOf(Loop(VTK_FLOAT, places), mesher).empty());
  vtkPolyData* mesh = mesher->GetOutput();
  for (vtkIdType point = 0; point < mesh->GetNumberOfPoints(); ++point)
  {
    EXPECT_NEAR(PointOf(mesh, point)[2], 0.3, 1e-7);
  }
  EXPECT_EQ(PointOf(mesh, 1), places[1]);
}

TEST(BitingMesherRounding, WhereNothingIsLeftTheErrorTellsWhatWasMerged)
{
  vtkNew<vtkBitingMesher> mesher;
  const auto texts = TextsOf(
    Loop(VTK_FLOAT, { { 1, 0, 0 }, { 1.0f, 1e-9f, 0 }, { 2, 0, 0 }, { 1.0f, -1e-9f, 0 } }), mesher);
  ASSERT_EQ(texts.size(), 1u);
  EXPECT_TRUE(Has(texts[0], "no closed loop")) << texts[0];
  EXPECT_TRUE(Has(texts[0], "too near"));
}

std::string RefusalWithSource(vtkDataSet* source)
{
  vtkNew<vtkBitingMesher> mesher;
  mesher->SetSpacingSourceData(source);
  const auto texts = TextsOf(UnitSquare(), mesher);
  EXPECT_EQ(texts.size(), 1u);
  EXPECT_TRUE(AreAllEmpty(mesher));
  return texts.empty() ? "" : texts.front();
}

TEST(BitingMesherRounding, ASourceThatLiesNowhereIsRefusedByWhatIsWrong)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(2, 2, 1);
  image->SetOrigin(std::nan(""), 0.0, 0.0);
  AddArray<vtkDoubleArray>(image->GetPointData(), "Spacing", { 0.1, 0.1, 0.1, 0.1 });
  EXPECT_TRUE(Has(RefusalWithSource(image), "origin of the image"));
  auto cells = EmptyInput();
  for (const Place& place : Rectangle(0, 0, 1, 1))
  {
    cells->GetPoints()->InsertNextPoint(place.data());
  }
  cells->GetPoints()->SetPoint(2, 1.0, HUGE_VAL, 0.0);
  cells->GetPolys()->InsertNextCell({ 0, 1, 2 });
  AddArray<vtkDoubleArray>(cells->GetPointData(), "Spacing", { 0.1, 0.1, 0.1, 0.1 });
  EXPECT_TRUE(Has(RefusalWithSource(cells), "coordinates that are not finite (1): point 2"));
  cells->GetPoints()->SetPoint(2, std::nan(""), 1.0, 0.0);
  AddArray<vtkDoubleArray>(cells->GetPointData(), "Spacing", { 0.1, 0.1, -9999.0, 0.1 });
  EXPECT_TRUE(Has(RefusalWithSource(cells), "coordinates that are not finite (1): point 2"));
}

TEST(BitingMesherRounding, ALargeNumberIsNamedInFewDigits)
{
  vtkNew<vtkBitingMesher> mesher;
  mesher->SetPhi(1e300);
  const auto texts = TextsOf(UnitSquare(), mesher);
  ASSERT_EQ(texts.size(), 1u);
  EXPECT_TRUE(Has(texts[0], "Phi is 1e+300;"));
  mesher->SetPhi(1.0);
  mesher->SetMergeTolerance(1.0);
  EXPECT_TRUE(Has(TextsOf(UnitSquare(), mesher).front(), "Merge Tolerance is 1;"));
}

TEST(BitingMesherRounding, PointsWithoutCellsAreToldOf)
{
  auto input = EmptyInput();
  const Place place{ 1.0, 2.0, 3.0 };
  input->GetPoints()->InsertNextPoint(place.data());
  vtkNew<vtkBitingMesher> mesher;
  const auto texts = TextsOf(input, mesher);
  ASSERT_EQ(texts.size(), 1u);
  EXPECT_TRUE(Has(texts[0], "points, but no cells"));
}

TEST(BitingMesherRounding, SmallPhiKeepsTheBoundOfTheTheorem)
{
  for (const double phi : { 0.3, 0.6, 0.8, 0.95 })
  {
    vtkNew<vtkBitingMesher> mesher;
    mesher->SetUniformSpacing(0.03);
    mesher->SetRelaxation(false);
    mesher->SetPhi(phi);
    TextsOf(UnitSquare(), mesher);
    EXPECT_LE(Figure(mesher->GetOutput(), "LargestRadiusEdgeRatio"), 1.01 * std::sqrt(2.0) / phi);
  }
}

} // namespace
