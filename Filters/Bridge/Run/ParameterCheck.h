// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingParameterCheck_h
#define BitingParameterCheck_h

#include "../../Kernel/BitingMesh.h"
#include "../../Kernel/Spacing/Spacing.h"

#include <cmath>   // for isfinite
#include <sstream> // for values
#include <string>  // for refusals

namespace biting
{

/// Short, also where the value is large.
inline std::string ValueText(double value)
{
  std::ostringstream text;
  text << value;
  return text.str();
}

/// Why `value` of the parameter `name` cannot be; empty where it is finite, and 0 or more.
inline std::string CheckAtLeastZero(const char* name, double value)
{
  if (value >= 0.0 && std::isfinite(value))
  {
    return {};
  }
  return std::string(name) + " is " + ValueText(value) + "; it must be finite, and 0 or more.";
}

/// Of the parameters that mesher and remesher have in common.
inline std::string CheckSpacingParameters(const SpacingOptions& spacing)
{
  for (const std::string& refusal : { CheckAtLeastZero("Uniform Spacing", spacing.Uniform),
         CheckAtLeastZero("Spacing Scale", spacing.Scale),
         CheckAtLeastZero("Minimum Spacing", spacing.Minimum),
         CheckAtLeastZero("Maximum Spacing", spacing.Maximum),
         CheckAtLeastZero("Gradation", spacing.Gradation) })
  {
    if (!refusal.empty())
    {
      return refusal;
    }
  }
  if (spacing.Scale == 0.0)
  {
    return "Spacing Scale is 0; it must be above 0.";
  }
  const bool isCrossed = spacing.Maximum > 0.0 && spacing.Minimum > spacing.Maximum;
  return isCrossed ? "Minimum Spacing is above Maximum Spacing." : "";
}

/// Of all that the mesher has.
std::string CheckMesherParameters(const BitingMeshOptions& options);

} // namespace biting

#endif
