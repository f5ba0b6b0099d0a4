// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingRemeshLaws_h
#define BitingRemeshLaws_h

#include "BitingRemesh.h"
#include "Quality/MeshCheck.h"
#include "Quality/TriangleLinks.h"
#include "Remeshing/Stitching.h"

#include <algorithm> // for sort
#include <array>     // for corners
#include <cmath>     // for abs
#include <limits>    // for infinity
#include <map>       // for sums
#include <set>       // for edges
#include <string>    // for the violation
#include <utility>   // for pairs
#include <vector>    // for the arrays

namespace biting
{

constexpr double Rounding = 1e-15; // of coordinates of about 1

/// A mesh as input of the remesher: with its edges as lines, of equal tags where they cover the
/// same input cell.
inline RemeshInput RemeshInputOf(const BitingMesh& mesh, double rounding)
{
  RemeshInput input;
  input.Points = mesh.Points;
  input.Corners = mesh.Corners;
  input.Regions = mesh.Regions;
  input.LineStarts = mesh.EdgeStarts;
  input.LineEnds = mesh.EdgeEnds;
  input.LineCells = mesh.EdgeCells;
  input.AreAlike = [](Id a, Id b) { return a == b; };
  for (const VertexKind kind : mesh.Kinds)
  {
    input.IsFixed.push_back(kind == VertexKind::Embedded);
  }
  input.Rounding = rounding;
  return input;
}

/// The promises of Remesh that can be seen in its result, checked without its own structures.
/// Returns the first one that is broken, empty where none is.
class RemeshLaws
{
public:
  RemeshLaws(const RemeshInput& input, const RemeshResult& result)
    : Input(input)
    , Mesh(result.Mesh)
    , Result(result)
  {
  }

  /// `allowed`: how far edges may be from each old vertex.
  RemeshLaws(
    const RemeshInput& input, const RemeshResult& result, const std::vector<double>& allowed)
    : RemeshLaws(input, result)
  {
    this->Allowed = allowed;
    this->MostAllowed = allowed.empty() ? 0.0 : *std::max_element(allowed.begin(), allowed.end());
  }

  std::string Violation() const
  {
    for (const std::string& violation : { this->OfMesh(), this->OfKept(), this->OfTriangles(),
           this->OfAreas(), this->OfLengths(), this->OfPlaces(), this->OfTopology() })
    {
      if (!violation.empty())
      {
        return violation;
      }
    }
    return {};
  }

private:
  static constexpr double Tolerance = 1e-9; // of sums

  using Sums = std::map<Id, double>;
  using Ends = std::pair<Id, Id>;

  std::string OfMesh() const
  {
    const TriangleLinks links =
      LinkTriangles(this->Mesh.Corners, static_cast<Id>(this->Mesh.Points.size()));
    if (links.Neighbors != this->Mesh.Neighbors)
    {
      return "neighbors are not those that corners tell";
    }
    std::map<Ends, Id> edges;
    for (std::size_t k = 0; k < this->Mesh.EdgeStarts.size(); ++k)
    {
      edges[std::minmax(this->Mesh.EdgeStarts[k], this->Mesh.EdgeEnds[k])] = static_cast<Id>(k);
    }
    std::vector<Id> constraints(this->Mesh.Corners.size(), NoId);
    for (std::size_t slot = 0; slot < constraints.size(); ++slot)
    {
      const std::size_t first = slot - slot % 3;
      const auto found = edges.find(std::minmax(
        this->Mesh.Corners[first + (slot + 1) % 3], this->Mesh.Corners[first + (slot + 2) % 3]));
      constraints[slot] = found == edges.end() ? NoId : found->second;
    }
    // Where all of the area is rounding it is anything up to twice that.
    const double rounding = this->RoundingOfAreas();
    const bool isRounding = this->Result.Old.Area <= rounding;
    const double area = isRounding ? rounding : this->Result.Old.Area;
    return CheckMesh({ this->Mesh.Points, this->Mesh.Corners, this->Mesh.Neighbors, constraints,
      area, Tolerance + (isRounding ? 1.0 : rounding / area) });
  }

  std::string OfKept() const
  {
    std::vector<std::uint8_t> isKept(this->Input.Points.size(), 0);
    for (std::size_t vertex = 0; vertex < this->Mesh.Points.size(); ++vertex)
    {
      const Id original = this->Mesh.OriginalPoints[vertex];
      if (original != NoId && this->Mesh.Points[vertex] != this->Input.Points[original])
      {
        return "a kept vertex has moved";
      }
      if (original != NoId && isKept[original]++ != 0)
      {
        return "an old vertex is there twice";
      }
    }
    for (std::size_t vertex = 0; vertex < this->Input.IsFixed.size(); ++vertex)
    {
      if (this->Input.IsFixed[vertex] && !isKept[vertex] && this->IsUsed(static_cast<Id>(vertex)))
      {
        return "a fixed vertex has gone";
      }
    }
    return {};
  }

  bool IsUsed(Id vertex) const
  {
    const std::vector<Id>& corners = this->Result.Old.Corners;
    return std::find(corners.begin(), corners.end(), vertex) != corners.end();
  }

  /// Whether that triangle of the mesh that was read must stay: not one that had to be divided.
  bool IsFrozen(std::size_t triangle) const
  {
    const OldMesh& old = this->Result.Old;
    const std::size_t origin =
      old.Origins.empty() ? triangle : static_cast<std::size_t>(old.Origins[triangle]);
    return !this->Input.IsFrozen.empty() && this->Input.IsFrozen[origin] &&
      (old.IsRepaired.empty() || !old.IsRepaired[triangle]);
  }

  std::string OfTriangles() const
  {
    std::vector<std::uint8_t> isKept(this->Result.Old.Regions.size(), 0);
    for (std::size_t triangle = 0; triangle < this->Mesh.Regions.size(); ++triangle)
    {
      const Id original = this->Result.OriginalTriangles[triangle];
      if (original == NoId)
      {
        continue;
      }
      std::array<Id, 3> now{};
      std::array<Id, 3> before{};
      for (std::size_t k = 0; k < 3; ++k)
      {
        now[k] = this->Mesh.OriginalPoints[this->Mesh.Corners[3 * triangle + k]];
        before[k] = this->Result.Old.Corners[3 * static_cast<std::size_t>(original) + k];
      }
      std::sort(now.begin(), now.end());
      std::sort(before.begin(), before.end());
      if (now != before || isKept[original]++ != 0)
      {
        return "an unchanged triangle has other corners";
      }
    }
    for (std::size_t triangle = 0; triangle < isKept.size(); ++triangle)
    {
      if (this->IsFrozen(triangle) && !isKept[triangle])
      {
        return "a frozen triangle has changed";
      }
    }
    return {};
  }

  /// Vertices go that are no further than the rounding off the line between others, and come as
  /// near to it: a strip as wide on either side of all edges.
  double RoundingOfAreas() const
  {
    const BitingMesh old = EdgesOf(this->Result.Old);
    const std::vector<Point2>& points = this->Result.Old.Points;
    double length = 0.0;
    for (std::size_t k = 0; k < old.EdgeStarts.size(); ++k)
    {
      length += Distance(points[old.EdgeStarts[k]], points[old.EdgeEnds[k]]);
    }
    // A strip as wide, and a disc at each end.
    const double most = this->MostAllowed;
    return 2.0 * this->Input.Rounding * length +
      most * (2.0 * length + 4.0 * most * static_cast<double>(old.EdgeStarts.size()));
  }

  /// An end that is off the line by the rounding changes the length of an edge by that at most:
  /// where it goes along the line, which it does where ends are as near to each other.
  double RoundingOfLengths(const BitingMesh& old) const
  {
    return 2.0 * this->Input.Rounding *
      static_cast<double>(old.EdgeStarts.size() + this->Mesh.EdgeStarts.size());
  }

  static std::string Compare(Sums before, Sums after, double allowed, const char* text)
  {
    for (const auto& [key, sum] : before)
    {
      if (!(std::abs(after[key] - sum) <= allowed))
      {
        return text;
      }
    }
    for (const auto& [key, sum] : after)
    {
      if (before.count(key) == 0 && !(sum <= allowed))
      {
        return text;
      }
    }
    return {};
  }

  static Sums Areas(const std::vector<Point2>& points, const std::vector<Id>& corners,
    const std::vector<Id>& regions)
  {
    Sums areas;
    for (std::size_t k = 0; k < corners.size(); k += 3)
    {
      const Point2& a = points[corners[k]];
      areas[regions[k / 3]] += 0.5 * Cross(points[corners[k + 1]] - a, points[corners[k + 2]] - a);
    }
    return areas;
  }

  std::string OfAreas() const
  {
    const OldMesh& old = this->Result.Old;
    return Compare(Areas(old.Points, old.Corners, old.Regions),
      Areas(this->Mesh.Points, this->Mesh.Corners, this->Mesh.Regions),
      Tolerance * old.Area + this->RoundingOfAreas(), "a region has another area");
  }

  std::string OfLengths() const
  {
    const BitingMesh old = EdgesOf(this->Result.Old);
    double whole = 0.0;
    Sums before;
    Sums after;
    for (std::size_t k = 0; k < old.EdgeStarts.size(); ++k)
    {
      const std::vector<Point2>& points = this->Result.Old.Points;
      const double length = Distance(points[old.EdgeStarts[k]], points[old.EdgeEnds[k]]);
      before[this->TagOf(old.EdgeCells[k])] += length;
      whole += length;
    }
    for (std::size_t k = 0; k < this->Mesh.EdgeStarts.size(); ++k)
    {
      after[this->TagOf(this->Mesh.EdgeCells[k])] += Distance(
        this->Mesh.Points[this->Mesh.EdgeStarts[k]], this->Mesh.Points[this->Mesh.EdgeEnds[k]]);
    }
    const bool mayDiffer = this->MostAllowed > 0.0;
    return mayDiffer ? CompareKeys(before, after)
                     : Compare(before, after, Tolerance * whole + this->RoundingOfLengths(old),
                         "edges of a tag have another length");
  }

  static std::string CompareKeys(const Sums& before, const Sums& after)
  {
    const bool isSame = before.size() == after.size() &&
      std::equal(before.begin(), before.end(), after.begin(),
        [](const auto& a, const auto& b) { return a.first == b.first; });
    return isSame ? "" : "edges have other tags";
  }

  using Segments = std::map<Id, std::vector<std::array<Point2, 2>>>;

  Segments SegmentsOf(const BitingMesh& edges, const std::vector<Point2>& points) const
  {
    Segments segments;
    for (std::size_t k = 0; k < edges.EdgeStarts.size(); ++k)
    {
      segments[this->TagOf(edges.EdgeCells[k])].push_back(
        { points[edges.EdgeStarts[k]], points[edges.EdgeEnds[k]] });
    }
    return segments;
  }

  static double DistanceTo(const std::vector<std::array<Point2, 2>>& segments, const Point2& p)
  {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& [a, b] : segments)
    {
      const double square = Dot(b - a, b - a);
      const double share = square > 0.0 ? std::clamp(Dot(p - a, b - a) / square, 0.0, 1.0) : 0.0;
      least = std::min(least, Distance(p, a + share * (b - a)));
    }
    return least;
  }

  /// Old vertices of edges of a tag are as near to new ones as is allowed there, samples of these
  /// to old edges as is allowed anywhere.
  std::string OfPlaces() const
  {
    if (this->Allowed.empty())
    {
      return {};
    }
    const BitingMesh old = EdgesOf(this->Result.Old);
    const Segments before = this->SegmentsOf(old, this->Result.Old.Points);
    const Segments after = this->SegmentsOf(this->Mesh, this->Mesh.Points);
    for (std::size_t k = 0; k < old.EdgeStarts.size(); ++k)
    {
      const Id start = old.EdgeStarts[k];
      const double distance =
        DistanceTo(after.at(this->TagOf(old.EdgeCells[k])), this->Result.Old.Points[start]);
      if (!(distance <= this->Allowed[start] + 2.0 * this->Input.Rounding))
      {
        return "an edge is too far from an old vertex";
      }
    }
    for (const auto& [tag, segments] : after)
    {
      for (const auto& [a, b] : segments)
      {
        const double distance = DistanceTo(before.at(tag), 0.5 * (a + b));
        if (!(distance <= this->MostAllowed + 2.0 * this->Input.Rounding))
        {
          return "a new edge is too far from the old ones";
        }
      }
    }
    return {};
  }

  /// Of each region, the Euler characteristic: pieces less holes.
  static std::map<Id, long long> Characteristics(
    const std::vector<Id>& corners, const std::vector<Id>& regions)
  {
    std::set<std::pair<Id, Id>> vertices;
    std::set<std::pair<Id, Ends>> edges;
    std::map<Id, long long> sums;
    for (std::size_t slot = 0; slot < corners.size(); ++slot)
    {
      const Id region = regions[slot / 3];
      const Id next = corners[slot - slot % 3 + (slot + 1) % 3];
      sums[region] += slot % 3 == 0 ? 1 : 0;
      sums[region] += vertices.insert({ region, corners[slot] }).second ? 1 : 0;
      sums[region] -= edges.insert({ region, std::minmax(corners[slot], next) }).second ? 1 : 0;
    }
    return sums;
  }

  std::string OfTopology() const
  {
    const OldMesh& old = this->Result.Old;
    const bool isSame = Characteristics(old.Corners, old.Regions) ==
      Characteristics(this->Mesh.Corners, this->Mesh.Regions);
    return isSame || this->HasGapsOfRounding() ? "" : "a region has other pieces or holes";
  }

  /// Whether a vertex lies as near to an edge that does not end there: they may be meant to touch,
  /// or not.
  bool HasGapsOfRounding() const
  {
    const BitingMesh old = EdgesOf(this->Result.Old);
    const std::vector<Point2>& points = this->Result.Old.Points;
    for (const Id vertex : old.EdgeStarts)
    {
      for (std::size_t k = 0; k < old.EdgeStarts.size(); ++k)
      {
        const Id start = old.EdgeStarts[k];
        const Id end = old.EdgeEnds[k];
        const bool isNear = start != vertex && end != vertex &&
          DistanceTo({ { points[start], points[end] } }, points[vertex]) <=
            2.0 * this->Input.Rounding;
        if (isNear)
        {
          return true;
        }
      }
    }
    return false;
  }

  Id TagOf(Id line) const { return line == NoId ? NoId : this->Input.LineCells[line]; }

  const RemeshInput& Input;
  const BitingMesh& Mesh;
  const RemeshResult& Result;
  std::vector<double> Allowed;
  double MostAllowed = 0.0;
};

} // namespace biting

#endif
