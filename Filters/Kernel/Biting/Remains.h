// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingRemains_h
#define BitingRemains_h

#include "../Base/Ids.h"
#include "../Base/Point.h"
#include "Bites.h"

#include <array>   // for triangles
#include <cstddef> // for counts
#include <utility> // for pairs
#include <vector>  // for the pieces

namespace biting
{

/// What bites leave of a triangle, as convex pieces.
/// A square is taken away as it is; of a circle, a regular polygon of 64 corners on it. Bites are
/// taken to be larger by a slack, so that those that touch leave nothing between them.
class Remains
{
public:
  /// Begins with all of the triangle.
  void Begin(const std::array<Point2, 3>& triangle);

  /// False where that changes nothing.
  bool TakeAway(const Bites& bites, Id bite, double slack);

  bool IsEmpty() const { return this->Left.Ends.empty(); }

  /// The mean of the corners of the last piece, which lies in it; and to take that piece away.
  Point2 MiddleOfLast() const;
  void DropLast() { this->Left.DropLast(); }

private:
  // Polygon i ends before Ends[i].
  struct Polygons
  {
    std::vector<Point2> Corners;
    std::vector<std::size_t> Ends;

    std::size_t Begin(std::size_t polygon) const
    {
      return polygon == 0 ? 0 : this->Ends[polygon - 1];
    }
    void Clear();
    void DropLast();
    void Shrink(std::size_t count);
  };

  // Of a bite: a regular polygon, of a square itself.
  struct Sides
  {
    Point2 Center;
    double Reach; ///< from the centre, with the slack
    double Slack;
    double CosineOfHalfTurn;     ///< from a normal to the next
    std::vector<Point2> Normals; ///< outwards
  };

  void SetSides(const Bites& bites, Id bite, double slack);
  bool CutPiece(const Point2* begin, const Point2* end);
  std::pair<double, double> MeasureBeyond(const Point2& normal);
  void CutInside();
  void KeepWhole(const Point2* begin, const Point2* end);

  Sides Bite; ///< what is taken away
  Polygons Left;
  Polygons Next;
  std::vector<Point2> Inside; ///< of a piece: what is within the sides so far
  std::vector<Point2> Cut;
  std::vector<double> Beyond; ///< how far the corners of Inside lie beyond a side
};

// Whether nothing is left of a triangle, by what is about its corners alone.

/// Whether each place of the triangle is within `distance` of one of its corners.
bool IsWithinOfCorners(const std::array<Point2, 3>& corners, double distance);

/// Whether these bites, centred at the corners of the triangle, cover it. Where it says no they may
/// do so all the same.
bool CoverTriangle(const Bites& bites, const std::array<Id, 3>& atCorners);

} // namespace biting

#endif
