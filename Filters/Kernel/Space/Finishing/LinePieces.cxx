// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "LinePieces.h"

#include <algorithm> // for find_if, max, replace

namespace biting
{

LinePieces::LinePieces(RelaxedBody& body)
  : Body(body)
  , PiecesAt(At(body.NumberOnLines))
  , IsFixed(At(body.NumberOnLines), 0)
{
  for (std::size_t k = 0; k < body.PieceEnds.size(); ++k)
  {
    this->PiecesAt[At(body.PieceEnds[k])].push_back(static_cast<Id>(k / 2));
  }
}

Id LinePieces::Between(Id a, Id b) const
{
  if (std::max(At(a), At(b)) >= this->PiecesAt.size())
  {
    return NoId;
  }
  const std::vector<Id>& pieces = this->PiecesAt[At(a)];
  const auto piece = std::find_if(
    pieces.begin(), pieces.end(), [this, a, b](Id k) { return this->OtherEnd(k, a) == b; });
  return piece == pieces.end() ? NoId : *piece;
}

std::array<Id, 2> LinePieces::PiecesOf(Id vertex) const
{
  const std::vector<Id>& chains = this->Body.PieceChains;
  if (vertex < this->Body.NumberOfCorners || chains.empty() ||
    At(vertex) >= this->PiecesAt.size() || this->IsFixed[At(vertex)] != 0)
  {
    return { NoId, NoId };
  }
  const std::vector<Id>& pieces = this->PiecesAt[At(vertex)];
  const bool isOne = pieces.size() == 2 && chains[At(pieces[0])] == chains[At(pieces[1])];
  return isOne ? std::array<Id, 2>{ pieces[0], pieces[1] } : std::array<Id, 2>{ NoId, NoId };
}

Id LinePieces::OtherEnd(Id piece, Id vertex) const
{
  const Id* ends = &this->Body.PieceEnds[At(2 * piece)];
  return ends[0] == vertex ? ends[1] : ends[0];
}

/// A piece that is gone keeps its ends, the first one as its code.
void LinePieces::Join(Id vertex, Id gone)
{
  const std::vector<Id>& own = this->PiecesAt[At(vertex)];
  const Id kept = own[0] == gone ? own[1] : own[0];
  Id& first = this->Body.PieceEnds[At(2 * gone)];
  const bool isUndone = first < 0;
  first = isUndone ? RelaxedBody::CodeOf(first) : first;
  const Id end = this->OtherEnd(gone, vertex);
  first = isUndone ? first : RelaxedBody::CodeOf(first);
  std::vector<Id>& pieces = this->PiecesAt[At(end)];
  std::replace(pieces.begin(), pieces.end(), isUndone ? kept : gone, isUndone ? gone : kept);
  Id* ends = &this->Body.PieceEnds[At(2 * kept)];
  std::replace(ends, ends + 2, isUndone ? end : vertex, isUndone ? vertex : end);
}

void LinePieces::GiveBack(const std::vector<Id>& numbers)
{
  std::vector<Id>& ends = this->Body.PieceEnds;
  std::vector<Id>& chains = this->Body.PieceChains;
  std::size_t kept = 0;
  for (std::size_t piece = 0; piece < ends.size() / 2; ++piece)
  {
    if (ends[2 * piece] >= 0)
    {
      ends[2 * kept] = numbers[At(ends[2 * piece])];
      ends[2 * kept + 1] = numbers[At(ends[2 * piece + 1])];
      if (!chains.empty())
      {
        chains[kept] = chains[piece];
      }
      ++kept;
    }
  }
  ends.resize(2 * kept);
  chains.resize(chains.empty() ? 0 : kept);
}

} // namespace biting
