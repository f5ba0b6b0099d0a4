// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingStarObjective_h
#define BitingStarObjective_h

#include "../Base/Ids.h"
#include "../Base/Point.h"
#include "MutableMesh.h"
#include "Star.h"

namespace biting
{

// Beyond these, in spacings, an edge is out of the band.
constexpr double ShortestInBand = 0.74;
constexpr double LongestInBand = 1.36;

/// The objective around a vertex, as a function of its place: the larger one of the cotangent of
/// the smallest angle of its triangles, and min(cot 38 + 3 e, cot 32 = 1.6) with e > 0 the excess
/// max(0.74 - l, l - 1.36) of an edge of l spacings.
/// Angles between two segments at an input vertex, which nothing changes, do not count; nor do the
/// lengths of the edges of a vertex that cannot move.
class StarObjective
{
public:
  /// Which angles of a triangle are between segments.
  struct FixedAngles
  {
    bool IsAtCenter;
    bool IsAtFirst; ///< of the two outer corners
    bool IsAtSecond;

    bool HasAny() const { return this->IsAtCenter || this->IsAtFirst || this->IsAtSecond; }
  };

  StarObjective(const MutableMesh& mesh, Id vertex, const Star& star);

  /// Where the vertex is.
  double Here() const { return this->ValueHere; }

  /// Fits the slope of f, which At needs and Here does not.
  void FitSlope();

  /// The objective with the vertex moved by `shift` where that is below `limit`; else any value
  /// that is not below `limit`.
  double At(const Point2& shift, double limit) const;

private:
  void FindFixedAngles(const MutableMesh& mesh);
  void FindWorst();
  double WorstTriangle(const Point2& shift, double limit) const;
  double TriangleAt(int k, const Point2& shift) const;
  double WorstLength(const Point2& shift) const;

  const Star& Around;
  double Spacing;
  Point2 Slope; ///< of the spacing
  double Spacings[Star::Capacity + 1];
  double ValueHere = 0.0;
  int Worst = 0; ///< the triangle that is worst here: At computes it first, as it mostly decides
  bool HasLengths = true;
  bool HasFixedAngles = false;
  FixedAngles Fixed[Star::Capacity]; ///< of each triangle; set where there are any
};

/// The objective of the star of a vertex where it is; 0 where the star is too large.
double ObjectiveAround(const MutableMesh& mesh, Id vertex);

/// The cotangent of the triangle's smallest angle, without angles between two segments.
double WorstFreeCotangent(const MutableMesh& mesh, Id triangle);

/// Whether WorstFreeCotangent of the triangle is above `cotangent`.
bool IsWorseThan(const MutableMesh& mesh, Id triangle, double cotangent);

/// Whether the edge is shorter than 0.74 or longer than 1.36 spacings.
bool IsOutOfBand(const MutableMesh& mesh, Id edge);

} // namespace biting

#endif
