// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "StarObjective.h"

#include <algorithm> // for max, min
#include <limits>    // for infinity

namespace biting
{

namespace
{

constexpr double CotangentPerLength = 3.0; // what a spacing out of the band counts
constexpr double GreatestPenalty = 1.6;    // cotangent of 32 degrees

/// As WorstCotangent, without the angles that are fixed.
double WorstOfOthers(const Point2& p, const Point2& q, const StarObjective::FixedAngles& fixed)
{
  const double product = Dot(p, q);
  const double cross = Cross(p, q);
  double largest = fixed.IsAtCenter ? 0.0 : product;
  largest = fixed.IsAtFirst ? largest : std::max(largest, Dot(p, p) - product);
  largest = fixed.IsAtSecond ? largest : std::max(largest, Dot(q, q) - product);
  return cross > 0.0 ? largest / cross : std::numeric_limits<double>::infinity();
}

} // namespace

StarObjective::StarObjective(const MutableMesh& mesh, Id vertex, const Star& star)
  : Around(star)
  , Spacing(mesh.Spacings[vertex])
{
  for (int k = 0; k <= star.NumberOfTriangles; ++k)
  {
    this->Spacings[k] = mesh.Spacings[star.Vertices[k]];
  }
  this->HasLengths = mesh.Freedoms[vertex] != Freedom::Fixed;
  if (mesh.Freedoms[vertex] != Freedom::Free)
  {
    this->FindFixedAngles(mesh);
  }
  this->FindWorst();
}

void StarObjective::FindWorst()
{
  double worst = -1.0;
  for (int k = 0; k < this->Around.NumberOfTriangles; ++k)
  {
    const double value = this->TriangleAt(k, {});
    this->Worst = value > worst ? k : this->Worst;
    worst = std::max(worst, value);
  }
  this->ValueHere = this->HasLengths ? std::max(worst, this->WorstLength({})) : worst;
}

double StarObjective::TriangleAt(int k, const Point2& shift) const
{
  const Point2 p = this->Around.Spokes[k] - shift;
  const Point2 q = this->Around.Spokes[k + 1] - shift;
  return this->HasFixedAngles && this->Fixed[k].HasAny()
    ? WorstOfOthers(p, q, this->Fixed[k])
    : WorstCotangent(p, q, Dot(p, p), Dot(q, q));
}

// Moves are short, and this saves an evaluation for each place that is tried.
void StarObjective::FitSlope()
{
  this->Slope = SlopeOfSpacing(this->Around, this->Spacing, this->Spacings);
}

void StarObjective::FindFixedAngles(const MutableMesh& mesh)
{
  for (int k = 0; k < this->Around.NumberOfTriangles; ++k)
  {
    const Id edge = this->Around.Edges[k];
    const bool isFirstMarked = mesh.Marks[MutableMesh::Previous(edge)] != NoId;
    const bool isSecondMarked = mesh.Marks[MutableMesh::Next(edge)] != NoId;
    const bool isOuterMarked = mesh.Marks[edge] != NoId;
    this->Fixed[k] = { isFirstMarked && isSecondMarked, isOuterMarked && isFirstMarked,
      isOuterMarked && isSecondMarked };
    this->HasFixedAngles |= this->Fixed[k].HasAny();
  }
}

double StarObjective::At(const Point2& shift, double limit) const
{
  const double worst = this->WorstTriangle(shift, limit);
  const bool isDone = worst >= limit || !this->HasLengths;
  return isDone ? worst : std::max(worst, this->WorstLength(shift));
}

double StarObjective::WorstTriangle(const Point2& shift, double limit) const
{
  double worst = this->TriangleAt(this->Worst, shift);
  for (int k = 0; k < this->Around.NumberOfTriangles && worst < limit; ++k)
  {
    worst = std::max(worst, this->TriangleAt(k, shift));
  }
  return worst;
}

// Roots are taken only of lengths that are out of the band.
double StarObjective::WorstLength(const Point2& shift) const
{
  const double spacing = this->Spacing + Dot(this->Slope, shift);
  const int last = this->Around.NumberOfTriangles - (this->Around.IsClosed ? 1 : 0);
  double excess = 0.0;
  for (int k = 0; k <= last; ++k)
  {
    const Point2 p = this->Around.Spokes[k] - shift;
    const double mean = 0.5 * (spacing + this->Spacings[k]);
    const double square = Dot(p, p);
    if (square > LongestInBand * LongestInBand * mean * mean ||
      square < ShortestInBand * ShortestInBand * mean * mean)
    {
      const double length = std::sqrt(square) / mean;
      excess = std::max(excess, std::max(ShortestInBand - length, length - LongestInBand));
    }
  }
  return excess > 0.0
    ? std::min(CotangentOf38Degrees + CotangentPerLength * excess, GreatestPenalty)
    : 0.0;
}

double ObjectiveAround(const MutableMesh& mesh, Id vertex)
{
  Star star;
  return star.Read(mesh, vertex) ? StarObjective(mesh, vertex, star).Here() : 0.0;
}

double WorstFreeCotangent(const MutableMesh& mesh, Id triangle)
{
  const Id first = 4 * triangle;
  const Point2& center = mesh.Points[mesh.Corners[first]];
  const bool isMarked[] = { mesh.Marks[first] != NoId, mesh.Marks[first + 1] != NoId,
    mesh.Marks[first + 2] != NoId };
  return WorstOfOthers(mesh.Points[mesh.Corners[first + 1]] - center,
    mesh.Points[mesh.Corners[first + 2]] - center,
    { isMarked[1] && isMarked[2], isMarked[2] && isMarked[0], isMarked[0] && isMarked[1] });
}

bool IsWorseThan(const MutableMesh& mesh, Id triangle, double cotangent)
{
  const Id first = 4 * triangle;
  const Point2& a = mesh.Points[mesh.Corners[first]];
  const Point2& b = mesh.Points[mesh.Corners[first + 1]];
  const Point2& c = mesh.Points[mesh.Corners[first + 2]];
  return WorstCotangent(a, b, c) > cotangent && WorstFreeCotangent(mesh, triangle) > cotangent;
}

bool IsOutOfBand(const MutableMesh& mesh, Id edge)
{
  const double square = mesh.SquaredRelativeLength(edge);
  return !(square >= ShortestInBand * ShortestInBand && square <= LongestInBand * LongestInBand);
}

} // namespace biting
