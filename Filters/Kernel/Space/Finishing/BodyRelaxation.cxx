// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "BodyRelaxation.h"

#include "BodyTets.h"
#include "EdgeRemoval.h"
#include "VertexMoves.h"

#include <algorithm> // for any_of, count_if, max, min, sort, unique
#include <cmath>     // for abs
#include <cstddef>   // for ptrdiff_t
#include <set>       // for steps that were tried
#include <utility>   // for pairs

namespace biting
{

namespace
{

/// Badness (TetShape): the square of the cosine of the smallest angle.
constexpr double At30 = 0.7499; // 30.007 degrees: rounding leaves 30
constexpr double At31 = 0.7347368398357183;
constexpr double At35 = 0.6710100716628343;
constexpr double At38 = 0.6209609477998338;
constexpr double At45 = 0.5;
constexpr double At1 = 0.9996954135095479;

/// A body that is relaxed, and trials of changes.
class BodyTrials
{
protected:
  BodyTrials(const SurfaceGround& ground, const std::function<double(const Point3&)>& f,
    RelaxedBody& body, Pulse& pulse)
    : Tets(body, pulse)
    , Normals(ground, this->Tets)
    , Moves(this->Tets, this->Normals, f)
    , Edges(this->Tets, this->Normals)
    , Beats(pulse)
    , TrialsLeft(300 + this->Tets.Mesh.NumberOfSlots() / 256) // most find nothing
    , TrialsToCome(std::min(this->Tets.Mesh.NumberOfSlots() / 4, 4000))
  {
  }

  bool IsBad(Id cell, double limit) const
  {
    return !this->Tets.Mesh.IsFree(cell) && this->Tets.Badness[At(cell)] > limit;
  }

  /// Tries all cells that are still bad, the worst first; after the first round those near which
  /// something has changed. Steps at their own edges first: these succeed most often.
  bool TryWorst(Id round)
  {
    constexpr Id TrialsAfterSuccess = 64;
    std::vector<std::pair<double, Id>> bad;
    for (Id cell = 0; cell < this->Tets.Mesh.NumberOfSlots(); ++cell)
    {
      if (this->IsBad(cell, At30) && !this->IsSharp(cell))
      {
        bad.push_back({ -this->Tets.Badness[At(cell)], cell });
      }
    }
    std::sort(bad.begin(), bad.end());
    bool isChanged = false;
    this->Rounds.resize(this->Tets.Mesh.Points.size(), 0);
    for (std::ptrdiff_t common = 4; common >= 2; --common)
    {
      for (const auto& [badness, cell] : bad)
      {
        const BodyTets::Tetrahedron corners = this->Tets.CornersOf(cell);
        const auto isNew = [this, round](Id vertex) { return this->Rounds[At(vertex)] >= round; };
        if (this->TrialsLeft > 0 && this->IsBad(cell, At30) &&
          std::abs(this->Tets.Badness[At(cell)] + badness) < LeastGain &&
          std::any_of(corners.begin(), corners.end(), isNew) && this->Beats.Ask() &&
          this->TryAt(cell, common))
        {
          isChanged = true;
          const Id more = std::min(this->TrialsToCome, TrialsAfterSuccess);
          this->TrialsToCome -= more;
          this->TrialsLeft += more;
          this->Rounds.resize(this->Tets.Mesh.Points.size(), 0);
          for (const Id vertex : this->Reached)
          {
            this->Rounds[At(vertex)] = round + 1;
          }
        }
      }
    }
    return isChanged;
  }

  /// Whether the surface itself has an angle below 25 degrees at an edge of the cell.
  bool IsSharp(Id cell) const
  {
    constexpr double Cosine = 0.9063077870366499;
    bool isSharp = false;
    for (std::size_t edge = 0; edge < 6 && !isSharp; ++edge)
    {
      const auto [a, b, p, q] = this->Edges.CornersFrom(cell, edge);
      const Point3& at = this->Tets.Mesh.PointAt(a);
      const Point3 along = this->Tets.Mesh.PointAt(b) - at;
      const Point3 m = Cross(along, this->Tets.Mesh.PointAt(p) - at);
      const Point3 n = Cross(along, this->Tets.Mesh.PointAt(q) - at);
      isSharp = Dot(m, n) > Cosine * Length(m) * Length(n) &&
        this->Tets.Lines.Between(a, b) != NoId &&
        this->Tets.RecordOf(this->Tets.SlotOf(cell, p)) >= 0 &&
        this->Tets.RecordOf(this->Tets.SlotOf(cell, q)) >= 0;
    }
    return isSharp;
  }

  /// Tries steps that make cells worse, and what can be made of that: at edges of the cells that
  /// share `common` corners with this one, but for edges of cells that share more.
  bool TryAt(Id cell, std::ptrdiff_t common)
  {
    const BodyTets::Tetrahedron corners = this->Tets.CornersOf(cell);
    const auto isCorner = [&corners](Id vertex)
    { return std::find(corners.begin(), corners.end(), vertex) != corners.end(); };
    const std::vector<Id> near = this->CellsAt(corners);
    std::set<std::pair<Id, Id>> seen;
    for (std::ptrdiff_t count = 4; count >= common; --count)
    {
      for (const Id other : near)
      {
        const BodyTets::Tetrahedron own = this->Tets.CornersOf(other);
        const bool isNow = std::count_if(own.begin(), own.end(), isCorner) == count;
        for (std::size_t edge = 0; isNow && edge < 6; ++edge)
        {
          const BodyTets::Tetrahedron ends = this->Edges.CornersFrom(other, edge);
          const bool isNew = seen.insert(std::minmax(ends[0], ends[1])).second && count == common;
          for (int step = 0; step < 4 && isNew && this->TrialsLeft > 0; ++step)
          {
            if (!this->Beats.HasStopped() && this->Try(cell, other, edge, step))
            {
              return true;
            }
          }
        }
      }
    }
    return false;
  }

  bool Do(Id cell, std::size_t edge, int step)
  {
    const Id a = this->Edges.CornersFrom(cell, edge)[0];
    const Id b = this->Edges.CornersFrom(cell, edge)[1];
    return step == 0 ? this->Edges.Remove(cell, edge)
      : step == 1    ? this->Edges.Split(cell, edge)
                     : this->Moves.Merge(step == 2 ? a : b, step == 2 ? b : a);
  }

  /// Does a step at an edge of `other`, and improves what is near. Takes all back where the cell,
  /// or one that changed, is not better than the cell was.
  bool Try(Id cell, Id other, std::size_t edge, int step)
  {
    constexpr int MostRounds = 3;
    const double limit = this->Tets.Badness[At(cell)] - LeastGain;
    std::vector<CellChange> log;
    this->Tets.Log = &log;
    this->Tets.IsTrial = true;
    bool goes = this->Do(other, edge, step);
    this->Tets.IsTrial = false;
    if (goes)
    {
      --this->TrialsLeft;
      double worst = this->FindReached();
      double last = Infinity;
      for (int round = 0; round < MostRounds && worst < last - LeastGain; ++round)
      {
        last = worst;
        this->ImproveAll(this->CellsAt(this->Reached), At31);
        worst = this->FindReached();
      }
      goes = worst < limit && !this->IsBad(cell, limit);
      if (!goes)
      {
        this->Moves.TakeBack();
      }
    }
    this->Tets.Log = nullptr;
    return goes;
  }

  /// Sets Reached: the corners of cells that have changed by the log. The badness of the worst.
  double FindReached()
  {
    std::vector<Id> changed;
    for (const CellChange& change : *this->Tets.Log)
    {
      changed.insert(changed.end(), change.Cells.begin(), change.Cells.end());
      for (const Id slot :
        change.Vertex == NoId ? std::vector<Id>() : this->Tets.StarOf(change.Vertex))
      {
        changed.push_back(slot >> 2);
      }
    }
    SortUnique(changed);
    double worst = 0.0;
    this->Reached.clear();
    for (const Id cell : changed)
    {
      if (!this->Tets.Mesh.IsFree(cell))
      {
        const BodyTets::Tetrahedron corners = this->Tets.CornersOf(cell);
        this->Reached.insert(this->Reached.end(), corners.begin(), corners.end());
        worst = std::max(worst, this->Tets.Badness[At(cell)]);
      }
    }
    SortUnique(this->Reached);
    return worst;
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

  static void SortUnique(std::vector<Id>& list)
  {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }

  BodyTets Tets;
  GroundNormals Normals;
  VertexMoves Moves;
  EdgeRemoval Edges;
  Pulse& Beats;
  std::vector<Id> Reached; ///< vertices
  std::vector<Id> Rounds;  ///< of vertices: 1 + the last round that changed a cell there
  Id TrialsLeft;
  Id TrialsToCome; ///< where others help
};

/// The order of the steps.
class BodyRelaxer : private BodyTrials
{
public:
  BodyRelaxer(const SurfaceGround& ground, const std::function<double(const Point3&)>& f,
    RelaxedBody& body, Pulse& pulse)
    : BodyTrials(ground, f, body, pulse)
  {
  }

  void Run()
  {
    constexpr Id Sweeps = 4;
    this->MergeThinFacets();
    for (Id sweep = 0; sweep < Sweeps && this->GoOn(0.15 * sweep); ++sweep)
    {
      this->SmoothAll();
      this->ChangeBad(At35);
    }
    constexpr Id MostRounds = 8;
    constexpr Id MostRoundsOfTrials = 32; // a round makes the worst a little better
    const auto repeat = [this](Id most, double begin, double end, const auto& step)
    {
      bool isChanged = true;
      for (Id k = 0; k < most && isChanged && this->GoOn(begin + k * (end - begin) / most); ++k)
      {
        isChanged = step(k);
      }
    };
    repeat(MostRounds, 0.6, 0.84,
      [this](Id /*round*/)
      {
        const bool isMoved = this->MoveBad(At35);
        return this->ChangeBad(At38) || isMoved;
      });
    repeat(MostRounds, 0.84, 0.92, [this](Id /*round*/) { return this->LoosenWorst(At30); });
    repeat(MostRoundsOfTrials, 0.92, 1.0, [this](Id round) { return this->TryWorst(round); });
    this->Tets.GiveBack();
  }

  void RemoveFlat()
  {
    constexpr int MostRounds = 4;
    bool isChanged = true;
    for (int round = 0; round < MostRounds && isChanged && this->Beats.Ask(); ++round)
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
