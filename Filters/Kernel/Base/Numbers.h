// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingNumbers_h
#define BitingNumbers_h

#include <limits> // for infinity

namespace biting
{

constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr double DegreesPerRadian = 57.295779513082320876798154814105;

} // namespace biting

#endif
