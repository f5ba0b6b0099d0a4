// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingCollarPart_h
#define BitingCollarPart_h

#include "../Base/Ids.h"
#include "../Blocks/WholeNumbers.h"
#include "../Mesh/BitingMesh.h"

#include <vector> // for bytes

namespace biting
{

/// What a member of a crew gets of the collars' mesh: the triangles that are to be its own, and
/// rings of others around them; and where the cores of its blocks are in the whole.
struct CollarPart
{
  BitingMesh Mesh; ///< vertices, triangles and Piece only
  std::vector<Id> Constraints;
  std::vector<BlockNumbers> Blocks; ///< of its own, rising
  int GhostLevels = 0;
  bool CountsAsked = false; ///< vertices that the spacing asks for (FineDrawing.h)
};

std::vector<char> PackPart(const CollarPart& part);

/// False where the bytes are none.
bool UnpackPart(const std::vector<char>& bytes, CollarPart& part);

} // namespace biting

#endif
