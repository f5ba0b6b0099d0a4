// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingDrawnLengths_h
#define BitingDrawnLengths_h

#include "../Base/Ids.h"
#include "Spacing.h"

#include <cstddef> // for size_t
#include <vector>  // for the arrays

namespace biting
{

/// How long the segments of the drawing are that a segment of `FeatureSource` stands for, and what
/// that tells about places on it: the largest function that is at most the length of a segment on
/// it, and grows no faster than a gradation.
///
/// A segment and its path have places in common: those that share the one and the other alike.
class DrawnLengths
{
public:
  /// Refers to the source. Cost: linear in the segments of the drawing.
  DrawnLengths(const FeatureSource& source, double gradation);

  /// At a share of the segment; infinite where it stands for nothing else.
  double operator()(Id segment, double share) const;

private:
  void AddPath(std::size_t first, std::size_t last);

  const FeatureSource& Source;
  const double Gradation;
  std::vector<double> Ends; ///< of each segment of the drawing: as the length of its path up to it
  std::vector<double> Bounds; ///< there
};

} // namespace biting

#endif
