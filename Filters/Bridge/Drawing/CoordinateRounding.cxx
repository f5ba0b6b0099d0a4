// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "CoordinateRounding.h"

#include "../../Kernel/Domain/Polylines.h" // for NoiseInUlp

#include "vtkType.h" // for data types

#include <algorithm> // for all_of, find_if, max, min
#include <cmath>     // for abs, floor, fmod, frexp, ilogb, ldexp
#include <limits>    // for epsilon

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

bool AreWhole(const double* coordinates, const std::vector<Id>& points, Pulse& pulse)
{
  const auto isWhole = [](double value) { return std::floor(value) == value; };
  return std::all_of(points.begin(), points.end(),
    [coordinates, &isWhole, &pulse](Id point)
    {
      const double* place = coordinates + 3 * static_cast<std::size_t>(point);
      return pulse.Beat(1) && std::all_of(place, place + 3, isWhole);
    });
}

bool CountAsFloats(
  int dataType, const double* coordinates, const std::vector<Id>& points, Pulse& pulse)
{
  return dataType == VTK_FLOAT ? !AreWhole(coordinates, points, pulse)
                               : dataType == VTK_DOUBLE && HoldFloats(coordinates, points, pulse);
}

/// What the coordinates along one axis are.
struct AxisRange
{
  double Least = std::numeric_limits<double>::infinity();
  double Most = -std::numeric_limits<double>::infinity();

  double Magnitude() const { return std::max(std::abs(this->Least), std::abs(this->Most)); }
  double Extent() const { return this->Most - this->Least; }
};

std::array<AxisRange, 3> RangesOf(
  const double* coordinates, const std::vector<Id>& points, Pulse& pulse)
{
  std::array<AxisRange, 3> ranges;
  pulse.ForEach(points.size(),
    [coordinates, &points, &ranges](std::size_t k)
    {
      const double* place = coordinates + 3 * static_cast<std::size_t>(points[k]);
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        ranges[axis].Least = std::min(ranges[axis].Least, place[axis]);
        ranges[axis].Most = std::max(ranges[axis].Most, place[axis]);
      }
    });
  return ranges;
}

} // namespace

CoordinateRounding RoundingOfCoordinates(
  int dataType, const double* coordinates, const std::vector<Id>& points, Pulse& pulse)
{
  const PulsePart part(pulse, 0.0, 0.0);
  CoordinateRounding rounding;
  if (points.empty())
  {
    return rounding;
  }
  const bool areFloats = CountAsFloats(dataType, coordinates, points, pulse);
  const double unit = areFloats ? static_cast<double>(std::numeric_limits<float>::epsilon())
                                : std::numeric_limits<double>::epsilon();
  const std::array<AxisRange, 3> ranges = RangesOf(coordinates, points, pulse);
  double largest = 0.0;
  double extent = 0.0;
  for (const AxisRange& range : ranges)
  {
    largest = std::max(largest, range.Magnitude());
    extent = std::max(extent, range.Extent());
  }
  rounding.Most = NoiseInUlp * unit * largest;
  for (std::size_t axis = 0; axis < 3 && !pulse.HasStopped(); ++axis)
  {
    const double own = std::max(ranges[axis].Magnitude(), extent) + (NoiseInUlp - 1.0) * extent;
    rounding.Axes[axis] = areFloats ? std::min(rounding.Most, unit * own) : rounding.Most;
  }
  return rounding;
}

} // namespace biting
