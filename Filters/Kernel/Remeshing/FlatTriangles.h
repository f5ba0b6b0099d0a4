// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingFlatTriangles_h
#define BitingFlatTriangles_h

#include "../Base/Ids.h"
#include "../Base/Point.h"

#include <array>   // for sides
#include <cstddef> // for sizes
#include <cstdint> // for flags
#include <utility> // for pairs
#include <vector>  // for the arrays

namespace biting
{

/// One that was flat.
struct FlatTriangle
{
  Id Triangle = NoId;
  Point2 Middle;
};

/// A side of a flat triangle that is no edge any more: its ends, and the corner between.
using DividedSide = std::array<Id, 3>;

/// What became of flat triangles. Triangles that were neither flat nor beside such are what they
/// were, in their order.
struct FlatTriangleRepair
{
  std::vector<FlatTriangle> Flat;  ///< in the order in which they went, each once
  std::vector<Id> Origins;         ///< of each triangle now: the one that was there, or beside it
  std::vector<std::uint8_t> IsNew; ///< of each triangle now: its corners are others
  std::vector<std::pair<Id, Id>> Welded; ///< vertices at one place: that which went, which stayed
  std::vector<DividedSide> Divided;      ///< in the order in which they went
  std::vector<Id> RimVertices;           ///< corners of those that went with nothing in their place
};

/// Takes flat triangles out of a mesh, as contours, clips and triangulations of polygons leave them
/// behind: those without area, and those no higher than `rounding` that lie on others beside them,
/// as rounding turned them over. Of two corners at one place the lower one stays for both; else the
/// triangle across the longest side is divided at the third corner, and the flat one is a part of
/// it afterwards. At a free edge the flat one only goes. What cannot be mended so stays, as where
/// more than 32 lie one upon another in a mesh of more than 100,000 triangles, and so does a mesh
/// that has no other triangles. `corners` are three a triangle, of any orientation; the last
/// `filled` of them were put in between others (HangingVertices.h) and are mended, however little
/// area they have, but not listed as flat. Cost O(n), once where nothing is flat.
FlatTriangleRepair RepairFlatTriangles(const std::vector<Point2>& points, double rounding,
  std::vector<Id>& corners, std::size_t filled = 0);

} // namespace biting

#endif
