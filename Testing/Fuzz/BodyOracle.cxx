// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "BodyOracle.h"

#include "Predicates/Predicates3.h"
#include "Space/Union/ResolveCrossings.h"

#include "Support/TestThreads.h"

#include <algorithm> // for all_of, binary_search, count, min, remove_if, rotate, sort
#include <array>     // for facets
#include <cmath>     // for angles
#include <numeric>   // for iota
#include <utility>   // for edges

namespace biting
{

namespace
{

using Edge = std::array<Id, 2>;
using Facet = std::array<Id, 3>;

bool AreFinite(const std::vector<Point3>& points)
{
  return std::all_of(points.begin(), points.end(),
    [](const Point3& point)
    { return std::isfinite(point.X) && std::isfinite(point.Y) && std::isfinite(point.Z); });
}

/// Whether corners are vertices, and each of these is one.
bool AreVertices(const std::vector<Id>& corners, std::size_t size)
{
  std::vector<bool> isUsed(size, false);
  for (const Id corner : corners)
  {
    if (corner < 0 || At(corner) >= size)
    {
      return false;
    }
    isUsed[At(corner)] = true;
  }
  return std::count(isUsed.begin(), isUsed.end(), false) == 0;
}

/// Six times the volume under triangles, seen from `from`.
double Volume(const std::vector<Point3>& points, const std::vector<Id>& corners, const Point3& from)
{
  double volume = 0.0;
  for (std::size_t slot = 0; slot < corners.size(); slot += 3)
  {
    volume += Dot(points[At(corners[slot])] - from,
      Cross(points[At(corners[slot + 1])] - from, points[At(corners[slot + 2])] - from));
  }
  return volume / 6.0;
}

std::string NameOf(ProblemCode code)
{
  const std::array<const char*, 6> shapes = { "open edges", "crowded edges", "pinches", "folds",
    "crossings", "one side" };
  const int shape = static_cast<int>(code) - static_cast<int>(ProblemCode::OpenEdges);
  return code == ProblemCode::TooThin      ? "too thin"
    : code == ProblemCode::TooSharp        ? "too sharp"
    : code == ProblemCode::TooManyVertices ? "too many"
    : shape >= 0 && shape < 6              ? shapes[static_cast<std::size_t>(shape)]
                                           : "code-" + std::to_string(static_cast<int>(code));
}

/// What errors say; a place for each, and no failed check.
std::string TextOf(const ProblemList& problems, std::string& violation)
{
  std::string text;
  for (const ProblemGroup& group : problems.Groups())
  {
    if (!IsError(group.Code))
    {
      continue;
    }
    const Problem& first = group.First.front();
    text += NameOf(group.Code) + " " + first.Detail + "; ";
    if (!AreFinite({ first.Place }))
    {
      violation = "an error without a place: " + text;
    }
    if (group.Code == ProblemCode::CheckFailed)
    {
      violation = "the check failed: " + first.Detail + " at " + std::to_string(first.Place.X) +
        " " + std::to_string(first.Place.Y) + " " + std::to_string(first.Place.Z);
    }
  }
  return text;
}

/// Numbers of vertices - edges + triangles of the parts, ascending; edges with one triangle and
/// with more than two.
struct Topology
{
  std::vector<int> EulerNumbers;
  std::size_t Borders = 0;
  std::size_t Crowded = 0;
  bool IsOriented = true; ///< each edge of two triangles is there both ways
};

Topology TopologyOf(std::size_t size, const std::vector<Id>& corners)
{
  std::vector<Id> parts(size);
  std::iota(parts.begin(), parts.end(), 0);
  const auto partOf = [&parts](Id vertex)
  {
    while (parts[At(vertex)] != vertex)
    {
      vertex = parts[At(vertex)] = parts[At(parts[At(vertex)])];
    }
    return vertex;
  };
  std::vector<std::array<Id, 3>> edges;
  edges.reserve(corners.size());
  for (std::size_t slot = 0; slot < corners.size(); ++slot)
  {
    const Id a = corners[slot];
    const Id b = corners[slot % 3 == 2 ? slot - 2 : slot + 1];
    edges.push_back({ std::min(a, b), std::max(a, b), a < b ? 0 : 1 });
    parts[At(partOf(a))] = partOf(b);
  }
  Topology topology;
  std::vector<int> numbers(size, 0);
  std::vector<bool> isCounted(size, false);
  for (std::size_t slot = 0; slot < corners.size(); ++slot)
  {
    numbers[At(partOf(corners[slot]))] += (isCounted[At(corners[slot])] ? 0 : 1) + slot % 3 / 2;
    isCounted[At(corners[slot])] = true;
  }
  std::sort(edges.begin(), edges.end());
  for (std::size_t first = 0, end = 0; first < edges.size(); first = end)
  {
    while (
      end < edges.size() && edges[end][0] == edges[first][0] && edges[end][1] == edges[first][1])
    {
      ++end;
    }
    --numbers[At(partOf(edges[first][0]))];
    topology.Borders += end - first == 1 ? 1 : 0;
    topology.Crowded += end - first > 2 ? 1 : 0;
    topology.IsOriented =
      topology.IsOriented && (end - first != 2 || edges[first][2] != edges[first + 1][2]);
  }
  for (std::size_t vertex = 0; vertex < size; ++vertex)
  {
    if (isCounted[vertex] && parts[vertex] == static_cast<Id>(vertex))
    {
      topology.EulerNumbers.push_back(numbers[vertex]);
    }
  }
  std::sort(topology.EulerNumbers.begin(), topology.EulerNumbers.end());
  return topology;
}

std::string JudgeTopology(const BitingSurface& mesh, const SurfaceMesh& input, bool isCut)
{
  const Topology wanted = TopologyOf(input.Points.size(), input.Corners);
  const Topology topology = TopologyOf(mesh.Points.size(), mesh.Corners);
  if (topology.EulerNumbers != wanted.EulerNumbers)
  {
    const auto list = [](const std::vector<int>& numbers)
    {
      std::string text;
      for (const int number : numbers)
      {
        text += " " + std::to_string(number);
      }
      return text;
    };
    return "Euler numbers" + list(topology.EulerNumbers) + " for" + list(wanted.EulerNumbers);
  }
  // Fins that are far thinner than f may go, if that is told.
  if (!(isCut && wanted.Crowded > 0) &&
    ((topology.Borders > 0) != (wanted.Borders > 0) ||
      (topology.Crowded > 0) != (wanted.Crowded > 0)))
  {
    return std::to_string(topology.Borders) + " edges with one triangle and " +
      std::to_string(topology.Crowded) + " with more than two for " +
      std::to_string(wanted.Borders) + " and " + std::to_string(wanted.Crowded);
  }
  return topology.IsOriented || !wanted.IsOriented || wanted.Crowded > 0
    ? ""
    : "triangles are oriented against each other";
}

/// From p to the triangle.
double DistanceTo(const std::array<Point3, 3>& triangle, const Point3& p)
{
  double nearest = Infinity;
  const Point3 normal = Cross(triangle[1] - triangle[0], triangle[2] - triangle[0]);
  bool isAbove = Length(normal) > 0.0;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Point3& a = triangle[k];
    const Point3 along = triangle[(k + 1) % 3] - a;
    const double length = Dot(along, along);
    const double at = length > 0.0 ? std::min(1.0, std::max(0.0, Dot(p - a, along) / length)) : 0.0;
    nearest = std::min(nearest, Distance(p, a + at * along));
    isAbove = isAbove && Dot(Cross(normal, along), p - a) >= 0.0;
  }
  return isAbove ? std::min(nearest, std::abs(Dot(p - triangle[0], normal)) / Length(normal))
                 : nearest;
}

double DistanceTo(
  const std::vector<Point3>& points, const std::vector<Id>& corners, const Point3& p)
{
  double nearest = Infinity;
  for (std::size_t slot = 0; slot < corners.size(); slot += 3)
  {
    nearest = std::min(nearest,
      DistanceTo(
        { points[At(corners[slot])], points[At(corners[slot + 1])], points[At(corners[slot + 2])] },
        p));
  }
  return nearest;
}

/// Of some vertices and middles of one from the other, in f.
std::string JudgeDistances(
  const BitingSurface& mesh, const SurfaceMesh& input, double size, bool isCut)
{
  constexpr std::size_t Samples = 40;
  const auto farthest = [](const auto& from, const auto& to)
  {
    double most = 0.0;
    const std::size_t step = 1 + from.Corners.size() / Samples;
    for (std::size_t slot = 0; slot < from.Corners.size(); slot += step)
    {
      const std::size_t first = slot - slot % 3;
      const Point3& corner = from.Points[At(from.Corners[slot])];
      const Point3 middle = (1.0 / 3.0) *
        (from.Points[At(from.Corners[first])] + from.Points[At(from.Corners[first + 1])] +
          from.Points[At(from.Corners[first + 2])]);
      most = std::max({ most, DistanceTo(to.Points, to.Corners, corner),
        DistanceTo(to.Points, to.Corners, middle) });
    }
    return most;
  };
  const double off = farthest(mesh, input) / size;
  const double missed = farthest(input, mesh) / size;
  return off <= (isCut ? 1.0 : 0.5) && missed <= (isCut ? 1.5 : 1.0)
    ? ""
    : "off by " + std::to_string(off) + " f, missed by " + std::to_string(missed) + " f";
}

template <typename Value>
bool AreWithin(const std::vector<Value>& values, std::size_t size, Value low, Value high)
{
  return values.size() == size &&
    std::all_of(values.begin(), values.end(),
      [low, high](Value value) { return value >= low && value <= high; });
}

/// Of f as given: f as used. Lines are divided into a whole number of pieces.
constexpr double MostShare = 2.0;

std::string JudgeArrays(
  const BitingSurface& mesh, const CheckedSurface& checked, const SurfaceCase& surface)
{
  const std::size_t points = mesh.Points.size();
  const std::size_t triangles = mesh.Corners.size() / 3;
  const Id cells = static_cast<Id>(checked.Mesh.NumberOfTriangles());
  const Id originals = static_cast<Id>(surface.Input.Points.size());
  const double most = MostShare * surface.LargestSize;
  const bool areWithin = AreWithin(mesh.Spacing, points, 1e-300, most) &&
    AreWithin(mesh.BiteOrders, points, NoId, 1000000) && mesh.Kinds.size() == points &&
    AreWithin(mesh.OriginalPoints, points, NoId, originals - 1) &&
    AreWithin(mesh.Triangles, triangles, Id(0), cells - 1) && mesh.Regions.size() == triangles &&
    AreWithin(mesh.Deviations, triangles, 0.0, 10.0) &&
    AreWithin(mesh.EdgeEnds, 2 * mesh.EdgeKinds.size(), Id(0), static_cast<Id>(points) - 1) &&
    mesh.BiteCenters.size() == mesh.BiteRadii.size();
  return areWithin ? "" : "arrays have other sizes, or values out of range";
}

std::string JudgeSurface(
  const BitingSurface& mesh, const CheckedSurface& checked, const SurfaceCase& surface, bool isCut)
{
  if (mesh.Corners.empty() || !AreFinite(mesh.Points) ||
    !AreVertices(mesh.Corners, mesh.Points.size()))
  {
    return "no surface, or vertices that are no places, or are unused";
  }
  const SurfaceFigures& figures = checked.Figures;
  const double size = surface.LargestSize;
  const double volume = Volume(mesh.Points, mesh.Corners, mesh.Points.front());
  const bool isPlain = figures.OpenEdges == 0 && figures.NonManifoldEdges == 0;
  if (isPlain && !(std::abs(volume - figures.Volume) <= 0.5 * size * figures.Area))
  {
    return "volume " + std::to_string(volume) + " for " + std::to_string(figures.Volume);
  }
  for (const std::string& wrong :
    { JudgeArrays(mesh, checked, surface), JudgeTopology(mesh, checked.Mesh, isCut),
      JudgeDistances(mesh, checked.Mesh, size, isCut) })
  {
    if (!wrong.empty())
    {
      return wrong;
    }
  }
  return {};
}

/// From the lowest corner on, in their orientation.
Facet Turned(Facet corners)
{
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  return corners;
}

/// A facet of a tetrahedron, from outside.
struct CellFacet
{
  Facet Corners;
  Id Region;

  bool operator<(const CellFacet& other) const { return this->Corners < other.Corners; }
};

std::vector<CellFacet> FacetsOf(const BitingBody& mesh)
{
  std::vector<CellFacet> facets;
  for (std::size_t tet = 0; tet < mesh.Regions.size(); ++tet)
  {
    const Id* t = &mesh.Corners[4 * tet];
    for (const Facet& facet : { Facet{ t[1], t[2], t[3] }, { t[0], t[3], t[2] },
           { t[0], t[1], t[3] }, { t[0], t[2], t[1] } })
    {
      facets.push_back({ Turned(facet), mesh.Regions[tet] });
    }
  }
  std::sort(facets.begin(), facets.end());
  return facets;
}

/// The boundary has all facets that no other tetrahedron of the same region has, and no others.
std::string JudgeFacets(const BitingBody& mesh)
{
  const std::vector<CellFacet> facets = FacetsOf(mesh);
  std::vector<Facet> outer;
  for (std::size_t k = 0; k < facets.size(); ++k)
  {
    const Facet& corners = facets[k].Corners;
    if (k > 0 && corners == facets[k - 1].Corners)
    {
      return "two tetrahedra on one side of a facet";
    }
    const CellFacet back{ { corners[0], corners[2], corners[1] }, 0 };
    const auto other = std::lower_bound(facets.begin(), facets.end(), back);
    const bool hasOther = other != facets.end() && other->Corners == back.Corners;
    if (!hasOther || facets[k].Region < other->Region)
    {
      outer.push_back(corners);
    }
  }
  const std::vector<Id>& corners = mesh.Boundary.Corners;
  std::vector<Facet> boundary;
  for (std::size_t slot = 0; slot < corners.size(); slot += 3)
  {
    boundary.push_back(Turned({ corners[slot], corners[slot + 1], corners[slot + 2] }));
  }
  std::sort(boundary.begin(), boundary.end());
  // Bodies of one region may share a wall.
  const auto isWall = [&facets](const Facet& facet)
  {
    const auto has = [&facets](const Facet& one) {
      return std::binary_search(facets.begin(), facets.end(), CellFacet{ one, 0 });
    };
    return has(facet) && has({ facet[0], facet[2], facet[1] });
  };
  boundary.erase(std::remove_if(boundary.begin(), boundary.end(),
                   [&outer, &isWall](const Facet& facet) {
                     return !std::binary_search(outer.begin(), outer.end(), facet) && isWall(facet);
                   }),
    boundary.end());
  return boundary == outer ? "" : "the boundary is not that of the tetrahedra";
}

/// In degrees, of the six.
double SmallestDihedral(const std::array<Point3, 4>& corners)
{
  double smallest = 180.0;
  for (std::size_t i = 0; i < 4; ++i)
  {
    for (std::size_t j = i + 1; j < 4; ++j)
    {
      const std::size_t k = (i == 0 || j == 0) ? (i == 1 || j == 1 ? 2 : 1) : 0;
      const std::size_t l = 6 - i - j - k;
      const Point3 along = corners[j] - corners[i];
      const Point3 u = Cross(along, corners[k] - corners[i]);
      const Point3 v = Cross(along, corners[l] - corners[i]);
      smallest = std::min(smallest, std::atan2(Length(Cross(u, v)), Dot(u, v)) * 57.2957795);
    }
  }
  return smallest;
}

std::string JudgeBody(const BitingBody& mesh, const CheckedSurface& checked,
  const SurfaceCase& surface, bool isCut, double& smallestDihedral)
{
  if (mesh.Corners.empty() || !AreFinite(mesh.Points) ||
    !AreVertices(mesh.Corners, mesh.Points.size()) ||
    mesh.Regions.size() * 4 != mesh.Corners.size())
  {
    return "no body, or vertices that are no places, or are unused";
  }
  if (!AreWithin(mesh.Spacing, mesh.Points.size(), 1e-300, MostShare * surface.LargestSize) ||
    mesh.BiteOrders.size() != mesh.Points.size() ||
    mesh.BoundaryCells.size() * 3 != mesh.Boundary.Corners.size())
  {
    return "arrays of the body have other sizes, or values out of range";
  }
  double volume = 0.0;
  for (std::size_t slot = 0; slot < mesh.Corners.size(); slot += 4)
  {
    const auto at = [&mesh, slot](std::size_t k)
    { return mesh.Points[At(mesh.Corners[slot + k])]; };
    if (Orient3D(at(0), at(1), at(2), at(3)) <= 0)
    {
      return "a tetrahedron is not positive";
    }
    volume += Dot(Cross(at(1) - at(0), at(2) - at(0)), at(3) - at(0)) / 6.0;
    smallestDihedral = std::min(smallestDihedral, SmallestDihedral({ at(0), at(1), at(2), at(3) }));
  }
  std::string facets = JudgeFacets(mesh);
  const SurfaceFigures& figures = checked.Figures;
  const bool isPlain =
    figures.OpenEdges == 0 && figures.NonManifoldEdges == 0 && surface.Values.empty();
  if (isPlain && facets.empty() && surface.Options.MaximumNumberOfBites == 0)
  {
    facets = JudgeSurface(mesh.Boundary, checked, surface, isCut);
  }
  const bool isFilled =
    !isPlain || std::abs(volume - figures.Volume) <= 0.5 * surface.LargestSize * figures.Area;
  const bool isAsMade = surface.Volume < 0.0 ||
    std::abs(volume - surface.Volume) <= 0.5 * surface.LargestSize * figures.Area;
  return (isFilled && isAsMade) || !facets.empty()
    ? facets
    : "volume of the body " + std::to_string(volume) + " for " + std::to_string(figures.Volume) +
      ", made of " + std::to_string(surface.Volume);
}

bool IsSame(const std::vector<Point3>& a, const std::vector<Point3>& b)
{
  return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin());
}

bool IsSame(const BitingSurface& a, const BitingSurface& b)
{
  return IsSame(a.Points, b.Points) && a.Spacing == b.Spacing && a.BiteOrders == b.BiteOrders &&
    a.Kinds == b.Kinds && a.OriginalPoints == b.OriginalPoints && a.Corners == b.Corners &&
    a.Triangles == b.Triangles && a.Regions == b.Regions && a.Deviations == b.Deviations &&
    a.EdgeEnds == b.EdgeEnds && IsSame(a.BiteCenters, b.BiteCenters);
}

bool IsSame(const BitingBody& a, const BitingBody& b)
{
  return IsSame(a.Boundary, b.Boundary) && IsSame(a.Points, b.Points) && a.Spacing == b.Spacing &&
    a.BiteOrders == b.BiteOrders && a.Corners == b.Corners && a.Regions == b.Regions &&
    a.BoundaryCells == b.BoundaryCells && IsSame(a.BiteCenters, b.BiteCenters);
}

/// Meshes, and tells what became of it. `make` takes problems and a monitor, `judge` a mesh and
/// whether edges were cut off.
template <typename Make, typename Judge>
bool RunStage(const Make& make, const Judge& judge, bool isRepeated, BodyOutcome& outcome)
{
  ProblemList problems;
  const auto mesh = make(problems, NoMonitor());
  outcome.Refusal += TextOf(problems, outcome.Violation);
  const bool isMeshed = !problems.HasErrors();
  if (isMeshed)
  {
    outcome.Violation += judge(mesh, problems.Has(ProblemCode::LostFeatures));
  }
  else if (!mesh.Corners.empty())
  {
    outcome.Violation += "a mesh beside an error";
  }
  if (isRepeated)
  {
    ProblemList again;
    MonitorWithThreads threads(4);
    outcome.Violation += IsSame(mesh, make(again, threads)) ? "" : "other bytes of four threads";
  }
  return isMeshed;
}

/// Whether an error of the check leaves it to the mesher.
bool IsMeshable(const ProblemList& checks)
{
  return std::all_of(checks.Groups().begin(), checks.Groups().end(),
    [](const ProblemGroup& group)
    {
      return !IsError(group.Code) || group.Code == ProblemCode::OpenEdges ||
        group.Code == ProblemCode::NonManifoldEdges;
    });
}

} // namespace

BodyOutcome RunSurfaceCase(const SurfaceCase& surface, bool isRepeated)
{
  using Stage = BodyOutcome::Stage;
  BodyOutcome outcome;
  ProblemList checks;
  SurfaceCheckOptions check = surface.Check;
  check.Spacing = surface.IsToFill ? surface.Options.Surface.Spacing : SpacingField();
  CheckedSurface checked = CheckSurface(surface.Input, check, checks, NoMonitor());
  check.Spacing = surface.Options.Surface.Spacing;
  ResolveCrossings(checked, check, checks, NoMonitor());
  outcome.Refusal = TextOf(checks, outcome.Violation);
  outcome.IsClean = !checks.HasErrors() && checks.Groups().empty();
  const bool isThere = checked.Mesh.NumberOfTriangles() > 0; // more than rounding
  if (IsMeshable(checks) && isThere && outcome.Violation.empty())
  {
    BodyMesherOptions options = surface.Options;
    for (const Id cell : checked.Mesh.Cells)
    {
      if (!surface.Values.empty())
      {
        options.Surface.Regions.push_back(surface.Values[At(cell)]);
      }
    }
    outcome.Refusal.clear();
    const bool isMeshed = surface.IsToMesh &&
      RunStage([&](ProblemList& problems, Monitor& monitor)
        { return MakeBitingSurface(checked, options.Surface, problems, monitor); },
        [&](const BitingSurface& mesh, bool isCut)
        { return JudgeSurface(mesh, checked, surface, isCut); },
        isRepeated, outcome);
    const std::string refusal = std::move(outcome.Refusal);
    outcome.Refusal = surface.IsToFill ? "" : refusal;
    const bool isFilled = surface.IsToFill &&
      RunStage([&](ProblemList& problems, Monitor& monitor)
        { return MakeBitingBody(checked, options, problems, monitor); },
        [&](const BitingBody& mesh, bool isCut)
        { return JudgeBody(mesh, checked, surface, isCut, outcome.SmallestDihedral); },
        isRepeated, outcome);
    outcome.Reached = isFilled ? Stage::Filled : isMeshed ? Stage::Meshed : Stage::Refused;
  }
  const Stage wanted = surface.IsToFill ? Stage::Filled : Stage::Meshed;
  if (outcome.Violation.empty() && surface.IsFair && outcome.Reached != wanted &&
    outcome.Refusal.find("vertices") == std::string::npos)
  {
    outcome.Violation = "a fair surface is refused: " + outcome.Refusal;
  }
  return outcome;
}

} // namespace biting
