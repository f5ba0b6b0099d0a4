// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingReachFactor_h
#define BitingReachFactor_h

#include "../Base/Point.h"
#include "Bites.h"
#include "CandidateQueue.h" // for FrontOrder

namespace biting
{

/// The triangle of a new bite and the two that it stands on, and f at each: as much as is known of
/// the slope of f without asking for more of it.
struct BiteTriangle
{
  Point2 Left;
  Point2 Right;
  Point2 Top;
  double LeftSpacing;
  double RightSpacing;
  double TopSpacing;
};

/// What bounds the factor below and above where no slope of f is greater than `slope`.
double LeastReachFactor(double slope);
double GreatestReachFactor(double slope);

/// How large the bite at Top is, in units of c_b f, for the mean edge length to be f.
///
/// Two things make lengths depend on the slope g of f, which is the same in all scales of f:
/// - A circle keeps the next one away by the f of its own centre, though the length between them is
///   to be the mean of both (squares are placed by that: BalancedTop.h). Bites that go on as f
///   grows are larger by their share of that growth, others smaller. That makes lengths independent
///   of the direction in which the front moves.
/// - Lattices of one length do not fit a field with another: between them are faults, in which
///   lengths are greater, and the more of them the greater g. Measured over 12 domains and fields,
///   most of them in two to four scales: by .29 g for squares, .2 sqrt(g) for circles, .25 sqrt(g)
///   with BestFirst.
/// The mean length of inner edges then is within 2 % of f for most fields with g <= .3, within 4 %
/// for all that were measured.
/// Laws: 1 where f is level; within the bounds; the same in all units, places and directions;
/// continuous in f. A slope counts as 1 at most, that ahead as 0.5.
double ReachFactor(BiteShape shape, FrontOrder order, const BiteTriangle& triangle);

} // namespace biting

#endif
