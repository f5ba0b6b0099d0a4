// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingHistogram_h
#define BitingHistogram_h

#include <vector> // for the arrays

namespace biting
{

/// How often values occur, in bins of equal width.
struct Histogram
{
  std::vector<double> Centers;  ///< middle of each bin, in the unit of the values
  std::vector<double> Percents; ///< of the values that are numbers; they add up to 100
};

/// Counts `values` in `numberOfBins` bins (at least 1) of [low, high]. A bin holds its lower end;
/// the last one its upper end, too, and what is above; the first one what is below. NaN is not
/// counted. Where nothing is counted, all bins have 0.
Histogram MakeHistogram(
  const std::vector<double>& values, double low, double high, int numberOfBins);

} // namespace biting

#endif
