// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingEdgeSamples_h
#define BitingEdgeSamples_h

#include "../Base/Point.h"
#include "../Spacing/Spacing.h"

#include <vector> // for the samples

namespace biting
{

/// f along an edge, from few samples of it, from its start to its end.
///
/// Between samples f is taken as linear. Of three in a row, at most 3 f apart, the middle one is
/// within 2 % of the line through the others, and they do not differ by more than a factor of two;
/// or they are a fifth of f apart, or, where f jumps, a thousandth.
class EdgeSamples
{
public:
  struct Sample
  {
    double Parameter, Spacing;
  };

  explicit EdgeSamples(const Spacing& spacing)
    : F(spacing)
  {
  }

  /// Begins with the edge ab, where f is known at the ends.
  void Begin(const Point2& a, const Point2& b, double atA, double atB);

  /// The one that is next, behind the start at first; the last is the end of the edge.
  Sample Next();

private:
  void LookAhead();
  Sample Ask(double parameter) const;
  Sample AskBefore(const Sample& sample) const;
  bool IsBetween(const Sample& middle) const;
  bool IsFine(const Sample& middle) const;

  const Spacing& F;
  Point2 Start, Way;
  double Length = 0.0;
  Sample Last = {};          ///< that was told
  bool IsNextFine = false;   ///< f is linear up to the next one
  std::vector<Sample> Ahead; ///< descending to the next one
};

} // namespace biting

#endif
