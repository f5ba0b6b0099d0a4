// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingValueRange_h
#define BitingValueRange_h

#include <algorithm> // for min, max

namespace biting
{

/// How values as given become spacing: scaled, then clamped.
struct ValueRange
{
  double Scale = 1.0;
  double Least = 0.0;
  double Most = 0.0;

  double operator()(double value) const
  {
    return std::min(std::max(this->Scale * value, this->Least), this->Most);
  }
};

} // namespace biting

#endif
