// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingCutLine_h
#define BitingCutLine_h

#include "../Base/Box.h"
#include "../Base/BoxTree.h"
#include "../Base/Ids.h"
#include "../Base/Point.h"
#include "../Domain/DomainLocator.h"
#include "../Spacing/Spacing.h"
#include "CutFrame.h"
#include "CutGraph.h"

#include <algorithm> // for all_of
#include <cstdint>   // for flags
#include <vector>    // for the stretches

namespace biting
{

/// The pieces of a graph in a part of the plane. A cut with moved ends (CutEffort) leaves its line,
/// so pieces beside the box count, too.
///
/// Segments of the domain are found in a tree that all parts share. A search that finds k pieces
/// costs O(log n + k).
struct CutScene
{
  /// A segment of the domain by its first piece, or an embedded point.
  struct Filed
  {
    Id Piece; ///< NoId: an embedded point
    Id End;   ///< vertex: of the segment, or that point
    Box2 Bounds;

    const Box2& Box() const { return this->Bounds; }
    double Least() const { return 0.0; }
  };

  const CutGraph& Graph;
  const DomainLocator& Locator;
  const Spacing& F;
  const CutFrame& Frame;
  const std::vector<std::uint8_t>& AreUncut;     ///< segments of the domain that no cut may meet
  const std::vector<std::uint8_t>& ArePreserved; ///< segments that a cut may meet at ends only
  const BoxTree<Filed>& Tree;
  Box2 Box;               ///< in the frame
  Box2 Around;            ///< the box, widened
  std::vector<Id> Others; ///< pieces that meet Around and are not in the tree

  bool MayEndOn(const CutGraph::Piece& piece) const
  {
    return piece.Segment == NoId || this->AreUncut[piece.Segment] == 0;
  }

  bool MayDivide(const CutGraph::Piece& piece) const
  {
    return piece.Segment == NoId || this->ArePreserved.empty() ||
      this->ArePreserved[piece.Segment] == 0;
  }

  Box2 BoundsOf(Id piece) const
  {
    const CutGraph::Piece& ends = this->Graph.Pieces[piece];
    return Box2::Around(this->Frame.To(this->Graph.Vertices[ends.Start]),
      this->Frame.To(this->Graph.Vertices[ends.End]));
  }

  /// Whether `isSo` holds for all pieces of the scene whose boxes meet `place`, in the frame.
  template <typename Question>
  bool AllPieces(const Box2& place, const Question& isSo) const
  {
    const auto holds = [this, &place](Id piece)
    {
      const Box2 bounds = this->BoundsOf(piece);
      return bounds.Meets(place) && bounds.Meets(this->Around);
    };
    return this->Tree.AllOf(place,
             [this, &isSo, &holds](const Filed& filed)
             {
               const Id piece = filed.Piece;
               const bool isHere = piece != NoId && filed.Bounds.Meets(this->Around) &&
                 (this->Graph.Pieces[piece].End == filed.End || holds(piece));
               return !isHere || isSo(piece);
             }) &&
      std::all_of(this->Others.begin(), this->Others.end(),
        [&isSo, &holds](Id piece) { return !holds(piece) || isSo(piece); });
  }

  /// Whether `isSo` holds for all ends of these pieces, and all embedded points, that lie in
  /// `place`. A vertex may be asked for several times.
  template <typename Question>
  bool AllVertices(const Box2& place, const Question& isSo) const
  {
    const auto isAway = [this, &place](Id vertex)
    { return !place.Contains(this->Frame.To(this->Graph.Vertices[vertex])); };
    return this->AllPieces(place,
             [this, &isSo, &isAway](Id piece)
             {
               const CutGraph::Piece& ends = this->Graph.Pieces[piece];
               return (isAway(ends.Start) || isSo(ends.Start)) &&
                 (isAway(ends.End) || isSo(ends.End));
             }) &&
      this->Tree.AllOf(
        place, [&isSo](const Filed& filed) { return filed.Piece != NoId || isSo(filed.End); });
  }
};

/// A line parallel to an axis of a frame.
struct AxisLine
{
  bool IsVertical = true;
  double At = 0.0;

  /// The box up to `margin` on both sides of the line, and from `low` to `high` along it.
  Box2 Band(double margin, double low, double high) const
  {
    const double from = this->At - margin;
    const double to = this->At + margin;
    return this->IsVertical ? Box2{ { from, low }, { to, high } }
                            : Box2{ { low, from }, { high, to } };
  }
};

/// Where a cut begins or ends: at a vertex, or on a piece, which is divided there by a new vertex.
struct CutEnd
{
  Point2 Place;
  double Along = 0.0; ///< the coordinate along the line
  Id Vertex = NoId;
  Id Piece = NoId; ///< where Vertex is NoId
  double F = 0.0;
  bool IsOpen = false; ///< nothing is near but the segments that it is on, nearly at right angles
};

/// A straight part of the line, through the domain, between two neighbouring pieces.
struct CutStretch
{
  CutEnd From;
  CutEnd To;
};

/// The part of a line that is in the domain and in the box of the scene.
struct CutLine
{
  std::vector<CutStretch> Stretches;
  bool IsGood = true;
};

/// How a line with a stretch that is not good is treated.
enum class CutEffort
{
  AsItIs,
  /// Each end of such a stretch moves to a vertex within some f, so that the stretch is good. Short
  /// stretches are left out, so the line may fail to divide the domain.
  MoveEnds
};

/// The stretches of `line`, each from a piece to the next. The line is not good, and its stretches
/// are of no use, where a stretch meets a piece again, comes near to a vertex or a piece in
/// proportion to f, leaves a piece at less than 40 degrees, ends on a segment that stays uncut, or
/// is short.
CutLine MakeCutLine(
  const CutScene& scene, const AxisLine& line, CutEffort effort = CutEffort::AsItIs);

} // namespace biting

#endif
