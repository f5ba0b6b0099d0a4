// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingCutLine_h
#define BitingCutLine_h

#include "../Base/Ids.h"
#include "../Base/Point.h"
#include "CutScene.h"

#include <vector> // for the stretches

namespace biting
{

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
