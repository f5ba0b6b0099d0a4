// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingStageProblems_h
#define BitingStageProblems_h

#include "../Base/PartOfStage.h"
#include "../Base/Problem.h"

#include <string> // for details

namespace biting
{

inline void AddProblem(ProblemCode code, const std::string& detail, ProblemList& problems)
{
  Problem problem;
  problem.Code = code;
  problem.Detail = detail;
  problems.Add(problem);
}

/// Whether the part was stopped, which is noted then where nothing was refused before.
inline bool AddAborted(const PartOfStage& part, ProblemList& problems)
{
  if (part.HasStopped() && !problems.HasErrors())
  {
    AddProblem(ProblemCode::Aborted, "", problems);
  }
  return part.HasStopped();
}

} // namespace biting

#endif
