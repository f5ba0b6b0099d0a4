// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingPieceUnion_h
#define BitingPieceUnion_h

#include "../Base/Ids.h"
#include "../Base/Pulse.h"
#include "../Blocks/WholeNumbers.h"
#include "../Mesh/BitingMesh.h"
#include "PieceDealer.h"

#include <cstddef> // for numbers of blocks
#include <vector>  // for constraints

namespace biting
{

/// The piece of one member of a crew: the cores of its blocks and its part of the collars' mesh.
struct UnitedPiece
{
  BitingMesh Mesh; ///< vertices, triangles and Piece only
  /// Of the triangles. Edges at which the part of the collars ends have one, too, so that each
  /// boundary edge has one.
  std::vector<Id> Constraints;
  bool IsSound = true; ///< false: a core does not fit to its collar
};

/// The blocks `numbers` of `kept`, rising, give their memory. Where the monitor wants to stop the
/// result has no meaning.
UnitedPiece UnitePiece(
  KeptBlocks& kept, const std::vector<std::size_t>& numbers, CollarPart part, Pulse& pulse);

/// Leaves out the triangles of a piece beyond the ghost level, and vertices that no other triangle
/// uses, with what is measured of them. Neighbors are not kept.
void TrimPiece(int ghostLevels, BitingMesh& mesh);

} // namespace biting

#endif
