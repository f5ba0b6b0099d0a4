// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingRegionNumbers_h
#define BitingRegionNumbers_h

#include "../../Kernel/Base/Ids.h"
#include "../../Kernel/Base/Pulse.h"
#include "Drawing.h"

#include <string> // for the refusal
#include <vector> // for numbers

namespace biting
{

/// For each cell of the drawing a number, equal where all components of the cell array `name` are
/// equal: whole numbers to the last digit, NaN to NaN, 0 to -0, texts. Empty where `name` is empty
/// or "None". Returns why there are none: the drawing has no such array, or one that is too short.
std::string FindRegionNumbers(
  const Drawing& drawing, const std::string& name, std::vector<Id>& numbers, Pulse& pulse);

} // namespace biting

#endif
