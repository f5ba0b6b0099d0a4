// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingDrawing_h
#define BitingDrawing_h

#include "Domain/Polylines.h"

#include <vector> // for segments

namespace biting
{

/// A segment of the input.
struct DrawnSegment
{
  Point2 Start;
  Point2 End;
  Id Chain = NoId;
  Id Cell = NoId;
  bool Bounds = false; ///< by its kind, or because its chain is closed
  Id Face = NoId;      ///< the chain, where that is a face
  Id Region = 0;       ///< of the face
};

/// The input as the oracle reads it: plain segments and points, nothing resolved.
struct Drawing
{
  std::vector<DrawnSegment> Segments; ///< none of length zero
  std::vector<Point2> Points;         ///< embedded ones
  double Largest = 0.0;               ///< coordinate, in magnitude
  double SeamNoise = 0.0;             ///< of the input: points that near are one
  bool IsExplicit = false;            ///< what bounds is known without interpretation
  bool HasFaces = false;

  /// How far what is drawn may move in the domain: the kernel welds what is nearer than
  /// RoundingInUlp of the largest coordinate, once a round of its resolution, and rounds points on
  /// segments; but first points that SeamNoise does not tell apart.
  double Slack() const;

  /// The same with some of the segments only, and no points.
  Drawing Of(const std::vector<DrawnSegment>& segments) const;
};

/// Reads `input`, whose coordinates are finite. Those that the kernel takes for zero are zero.
Drawing ReadDrawing(const Polylines& input);

/// The segments of each face.
std::vector<std::vector<DrawnSegment>> FacesOf(const Drawing& drawing);

} // namespace biting

#endif
