// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingPolylineShapes_h
#define BitingPolylineShapes_h

#include "Base/Problem.h"
#include "Domain/Polylines.h"
#include "DomainCheck.h"

#include <algorithm> // for reverse
#include <cstdint>   // for the generator
#include <string>    // for the check
#include <vector>    // for chains

namespace biting
{

/// Builds polylines for tests.
class PolylineBuilder
{
public:
  /// A chain through `places`, with points of its own.
  PolylineBuilder& Chain(const std::vector<Point2>& places, ChainKind kind = ChainKind::Automatic)
  {
    for (const Point2& place : places)
    {
      this->Input.Connectivity.push_back(static_cast<Id>(this->Input.Points.size()));
      this->Input.Points.push_back(place);
    }
    return this->Finish(kind);
  }

  /// A chain that returns to its first point.
  PolylineBuilder& Loop(const std::vector<Point2>& places, ChainKind kind = ChainKind::Automatic)
  {
    const Id first = static_cast<Id>(this->Input.Points.size());
    for (const Point2& place : places)
    {
      this->Input.Connectivity.push_back(static_cast<Id>(this->Input.Points.size()));
      this->Input.Points.push_back(place);
    }
    this->Input.Connectivity.push_back(first);
    return this->Finish(kind);
  }

  PolylineBuilder& Box(
    double x0, double y0, double x1, double y1, ChainKind kind = ChainKind::Automatic)
  {
    return this->Loop({ { x0, y0 }, { x1, y0 }, { x1, y1 }, { x0, y1 } }, kind);
  }

  /// Of the faces that follow.
  PolylineBuilder& Region(Id region)
  {
    this->CurrentRegion = region;
    return *this;
  }

  const Polylines& Lines() const { return this->Input; }

private:
  PolylineBuilder& Finish(ChainKind kind)
  {
    this->Input.Cells.push_back(this->Input.NumberOfChains());
    this->Input.Kinds.push_back(kind);
    this->Input.Regions.push_back(this->CurrentRegion);
    this->Input.Offsets.push_back(static_cast<Id>(this->Input.Connectivity.size()));
    return *this;
  }

  Polylines Input;
  Id CurrentRegion = 0;
};

/// A domain with what was said while it was made, and the verdict of the check.
struct MadeDomain
{
  biting::Domain Domain;
  ProblemList Problems;
  std::string Violation;
};

inline MadeDomain Make(const Polylines& input, bool repair = true, bool keepCellEdges = false)
{
  MadeDomain made;
  SilentMonitor monitor;
  DomainOptions options;
  options.Repair = repair;
  options.KeepCellEdges = keepCellEdges;
  made.Domain = MakeDomain(input, options, made.Problems, monitor);
  made.Violation = CheckDomain(made.Domain);
  return made;
}

inline MadeDomain Make(const PolylineBuilder& builder, bool repair = true)
{
  return Make(builder.Lines(), repair);
}

/// Every segment a chain of two points of its own, as many VTK sources give them. Chains keep their
/// kind; those that close are boundary, as they were.
inline Polylines Unmerge(const Polylines& input)
{
  PolylineBuilder builder;
  for (Id chain = 0; chain < input.NumberOfChains(); ++chain)
  {
    const auto c = static_cast<std::size_t>(chain);
    for (Id place = input.Offsets[c]; place < input.Offsets[c + 1]; ++place)
    {
      const auto pointAt = [&input](Id i)
      {
        const Id point = input.Connectivity[static_cast<std::size_t>(i)];
        return input.Points[static_cast<std::size_t>(point)];
      };
      if (input.Kinds[c] == ChainKind::EmbeddedPoint)
      {
        builder.Chain({ pointAt(place) }, input.Kinds[c]);
      }
      else if (place > input.Offsets[c])
      {
        builder.Chain({ pointAt(place - 1), pointAt(place) }, input.Kinds[c]);
      }
    }
  }
  return builder.Lines();
}

/// Every chain backwards.
inline Polylines Reverse(Polylines input)
{
  for (std::size_t c = 0; c < input.Kinds.size(); ++c)
  {
    std::reverse(input.Connectivity.begin() + input.Offsets[c],
      input.Connectivity.begin() + input.Offsets[c + 1]);
  }
  return input;
}

template <typename Motion>
Polylines Move(Polylines input, Motion motion)
{
  for (Point2& point : input.Points)
  {
    point = motion(point);
  }
  return input;
}

/// The same sequence of numbers on every platform (G. Marsaglia, "Xorshift RNGs", 2003).
class TestNumbers
{
public:
  explicit TestNumbers(std::uint64_t seed)
    : State(seed * 0x9E3779B97F4A7C15u + 1u)
  {
  }

  /// In [0, bound).
  int Below(int bound)
  {
    this->State ^= this->State << 13;
    this->State ^= this->State >> 7;
    this->State ^= this->State << 17;
    return static_cast<int>((this->State >> 20) % static_cast<std::uint64_t>(bound));
  }

  double Unit() { return this->Below(1 << 30) / static_cast<double>(1 << 30); }

private:
  std::uint64_t State;
};

} // namespace biting

#endif
