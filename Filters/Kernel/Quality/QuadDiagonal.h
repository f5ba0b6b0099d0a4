// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingQuadDiagonal_h
#define BitingQuadDiagonal_h

#include <array>   // for corners
#include <cstdint> // for the enum

namespace biting
{

/// The diagonal that divides a quad into two triangles.
enum class QuadDiagonal : std::uint8_t
{
  None,   ///< either makes triangles of opposite or no orientation: sides cross, or no area
  First,  ///< between the corners 0 and 2
  Second, ///< between the corners 1 and 3
};

/// Of the diagonals that make two triangles of one orientation, the one whose smallest angle is
/// larger; First where the angles differ by no more than rounding. Orientations are exact, seen
/// along the axis nearest to the normal of the quad.
QuadDiagonal FindQuadDiagonal(const std::array<std::array<double, 3>, 4>& corners);

/// The corners of both triangles, which turn as the quad does: numbers in the quad.
std::array<std::array<std::uint8_t, 3>, 2> TrianglesOfQuad(QuadDiagonal diagonal);

} // namespace biting

#endif
