// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "BodyRelaxation.h"

#include "BodyTets.h"
#include "EdgeRemoval.h"
#include "VertexMoves.h"

#include <algorithm> // for sort, unique

namespace biting
{

namespace
{

/// Badness (TetShape): the square of the cosine of the smallest angle.
constexpr double At31 = 0.7347368398357183;
constexpr double At35 = 0.6710100716628343;
constexpr double At38 = 0.6209609477998338;
constexpr double At45 = 0.5;
constexpr double At1 = 0.9996954135095479;

class BodyRelaxer
{
public:
  BodyRelaxer(const SurfaceGround& ground, const std::function<double(const Point3&)>& f,
    RelaxedBody& body, Pulse& pulse)
    : Tets(body, pulse)
    , Normals(ground, this->Tets)
    , Moves(this->Tets, this->Normals, f)
    , Edges(this->Tets, this->Normals)
    , Beats(pulse)
  {
  }

  void Run()
  {
    constexpr int Sweeps = 4;
    constexpr int Rounds = 8;
    this->MergeThinFacets();
    for (int sweep = 0; sweep < Sweeps && this->GoOn(0.15 * sweep); ++sweep)
    {
      this->SmoothAll();
      this->ChangeBad(At35);
    }
    bool isChanged = true;
    for (int round = 0; round < Rounds && isChanged && this->GoOn(0.6 + 0.03 * round); ++round)
    {
      isChanged = this->MoveBad(At35);
      isChanged = this->ChangeBad(At38) || isChanged;
    }
    isChanged = true;
    for (int round = 0; round < Rounds && isChanged && this->GoOn(0.84 + 0.02 * round); ++round)
    {
      isChanged = this->LoosenWorst(At31);
    }
    this->Tets.GiveBack();
  }

  void RemoveFlat()
  {
    constexpr int Rounds = 4;
    bool isChanged = true;
    for (int round = 0; round < Rounds && isChanged && this->Beats.Ask(); ++round)
    {
      isChanged = this->ChangeBad(At1);
    }
    this->Tets.GiveBack();
  }

private:
  bool GoOn(double fraction)
  {
    this->Beats.SetFraction(fraction);
    return this->Beats.Ask();
  }

  void SmoothAll()
  {
    for (Id vertex = this->Tets.Body.NumberOnLines;
         vertex < this->Tets.Mesh.NumberOfVertices() && this->Beats.Beat(64); ++vertex)
    {
      this->Moves.Smooth(vertex, At35);
    }
  }

  bool IsBad(Id cell, double limit) const
  {
    return !this->Tets.Mesh.IsFree(cell) && this->Tets.Badness[At(cell)] > limit;
  }

  bool ChangeBad(double limit)
  {
    bool isChanged = false;
    for (Id cell = 0; cell < this->Tets.Mesh.NumberOfSlots() && !this->Beats.HasStopped(); ++cell)
    {
      if (this->IsBad(cell, limit) && this->Beats.Beat(128))
      {
        isChanged = this->Edges.Improve(cell) || isChanged;
      }
    }
    return isChanged;
  }

  bool MoveBad(double limit)
  {
    bool isMoved = false;
    for (Id cell = 0; cell < this->Tets.Mesh.NumberOfSlots() && !this->Beats.HasStopped(); ++cell)
    {
      isMoved = this->MoveCorners(cell, limit) || isMoved;
    }
    return isMoved;
  }

  /// Makes room about the worst cells: those near them get better than they need to be, or
  /// there is a vertex less, or one more. Cells that this adds wait for the next round: each may be
  /// nearly as bad as its parent, and be split as well.
  bool LoosenWorst(double limit)
  {
    bool isChanged = false;
    const Id slots = this->Tets.Mesh.NumberOfSlots();
    for (Id cell = 0; cell < slots && !this->Beats.HasStopped(); ++cell)
    {
      if (this->IsBad(cell, limit))
      {
        isChanged = this->ImproveAround(cell) || isChanged;
        isChanged =
          (this->IsBad(cell, limit) && this->MergeAny(this->Tets.CornersOf(cell))) || isChanged;
        isChanged = (this->IsBad(cell, limit) && this->Edges.Split(cell)) || isChanged;
      }
    }
    return isChanged;
  }

  /// Merges vertices of thin facets of the boundary while there are slivers, which tetrahedra at
  /// such facets are: later each merge would make others worse.
  void MergeThinFacets()
  {
    for (Id cell = 0; cell < this->Tets.Mesh.NumberOfSlots() && !this->Beats.HasStopped(); ++cell)
    {
      this->Beats.Beat();
      for (Id slot = 4 * cell; slot < 4 * cell + 4 && !this->Tets.Mesh.IsFree(cell); ++slot)
      {
        if (this->Tets.RecordOf(slot) >= 0 && this->IsThin(slot))
        {
          this->MergeAny(this->Tets.FacetCorners(slot));
        }
      }
    }
  }

  /// Whether an angle of the facet is below 20 degrees.
  bool IsThin(Id slot) const
  {
    constexpr double Tangent = 0.36397023426620234;
    bool isThin = false;
    const std::array<Id, 3> corners = this->Tets.FacetCorners(slot);
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Point3& at = this->Tets.Mesh.PointAt(corners[k]);
      const Point3 side = this->Tets.Mesh.PointAt(corners[(k + 1) % 3]) - at;
      const Point3 other = this->Tets.Mesh.PointAt(corners[(k + 2) % 3]) - at;
      isThin = isThin || Length(Cross(side, other)) < Tangent * Dot(side, other);
    }
    return isThin;
  }

  template <typename Corners>
  bool MergeAny(const Corners& corners)
  {
    for (const Id vertex : corners)
    {
      for (const Id other : corners)
      {
        if (vertex != other && this->Moves.Merge(vertex, other))
        {
          return true;
        }
      }
    }
    return false;
  }

  bool ImproveAround(Id cell)
  {
    this->Near.clear();
    for (const Id vertex : this->Tets.CornersOf(cell))
    {
      for (const Id slot : this->Tets.StarOf(vertex))
      {
        this->Near.push_back(slot >> 2);
      }
    }
    std::sort(this->Near.begin(), this->Near.end());
    this->Near.erase(std::unique(this->Near.begin(), this->Near.end()), this->Near.end());
    bool isChanged = false;
    for (const Id other : this->Near)
    {
      isChanged = this->MoveCorners(other, At45) || isChanged;
      isChanged = (this->IsBad(other, At45) && this->Edges.Improve(other)) || isChanged;
    }
    return isChanged;
  }

  bool MoveCorners(Id cell, double limit)
  {
    bool isMoved = false;
    for (Id slot = 4 * cell; slot < 4 * cell + 4 && this->IsBad(cell, limit); ++slot)
    {
      this->Beats.Beat(256);
      isMoved = this->Moves.Improve(this->Tets.VertexAt(slot), limit) || isMoved;
    }
    return isMoved;
  }

  BodyTets Tets;
  GroundNormals Normals;
  VertexMoves Moves;
  EdgeRemoval Edges;
  Pulse& Beats;
  std::vector<Id> Near;
};

} // namespace

void RelaxBody(const SurfaceGround& ground, const std::function<double(const Point3&)>& f,
  RelaxedBody& body, Pulse& pulse)
{
  BodyRelaxer(ground, f, body, pulse).Run();
}

void RemoveFlatTetrahedra(const SurfaceGround& ground, RelaxedBody& body, Pulse& pulse)
{
  const std::function<double(const Point3&)> none;
  BodyRelaxer(ground, none, body, pulse).RemoveFlat();
}

} // namespace biting
