// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingSeenProblems_h
#define BitingSeenProblems_h

#include "FilterTesting.h"

#include "vtkBitingSurfaceMesher.h"

#include "vtkIdTypeArray.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <algorithm> // for copy_if
#include <iterator>  // for back_inserter
#include <string>    // for messages
#include <vector>    // for lists

namespace testing_filters
{

constexpr int NumberOfKinds = vtkBitingSurfaceMesher::UNITED_SURFACES + 1;

/// One point of the output, with its arrays.
struct SeenProblem
{
  int Kind;
  int IsError;
  vtkIdType FirstId;
  vtkIdType SecondId;
  Place Where;
  std::string Message;
};

/// What a run has left.
struct Outcome
{
  std::vector<SeenProblem> Problems;
  std::vector<vtkIdType> Counts;
  std::vector<std::string> Errors;
  std::vector<std::string> Warnings;

  std::vector<SeenProblem> Of(int kind) const
  {
    std::vector<SeenProblem> found;
    std::copy_if(this->Problems.begin(), this->Problems.end(), std::back_inserter(found),
      [kind](const SeenProblem& problem) { return problem.Kind == kind; });
    return found;
  }
};

inline std::vector<SeenProblem> ReadProblems(vtkPolyData* data)
{
  vtkPointData* arrays = data->GetPointData();
  auto* kinds = vtkUnsignedCharArray::SafeDownCast(arrays->GetArray("ProblemKind"));
  auto* errors = vtkUnsignedCharArray::SafeDownCast(arrays->GetArray("IsError"));
  auto* firstIds = vtkIdTypeArray::SafeDownCast(arrays->GetArray("FirstId"));
  auto* secondIds = vtkIdTypeArray::SafeDownCast(arrays->GetArray("SecondId"));
  auto* messages = vtkStringArray::SafeDownCast(arrays->GetAbstractArray("Message"));
  EXPECT_TRUE(kinds && errors && firstIds && secondIds && messages);
  EXPECT_EQ(data->GetNumberOfVerts(), data->GetNumberOfPoints());
  EXPECT_EQ(data->GetNumberOfCells(), data->GetNumberOfPoints());
  std::vector<SeenProblem> problems;
  for (vtkIdType k = 0; kinds && k < data->GetNumberOfPoints(); ++k)
  {
    problems.push_back({ kinds->GetValue(k), errors->GetValue(k), firstIds->GetValue(k),
      secondIds->GetValue(k), PointOf(data, k), messages->GetValue(k) });
  }
  return problems;
}

inline Outcome RunOf(vtkBitingMesher* mesher)
{
  Messages messages(mesher);
  mesher->Update();
  Outcome run;
  vtkPolyData* data = mesher->GetOutput(vtkBitingMesher::PROBLEMS);
  run.Problems = ReadProblems(data);
  auto* counts = vtkIdTypeArray::SafeDownCast(data->GetFieldData()->GetArray("ProblemCounts"));
  EXPECT_TRUE(counts && counts->GetNumberOfTuples() == NumberOfKinds);
  run.Counts.assign(counts->GetPointer(0), counts->GetPointer(0) + NumberOfKinds);
  run.Errors = messages.Errors;
  run.Warnings = messages.Warnings;
  return run;
}

inline Outcome RunOf(vtkPolyData* input, double spacing = 0.1)
{
  vtkNew<vtkBitingMesher> mesher;
  mesher->SetInputData(input);
  mesher->SetUniformSpacing(spacing);
  return RunOf(mesher);
}

/// A refused input: one error, no mesh, and all its points say so.
inline Outcome RefusalOf(vtkPolyData* input)
{
  vtkNew<vtkBitingMesher> mesher;
  mesher->SetInputData(input);
  Outcome run = RunOf(mesher);
  EXPECT_EQ(run.Errors.size(), 1u);
  EXPECT_TRUE(AreAllEmpty(mesher));
  for (const SeenProblem& problem : run.Problems)
  {
    EXPECT_EQ(problem.IsError, 1);
  }
  return run;
}

} // namespace testing_filters

#endif
