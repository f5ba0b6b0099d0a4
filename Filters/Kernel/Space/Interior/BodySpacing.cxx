// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "BodySpacing.h"

#include "../../Spacing/ConeTree.h"

#include <memory> // for the tree

namespace biting
{

std::function<double(const Point3&)> BodySpacing(const std::function<double(const Point3&)>& given,
  const std::vector<Point3>& centers, const std::vector<double>& sizes, double gradation,
  Pulse& pulse)
{
  Box3 bounds;
  std::vector<Cone<3>> cones;
  for (std::size_t k = 0; k < centers.size() && pulse.Beat(1); ++k)
  {
    bounds.Add(centers[k]);
    if (sizes[k] < (1.0 - ConeTree<3>::Tolerance) * given(centers[k]))
    {
      cones.emplace_back();
      cones.back().Start = centers[k];
      cones.back().Value = sizes[k];
    }
  }
  if (cones.empty())
  {
    return given;
  }
  PulseMonitor monitor(pulse);
  const double slope = gradation > 0.0 ? gradation : 0.3;
  const auto tree = std::make_shared<const ConeTree<3>>(cones, slope, bounds, Infinity, monitor);
  if (pulse.HasStopped())
  {
    return given;
  }
  return [given, tree](const Point3& x) { return std::min(given(x), (*tree)(x)); };
}

} // namespace biting
