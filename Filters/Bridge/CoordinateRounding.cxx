// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "CoordinateRounding.h"

#include "../Kernel/Domain/Polylines.h" // for NoiseInUlp

#include "vtkType.h" // for data types

#include <algorithm> // for all_of, find_if, max, min
#include <cmath>     // for abs, fmod, frexp, ilogb, ldexp
#include <limits>    // for epsilon
#include <numeric>   // for accumulate

namespace biting
{

namespace
{

constexpr std::size_t PointsPerFullFloat = 8;

bool IsFloat(double value)
{
  return std::abs(value) <= static_cast<double>(std::numeric_limits<float>::max()) &&
    static_cast<double>(static_cast<float>(value)) == value;
}

/// Whether a float needs all of its bits to be `value`, which is one.
bool IsFullFloat(double value)
{
  int exponent = 0;
  const double digits =
    std::ldexp(std::frexp(value, &exponent), std::numeric_limits<float>::digits);
  return std::fmod(digits, 2.0) != 0.0;
}

bool HoldFloats(const double* coordinates, const std::vector<Id>& points, Pulse& pulse)
{
  std::size_t full = 0;
  int leastOrder = std::numeric_limits<int>::max();
  int greatestOrder = std::numeric_limits<int>::min();
  for (const Id point : points)
  {
    const double* place = coordinates + 3 * static_cast<std::size_t>(point);
    if (!pulse.Beat(1) || !std::all_of(place, place + 3, IsFloat))
    {
      return false;
    }
    const double* found = std::find_if(place, place + 3, IsFullFloat);
    if (found != place + 3)
    {
      leastOrder = std::min(leastOrder, std::ilogb(*found));
      greatestOrder = std::max(greatestOrder, std::ilogb(*found));
      ++full;
    }
  }
  return leastOrder < greatestOrder && PointsPerFullFloat * full >= points.size();
}

double LargestMagnitude(const double* coordinates, const std::vector<Id>& points, Pulse& pulse)
{
  double largest = 0.0;
  pulse.ForEach(points.size(),
    [coordinates, &points, &largest](std::size_t k)
    {
      const double* place = coordinates + 3 * static_cast<std::size_t>(points[k]);
      largest = std::accumulate(place, place + 3, largest,
        [](double known, double value) { return std::max(known, std::abs(value)); });
    });
  return largest;
}

} // namespace

double RoundingOfCoordinates(
  int dataType, const double* coordinates, const std::vector<Id>& points, Pulse& pulse)
{
  const PulsePart part(pulse, 0.0, 0.0);
  const bool areFloats =
    dataType == VTK_FLOAT || (dataType == VTK_DOUBLE && HoldFloats(coordinates, points, pulse));
  const double unit = areFloats ? static_cast<double>(std::numeric_limits<float>::epsilon())
                                : std::numeric_limits<double>::epsilon();
  return NoiseInUlp * unit * LargestMagnitude(coordinates, points, pulse);
}

} // namespace biting
