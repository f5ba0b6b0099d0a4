// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

// The oracle under libFuzzer, which makes bytes up and keeps those that reach new branches:
//
//   cmake -D CMAKE_CXX_COMPILER=clang++ -D BITING_SDK=Kernel -D BITING_BUILD_GUIDED_FUZZ=ON ...
//   BitingGuidedFuzz -max_len=600 -timeout=10 corpus
//
// A file of bytes that it leaves behind repeats the case: BitingGuidedFuzz crash-...
// It needs clang and its runtime library (libclang-rt-14-dev). BitingFuzz.cxx runs without.

#include "Oracle.h"

#include <cstdlib>  // for abort
#include <iostream> // for the violation

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
  biting::FuzzNumbers numbers(bytes, size);
  const biting::FuzzCase fuzzCase = biting::MakeFuzzCase(numbers);
  const biting::FuzzOutcome outcome = biting::RunFuzzCase(fuzzCase);
  if (outcome.Kind == biting::Verdict::Violation)
  {
    std::cerr << outcome.Violation << "\n" << biting::Describe(fuzzCase) << "\n";
    biting::WriteLegacyVtk(std::cerr, fuzzCase.Input, "violation");
    std::abort();
  }
  return 0;
}
