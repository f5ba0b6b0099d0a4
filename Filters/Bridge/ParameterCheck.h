// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingParameterCheck_h
#define BitingParameterCheck_h

#include <cmath>  // for isfinite
#include <string> // for refusals

namespace biting
{

/// Why `value` of the parameter `name` cannot be; empty where it is finite, and 0 or more.
inline std::string CheckAtLeastZero(const char* name, double value)
{
  if (value >= 0.0 && std::isfinite(value))
  {
    return {};
  }
  return std::string(name) + " is " + std::to_string(value) + "; it must be finite, and 0 or more.";
}

} // namespace biting

#endif
