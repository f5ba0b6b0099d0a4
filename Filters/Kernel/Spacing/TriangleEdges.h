// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingTriangleEdges_h
#define BitingTriangleEdges_h

#include "../Base/Ids.h"
#include "../Base/Pulse.h"

#include <vector> // for the arrays

namespace biting
{

/// The edges of triangles, each of them once, in the order of the numbers of their lower and of
/// their higher ends. Cost: linear, as long as few meet at a point.
class TriangleEdges
{
public:
  /// Of three corners a triangle, below `points`. Which of two points is the lower one
  /// `heights` tell, or where these are equal, or there are none, their numbers.
  /// Incomplete if the pulse stops.
  TriangleEdges(const std::vector<Id>& corners, std::size_t points, Pulse& pulse,
    const std::vector<double>& heights = {});

  /// Those with that lower end are the edges [FirstAt(point), FirstAt(point + 1)).
  std::size_t FirstAt(std::size_t point) const { return this->Firsts[point]; }
  Id HighEnd(std::size_t edge) const { return this->HighEnds[edge]; }

  /// Whether all triangles of which it is a side lie on one side of it, where all corners are
  /// counterclockwise: it is of one only, or these lie on each other.
  bool IsBorder(std::size_t edge) const { return this->AreBorder[edge]; }

private:
  std::vector<std::size_t> Firsts; ///< of each point; and the end of the last one's
  std::vector<Id> HighEnds;
  std::vector<bool> AreBorder;
};

} // namespace biting

#endif
