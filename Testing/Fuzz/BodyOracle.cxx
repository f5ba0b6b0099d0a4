// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "BodyOracle.h"

#include "Predicates/Predicates3.h"

#include <algorithm> // for all_of, binary_search, count, min, remove_if, rotate, sort
#include <array>     // for facets
#include <cmath>     // for angles
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
    text += "code " + std::to_string(static_cast<int>(group.Code)) + " " + first.Detail + "; ";
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

/// Of an input without edges that are open or have more than two triangles.
std::string JudgeSurface(
  const BitingSurface& mesh, const CheckedSurface& checked, const SurfaceCase& surface)
{
  if (mesh.Corners.empty() || !AreFinite(mesh.Points) ||
    !AreVertices(mesh.Corners, mesh.Points.size()))
  {
    return "no surface, or vertices that are no places, or are unused";
  }
  std::vector<Edge> edges;
  for (std::size_t slot = 0; slot < mesh.Corners.size(); ++slot)
  {
    edges.push_back({ mesh.Corners[slot], mesh.Corners[slot % 3 == 2 ? slot - 2 : slot + 1] });
  }
  std::sort(edges.begin(), edges.end());
  const SurfaceFigures& figures = checked.Figures;
  const bool isPlain = figures.OpenEdges == 0 && figures.NonManifoldEdges == 0;
  if (!isPlain)
  {
    return {};
  }
  for (std::size_t k = 0; k < edges.size(); ++k)
  {
    if ((k > 0 && edges[k] == edges[k - 1]) ||
      !std::binary_search(edges.begin(), edges.end(), Edge{ edges[k][1], edges[k][0] }))
    {
      return "the surface is not closed";
    }
  }
  const auto euler = static_cast<std::int64_t>(mesh.Points.size()) -
    static_cast<std::int64_t>(edges.size() / 2) +
    static_cast<std::int64_t>(mesh.Corners.size() / 3);
  if (euler != figures.EulerNumber)
  {
    return "Euler number " + std::to_string(euler) + " for " + std::to_string(figures.EulerNumber);
  }
  const double volume = Volume(mesh.Points, mesh.Corners, mesh.Points.front());
  return std::abs(volume - figures.Volume) <= 0.5 * surface.LargestSize * figures.Area
    ? ""
    : "volume " + std::to_string(volume) + " for " + std::to_string(figures.Volume);
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
  const SurfaceCase& surface, double& smallestDihedral)
{
  if (mesh.Corners.empty() || !AreFinite(mesh.Points) ||
    !AreVertices(mesh.Corners, mesh.Points.size()) ||
    mesh.Regions.size() * 4 != mesh.Corners.size())
  {
    return "no body, or vertices that are no places, or are unused";
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
  const std::string facets = JudgeFacets(mesh);
  const SurfaceFigures& figures = checked.Figures;
  const bool isPlain =
    figures.OpenEdges == 0 && figures.NonManifoldEdges == 0 && surface.Values.empty();
  const bool isFilled =
    !isPlain || std::abs(volume - figures.Volume) <= 0.5 * surface.LargestSize * figures.Area;
  return isFilled || !facets.empty()
    ? facets
    : "volume of the body " + std::to_string(volume) + " for " + std::to_string(figures.Volume);
}

} // namespace

BodyOutcome RunSurfaceCase(const SurfaceCase& surface)
{
  BodyOutcome outcome;
  ProblemList checks;
  const CheckedSurface checked = CheckSurface(surface.Input, surface.Check, checks, NoMonitor());
  outcome.Refusal = TextOf(checks, outcome.Violation);
  bool isMeshable = true;
  for (const ProblemGroup& group : checks.Groups())
  {
    isMeshable = isMeshable &&
      (!IsError(group.Code) || group.Code == ProblemCode::OpenEdges ||
        group.Code == ProblemCode::NonManifoldEdges);
  }
  if (isMeshable && outcome.Violation.empty())
  {
    BodyMesherOptions options = surface.Options;
    for (const Id cell : checked.Mesh.Cells)
    {
      if (!surface.Values.empty())
      {
        options.Surface.Regions.push_back(surface.Values[At(cell)]);
      }
    }
    ProblemList ofSurface;
    const BitingSurface mesh = MakeBitingSurface(checked, options.Surface, ofSurface, NoMonitor());
    outcome.Refusal = TextOf(ofSurface, outcome.Violation);
    const bool isMeshed = !ofSurface.HasErrors();
    const std::string wrong = !isMeshed ? "" : JudgeSurface(mesh, checked, surface);
    ProblemList ofBody;
    const BitingBody body = MakeBitingBody(checked, options, ofBody, NoMonitor());
    const std::string refusal = TextOf(ofBody, outcome.Violation);
    outcome.Refusal += refusal;
    const bool isFilled = !ofBody.HasErrors();
    const std::string wrongBody =
      !isFilled ? "" : JudgeBody(body, checked, surface, outcome.SmallestDihedral);
    outcome.Violation += wrong + wrongBody;
    outcome.Reached = isFilled ? BodyOutcome::Stage::Filled
      : isMeshed               ? BodyOutcome::Stage::Meshed
                               : BodyOutcome::Stage::Refused;
    if ((!isMeshed && !mesh.Corners.empty()) || (!isFilled && !body.Corners.empty()))
    {
      outcome.Violation = "a mesh beside an error";
    }
  }
  if (outcome.Violation.empty() && surface.IsFair &&
    outcome.Reached != BodyOutcome::Stage::Filled &&
    outcome.Refusal.find("vertices") == std::string::npos)
  {
    outcome.Violation = "a fair surface is refused: " + outcome.Refusal;
  }
  return outcome;
}

} // namespace biting
