// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingLookedAt_h
#define BitingLookedAt_h

#include <algorithm> // for find
#include <array>     // for what is known
#include <cstddef>   // for counts

namespace biting
{

/// The last few of the numbers that were looked at.
template <typename Number>
class LookedAt
{
public:
  /// Whether it is not one of them.
  bool Add(Number number)
  {
    const auto end = this->Known.begin() + static_cast<std::ptrdiff_t>(std::min(this->Count, Most));
    if (std::find(this->Known.begin(), end, number) != end)
    {
      return false;
    }
    this->Known[this->Count++ % Most] = number;
    return true;
  }

private:
  static constexpr std::size_t Most = 16;
  std::array<Number, Most> Known;
  std::size_t Count = 0;
};

} // namespace biting

#endif
