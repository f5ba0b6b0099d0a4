// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SharpCorners.h"

#include <algorithm> // for min, max

namespace biting
{

SharpCorners::SharpCorners(const Domain& domain, const std::vector<double>& spacings,
  const Spacing& spacing, double step, Id limit, Pulse& pulse)
  : Geometry(domain)
  , F(spacing)
  , Step(step)
  , FirstShells(domain.NumberOfVertices(), 0)
  , NumbersOfShells(2 * static_cast<std::size_t>(domain.NumberOfSegments()), 0)
{
  const SpokesOfVertices spokes(domain);
  for (Id vertex = 0; vertex < domain.NumberOfVertices() && pulse.Beat(); ++vertex)
  {
    this->FirstShells[vertex] = static_cast<Id>(this->Radii.size());
    this->FindSides(spokes.SharpSectorsAt(vertex));
    this->AddShells(domain.Vertices[vertex], spacings[vertex], limit);
    for (const Side& side : this->Sides)
    {
      const Id segment = side.Spoke.Segment;
      const bool isEnd = domain.Starts[segment] != vertex;
      this->NumbersOfShells[2 * static_cast<std::size_t>(segment) + (isEnd ? 1 : 0)] = side.Count;
    }
  }
}

void SharpCorners::FindSides(const std::vector<SharpSector>& sectors)
{
  this->Sides.clear();
  for (const SharpSector& sector : sectors)
  {
    const double halfSine = 0.5 * Distance(sector.First.Direction, sector.Last.Direction);
    this->AddSide(sector.First, halfSine);
    this->AddSide(sector.Last, halfSine);
  }
}

void SharpCorners::AddSide(const Spoke& spoke, double halfSine)
{
  for (Side& side : this->Sides)
  {
    if (side.Spoke.Segment == spoke.Segment)
    {
      side.HalfSine = std::min(side.HalfSine, halfSine);
      return;
    }
  }
  const double length = Distance(this->Geometry.Vertices[this->Geometry.Starts[spoke.Segment]],
    this->Geometry.Vertices[this->Geometry.Ends[spoke.Segment]]);
  this->Sides.push_back({ spoke, length, halfSine });
}

void SharpCorners::AddShells(const Point2& corner, double spacing, Id limit)
{
  double last = 0.0;
  double lastSpacing = spacing;
  for (Id count = 0; count < limit && !this->Sides.empty(); ++count)
  {
    const double half = 0.5 * this->Step * lastSpacing;
    const double radius = last + this->Step * this->SpacingAt(corner, last + half);
    if (!(radius > last) || !this->CountShell(radius, last, lastSpacing))
    {
      return;
    }
    this->Radii.push_back(radius);
    last = radius;
    lastSpacing = this->SpacingAt(corner, radius);
  }
}

// The greatest on the sides, as far as these reach.
double SharpCorners::SpacingAt(const Point2& corner, double radius) const
{
  double spacing = 0.0;
  for (const Side& side : this->Sides)
  {
    const double reach = std::min(radius, side.Length);
    spacing = std::max(spacing, this->F(corner + reach * side.Spoke.Direction));
  }
  return spacing;
}

// Counts the shell for the sides that it meets and that are closer together than f at the shell
// before. Whether there are any.
bool SharpCorners::CountShell(double radius, double lastRadius, double lastSpacing)
{
  bool isCounted = false;
  for (Side& side : this->Sides)
  {
    if (radius < side.Length && 2.0 * lastRadius * side.HalfSine < lastSpacing)
    {
      ++side.Count;
      isCounted = true;
    }
  }
  return isCounted;
}

EndShells SharpCorners::ShellsOn(Id segment) const
{
  return { this->ShellsAt(segment, 0), this->ShellsAt(segment, 1) };
}

std::vector<double> SharpCorners::ShellsAt(Id segment, int end) const
{
  const Id vertex = (end == 0 ? this->Geometry.Starts : this->Geometry.Ends)[segment];
  const auto first = this->Radii.begin() + this->FirstShells[vertex];
  return { first, first + this->NumbersOfShells[2 * static_cast<std::size_t>(segment) + end] };
}

} // namespace biting
