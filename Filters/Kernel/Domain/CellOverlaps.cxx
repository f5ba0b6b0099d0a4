// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "CellOverlaps.h"

#include "Nesting.h"

#include <algorithm> // for any_of, min, max
#include <cmath>     // for abs
#include <cstddef>   // for size_t
#include <cstdint>   // for flags
#include <cstdlib>   // for abs
#include <limits>    // for epsilon

namespace biting
{

namespace
{

/// Of the area of all faces; sums of areas are exact to their last bits.
constexpr double OverlapShare = 8.0 * std::numeric_limits<double>::epsilon();

/// A surface: faces that were joined.
struct Surface
{
  Id LeastCover =
    NoId; ///< how many others cover the outline, where that is least; NoId: not met yet
  Id MostCover = NoId;
  Id Deepest = NoId; ///< a segment of the outline that most cover
  Id Parent = NoId;  ///< what surrounds its first segment; NoId: nothing
};

class OverlapFinder
{
public:
  OverlapFinder(
    const Arrangement& arrangement, const Polylines& input, ProblemList& problems, Pulse& pulse)
    : Drawing(arrangement)
    , Cells(input.Cells)
    , Problems(problems)
    , Beats(pulse)
    , Groups(arrangement.Groups)
    , Surfaces(input.Cells.size())
    , OwnersAbove(arrangement.Edges.size(), NoId)
    , IsReported(input.Cells.size(), 0)
  {
  }

  void Run();

private:
  void FindDepths();
  void JoinNeighbors();
  void Visit(Id segment);
  void MeetOutline(Id segment, Surface& surface) const;
  Id OwnerBelow(Id segment) const;
  void ReportSurfaces();
  bool LiesOnOthers(const Surface& surface);
  void Report(Id segment, ProblemCode code);

  const FaceEdge& FacesAt(Id segment) const { return this->Drawing.Edge(segment).Faces; }
  Id StepOf(Id segment) const { return this->Depths.Steps[segment]; }

  const Arrangement& Drawing;
  const std::vector<Id>& Cells;
  ProblemList& Problems;
  Pulse& Beats;
  DisjointSets Groups;
  SegmentDepths Depths;
  std::vector<Surface> Surfaces; ///< by the face that stands for the group
  std::vector<Id> OwnersAbove;   ///< of each segment: the innermost surface just above it
  std::vector<std::uint8_t> IsReported;
};

void OverlapFinder::Run()
{
  this->FindDepths();
  this->JoinNeighbors();
  for (std::size_t k = 0; k < this->Depths.Order.size() && this->Beats.Beat(1); ++k)
  {
    this->Visit(this->Depths.Order[k]);
  }
  this->ReportSurfaces();
}

void OverlapFinder::FindDepths()
{
  std::vector<Id> turns;
  for (const ArrangementEdge& edge : this->Drawing.Edges)
  {
    turns.push_back(edge.Faces.Turn);
  }
  this->Depths =
    biting::FindDepths(this->Drawing.Vertices, this->Drawing.EdgeEnds(), turns, this->Beats);
}

/// Over common edges that are interfaces.
void OverlapFinder::JoinNeighbors()
{
  for (const ArrangementEdge& edge : this->Drawing.Edges)
  {
    if (edge.Faces.Count == 2 && edge.Faces.Turn == 0 && edge.Faces.Second() != NoId)
    {
      this->Groups.Unite(edge.Faces.First(), edge.Faces.Second());
    }
  }
}

/// What lies below the left end of a segment has been visited before it.
void OverlapFinder::Visit(Id segment)
{
  const FaceEdge& faces = this->FacesAt(segment);
  const Id below = this->OwnerBelow(segment);
  Id above = below;
  const bool isThin = faces.Count == 1 && faces.Turn == 0;
  if (faces.First() != NoId && !isThin)
  {
    const Id group = this->Groups.SetOf(faces.First());
    Surface& surface = this->Surfaces[group];
    surface.Parent = surface.LeastCover == NoId ? below : surface.Parent;
    this->MeetOutline(segment, surface);
    above = this->StepOf(segment) > 0 ? group : this->StepOf(segment) < 0 ? surface.Parent : below;
  }
  this->OwnersAbove[segment] = above;
  if (faces.First() != NoId && faces.Count + std::abs(faces.Turn) > 3)
  {
    this->Report(segment, ProblemCode::OverlappingCells);
  }
}

void OverlapFinder::MeetOutline(Id segment, Surface& surface) const
{
  if (this->FacesAt(segment).Count != 1)
  {
    return;
  }
  const Id above = this->Depths.Above[segment];
  const Id cover = std::min(std::abs(above), std::abs(above - this->StepOf(segment)));
  const bool isFirst = surface.LeastCover == NoId;
  surface.LeastCover = isFirst ? cover : std::min(surface.LeastCover, cover);
  surface.Deepest = isFirst || cover > surface.MostCover ? segment : surface.Deepest;
  surface.MostCover = std::max(surface.MostCover, cover);
}

Id OverlapFinder::OwnerBelow(Id segment) const
{
  const Id below = this->Depths.Below[segment];
  return below == NoId ? NoId : this->OwnersAbove[below];
}

void OverlapFinder::ReportSurfaces()
{
  for (const Surface& surface : this->Surfaces)
  {
    const bool isHole = !this->LiesOnOthers(surface);
    const bool isKnown = isHole && this->Problems.Has(ProblemCode::OverlappingCells);
    if (surface.MostCover > 0 && !isKnown && this->Beats.Beat(1))
    {
      this->Report(
        surface.Deepest, isHole ? ProblemCode::NestedCells : ProblemCode::OverlappingCells);
    }
  }
}

/// Where its outline lies within a single face all along, it is a hole.
bool OverlapFinder::LiesOnOthers(const Surface& surface)
{
  const bool isOfSeveral = surface.Parent != NoId && this->Groups.SizeOf(surface.Parent) > 1;
  return surface.LeastCover != surface.MostCover || isOfSeveral;
}

void OverlapFinder::Report(Id segment, ProblemCode code)
{
  const auto face = static_cast<std::size_t>(this->FacesAt(segment).First());
  if (!this->IsReported[face])
  {
    this->IsReported[face] = 1;
    this->Problems.Add({ code, { this->Cells[face] },
      this->Drawing.At(this->Drawing.Edge(segment).Ends.Start), {} });
  }
}

bool MayOverlap(const Arrangement& arrangement, double area)
{
  const bool hasBoundaryLines = std::any_of(arrangement.Edges.begin(), arrangement.Edges.end(),
    [](const ArrangementEdge& edge) { return edge.BoundaryCount > 0; });
  const double excess = std::abs(arrangement.FaceArea - area);
  return arrangement.FaceArea > 0.0 &&
    (hasBoundaryLines || excess > OverlapShare * arrangement.FaceArea);
}

} // namespace

void ReportCellOverlaps(const Arrangement& arrangement, const Polylines& input, double area,
  ProblemList& problems, Pulse& pulse)
{
  if (MayOverlap(arrangement, area))
  {
    OverlapFinder(arrangement, input, problems, pulse).Run();
  }
}

} // namespace biting
