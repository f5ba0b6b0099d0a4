// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "BodyRelaxation.h"

#include "BodyTets.h"
#include "EdgeRemoval.h"
#include "VertexMoves.h"

#include <algorithm> // for all_of, any_of, copy_if, sort, unique
#include <cstddef>   // for ptrdiff_t
#include <iterator>  // for back_inserter
#include <set>       // for steps that were tried
#include <utility>   // for pairs

namespace biting
{

namespace
{

/// Badness (TetShape): the square of the cosine of the smallest angle.
constexpr double At30 = 0.7499; // a bit more
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
    , TrialsLeft(MostTrials(body))
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
    for (int round = 0; round < Rounds && isChanged && this->GoOn(0.84 + 0.01 * round); ++round)
    {
      isChanged = this->LoosenWorst(At30);
    }
    isChanged = true;
    for (Id round = 0; round < Rounds && isChanged && this->GoOn(0.92 + 0.01 * round); ++round)
    {
      isChanged = this->TryWorst(round);
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
  static Id MostTrials(const RelaxedBody& body)
  {
    constexpr Id Least = 1000;
    constexpr Id Share = 32;
    return Least + static_cast<Id>(body.Regions.size()) / Share;
  }

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
      const BodyTets::Tetrahedron corners = this->Tets.CornersOf(cell);
      isChanged =
        (this->IsBad(cell, limit) && this->ImproveAll(this->CellsAt(corners), At45)) || isChanged;
      isChanged = (this->IsBad(cell, limit) && this->MergeAny(corners)) || isChanged;
      bool isSplit = false;
      for (std::size_t edge = 0; edge < 6 && !isSplit && this->IsBad(cell, limit); ++edge)
      {
        isSplit = this->Edges.Split(cell, edge);
      }
      isChanged = isSplit || isChanged;
    }
    return isChanged;
  }

  /// Tries all cells that are still bad, the worst first; after the first round those near which
  /// something has changed.
  bool TryWorst(Id round)
  {
    std::vector<std::pair<double, Id>> bad;
    for (Id cell = 0; cell < this->Tets.Mesh.NumberOfSlots(); ++cell)
    {
      if (this->IsBad(cell, At30))
      {
        bad.push_back({ -this->Tets.Badness[At(cell)], cell });
      }
    }
    std::sort(bad.begin(), bad.end());
    bool isChanged = false;
    for (const auto& [badness, cell] : bad)
    {
      const bool isSame = this->IsBad(cell, At30) && -this->Tets.Badness[At(cell)] == badness;
      if (isSame && this->IsChangedSince(cell, round) && this->Beats.Ask() && this->TryAt(cell))
      {
        isChanged = true;
        this->Rounds.resize(this->Tets.Mesh.Points.size(), 0);
        for (const Id vertex : this->Reached)
        {
          this->Rounds[At(vertex)] = round + 1;
        }
      }
    }
    return isChanged;
  }

  bool IsChangedSince(Id cell, Id round)
  {
    this->Rounds.resize(this->Tets.Mesh.Points.size(), 0);
    const BodyTets::Tetrahedron corners = this->Tets.CornersOf(cell);
    return std::any_of(corners.begin(), corners.end(),
      [this, round](Id vertex) { return this->Rounds[At(vertex)] >= round; });
  }

  /// Tries steps that make cells worse, and what can be made of that: at the cell, then at those
  /// that have three and two corners of it.
  bool TryAt(Id cell)
  {
    const BodyTets::Tetrahedron corners = this->Tets.CornersOf(cell);
    const std::vector<Id> near = this->CellsAt(corners);
    const double before = this->Tets.Badness[At(cell)];
    std::set<BodyTets::Tetrahedron> done;
    for (std::ptrdiff_t common = 4; common >= 2; --common)
    {
      for (const Id other : near)
      {
        const BodyTets::Tetrahedron own = this->Tets.CornersOf(other);
        const auto isCorner = [&corners](Id vertex)
        { return std::find(corners.begin(), corners.end(), vertex) != corners.end(); };
        const bool isNow = std::count_if(own.begin(), own.end(), isCorner) == common;
        for (std::size_t step = 0; isNow && step<NumberOfSteps&& this->TrialsLeft> 0; ++step)
        {
          if (done.insert(KeyOf(own, step)).second && this->Try(other, step, before))
          {
            return true;
          }
        }
      }
    }
    return false;
  }

  /// Steps at a cell: to remove its edges; to split them; to flip its facets; to merge its corners.
  static constexpr std::size_t NumberOfSteps = 28;
  static constexpr std::size_t EdgeCorners[6][2] = { { 0, 1 }, { 0, 2 }, { 0, 3 }, { 1, 2 },
    { 1, 3 }, { 2, 3 } };

  /// Is the same for the same step at another cell.
  static BodyTets::Tetrahedron KeyOf(const BodyTets::Tetrahedron& c, std::size_t step)
  {
    BodyTets::Tetrahedron key{ NoId, NoId, NoId, step < 6 ? 0 : step < 12 ? 1 : 2 };
    if (step < 12)
    {
      key[0] = c[EdgeCorners[step % 6][0]];
      key[1] = c[EdgeCorners[step % 6][1]];
    }
    else if (step < 16)
    {
      std::copy_if(c.begin(), c.end(), key.begin(),
        [&c, step](const Id& vertex) { return &vertex != &c[step - 12]; });
    }
    else
    {
      return { c[(step - 16) / 3], c[((step - 16) / 3 + 1 + step % 3) % 4], NoId, 3 };
    }
    std::sort(key.begin(), key.begin() + 3);
    return key;
  }

  bool Do(Id cell, std::size_t step)
  {
    if (step < 12)
    {
      return step < 6 ? this->Edges.Remove(cell, step) : this->Edges.Split(cell, step - 6);
    }
    if (step < 16)
    {
      return this->Edges.Flip(4 * cell + static_cast<Id>(step - 12));
    }
    const BodyTets::Tetrahedron c = this->Tets.CornersOf(cell);
    return this->Moves.Merge(c[(step - 16) / 3], c[((step - 16) / 3 + 1 + step % 3) % 4]);
  }

  /// Does the step, and improves what is near. Takes all back where a cell that changed is not
  /// better than `before` then.
  bool Try(Id cell, std::size_t step, double before)
  {
    constexpr int Rounds = 3;
    std::vector<CellChange> log;
    this->Tets.Log = &log;
    this->Tets.IsTrial = true;
    bool goes = this->Do(cell, step);
    this->Tets.IsTrial = false;
    if (goes)
    {
      --this->TrialsLeft;
      for (int round = 0; round < Rounds; ++round)
      {
        this->FindReached();
        this->ImproveAll(this->CellsAt(this->Reached), At35);
      }
      const std::vector<Id> changed = this->FindReached();
      goes = std::all_of(changed.begin(), changed.end(),
        [this, before](Id c) { return this->Tets.Badness[At(c)] < before - LeastGain; });
      if (!goes)
      {
        this->Moves.TakeBack();
      }
    }
    this->Tets.Log = nullptr;
    return goes;
  }

  /// Cells that have changed by the log. Sets Reached: their corners.
  std::vector<Id> FindReached()
  {
    std::vector<Id> changed;
    for (const CellChange& change : *this->Tets.Log)
    {
      std::copy_if(change.Cells.begin(), change.Cells.end(), std::back_inserter(changed),
        [this](Id cell) { return !this->Tets.Mesh.IsFree(cell); });
      for (const Id slot :
        change.Vertex == NoId ? std::vector<Id>() : this->Tets.StarOf(change.Vertex))
      {
        changed.push_back(slot >> 2);
      }
    }
    SortUnique(changed);
    this->Reached.clear();
    for (const Id cell : changed)
    {
      const BodyTets::Tetrahedron corners = this->Tets.CornersOf(cell);
      this->Reached.insert(this->Reached.end(), corners.begin(), corners.end());
    }
    SortUnique(this->Reached);
    return changed;
  }

  static void SortUnique(std::vector<Id>& list)
  {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
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

  /// The cells of the vertices.
  template <typename Vertices>
  std::vector<Id> CellsAt(const Vertices& vertices)
  {
    std::vector<Id> cells;
    for (const Id vertex : vertices)
    {
      for (const Id slot : this->Tets.StarOf(vertex))
      {
        cells.push_back(slot >> 2);
      }
    }
    SortUnique(cells);
    return cells;
  }

  bool ImproveAll(const std::vector<Id>& cells, double limit)
  {
    bool isChanged = false;
    for (const Id cell : cells)
    {
      isChanged = this->MoveCorners(cell, limit) || isChanged;
      isChanged = (this->IsBad(cell, limit) && this->Edges.Improve(cell)) || isChanged;
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
  std::vector<Id> Reached; ///< vertices
  std::vector<Id> Rounds;  ///< of vertices: one more than the last in which a trial changed them
  Id TrialsLeft;
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
