// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SegmentParts.h"

#include <algorithm> // for swap, max, min

namespace biting
{

namespace
{

constexpr double LongestPart = 1.4142135623730951;

// Within 1/sqrt(2) and sqrt(2): a margin for the spacing, which changes along the slide.
constexpr double ShortAfterSlide = 0.73;
constexpr double LongAfterSlide = 1.37;

/// The other end of the other part at a vertex that slides; NoId where there is none.
Id FarEnd(const MutableMesh& mesh, Id vertex, Id nearEnd)
{
  Id far = NoId;
  mesh.HoldsAround(vertex,
    [&mesh, nearEnd, &far](Id edge)
    {
      const Id origin = mesh.Origin(edge);
      const Id target = mesh.Target(edge);
      if (origin != nearEnd && mesh.Marks[MutableMesh::Previous(edge)] != NoId)
      {
        far = origin;
      }
      else if (target != nearEnd && mesh.Marks[MutableMesh::Next(edge)] != NoId)
      {
        far = target;
      }
      return far == NoId;
    });
  return far;
}

bool IsLong(const MutableMesh& mesh, const Point2& place, double spacing, Id end)
{
  return end != NoId &&
    Distance(place, mesh.Points[end]) > 0.5 * LongestPart * (spacing + mesh.Spacings[end]);
}

/// Of the part along `spoke` of a vertex that moves by `step`.
double ShareOfStep(const Point2& step, const Point2& spoke, double spacing)
{
  const double length = Length(spoke);
  const double change = Dot(step, spoke) / length;
  const double room = length - (change > 0.0 ? ShortAfterSlide : LongAfterSlide) * spacing;
  const bool isWithin = change == 0.0 || (change > 0.0 ? change <= room : change >= room);
  return isWithin ? 1.0 : std::max(0.0, room / change);
}

} // namespace

bool IsTooLongPart(const MutableMesh& mesh, Id edge)
{
  return mesh.Marks[edge] != NoId && mesh.RelativeLength(edge) > LongestPart;
}

bool LeavesLongPart(const MutableMesh& mesh, Id edge)
{
  Id kept = mesh.Origin(edge);
  Id gone = mesh.Target(edge);
  if (mesh.Freedoms[gone] < mesh.Freedoms[kept])
  {
    std::swap(kept, gone);
  }
  if (mesh.Marks[edge] == NoId || mesh.Freedoms[gone] != Freedom::Sliding)
  {
    return false;
  }
  const Id beyond = FarEnd(mesh, gone, kept);
  if (mesh.Freedoms[kept] == Freedom::Fixed)
  {
    return IsLong(mesh, mesh.Points[kept], mesh.Spacings[kept], beyond);
  }
  const Point2 middle = Midpoint(mesh.Points[kept], mesh.Points[gone]);
  const double spacing = 0.5 * (mesh.Spacings[kept] + mesh.Spacings[gone]);
  return IsLong(mesh, middle, spacing, beyond) ||
    IsLong(mesh, middle, spacing, FarEnd(mesh, kept, gone));
}

// A half is h / m long, with the mean m of the spacings at its ends: 1 / (h / m) is below the whole
// l where m < h l.
bool LeavesShortParts(const MutableMesh& mesh, Id edge)
{
  const Id origin = mesh.Origin(edge);
  const Id target = mesh.Target(edge);
  if (mesh.Marks[edge] == NoId)
  {
    return false;
  }
  if (mesh.Freedoms[origin] != Freedom::Fixed || mesh.Freedoms[target] != Freedom::Fixed)
  {
    return mesh.RelativeLength(edge) < 1.0;
  }
  if (!mesh.MayDivide(edge))
  {
    return true;
  }
  const Point2& a = mesh.Points[origin];
  const Point2& b = mesh.Points[target];
  const double most = std::max(mesh.Spacings[origin], mesh.Spacings[target]);
  const double length = Distance(a, b) * mesh.RelativeLength(edge);
  return length < most || length < mesh.F(Midpoint(a, b)) + most;
}

double ShareOfSlide(const MutableMesh& mesh, Id vertex, const Star& star, const Point2& step)
{
  double share = 1.0;
  for (int k = 0; k <= star.NumberOfTriangles; ++k)
  {
    if (mesh.Marks[star.SpokeEdge(k)] != NoId)
    {
      const double mean = 0.5 * (mesh.Spacings[vertex] + mesh.Spacings[star.Vertices[k]]);
      share = std::min(share, ShareOfStep(step, star.Spokes[k], mean));
    }
  }
  return share;
}

} // namespace biting
