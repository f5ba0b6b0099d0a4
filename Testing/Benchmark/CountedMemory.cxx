// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "CountedMemory.h"

#include <malloc.h> // for the size of an allocation

#include <cstdlib> // for malloc
#include <new>     // for what is replaced

namespace
{

std::size_t Live = 0;
std::size_t Peak = 0;

} // namespace

void* operator new(std::size_t size)
{
  void* memory = std::malloc(size);
  if (memory == nullptr)
  {
    std::abort();
  }
  Live += malloc_usable_size(memory);
  Peak = Live > Peak ? Live : Peak;
  return memory;
}

// A sanitizer has its own otherwise, which does not go with the others here.
void* operator new(std::size_t size, const std::nothrow_t&) noexcept
{
  return operator new(size);
}

void operator delete(void* memory) noexcept
{
  Live -= malloc_usable_size(memory);
  std::free(memory);
}

void operator delete(void* memory, std::size_t) noexcept
{
  operator delete(memory);
}

std::size_t BeginPeak()
{
  Peak = Live;
  return Live;
}

std::size_t PeakBytes()
{
  return Peak;
}
