// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SeenProblems.h"

#include "vtkAppendPolyData.h"
#include "vtkImageData.h"
#include "vtkLine.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace testing_filters;

namespace
{

/// (x, y) on a plane that leans.
Place Leaning(double x, double y)
{
  return { 3.0 + 0.8 * x, -1.0 + y, 7.0 + 0.6 * x };
}

/// A square in a leaning plane, and lines of two points across it, in a fixed disorder.
vtkSmartPointer<vtkPolyData> CrossedSquare(int numberOfLines)
{
  auto input = EmptyInput();
  AddChain(input, { Leaning(0, 0), Leaning(1, 0), Leaning(1, 1), Leaning(0, 1) }, true);
  for (int k = 0; k < numberOfLines; ++k)
  {
    const double x = 0.1 + 0.8 * k / numberOfLines;
    const double y = 0.1 + 0.8 * (7 * k % numberOfLines) / numberOfLines;
    AddChain(input, { Leaning(x, 0.05), Leaning(0.95, y) }, false);
  }
  return input;
}

double DistanceToCell(const Place& place, vtkPolyData* input, vtkIdType cell)
{
  vtkNew<vtkIdList> ids;
  input->GetCellPoints(cell, ids);
  double least = HUGE_VAL;
  for (vtkIdType k = 0; k + 1 < ids->GetNumberOfIds(); ++k)
  {
    const Place start = PointOf(input, ids->GetId(k));
    const Place end = PointOf(input, ids->GetId(k + 1));
    double along = 0.0;
    Place closest;
    least = std::min(least,
      vtkLine::DistanceToLine(place.data(), start.data(), end.data(), along, closest.data()));
  }
  return std::sqrt(least);
}

/// The unit square with one of each thing that is repaired.
vtkSmartPointer<vtkPolyData> DefectiveSquare()
{
  auto input = UnitSquare();
  AddChain(input, { { 0.25, 0, 0 }, { 0.75, 0, 0 } }, false);
  AddChain(input, { { 0.2, 0.3, 0 }, { 0.8, 0.3, 0 } }, false);
  AddChain(input, { { 0.5, 0.1, 0 }, { 0.5, 0.6, 0 }, { 0.5, 0.6, 0 }, { 0.4, 0.7, 0 } }, false);
  AddChain(input, { { 3, 3, 0 }, { 4, 4, 0 } }, false);
  AddVertex(input, { 5, 5, 0 });
  AddVertex(input, { 6, 5, 0 });
  return input;
}

} // namespace

TEST(BitingMesherProblems, AreNoneWhereNothingIsWrong)
{
  vtkNew<vtkBitingMesher> mesher;
  mesher->SetInputData(UnitSquare());
  const Outcome run = RunOf(mesher);
  EXPECT_TRUE(run.Problems.empty());
  EXPECT_EQ(run.Counts, std::vector<vtkIdType>(NumberOfKinds, 0));
}

TEST(BitingMesherProblems, NameTheirKinds)
{
  vtkNew<vtkBitingMesher> mesher;
  mesher->SetInputData(UnitSquare());
  mesher->Update();
  auto* names = vtkStringArray::SafeDownCast(
    mesher->GetOutput(3)->GetFieldData()->GetAbstractArray("ProblemKindNames"));
  ASSERT_TRUE(names);
  ASSERT_EQ(names->GetNumberOfValues(), NumberOfKinds);
  EXPECT_EQ(names->GetValue(vtkBitingMesher::DUPLICATE_POINTS), "DuplicatePoints");
  EXPECT_EQ(names->GetValue(vtkBitingMesher::CROSSINGS), "Crossings");
  EXPECT_EQ(names->GetValue(vtkBitingMesher::NO_CLOSED_LOOP), "NoClosedLoop");
  EXPECT_EQ(names->GetValue(vtkBitingMesher::NOT_PLANAR), "NotPlanar");
  EXPECT_EQ(names->GetValue(vtkBitingMesher::BAD_SPACING), "BadSpacing");
  EXPECT_EQ(names->GetValue(vtkBitingMesher::CHECK_FAILED), "CheckFailed");
  EXPECT_EQ(names->GetValue(vtkBitingMesher::OVERLAPPING_CELLS), "OverlappingCells");
}

TEST(BitingMesherProblems, AreAsManyAsTheWarningsSay)
{
  const Outcome run = RunOf(DefectiveSquare());
  EXPECT_TRUE(run.Errors.empty());
  vtkIdType kinds = 0;
  for (int kind = 0; kind < NumberOfKinds; ++kind)
  {
    const auto count = static_cast<vtkIdType>(run.Of(kind).size());
    EXPECT_EQ(count, run.Counts[kind]) << kind;
    kinds += count > 0 ? 1 : 0;
    const std::string told = " (" + std::to_string(count) + "): ";
    EXPECT_TRUE(count == 0 ||
      std::any_of(run.Warnings.begin(), run.Warnings.end(),
        [&told](const std::string& warning) { return Has(warning, told); }))
      << kind;
  }
  EXPECT_EQ(kinds, static_cast<vtkIdType>(run.Warnings.size()));
  EXPECT_GE(kinds, 5);
  for (const SeenProblem& problem : run.Problems)
  {
    EXPECT_EQ(problem.IsError, 0);
    EXPECT_FALSE(problem.Message.empty());
  }
}

TEST(BitingMesherProblems, LieOnBothSegmentsThatCross)
{
  const auto input = CrossedSquare(40);
  const Outcome run = RunOf(input);
  const auto crossings = run.Of(vtkBitingMesher::CROSSINGS);
  ASSERT_GT(crossings.size(), 100u);
  EXPECT_EQ(static_cast<vtkIdType>(crossings.size()), run.Counts[vtkBitingMesher::CROSSINGS]);
  for (const SeenProblem& crossing : crossings)
  {
    EXPECT_LT(DistanceToCell(crossing.Where, input, crossing.FirstId), 1e-12);
    EXPECT_LT(DistanceToCell(crossing.Where, input, crossing.SecondId), 1e-12);
  }
}

TEST(BitingMesherProblems, LieAtTheVeryPointThatTouches)
{
  auto input = EmptyInput();
  AddChain(input, { Leaning(0, 0), Leaning(1, 0), Leaning(1, 1), Leaning(0, 1) }, true);
  const Place start = Leaning(0.5, 0.25);
  const Place end = Leaning(0.5, 0.75);
  AddChain(input, { start, end }, false);
  AddChain(input, { end, start, Leaning(0.25, 0.5) }, true);
  AddChain(input,
    { { 0.5 * (start[0] + end[0]), 0.5 * (start[1] + end[1]), start[2] }, Leaning(0.75, 0.5),
      Leaning(0.8, 0.6) },
    true);
  const Outcome run = RunOf(input);
  const auto touches = run.Of(vtkBitingMesher::TOUCHES);
  ASSERT_FALSE(touches.empty());
  for (const SeenProblem& touch : touches)
  {
    ASSERT_GE(touch.SecondId, 0);
    EXPECT_EQ(touch.Where, PointOf(input, touch.SecondId));
  }
}

TEST(BitingMesherProblems, ShowEmbeddedPointsOutsideWhereTheyAre)
{
  const auto input = DefectiveSquare();
  const auto outside = RunOf(input).Of(vtkBitingMesher::OUTSIDE_POINTS);
  ASSERT_EQ(outside.size(), 2u);
  for (const SeenProblem& problem : outside)
  {
    EXPECT_EQ(problem.Where, PointOf(input, problem.FirstId));
    EXPECT_EQ(problem.SecondId, -1);
  }
  EXPECT_EQ(outside[0].Message,
    "Embedded points outside of the domain: point " + std::to_string(outside[0].FirstId) +
      " at (5, 5, 0)");
}

TEST(BitingMesherProblems, AreKeptUpToTheLimitAndCountedBeyond)
{
  auto input = UnitSquare();
  for (int k = 0; k < 12000; ++k)
  {
    AddVertex(input, { 2.0 + k, 3.0, 0.0 });
  }
  const Outcome run = RunOf(input);
  EXPECT_EQ(run.Problems.size(), 10000u);
  EXPECT_EQ(run.Counts[vtkBitingMesher::OUTSIDE_POINTS], 12000);
}

TEST(BitingMesherProblems, AreTheSamePlacesAsErrorsWhereRepairIsOff)
{
  vtkNew<vtkBitingMesher> mesher;
  mesher->SetInputData(CrossedSquare(10));
  mesher->SetUniformSpacing(0.1);
  const Outcome repaired = RunOf(mesher);
  EXPECT_TRUE(repaired.Errors.empty());
  mesher->RepairInputOff();
  const Outcome refused = RunOf(mesher);
  EXPECT_EQ(refused.Errors.size(), 1u);
  EXPECT_TRUE(AreAllEmpty(mesher));
  ASSERT_EQ(refused.Problems.size(), repaired.Problems.size());
  for (std::size_t k = 0; k < refused.Problems.size(); ++k)
  {
    EXPECT_EQ(refused.Problems[k].IsError, 1);
    EXPECT_EQ(repaired.Problems[k].IsError, 0);
    EXPECT_EQ(refused.Problems[k].Kind, repaired.Problems[k].Kind);
    EXPECT_EQ(refused.Problems[k].Where, repaired.Problems[k].Where);
  }
}

TEST(BitingMesherProblems, ShowOpenEndsThatWereJoinedWhereTheyWere)
{
  auto input = EmptyInput();
  AddChain(input, { Leaning(0, 0), Leaning(1, 0), Leaning(1, 1), Leaning(0, 1) }, true);
  AddChain(input, { Leaning(2e-4, 0.3), Leaning(0.5, 0.4), Leaning(1 - 1e-6, 0.6) }, false);
  vtkNew<vtkBitingMesher> mesher;
  mesher->SetInputData(input);
  mesher->SetUniformSpacing(0.1);
  const Outcome repaired = RunOf(mesher);
  const auto ends = repaired.Of(vtkBitingMesher::JOINED_ENDS);
  ASSERT_EQ(ends.size(), 2u);
  EXPECT_EQ(ends[0].FirstId, 4);
  EXPECT_EQ(ends[0].SecondId, 0);
  EXPECT_EQ(ends[0].Where, PointOf(input, 4));
  EXPECT_EQ(ends[1].FirstId, 6);
  ASSERT_EQ(repaired.Warnings.size(), 1u);
  EXPECT_TRUE(Has(repaired.Warnings[0], "(2): point 4 with cell 0 near (3.00016, -0.7, 7.00012)"));
  EXPECT_TRUE(Has(repaired.Warnings[0], "(moved by 0.0002, which is the most)"));
  EXPECT_NEAR(AreaOf(mesher->GetOutput()), 1.0, 1e-12);
  EXPECT_EQ(Figure(mesher->GetOutput(), "RepairedOpenEnds"), 2.0);
  mesher->RepairInputOff();
  const Outcome refused = RunOf(mesher);
  EXPECT_EQ(refused.Of(vtkBitingMesher::JOINED_ENDS).size(), 2u);
  ASSERT_EQ(refused.Errors.size(), 1u);
  EXPECT_TRUE(Has(refused.Errors[0], "Repair Input is off, and the input is not clean. Open ends"));
}

TEST(BitingMesherProblems, ShowTheGapOfAnOutline)
{
  auto input = EmptyInput();
  AddChain(input, { { 0.4, 0.4, 0 }, { 0.6, 0.4, 0 }, { 0.5, 0.6, 0 } }, true);
  AddChain(input, { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0.3, 0 } }, false);
  vtkNew<vtkBitingMesher> mesher;
  mesher->SetInputData(input);
  mesher->SetUniformSpacing(0.1);
  const Outcome run = RunOf(mesher);
  EXPECT_TRUE(AreAllEmpty(mesher));
  ASSERT_EQ(run.Errors.size(), 1u);
  EXPECT_TRUE(Has(run.Errors[0], "Outlines that do not close"));
  EXPECT_TRUE(Has(run.Errors[0], "(a gap of 0.3; an End Tolerance of 3 closes it)"));
  const auto gaps = run.Of(vtkBitingMesher::OPEN_OUTLINES);
  ASSERT_EQ(gaps.size(), 1u);
  EXPECT_EQ(gaps[0].IsError, 1);
  EXPECT_EQ(gaps[0].FirstId, 3);
  EXPECT_EQ(gaps[0].SecondId, 7);
  mesher->SetEndTolerance(3.0);
  EXPECT_TRUE(RunOf(mesher).Errors.empty());
  EXPECT_NEAR(AreaOf(mesher->GetOutput()), 0.98, 1e-12);
}

TEST(BitingMesherProblems, AreNoPlanesForALineInSpace)
{
  auto input = EmptyInput();
  AddChain(input, { { 0, 0, 0 }, { 0.3, 0.7, 0.9 }, { 1.5, 3.5, 4.5 } }, true);
  vtkNew<vtkBitingMesher> mesher;
  mesher->SetInputData(input);
  const Outcome run = RunOf(mesher);
  ASSERT_EQ(run.Errors.size(), 1u);
  EXPECT_TRUE(Has(run.Errors[0], "all lie on one straight line; the first of them"))
    << run.Errors[0];
}

TEST(BitingMesherProblems, ShowTheOpenEndsWhereNoLoopIsClosed)
{
  auto input = EmptyInput();
  AddChain(input, { { 0, 0, 2 }, { 1, 0, 2 }, { 1, 1, 2 } }, false);
  AddChain(input, { { 1, 1, 2 }, { 0, 1, 2 } }, false);
  AddChain(input, { { 5, 5, 2 }, { 6, 5, 2 } }, false);
  const Outcome run = RefusalOf(input);
  const auto ends = run.Of(vtkBitingMesher::NO_CLOSED_LOOP);
  std::vector<vtkIdType> ids;
  for (const SeenProblem& end : ends)
  {
    ids.push_back(end.FirstId);
    EXPECT_EQ(end.Where, PointOf(input, end.FirstId));
  }
  std::sort(ids.begin(), ids.end());
  EXPECT_EQ(ids, (std::vector<vtkIdType>{ 0, 4, 5, 6 }));
  EXPECT_TRUE(Has(run.Errors[0], "(4 open ends): open end at point 0 near (0, 0, 2)"))
    << run.Errors[0];
}

TEST(BitingMesherProblems, ShowNoPlaceWhereClosedLoopsBoundNothing)
{
  auto input = UnitSquare();
  AddArray<vtkDoubleArray>(input->GetCellData(), "Kind", { 1.0 });
  const Outcome run = RefusalOf(input);
  EXPECT_TRUE(run.Problems.empty());
  EXPECT_EQ(run.Counts[vtkBitingMesher::NO_CLOSED_LOOP], 1);
  EXPECT_TRUE(Has(run.Errors[0],
    "There is no closed loop, and so no domain: there are interfaces only, the first of cell 0 "
    "near (0, 0, "
    "0)"))
    << run.Errors[0];
}

TEST(BitingMesherProblems, ShowPointsThatAreNotFiniteBesideThem)
{
  auto input = EmptyInput();
  const double nan = std::nan("");
  AddChain(input, { { nan, 0, 0 }, { 1, 0, 0 }, { 1, HUGE_VAL, 0 }, { nan, 0, 0 } }, false);
  AddVertex(input, { nan, nan, nan });
  const Outcome run = RefusalOf(input);
  EXPECT_EQ(run.Counts[vtkBitingMesher::NOT_FINITE], 4);
  ASSERT_EQ(run.Problems.size(), 3u);
  for (const SeenProblem& problem : run.Problems)
  {
    EXPECT_EQ(problem.Where, PointOf(input, 1));
  }
  EXPECT_EQ(run.Problems[1].FirstId, 2);
  EXPECT_TRUE(Has(run.Problems[1].Message, "point 2 at (1, inf, 0)")) << run.Problems[1].Message;
}

TEST(BitingMesherProblems, ShowPointsOffThePlaneWorstFirst)
{
  auto input = EmptyInput();
  std::vector<Place> circle;
  for (int k = 0; k < 24; ++k)
  {
    circle.push_back({ std::cos(k * 0.26), std::sin(k * 0.26), 1e-3 * (k % 5) });
  }
  circle[7][2] = 0.25;
  AddChain(input, circle, true);
  const Outcome run = RefusalOf(input);
  const auto off = run.Of(vtkBitingMesher::NOT_PLANAR);
  ASSERT_GT(off.size(), 5u);
  EXPECT_EQ(off.front().FirstId, 7);
  for (const SeenProblem& problem : off)
  {
    EXPECT_EQ(problem.Where, PointOf(input, problem.FirstId));
  }
  EXPECT_TRUE(Has(off.front().Message, "it lies 0.2")) << off.front().Message;
}

TEST(BitingMesherProblems, ShowValuesOfTheInputThatAreNoSpacing)
{
  auto input = UnitSquare(5.0);
  AddArray<vtkDoubleArray>(input->GetPointData(), "Spacing", { 0.1, 0.0, 0.1, std::nan("") });
  const Outcome run = RefusalOf(input);
  ASSERT_EQ(run.Problems.size(), 2u);
  EXPECT_EQ(run.Counts[vtkBitingMesher::BAD_SPACING], 2);
  EXPECT_EQ(run.Problems[1].Kind, vtkBitingMesher::BAD_SPACING);
  EXPECT_EQ(run.Problems[1].FirstId, 3);
  EXPECT_EQ(run.Problems[1].Where, PointOf(input, 3));
  EXPECT_EQ(
    run.Problems[0].Message, "The spacing array Spacing of the input: point 1 with 0 at (1, 0, 5)");
}

TEST(BitingMesherProblems, ShowValuesOfTheSourceThatAreNoSpacing)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(3, 3, 1);
  AddArray<vtkDoubleArray>(
    image->GetPointData(), "Spacing", { 1, 1, 1, 1, -1, 1, 1, 1, std::nan("") });
  vtkNew<vtkBitingMesher> mesher;
  mesher->SetInputData(UnitSquare());
  mesher->SetSpacingSourceData(image);
  const Outcome run = RunOf(mesher);
  EXPECT_EQ(run.Errors.size(), 1u);
  ASSERT_EQ(run.Problems.size(), 1u);
  EXPECT_EQ(run.Problems[0].FirstId, 4);
  EXPECT_EQ(run.Problems[0].Where, (Place{ 1.0, 1.0, 0.0 }));
  EXPECT_TRUE(Has(run.Problems[0].Message, "of the source")) << run.Problems[0].Message;
}

TEST(BitingMesherProblems, ShowRepairsEvenWhereTheMeshIsRefusedForItsSize)
{
  const Outcome run = RunOf(DefectiveSquare(), 1e-9);
  EXPECT_EQ(run.Errors.size(), 1u);
  EXPECT_EQ(run.Counts[vtkBitingMesher::TOO_MANY_VERTICES], 1);
  EXPECT_TRUE(run.Of(vtkBitingMesher::TOO_MANY_VERTICES).empty());
  ASSERT_EQ(run.Of(vtkBitingMesher::OUTSIDE_POINTS).size(), 2u);
  EXPECT_EQ(run.Of(vtkBitingMesher::OUTSIDE_POINTS)[0].IsError, 0);
}

TEST(BitingMesherProblems, ReachTheNextFilterAfterARefusal)
{
  auto input = EmptyInput();
  AddChain(input, { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 } }, false);
  vtkNew<vtkBitingMesher> mesher;
  mesher->SetInputData(input);
  vtkNew<vtkAppendPolyData> next;
  next->SetInputConnection(mesher->GetOutputPort(vtkBitingMesher::PROBLEMS));
  Messages messages(mesher);
  mesher->Update();
  next->Update();
  next->Update();
  EXPECT_EQ(next->GetOutput()->GetNumberOfPoints(), 2);
  EXPECT_EQ(messages.Errors.size(), 1u);
}

TEST(BitingMesherProblems, AreForgottenByTheNextRun)
{
  vtkNew<vtkBitingMesher> mesher;
  mesher->SetInputData(DefectiveSquare());
  mesher->SetUniformSpacing(0.1);
  EXPECT_FALSE(RunOf(mesher).Problems.empty());
  mesher->SetInputData(UnitSquare());
  EXPECT_TRUE(RunOf(mesher).Problems.empty());
}

TEST(BitingMesherProblems, AreEmptyForEmptyInputAndAfterAnAbort)
{
  vtkNew<vtkBitingMesher> mesher;
  mesher->SetInputData(EmptyInput());
  mesher->Update();
  EXPECT_TRUE(IsEmpty(mesher->GetOutput(vtkBitingMesher::PROBLEMS)));
  vtkNew<vtkCallbackCommand> abort;
  abort->SetCallback([](vtkObject* caller, unsigned long, void*, void*)
    { vtkAlgorithm::SafeDownCast(caller)->SetAbortExecute(1); });
  mesher->AddObserver(vtkCommand::ProgressEvent, abort);
  Messages messages(mesher);
  mesher->SetInputData(DefectiveSquare());
  mesher->Update();
  EXPECT_TRUE(messages.Errors.empty());
  EXPECT_TRUE(AreAllEmpty(mesher));
  EXPECT_TRUE(IsEmpty(mesher->GetOutput(vtkBitingMesher::PROBLEMS)));
}
