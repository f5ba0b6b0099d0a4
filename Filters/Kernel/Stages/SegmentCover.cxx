// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SegmentCover.h"

#include "../Base/Pulse.h"
#include "../Delaunay/ConstrainedEdges.h"

#include <algorithm> // for find_if
#include <cstdint>   // for sums
#include <cstring>   // for memcpy

namespace biting
{

namespace
{

std::uint64_t BitsOf(double value)
{
  std::uint64_t bits = 0;
  std::memcpy(&bits, &value, sizeof bits);
  return bits;
}

// Different for different places, as good as surely (the finalizer of S. Vigna's splitmix64, 2015).
std::uint64_t MarkOf(const Point2& place)
{
  std::uint64_t mark = BitsOf(place.X) + 0x9E3779B97F4A7C15u * BitsOf(place.Y);
  mark = (mark ^ (mark >> 30)) * 0xBF58476D1CE4E5B9u;
  mark = (mark ^ (mark >> 27)) * 0x94D049BB133111EBu;
  return mark ^ (mark >> 31);
}

std::string ViolationAt(const Domain& domain, std::size_t segment)
{
  return "the mesh edges on segment " + std::to_string(segment) + ", of cell " +
    std::to_string(domain.Cells[segment]) + ", are not a chain between its ends";
}

} // namespace

// Each place of a chain but its ends is marked twice, which leaves no mark.
std::string CheckSegmentCover(const Domain& domain, const SegmentCoverInput& mesh, Monitor& monitor)
{
  Pulse pulse(monitor);
  std::vector<std::uint64_t> marks(static_cast<std::size_t>(domain.NumberOfSegments()), 0);
  ForEachConstrainedEdge(mesh, pulse,
    [&mesh, &marks](Id constraint, Id start, Id end)
    { marks[mesh.Segments[constraint]] ^= MarkOf(mesh.Points[start]) ^ MarkOf(mesh.Points[end]); });
  pulse.ForEach(marks.size(),
    [&domain, &marks](std::size_t segment)
    {
      marks[segment] ^= MarkOf(domain.Vertices[domain.Starts[segment]]) ^
        MarkOf(domain.Vertices[domain.Ends[segment]]);
    });
  const auto broken =
    std::find_if(marks.begin(), marks.end(), [](std::uint64_t mark) { return mark != 0; });
  return broken == marks.end()
    ? std::string()
    : ViolationAt(domain, static_cast<std::size_t>(broken - marks.begin()));
}

} // namespace biting
