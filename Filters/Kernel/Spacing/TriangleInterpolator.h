// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingTriangleInterpolator_h
#define BitingTriangleInterpolator_h

#include "BorderTree.h"
#include "Spacing.h"
#include "TriangleBuckets.h"

#include <memory> // for buckets

namespace biting
{

/// The piecewise linear interpolant of a triangulated source; in its holes and outside the value of
/// the nearest point of it. Where triangles leave a gap by rounding, that is the value beside the
/// gap. Where triangles overlap the smallest value counts, if the source says that they may.
class TriangleInterpolator
{
public:
  /// Leaves out triangles that have no area or have a corner that is NaN.
  /// Incomplete if the monitor asks to stop: it must not be evaluated then.
  explicit TriangleInterpolator(const TriangulatedSource& source, Monitor& monitor = NoMonitor());

  /// No triangle is left: it must not be evaluated.
  bool IsEmpty() const { return this->Records.empty(); }

  /// Whether triangles may lie on each other.
  bool HasOverlaps() const { return this->MayOverlap; }

  double operator()(const Point2& x) const;

  /// Whether x is on a triangle.
  bool Covers(const Point2& x) const { return this->FindRecord(x, false) != nullptr; }

  /// For x outside of all triangles: the nearest point of their border. Elsewhere x itself, at a
  /// distance of 0. It is found sooner beside one that is `known`, of another place.
  NearestValue Nearest(const Point2& x, const NearestValue& known = Unknown()) const;

  /// The nearest point of the border, or `known` where none is nearer.
  NearestValue NearestOfBorder(const Point2& x, const NearestValue& known) const
  {
    return this->Border.Nearest(x, known);
  }

  const std::vector<BorderEdge>& BorderEdges() const { return this->Border.AllEdges(); }

private:
  /// One triangle: the weights of corners 1 and 2 are linear in x - Origin (corner 0).
  struct Record
  {
    Point2 Origin;
    Point2 FirstWeight;
    Point2 SecondWeight;
    double Value;
    double FirstValue;
    double SecondValue;
  };

  void MakeRecords(const TriangulatedSource& source, const std::vector<Id>& usable, Pulse& pulse);
  static Record MakeRecord(const TriangulatedSource& source, const Id* corners);
  const Record* FindRecord(const Point2& x, bool isLeast) const;
  static double ValueAt(const Record& record, const Point2& x);
  static NearestValue Unknown();
  NearestValue NearestOutside(const Point2& x, const NearestValue& known) const;
  static NearestValue NearestOnTriangle(const Record& record, const Point2& x);

  std::unique_ptr<TriangleBuckets> Buckets; ///< of Records
  std::vector<Record> Records;              ///< in the order of the buckets
  BorderTree Border;
  bool MayOverlap = false;
};

} // namespace biting

#endif
