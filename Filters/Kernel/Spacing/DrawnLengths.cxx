// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "DrawnLengths.h"

#include <algorithm> // for lower_bound, min
#include <cstddef>   // for ptrdiff_t
#include <limits>    // for infinity

namespace biting
{

DrawnLengths::DrawnLengths(const FeatureSource& source, double gradation)
  : Source(source)
  , Gradation(gradation)
{
  this->Ends.reserve(source.PathLengths.size());
  this->Bounds.reserve(source.PathLengths.size());
  for (std::size_t segment = 0; segment + 1 < source.PathOffsets.size(); ++segment)
  {
    this->AddPath(static_cast<std::size_t>(source.PathOffsets[segment]),
      static_cast<std::size_t>(source.PathOffsets[segment + 1]));
  }
}

// The bound at the end of each segment is that of both beside it, then handed on in both
// directions.
void DrawnLengths::AddPath(std::size_t first, std::size_t last)
{
  const std::vector<double>& lengths = this->Source.PathLengths;
  double end = 0.0;
  double bound = std::numeric_limits<double>::infinity();
  for (std::size_t k = first; k < last; ++k)
  {
    const double next = k + 1 < last ? lengths[k + 1] : lengths[k];
    end += lengths[k];
    bound = std::min(bound + this->Gradation * lengths[k], std::min(lengths[k], next));
    this->Ends.push_back(end);
    this->Bounds.push_back(bound);
  }
  for (std::size_t k = last; k-- > first + 1;)
  {
    this->Bounds[k - 1] =
      std::min(this->Bounds[k - 1], this->Bounds[k] + this->Gradation * lengths[k]);
  }
}

double DrawnLengths::operator()(Id segment, double share) const
{
  const auto place = static_cast<std::size_t>(segment);
  if (place + 1 >= this->Source.PathOffsets.size())
  {
    return std::numeric_limits<double>::infinity();
  }
  const auto first = this->Ends.begin() + this->Source.PathOffsets[place];
  const auto last = this->Ends.begin() + this->Source.PathOffsets[place + 1] - 1;
  const double along = share * *last;
  const auto at =
    static_cast<std::size_t>(std::lower_bound(first, last, along) - this->Ends.begin());
  const double length = this->Source.PathLengths[at];
  const double toEnd = this->Ends[at] - along;
  const double toEnds = this->Bounds[at] + this->Gradation * toEnd;
  const bool isFirst = this->Ends.begin() + static_cast<std::ptrdiff_t>(at) == first;
  return std::min({ length, toEnds,
    isFirst ? length : this->Bounds[at - 1] + this->Gradation * (length - toEnd) });
}

} // namespace biting
