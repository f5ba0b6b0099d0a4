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
  bool IsExplicit = false;            ///< what bounds is known without interpretation
  bool HasFaces = false;

  /// How far what is drawn may move in the domain: see EvenOddArea.h.
  double Slack() const;
};

/// Reads `input`, whose coordinates are finite. Those that the kernel takes for zero are zero.
Drawing ReadDrawing(const Polylines& input);

/// The area of the even-odd region of the segments that bound, each as often as it is drawn, and
/// how far from it the area of a correct mesh may be.
///
/// The area changes by no more than d times the length of the boundary where no point of it moves
/// further than d; so nothing here needs to be exact. Drawing::Slack is that d: the kernel welds what
/// is nearer than 4 ulp of the largest coordinate, once a round of its resolution, and rounds points
/// on segments.
struct EvenOddArea
{
  double Area = 0.0;
  double Tolerance = 0.0;
};
EvenOddArea MeasureEvenOddArea(const Drawing& drawing);

/// The even-odd areas of all faces, one by one, added up; as exact as that of a drawing.
EvenOddArea SumOfFaces(const Drawing& drawing);

} // namespace biting

#endif
