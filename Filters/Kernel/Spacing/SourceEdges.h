// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingSourceEdges_h
#define BitingSourceEdges_h

#include "../Base/Pulse.h"
#include "Spacing.h"

#include <vector> // for the arrays

namespace biting
{

/// The edges around each point of a triangulated source.
class SourceEdges
{
public:
  /// From a point, which is not among what it knows.
  struct Edge
  {
    Point2 Along;
    double End; ///< the value there, as given
    Id To;
    bool IsSteep; ///< a triangle beside it is
  };

  struct Range
  {
    const Edge* First;
    const Edge* Last;
    const Edge* begin() const { return this->First; }
    const Edge* end() const { return this->Last; }
  };

  SourceEdges() = default;

  /// `isSteep` is one a triangle. Incomplete if the pulse stops: nothing must be asked then.
  SourceEdges(const TriangulatedSource& source, const std::vector<bool>& isSteep, Pulse& pulse);

  Range operator()(Id point) const
  {
    const Id* first = &this->Firsts[static_cast<std::size_t>(point)];
    return { this->Edges.data() + first[0], this->Edges.data() + first[1] };
  }

private:
  void AddFrom(const TriangulatedSource& source, Id point, std::size_t triangle, bool isSteep);

  std::vector<Id> Firsts; ///< those of point p are Firsts[p] to Firsts[p + 1]
  std::vector<Edge> Edges;
};

} // namespace biting

#endif
