// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingKeepRules_h
#define BitingKeepRules_h

namespace biting
{

/// What counts more where keeping vertices and good shapes exclude each other.
enum class RemeshPreference
{
  Keeping, ///< all vertices that can stay do
  Balanced,
  Shape ///< vertices go where others could be placed better
};

/// How the boundary, the interfaces and the tagged edges may change.
enum class EdgePolicy
{
  Free,      ///< vertices on straight parts may go and come
  SplitOnly, ///< none goes
  Frozen     ///< none goes, none comes
};

/// When a vertex of an old mesh is kept. Lengths are mean lengths of the edges at a vertex, or
/// single edges, in units of f.
///
/// Within the band from LowestUnchanged to HighestUnchanged the mesh is as it is wanted: meshes of
/// the mesher, relaxed, are, and a change of f by a tenth leaves vertices within. What is beyond is
/// made anew, with what is around it; there a vertex fits that is within Lowest to Highest. Below
/// Crowded, at most Lowest, the vertices of a coarser lattice are among the old ones, and above
/// Sparse there is room for new ones between them; but in between neither is so: old vertices there
/// are in the way of others. Nor is it so where f changes from one old vertex to the next: the old
/// lattice has none of the right size within, and what it leaves breaks each lattice that has. But
/// where all edges of a vertex have good halves the new lattice is the old one, divided in two
/// (DividedEdges.h), whatever f does: it then changes as the old lengths do.
struct KeepRules
{
  static constexpr double LowestUnchanged = 0.75;
  static constexpr double HighestUnchanged = 1.3;

  // Single edges are as they are wanted from 1 / sqrt(2) to sqrt(2): squared.
  static constexpr double LeastSquare = 0.5;
  static constexpr double GreatestSquare = 2.0;

  /// Acceptance radius in units of f, measured: with it a mesh that fits is kept whole.
  static constexpr double RadiusOfFitting = 0.7;

  double Crowded = LowestUnchanged;
  double Lowest = LowestUnchanged;
  double Highest = 1.4;
  double Sparse = 1.6;

  // Among a vertex and those that edges join it to, the largest f in units of the least: where it
  // is beyond these, none of a mesh that is too fine is kept, and none of one that is too coarse.
  // Beside a part where f is half of the old, and level, it grows to 1.6 with a gradation of 0.3.
  double GreatestChangeBelow = 1.15;
  double GreatestChangeAbove = 1.7;

  // Where more than this share of the neighbors of a vertex goes it does, too: the others are the
  // rest of a lattice that ends here. From 1 on: never.
  double GreatestShareInTheWay = 0.5;

  // How far from the end of an equal part of a straight edge a vertex may be that stays there, in
  // parts, and how much farther than the one before: so edges between two of them are 0.7 to 1.3
  // parts long. Where old edges are half as long as f none is farther away than a quarter.
  double GreatestShift = 0.26;
  double GreatestChangeOfShift = 0.3;

  // Kept vertices are released, they may move and go, beside an angle whose cotangent is larger, or
  // an edge beyond these.
  double GreatestCotangent = 1.3763819; // 36 degrees
  double ShortestEdge = 0.70710678;
  double LongestEdge = 1.41421356;

  // A vertex goes to the place of an old one near it where no angle of its triangles then has a
  // larger cotangent. Farther than half the radius of fitting another one may be as near to it.
  double GreatestCotangentAtPlaces = 1.0913085; // 42.5 degrees, as 99 % of a good mesh have
  static constexpr double ReachOfPlaces = 0.5 * RadiusOfFitting;

  static bool IsUnchanged(double length)
  {
    return length >= LowestUnchanged && length <= HighestUnchanged;
  }
  bool IsFitting(double length) const { return length >= this->Lowest && length <= this->Highest; }
  /// Of half an edge, squared, in squared spacings.
  static bool IsGoodHalf(double square)
  {
    return square >= LeastSquare && square <= GreatestSquare;
  }
  /// `change`: the largest f around in units of the least; `mayBeDivided`: all edges have good
  /// halves.
  bool IsInTheWay(double length, double change, bool mayBeDivided) const
  {
    if (this->IsFitting(length))
    {
      return false;
    }
    const bool isBetween = length > this->Crowded && length < this->Sparse;
    const bool changes = length < this->Lowest
      ? change > this->GreatestChangeBelow
      : change > this->GreatestChangeAbove && !mayBeDivided;
    return isBetween || changes;
  }
};

inline KeepRules RulesFor(RemeshPreference preference)
{
  switch (preference)
  {
    case RemeshPreference::Keeping:
      return { 0.82, 0.82, 1.22, 1.22, 1e6, 1e6, 2.0, 1e6, 1e6, 1.8807265, 0.0, 1e6, 1.4281480 };
    case RemeshPreference::Shape:
      return { 0.5, 0.82, 1.22, 1.9, 1.15, 1.7, 0.5, 0.26, 0.3, 1.4281480, 0.70710678, 1.41421356,
        0.0 };
    default:
      return {};
  }
}

} // namespace biting

#endif
