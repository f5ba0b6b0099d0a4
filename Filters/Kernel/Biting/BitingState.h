// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingBitingState_h
#define BitingBitingState_h

#include "../Base/Ids.h"
#include "../Base/Monitor.h"
#include "../Base/Point.h"
#include "../Base/Pulse.h"
#include "../Domain/Domain.h"
#include "../Domain/DomainLocator.h"
#include "../Spacing/Spacing.h"
#include "BiteGrid.h"
#include "Bites.h"
#include "BitingScheme.h"
#include "Orientation.h"

#include <vector> // for the spacings

namespace biting
{

/// The state of biting: the domain, f and the options, the bites so far, and the vertices and edges
/// of the mesh so far. A phase is a function of the state and knows no other phase. The driver
/// (BitingScheme.cxx) has their order.
struct BitingState
{
  BitingState(const Domain& domain, const DomainLocator& locator, const Spacing& spacing,
    double expectedVertices, const BitingOptions& options, Monitor& monitor);
  BitingState(const BitingState&) = delete;
  void operator=(const BitingState&) = delete;

  /// Makes room for the vertices and bites that are expected.
  void Reserve();

  Id AddVertex(const Point2& place, double spacing, Id segment);
  void AddEdge(Id start, Id end, Id segment);

  /// Makes the bite of a vertex, of half-width `share` c_b f.
  void Bite(Id vertex, const Point2& axis, double share, BitePhase phase);

  /// Makes a bite that need not be a vertex's.
  void AddBite(
    const Point2& center, const Point2& axis, double halfWidth, double spacing, BitePhase phase);

  /// Whether biting goes on.
  bool MayBite() const;

  /// Counts a bite, after all of its squares are made.
  void FinishBite();

  /// To be called now and then: progress, and abort.
  void Step();

  /// BitingResult::Segments: the array ends with the last vertex that has one, until all are made.
  Id SegmentOf(Id vertex) const
  {
    const bool isListed = vertex < static_cast<Id>(this->Result.Segments.size());
    return isListed ? this->Result.Segments[vertex] : NoId;
  }

  /// Whether the segment is to stay one edge.
  bool IsPreserved(Id segment) const
  {
    return this->Options.PreserveBoundary || this->Geometry.MustPreserve(segment);
  }

  /// How far outside of a bite, or inside, a place still lies on its outline: as far as rounding of
  /// places goes. Where bites are as small as that, each takes something away all the same.
  double Slack(Id bite) const;

  /// Whether any may be divided.
  bool DividesSegments() const;

  /// Why an edge was not divided, once it was not.
  BitingEnd ReasonNotToDivide() const;

  const Domain& Geometry;
  const DomainLocator& Locator;
  const Spacing& F;
  const BitingOptions& Options;
  Pulse Progress;
  double ExpectedVertices;
  BitingResult Result;
  Bites& Placed; ///< the bites so far
  BiteGrid Grid;
  VertexAxes Axes;                    ///< of the bites of input vertices, once these are bitten
  std::vector<double> PlacedSpacings; ///< f at each bite, where half-widths follow its slope
  Id NumberOfBites = 0;
};

/// How far the grid finds neighbours, in half-widths: as far as the placement asks for them.
double NeighborRange(const BitingOptions& options);

} // namespace biting

#endif
