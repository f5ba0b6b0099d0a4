// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "RaisedSpacing.h"

#include "../Spacing/SourceCheck.h"

#include <sstream> // for the detail

namespace biting
{

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
  const double least = spacing.Scale * LeastGiven(spacing);
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
