// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "ParameterCheck.h"

namespace biting
{

std::string CheckMesherParameters(const BitingMeshOptions& options)
{
  const double mergeTolerance = options.Domain.MergeTolerance;
  const SimplificationOptions& simplification = options.Simplification;
  for (const std::string& refusal :
    { CheckSpacingParameters(options.Spacing), CheckAtLeastZero("Merge Tolerance", mergeTolerance),
      CheckAtLeastZero("End Tolerance", options.Domain.EndTolerance),
      CheckAtLeastZero("Boundary Tolerance", simplification.Tolerance),
      CheckAtLeastZero("Corner Angle", simplification.CornerAngle),
      CheckAtLeastZero("Minimum Loop Size", simplification.MinimumLoopSize) })
  {
    if (!refusal.empty())
    {
      return refusal;
    }
  }
  const double constant = options.BitingConstant;
  if (constant != 0.0 && !(constant >= 0.1 && constant <= 1.0))
  {
    return "Biting Constant is " + ValueText(constant) +
      "; it must be 0 (automatic) or within [0.1, 1].";
  }
  if (!(options.Phi > 0.0 && options.Phi <= 1.0))
  {
    return "Phi is " + ValueText(options.Phi) + "; it must be above 0 and at most 1.";
  }
  if (mergeTolerance >= 1.0)
  {
    return "Merge Tolerance is " + ValueText(mergeTolerance) +
      "; it is relative to the diagonal of the input, and must be below 1.";
  }
  if (options.MaximumNumberOfBites < -1 || options.MaximumNumberOfVertices < 1)
  {
    return options.MaximumNumberOfBites < -1
      ? "Maximum Number Of Bites is below -1; -1 means until the front is empty."
      : "Maximum Number Of Vertices is below 1.";
  }
  return {};
}

} // namespace biting
