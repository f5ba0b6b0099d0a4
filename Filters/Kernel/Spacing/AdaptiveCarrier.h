// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingAdaptiveCarrier_h
#define BitingAdaptiveCarrier_h

#include "Quadtree.h"
#include "SegmentExtension.h"

#include <array>      // for node values
#include <cstddef>    // for counts
#include <functional> // for what is not needed

namespace biting
{

/// The extension of a segment source, ready for fast evaluation over a box.
///
/// A quadtree whose leaves either keep the few cones that are lowest there, or interpolate the
/// extension by a quadratic in x and y between three by three nodes. The tree is refined until one
/// or the other holds to Tolerance, relative to the value: leaves are about as large as the value
/// divided by its slope where the extension is smooth, and smaller where many cones meet. Leaves do
/// not share values; across their borders the carrier may jump within the tolerance. Lists of up to
/// twelve cones are complete and exact; the other leaves are tested, not proven.
/// Cost: logarithmic in the number of cones for each of about as many leaves as a mesh of this
/// spacing has vertices.
class AdaptiveCarrier
{
public:
  static constexpr double Tolerance = 0.005;
  static constexpr double LeavesPerVertex = 16.0;

  /// Where it need not be exact, and when to give up.
  struct Relief
  {
    double Most =
      std::numeric_limits<double>::infinity(); ///< values above this need not be told apart
    std::function<bool(const Box2&)> IsUnused; ///< may be empty: boxes where half the value will do
    /// May be empty: asked once, when there are many leaves. Infinity: give up.
    std::function<double(Monitor&)> ForecastVertices;
    std::size_t ManyLeaves = 0; ///< how many
  };

  /// Not complete yet. The extension has at least one cone, the box an extent.
  AdaptiveCarrier(SegmentExtension extension, const Box2& bounds);

  /// Makes it complete, or leaves it as it was where that took more than LeavesPerVertex leaves a
  /// vertex of the forecast (and as many times ManyLeaves). False if the monitor asks to stop or the
  /// forecast is infinite.
  bool Refine(const Relief& relief, Monitor& monitor);

  bool IsComplete() const { return this->Complete; }

  /// Outside of the box the value of the nearest point in it. Exact and slow while it is not complete.
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
  Quadtree Tree; ///< an even leaf 2i interpolates NodeValues[i], an odd one 2i + 1 has Lists[i]
  std::vector<std::array<double, 9>> NodeValues; ///< [i + 3 j] at (i / 2, j / 2)
  std::vector<ConeList> Lists;
  std::vector<Id> ListedCones;
  bool Complete = false;
};

} // namespace biting

#endif
