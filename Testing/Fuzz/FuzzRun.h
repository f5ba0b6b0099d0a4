// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingFuzzRun_h
#define BitingFuzzRun_h

#include "RandomInput.h"

namespace biting
{

/// What the kernel made of a case.
struct FuzzRun
{
  BitingMesh Mesh;
  ProblemList Problems;
  bool SaidStop = false;
  bool HasBadFraction = false;
};

FuzzRun Run(const FuzzCase& fuzzCase, int numberOfThreads = 1);

} // namespace biting

#endif
