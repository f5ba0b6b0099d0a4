// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingSourceCover_h
#define BitingSourceCover_h

#include "../../Kernel/Base/Box.h"
#include "../../Kernel/BitingMesh.h"
#include "../../Kernel/Spacing/Spacing.h"
#include "../Drawing/PlaneFrame.h"

#include <cstddef> // for numbers of squares
#include <cstdint> // for triangles
#include <limits>  // for none
#include <string>  // for the warning
#include <vector>  // for marks

namespace biting
{

/// Where a spacing source has something to say: a grid in its box, a triangulation near its
/// triangles; each with a margin about as wide as its own points lie apart. Holes of a grid belong
/// to it.
class SourceCover
{
public:
  /// Of the one grid or triangulation of `options`; everything is covered where there is none.
  explicit SourceCover(const SpacingOptions& options);

  bool Covers(const Point2& place) const;

private:
  void Cover(const GridSource& grid);
  void Cover(const TriangulatedSource& source);
  void Cover(const SegmentSource&) {} // everywhere
  void Mark(const Box2& box);
  std::size_t Column(double x) const;
  std::size_t Row(double y) const;

  bool HasSource = false;
  Box2 Bounds; ///< with the margin
  double SquareSize = 0.0;
  std::size_t Columns = 0;
  std::size_t Rows = 0;
  std::vector<char> IsMarked; ///< squares over the bounds; empty: all of them
};

/// The part of a mesh, or of a piece of it, that sources do not cover. Parts of pieces are joined.
struct UncoveredPart
{
  double WholeArea = 0.0;
  double Area = 0.0;
  std::int64_t FirstTriangle = std::numeric_limits<std::int64_t>::max(); ///< that is not covered
  Point2 Place;                                                          ///< its middle

  void Join(const UncoveredPart& other);
};

/// Of the triangles that are the piece's own; all are where it is none.
UncoveredPart FindUncovered(const BitingMesh& mesh, const SpacingOptions& options);

/// A warning of the uncovered part, with its place in space; empty where all is covered.
std::string UncoveredWarning(const UncoveredPart& part, const PlaneFrame& frame);

/// Warns of the part of a mesh that the sources of `options` do not cover, if there is any: how
/// much of it, and a place in space. Empty where there is none.
std::string UncoveredWarning(const std::vector<Point2>& points, const std::vector<Id>& corners,
  const SpacingOptions& options, const PlaneFrame& frame);

} // namespace biting

#endif
