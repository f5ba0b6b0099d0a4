// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Histogram.h"

#include <algorithm> // for min, max
#include <cmath>     // for isnan
#include <cstdint>   // for counts

namespace biting
{

Histogram MakeHistogram(
  const std::vector<double>& values, double low, double high, int numberOfBins)
{
  const double width = (high - low) / numberOfBins;
  std::vector<std::int64_t> counts(static_cast<std::size_t>(numberOfBins), 0);
  std::int64_t total = 0;
  for (const double value : values)
  {
    if (!std::isnan(value))
    {
      const double bin = std::max(0.0, std::min((value - low) / width, numberOfBins - 1.0));
      ++counts[bin];
      ++total;
    }
  }
  const double share = total > 0 ? 100.0 / static_cast<double>(total) : 0.0;
  Histogram histogram;
  for (int bin = 0; bin < numberOfBins; ++bin)
  {
    histogram.Centers.push_back(low + (bin + 0.5) * width);
    histogram.Percents.push_back(share * static_cast<double>(counts[bin]));
  }
  return histogram;
}

} // namespace biting
