// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingPolylines_h
#define BitingPolylines_h

#include "../Base/Ids.h"
#include "../Base/Point.h"

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

/// How far apart points may be that were computed along two ways, in units of 2^-52 of the size of
/// the drawing: at the seam of a surface that closes on itself, by an angle near zero and by a full
/// turn.
///
/// With e = 2^-52, a full turn start + i step is off by 1.1 e for pi, by pi e for the step, and by
/// 2 e for the product and for the sum each: below 9 e. Shapes are trigonometric polynomials of
/// their angles, no larger than S / 2 where S is their size. Of degree k, by Bernstein's
/// inequality, a place moves by at most k S / 2 times what its angle does: 4.5 k e S. Degrees up to
/// six are usual (Boy's surface): 27 e S, and a few for the formula itself. Where such a shape was
/// moved far away its size has stayed: what the place adds is in NoiseInUlp. In slices of
/// ParaView's sources such points are up to 16 units of their largest coordinate apart, 8 of their
/// size.
///
/// It is no measure for points beside segments: a bend or a spike that thin is a shape.
constexpr double SeamInUlp = 32.0;

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

  /// Along x and along y: points that are not further apart are one, by the ellipse with these
  /// half-axes. The rounding of computed points in the type that they had (CoordinateRounding.h).
  /// Where it is less, RoundingInUlp counts, in doubles.
  Point2 Rounding;

  /// Where it is more, points that are not further apart than this are one, too: SeamInUlp. But a
  /// point that near to a segment is beside it.
  double SeamNoise = 0.0;

  Id NumberOfChains() const { return static_cast<Id>(this->Kinds.size()); }
};

} // namespace biting

#endif
