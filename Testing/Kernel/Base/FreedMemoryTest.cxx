// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Base/FreedMemory.h"

#include <gtest/gtest.h>

#include <cstddef> // for sizes
#include <cstdlib> // for exit
#include <memory>  // for memory

#include <sys/resource.h> // for page faults

// There, if the address sanitizer watches the kernel.
extern "C" __attribute__((weak)) void __asan_init();

namespace biting
{

namespace
{

constexpr std::size_t Size = 4u << 20;
constexpr std::size_t PageSize = 4096;

bool IsOfGlibc()
{
#if defined(__GLIBC__)
  return __asan_init == nullptr;
#else
  return false;
#endif
}

// Takes memory, touches each page of it, and frees it.
void TakeAndFree()
{
  const std::unique_ptr<char[]> memory(new char[Size]);
  volatile char* place = memory.get();
  for (std::size_t k = 0; k < Size; k += PageSize)
  {
    place[k] = 1;
  }
}

// Page faults of doing that once more.
long FaultsOfSecond()
{
  const auto countFaults = []
  {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_minflt;
  };
  TakeAndFree();
  const long before = countFaults();
  TakeAndFree();
  return countFaults() - before;
}

constexpr long Few = static_cast<long>(Size / PageSize) / 10;
constexpr int TookFew = 0;
constexpr int TookMany = 1;

void ExitWithFaults()
{
  std::exit(FaultsOfSecond() < Few ? TookFew : TookMany);
}

} // namespace

// In processes of their own, as what others freed before has a part in it.
TEST(KeepFreedMemory, TakesNoPagesFromTheSystemForWhatWasFreed)
{
  if (!IsOfGlibc())
  {
    GTEST_SKIP() << "another allocator";
  }
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(ExitWithFaults(), testing::ExitedWithCode(TookMany), "");
  EXPECT_EXIT(
    {
      KeepFreedMemory();
      ExitWithFaults();
    },
    testing::ExitedWithCode(TookFew), "");
}

} // namespace biting
