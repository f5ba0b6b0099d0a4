// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingPaperSpacing_h
#define BitingPaperSpacing_h

#include <cmath> // for pow

/// The example of section 6 of the paper: a square and a spacing that depends on y only.
constexpr double PaperSide = 9.0;

inline double PaperSpacing(double y)
{
  if (y <= 2.0)
  {
    return 1.0 - 0.475 * y;
  }
  if (y <= 4.5)
  {
    return 0.05 * std::pow(20.0, (y - 2.0) / 2.5);
  }
  if (y <= 7.0)
  {
    return std::pow(0.2, (y - 4.5) / 2.5);
  }
  return 0.2 + 0.8 * std::pow((y - 7.0) / 2.0, 4);
}

/// Bilinear between this many intervals of y, the spacing is wrong by less than 1e-5 of itself.
constexpr int PaperIntervals = 3600;

#endif
