// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingAdaptiveCarrier_h
#define BitingAdaptiveCarrier_h

#include "Quadtree.h"
#include "SegmentExtension.h"

#include <array> // for corner values

namespace biting
{

/// The extension of a segment source, ready for fast evaluation over a box.
///
/// A quadtree whose leaves either keep the few cones that can be the lowest there, and are exact,
/// or interpolate the extension between their corners. The tree is refined until one or the other
/// holds to Tolerance, relative to the value: so it is fine only where the extension has creases
/// between many cones. Leaves do not share corners; across their borders the value may jump within
/// the tolerance. Interpolating leaves are tested at nine points besides their corners, not proven.
class AdaptiveCarrier
{
public:
  static constexpr double Tolerance = 0.0125;

  /// Incomplete if the monitor asks to stop; it must not be evaluated then. The extension has at
  /// least one cone, the box an extent.
  AdaptiveCarrier(SegmentExtension extension, const Box2& bounds, Monitor& monitor);

  bool IsComplete() const { return this->Complete; }

  /// Outside of the box the value of the nearest point in it.
  double operator()(const Point2& x) const;

private:
  friend class CarrierBuilder;

  struct ConeList
  {
    Id First = 0; ///< in ListedCones
    Id Count = 0;
  };

  SegmentExtension Extension;
  Box2 Bounds;
  Quadtree Tree; ///< an even leaf 2i interpolates CornerValues[i], an odd one 2i + 1 has Lists[i]
  std::vector<std::array<double, 4>> CornerValues; ///< in the order of quarters
  std::vector<ConeList> Lists;
  std::vector<Id> ListedCones;
  bool Complete = true;
};

} // namespace biting

#endif
