// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingTriangleSides_h
#define BitingTriangleSides_h

#include "../Base/Pulse.h"
#include "Spacing.h"

namespace biting
{

/// The sides of some of the triangles of a source, those of one edge together. Side 3 t + k of
/// triangle t leads from its corner k to the next one. Cost: linear.
class TriangleSides
{
public:
  /// Refers to the source. Incomplete if the pulse stops.
  TriangleSides(const TriangulatedSource& source, const std::vector<Id>& triangles, Pulse& pulse);

  /// Calls visit(first, last) for each edge, in the order of its ends: [first, last) are its sides.
  template <typename Visit>
  void ForEachEdge(Pulse& pulse, Visit visit) const
  {
    for (std::size_t edge = 0; edge + 1 < this->Firsts.size() && pulse.Beat(1); ++edge)
    {
      visit(this->Sides.data() + this->Firsts[edge], this->Sides.data() + this->Firsts[edge + 1]);
    }
  }

  Id StartOf(Id side) const { return this->Corner(side); }
  Id EndOf(Id side) const { return this->Corner(side % 3 == 2 ? side - 2 : side + 1); }
  Id LowEnd(Id side) const { return std::min(this->StartOf(side), this->EndOf(side)); }
  Id HighEnd(Id side) const { return std::max(this->StartOf(side), this->EndOf(side)); }
  Id OppositeOf(Id side) const { return this->Corner(side % 3 == 0 ? side + 2 : side - 1); }

private:
  Id Corner(Id corner) const { return this->Source.Triangles[static_cast<std::size_t>(corner)]; }

  const TriangulatedSource& Source;
  std::vector<Id> Sides;           ///< in the order of their ends
  std::vector<std::size_t> Firsts; ///< of each edge, in Sides; and the end of these
};

} // namespace biting

#endif
