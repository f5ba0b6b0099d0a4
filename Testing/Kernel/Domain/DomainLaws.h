// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingDomainLaws_h
#define BitingDomainLaws_h

#include "../Support/PolylineShapes.h"

#include <gtest/gtest.h>

#include <algorithm> // for count, min, max
#include <cmath>     // for cos, sin
#include <cstdint>   // for ids
#include <set>       // for distinct places
#include <utility>   // for pairs
#include <vector>    // for places

namespace biting
{

// What is expected of domains.

constexpr double Pi = 3.14159265358979323846;

/// A valid domain of that area, and nothing said but `repairs` kinds.
inline void ExpectDomain(const MadeDomain& made, double area, std::size_t repairs = 0)
{
  EXPECT_EQ(made.Violation, "");
  EXPECT_FALSE(made.Problems.HasErrors());
  EXPECT_EQ(made.Problems.Groups().size(), repairs);
  EXPECT_DOUBLE_EQ(made.Domain.Area, area);
}

inline void ExpectRefused(const MadeDomain& made, ProblemCode code)
{
  EXPECT_TRUE(made.Problems.Has(code));
  EXPECT_EQ(made.Domain.NumberOfVertices(), 0);
  EXPECT_EQ(made.Domain.NumberOfSegments(), 0);
  EXPECT_EQ(made.Domain.Area, 0.0);
}

inline std::vector<std::int64_t> FirstIds(const MadeDomain& made, ProblemCode code)
{
  for (const ProblemGroup& group : made.Problems.Groups())
  {
    if (group.Code == code)
    {
      return group.First.front().Ids;
    }
  }
  return {};
}

using Ids = std::vector<std::int64_t>;

inline Id InterfaceCount(const Domain& domain)
{
  return static_cast<Id>(std::count(domain.IsBoundary.begin(), domain.IsBoundary.end(), 0));
}

inline std::vector<Point2> WigglyCircle(int count)
{
  std::vector<Point2> places;
  for (int i = 0; i < count; ++i)
  {
    const double angle = 2 * Pi * i / count;
    const double radius = 1.0 + 0.05 * std::cos(50 * angle);
    places.push_back({ radius * std::cos(angle), radius * std::sin(angle) });
  }
  return places;
}

/// Equal but for the numbers of vertices and segments and the direction of segments.
inline std::set<std::pair<Point2, Point2>> Drawing(const Domain& domain, bool boundary)
{
  std::set<std::pair<Point2, Point2>> drawing;
  for (std::size_t s = 0; s < domain.Starts.size(); ++s)
  {
    const Point2& a = domain.Vertices[static_cast<std::size_t>(domain.Starts[s])];
    const Point2& b = domain.Vertices[static_cast<std::size_t>(domain.Ends[s])];
    if ((domain.IsBoundary[s] != 0) == boundary)
    {
      drawing.emplace(std::min(a, b), std::max(a, b));
    }
  }
  return drawing;
}

/// Equal to the last bit, but for ids of the input.
inline void ExpectSame(const Domain& a, const Domain& b)
{
  EXPECT_EQ(a.Vertices, b.Vertices);
  EXPECT_EQ(a.IsEmbedded, b.IsEmbedded);
  EXPECT_EQ(a.Starts, b.Starts);
  EXPECT_EQ(a.Ends, b.Ends);
  EXPECT_EQ(a.IsBoundary, b.IsBoundary);
  EXPECT_EQ(a.LeftInside, b.LeftInside);
  EXPECT_EQ(a.RightInside, b.RightInside);
  EXPECT_EQ(a.Area, b.Area);
}

/// Much of everything: holes, crossing interfaces and open chains, points.
inline Polylines Medley(int size)
{
  PolylineBuilder builder;
  builder.Box(-1, -1, size + 1, size + 1, ChainKind::Boundary);
  for (int i = 0; i < size; ++i)
  {
    builder.Box(i + 0.25, 0.25, i + 0.5, 0.5, ChainKind::Boundary);
    builder.Chain({ { 0.0, i + 0.625 }, { size - 0.5, i + 0.75 } }, ChainKind::Interface);
    builder.Chain({ { i + 0.75, 0.0 }, { i + 0.625, size - 0.5 } });
    builder.Chain({ { i + 0.875, 0.875 }, { i + 0.25, 0.375 } }, ChainKind::EmbeddedPoint);
  }
  return builder.Lines();
}

} // namespace biting

#endif
