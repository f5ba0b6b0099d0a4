// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingPolylines_h
#define BitingPolylines_h

#include "../Base/Ids.h"
#include "../Base/Point2.h"

#include <vector> // for the arrays

namespace biting
{

/// What a chain of the input is.
enum class ChainKind : signed char
{
  Automatic = -1,    ///< closed chains are boundary, open ones interface (see Domain.h)
  Boundary = 0,      ///< bounds the domain, by even-odd parity
  Interface = 1,     ///< becomes mesh edges, does not change the domain
  EmbeddedPoint = 2, ///< every point of it becomes a mesh vertex
  Face = 3 ///< closed: the outline of a two-dimensional cell, whose area counts (see Domain.h)
};

/// How far off, in units in the last place of the largest coordinate, a computed point may be.
///
/// A filter computes points as a + t (b - a), in the type of the coordinates. With u half a unit
/// and M the largest coordinate, b - a is off by 2 u M, and so are its product with t, for its own
/// rounding and for that of t each; the sum is off by u M more: 7 u M, or 3.5 units, at worst.
constexpr double RoundingInUlp = 4.0;

/// How far apart points may be that are meant to be one: two computed points, each off by as much.
/// In slices of ParaView's sources points that are meant to be one are up to 6 units apart.
constexpr double NoiseInUlp = 2.0 * RoundingInUlp;

/// The input of the kernel: chains of points in the plane, as they come (points may repeat, chains
/// may touch). Chain c has the points Connectivity[Offsets[c]] .. Connectivity[Offsets[c + 1] - 1];
/// a closed chain repeats its first point id at its end.
struct Polylines
{
  std::vector<Point2> Points;
  std::vector<Id> Offsets{ 0 };
  std::vector<Id> Connectivity;
  std::vector<ChainKind> Kinds; ///< one a chain
  std::vector<Id> Cells;        ///< the input cell of each chain, for messages and tags
  std::vector<Id> Regions; ///< of each chain, what faces tell apart; empty: all are of one region

  /// Points that are not further apart are one: NoiseInUlp units in the last place of the largest
  /// coordinate, in the type that the points had. Where it is less, RoundingInUlp counts, in
  /// doubles.
  double Rounding = 0.0;

  Id NumberOfChains() const { return static_cast<Id>(this->Kinds.size()); }
};

} // namespace biting

#endif
