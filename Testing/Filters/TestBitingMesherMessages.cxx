// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "FilterTesting.h"

#include "vtkErrorCode.h"
#include "vtkStringArray.h"

#include <gtest/gtest.h>

#include <sstream> // for words

using namespace testing_filters;

namespace
{

// What the panel of ParaView shows in short lines, as one.
std::string JoinedSummary(vtkBitingMesher* mesher)
{
  std::istringstream words(mesher->GetSummary());
  std::string text;
  for (std::string word; words >> word;)
  {
    text += (text.empty() ? "" : " ") + word;
  }
  return text;
}

std::string RefusalOf(vtkPolyData* input, vtkBitingMesher* mesher)
{
  Messages messages(mesher);
  mesher->SetInputData(input);
  mesher->Update();
  EXPECT_EQ(messages.Errors.size(), 1u);
  EXPECT_TRUE(messages.Warnings.empty());
  EXPECT_TRUE(messages.OfExecutive.empty());
  EXPECT_TRUE(AreAllEmpty(mesher));
  EXPECT_EQ(mesher->GetErrorCode(), vtkErrorCode::UserError);
  const std::string summary = JoinedSummary(mesher);
  EXPECT_EQ(summary.rfind("Error: ", 0), 0u) << summary;
  EXPECT_TRUE(Has(messages.Errors.front(), summary.substr(7).c_str())) << summary;
  return messages.Errors.empty() ? "" : messages.Errors.front();
}

std::string RefusalOf(vtkPolyData* input)
{
  vtkNew<vtkBitingMesher> mesher;
  return RefusalOf(input, mesher);
}

std::vector<std::string> WarningsOf(vtkPolyData* input, vtkBitingMesher* mesher)
{
  Messages messages(mesher);
  mesher->SetInputData(input);
  mesher->SetUniformSpacing(0.1);
  mesher->Update();
  EXPECT_TRUE(messages.Errors.empty());
  EXPECT_GT(mesher->GetOutput()->GetNumberOfCells(), 0);
  return messages.Warnings;
}

std::string WarningOf(vtkPolyData* input)
{
  vtkNew<vtkBitingMesher> mesher;
  const auto warnings = WarningsOf(input, mesher);
  EXPECT_EQ(warnings.size(), 1u);
  return warnings.empty() ? "" : warnings.front();
}

// Two squares at height 2 whose sides cross at (1, 0.5) and (0.5, 1).
vtkSmartPointer<vtkPolyData> CrossingSquares()
{
  auto input = UnitSquare(2.0);
  AddChain(input, Rectangle(0.5, 0.5, 1.5, 1.5, 2.0), true);
  return input;
}

} // namespace

TEST(BitingMesherMessages, NameCrossingSegmentsAndTheirPlaceInSpace)
{
  vtkNew<vtkBitingMesher> mesher;
  const auto warnings = WarningsOf(CrossingSquares(), mesher);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_TRUE(Has(warnings[0], "Crossing segments (2): cell 0 with cell 1 near (")) << warnings[0];
  EXPECT_TRUE(Has(warnings[0], "(1, 0.5, 2)") || Has(warnings[0], "(0.5, 1, 2)")) << warnings[0];
  EXPECT_EQ(Figure(mesher->GetOutput(), "RepairedCrossings"), 2.0);
  EXPECT_NEAR(AreaOf(mesher->GetOutput()), 1.5, 1e-12);
}

TEST(BitingMesherMessages, SayTheSameAsAnErrorWhereRepairIsOff)
{
  vtkNew<vtkBitingMesher> mesher;
  mesher->RepairInputOff();
  const std::string refusal = RefusalOf(CrossingSquares(), mesher);
  EXPECT_TRUE(Has(refusal, "Crossing segments (2): cell 0 with cell 1 near (")) << refusal;
  EXPECT_TRUE(Has(refusal, "Repair Input")) << refusal;
}

TEST(BitingMesherMessages, CountWhatTheyDoNotList)
{
  auto input = UnitSquare();
  for (int k = 0; k < 12; ++k)
  {
    AddVertex(input, { 2.0 + k, 3.0, 0.0 });
  }
  const std::string warning = WarningOf(input);
  EXPECT_TRUE(Has(warning, "Embedded points outside of the domain (12)")) << warning;
  EXPECT_TRUE(Has(warning,
    "point 4 near (2, 3, 0), point 5, point 6, point 7, point 8, ... and "
    "7 more"))
    << warning;
}

TEST(BitingMesherMessages, NameZeroLengthSegments)
{
  auto input = EmptyInput();
  AddChain(input, { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } }, true);
  vtkNew<vtkBitingMesher> mesher;
  const auto warnings = WarningsOf(input, mesher);
  ASSERT_FALSE(warnings.empty());
  EXPECT_NEAR(AreaOf(mesher->GetOutput()), 1.0, 1e-12);
}

TEST(BitingMesherMessages, NameInterfacesOutside)
{
  auto input = UnitSquare();
  AddChain(input, { { 3, 3, 0 }, { 4, 4, 0 } }, false);
  EXPECT_TRUE(Has(WarningOf(input), "Interfaces outside of the domain (1): cell 1"));
  EXPECT_TRUE(Has(WarningOf(input), "Clip or IsoVolume give the whole area"));
}

TEST(BitingMesherMessages, RefuseInputWithoutALoop)
{
  auto input = EmptyInput();
  AddChain(input, { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 } }, false);
  const std::string refusal = RefusalOf(input);
  EXPECT_TRUE(
    Has(refusal, "There is no closed loop, and so no domain (2 open ends): open end at point 0"))
    << refusal;
}

TEST(BitingMesherMessages, RefuseAKindArrayThatIsTooShort)
{
  auto input = UnitSquare();
  AddArray<vtkDoubleArray>(input->GetCellData(), "Kind", {});
  EXPECT_TRUE(Has(RefusalOf(input), "The cell array Kind has 0 values for 1 cells."));
}

TEST(BitingMesherMessages, RefuseASpacingArrayThatIsTooShort)
{
  auto input = UnitSquare();
  AddArray<vtkDoubleArray>(input->GetPointData(), "Spacing", { 0.1, 0.1 });
  EXPECT_TRUE(Has(RefusalOf(input), "The spacing array Spacing has 2 values for 4 points."));
}

TEST(BitingMesherMessages, LeaveOutACellArrayThatIsTooShort)
{
  auto input = UnitSquare();
  AddArray<vtkDoubleArray>(input->GetCellData(), "Tag", {});
  vtkNew<vtkBitingMesher> mesher;
  EXPECT_TRUE(WarningsOf(input, mesher).empty());
  EXPECT_EQ(mesher->GetOutput(1)->GetCellData()->GetArray("Tag"), nullptr);
}

TEST(BitingMesherMessages, RefuseALoopDrawnTwiceAndSayWhy)
{
  auto input = UnitSquare();
  AddChain(input, { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } }, true);
  const std::string refusal = RefusalOf(input);
  EXPECT_TRUE(Has(
    refusal, "There is no closed loop, and so no domain: 4 boundary segments are drawn an even"))
    << refusal;
  EXPECT_TRUE(Has(refusal, "near (0, 0, 0). Close")) << refusal;
}

TEST(BitingMesherMessages, RefuseCoordinatesThatAreNotFinite)
{
  auto input = EmptyInput();
  AddChain(input, { { 0, 0, 0 }, { 1, 0, 0 }, { std::nan(""), 1, 0 } }, true);
  const std::string refusal = RefusalOf(input);
  EXPECT_TRUE(Has(refusal, "not finite (1): point 2 near (nan, 1, 0)")) << refusal;
}

TEST(BitingMesherMessages, RefuseLoopsThatAreNotPlanar)
{
  auto input = EmptyInput();
  AddChain(input, { { 0, 0, 0.1 }, { 1, 0, -0.1 }, { 1, 1, 0.1 }, { 0, 1, -0.1 } }, true);
  const std::string refusal = RefusalOf(input);
  EXPECT_TRUE(Has(refusal, "not planar")) << refusal;
  // All four are equally far, but for rounding.
  EXPECT_TRUE(Has(refusal, "(4): point ")) << refusal;
  EXPECT_TRUE(Has(refusal, " (it lies 0.10")) << refusal;
}

TEST(BitingMesherMessages, AcceptLoopsThatArePlanarWithinTheTolerance)
{
  auto input = EmptyInput();
  AddChain(input, { { 0, 0, 1e-7 }, { 1, 0, -1e-7 }, { 1, 1, 1e-7 }, { 0, 1, -1e-7 } }, true);
  vtkNew<vtkBitingMesher> mesher;
  EXPECT_TRUE(WarningsOf(input, mesher).empty());
  EXPECT_NEAR(AreaOf(mesher->GetOutput()), 1.0, 1e-6);
}

TEST(BitingMesherMessages, RefuseABoundarySpacingThatIsNotPositive)
{
  for (const double bad : { 0.0, -1.0, std::nan("") })
  {
    auto input = UnitSquare();
    AddArray<vtkDoubleArray>(input->GetPointData(), "Spacing", { 0.1, 0.1, bad, 0.1 });
    const std::string refusal = RefusalOf(input);
    EXPECT_TRUE(Has(refusal, "The spacing array Spacing has values")) << refusal;
    EXPECT_TRUE(Has(refusal, "(1): point 2 with")) << refusal;
    EXPECT_TRUE(Has(refusal, "at (1, 1, 0)")) << refusal;
  }
}

TEST(BitingMesherMessages, RefuseMoreVerticesThanAllowedWithTheEstimate)
{
  vtkNew<vtkBitingMesher> mesher;
  mesher->SetUniformSpacing(1e-9);
  const std::string refusal = RefusalOf(UnitSquare(), mesher);
  EXPECT_TRUE(Has(refusal, "Maximum Number Of Vertices")) << refusal;
  EXPECT_TRUE(Has(refusal, "e+18")) << refusal;
}

TEST(BitingMesherMessages, RefuseAnUnknownKindWithItsCell)
{
  auto input = UnitSquare();
  AddArray<vtkDoubleArray>(input->GetCellData(), "Kind", { 7.0 });
  EXPECT_TRUE(Has(RefusalOf(input), "Cell 0 has an unknown Kind, 7"));
  auto named = UnitSquare();
  vtkNew<vtkStringArray> names;
  names->SetName("Kind");
  names->InsertNextValue("boundary");
  named->GetCellData()->AddArray(names);
  EXPECT_TRUE(Has(RefusalOf(named), "Kind is not numeric"));
}

TEST(BitingMesherMessages, RefuseCellsWhosePointsDoNotExist)
{
  auto input = UnitSquare();
  input->GetLines()->InsertNextCell({ 0, 99 });
  EXPECT_TRUE(Has(RefusalOf(input), "Cell 1 of the input refers to point 99"));
}

TEST(BitingMesherMessages, RefuseParametersOutOfRangeByName)
{
  const auto refusal = [](void (*change)(vtkBitingMesher*))
  {
    vtkNew<vtkBitingMesher> mesher;
    change(mesher);
    return RefusalOf(UnitSquare(), mesher);
  };
  using Mesher = vtkBitingMesher*;
  EXPECT_TRUE(Has(refusal([](Mesher m) { m->SetUniformSpacing(-1.0); }), "Uniform Spacing"));
  EXPECT_TRUE(Has(refusal([](Mesher m) { m->SetSpacingScale(0.0); }), "Spacing Scale"));
  EXPECT_TRUE(Has(refusal([](Mesher m) { m->SetMinimumSpacing(-1.0); }), "Minimum Spacing"));
  EXPECT_TRUE(Has(refusal([](Mesher m) { m->SetMaximumSpacing(HUGE_VAL); }), "Maximum Spacing"));
  EXPECT_TRUE(Has(refusal([](Mesher m) { m->SetGradation(std::nan("")); }), "Gradation"));
  EXPECT_TRUE(Has(refusal([](Mesher m) { m->SetBitingConstant(0.05); }), "Biting Constant"));
  EXPECT_TRUE(Has(refusal([](Mesher m) { m->SetPhi(0.0); }), "Phi"));
  EXPECT_TRUE(
    Has(refusal([](Mesher m) { m->SetMaximumNumberOfBites(-2); }), "Maximum Number Of Bites"));
  EXPECT_TRUE(
    Has(refusal([](Mesher m) { m->SetMaximumNumberOfVertices(0); }), "Maximum Number Of Vertices"));
}

TEST(BitingMesherMessages, AreAbsentForEmptyInput)
{
  vtkNew<vtkPolyData> nothing;
  vtkNew<vtkBitingMesher> mesher;
  Messages messages(mesher);
  mesher->SetInputData(nothing);
  mesher->Update();
  EXPECT_TRUE(messages.Errors.empty());
  EXPECT_TRUE(messages.Warnings.empty());
  EXPECT_TRUE(messages.OfExecutive.empty());
  EXPECT_TRUE(AreAllEmpty(mesher));
}

TEST(BitingMesherMessages, AreOneSentenceForPointsWithoutCells)
{
  auto onlyPoints = EmptyInput();
  const Place place{ 1.0, 2.0, 3.0 };
  onlyPoints->GetPoints()->InsertNextPoint(place.data());
  vtkNew<vtkBitingMesher> mesher;
  Messages messages(mesher);
  mesher->SetInputData(onlyPoints);
  mesher->Update();
  EXPECT_TRUE(messages.Warnings.empty());
  ASSERT_EQ(messages.Errors.size(), 1u);
  EXPECT_TRUE(Has(messages.Errors.front(), "points, but no cells"));
  EXPECT_TRUE(AreAllEmpty(mesher));
  // Nor with cells that have too few of them, in an input with points or without.
  onlyPoints->GetPolys()->InsertNextCell({ 0, 0 });
  onlyPoints->Modified();
  vtkNew<vtkPolyData> nothing;
  const vtkIdType none = 0;
  nothing->AllocateExact(1, 1);
  nothing->InsertNextCell(VTK_POLY_LINE, 0, &none);
  for (vtkPolyData* input : { onlyPoints.Get(), nothing.Get() })
  {
    mesher->SetInputData(input);
    mesher->Update();
    EXPECT_TRUE(Has(messages.Errors.back(), "No cell of the input describes a domain"));
  }
  EXPECT_EQ(messages.Errors.size(), 3u);
}

TEST(BitingMesherMessages, LeaveNoErrorCodeWhereTheNextRunIsGood)
{
  vtkNew<vtkBitingMesher> mesher;
  mesher->SetUniformSpacing(-1.0);
  RefusalOf(UnitSquare(), mesher);
  mesher->SetUniformSpacing(0.1);
  mesher->Update();
  EXPECT_GT(mesher->GetOutput()->GetNumberOfCells(), 0);
  EXPECT_EQ(mesher->GetErrorCode(), vtkErrorCode::NoError);
}
