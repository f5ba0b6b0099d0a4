// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Welding.h"

#include "../Base/SortInSteps.h"
#include "AreaSum.h"
#include "OpenEnds.h"
#include "PointWelding.h"

#include <algorithm>  // for find, lower_bound, max, min
#include <cmath>      // for abs
#include <functional> // for less
#include <utility>    // for pair, move

namespace biting
{

namespace
{

class Welder
{
public:
  Welder(const Polylines& input, const DomainOptions& options, ProblemList& problems, Pulse& pulse)
    : Input(input)
    , Problems(problems)
    , Beats(pulse)
    , Options(options)
    , HasFaces(
        std::find(input.Kinds.begin(), input.Kinds.end(), ChainKind::Face) != input.Kinds.end())
  {
  }

  Arrangement Run();

private:
  void MakeVertices();
  void FindLoops();
  void AppendChain(Id chain);
  ArrangementEdge EdgeOf(Id chain) const;
  void AppendFace(Id chain);
  void AppendEdges(Id chain, const ArrangementEdge& prototype);
  void AppendEdge(Id first, Id second, const FaceEdge& faces, ArrangementEdge& edge);
  void AppendEmbeddedPoints(Id chain);
  void MergeEmbeddedPoints();
  void ReportEqualPoints(Id cell, Id first, Id second);
  bool IsClosed(Id chain) const;
  bool AreEqual(Id first, Id second) const { return this->Place(first) == this->Place(second); }

  Id Offset(Id chain) const { return this->Input.Offsets[chain]; }
  Id PointAt(Id place) const { return this->Input.Connectivity[place]; }
  Id VertexOf(Id point) const { return this->PointVertices[point]; }
  Id StartOf(Id chain) const { return this->VertexOf(this->PointAt(this->Offset(chain))); }
  Id EndOf(Id chain) const { return this->VertexOf(this->PointAt(this->Offset(chain + 1) - 1)); }
  Point2 Place(Id point) const { return PlaceOf(this->Input, point); }

  const Polylines& Input;
  ProblemList& Problems;
  Pulse& Beats;
  const DomainOptions& Options;
  const bool HasFaces;
  Arrangement Result;
  AreaSum FaceArea{ {} };        ///< of all faces
  std::vector<Id> PointVertices; ///< NoId: no chain uses the point
  std::vector<SegmentFoot> Feet;
  std::vector<Id> Loops; ///< of chains that are no faces: the first one of the loop, NoId: none
  std::vector<std::pair<Id, Id>> EmbeddedPoints; ///< vertex, point
};

Arrangement Welder::Run()
{
  this->MakeVertices();
  this->FindLoops();
  this->Result.Edges.reserve(this->Input.Connectivity.size());
  this->Result.Groups =
    DisjointSets(static_cast<std::size_t>(this->HasFaces ? this->Input.NumberOfChains() : 0));
  this->Result.Regions = this->Input.Regions;
  for (Id chain = 0; chain < this->Input.NumberOfChains() && this->Beats.Beat(); ++chain)
  {
    this->AppendChain(chain);
  }
  this->MergeEmbeddedPoints();
  this->Result.FaceArea = this->FaceArea.Area();
  return std::move(this->Result);
}

void Welder::MakeVertices()
{
  WeldedPoints points =
    WeldPoints(this->Input, this->Options.MergeTolerance, this->Problems, this->Beats);
  this->Feet = JoinOpenEnds(this->Input, this->Options, points, this->Problems, this->Beats);
  this->Result.Vertices = std::move(points.Vertices);
  this->Result.VertexPoints = std::move(points.VertexPoints);
  this->Result.Rounding = points.Rounding;
  this->Result.Resolution = points.Resolution;
  this->Result.Stretch = points.Stretch;
  this->PointVertices = std::move(points.VertexOf);
}

/// For the rules other than EvenOdd. Chains whose ends meet are joined; where an odd number of ends
/// is at one vertex they make no loop.
void Welder::FindLoops()
{
  const Id chains = this->Options.Rule == DomainRule::EvenOdd ? 0 : this->Input.NumberOfChains();
  const auto mayBound = [this](Id chain)
  {
    const ChainKind kind = this->Input.Kinds[chain];
    return this->Offset(chain) < this->Offset(chain + 1) &&
      (kind == ChainKind::Boundary || (kind == ChainKind::Automatic && !this->HasFaces));
  };
  this->Loops.assign(this->Input.Kinds.size(), NoId);
  DisjointSets joined(this->Result.Vertices.size());
  std::vector<std::uint8_t> isOdd(this->Result.Vertices.size(), 0);
  for (Id chain = 0; chain < chains; ++chain)
  {
    if (mayBound(chain) && !this->IsClosed(chain))
    {
      joined.Unite(this->StartOf(chain), this->EndOf(chain));
      isOdd[this->StartOf(chain)] ^= 1;
      isOdd[this->EndOf(chain)] ^= 1;
    }
  }
  std::vector<Id> firsts(isOdd.size(), NoId); // of joined chains, by their set
  std::vector<std::uint8_t> isOpen(isOdd.size(), 0);
  for (std::size_t vertex = 0; vertex < isOdd.size(); ++vertex)
  {
    isOpen[joined.SetOf(static_cast<Id>(vertex))] |= isOdd[vertex];
  }
  for (Id chain = 0; chain < chains; ++chain)
  {
    if (mayBound(chain))
    {
      const Id set = joined.SetOf(this->StartOf(chain));
      firsts[set] = firsts[set] == NoId && !this->IsClosed(chain) ? chain : firsts[set];
      this->Loops[chain] = this->IsClosed(chain) ? chain : isOpen[set] ? NoId : firsts[set];
    }
  }
}

void Welder::AppendChain(Id chain)
{
  const ChainKind kind = this->Input.Kinds[chain];
  if (kind == ChainKind::EmbeddedPoint)
  {
    this->AppendEmbeddedPoints(chain);
    return;
  }
  if (kind == ChainKind::Face)
  {
    this->AppendFace(chain);
    return;
  }
  this->AppendEdges(chain, this->EdgeOf(chain));
}

/// What an edge of the line `chain` counts for.
ArrangementEdge Welder::EdgeOf(Id chain) const
{
  const ChainKind kind = this->Input.Kinds[chain];
  const bool isAutomatic = kind == ChainKind::Automatic && !this->HasFaces;
  const bool isBoundary = kind == ChainKind::Boundary || (isAutomatic && this->IsClosed(chain));
  ArrangementEdge edge;
  edge.Cell = this->Input.Cells[chain];
  if (this->Loops[chain] != NoId)
  {
    edge.Faces.AddRun(this->Loops[chain]);
    edge.Faces.Stays = true;
    return edge;
  }
  edge.BoundaryCount = isBoundary ? 1 : 0;
  edge.OpenCount = isAutomatic && !isBoundary ? 1 : 0;
  edge.IsInterface = !isAutomatic && !isBoundary;
  return edge;
}

/// What is thinner than rounding may be turned over when it is welded: it lies on neither side.
void Welder::AppendFace(Id chain)
{
  const Id first = this->Offset(chain);
  const Id end = this->Offset(chain + 1);
  if (first == end)
  {
    return;
  }
  AreaSum sum(this->Place(this->PointAt(first)));
  double thin = 0.0;
  for (Id place = first + 1; place < end; ++place)
  {
    const Point2 start = this->Place(this->PointAt(place - 1));
    const Point2 stop = this->Place(this->PointAt(place));
    sum.Add(start, stop);
    thin += this->Result.ReachAcross(stop - start);
  }
  const bool isReversed = sum.Area() < 0.0;
  const bool isThin = std::abs(sum.Area()) <= thin;
  ArrangementEdge edge;
  edge.Cell = this->Input.Cells[chain];
  edge.Faces.Turn = isThin ? 0 : isReversed ? -1 : 1;
  edge.Faces.AddRun(isReversed ? FaceEdge::OtherSide(chain) : chain);
  edge.Faces.Stays = this->Options.KeepCellEdges || this->Options.Rule != DomainRule::EvenOdd;
  this->FaceArea.AddMagnitude(sum);
  this->AppendEdges(chain, edge);
}

bool Welder::IsClosed(Id chain) const
{
  return this->Offset(chain) < this->Offset(chain + 1) &&
    this->StartOf(chain) == this->EndOf(chain);
}

/// Directs `edge` from the lesser of its ends to the greater.
void SetEnds(Id first, Id second, const FaceEdge& faces, ArrangementEdge& edge)
{
  edge.Ends = { std::min(first, second), std::max(first, second) };
  edge.Faces = FaceEdge();
  edge.Faces.Absorb(faces, first > second);
}

/// That corners of a face coincide is no news: so do those of a quad that is a triangle.
void Welder::AppendEdges(Id chain, const ArrangementEdge& prototype)
{
  ArrangementEdge edge = prototype;
  const Id end = this->Offset(chain + 1);
  for (Id place = this->Offset(chain) + 1; place < end && this->Beats.Beat(1); ++place)
  {
    const Id first = this->PointAt(place - 1);
    const Id second = this->PointAt(place);
    Id start = this->VertexOf(first);
    const bool isPoint = start == this->VertexOf(second);
    for (auto foot = std::lower_bound(this->Feet.begin(), this->Feet.end(), place - 1,
           [](const SegmentFoot&f, Id wanted) { return f.Place < wanted; });
         foot != this->Feet.end() && foot->Place == place - 1; ++foot)
    {
      this->AppendEdge(start, foot->Vertex, prototype.Faces, edge);
      start = foot->Vertex;
    }
    this->AppendEdge(start, this->VertexOf(second), prototype.Faces, edge);
    if (isPoint && edge.Faces.Count == 0 && this->AreEqual(first, second))
    {
      this->ReportEqualPoints(edge.Cell, first, second);
    }
  }
}

void Welder::AppendEdge(Id first, Id second, const FaceEdge& faces, ArrangementEdge& edge)
{
  SetEnds(first, second, faces, edge);
  if (first != second)
  {
    this->Result.Edges.push_back(edge);
  }
}

void Welder::ReportEqualPoints(Id cell, Id first, Id second)
{
  const bool isRepeated = first == second;
  this->Problems.Add({ isRepeated ? ProblemCode::ZeroLengthSegments : ProblemCode::DuplicatePoints,
    { isRepeated ? cell : first, second }, this->Place(first), {} });
}

void Welder::AppendEmbeddedPoints(Id chain)
{
  const Id end = this->Offset(chain + 1);
  for (Id place = this->Offset(chain); place < end && this->Beats.Beat(1); ++place)
  {
    const Id point = this->PointAt(place);
    this->EmbeddedPoints.emplace_back(this->VertexOf(point), point);
  }
}

void Welder::MergeEmbeddedPoints()
{
  if (!SortInSteps(this->EmbeddedPoints, std::less<>(), this->Beats))
  {
    return;
  }
  Id first = NoId;
  for (const auto& [vertex, point] : this->EmbeddedPoints)
  {
    std::vector<Id>& merged = this->Result.EmbeddedVertices;
    if (merged.empty() || merged.back() != vertex)
    {
      merged.push_back(vertex);
      first = point;
    }
    else if (this->AreEqual(first, point))
    {
      this->Problems.Add(
        { ProblemCode::DuplicatePoints, { first, point }, this->Place(point), {} });
    }
  }
}

} // namespace

Arrangement WeldPolylines(
  const Polylines& input, const DomainOptions& options, ProblemList& problems, Pulse& pulse)
{
  return Welder(input, options, problems, pulse).Run();
}

} // namespace biting
