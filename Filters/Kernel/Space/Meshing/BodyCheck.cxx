// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "BodyCheck.h"

#include "../../Predicates/Predicates3.h"
#include "../Boundary/BodySides.h"
#include "../Delaunay/TetMesh.h"
#include "CertifiedSurface.h"
#include "FacetTable.h"

#include <algorithm> // for find, max, min, sort
#include <array>     // for corners
#include <cmath>     // for abs
#include <cstdint>   // for marks
#include <utility>   // for move, pairs

namespace biting
{

namespace
{

class BodyChecker
{
public:
  BodyChecker(const CheckedSurface& surface, const std::vector<TriangleSides>& sides,
    const RelaxedBody& body, Pulse& pulse)
    : Surface(surface)
    , Sides(sides)
    , Body(body)
    , Beats(pulse)
  {
  }

  BodyVerdict Run()
  {
    this->Verdict.CellsBehind.assign(this->Body.Facets.size() / 3, NoId);
    this->CheckSides();
    this->CheckPieces();
    const auto begin = this->Body.Points.begin();
    if (this->Verdict.What.empty() &&
      CrossesItself({ begin, begin + this->Body.NumberOnBoundary }, this->Body.Facets, this->Beats))
    {
      this->Refuse("a boundary that crosses itself", this->Body.Facets[0]);
    }
    this->Verdict.IsCoarse = this->Verdict.What.empty();
    this->CheckVolumes();
    return std::move(this->Verdict);
  }

private:
  void Refuse(std::string what, Id vertex)
  {
    if (this->Verdict.What.empty())
    {
      this->Verdict.What = std::move(what);
      this->Verdict.Place = this->Body.Points[At(vertex)];
    }
  }

  /// The facets of tetrahedra: each is shared by two of one label, or it is a facet of the
  /// boundary.
  void CheckSides()
  {
    const std::vector<Id>& twins = this->Body.Twins;
    std::vector<Id> front(this->Verdict.CellsBehind.size(), NoId);
    std::vector<std::uint8_t> isUsed(this->Body.Points.size(), 0);
    for (Id side = 0; side < static_cast<Id>(twins.size()) && this->Beats.Beat(1); ++side)
    {
      isUsed[At(this->Body.Corners[At(side)])] = 1;
      const Id twin = twins[At(side)];
      const std::array<Id, 3> own = this->CornersOf(side);
      if (twin >= 0 && twin < static_cast<Id>(twins.size()))
      {
        const std::array<Id, 3> other = this->CornersOf(twin);
        const bool isSame =
          twins[At(twin)] == side && own[0] == other[0] && own[1] == other[2] && own[2] == other[1];
        if (!isSame || this->Body.Regions[At(side / 4)] != this->Body.Regions[At(twin / 4)])
        {
          this->Refuse(isSame ? "a boundary that is open" : "tetrahedra that do not fit", own[0]);
        }
        continue;
      }
      const Id facet = RelaxedBody::CodeOf(twin);
      if (facet < 0 || facet >= static_cast<Id>(front.size()))
      {
        this->Refuse("a boundary that is open", own[0]);
        continue;
      }
      const Id* corners = &this->Body.Facets[3 * At(facet)];
      const std::array<Id, 3> given = LowestFirst(corners[0], corners[1], corners[2]);
      Id& tet = (given == own ? this->Verdict.CellsBehind : front)[At(facet)];
      const bool isTurned = given[0] == own[0] && given[1] == own[2] && given[2] == own[1];
      if (tet != NoId || (given != own && !isTurned))
      {
        this->Refuse("a facet of too many tetrahedra", own[0]);
      }
      tet = side / 4;
    }
    this->CheckFacets(front);
    const auto unused = std::find(isUsed.begin(), isUsed.end(), 0);
    if (unused != isUsed.end())
    {
      this->Refuse("a vertex without tetrahedra", static_cast<Id>(unused - isUsed.begin()));
    }
  }

  std::array<Id, 3> CornersOf(Id side) const
  {
    const Id* own = &this->Body.Corners[4 * At(side / 4)];
    const auto& place = TetMesh::FacetCorners[side % 4];
    return LowestFirst(own[place[0]], own[place[1]], own[place[2]]);
  }

  /// `front`: the tetrahedra in front of facets.
  void CheckFacets(const std::vector<Id>& front)
  {
    for (std::size_t facet = 0; facet < front.size(); ++facet)
    {
      const Id behind = this->Verdict.CellsBehind[facet];
      const Id other = front[facet] == NoId ? 0 : this->Body.Regions[At(front[facet])];
      if (behind == NoId || !IsBehind(this->Body.Regions[At(behind)], other))
      {
        this->Refuse("a facet that is turned", this->Body.Facets[3 * facet]);
      }
    }
  }

  void CheckPieces()
  {
    std::vector<std::pair<Id, Id>> edges;
    const std::vector<Id>& facets = this->Body.Facets;
    edges.reserve(facets.size());
    for (std::size_t slot = 0; slot < facets.size(); ++slot)
    {
      const Id next = facets[NextSlotOf(slot)];
      if (facets[slot] < this->Body.NumberOnLines && next < this->Body.NumberOnLines)
      {
        edges.push_back(std::minmax(facets[slot], next));
      }
    }
    std::sort(edges.begin(), edges.end());
    for (std::size_t k = 0; k < this->Body.PieceEnds.size(); k += 2)
    {
      const std::pair<Id, Id> edge =
        std::minmax(this->Body.PieceEnds[k], this->Body.PieceEnds[k + 1]);
      if (!std::binary_search(edges.begin(), edges.end(), edge))
      {
        this->Refuse("a feature line with a gap", edge.first);
      }
    }
  }

  void CheckVolumes()
  {
    constexpr double MostShare = 0.15; // coarse meshes of round bodies lose some
    std::vector<double> given;
    const Point3 origin = this->Body.Points.front();
    const auto add = [&given](Id label, double volume)
    {
      given.resize(std::max(given.size(), At(label) + 1), 0.0);
      given[At(label)] += volume;
    };
    for (std::size_t t = 0; t < this->Sides.size(); ++t)
    {
      const std::array<Point3, 3> p = this->Surface.Mesh.Triangle(t);
      const double volume = Dot(p[0] - origin, Cross(p[1] - origin, p[2] - origin)) / 6.0;
      add(this->Sides[t][0], volume);
      add(this->Sides[t][1], -volume);
    }
    std::vector<double> volumes(given.size(), 0.0);
    for (std::size_t tet = 0; tet < this->Body.Regions.size(); ++tet)
    {
      const Id* corners = &this->Body.Corners[4 * tet];
      const auto edge = [this, corners](std::size_t k)
      { return this->Body.Points[At(corners[k])] - this->Body.Points[At(corners[0])]; };
      volumes[At(this->Body.Regions[tet])] += Dot(Cross(edge(1), edge(2)), edge(3)) / 6.0;
    }
    const std::vector<Id>& regions = this->Body.Regions;
    for (std::size_t label = 1; label < given.size(); ++label)
    {
      if (std::abs(volumes[label] - given[label]) > MostShare * std::abs(given[label]))
      {
        const auto tet = std::find(regions.begin(), regions.end(), static_cast<Id>(label));
        this->Refuse("the mesh of this body has volume " + Figure(volumes[label]) + ", not " +
            Figure(given[label]),
          tet == regions.end() ? 0 : *(this->Body.Corners.begin() + 4 * (tet - regions.begin())));
      }
    }
  }

  const CheckedSurface& Surface;
  const std::vector<TriangleSides>& Sides;
  const RelaxedBody& Body;
  Pulse& Beats;
  BodyVerdict Verdict;
};

} // namespace

BodyVerdict CheckBody(const CheckedSurface& surface, const std::vector<TriangleSides>& sides,
  const RelaxedBody& body, Pulse& pulse)
{
  return BodyChecker(surface, sides, body, pulse).Run();
}

Id FindNotPositive(const std::vector<Point3>& points, const std::vector<Id>& corners, Pulse& pulse)
{
  for (std::size_t slot = 0; slot < corners.size() && pulse.Beat(); slot += 4)
  {
    if (Orient3D(points[At(corners[slot])], points[At(corners[slot + 1])],
          points[At(corners[slot + 2])], points[At(corners[slot + 3])]) <= 0)
    {
      return static_cast<Id>(slot / 4);
    }
  }
  return NoId;
}

} // namespace biting
