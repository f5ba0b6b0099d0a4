// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "EdgeRemoval.h"

#include "../../Base/Numbers.h"
#include "TrialSteps.h"

#include <algorithm> // for find, max

namespace biting
{

bool EdgeRemoval::Improve(Id cell)
{
  std::uint32_t touched = 0;
  for (const Id vertex : this->Tets.CornersOf(cell))
  {
    touched = std::max(touched, this->Tets.Touched[At(vertex)]);
  }
  if (this->Tets.Tried[At(cell)] > touched)
  {
    return false;
  }
  this->Tets.Tried[At(cell)] = ++this->Tets.Clock;
  for (std::size_t edge = 0; edge < 6; ++edge)
  {
    if (this->Remove(cell, edge))
    {
      return true;
    }
  }
  for (Id slot = 4 * cell; slot < 4 * cell + 4; ++slot)
  {
    if (this->Flip(slot))
    {
      return true;
    }
  }
  return false;
}

bool EdgeRemoval::IsPositive(const BodyTets::Tetrahedron& t) const
{
  const TetMesh& mesh = this->Tets.Mesh;
  return Orient3D(mesh.PointAt(t[0]), mesh.PointAt(t[1]), mesh.PointAt(t[2]), mesh.PointAt(t[3])) >
    0;
}

bool EdgeRemoval::Remove(Id cell, std::size_t edge)
{
  if (!this->FindLinks(cell, edge) || (this->NumberOfRecords > 0 && !this->IsInPatch()) ||
    (this->NumberOfLinks == 2 && this->Links[0].Size == 2 && this->Links[1].Size == 2))
  {
    return false;
  }
  for (std::size_t k = 0; k < this->NumberOfLinks; ++k)
  {
    if (!this->Triangulate(this->Links[k], LimitOf(this->Before, this->Tets.IsTrial)))
    {
      return false;
    }
  }
  if (this->NumberOfRecords > 0 && !this->FlipFacets())
  {
    return false;
  }
  for (std::size_t k = 0; k < this->NumberOfLinks; ++k)
  {
    this->Fill(this->Links[k], 0, this->Links[k].Size - 1);
  }
  this->Change.Apply(this->Tets);
  return true;
}

/// Sets the edge, the cells about it and its links. False where it cannot be taken away.
bool EdgeRemoval::FindLinks(Id cell, std::size_t edge)
{
  auto [a, b, p, q] = this->CornersFrom(cell, edge);
  this->A = a;
  this->B = b;
  if (this->Tets.Lines.Between(this->A, this->B) != NoId)
  {
    return false;
  }
  const Id first = this->Rewind(cell, p, q);
  return first != NoId && this->Wind(first, p, q);
}

/// The cell about the edge behind the first facet with a record, going back; the cell itself where
/// there is no such facet; NoId where there are too many cells. (A, B, p, q) are its corners.
Id EdgeRemoval::Rewind(Id cell, Id& p, Id& q) const
{
  Id current = cell;
  for (std::size_t count = 0; count < MostOfLink; ++count)
  {
    const Id slot = this->Tets.SlotOf(current, q);
    if (this->Tets.RecordOf(slot) >= 0)
    {
      return current;
    }
    const Id across = this->Tets.Mesh.Twins[At(slot)];
    current = TetMesh::CellOf(across);
    q = p;
    p = this->Tets.VertexAt(across);
    if (current == cell)
    {
      return current;
    }
  }
  return NoId;
}

/// Collects what is about the edge.
bool EdgeRemoval::Wind(Id first, Id p, Id q)
{
  this->Change.Clear();
  this->NumberOfLinks = 0;
  this->NumberOfRecords = 0;
  this->Before = 0.0;
  const Id begin = this->Tets.RecordOf(this->Tets.SlotOf(first, q));
  if (begin >= 0)
  {
    this->Records[this->NumberOfRecords++] = begin;
  }
  Id current = first;
  bool isEnd = false;
  while (!isEnd)
  {
    if (this->NumberOfLinks == 2)
    {
      return false;
    }
    Link& link = this->Links[this->NumberOfLinks++];
    link.Region = this->Tets.Mesh.Labels[At(current)];
    link.Vertices[0] = p;
    link.Size = 1;
    Id record = NoId;
    while (!isEnd && record < 0)
    {
      if (link.Size == MostOfLink)
      {
        return false;
      }
      this->Change.Cells.push_back(current);
      this->Before = std::max(this->Before, this->Tets.Badness[At(current)]);
      link.Vertices[link.Size++] = q;
      const Id slot = this->Tets.SlotOf(current, p);
      record = this->Tets.RecordOf(slot);
      const Id across = this->Tets.Across(slot);
      current = across == NoId ? NoId : TetMesh::CellOf(across);
      p = q;
      q = across == NoId ? NoId : this->Tets.VertexAt(across);
      isEnd = current == NoId || current == first;
    }
    if (record >= 0 && record != begin)
    {
      if (this->NumberOfRecords == 2)
      {
        return false;
      }
      this->Records[this->NumberOfRecords++] = record;
    }
  }
  // A closed link has come back to its first vertex.
  this->Links[0].Size -= begin < 0 ? 1 : 0;
  return true;
}

/// Finds the best triangulation. False where its worst tetrahedron is not better than the limit.
bool EdgeRemoval::Triangulate(Link& link, double limit)
{
  const std::size_t n = link.Size;
  for (std::size_t i = 0; i + 1 < n; ++i)
  {
    link.Costs[i][i + 1] = -1.0;
  }
  for (std::size_t span = 2; span < n; ++span)
  {
    for (std::size_t i = 0; i + span < n; ++i)
    {
      const std::size_t j = i + span;
      double least = limit;
      for (std::size_t k = i + 1; k < j; ++k)
      {
        const double sides = std::max(link.Costs[i][k], link.Costs[k][j]);
        if (sides < least)
        {
          const double cost = std::max(
            sides, this->Cost({ link.Vertices[i], link.Vertices[k], link.Vertices[j] }, least));
          link.Apexes[i][j] = cost < least ? k : link.Apexes[i][j];
          least = std::min(least, cost);
        }
      }
      link.Costs[i][j] = least < limit ? least : Infinity;
    }
  }
  return link.Costs[0][n - 1] < limit;
}

/// The badness of the worse of the tetrahedra at a triangle of a link; infinite where it is not
/// below the limit, or one is not positive.
double EdgeRemoval::Cost(const std::array<Id, 3>& triangle, double limit) const
{
  const BodyTets::Tetrahedron above{ triangle[0], triangle[1], triangle[2], this->B };
  const BodyTets::Tetrahedron below{ this->A, triangle[0], triangle[1], triangle[2] };
  double cost = this->Tets.BadnessOf(above);
  cost = cost < limit ? std::max(cost, this->Tets.BadnessOf(below)) : cost;
  return cost < limit && this->IsPositive(above) && this->IsPositive(below) ? cost : Infinity;
}

void EdgeRemoval::Fill(const Link& link, std::size_t i, std::size_t j)
{
  if (j < i + 2)
  {
    return;
  }
  const std::size_t k = link.Apexes[i][j];
  const Id p = link.Vertices[i];
  const Id q = link.Vertices[k];
  const Id r = link.Vertices[j];
  this->Change.Filling.push_back({ p, q, r, this->B });
  this->Change.Filling.push_back({ this->A, p, q, r });
  this->Change.Regions.insert(this->Change.Regions.end(), 2, link.Region);
  this->Fill(link, i, k);
  this->Fill(link, k, j);
}

/// The facets (A, B, p) and (B, A, q) become (p, q, B) and (q, p, A). False where that is not
/// allowed.
bool EdgeRemoval::FlipFacets()
{
  const Id p = this->Links[0].Vertices[0];
  const Id q = this->Links[0].Vertices[this->Links[0].Size - 1];
  const Id a = this->A;
  const Id b = this->B;
  const bool isInCell =
    this->Links[0].Size == 2 || (this->NumberOfLinks == 2 && this->Links[1].Size == 2);
  if (this->Tets.Lines.Between(p, q) != NoId || !this->IsNewEdge(p, q, isInCell) ||
    !this->Normals.AllowsFlip({ { { a, b, p }, { b, a, q } } }, { { { p, b, q }, { q, a, p } } }))
  {
    return false;
  }
  this->Change.Facets.push_back({ this->Records[0], { p, b, q } });
  this->Change.Facets.push_back({ this->Records[1], { q, a, p } });
  return true;
}

/// Whether no cell has the edge; with `isInCell`, no facet with a record.
bool EdgeRemoval::IsNewEdge(Id p, Id q, bool isInCell)
{
  for (const Id own : this->Tets.StarOf(p))
  {
    const Id base = own & ~3;
    const BodyTets::Tetrahedron corners = this->Tets.CornersOf(base >> 2);
    const bool has = std::find(corners.begin(), corners.end(), q) != corners.end();
    for (Id slot = base; slot < base + 4 && has; ++slot)
    {
      const Id corner = this->Tets.VertexAt(slot);
      if (!isInCell || (corner != p && corner != q && this->Tets.RecordOf(slot) >= 0))
      {
        return false;
      }
    }
  }
  return true;
}

bool EdgeRemoval::Split(Id cell, std::size_t edge)
{
  const bool goes = this->FindLinks(cell, edge) &&
    (this->NumberOfRecords == 0 || this->IsInPatch()) && this->FillFromInside();
  if (goes)
  {
    this->Change.Apply(this->Tets);
  }
  return goes;
}

/// Whether there are two facets at the edge, which is no piece: they lie in one patch.
bool EdgeRemoval::IsInPatch() const
{
  return this->NumberOfRecords == 2 &&
    this->Tets.IsInterface(this->Records[0]) == this->Tets.IsInterface(this->Records[1]) &&
    this->NumberOfLinks == (this->Tets.IsInterface(this->Records[0]) ? 2u : 1u);
}

/// Looks for the place of a new vertex at which the worst of the halves of the cells about the edge
/// is best, from the middle of the edge on; between facets it is the place on the ground below the
/// middle.
bool EdgeRemoval::FillFromInside()
{
  const Point3& a = this->Tets.Mesh.PointAt(this->A);
  const Point3& b = this->Tets.Mesh.PointAt(this->B);
  const double length = Distance(a, b);
  const double size =
    0.5 * (this->Tets.Body.Sizes[At(this->A)] + this->Tets.Body.Sizes[At(this->B)]);
  if (length < 0.5 * size) // else flat parts are split without end
  {
    return false;
  }
  const bool isOnFacets = this->NumberOfRecords > 0;
  GroundPlace best{ NoId, Midpoint(a, b) };
  best = isOnFacets ? this->Normals.ProjectOnFacet(this->Records[0], best.Place) : best;
  this->Fresh = this->Fresh == NoId ? this->Tets.AddVertex() : this->Fresh;
  this->FillAround(this->Fresh);
  double worst = this->WorstOfFilling(best.Place, 1.0);
  TryInSteps(isOnFacets ? 0.0 : 0.1 * length, 0.01 * length,
    [this, &best, &worst](const Point3& step)
    {
      const Point3 place = best.Place + step;
      const double tried = this->WorstOfFilling(place, worst - LeastGain);
      const bool goes = tried < worst;
      best.Place = goes ? place : best.Place;
      worst = std::min(worst, tried);
      return goes;
    });
  if (!(worst < LimitOf(this->Before, this->Tets.IsTrial)) ||
    (isOnFacets && !this->SplitFacets(best)))
  {
    return false;
  }
  this->Tets.Mesh.Points[At(this->Fresh)] = best.Place;
  this->Tets.Body.Sizes[At(this->Fresh)] = size;
  this->Tets.Body.BoundaryPlaces.resize(this->Tets.Body.Sizes.size(), NoId);
  this->Tets.Body.BoundaryPlaces[At(this->Fresh)] = best.Triangle;
  this->Tets.Kinds[At(this->Fresh)] = isOnFacets ? BodyTets::Kind::OnPatch : BodyTets::Kind::Inside;
  this->Fresh = NoId;
  return true;
}

/// Sets the halves of the cells about the edge.
void EdgeRemoval::FillAround(Id vertex)
{
  for (std::size_t side = 0; side < this->NumberOfLinks; ++side)
  {
    const Link& link = this->Links[side];
    const std::size_t cells = link.Size - (this->NumberOfRecords > 0 ? 1 : 0);
    for (std::size_t k = 0; k < cells; ++k)
    {
      const Id p = link.Vertices[k];
      const Id q = link.Vertices[(k + 1) % link.Size];
      this->Change.Filling.push_back({ this->A, vertex, p, q });
      this->Change.Filling.push_back({ vertex, this->B, p, q });
    }
    this->Change.Regions.insert(this->Change.Regions.end(), 2 * cells, link.Region);
  }
}

/// The badness of the worst of the halves with the new vertex there; infinite where it is not below
/// the limit, or one is not positive.
double EdgeRemoval::WorstOfFilling(const Point3& place, double limit)
{
  this->Tets.Mesh.Points[At(this->Fresh)] = place;
  double worst = 0.0;
  for (const BodyTets::Tetrahedron& t : this->Change.Filling)
  {
    worst = std::max(worst, this->Tets.BadnessOf(t));
    if (!(worst < limit) || !this->IsPositive(t))
    {
      return Infinity;
    }
  }
  return worst;
}

/// Sets the halves of the facets. False where the ground does not allow them.
bool EdgeRemoval::SplitFacets(const GroundPlace& place)
{
  const Link& link = this->Links[0];
  const Id ends[2] = { link.Vertices[0], link.Vertices[link.Size - 1] };
  std::vector<GroundNormals::FacetChange> changes;
  for (std::size_t k = 0; k < 2; ++k)
  {
    const std::array<Id, 3> corners{ k == 0 ? this->A : this->B, k == 0 ? this->B : this->A,
      ends[k] };
    changes.push_back({ this->Records[k], corners, this->A });
    changes.push_back({ this->Records[k], corners, this->B });
  }
  if (!this->Normals.AllowsChange(changes, NoId, place))
  {
    return false;
  }
  for (std::size_t k = 0; k < 2; ++k)
  {
    this->Change.Facets.push_back({ this->Records[k], { this->A, this->Fresh, ends[k] } });
    this->Change.Facets.push_back(
      { this->Tets.AddRecord(this->Records[k]), { this->Fresh, this->B, ends[k] } });
  }
  return true;
}

bool EdgeRemoval::Flip(Id slot)
{
  const Id twin = this->Tets.Mesh.Twins[At(slot)];
  if (twin < 0)
  {
    return false;
  }
  const Id d = this->Tets.VertexAt(slot);
  const Id e = this->Tets.VertexAt(twin);
  const double limit =
    LimitOf(std::max(this->Tets.Badness[At(slot >> 2)], this->Tets.Badness[At(twin >> 2)]),
      this->Tets.IsTrial);
  this->Change.Clear();
  for (int k = 0; k < 3; ++k)
  {
    const BodyTets::Tetrahedron filling{ d, e, this->Tets.Mesh.FacetCorner(slot, k),
      this->Tets.Mesh.FacetCorner(slot, (k + 1) % 3) };
    if (!(this->Tets.BadnessOf(filling) < limit) || !this->IsPositive(filling))
    {
      return false;
    }
    this->Change.Filling.push_back(filling);
  }
  this->Change.Cells = { slot >> 2, twin >> 2 };
  this->Change.Regions.assign(3, this->Tets.Mesh.Labels[At(slot >> 2)]);
  this->Change.Apply(this->Tets);
  return true;
}

} // namespace biting
