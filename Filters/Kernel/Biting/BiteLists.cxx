// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "BiteLists.h"

namespace biting
{

void BiteLists::Append(const BiteEntry& entry, Id& list)
{
  if (list == NoId || this->At(list).Count == Block::Capacity)
  {
    const Id added = this->Add();
    this->Chunks[added / ChunkSize][added % ChunkSize].Older = list;
    list = added;
  }
  Block& newest = this->Chunks[list / ChunkSize][list % ChunkSize];
  newest.Entries[newest.Count++] = entry;
}

Id BiteLists::Add()
{
  if (static_cast<std::size_t>(this->Count) == ChunkSize * this->Chunks.size())
  {
    this->AddChunks();
  }
  return this->Count++;
}

void BiteLists::AddChunks()
{
  const std::size_t chunks = 1 + this->Chunks.size() / ShareAtOnce;
  // make_unique would fill it twice
  this->Allocated.emplace_back(new Block[chunks * ChunkSize]);
  for (std::size_t k = 0; k < chunks; ++k)
  {
    this->Chunks.push_back(this->Allocated.back().get() + k * ChunkSize);
  }
}

void BiteLists::Clear()
{
  std::vector<std::unique_ptr<Block[]>>().swap(this->Allocated);
  std::vector<Block*>().swap(this->Chunks);
  this->Count = 0;
}

} // namespace biting
