// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Smoothing.h"

#include "../Base/Numbers.h"
#include "SegmentParts.h"
#include "Star.h"

#include <algorithm> // for max
#include <cstddef>   // for slots
#include <cstdint>   // for marks
#include <vector>    // for marks

namespace biting
{

namespace
{

constexpr int MostAttempts = 3;
constexpr double Overrelaxation = 1.3;
constexpr double SizeWeight = 3.0; // more makes lengths better, and angles worse
// A vertex stays in a coarse sweep where all its edges are within these, in spacings, and all
// angles of its triangles above 52 degrees.
constexpr double ShortestFine = 0.9;
constexpr double LongestFine = 1.1;
constexpr double CrossOfEquilateral = 0.8660254037844386; // of two sides of length one

/// Gradient and Hessian of the energy at the center, and the worst cotangent.
struct EnergyExpansion
{
  Point2 Gradient;
  double XX = 0.0;
  double XY = 0.0;
  double YY = 0.0;
  double Worst = 0.0;

  /// A term of the energy with the given slope, and the second derivative `bend` along it.
  void Add(const Point2& slope, double first, double bend)
  {
    this->Gradient = this->Gradient + first * slope;
    this->XX += bend * slope.X * slope.X;
    this->XY += bend * slope.X * slope.Y;
    this->YY += bend * slope.Y * slope.Y;
  }
};

// With r = s / c, s = pp + qq - pq and c the cross product, up to the factor sqrt(3): both s and c
// are polynomials of the center, s of degree two and c of degree one.
void AddShape(const Point2& p, const Point2& q, double s, double inverse, EnergyExpansion& sum)
{
  const double r = s * inverse;
  const Point2 slopeOfCross = Perpendicular(q - p);
  const Point2 slope = inverse * (-1.0 * (p + q) - r * slopeOfCross);
  const double first = 4.0 * r * r * r;
  const double scaled = first * inverse;
  sum.Add(slope, first, 12.0 * r * r);
  sum.XX += scaled * (2.0 - 2.0 * slope.X * slopeOfCross.X);
  sum.YY += scaled * (2.0 - 2.0 * slope.Y * slopeOfCross.Y);
  sum.XY -= scaled * (slope.X * slopeOfCross.Y + slope.Y * slopeOfCross.X);
}

// The term a + 1/a, where a is c in units of `wanted`.
void AddSize(const Point2& p, const Point2& q, double inverse, double wanted, EnergyExpansion& sum)
{
  const double inverseSize = wanted * inverse;
  const double scale = SizeWeight / wanted;
  sum.Add(Perpendicular(q - p), scale * (1.0 - inverseSize * inverseSize),
    2.0 * scale * inverseSize * inverseSize * inverse);
}

EnergyExpansion ExpandEnergy(const MutableMesh& mesh, Id vertex, const Star& star)
{
  EnergyExpansion sum;
  Point2 p = star.Spokes[0];
  double pp = Dot(p, p);
  double spacing = mesh.Spacings[vertex] + mesh.Spacings[star.Vertices[0]];
  for (int k = 1; k <= star.NumberOfTriangles; ++k)
  {
    const Point2 q = star.Spokes[k];
    const double qq = Dot(q, q);
    const double nextSpacing = mesh.Spacings[star.Vertices[k]];
    const double product = Dot(p, q);
    const double inverse = 1.0 / Cross(p, q);
    const double mean = (spacing + nextSpacing) / 3.0;
    AddShape(p, q, pp + qq - product, inverse, sum);
    AddSize(p, q, inverse, CrossOfEquilateral * mean * mean, sum);
    sum.Worst = std::max(sum.Worst, std::max(product, std::max(pp, qq) - product) * inverse);
    p = q;
    pp = qq;
    spacing = mesh.Spacings[vertex] + nextSpacing;
  }
  return sum;
}

/// The way to where the quadratic has its least value, along the segment for a sliding vertex; zero
/// where it has none.
Point2 NewtonStep(const MutableMesh& mesh, Id vertex, const EnergyExpansion& sum)
{
  const Point2& g = sum.Gradient;
  if (mesh.Freedoms[vertex] == Freedom::Sliding)
  {
    const Id segment = mesh.Segments[vertex];
    const Point2 d = mesh.Geometry.Vertices[mesh.Geometry.Ends[segment]] -
      mesh.Geometry.Vertices[mesh.Geometry.Starts[segment]];
    const double bend = sum.XX * d.X * d.X + 2.0 * sum.XY * d.X * d.Y + sum.YY * d.Y * d.Y;
    return bend > 0.0 ? (-Dot(g, d) / bend) * d : Point2{};
  }
  const double determinant = sum.XX * sum.YY - sum.XY * sum.XY;
  if (!(determinant > 0.0 && sum.XX > 0.0))
  {
    return {};
  }
  return (1.0 / determinant) * Point2{ sum.XY * g.Y - sum.YY * g.X, sum.XY * g.X - sum.XX * g.Y };
}

bool IsFine(const MutableMesh& mesh, Id vertex, const Star& star)
{
  for (int k = 0; k <= star.NumberOfTriangles; ++k)
  {
    const double mean = 0.5 * (mesh.Spacings[vertex] + mesh.Spacings[star.Vertices[k]]);
    const double square = Dot(star.Spokes[k], star.Spokes[k]);
    if (!(square > ShortestFine * ShortestFine * mean * mean &&
          square < LongestFine * LongestFine * mean * mean))
    {
      return false;
    }
  }
  return star.Worst({}) < CotangentOf52Degrees;
}

/// Limits of the lengths of edges; by default there are none.
struct LengthsWithin
{
  double LeastSquare = 0.0;         ///< in squared spacings
  double GreatestSquare = Infinity; ///< in squared spacings

  /// Whether no edge of the star is farther beyond the limits after the step than before.
  bool Allow(const MutableMesh& mesh, Id vertex, const Star& star, const Point2& step) const
  {
    for (int k = 0; this->GreatestSquare < Infinity && k <= star.NumberOfTriangles; ++k)
    {
      const double mean = 0.5 * (mesh.Spacings[vertex] + mesh.Spacings[star.Vertices[k]]);
      const Point2 spoke = star.Spokes[k] - step;
      const double before = Dot(star.Spokes[k], star.Spokes[k]);
      const double after = Dot(spoke, spoke);
      if ((after > before && after > this->GreatestSquare * mean * mean) ||
        (after < before && after < this->LeastSquare * mean * mean))
      {
        return false;
      }
    }
    return true;
  }
};

bool SmoothStar(MutableMesh& mesh, Id vertex, const Star& star,
  double allowedCotangent = CotangentOf30Degrees, const LengthsWithin& lengths = {})
{
  const EnergyExpansion sum = ExpandEnergy(mesh, vertex, star);
  const double allowed = std::max(sum.Worst, allowedCotangent);
  Point2 step = Overrelaxation * NewtonStep(mesh, vertex, sum);
  if (mesh.Freedoms[vertex] == Freedom::Sliding)
  {
    step = ShareOfSlide(mesh, vertex, star, step) * step;
  }
  for (int attempt = 0; attempt < MostAttempts; ++attempt)
  {
    const Point2 place = mesh.PlaceFor(vertex, star.Center + step);
    const double worst = star.Worst(place - star.Center);
    if (worst <= allowed && lengths.Allow(mesh, vertex, star, place - star.Center) &&
      (worst < CertainCotangent || IsValidAt(mesh, vertex, star, place)))
    {
      MoveWithSpacing(mesh, vertex, star, place);
      return true;
    }
    step = 0.5 * step;
  }
  return false;
}

bool MayMove(const MutableMesh& mesh, Id vertex, Star& star)
{
  return mesh.Freedoms[vertex] != Freedom::Fixed && star.Read(mesh, vertex);
}

/// Whether the triangle is fine by more than rounding, so that it is from whichever corner.
bool IsSurelyFine(const MutableMesh& mesh, Id triangle)
{
  constexpr double Margin = 1e-9; // far above rounding
  bool isFine = true;
  for (Id edge = 4 * triangle; isFine && edge < 4 * triangle + 3; ++edge)
  {
    const double square = mesh.SquaredRelativeLength(edge);
    isFine = square > (1.0 + Margin) * ShortestFine * ShortestFine &&
      square < (1.0 - Margin) * LongestFine * LongestFine;
  }
  const Id* corners = mesh.Corners.data() + 4 * static_cast<std::size_t>(triangle);
  return isFine &&
    WorstCotangent(mesh.Points[corners[0]], mesh.Points[corners[1]], mesh.Points[corners[2]]) <
    (1.0 - Margin) * CotangentOf52Degrees;
}

/// 1 for the vertices of triangles that are not surely fine; the stars of all others are. One look
/// at a triangle costs less than three at stars.
std::vector<std::uint8_t> FindCoarse(const MutableMesh& mesh, Pulse& pulse)
{
  std::vector<std::uint8_t> mayBeCoarse(mesh.Points.size(), 0);
  pulse.ForEach(mesh.Regions.size(),
    [&mesh, &mayBeCoarse](std::size_t slot)
    {
      const Id triangle = static_cast<Id>(slot);
      if (mesh.IsEdge(4 * triangle) && !IsSurelyFine(mesh, triangle))
      {
        for (Id edge = 4 * triangle; edge < 4 * triangle + 3; ++edge)
        {
          mayBeCoarse[mesh.Corners[edge]] = 1;
        }
      }
    });
  return mayBeCoarse;
}

template <typename Smooth>
void Sweep(DelaunayMesh& mesh, const Smooth& smooth, Pulse& pulse)
{
  pulse.ForEach(mesh.Points.size(),
    [&mesh, &smooth](std::size_t slot)
    {
      const Id vertex = static_cast<Id>(slot);
      if (mesh.IsAlive(vertex))
      {
        smooth(vertex);
      }
    });
}

} // namespace

void SmoothVertex(DelaunayMesh& mesh, Id vertex)
{
  Star star;
  if (MayMove(mesh, vertex, star) && SmoothStar(mesh, vertex, star))
  {
    mesh.RestoreAround(vertex);
  }
}

void SmoothAll(DelaunayMesh& mesh, SweepKind kind, Pulse& pulse)
{
  std::vector<std::uint8_t> areChanged(mesh.Regions.size(), 0); // triangles with a moved corner
  const bool isCoarse = kind == SweepKind::Coarse;
  std::vector<std::uint8_t> mayBeCoarse =
    isCoarse ? FindCoarse(mesh, pulse) : std::vector<std::uint8_t>(mesh.Points.size(), 1);
  Sweep(
    mesh,
    [&mesh, &areChanged, &mayBeCoarse, isCoarse](Id vertex)
    {
      Star star;
      const bool isMoved = mayBeCoarse[vertex] != 0 && MayMove(mesh, vertex, star) &&
        !(isCoarse && IsFine(mesh, vertex, star)) && SmoothStar(mesh, vertex, star);
      for (int k = 0; isMoved && k < star.NumberOfTriangles; ++k)
      {
        areChanged[MutableMesh::TriangleOf(star.Edges[k])] = 1;
        mayBeCoarse[star.Vertices[k]] = 1;
        mayBeCoarse[star.Vertices[k + 1]] = 1;
      }
    },
    pulse);
  isCoarse ? mesh.RestoreBeside(areChanged, pulse) : mesh.RestoreAll(pulse);
}

void SmoothWithin(DelaunayMesh& mesh, const SmoothingLimits& limits, Pulse& pulse)
{
  const LengthsWithin lengths{ limits.ShortestEdge * limits.ShortestEdge,
    limits.LongestEdge * limits.LongestEdge };
  Sweep(
    mesh,
    [&mesh, &limits, &lengths](Id vertex)
    {
      Star star;
      if (MayMove(mesh, vertex, star))
      {
        SmoothStar(mesh, vertex, star, limits.GreatestCotangent, lengths);
      }
    },
    pulse);
  mesh.RestoreAll(pulse);
}

} // namespace biting
