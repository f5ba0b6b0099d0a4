// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingStar_h
#define BitingStar_h

#include "../Base/Ids.h"
#include "../Base/Point.h"
#include "MutableMesh.h"

#include <algorithm> // for max
#include <limits>    // for infinity

namespace biting
{

// Angles are compared by the cotangent of a triangle's smallest: the larger, the worse. It takes no
// root, and is infinite where the area is not positive.
constexpr double CotangentOf20Degrees = 2.747477;
constexpr double CotangentOf25Degrees = 2.144507;
constexpr double CotangentOf30Degrees = 1.732051;
constexpr double CotangentOf35Degrees = 1.428148;
constexpr double CotangentOf38Degrees = 1.279942;
constexpr double CotangentOf40Degrees = 1.191754;
constexpr double CotangentOf52Degrees = 0.781286;

/// Triangles as flat as this are told from inverted ones by exact predicates only. For all others
/// the filter of Orient2D answers: with spokes p, q as rounded, the largest of the three products
/// is at least (pp + qq) / 6 and the magnitude at most (pp + qq) / 2, so the determinant is at
/// least 3e-7 of the magnitude, and the filter asks for 3e-16.
constexpr double CertainCotangent = 1e6;

/// The cotangent of the smallest angle of the triangle (center, center + p, center + q).
inline double WorstCotangent(const Point2& p, const Point2& q, double pp, double qq)
{
  const double product = Dot(p, q);
  const double cross = Cross(p, q);
  const double largest = std::max(product, std::max(pp, qq) - product);
  return cross > 0.0 ? largest / cross : std::numeric_limits<double>::infinity();
}

inline double WorstCotangent(const Point2& a, const Point2& b, const Point2& c)
{
  const Point2 p = b - a;
  const Point2 q = c - a;
  return WorstCotangent(p, q, Dot(p, p), Dot(q, q));
}

/// The triangles around a vertex, with their outer corners counterclockwise as seen from the
/// vertex. A closed star repeats the first corner at the end.
struct Star
{
  static constexpr int Capacity = 40; ///< triangles; larger stars are left as they are

  Point2 Center;
  int NumberOfTriangles = 0;
  bool IsClosed = true;
  Id Edges[Capacity]; ///< of each triangle: the half-edge opposite the center
  Id Vertices[Capacity + 1];
  Point2 Spokes[Capacity + 1]; ///< from the center

  /// Reads the star of the vertex; false where it is too large.
  bool Read(const MutableMesh& mesh, Id vertex);

  /// The half-edge of a triangle along spoke k.
  Id SpokeEdge(int k) const
  {
    return k == this->NumberOfTriangles ? MutableMesh::Next(this->Edges[k - 1])
                                        : MutableMesh::Previous(this->Edges[k]);
  }

  /// The largest WorstCotangent of the triangles, with the center moved by `shift`.
  double Worst(const Point2& shift) const
  {
    double worst = 0.0;
    Point2 p = this->Spokes[0] - shift;
    double pp = Dot(p, p);
    for (int k = 1; k <= this->NumberOfTriangles; ++k)
    {
      const Point2 q = this->Spokes[k] - shift;
      const double qq = Dot(q, q);
      worst = std::max(worst, WorstCotangent(p, q, pp, qq));
      p = q;
      pp = qq;
    }
    return worst;
  }
};

inline bool Star::Read(const MutableMesh& mesh, Id vertex)
{
  if (mesh.Degrees[vertex] > Capacity)
  {
    return false;
  }
  this->Center = mesh.Points[vertex];
  const Id first = mesh.FirstAround(vertex);
  Id edge = first;
  Id last = NoId;
  int count = 0;
  do
  {
    const Id corner = mesh.Origin(edge);
    this->Edges[count] = edge;
    this->Vertices[count] = corner;
    this->Spokes[count] = mesh.Points[corner] - this->Center;
    ++count;
    last = edge;
    edge = mesh.Turn(edge);
  } while (edge != NoId && edge != first);
  this->IsClosed = edge == first;
  this->NumberOfTriangles = count;
  const Id corner = mesh.Target(last);
  this->Vertices[count] = corner;
  this->Spokes[count] = mesh.Points[corner] - this->Center;
  return true;
}

/// The largest WorstCotangent of the triangles around the vertex; infinite where the star is too
/// large to be read.
double WorstAround(const MutableMesh& mesh, Id vertex);

/// The slope of the linear function, equal to `spacing` at the center, that fits the spacings
/// `around` at the outer corners by least squares; zero where these are nearly on one line.
Point2 SlopeOfSpacing(const Star& star, double spacing, const double* around);

/// Moves the vertex of the star. Its spacing changes by the slope and stays within the range of the
/// spacings of the star. Where these differ by more than a factor of two f is evaluated instead.
void MoveWithSpacing(MutableMesh& mesh, Id vertex, const Star& star, const Point2& place);

/// Whether the vertex may lie at `place` (exact, and rounded as it will be), which on a segment is
/// between its neighbours there.
bool IsValidAt(const MutableMesh& mesh, Id vertex, const Star& star, const Point2& place);

} // namespace biting

#endif
