// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "CutDivision.h"

#include "../Base/PointOnSegment.h"
#include "../Biting/EdgeDivision.h"
#include "CutRows.h"

#include <cmath> // for sqrt

namespace biting
{

namespace
{

// Pairs of rows at an end that is not open, in which the cut stays on its line.
constexpr std::size_t StraightPairs = 2;

class CutDivider
{
public:
  CutDivider(const Spacing& spacing, const CutDivision& wanted, CutGraph& graph, Pulse& pulse)
    : F(spacing)
    , Wanted(wanted)
    , Graph(graph)
    , Sides(spacing, wanted.BitingConstant, wanted.PartLength, pulse)
    , Pairs(
        spacing, CutRows::Pair * wanted.BitingConstant, CutRows::Pair * wanted.PartLength, pulse)
  {
  }

  bool Divide(Id piece)
  {
    this->Start = this->Graph.Vertices[this->Graph.Pieces[piece].Start];
    this->End = this->Graph.Vertices[this->Graph.Pieces[piece].End];
    const bool isFolded = this->Graph.Pieces[piece].Folded.IsFolded;
    EdgeDivider& divider = isFolded ? this->Pairs : this->Sides;
    if (!divider.Divide(this->Start, this->End, this->Wanted.MostVertices, this->Points))
    {
      return false;
    }
    isFolded ? this->SplitFolded(piece) : this->SplitStraight(piece);
    return true;
  }

private:
  // A vertex on the line of the cut, and f there.
  struct PlaceOnLine
  {
    double Parameter;
    double F;
  };

  void SplitStraight(Id piece)
  {
    for (std::size_t k = 0; k < this->Points.Parameters.size(); ++k)
    {
      const Point2 place = PointOnSegment(
        this->Start, this->End, this->Points.Parameters[k], this->Points.Spacings[k]);
      piece = this->Graph.Split(piece, this->Graph.AddVertex(place, NoId));
    }
  }

  // The points divide it into pairs of rows, of which each is divided once more.
  void SplitFolded(Id piece)
  {
    const CutGraph::Fold fold = this->Graph.Pieces[piece].Folded;
    const std::size_t pairs = this->Points.Parameters.size() + 1;
    PlaceOnLine last{ 0.0, this->F(this->Start) };
    for (std::size_t k = 0; k < pairs; ++k)
    {
      const bool isLast = k + 1 == pairs;
      const PlaceOnLine next{ isLast ? 1.0 : this->Points.Parameters[k],
        isLast ? this->F(this->End) : this->Points.Spacings[k] };
      const bool isFolded = (fold.IsOpenAtStart || k >= StraightPairs) &&
        (fold.IsOpenAtEnd || k + StraightPairs < pairs);
      piece = this->Graph.Split(
        piece, this->Graph.AddVertex(this->FoldBetween(last, next, isFolded), NoId));
      if (!isLast)
      {
        const Point2 place = PointOnSegment(this->Start, this->End, next.Parameter, next.F);
        piece = this->Graph.Split(piece, this->Graph.AddVertex(place, NoId));
      }
      last = next;
    }
  }

  // Halves the integral of 1/f between two places, as it is where f is linear. The root is of a
  // ratio: so it is the same in all units of length.
  Point2 FoldBetween(const PlaceOnLine& first, const PlaceOnLine& next, bool isFolded) const
  {
    const double share = 1.0 / (1.0 + std::sqrt(next.F / first.F));
    const double parameter = first.Parameter + share * (next.Parameter - first.Parameter);
    const Point2 way = this->End - this->Start;
    const Point2 middle = this->Start + parameter * way;
    const double aside = isFolded ? 0.5 * this->Wanted.PartLength * this->F(middle) : 0.0;
    return middle + aside / Length(way) * Perpendicular(way);
  }

  const Spacing& F;
  const CutDivision& Wanted;
  CutGraph& Graph;
  EdgeDivider Sides;
  EdgeDivider Pairs;
  DivisionPoints Points;
  Point2 Start; ///< of the cut at hand
  Point2 End;
};

} // namespace

bool DivideCuts(const Spacing& spacing, const CutDivision& wanted, CutGraph& graph, Pulse& pulse)
{
  CutDivider divider(spacing, wanted, graph, pulse);
  const Id undivided = graph.NumberOfPieces();
  for (Id piece = 0; piece < undivided; ++piece)
  {
    if (graph.IsCut(piece) && !divider.Divide(piece))
    {
      return false;
    }
  }
  return true;
}

} // namespace biting
