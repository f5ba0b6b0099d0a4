// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingBlockBytes_h
#define BitingBlockBytes_h

#include "BlockCollar.h"
#include "BlockDomains.h"

#include <cstddef> // for numbers of blocks
#include <vector>  // for bytes

namespace biting
{

/// The collars of those of all `blocks` that `numbers` names, as bytes of this machine, for another
/// process that has the same blocks: about 115 a vertex. Numbers of vertices stay 32 bits wide, as
/// they are those of a block.
std::vector<char> PackCollars(const BlockDomains& blocks, const std::vector<std::size_t>& numbers,
  const std::vector<BlockCollar>& collars);

/// Puts them where they belong. False where the bytes are none, or of other blocks; then nothing is
/// changed.
bool UnpackCollars(const std::vector<char>& bytes, const BlockDomains& blocks,
  const std::vector<std::size_t>& numbers, std::vector<BlockCollar>& collars);

} // namespace biting

#endif
