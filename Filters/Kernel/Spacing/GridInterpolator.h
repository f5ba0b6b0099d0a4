// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingGridInterpolator_h
#define BitingGridInterpolator_h

#include "Source.h"

namespace biting
{

/// The bilinear interpolant of a grid. Outside it is the nearest value of the border. A node whose
/// value is NaN takes the value of the nearest node that has one.
class GridInterpolator : public Source
{
public:
  /// At least one value is given. Where the grid does not reach the border of `bounds` it gets a
  /// row or column of nodes there. Linear in the number of nodes, a search for each hole;
  /// incomplete if the pulse stops.
  GridInterpolator(
    const std::shared_ptr<const GridSource>& source, const Box2& bounds, Pulse& pulse);

  double operator()(const Point2& x) const override;
  double AddLowEdges(const SteepRule& rule, SegmentSource& edges, Pulse& pulse) const override;

private:
  std::shared_ptr<const GridSource> Grid; ///< without holes
};

} // namespace biting

#endif
