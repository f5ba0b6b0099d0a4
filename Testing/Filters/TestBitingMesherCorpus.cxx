// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "CorpusChecks.h"

#include <gtest/gtest.h>

#include <iostream>

using namespace testing_filters;

namespace
{

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
  return CheckMesh(example, mesher->GetOutput(), mesher->GetOutput());
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
  JudgeSharedInputs(Ordinary, Turn);
}

TEST(SharedCorpus, IsMeshedFarFromTheOriginWithReversedPolylines)
{
  JudgeSharedInputs(Ordinary,
    [](Case& example)
    {
      Reverse(example);
      Move(example);
    });
}

TEST(SharedCorpus, IsMeshedAtTinyScaleWithUnmergedPoints)
{
  JudgeSharedInputs(Ordinary,
    [](Case& example)
    {
      Unmerge(example);
      Scale(example, 1e-9);
    });
}

TEST(SharedCorpus, IsMeshedAtHugeScale)
{
  JudgeSharedInputs(Ordinary, [](Case& example) { Scale(example, 1e9); });
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
