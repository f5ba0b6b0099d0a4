// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingDrawingOracle_h
#define BitingDrawingOracle_h

#include "JudgedMesh.h"

#include <map> // for faces

namespace biting
{

/// That the mesh is that of the drawing: its area, its points, its segments, what lies on them.
class DrawingOracle
{
public:
  explicit DrawingOracle(JudgedMesh& judged)
    : Judged(judged)
  {
  }

  bool Holds();

private:
  enum class Answer
  {
    No,
    Unknown,
    Yes
  };

  bool HasArea();
  bool KeepsPoints();
  bool IsOfPoint(const DrawnSegment& segment) const;
  bool KeepsPoint(const Point2& p, const char* what);
  bool IsAtBoundary(const Point2& p) const;
  bool IsAtVertex(const Point2& p) const;
  bool Covers(const Point2& p) const;
  bool CoversSegments();
  bool CoversSegment(const DrawnSegment& segment);
  bool CoversGap(const DrawnSegment& segment, double from, double to);
  Answer DividesFaces(const Point2& p, const Point2& q, double slack) const;
  bool HasTriangle(const std::map<Id, const DrawnSegment*>& faces) const;
  bool SurelyDividesFaces(const Point2& p, const Point2& q) const;
  bool MayDivideFaces(const Point2& p, const Point2& q) const;
  bool AllSay(Answer answer, const Point2& p, const Point2& q) const;
  bool HasLine(const Point2& p, const Point2& q) const;
  bool CoversSafely(const Point2& p) const;
  bool LiesOnInput();
  bool LiesOnCell(const Point2& p, Id cell) const;
  bool HasKinds();
  bool HasKind(std::size_t vertex, bool isOnEdge);
  bool PreservesBoundary();

  JudgedMesh& Judged;
};

} // namespace biting

#endif
