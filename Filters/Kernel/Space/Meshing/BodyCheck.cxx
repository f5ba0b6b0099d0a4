// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "BodyCheck.h"

#include "../../Predicates/Predicates3.h"
#include "../Boundary/BodySides.h"
#include "../Delaunay/TetMesh.h"
#include "CertifiedSurface.h"
#include "FacetTable.h"

#include <algorithm> // for max, min, sort
#include <array>     // for corners
#include <cmath>     // for abs
#include <utility>   // for move, pairs

namespace biting
{

namespace
{

/// A facet of a tetrahedron as seen from its lowest corner.
struct TetSide
{
  std::array<Id, 3> Corners; ///< the lowest first, away from the tetrahedron
  Id Tet;

  std::pair<Id, Id> Key() const { return std::minmax(this->Corners[1], this->Corners[2]); }

  bool operator<(const TetSide& other) const
  {
    return this->Key() != other.Key() ? this->Key() < other.Key() : this->Tet < other.Tet;
  }
};

class BodyChecker
{
public:
  BodyChecker(const CheckedSurface& surface, const std::vector<TriangleSides>& sides,
    const RelaxedBody& body, Pulse& pulse)
    : Surface(surface)
    , Sides(sides)
    , Body(body)
    , Beats(pulse)
    , Facets(body.Facets, At(body.NumberOnBoundary))
  {
  }

  BodyVerdict Run()
  {
    this->Verdict.CellsBehind.assign(this->Body.Facets.size() / 3, NoId);
    this->CheckSides();
    this->CheckPieces();
    if (this->Verdict.What.empty() &&
      CrossesItself(this->BoundaryPoints(), this->Body.Facets, this->Beats))
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

  std::vector<Point3> BoundaryPoints() const
  {
    const auto begin = this->Body.Points.begin();
    return { begin, begin + this->Body.NumberOnBoundary };
  }

  /// The facets of tetrahedra, corner by corner: each is shared by two of one label, or it is a
  /// facet of the boundary.
  void CheckSides()
  {
    const std::vector<Id>& corners = this->Body.Corners;
    const IdLists tetsAt(this->Body.Points.size(),
      [&corners](const auto& add)
      {
        for (std::size_t corner = 0; corner < corners.size(); ++corner)
        {
          add(corners[corner], static_cast<Id>(corner / 4));
        }
      });
    std::vector<TetSide> sides;
    for (Id vertex = 0; vertex < static_cast<Id>(this->Body.Points.size()); ++vertex)
    {
      sides.clear();
      for (const Id tet : tetsAt[vertex])
      {
        for (const auto& place : TetMesh::FacetCorners)
        {
          const Id* own = &corners[4 * At(tet)];
          const TetSide side{ LowestFirst(own[place[0]], own[place[1]], own[place[2]]), tet };
          if (side.Corners[0] == vertex)
          {
            sides.push_back(side);
          }
        }
      }
      std::sort(sides.begin(), sides.end());
      this->CheckRuns(sides);
      if (tetsAt[vertex].Size() == 0)
      {
        this->Refuse("a vertex without tetrahedra", vertex);
      }
      if (!this->Beats.Beat(64))
      {
        return;
      }
    }
    for (std::size_t facet = 0; facet < this->Verdict.CellsBehind.size(); ++facet)
    {
      if (this->Verdict.CellsBehind[facet] == NoId)
      {
        this->Refuse("a facet without tetrahedra", this->Body.Facets[3 * facet]);
      }
    }
  }

  void CheckRuns(const std::vector<TetSide>& sides)
  {
    std::size_t end = 0;
    for (std::size_t begin = 0; begin < sides.size(); begin = end)
    {
      while (end < sides.size() && sides[end].Key() == sides[begin].Key())
      {
        ++end;
      }
      const std::size_t count = end - begin;
      if (count > 2 || (count == 2 && sides[begin].Corners == sides[begin + 1].Corners))
      {
        this->Refuse("a facet of too many tetrahedra", sides[begin].Corners[0]);
        return;
      }
      const Id label = this->Body.Regions[At(sides[begin].Tet)];
      const Id other = count == 2 ? this->Body.Regions[At(sides[begin + 1].Tet)] : 0;
      const std::array<Id, 3>& corners = sides[begin].Corners;
      const bool isOfBoundary =
        std::max(corners[1], corners[2]) < this->Body.NumberOnBoundary && label != other;
      const Id facet = isOfBoundary ? this->Facets.Find(corners) : NoId;
      if (label != other && facet == NoId)
      {
        this->Refuse("a boundary that is open", corners[0]);
        return;
      }
      if (facet != NoId)
      {
        const TetSide& behind = sides[begin + (IsBehind(label, other) ? 0 : 1)];
        if (behind.Corners != this->Facets.CornersOf(facet) ||
          this->Verdict.CellsBehind[At(facet)] != NoId)
        {
          this->Refuse("a facet that is turned", corners[0]);
        }
        this->Verdict.CellsBehind[At(facet)] = behind.Tet;
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
      const Id a = this->Body.PieceEnds[k];
      const Id b = this->Body.PieceEnds[k + 1];
      if (!std::binary_search(
            edges.begin(), edges.end(), std::pair<Id, Id>(std::min(a, b), std::max(a, b))))
      {
        this->Refuse("a feature line with a gap", a);
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
      const Point3& a = this->Body.Points[At(corners[0])];
      volumes[At(this->Body.Regions[tet])] +=
        Dot(Cross(this->Body.Points[At(corners[1])] - a, this->Body.Points[At(corners[2])] - a),
          this->Body.Points[At(corners[3])] - a) /
        6.0;
    }
    for (std::size_t label = 1; label < given.size(); ++label)
    {
      if (std::abs(volumes[label] - given[label]) > MostShare * std::abs(given[label]))
      {
        this->Refuse("volume " + Figure(volumes[label]) + " in place of " + Figure(given[label]),
          this->VertexOf(static_cast<Id>(label)));
      }
    }
  }

  Id VertexOf(Id label) const
  {
    const auto tet = std::find(this->Body.Regions.begin(), this->Body.Regions.end(), label);
    return tet == this->Body.Regions.end()
      ? 0
      : this->Body.Corners[4 * static_cast<std::size_t>(tet - this->Body.Regions.begin())];
  }

  const CheckedSurface& Surface;
  const std::vector<TriangleSides>& Sides;
  const RelaxedBody& Body;
  Pulse& Beats;
  FacetTable Facets;
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
