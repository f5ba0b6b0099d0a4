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

  Id NumberOfChains() const { return static_cast<Id>(this->Kinds.size()); }
};

} // namespace biting

#endif
