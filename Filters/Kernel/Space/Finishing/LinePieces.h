// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingLinePieces_h
#define BitingLinePieces_h

#include "BodyRelaxation.h"

#include <array>   // for two pieces
#include <cstdint> // for marks
#include <vector>  // for lists of pieces

namespace biting
{

/// The pieces of feature lines of a body, found by their vertices.
class LinePieces
{
public:
  explicit LinePieces(RelaxedBody& body);

  /// The piece between two vertices, or NoId.
  Id Between(Id a, Id b) const;

  /// The two pieces of one chain at a vertex that is no corner and not fixed; else NoId.
  std::array<Id, 2> PiecesOf(Id vertex) const;
  void Fix(Id vertex) { this->IsFixed[At(vertex)] = 1; }
  Id OtherEnd(Id piece, Id vertex) const;

  /// Makes one piece of the two at a vertex: `gone`, whose other end gets the other piece. A
  /// second call undoes the first; several are undone in reverse order.
  void Join(Id vertex, Id gone);

  /// Pieces that are gone leave the body; vertices get new numbers.
  void GiveBack(const std::vector<Id>& numbers);

private:
  RelaxedBody& Body;
  std::vector<std::vector<Id>> PiecesAt; ///< of vertices on lines
  std::vector<std::uint8_t> IsFixed;     ///< the same
};

} // namespace biting

#endif
