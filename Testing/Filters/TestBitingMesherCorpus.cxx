// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "CorpusCase.h"
#include "CorpusIndex.h"
#include "MeshChecker.h"

#include <gtest/gtest.h>

#include <iostream>
#include <limits>
#include <sstream>

using namespace testing_filters;

namespace
{

struct Segment
{
  vtkIdType Line;
  biting::Point2 Start;
  biting::Point2 End;
};

std::vector<Segment> SegmentsOf(vtkPolyData* input)
{
  std::vector<Segment> segments;
  vtkNew<vtkIdList> ids;
  for (vtkIdType line = 0; line < input->GetNumberOfLines(); ++line)
  {
    input->GetLines()->GetCellAtId(line, ids);
    for (vtkIdType k = 1; k < ids->GetNumberOfIds(); ++k)
    {
      const Place a = PointOf(input, ids->GetId(k - 1));
      const Place b = PointOf(input, ids->GetId(k));
      if (a != b)
      {
        segments.push_back({ line, { a[0], a[1] }, { b[0], b[1] } });
      }
    }
  }
  return segments;
}

double DistanceTo(const Segment& segment, const biting::Point2& p)
{
  const biting::Point2 along = segment.End - segment.Start;
  const double share = Dot(p - segment.Start, along) / Dot(along, along);
  const double t = std::min(std::max(share, 0.0), 1.0);
  return Distance(p, segment.Start + t * along);
}

// Whether another segment runs so near that the two cannot be told apart: as boundary they cancel.
bool HasTwin(const std::vector<Segment>& segments, const Segment& segment, double rounding)
{
  const biting::Point2 middle = Midpoint(segment.Start, segment.End);
  int near = 0;
  for (const Segment& other : segments)
  {
    near += DistanceTo(other, middle) <= rounding ? 1 : 0;
  }
  return near > 1;
}

// The segment, divided at all ends of other segments that cannot be told from points on it.
std::vector<Segment> PartsOf(
  const std::vector<Segment>& segments, const Segment& segment, double rounding)
{
  std::vector<biting::Point2> places{ segment.End };
  for (const Segment& other : segments)
  {
    if (DistanceTo(segment, other.Start) <= rounding)
    {
      places.push_back(other.Start);
    }
  }
  std::sort(places.begin(), places.end(),
    [&segment](const biting::Point2& a, const biting::Point2& b)
    { return Distance(a, segment.Start) < Distance(b, segment.Start); });
  std::vector<Segment> parts;
  biting::Point2 start = segment.Start;
  for (const biting::Point2& place : places)
  {
    if (place != start)
    {
      parts.push_back({ segment.Line, start, place });
    }
    start = place;
  }
  return parts;
}

std::string TextOf(const biting::Point2& p)
{
  std::ostringstream text;
  text.precision(17);
  text << '(' << p.X << ", " << p.Y << ')';
  return text.str();
}

// Checks that the lines of the input are unions of edges; interfaces only where none was dropped.
std::string CheckLines(vtkPolyData* input, vtkPolyData* mesh, const MeshChecker& checker)
{
  const bool areInterfacesKept = Figure(mesh, "DroppedOutsideInterfaces") == 0.0;
  const double rounding = RoundingOf(input);
  const std::vector<Segment> segments = SegmentsOf(input);
  const auto isCovered = [&](const Segment& segment)
  {
    const double tolerance = rounding + 1e-12 * Distance(segment.Start, segment.End);
    return checker.Covers(segment.Start, segment.End, tolerance);
  };
  const auto isCoveredOrCancelled = [&](const Segment& segment)
  { return isCovered(segment) || HasTwin(segments, segment, rounding); };
  for (const Segment& segment : segments)
  {
    const double kind = KindOf(input, input->GetNumberOfVerts() + segment.Line);
    const bool isWanted = kind == 0.0 || (kind == 1.0 && areInterfacesKept);
    if (isWanted && !isCovered(segment))
    {
      const std::vector<Segment> parts = PartsOf(segments, segment, rounding);
      if (!std::all_of(parts.begin(), parts.end(), isCoveredOrCancelled))
      {
        return "the segment of line " + std::to_string(segment.Line) + " from " +
          TextOf(segment.Start) + " to " + TextOf(segment.End) + " is no union of edges";
      }
    }
  }
  return "";
}

std::string CheckEmbeddedPoints(vtkPolyData* input, vtkPolyData* mesh, const MeshChecker& checker)
{
  double missing = 0.0;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < input->GetNumberOfVerts(); ++cell)
  {
    input->GetVerts()->GetCellAtId(cell, ids);
    for (vtkIdType k = 0; k < ids->GetNumberOfIds(); ++k)
    {
      const Place place = PointOf(input, ids->GetId(k));
      missing += checker.HasVertex({ place[0], place[1] }) ? 0.0 : 1.0;
    }
  }
  return missing <= Figure(mesh, "DroppedOutsidePoints") ? "" : "an embedded point is missing";
}

// Checks the area, up to the rounding of the input's coordinates.
std::string CheckArea(const Case& example, const MeshChecker& checker)
{
  const double rounding = PerimeterOf(example.Input) * RoundingOf(example.Input);
  return std::isnan(example.Area) ? ""
                                  : checker.CheckArea(example.Area, 1e-9 * example.Area + rounding);
}

// Meshes and judges. Returns the first thing that is wrong, empty where nothing is.
std::string Judge(const Case& example)
{
  vtkNew<vtkBitingMesher> mesher;
  Messages messages(mesher);
  mesher->SetInputData(example.Input);
  mesher->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "None");
  mesher->SetUniformSpacing(example.Spacing);
  mesher->Update();
  if (!messages.Errors.empty())
  {
    return messages.Errors.front();
  }
  vtkPolyData* mesh = mesher->GetOutput();
  const MeshChecker checker(mesh);
  std::string verdict = checker.CheckValidity();
  verdict = verdict.empty() ? CheckArea(example, checker) : verdict;
  verdict = verdict.empty() ? CheckLines(example.Input, mesh, checker) : verdict;
  return verdict.empty() ? CheckEmbeddedPoints(example.Input, mesh, checker) : verdict;
}

bool IsFlat(vtkPolyData* input)
{
  double bounds[6];
  input->GetBounds(bounds);
  return bounds[4] == bounds[5];
}

Case CaseOf(const CorpusEntry& entry)
{
  return { entry.File, ReadPolyData(SharedInputs() + "/" + entry.File), entry.Spacing, entry.Area };
}

// Judges the valid inputs of the shared corpus with up to `limit` points after a change; those that
// do not lie in a plane of constant z are left to the tests of planes.
void JudgeSharedInputs(vtkIdType limit, const Change& change)
{
  const auto entries = SharedEntries({ "V", "W" });
  if (entries.empty())
  {
    std::cout << "No shared inputs: nothing judged.\n";
  }
  for (const CorpusEntry& entry : entries)
  {
    Case example = CaseOf(entry);
    if (IsFlat(example.Input) && example.Input->GetNumberOfPoints() <= limit)
    {
      change(example);
      EXPECT_EQ(Judge(example), "") << entry.File;
    }
  }
}

} // namespace

TEST(Corpus, OfDataIsNotEmptyAndIsMeshed)
{
  const std::string folder = std::string(BITING_SOURCE_DIR) + "/Data/";
  int inputs = 0;
  for (const std::string& file : DataFiles(folder))
  {
    const auto data = Read(folder + file);
    ASSERT_TRUE(data) << file;
    auto* input = vtkPolyData::SafeDownCast(data);
    if (input && input->GetNumberOfLines() > 0)
    {
      ++inputs;
      EXPECT_EQ(Judge({ file, input, 0.01 * SizeOf(input), std::nan("") }), "") << file;
    }
  }
  EXPECT_GT(inputs, 0);
}

TEST(Corpus, OfDataIsMeshedWithItsOwnSpacing)
{
  const std::string folder = std::string(BITING_SOURCE_DIR) + "/Data/";
  for (const std::string& file : DataFiles(folder))
  {
    auto input = vtkPolyData::SafeDownCast(Read(folder + file));
    if (input && input->GetPointData()->HasArray("Spacing"))
    {
      vtkNew<vtkBitingMesher> mesher;
      Messages messages(mesher);
      mesher->SetInputData(input);
      mesher->Update();
      EXPECT_TRUE(messages.Errors.empty()) << file;
      EXPECT_EQ(MeshChecker(mesher->GetOutput()).CheckValidity(), "") << file;
    }
  }
}

TEST(SharedCorpus, IsMeshedAsItIs)
{
  JudgeSharedInputs(AnySize, [](Case&) {});
}

TEST(SharedCorpus, IsMeshedTurnedByThirtyDegrees)
{
  JudgeSharedInputs(AnySize, Turn);
}

TEST(SharedCorpus, IsMeshedFarFromTheOrigin)
{
  JudgeSharedInputs(Ordinary, Move);
}

TEST(SharedCorpus, IsMeshedAtTinyScale)
{
  JudgeSharedInputs(Ordinary, [](Case& example) { Scale(example, 1e-9); });
}

TEST(SharedCorpus, IsMeshedAtHugeScale)
{
  JudgeSharedInputs(Ordinary, [](Case& example) { Scale(example, 1e9); });
}

TEST(SharedCorpus, IsMeshedWithReversedPolylines)
{
  JudgeSharedInputs(Ordinary, Reverse);
}

TEST(SharedCorpus, IsMeshedWithUnmergedPoints)
{
  JudgeSharedInputs(Ordinary, Unmerge);
}

TEST(SharedCorpus, IsMeshedInTiltedPlanes)
{
  for (const CorpusEntry& entry : SharedEntries({ "V", "W" }))
  {
    const Case example = CaseOf(entry);
    if (!IsFlat(example.Input))
    {
      vtkNew<vtkBitingMesher> mesher;
      mesher->SetInputData(example.Input);
      mesher->SetUniformSpacing(entry.Spacing);
      mesher->Update();
      EXPECT_NEAR(AreaOf(mesher->GetOutput()), entry.Area, 1e-9 * entry.Area) << entry.File;
    }
  }
}

TEST(SharedCorpus, IsMeshedOrRefusedWithAWordWhereItIsDefective)
{
  for (const CorpusEntry& entry : SharedEntries({ "R" }))
  {
    const Case example = CaseOf(entry);
    vtkNew<vtkBitingMesher> mesher;
    Messages messages(mesher);
    mesher->SetInputData(example.Input);
    mesher->SetUniformSpacing(std::isnan(entry.Spacing) ? 0.0 : entry.Spacing);
    mesher->Update();
    if (!messages.Errors.empty() || entry.Area == 0.0)
    {
      EXPECT_TRUE(AreAllEmpty(mesher)) << entry.File;
      EXPECT_GT(messages.Errors.size() + messages.Warnings.size(), 0u) << entry.File;
      continue;
    }
    const MeshChecker checker(mesher->GetOutput());
    const bool isClean = example.Input->GetNumberOfPolys() > 0;
    EXPECT_EQ(checker.CheckValidity(), "") << entry.File;
    EXPECT_EQ(CheckArea(example, checker), "") << entry.File;
    EXPECT_TRUE(isClean || !messages.Warnings.empty()) << entry.File;
  }
}

TEST(SharedCorpus, IsRefusedWithOneErrorWhereNothingCanBeMeshed)
{
  for (const CorpusEntry& entry : SharedEntries({ "E", "E*" }))
  {
    const Case example = CaseOf(entry);
    vtkNew<vtkBitingMesher> mesher;
    Messages messages(mesher);
    mesher->SetInputData(example.Input);
    mesher->Update();
    const bool hasCells = example.Input->GetNumberOfCells() > 0;
    EXPECT_EQ(messages.Errors.size(), hasCells ? 1u : 0u) << entry.File;
    EXPECT_TRUE(AreAllEmpty(mesher)) << entry.File;
  }
}
