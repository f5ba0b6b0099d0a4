// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "RaisedSpacing.h"

#include "Base/Numbers.h"

#include <algorithm> // for min
#include <memory>    // for sources
#include <sstream>   // for the detail
#include <vector>    // for values

namespace biting
{

namespace
{

/// Of the values that are a spacing.
template <typename Source>
double LeastOf(const std::shared_ptr<const Source>& source)
{
  double least = Infinity;
  if (source)
  {
    for (const double value : source->Values)
    {
      least = value > 0.0 && value < least ? value : least;
    }
  }
  return least;
}

double LeastGiven(const SpacingOptions& spacing)
{
  const double uniform = spacing.Uniform > 0.0 ? spacing.Uniform : Infinity;
  return spacing.Scale *
    std::min({ uniform, LeastOf(spacing.Grid), LeastOf(spacing.Triangulation),
      LeastOf(spacing.Segments) });
}

} // namespace

SpacingOptions RaiseToRounding(SpacingOptions spacing, const Domain& domain, ProblemList& problems)
{
  const double rounding = domain.Resolution;
  const bool isBelow = spacing.Minimum >= 0.0 && spacing.Minimum < rounding;
  const bool isFree = spacing.Maximum == 0.0 || spacing.Maximum > rounding;
  if (!isBelow || !isFree)
  {
    return spacing;
  }
  spacing.Minimum = rounding;
  const double least = LeastGiven(spacing);
  if (least < rounding && !problems.Has(ProblemCode::RaisedSpacing))
  {
    std::ostringstream detail;
    detail.precision(3);
    detail << least << " is raised to " << rounding;
    problems.Add({ ProblemCode::RaisedSpacing, {}, {}, detail.str() });
  }
  return spacing;
}

} // namespace biting
