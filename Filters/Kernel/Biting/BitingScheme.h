// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingBitingScheme_h
#define BitingBitingScheme_h

#include "../Base/Ids.h"
#include "../Base/Monitor.h"
#include "../Base/Point2.h"
#include "../Domain/Domain.h"
#include "../Domain/DomainLocator.h"
#include "../Spacing/Spacing.h"
#include "Bites.h"
#include "CandidateQueue.h"

#include <cstdint> // for limits
#include <vector>  // for the arrays

namespace biting
{

struct BitingOptions
{
  double BitingConstant = 0.0; ///< c_b; 0 = AutomaticBitingConstant
  double PartLength = 0.0;     ///< wanted length of boundary edges in units of f; 0 = as inside
  FrontOrder Order = FrontOrder::Layers;
  std::int64_t MaximumNumberOfBites = -1; ///< -1 = until the front is empty
  std::int64_t MaximumNumberOfVertices = 20000000;
  bool KeepFront = false; ///< fill Front
};

enum class BitingEnd
{
  Complete, ///< the front is empty, or the wanted number of bites is made
  Aborted,
  TooManyVertices
};

/// The vertices of the mesh and the edges that it must have.
struct BitingResult
{
  // Vertices: those of the domain in their order, then new ones in the order of their bites.
  std::vector<Point2> Points;
  std::vector<double> Spacings;
  std::vector<Id> BiteOrders; ///< NoId where biting stopped before
  std::vector<Id> Segments;   ///< of a new vertex: the domain segment that it lies on, or NoId

  // The parts into which the segments are divided.
  std::vector<Id> EdgeStarts;
  std::vector<Id> EdgeEnds;
  std::vector<Id> EdgeSegments;

  biting::Bites Bites;
  std::vector<Point2> Front; ///< two points a piece; empty once the front is
  BitingEnd End = BitingEnd::Complete;
};

/// The c_b for which the mean edge length of the mesh is f, on average over domains.
double AutomaticBitingConstant(FrontOrder order);

/// How many vertices the mesh will have, by the integral of 1/f^2 (see VertexEstimate.h).
double EstimateNumberOfVertices(double integratedDensity, const BitingOptions& options);

/// Bites the domain until nothing is left of it (paper, section 3.1): the vertices of the domain,
/// points on its segments, then vertices of the front, each bite a square of half-width c_b f.
///
/// Laws (PAPER-NOTES; alpha the Lipschitz constant of f): no centre lies inside an earlier bite,
/// except that all input vertices are bitten however near they are; every point of the domain lies in
/// a bite. The front is kept as the set of its uncovered vertices: it needs no linked list, no
/// priority search tree, no cuts at holes (paper, section 5).
/// Cost O(n) for Layers, O(n log n) for LargestY.
BitingResult BiteDomain(const Domain& domain, const DomainLocator& locator, const Spacing& spacing,
  double expectedVertices, const BitingOptions& options, Monitor& monitor);

} // namespace biting

#endif
