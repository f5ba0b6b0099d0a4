// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Problem.h"

#include <algorithm> // for any_of, find_if, min
#include <cmath>     // for ceil, floor, log10, pow
#include <sstream>   // for figures
#include <utility>   // for move

namespace biting
{

void ProblemList::Add(Problem problem)
{
  ProblemGroup& group = this->GroupOf(problem.Code);
  ++group.Count;
  if (group.First.size() < KeptPerKind)
  {
    group.First.push_back(std::move(problem));
  }
}

void ProblemList::Add(const ProblemGroup& group)
{
  ProblemGroup& own = this->GroupOf(group.Code);
  own.First.insert(own.First.end(), group.First.begin(), group.First.end());
  own.First.resize(std::min(own.First.size(), KeptPerKind));
  own.Count += group.Count;
}

ProblemGroup& ProblemList::GroupOf(ProblemCode code)
{
  const auto group = std::find_if(this->Kinds.begin(), this->Kinds.end(),
    [code](const ProblemGroup& one) { return one.Code == code; });
  return group != this->Kinds.end() ? *group
                                    : this->Kinds.emplace_back(ProblemGroup{ code, 0, {} });
}

std::int64_t ProblemList::Count(ProblemCode code) const
{
  const auto group = std::find_if(this->Kinds.begin(), this->Kinds.end(),
    [code](const ProblemGroup& one) { return one.Code == code; });
  return group != this->Kinds.end() ? group->Count : 0;
}

bool ProblemList::HasErrors() const
{
  return std::any_of(this->Kinds.begin(), this->Kinds.end(),
    [](const ProblemGroup& group) { return IsError(group.Code); });
}

bool IsError(ProblemCode code)
{
  return code == ProblemCode::Aborted || code == ProblemCode::BadTriangles ||
    code == ProblemCode::OpenOutlines || code == ProblemCode::UnmatchedSides ||
    code == ProblemCode::TooThin || code == ProblemCode::TooSharp ||
    (code >= ProblemCode::OpenEdges && code <= ProblemCode::NotOrientable) ||
    (code >= ProblemCode::NoClosedLoop && code <= ProblemCode::CheckFailed);
}

bool IsNote(ProblemCode code)
{
  return code == ProblemCode::SmallLoops || code == ProblemCode::FineDrawing ||
    code == ProblemCode::SurfaceTouches;
}

std::string Figure(double value, int digits)
{
  std::ostringstream text;
  text.precision(digits);
  text << value;
  return text.str();
}

std::string FigureAbove(double value)
{
  const double unit = std::pow(10.0, std::floor(std::log10(value)) - 1.0);
  return Figure(std::ceil(value / unit) * unit, 2);
}

} // namespace biting
