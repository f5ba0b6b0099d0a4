// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingRepetition_h
#define BitingRepetition_h

#include "FuzzRun.h"

#include <string> // for the violation

namespace biting
{

/// Runs the case again, on several threads, and once more magnified. What is wrong, or empty.
std::string JudgeRepetition(const FuzzRun& run, const FuzzCase& fuzzCase);

} // namespace biting

#endif
