// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingCutGraph_h
#define BitingCutGraph_h

#include "../Base/Ids.h"
#include "../Base/Point.h"
#include "../Domain/Domain.h"

#include <vector> // for the arrays

namespace biting
{

/// The segments of a domain and the cuts through it, divided where they meet.
///
/// Invariant: vertices are those of the domain, in their order, then others; a vertex that is not
/// of the domain lies on its segment `Segments`, to rounding, or on a cut (NoId). Pieces of a
/// segment have its direction.
struct CutGraph
{
  /// A folded cut has vertices on both sides of its line. An end is open if nothing is near it but
  /// what the cut meets there, nearly at a right angle. Only at open ends the fold reaches the end.
  struct Fold
  {
    bool IsFolded = false;
    bool IsOpenAtStart = true;
    bool IsOpenAtEnd = true;
  };

  struct Piece
  {
    Id Start;
    Id End;
    Id Segment; ///< of the domain; NoId: a cut
    Fold Folded;
  };

  CutGraph() = default;

  explicit CutGraph(const Domain& domain)
    : Vertices(domain.Vertices)
    , Segments(domain.Vertices.size(), NoId)
  {
    this->Pieces.reserve(domain.Starts.size());
    for (Id segment = 0; segment < domain.NumberOfSegments(); ++segment)
    {
      this->Pieces.push_back({ domain.Starts[segment], domain.Ends[segment], segment, {} });
    }
  }

  Id NumberOfPieces() const { return static_cast<Id>(this->Pieces.size()); }
  bool IsCut(Id piece) const { return this->Pieces[piece].Segment == NoId; }

  Id AddVertex(const Point2& place, Id segment)
  {
    this->Vertices.push_back(place);
    this->Segments.push_back(segment);
    return static_cast<Id>(this->Vertices.size()) - 1;
  }

  /// Divides the piece at the vertex. Returns the new piece, from the vertex to the old end.
  /// A folded cut is open at the new vertex.
  Id Split(Id piece, Id vertex)
  {
    Piece rest = this->Pieces[piece];
    rest.Start = vertex;
    rest.Folded.IsOpenAtStart = true;
    this->Pieces[piece].End = vertex;
    this->Pieces[piece].Folded.IsOpenAtEnd = true;
    this->Pieces.push_back(rest);
    return this->NumberOfPieces() - 1;
  }

  std::vector<Point2> Vertices;
  std::vector<Id> Segments;
  std::vector<Piece> Pieces;
};

} // namespace biting

#endif
