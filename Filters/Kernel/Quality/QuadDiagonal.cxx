// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "QuadDiagonal.h"

#include "../Predicates/Predicates.h"

#include <algorithm> // for max
#include <cmath>     // for abs, sqrt
#include <cstddef>   // for axes
#include <limits>    // for rounding

namespace biting
{

namespace
{

using Place = std::array<double, 3>;
using Quad = std::array<Place, 4>;

// A cosine of differences that are exact is off by the rounding of three products, a sum of three,
// two roots and a quotient: less than 8 units in the last place of 1.
constexpr double RoundingOfCosine = 8.0 * std::numeric_limits<double>::epsilon();

Place Difference(const Place& a, const Place& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

double Dot(const Place& a, const Place& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// The axis along which the quad, as the product of its diagonals, is largest.
std::size_t LargestAxis(const Quad& quad)
{
  const Place a = Difference(quad[2], quad[0]);
  const Place b = Difference(quad[3], quad[1]);
  std::size_t largest = 2;
  double size = std::abs(a[0] * b[1] - a[1] * b[0]);
  for (std::size_t axis = 0; axis < 2; ++axis)
  {
    const std::size_t next = axis + 1;
    const std::size_t last = (axis + 2) % 3;
    const double own = std::abs(a[next] * b[last] - a[last] * b[next]);
    largest = own > size ? axis : largest;
    size = std::max(own, size);
  }
  return largest;
}

bool TurnAlike(const Quad& quad, QuadDiagonal diagonal, std::size_t axis)
{
  std::array<int, 2> turns{};
  for (std::size_t k = 0; k < 2; ++k)
  {
    const auto corners = TrianglesOfQuad(diagonal)[k];
    const auto seen = [&quad, axis](std::size_t corner) {
      return Point2{ quad[corner][(axis + 1) % 3], quad[corner][(axis + 2) % 3] };
    };
    turns[k] = Orient2D(seen(corners[0]), seen(corners[1]), seen(corners[2]));
  }
  return turns[0] != 0 && turns[0] == turns[1];
}

// The cosine of the smallest angle of both triangles.
double LargestCosine(const Quad& quad, QuadDiagonal diagonal)
{
  double largest = -1.0;
  for (const auto& corners : TrianglesOfQuad(diagonal))
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Place& apex = quad[corners[k]];
      const Place a = Difference(quad[corners[(k + 1) % 3]], apex);
      const Place b = Difference(quad[corners[(k + 2) % 3]], apex);
      largest = std::max(largest, Dot(a, b) / (std::sqrt(Dot(a, a)) * std::sqrt(Dot(b, b))));
    }
  }
  return largest;
}

} // namespace

QuadDiagonal FindQuadDiagonal(const Quad& corners)
{
  const std::size_t axis = LargestAxis(corners);
  const bool mayBeFirst = TurnAlike(corners, QuadDiagonal::First, axis);
  const bool mayBeSecond = TurnAlike(corners, QuadDiagonal::Second, axis);
  if (!mayBeFirst || !mayBeSecond)
  {
    return mayBeFirst ? QuadDiagonal::First
      : mayBeSecond   ? QuadDiagonal::Second
                      : QuadDiagonal::None;
  }
  const bool isSecondBetter = LargestCosine(corners, QuadDiagonal::Second) + RoundingOfCosine <
    LargestCosine(corners, QuadDiagonal::First);
  return isSecondBetter ? QuadDiagonal::Second : QuadDiagonal::First;
}

std::array<std::array<std::uint8_t, 3>, 2> TrianglesOfQuad(QuadDiagonal diagonal)
{
  if (diagonal == QuadDiagonal::Second)
  {
    return { { { 0, 1, 3 }, { 1, 2, 3 } } };
  }
  return { { { 0, 1, 2 }, { 0, 2, 3 } } };
}

} // namespace biting
