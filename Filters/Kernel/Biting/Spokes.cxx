// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Spokes.h"

#include "../Predicates/Predicates.h"

#include <algorithm> // for sort

namespace biting
{

namespace
{

constexpr double CosineOf60 = 0.5;

} // namespace

SpokesOfVertices::SpokesOfVertices(const Domain& domain)
  : Geometry(domain)
  , Segments(domain.Vertices.size(),
      [&domain](const auto& add)
      {
        for (Id segment = 0; segment < domain.NumberOfSegments(); ++segment)
        {
          add(domain.Starts[segment], segment);
          add(domain.Ends[segment], segment);
        }
      })
{
}

std::vector<Spoke> SpokesOfVertices::Around(Id vertex) const
{
  std::vector<Spoke> spokes;
  for (const Id segment : this->Segments[vertex])
  {
    spokes.push_back(this->MakeSpoke(vertex, segment));
  }
  const Point2 center = this->Geometry.Vertices[vertex];
  std::sort(spokes.begin(), spokes.end(),
    [&center](const Spoke& a, const Spoke& b)
    {
      const bool isAboveA = center < a.End;
      const bool isAboveB = center < b.End;
      return isAboveA != isAboveB ? isAboveB : Orient2D(center, a.End, b.End) > 0;
    });
  return spokes;
}

Spoke SpokesOfVertices::MakeSpoke(Id vertex, Id segment) const
{
  const bool isStart = this->Geometry.Starts[segment] == vertex;
  const Id other = isStart ? this->Geometry.Ends[segment] : this->Geometry.Starts[segment];
  Spoke spoke;
  spoke.Segment = segment;
  spoke.End = this->Geometry.Vertices[other];
  const Point2 span = spoke.End - this->Geometry.Vertices[vertex];
  spoke.Direction = 1.0 / Length(span) * span;
  spoke.LeftInside =
    (isStart ? this->Geometry.LeftInside : this->Geometry.RightInside)[segment] != 0;
  return spoke;
}

std::vector<SharpSector> SpokesOfVertices::SharpSectorsAt(Id vertex) const
{
  std::vector<SharpSector> sectors;
  if (!this->MayBeSharp(vertex))
  {
    return sectors;
  }
  const std::vector<Spoke> spokes = this->Around(vertex);
  for (std::size_t k = 0; k < spokes.size(); ++k)
  {
    const Spoke& first = spokes[k];
    const Spoke& last = spokes[(k + 1) % spokes.size()];
    if (first.LeftInside && Dot(first.Direction, last.Direction) > CosineOf60 &&
      Orient2D(this->Geometry.Vertices[vertex], first.End, last.End) > 0)
    {
      sectors.push_back({ first, last });
    }
  }
  return sectors;
}

bool SpokesOfVertices::MayBeSharp(Id vertex) const
{
  const IdLists::List segments = this->Segments[vertex];
  if (segments.Size() != 2)
  {
    return segments.Size() > 2;
  }
  const Point2 a = this->MakeSpoke(vertex, segments[0]).Direction;
  const Point2 b = this->MakeSpoke(vertex, segments[1]).Direction;
  return Dot(a, b) > CosineOf60;
}

} // namespace biting
