// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingKeptBlocks_h
#define BitingKeptBlocks_h

#include "../Base/Ids.h"
#include "BlockCollar.h"
#include "BlockDomains.h"
#include "JoinedBlocks.h"
#include "WholeNumbers.h"

#include <vector> // for the blocks

namespace biting
{

/// Where blocks stay with the members of a crew that made them: what a member has when all are
/// relaxed. Collars of blocks have no mesh any more then.
struct KeptBlocks
{
  BlockDomains Parts;
  std::vector<BlockMesh> Meshes;    ///< of its own blocks; the others are empty
  std::vector<BlockCollar> Collars; ///< of its own blocks, and on the first member of all

  // On the first member.
  bool AreSpread = false;       ///< else it has the whole mesh
  std::vector<Id> Holders;      ///< members, of the blocks
  std::vector<bool> AreHolding; ///< of the members: they have given collars, and wait for the rest
  WholeNumbers Numbers;
  std::vector<Id> Owners; ///< members, of the triangles of the collars' mesh
};

} // namespace biting

#endif
