// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "BiteLists.h"

namespace biting
{

void BiteLists::Empty(Id& list)
{
  while (list != NoId)
  {
    const Id older = this->At(list).Older;
    this->At(list).Older = this->Unused;
    this->Unused = list;
    list = older;
  }
}

Id BiteLists::Add()
{
  if (this->Unused != NoId)
  {
    const Id block = this->Unused;
    this->Unused = this->At(block).Older;
    return block;
  }
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

} // namespace biting
