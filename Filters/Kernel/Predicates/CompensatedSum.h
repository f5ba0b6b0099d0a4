// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingCompensatedSum_h
#define BitingCompensatedSum_h

#include "DoubleDouble.h"

namespace biting
{

/// A sum that does not lose what its terms are too small to move (A. Neumaier, 1974).
class CompensatedSum
{
public:
  void Add(double term)
  {
    const DoubleDouble next = TwoSum(this->Total, term);
    this->Total = next.High;
    this->Lost += next.Low;
  }

  /// A term that is at most what rounding lost of others.
  void AddLost(double term) { this->Lost += term; }

  void Join(const CompensatedSum& other, double sign = 1.0)
  {
    this->Add(sign * other.Total);
    this->Lost += sign * other.Lost;
  }

  double Value() const { return this->Total + this->Lost; }

private:
  double Total = 0.0;
  double Lost = 0.0;
};

} // namespace biting

#endif
