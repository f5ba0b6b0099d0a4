// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

// How often f is asked, by all rooms but its own. In this program, as the linker puts a counter
// before Spacing::operator().

#include "../../Benchmark/MeshCases.h"

#include <gtest/gtest.h>

namespace
{

long numberOfQuestions = 0;

constexpr double MostAVertex = 4.0;

} // namespace

// The names that the linker gives (--wrap).
extern "C"
{
  // NOLINTNEXTLINE(bugprone-reserved-identifier)
  double __real__ZNK6biting7SpacingclERKNS_5PointILm2EEE(
    const biting::Spacing* spacing, const biting::Point2& x);

  // NOLINTNEXTLINE(bugprone-reserved-identifier)
  double __wrap__ZNK6biting7SpacingclERKNS_5PointILm2EEE(
    const biting::Spacing* spacing, const biting::Point2& x)
  {
    ++numberOfQuestions;
    return __real__ZNK6biting7SpacingclERKNS_5PointILm2EEE(spacing, x);
  }
}

namespace biting
{

namespace
{

double QuestionsAVertex(const MeshCase& made)
{
  ProblemList problems;
  numberOfQuestions = 0;
  const BitingMesh mesh = MakeBitingMesh(made.Drawing, made.Options, problems, NoMonitor());
  EXPECT_GT(mesh.Points.size(), 10000u);
  EXPECT_GT(numberOfQuestions, 10000);
  return static_cast<double>(numberOfQuestions) / static_cast<double>(mesh.Points.size());
}

} // namespace

TEST(Spacing, IsAskedAtMostFourTimesAVertexOfACoast)
{
  EXPECT_LE(QuestionsAVertex(OfFile("coast.vtk", 0.15)), MostAVertex);
}

TEST(Spacing, IsAskedAtMostFourTimesAVertexOfASquare)
{
  EXPECT_LE(QuestionsAVertex(SectionSix(20000.0)), MostAVertex);
}

} // namespace biting
