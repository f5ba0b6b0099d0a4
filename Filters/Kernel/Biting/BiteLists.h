// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingBiteLists_h
#define BitingBiteLists_h

#include "../Base/Ids.h"

#include <cstddef> // for sizes
#include <cstdint> // for numbers of blocks
#include <memory>  // for chunks of blocks
#include <vector>  // for the chunks

namespace biting
{

/// A bite as a leaf of the grid sees it, in units of the leaf.
struct BiteEntry
{
  float X, Y;   ///< its centre, from the low corner
  float Square; ///< of its half-width
  Id Bite;
};

/// Lists of bites, the newest first. A list is told by the number of its newest block, NoId where
/// it is empty; bites are only ever added to it, or taken out all at once.
class BiteLists
{
public:
  void Append(const BiteEntry& entry, Id& list);

  /// Calls visit(entry), the newest first, until it returns true.
  template <typename Visitor>
  bool Visit(Id list, Visitor&& visit) const;

  /// Empties the list; its memory is for the lists that follow.
  void Empty(Id& list);

private:
  // Two cache lines. Larger ones are half empty more often: 15 B a bite for twice the entries.
  struct Block
  {
    static constexpr Id Capacity = 7;
    Id Older = NoId;
    Id Count = 0;
    BiteEntry Entries[Capacity];
  };

  static constexpr std::uint32_t ChunkSize = 128;
  static constexpr std::size_t ShareAtOnce = 32; ///< one of so many that there are

  // Not signed: to divide by a power of two is to shift then.
  Block& At(Id block) const
  {
    const auto number = static_cast<std::uint32_t>(block);
    return this->Chunks[number / ChunkSize][number % ChunkSize];
  }
  Id Add();
  void AddChunks();

  // In chunks: to move all blocks where there is no room for one more takes twice the memory.
  // Chunks are allocated several at once, the more the more there are: threads that allocate small
  // parts by the thousand wait for each other.
  std::vector<std::unique_ptr<Block[]>> Allocated;
  std::vector<Block*> Chunks; ///< in what is allocated
  Id Count = 0;
  Id Unused = NoId; ///< a list of blocks that were emptied
};

inline void BiteLists::Append(const BiteEntry& entry, Id& list)
{
  Block* newest = list == NoId ? nullptr : &this->At(list);
  if (newest == nullptr || newest->Count == Block::Capacity)
  {
    const Id added = this->Add();
    newest = &this->At(added);
    newest->Older = list;
    newest->Count = 0;
    list = added;
  }
  newest->Entries[newest->Count++] = entry;
}

template <typename Visitor>
bool BiteLists::Visit(Id list, Visitor&& visit) const
{
  while (list != NoId)
  {
    const Block& entries = this->At(list);
    for (Id k = entries.Count; k-- > 0;)
    {
      if (visit(entries.Entries[k]))
      {
        return true;
      }
    }
    list = entries.Older;
  }
  return false;
}

} // namespace biting

#endif
