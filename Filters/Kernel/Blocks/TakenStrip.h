// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingTakenStrip_h
#define BitingTakenStrip_h

#include "../Base/Ids.h"
#include "../Base/Pulse.h"
#include "../Domain/Domain.h"
#include "../Relaxation/Relaxation.h"
#include "JoinedBlocks.h"

#include <cstdint> // for flags
#include <vector>  // for the maps

namespace biting
{

/// Some triangles of a mesh, as a mesh of a domain. Its segments are edges that stay, which are
/// preserved, and runs of edges on one segment of the whole, whose vertices may slide, or go.
struct TakenStrip
{
  /// Of an edge that stays: the slot across it, if outside of the strip, and its constraint.
  /// Of a run: the first of its constraints, which have consecutive numbers.
  struct Side
  {
    Id Outside = NoId; ///< a slot of the whole
    Id Constraint = NoId;
    Id NumberOfParts = 1; ///< more: a run
  };

  bool IsEmpty() const { return this->Triangles.empty(); }
  bool IsFixed(Id vertex) const
  {
    return static_cast<std::size_t>(vertex) < this->Border.Vertices.size();
  }

  std::vector<Id> Triangles; ///< numbers in the whole of the triangles of the strip
  std::vector<Id> Vertices;  ///< numbers in the whole of the strip's vertices: fixed ones first
  std::vector<Side> Sides;   ///< of the segments of the border
  Domain Border;
  RelaxationMesh Mesh;
};

/// A mesh from which strips are taken, with memory for all of them together.
struct StripSource
{
  /// The arguments must outlive this object.
  StripSource(
    const Domain& domain, const std::vector<std::uint8_t>& areTouching, const JoinedMesh& mesh);

  const Domain& Geometry;
  const std::vector<std::uint8_t>& AreTouching; ///< segments nearly touch others; empty: none does
  const JoinedMesh& Whole;
  std::vector<Id> TriangleNumbers; ///< of the whole's triangles in their strip, or NoId
  std::vector<Id> VertexNumbers;
};

/// The strip of these triangles, which are in their order. Vertices slide on segments that are not
/// preserved, and do not nearly touch others, as far as they are inside of the strip. No two strips
/// of one source have a vertex in common: so they may be taken at the same time. Where the monitor
/// wants to stop the result has no meaning.
TakenStrip TakeStrip(StripSource& source, std::vector<Id> triangles, Pulse& pulse);

} // namespace biting

#endif
