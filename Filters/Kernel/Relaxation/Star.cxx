// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Star.h"

#include "../Base/Numbers.h"
#include "../Predicates/Predicates.h"

#include <algorithm> // for clamp, max, min

namespace biting
{

namespace
{

constexpr double SlimmestFit = 1e-3;     // of a square matrix that is not near a singular one
constexpr double GreatestEstimate = 2.0; // ratio of the spacings from which one more is estimated

// A vertex that slides stays between its neighbours on the segment, also where rounding hides that
// the triangles beside it have turned over: where these are as thin as rounding.
bool StaysBetween(const MutableMesh& mesh, const Star& star, const Point2& place)
{
  const Point2 step = place - star.Center;
  for (int k = 0; k <= star.NumberOfTriangles; ++k)
  {
    const Point2& spoke = star.Spokes[k];
    if (mesh.Marks[star.SpokeEdge(k)] != NoId && !(Dot(spoke - step, spoke) > 0.0))
    {
      return false;
    }
  }
  return true;
}

} // namespace

double WorstAround(const MutableMesh& mesh, Id vertex)
{
  Star star;
  return star.Read(mesh, vertex) ? star.Worst({}) : Infinity;
}

Point2 SlopeOfSpacing(const Star& star, double spacing, const double* around)
{
  double xx = 0.0;
  double xy = 0.0;
  double yy = 0.0;
  Point2 moment;
  for (int k = 0; k < star.NumberOfTriangles; ++k)
  {
    const Point2& p = star.Spokes[k];
    xx += p.X * p.X;
    xy += p.X * p.Y;
    yy += p.Y * p.Y;
    moment = moment + (around[k] - spacing) * p;
  }
  const double determinant = xx * yy - xy * xy;
  return determinant > SlimmestFit * xx * yy
    ? (1.0 / determinant) * Point2{ yy * moment.X - xy * moment.Y, xx * moment.Y - xy * moment.X }
    : Point2{};
}

void MoveWithSpacing(MutableMesh& mesh, Id vertex, const Star& star, const Point2& place)
{
  if (mesh.F.IsUniform())
  {
    mesh.Move(vertex, place);
    return;
  }
  const double spacing = mesh.Spacings[vertex];
  double around[Star::Capacity + 1];
  double least = spacing;
  double most = spacing;
  for (int k = 0; k <= star.NumberOfTriangles; ++k)
  {
    around[k] = mesh.Spacings[star.Vertices[k]];
    least = std::min(least, around[k]);
    most = std::max(most, around[k]);
  }
  const Point2 slope = SlopeOfSpacing(star, spacing, around);
  const double moved = spacing + Dot(slope, place - star.Center);
  mesh.MoveWithEstimate(vertex, place, std::clamp(moved, least, most));
  if (most > GreatestEstimate * least)
  {
    mesh.RefreshSpacing(vertex);
  }
}

bool IsValidAt(const MutableMesh& mesh, Id vertex, const Star& star, const Point2& place)
{
  if (mesh.Freedoms[vertex] == Freedom::Sliding && !StaysBetween(mesh, star, place))
  {
    return false;
  }
  for (int k = 0; k < star.NumberOfTriangles; ++k)
  {
    if (Orient2D(place, mesh.Points[star.Vertices[k]], mesh.Points[star.Vertices[k + 1]]) <= 0)
    {
      return false;
    }
  }
  return true;
}

} // namespace biting
