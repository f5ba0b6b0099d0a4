// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "VertexMoves.h"

#include "TrialSteps.h"

#include <algorithm> // for any_of, find, max, minmax, remove_if, set_intersection
#include <iterator>  // for back_inserter

namespace biting
{

/// Adds the cells of the vertex that do not have the other one.
void VertexMoves::GatherBut(Id vertex, Id other)
{
  for (const Id slot : this->Tets.StarOf(vertex))
  {
    const std::array<Id, 3> c = this->Tets.FacetCorners(slot);
    if (std::find(c.begin(), c.end(), other) == c.end())
    {
      const double badness = this->Tets.Badness[At(slot >> 2)];
      const auto at = [this, &c](std::size_t k) { return this->Tets.Mesh.PointAt(c[k]); };
      this->Star.push_back({ badness, badness, slot, at(0), at(1), at(2) });
    }
  }
}

/// The badness of the worst of the star with the vertex there. Infinite where one is not positive,
/// or not below the limit; or the worst is not by LeastGain, and the load is not below MostLoad.
double VertexMoves::WorstAt(const Point3& place, double limit)
{
  double worst = 0.0;
  for (Cone& cone : this->Star)
  {
    cone.Tried = TetShape(place, cone.A, cone.B, cone.C).Badness();
    if (!(cone.Tried < limit))
    {
      return Infinity;
    }
    worst = std::max(worst, cone.Tried);
  }
  for (const Cone& cone : this->Star)
  {
    if (Orient3D(place, cone.A, cone.B, cone.C) <= 0)
    {
      return Infinity;
    }
  }
  return this->MostLoad == Infinity || worst < limit - LeastGain ||
      this->Load(&Cone::Tried) < this->MostLoad
    ? worst
    : Infinity;
}

/// The sum of the 16th powers of badness: about what the worst have, but it falls, too, where some
/// of several equally bad ones get better.
double VertexMoves::Load(double Cone::*badness) const
{
  double sum = 0.0;
  for (const Cone& cone : this->Star)
  {
    const double fourth = (cone.*badness) * (cone.*badness) * (cone.*badness) * (cone.*badness);
    sum += fourth * fourth * fourth * fourth;
  }
  return sum;
}

void VertexMoves::Move(Id vertex, const Point3& place)
{
  const RelaxedBody& body = this->Tets.Body;
  Point3& old = this->Tets.Mesh.Points[At(vertex)];
  if (this->Tets.Log != nullptr)
  {
    this->Tets.Log->emplace_back();
    CellChange& change = this->Tets.Log->back();
    change.Vertex = vertex;
    change.Place = old;
    change.Size = body.Sizes[At(vertex)];
    change.Triangle = this->Tets.Kinds[At(vertex)] == BodyTets::Kind::Inside
      ? NoId
      : body.BoundaryPlaces[At(vertex)];
  }
  old = place;
  ++this->Tets.Clock;
  for (Cone& cone : this->Star)
  {
    cone.Badness = cone.Tried;
    this->Tets.Badness[At(cone.Slot >> 2)] = cone.Tried;
    for (const Id corner : this->Tets.CornersOf(cone.Slot >> 2))
    {
      this->Tets.Touched[At(corner)] = this->Tets.Clock;
    }
  }
}

/// Moves the vertex there, or to the nearest place of its patch, if that suits.
bool VertexMoves::Try(Id vertex, const Point3& place, double limit)
{
  const bool isInside = this->Tets.Kinds[At(vertex)] == BodyTets::Kind::Inside;
  const GroundPlace there =
    isInside ? GroundPlace{ NoId, place } : this->Normals.Project(vertex, place);
  const bool suits = this->WorstAt(there.Place, limit) < Infinity &&
    (isInside || this->Normals.AllowsMove(vertex, there));
  if (suits)
  {
    this->Move(vertex, there.Place);
  }
  if (suits && isInside)
  {
    this->Tets.Body.Sizes[At(vertex)] = this->Size(place);
  }
  else if (suits)
  {
    this->Normals.Move(vertex, there);
  }
  return suits;
}

bool VertexMoves::Smooth(Id vertex, double good)
{
  const bool isInside = this->Tets.Kinds[At(vertex)] == BodyTets::Kind::Inside;
  const Point3 old = this->Tets.Mesh.PointAt(vertex);
  this->Star.clear();
  this->GatherBut(vertex, NoId);
  const Point3 way = isInside ? this->WayInside(old) : this->WayOnGround(vertex);
  double worst = 0.0;
  for (const Cone& cone : this->Star)
  {
    worst = std::max(worst, cone.Badness);
  }
  for (const double share : { 1.0, 0.5 })
  {
    if (this->Try(vertex, old + share * way, std::max(worst, good)))
    {
      return true;
    }
  }
  return false;
}

/// To the mean of the centres of spheres, weighted by volume / f^3.
Point3 VertexMoves::WayInside(const Point3& place) const
{
  const std::vector<double>& sizes = this->Tets.Body.Sizes;
  Point3 sum{};
  double mass = 0.0;
  for (const Cone& cone : this->Star)
  {
    const TetShape shape(place, cone.A, cone.B, cone.C);
    const Id* c = &this->Tets.Mesh.Corners[At(cone.Slot & ~3)];
    const double size = sizes[At(c[0])] + sizes[At(c[1])] + sizes[At(c[2])] + sizes[At(c[3])];
    const double density = 1.0 / (size * size * size);
    sum = sum + density * shape.WeightedCenter();
    mass += 2.0 * density * shape.SixVolumes();
  }
  return mass > 0.0 ? (1.0 / mass) * sum : Point3{};
}

/// To the mean of the middles of facets, weighted by area / f^4.
Point3 VertexMoves::WayOnGround(Id vertex) const
{
  Point3 sum{};
  double mass = 0.0;
  for (const Id slot : this->Tets.FacetsAt(vertex))
  {
    const std::array<Id, 3> c = this->Tets.FacetCorners(slot);
    const auto at = [this, &c](std::size_t k) { return this->Tets.Mesh.PointAt(c[k]); };
    const std::vector<double>& sizes = this->Tets.Body.Sizes;
    const double size = sizes[At(c[0])] + sizes[At(c[1])] + sizes[At(c[2])];
    const double own = Length(Cross(at(1) - at(0), at(2) - at(0))) / (size * size * size * size);
    sum = sum + (own / 3.0) * (at(0) + at(1) + at(2));
    mass += own;
  }
  return mass > 0.0 ? (1.0 / mass) * sum - this->Tets.Mesh.PointAt(vertex) : Point3{};
}

bool VertexMoves::Improve(Id vertex, double good)
{
  constexpr int MostMoves = 64; // more than good places take; where none is good it ends there
  if ((this->Tets.Kinds[At(vertex)] == BodyTets::Kind::OnLine && !this->Normals.Slides(vertex)) ||
    this->Tets.TriedMoves[At(vertex)] > this->Tets.Touched[At(vertex)] ||
    this->Tets.NumberOfMoves[At(vertex)] >= MostMoves)
  {
    return false;
  }
  this->Tets.NumberOfMoves[At(vertex)] += this->Tets.Log == nullptr ? 1 : 0;
  this->Star.clear();
  this->GatherBut(vertex, NoId);
  const auto isWorse = [](const Cone& a, const Cone& b) { return a.Badness > b.Badness; };
  std::sort(this->Star.begin(), this->Star.end(), isWorse);
  const double before = this->Worst();
  const double size = this->Tets.Body.Sizes[At(vertex)];
  constexpr double LeastFall = 1e-3;
  constexpr double Rounding = 1e-12;
  this->MostLoad = (1.0 - LeastFall) * this->Load(&Cone::Badness);
  TryInSteps(0.2 * size, 0.008 * size,
    [this, vertex, good, &isWorse](const Point3& step)
    {
      const bool goes = this->Worst() > good &&
        this->Try(vertex, this->Tets.Mesh.PointAt(vertex) + step, this->Worst() + Rounding);
      if (goes)
      {
        std::sort(this->Star.begin(), this->Star.end(), isWorse);
        this->MostLoad = (1.0 - LeastFall) * this->Load(&Cone::Badness);
      }
      return goes;
    });
  this->MostLoad = Infinity;
  this->Tets.TriedMoves[At(vertex)] = this->Worst() > good ? ++this->Tets.Clock : 0;
  return this->Worst() < before - LeastGain;
}

bool VertexMoves::Merge(Id vertex, Id other)
{
  const BodyTets::Kind kind = this->Tets.Kinds[At(vertex)];
  const bool isInside = kind == BodyTets::Kind::Inside;
  this->Change.Clear();
  if (!isInside && !this->FindFacets(vertex, other))
  {
    return false;
  }
  double before = 0.0;
  for (const Id slot : this->Tets.StarOf(vertex))
  {
    this->Change.Cells.push_back(slot >> 2);
    before = std::max(before, this->Tets.Badness[At(slot >> 2)]);
  }
  this->Star.clear();
  this->GatherBut(vertex, other);
  const std::size_t fillings = this->Star.size();
  const bool isFree = isInside && this->Tets.Kinds[At(other)] == BodyTets::Kind::Inside;
  Point3 place = this->Tets.Mesh.PointAt(other);
  if (isFree)
  {
    this->GatherBut(other, vertex);
    place = Midpoint(place, this->Tets.Mesh.PointAt(vertex));
  }
  double worst = this->WorstAt(place, 1.0);
  const double size = this->Tets.Body.Sizes[At(other)];
  TryInSteps(isFree ? 0.1 * size : 0.0, 0.01 * size,
    [this, &place, &worst](const Point3& step)
    {
      const double tried = this->WorstAt(place + step, worst - LeastGain);
      const bool goes = tried < worst;
      place = goes ? place + step : place;
      worst = std::min(worst, tried);
      return goes;
    });
  if (!(this->WorstAt(place, LimitOf(before, this->Tets.IsTrial)) < Infinity) ||
    (!isInside && !this->IsMergeable(vertex, other)))
  {
    return false;
  }
  if (kind == BodyTets::Kind::OnLine)
  {
    this->Join(vertex, this->Tets.Lines.Between(vertex, other));
  }
  for (std::size_t k = 0; k < fillings; ++k)
  {
    const Id slot = this->Star[k].Slot;
    BodyTets::Tetrahedron corners = this->Tets.CornersOf(slot >> 2);
    corners[At(slot & 3)] = other;
    this->Change.Filling.push_back(corners);
    this->Change.Regions.push_back(this->Tets.Mesh.Labels[At(slot >> 2)]);
  }
  this->Move(other, place);
  this->Change.Apply(this->Tets);
  return true;
}

void VertexMoves::Join(Id vertex, Id gone)
{
  this->Tets.Lines.Join(vertex, gone);
  if (this->Tets.Log != nullptr)
  {
    this->Tets.Log->emplace_back();
    this->Tets.Log->back().Vertex = vertex;
    this->Tets.Log->back().Piece = gone;
  }
}

void VertexMoves::TakeBack()
{
  const std::vector<CellChange> log = std::move(*this->Tets.Log);
  this->Tets.Log = nullptr;
  for (auto change = log.rbegin(); change != log.rend(); ++change)
  {
    const Id vertex = change->Vertex;
    if (vertex == NoId)
    {
      CellChange(*change).Apply(this->Tets);
      continue;
    }
    if (change->Piece != NoId)
    {
      this->Tets.Lines.Join(vertex, change->Piece);
      continue;
    }
    if (change->Triangle != NoId)
    {
      this->Normals.Move(vertex, { change->Triangle, change->Place });
    }
    this->Tets.Mesh.Points[At(vertex)] = change->Place;
    this->Tets.Body.Sizes[At(vertex)] = change->Size;
    ++this->Tets.Clock;
    for (const Id slot : this->Tets.StarOf(vertex))
    {
      for (const Id corner : this->Tets.CornersOf(slot >> 2))
      {
        this->Tets.Touched[At(corner)] = this->Tets.Clock;
      }
      this->Tets.Badness[At(slot >> 2)] = this->Tets.BadnessOf(this->Tets.CornersOf(slot >> 2));
    }
  }
}

/// Sets the facets of a vertex of the boundary that become others, or go, where it goes along an
/// edge of two facets and more to `other`, on its chain or patch. False where it may not.
bool VertexMoves::FindFacets(Id vertex, Id other)
{
  const std::array<Id, 2> pieces = this->Tets.Lines.PiecesOf(vertex);
  const Id piece = this->Tets.Lines.Between(vertex, other);
  if (this->Tets.Kinds[At(other)] == BodyTets::Kind::Inside ||
    (this->Tets.Kinds[At(vertex)] == BodyTets::Kind::OnLine &&
      (pieces[0] == NoId || piece == NoId)))
  {
    return false;
  }
  if (piece != NoId)
  {
    const Id end = this->Tets.Lines.OtherEnd(pieces[0] == piece ? pieces[1] : pieces[0], vertex);
    if (end == other || this->Tets.Lines.Between(end, other) != NoId)
    {
      return false;
    }
  }
  this->Facets.clear();
  std::size_t gone = 0;
  for (const Id slot : this->Tets.FacetsAt(vertex))
  {
    const Id record = this->Tets.RecordOf(slot);
    std::array<Id, 3> corners = this->Tets.FacetCorners(slot);
    const bool goes = std::find(corners.begin(), corners.end(), other) != corners.end();
    gone += goes ? 1 : 0;
    if (!goes)
    {
      this->Facets.push_back({ record, corners, vertex });
    }
    std::replace(corners.begin(), corners.end(), vertex, goes ? NoId : other);
    this->Change.Facets.push_back(
      { record, goes ? std::array<Id, 3>{ NoId, NoId, NoId } : corners });
  }
  return gone > 1;
}

/// What is at a vertex but not at the other one, or at the edge between them: edges opposite, as
/// pairs of vertices, and vertices, as pairs of the same; those on facets with records once more,
/// with a 1.
void VertexMoves::FindLink(Id vertex, Id other, bool isAtEdge, std::vector<LinkItem>& link)
{
  link.clear();
  const auto add = [&link](Id a, Id b, Id isOnFacet)
  {
    const auto [low, high] = std::minmax(a, b);
    link.insert(link.end(), { { low, high, isOnFacet }, { a, a, isOnFacet }, { b, b, isOnFacet } });
  };
  for (const Id own : this->Tets.StarOf(vertex))
  {
    const std::array<Id, 3> c = this->Tets.FacetCorners(own);
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Id next = c[(k + 1) % 3];
      const Id last = c[(k + 2) % 3];
      const auto isFacet = [this, own](Id beyond)
      { return this->Tets.RecordOf(this->Tets.SlotOf(own >> 2, beyond)) >= 0; };
      if (isAtEdge && c[k] != other)
      {
        continue;
      }
      add(next, last, 0);
      if (isFacet(isAtEdge ? last : c[k]))
      {
        add(next, isAtEdge ? next : last, 1);
      }
      if (isAtEdge && isFacet(next))
      {
        add(last, last, 1);
      }
    }
  }
  const auto isOther = [other](const LinkItem& i) { return i[0] == other || i[1] == other; };
  link.erase(std::remove_if(link.begin(), link.end(), isOther), link.end());
  std::sort(link.begin(), link.end());
  link.erase(std::unique(link.begin(), link.end()), link.end());
}

/// Whether the mesh stays one, with its boundary: all that is at both vertices is at the edge
/// between them (link condition, T. Dey et al., "Topology preserving edge contraction", 1999).
bool VertexMoves::IsMergeable(Id vertex, Id other)
{
  this->FindLink(vertex, other, false, this->Links[0]);
  this->FindLink(other, vertex, false, this->Links[1]);
  this->FindLink(vertex, other, true, this->Links[2]);
  std::vector<LinkItem>& both = this->Links[3];
  both.clear();
  std::set_intersection(this->Links[0].begin(), this->Links[0].end(), this->Links[1].begin(),
    this->Links[1].end(), std::back_inserter(both));
  return both == this->Links[2] && this->Normals.AllowsMerge(this->Facets, vertex, other);
}

} // namespace biting
