// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingStageProblems_h
#define BitingStageProblems_h

#include "../Base/Monitor.h"
#include "../Base/Problem.h"

#include <cstdint> // for limits
#include <string>  // for details

namespace biting
{

inline void AddProblem(ProblemCode code, const std::string& detail, ProblemList& problems)
{
  Problem problem;
  problem.Code = code;
  problem.Detail = detail;
  problems.Add(problem);
}

/// Of the first problem of that code, which there is.
inline std::string FirstDetail(ProblemCode code, const ProblemList& problems)
{
  for (const ProblemGroup& group : problems.Groups())
  {
    if (group.Code == code)
    {
      return group.First.front().Detail;
    }
  }
  return {};
}

inline void AddTooManyVertices(double estimate, std::int64_t limit, ProblemList& problems)
{
  AddProblem(ProblemCode::TooManyVertices,
    "about " + Figure(estimate) + " vertices, the limit is " + std::to_string(limit), problems);
}

/// Whether so many are more than the limit, which is noted then.
inline bool RefuseMoreThan(std::int64_t limit, double vertices, ProblemList& problems)
{
  const bool isTooMuch = !(vertices <= static_cast<double>(limit));
  if (isTooMuch)
  {
    AddTooManyVertices(vertices, limit, problems);
  }
  return isTooMuch;
}

/// Adds the problems of `list` to `problems`.
inline void AddAll(const ProblemList& list, ProblemList& problems)
{
  for (const ProblemGroup& group : list.Groups())
  {
    for (const Problem& problem : group.First)
    {
      problems.Add(problem);
    }
  }
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

/// Whether nothing is left to do: there is a refusal, or the monitor wants to stop.
inline bool IsOver(const PartOfStage& whole, ProblemList& problems)
{
  AddAborted(whole, problems);
  return problems.HasErrors();
}

} // namespace biting

#endif
