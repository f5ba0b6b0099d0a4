// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingBiteTriangle_h
#define BitingBiteTriangle_h

#include "../Base/Point.h"
#include "Bites.h"
#include "FrontOrder.h"

namespace biting
{

/// The triangle of a new bite and the two that it stands on, and f at each: as much as is known of
/// the slope of f without asking for more of it. How inner bites follow that slope, so that the
/// mean edge length is f: squares by their place, circles by their radius.
struct BiteTriangle
{
  Point2 Left;
  Point2 Right;
  Point2 Top;
  double LeftSpacing;
  double RightSpacing;
  double TopSpacing;
};

/// Where the top of the triangle makes each of its two new edges as long as the mean of f at its
/// ends, times `lengthPerSpacing`; on the side of the bond where Top is. Top itself where no place
/// does, or one nearer to it than a thousandth of an edge: sides of bites that are in line stay so
/// exactly.
///
/// A bisector point is as far from one bite as from the other. In a spacing that changes along the
/// bond that makes one edge too long and the other too short, and the lattice breaks up into pieces
/// that do not fit: balanced, it bends with the spacing instead, and keeps six triangles at nearly
/// all vertices.
/// Laws: the same in all units, places and directions; mirrored where Left and Right are exchanged;
/// where f is level, on the bisector.
Point2 BalancedTop(const BiteTriangle& triangle, double lengthPerSpacing);

/// How large the bite at Top is, in units of c_b f, for the mean edge length to be f.
///
/// Two things make lengths depend on the slope g of f, which is the same in all scales of f:
/// - A circle keeps the next one away by the f of its own centre, though the length between them is
///   to be the mean of both (squares are placed by that: BalancedTop). Bites that go on as f grows
///   are larger by their share of that growth, others smaller. That makes lengths independent of
///   the direction in which the front moves.
/// - Lattices of one length do not fit a field with another: between them are faults, in which
///   lengths are greater, and the more of them the greater g. Measured over 12 domains and fields,
///   most of them in two to four scales: by .29 g for squares, by FrontRule::FaultsOfCircles
///   sqrt(g) for circles.
/// The mean length of inner edges then is within 2 % of f for most fields with g <= .3, within 4 %
/// for all that were measured.
/// Laws: 1 where f is level; within the bounds; the same in all units, places and directions;
/// continuous in f. A slope counts as 1 at most, that ahead as 0.5.
double ReachFactor(BiteShape shape, FrontOrder order, const BiteTriangle& triangle);

/// What bounds the factor below and above where no slope of f is greater than `slope`.
double LeastReachFactor(double slope);
double GreatestReachFactor(double slope);

} // namespace biting

#endif
