// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "WholeCheck.h"

#include "../../Base/DisjointSets.h"
#include "../../Base/IdLists.h"
#include "../../Base/Problem.h"

#include <algorithm> // for minmax, sort, unique
#include <cmath>     // for abs
#include <cstdint>   // for marks
#include <utility>   // for move

namespace biting
{

namespace
{

/// Of a part of a triangle mesh.
struct PartFigures
{
  Id Euler = 0;
  double Area = 0.0;
  double Volume = 0.0;
  Id Triangle = NoId; ///< one of its triangles
};

/// Parts by what hangs together, or as given.
class PartMeasure
{
public:
  PartMeasure(const std::vector<Point3>& points, const std::vector<Id>& corners)
    : Points(points)
    , Corners(corners)
    , Parts(points.size())
  {
    for (std::size_t slot = 0; slot < corners.size(); ++slot)
    {
      this->Parts.Unite(corners[slot], corners[slot - slot % 3]);
    }
  }

  Id RootOf(Id vertex) { return this->Parts.SetOf(vertex); }

  /// By roots: those of others are empty.
  std::vector<PartFigures> Measure(Pulse& pulse)
  {
    std::vector<PartFigures> parts(this->Points.size());
    // Of edges at their lower ends.
    const IdLists heads(this->Points.size(),
      [this](const auto& add)
      {
        for (std::size_t slot = 0; slot < this->Corners.size(); ++slot)
        {
          const auto [low, high] =
            std::minmax(this->Corners[slot], this->Corners[slot % 3 == 2 ? slot - 2 : slot + 1]);
          add(low, high);
        }
      });
    std::vector<std::uint8_t> isUsed(this->Points.size(), 0);
    for (const Id corner : this->Corners)
    {
      isUsed[At(corner)] = 1;
    }
    std::vector<Id> ends;
    pulse.ForEach(isUsed.size(),
      [this, &heads, &isUsed, &ends, &parts](std::size_t vertex)
      {
        const Id low = static_cast<Id>(vertex);
        ends.assign(heads[low].begin(), heads[low].end());
        std::sort(ends.begin(), ends.end());
        const auto edges = std::unique(ends.begin(), ends.end()) - ends.begin();
        parts[At(this->RootOf(low))].Euler += isUsed[vertex] - static_cast<Id>(edges);
      });
    for (std::size_t t = 0; t < this->Corners.size() / 3; ++t)
    {
      PartFigures& part = parts[At(this->RootOf(this->Corners[3 * t]))];
      const Point3 origin = this->Points.front();
      const Point3 a = this->Points[At(this->Corners[3 * t])];
      const Point3 b = this->Points[At(this->Corners[3 * t + 1])];
      const Point3 c = this->Points[At(this->Corners[3 * t + 2])];
      ++part.Euler;
      part.Area += 0.5 * Length(Cross(b - a, c - a));
      part.Volume += Dot(a - origin, Cross(b - origin, c - origin)) / 6.0;
      part.Triangle = static_cast<Id>(t);
    }
    return parts;
  }

private:
  const std::vector<Point3>& Points;
  const std::vector<Id>& Corners;
  DisjointSets Parts;
};

std::string Difference(const char* what, double is, double wanted)
{
  return std::string("the mesh of this part has ") + what + " " + Figure(is) + ", not " +
    Figure(wanted);
}

/// Text for what differs; empty where nothing does.
std::string Compare(const PartFigures& part, const PartFigures& wanted, bool isClosed)
{
  constexpr double MostShare = 0.15; // of area and volume: coarse meshes of round bodies lose some
  if (part.Euler != wanted.Euler)
  {
    return Difference("Euler number", part.Euler, wanted.Euler);
  }
  if (std::abs(part.Area - wanted.Area) > MostShare * wanted.Area)
  {
    return Difference("area", part.Area, wanted.Area);
  }
  if (isClosed && std::abs(part.Volume - wanted.Volume) > MostShare * std::abs(wanted.Volume))
  {
    return Difference("volume", part.Volume, wanted.Volume);
  }
  return {};
}

} // namespace

WholeVerdict CheckWhole(const CheckedSurface& surface, const std::vector<Point3>& points,
  const std::vector<Id>& corners, const std::vector<Id>& below, Pulse& pulse)
{
  WholeVerdict verdict;
  if (points.empty())
  {
    return verdict;
  }
  PartMeasure wantedMeasure(surface.Mesh.Points, surface.Mesh.Corners);
  const std::vector<PartFigures> wanted = wantedMeasure.Measure(pulse);
  PartMeasure measure(points, corners);
  const std::vector<PartFigures> parts = measure.Measure(pulse);
  const auto refuse = [&verdict, &surface](Id triangle, std::string what)
  {
    verdict.IsSame = false;
    verdict.Triangle = triangle;
    verdict.Place = surface.Mesh.Middle(At(triangle));
    verdict.What = std::move(what);
  };
  // Of each part of the surface, the part of the mesh on it.
  std::vector<Id> partOn(wanted.size(), NoId);
  for (std::size_t t = 0; t < below.size(); ++t)
  {
    const Id root = wantedMeasure.RootOf(surface.Mesh.Corners[3 * At(below[t])]);
    Id& part = partOn[At(root)];
    const Id own = measure.RootOf(corners[3 * t]);
    if (part != NoId && part != own)
    {
      refuse(below[t], "a part in pieces");
      return verdict;
    }
    part = own;
  }
  std::vector<std::uint8_t> isTaken(parts.size(), 0);
  for (std::size_t root = 0; root < wanted.size(); ++root)
  {
    if (wanted[root].Triangle == NoId)
    {
      continue;
    }
    const Id part = partOn[root];
    const bool isClosed = surface.Shells.IsSolid(At(wanted[root].Triangle));
    const std::string what = part == NoId ? "a part is missing"
      : isTaken[At(part)]++ != 0          ? "a part that became one with another"
                                          : Compare(parts[At(part)], wanted[root], isClosed);
    if (!what.empty())
    {
      refuse(wanted[root].Triangle, what);
      verdict.IsCoarse = part != NoId && parts[At(part)].Euler == wanted[root].Euler;
      return verdict;
    }
  }
  return verdict;
}

} // namespace biting
