// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingBlockBytes_h
#define BitingBlockBytes_h

#include "BlockDomains.h"
#include "JoinedBlocks.h"

#include <vector> // for bytes

namespace biting
{

/// The meshes of those of all `blocks` that `numbers` names, as bytes of this machine, for another
/// process that has the same blocks: about 115 a vertex. Numbers of vertices stay 32 bits wide, as
/// they are those of a block.
std::vector<char> PackBlocks(const BlockDomains& blocks, const std::vector<std::size_t>& numbers,
  const std::vector<BlockMesh>& meshes);

/// Puts them where they belong. False where the bytes are none, or of other blocks; then nothing is
/// changed.
bool UnpackBlocks(const std::vector<char>& bytes, const BlockDomains& blocks,
  const std::vector<std::size_t>& numbers, std::vector<BlockMesh>& meshes);

} // namespace biting

#endif
