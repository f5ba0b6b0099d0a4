// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "CoveringFaces.h"

#include "../Base/DistanceToSegment.h"
#include "../Base/Tasks.h"
#include "../Domain/AreaSum.h"
#include "../Predicates/Predicates.h"
#include "../Quality/TriangleLinks.h"

#include <cmath>    // for abs, nextafter
#include <cstddef>  // for size_t
#include <map>      // for counts
#include <optional> // for the uppermost face

namespace biting
{

namespace
{

constexpr Id AnyClass = NoId;

Point2 MiddleOf(const BitingMesh& mesh, std::size_t triangle)
{
  const Id* corners = mesh.Corners.data() + 3 * triangle;
  return (1.0 / 3.0) *
    (mesh.Points[corners[0]] + mesh.Points[corners[1]] + mesh.Points[corners[2]]);
}

} // namespace

CoveringFaces::CoveringFaces(const Polylines& chains, const DomainOptions& options, Pulse& pulse)
  : Chains(chains)
  , IsUnion(options.Rule == DomainRule::Union)
  , AreApart(options.KeepCellEdges || (IsUnion && chains.Regions.empty()))
{
  std::vector<Face> faces;
  std::vector<Edge> edges;
  for (Id chain = 0; chain < chains.NumberOfChains() && pulse.Beat(); ++chain)
  {
    if (chains.Kinds[chain] != ChainKind::Face)
    {
      continue;
    }
    Face face{ {}, chain, 0.0 };
    AreaSum area(chains.Points[chains.Connectivity[chains.Offsets[chain]]]);
    for (Id k = chains.Offsets[chain]; k + 1 < chains.Offsets[chain + 1]; ++k)
    {
      const Point2& start = chains.Points[chains.Connectivity[k]];
      area.Add(start, chains.Points[chains.Connectivity[k + 1]]);
      face.Extent.Add(start);
      edges.push_back(EdgeAt(chains, chain, k));
    }
    face.Area = std::abs(area.Area());
    faces.push_back(face);
  }
  this->Faces = BoxTree<Face>(faces, pulse);
  this->Edges = BoxTree<Edge>(faces.size() > 1 ? edges : std::vector<Edge>(), pulse);
}

/// From left to right, of vertical ones upwards.
CoveringFaces::Edge CoveringFaces::EdgeAt(const Polylines& chains, Id chain, Id place)
{
  const Point2& a = chains.Points[chains.Connectivity[place]];
  const Point2& b = chains.Points[chains.Connectivity[place + 1]];
  return a < b ? Edge{ a, b, chain } : Edge{ b, a, chain };
}

/// Whether a ray upwards from `place` meets it. Of two edges that meet at a common x one is met.
bool CoveringFaces::Edge::IsAbove(const Point2& place) const
{
  return this->Start.X <= place.X && place.X < this->End.X &&
    Orient2D(this->Start, this->End, place) < 0;
}

std::vector<Id> CoveringFaces::FacesOf(const BitingMesh& mesh, Pulse& pulse) const
{
  std::vector<Id> faces(mesh.Regions.size(), NoId);
  if (this->Faces.Items().size() == 1)
  {
    faces.assign(faces.size(), this->Faces.Items().front().Chain);
    return faces;
  }
  constexpr std::size_t CheapSteps = 64; // of a query
  std::vector<Id> ofPiece;               // a piece has none
  if (mesh.Neighbors.size() != mesh.Corners.size())
  {
    ofPiece = LinkTriangles(mesh.Corners, static_cast<Id>(mesh.Points.size())).Neighbors;
  }
  const std::vector<Id>& neighbors = ofPiece.empty() ? mesh.Neighbors : ofPiece;
  ForRowsAtOnce(pulse, faces.size(), CheapSteps,
    [this, &mesh, &faces, &neighbors](std::size_t begin, std::size_t end)
    {
      for (std::size_t triangle = begin; triangle < end; ++triangle)
      {
        const Point2 middle = MiddleOf(mesh, triangle);
        for (std::size_t k = 3 * triangle; k < 3 * triangle + 3 && faces[triangle] == NoId; ++k)
        {
          const auto neighbor = static_cast<std::size_t>(neighbors[k]);
          const bool isKnown = neighbors[k] != NoId && begin <= neighbor && neighbor < triangle;
          if (isKnown && this->IsClear(Box2::Around(middle, MiddleOf(mesh, neighbor))))
          {
            faces[triangle] = faces[neighbor];
          }
        }
        faces[triangle] = faces[triangle] == NoId ? this->At(middle) : faces[triangle];
      }
    });
  return faces;
}

bool CoveringFaces::IsClear(const Box2& box) const
{
  return this->Edges.AllOf(box, [](const Edge&) { return false; });
}

Id CoveringFaces::At(const Point2& place) const
{
  std::optional<Face> uppermost;
  this->Faces.AllOf(Box2{ place, place },
    [this, &place, &uppermost](const Face& face)
    {
      if ((!uppermost || this->IsOver(face, *uppermost)) && this->Covers(face, place))
      {
        uppermost = face;
      }
      return true;
    });
  return uppermost ? uppermost->Chain : this->NearestOfClass(place, AnyClass);
}

bool CoveringFaces::IsOver(const Face& first, const Face& second) const
{
  const bool areAlike = this->IsUnion || first.Area == second.Area;
  return areAlike ? first.Chain > second.Chain : first.Area < second.Area;
}

/// Whether a ray upwards meets its outline an odd number of times: that of a small face is asked
/// edge by edge, else those near the ray are.
bool CoveringFaces::Covers(const Face& face, const Point2& place) const
{
  constexpr Id FewEdges = 32;
  bool isCovered = false;
  const Id first = this->Chains.Offsets[face.Chain];
  const Id last = this->Chains.Offsets[face.Chain + 1] - 1;
  for (Id k = first; k < last && last - first <= FewEdges; ++k)
  {
    isCovered ^= EdgeAt(this->Chains, face.Chain, k).IsAbove(place);
  }
  if (last - first > FewEdges)
  {
    this->Edges.AllOf(Box2{ place, { place.X, face.Extent.High.Y } },
      [&face, &place, &isCovered](const Edge& edge)
      {
        isCovered ^= edge.Chain == face.Chain && edge.IsAbove(place);
        return true;
      });
  }
  return isCovered;
}

Id CoveringFaces::NearestOfClass(const Point2& place, Id wanted) const
{
  Id nearest = NoId;
  double least = Infinity;
  this->Edges.Search(place, 1.0, Infinity,
    [this, &place, wanted, &nearest, &least](const Edge& edge, double)
    {
      const double distance = DistanceToSegment(place, edge.Start, edge.End);
      const bool isNearer = distance < least || (distance == least && edge.Chain < nearest);
      if (isNearer && (wanted == AnyClass || this->ClassOf(edge.Chain) == wanted))
      {
        least = distance;
        nearest = edge.Chain;
      }
      return std::nextafter(least, Infinity);
    });
  return nearest;
}

Id CoveringFaces::ClassOf(Id chain) const
{
  return this->AreApart ? chain : this->Chains.Regions.empty() ? 0 : this->Chains.Regions[chain];
}

CoveringFaces::Votes CoveringFaces::Count(
  const BitingMesh& mesh, const std::vector<Id>& faces) const
{
  std::map<std::pair<Id, Id>, std::int64_t> counts;
  for (std::size_t triangle = 0; triangle < faces.size(); ++triangle)
  {
    const bool isOwn = !mesh.Piece.IsPart || mesh.Piece.Levels[triangle] == 0;
    counts[{ mesh.Regions[triangle], this->ClassOf(faces[triangle]) }] += isOwn ? 1 : 0;
  }
  Votes votes;
  for (const auto& [key, triangles] : counts)
  {
    votes.push_back({ key.first, key.second, triangles });
  }
  return votes;
}

void CoveringFaces::CorrectBy(
  const Votes& votes, const BitingMesh& mesh, std::vector<Id>& faces, Pulse& pulse) const
{
  std::map<std::pair<Id, Id>, std::int64_t> counts;
  for (const Vote& vote : votes)
  {
    counts[{ vote.Region, vote.Class }] += vote.Triangles;
  }
  std::map<Id, std::pair<std::int64_t, Id>> most; // of each region, and the first class that has it
  for (const auto& [key, triangles] : counts)
  {
    const auto entry = most.try_emplace(key.first, triangles, key.second).first;
    entry->second =
      triangles > entry->second.first ? std::pair(triangles, key.second) : entry->second;
  }
  for (std::size_t triangle = 0; triangle < faces.size() && pulse.Beat(1); ++triangle)
  {
    const Id wanted = most.at(mesh.Regions[triangle]).second;
    if (this->ClassOf(faces[triangle]) != wanted)
    {
      faces[triangle] = this->NearestOfClass(MiddleOf(mesh, triangle), wanted);
    }
  }
}

} // namespace biting
