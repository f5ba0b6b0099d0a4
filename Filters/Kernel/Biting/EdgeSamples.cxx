// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "EdgeSamples.h"

#include <algorithm> // for minmax
#include <cmath>     // for abs

namespace biting
{

namespace
{

// In units of f.
constexpr double Reach = 2.0;
constexpr double LeastReach = 0.2;
constexpr double LeastReachAtJumps = 1e-3;
constexpr double Remainder = 0.5; // of a reach, that is taken along at the end of the edge

constexpr double GreatestBend = 0.02;
constexpr double GreatestRatioOfSamples = 2.0;

} // namespace

void EdgeSamples::Begin(const Point2& a, const Point2& b, double atA, double atB)
{
  this->Start = a;
  this->Way = b - a;
  this->Length = Distance(a, b);
  this->Last = { 0.0, atA };
  this->IsNextFine = this->F.IsUniform();
  this->Ahead.assign(1, { 1.0, atB });
}

EdgeSamples::Sample EdgeSamples::Next()
{
  if (!this->IsNextFine)
  {
    this->LookAhead();
  }
  else
  {
    this->IsNextFine = false;
  }
  this->Last = this->Ahead.back();
  this->Ahead.pop_back();
  return this->Last;
}

// Finds the next two samples.
void EdgeSamples::LookAhead()
{
  const double reach = this->Last.Parameter + Reach * this->Last.Spacing / this->Length;
  const double farthest = reach + Remainder * (reach - this->Last.Parameter);
  if (reach > this->Last.Parameter && this->Ahead.back().Parameter > farthest)
  {
    this->Ahead.push_back(this->Ask(reach));
  }
  Sample middle = this->AskBefore(this->Ahead.back());
  while (this->IsBetween(middle) && !this->IsFine(middle))
  {
    this->Ahead.push_back(middle);
    middle = this->AskBefore(middle);
  }
  this->IsNextFine = this->IsBetween(middle);
  if (this->IsNextFine)
  {
    this->Ahead.push_back(middle);
  }
}

EdgeSamples::Sample EdgeSamples::Ask(double parameter) const
{
  return { parameter, this->F(this->Start + parameter * this->Way) };
}

// Halfway from the last one.
EdgeSamples::Sample EdgeSamples::AskBefore(const Sample& sample) const
{
  return this->Ask(0.5 * (this->Last.Parameter + sample.Parameter));
}

// False where no number lies between the last parameter and the one ahead.
bool EdgeSamples::IsBetween(const Sample& middle) const
{
  return this->Last.Parameter < middle.Parameter && middle.Parameter < this->Ahead.back().Parameter;
}

// Whether f is linear enough from the last one over this to the one ahead.
bool EdgeSamples::IsFine(const Sample& middle) const
{
  const Sample& first = this->Last;
  const Sample& last = this->Ahead.back();
  const auto [least, most] = std::minmax({ first.Spacing, middle.Spacing, last.Spacing });
  const bool isSteep = most > GreatestRatioOfSamples * least;
  const double bend = std::abs(first.Spacing + last.Spacing - 2.0 * middle.Spacing);
  const double length = (last.Parameter - first.Parameter) * this->Length;
  return (!isSteep && bend <= 2.0 * GreatestBend * least) ||
    length <= 2.0 * (isSteep ? LeastReachAtJumps : LeastReach) * first.Spacing;
}

} // namespace biting
