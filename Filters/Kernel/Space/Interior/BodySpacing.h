// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingBodySpacing_h
#define BitingBodySpacing_h

#include "../../Base/Point.h"
#include "../../Base/Pulse.h"

#include <functional> // for f
#include <vector>     // for the boundary

namespace biting
{

/// f inside of a body: the lowest of `given` at x and size_i + gradation |x - x_i| over the
/// vertices x_i of the boundary whose size is below what is given there, to within 1 %
/// (ConeTree). Where there are none, `given` itself. Any number of threads may call the result.
/// Laws: nowhere above `given`.
std::function<double(const Point3&)> BodySpacing(const std::function<double(const Point3&)>& given,
  const std::vector<Point3>& centers, const std::vector<double>& sizes, double gradation,
  Pulse& pulse);

} // namespace biting

#endif
