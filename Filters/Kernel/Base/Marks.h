// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingMarks_h
#define BitingMarks_h

#include <atomic>  // for what threads share
#include <cstddef> // for counts
#include <cstdint> // for marks
#include <vector>  // for the array

namespace biting
{

/// A small number for each of so many things, 0 at first. Several threads may set the same one at
/// once, to the same value.
class Marks
{
public:
  explicit Marks(std::size_t count)
    : Values(count)
  {
  }

  std::size_t Size() const { return this->Values.size(); }
  void Set(std::size_t k, std::uint8_t value)
  {
    this->Values[k].store(value, std::memory_order_relaxed);
  }
  std::uint8_t operator[](std::size_t k) const
  {
    return this->Values[k].load(std::memory_order_relaxed);
  }

private:
  std::vector<std::atomic<std::uint8_t>> Values;
};

} // namespace biting

#endif
