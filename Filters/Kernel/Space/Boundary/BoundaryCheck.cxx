// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "BoundaryCheck.h"

#include <algorithm> // for sort, binary_search
#include <utility>   // for pairs

namespace biting
{

namespace
{

class BoundaryChecker
{
public:
  BoundaryChecker(const SurfaceGround& ground, const SurfaceBites& bites, SurfaceBoundary& boundary)
    : Ground(ground)
    , Bites(bites)
    , Boundary(boundary)
  {
  }

  void Run(Pulse& pulse)
  {
    this->FacetsAt = PlacesByOwner(this->Boundary.Corners, At(this->Bites.Size()));
    this->ListPieces();
    for (Id bite = 0; bite < this->Bites.Size() && pulse.Beat(8); ++bite)
    {
      if (this->FacetsAt[bite].Size() == 0)
      {
        this->Tell(BoundaryFault::Missing, bite, NoId);
      }
      else
      {
        this->CheckFan(bite);
      }
    }
    this->CheckPieces();
    this->CheckNormals();
  }

private:
  using Piece = std::pair<std::pair<Id, Id>, SurfaceEdgeKind>;

  void Tell(BoundaryFault fault, Id bite, Id other)
  {
    this->Boundary.Offences.push_back({ fault, bite, other });
  }

  void ListPieces()
  {
    const std::vector<Id>& ends = this->Bites.PieceEnds;
    for (std::size_t k = 0; k < ends.size(); k += 2)
    {
      const SurfaceEdgeKind kind = this->Ground.Chains.Kinds[At(this->Bites.PieceChains[k / 2])];
      this->Pieces.push_back({ std::minmax(ends[k], ends[k + 1]), kind });
    }
    std::sort(this->Pieces.begin(), this->Pieces.end());
  }

  bool IsPiece(Id a, Id b) const
  {
    return this->IsPiece(a, b, SurfaceEdgeKind::Feature) ||
      this->IsPiece(a, b, SurfaceEdgeKind::Border) ||
      this->IsPiece(a, b, SurfaceEdgeKind::NonManifold);
  }

  bool IsPiece(Id a, Id b, SurfaceEdgeKind kind) const
  {
    return a < this->Bites.NumberOnLines && b < this->Bites.NumberOnLines &&
      std::binary_search(this->Pieces.begin(), this->Pieces.end(), Piece(std::minmax(a, b), kind));
  }

  Id Next(Id slot) const { return this->Boundary.Corners[NextSlotOf(At(slot))]; }
  Id Previous(Id slot) const { return this->Boundary.Corners[PreviousSlotOf(At(slot))]; }

  /// Follows the fan from each facet at the bite; all of them must come in one turn, but at corners
  /// without pieces, which are pinches of the surface. At a vertex of features that is asked of
  /// solids only in all, and for other edges than pieces. Pieces that turn have two facets,
  /// oriented alike, pieces of borders one.
  void CheckFan(Id bite)
  {
    this->Fan.clear();
    for (const Id slot : this->FacetsAt[bite])
    {
      this->Fan.push_back({ this->Next(slot), this->Previous(slot) });
    }
    std::size_t starts = 0; // fans that begin at a piece
    std::size_t walked = 0; // facets in these
    for (const auto& [next, previous] : this->Fan)
    {
      Id before = 0;
      Id beside = 0;
      for (const auto& other : this->Fan)
      {
        before += other.second == next ? 1 : 0;
        beside += other.first == next ? 1 : 0;
      }
      const bool isPiece = this->IsPiece(bite, next);
      if (((before != 1 || beside != 1) &&
            (!isPiece || this->IsPiece(bite, next, SurfaceEdgeKind::Feature))) ||
        (before + beside != 1 && this->IsPiece(bite, next, SurfaceEdgeKind::Border)))
      {
        this->Tell(BoundaryFault::NonManifold, bite, next);
        return;
      }
      starts += isPiece ? 1 : 0;
    }
    for (std::size_t k = 0; k < (starts == 0 ? 1 : this->Fan.size()); ++k)
    {
      const bool isStart = starts == 0 || this->IsPiece(bite, this->Fan[k].first);
      walked += isStart ? this->WalkFan(bite, k) : 0;
    }
    if (walked != this->Fan.size() && (starts > 0 || bite >= this->Bites.NumberOfCorners))
    {
      this->Tell(BoundaryFault::Pinched, bite, NoId);
    }
  }

  /// The number of facets of Fan from the first on, up to a piece or round.
  std::size_t WalkFan(Id bite, std::size_t first) const
  {
    std::size_t at = first;
    for (std::size_t count = 1; count <= this->Fan.size(); ++count)
    {
      const Id previous = this->Fan[at].second;
      at = this->Fan.size();
      for (std::size_t k = 0; k < this->Fan.size() && !this->IsPiece(bite, previous); ++k)
      {
        at = this->Fan[k].first == previous ? k : at;
      }
      if (at == first || at == this->Fan.size())
      {
        return count;
      }
    }
    return this->Fan.size() + 1;
  }

  void CheckPieces()
  {
    const std::vector<Id>& ends = this->Bites.PieceEnds;
    for (std::size_t k = 0; k < ends.size(); k += 2)
    {
      bool isThere = false;
      for (const Id slot : this->FacetsAt[ends[k]])
      {
        isThere = isThere || this->Next(slot) == ends[k + 1] || this->Previous(slot) == ends[k + 1];
      }
      if (!isThere)
      {
        this->Tell(BoundaryFault::LostPiece, ends[k], ends[k + 1]);
      }
    }
  }

  void CheckNormals()
  {
    constexpr double LeastCosine = 0.5;
    for (std::size_t facet = 0; facet < this->Boundary.Triangles.size(); ++facet)
    {
      const Id* corners = &this->Boundary.Corners[3 * facet];
      const Point3& a = this->Bites.Centers[At(corners[0])];
      const Point3 normal =
        Cross(this->Bites.Centers[At(corners[1])] - a, this->Bites.Centers[At(corners[2])] - a);
      const Id triangle = this->Boundary.Triangles[facet];
      if (triangle == NoId ||
        Dot(normal, this->Ground.Normals[At(triangle)]) < LeastCosine * Length(normal))
      {
        const Id worst = std::max(corners[0], std::max(corners[1], corners[2]));
        this->Tell(BoundaryFault::Turned, worst, NoId);
      }
    }
  }

  const SurfaceGround& Ground;
  const SurfaceBites& Bites;
  SurfaceBoundary& Boundary;
  IdLists FacetsAt; ///< of bites: the slots of facets
  std::vector<std::pair<Id, Id>>
    Fan; ///< of the facets at a bite: the next corner, the previous one
  std::vector<Piece> Pieces;
};

} // namespace

void CheckBoundary(
  const SurfaceGround& ground, const SurfaceBites& bites, SurfaceBoundary& boundary, Pulse& pulse)
{
  BoundaryChecker(ground, bites, boundary).Run(pulse);
}

} // namespace biting
