// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "RegionEdges.h"

#include "../Base/IdLists.h"

#include <algorithm>  // for max, minmax, sort, swap
#include <cmath>      // for abs, round
#include <functional> // for the choice
#include <utility>    // for swap, pairs

namespace biting
{

namespace
{

double DistanceToLine(const Point2& p, const Point2& a, const Point2& b)
{
  const double length = Distance(a, b);
  return length > 0.0 ? std::abs(Cross(b - a, p - a)) / length : Distance(p, a);
}

/// A walk along edges, from a vertex that stays to the next one.
struct Run
{
  std::vector<Id> Vertices;
  std::vector<Id> Edges;
};

/// Marks the places of a run that stay, besides its ends.
using Choice =
  std::function<void(const std::vector<Id>&, std::size_t, std::size_t, std::vector<std::uint8_t>&)>;

class EdgeReader
{
public:
  /// `left`: as for ThinnedEdges, or null.
  EdgeReader(const OldMesh& mesh, const ChangedRegion& region, EdgePolicy policy,
    const std::vector<std::uint8_t>* left)
    : Mesh(mesh)
    , Region(region)
    , Policy(policy)
    , Left(left)
  {
  }

  /// `choose` marks what stays of a straight piece.
  RegionEdges Read(const Choice& choose)
  {
    this->ReadSlots();
    this->ListIncidences();
    this->FindLoose();
    this->Result.IsKept.assign(this->Region.Vertices.size(), 0);
    this->Result.IsGone.assign(this->Region.Vertices.size(), 0);
    this->IsWalked.assign(this->Old.size(), 0);
    // Loops without a vertex that stays begin anywhere, so they come last.
    for (const bool isLoop : { false, true })
    {
      for (Id vertex = 0; vertex < this->Region.NumberOfVertices(); ++vertex)
      {
        for (const Id edge : this->Incidences[vertex])
        {
          if (!this->IsWalked[edge] && (isLoop || !this->AreLoose[vertex]))
          {
            this->AreLoose[vertex] = 0;
            this->Reduce(this->Walk(vertex, edge), choose);
          }
        }
      }
    }
    return std::move(this->Result);
  }

private:
  void ReadSlots()
  {
    for (const Id triangle : this->Region.Triangles)
    {
      for (Id slot = 3 * triangle; slot < 3 * triangle + 3; ++slot)
      {
        const Id neighbor = this->Mesh.Neighbors[slot];
        const bool isOnRim = neighbor != NoId && !this->Region.IsChanged[neighbor];
        const bool isFirst = isOnRim || neighbor < triangle;
        if (isFirst && (isOnRim || this->Mesh.Marks[slot] != NoId))
        {
          this->Old.push_back({ this->Region.Numbers[this->Mesh.Start(slot)],
            this->Region.Numbers[this->Mesh.End(slot)], this->Mesh.Marks[slot],
            this->Mesh.Regions[triangle],
            neighbor == NoId || isOnRim ? NoId : this->Mesh.Regions[neighbor],
            isOnRim ? this->Mesh.Across(slot) : NoId });
        }
      }
    }
  }

  void ListIncidences()
  {
    this->Incidences = IdLists(this->Region.Vertices.size(),
      [this](const auto& add)
      {
        for (Id edge = 0; edge < static_cast<Id>(this->Old.size()); ++edge)
        {
          add(this->Old[edge].Start, edge);
          add(this->Old[edge].End, edge);
        }
      });
  }

  void FindLoose()
  {
    this->AreLoose.assign(this->Region.Vertices.size(), 0);
    for (Id vertex = 0; vertex < this->Region.NumberOfVertices(); ++vertex)
    {
      this->AreLoose[vertex] = this->Policy == EdgePolicy::Free &&
        (this->Left ? (*this->Left)[vertex] == 0 : this->IsLoose(vertex));
    }
  }

  bool IsLoose(Id vertex) const
  {
    const IdLists::List edges = this->Incidences[vertex];
    if (!this->Region.IsInside[vertex] || edges.Size() != 2)
    {
      return false;
    }
    const Id one = edges[0];
    const Id two = edges[1];
    const Point2& before = this->Place(this->OtherEnd(one, vertex));
    const Point2& after = this->Place(this->OtherEnd(two, vertex));
    const Point2& place = this->Place(vertex);
    return this->AreAlike(vertex, this->Old[one], this->Old[two]) &&
      Dot(place - before, after - place) > 0.0 &&
      DistanceToLine(place, before, after) <= this->Mesh.Rounding;
  }

  bool AreAlike(Id vertex, const RegionEdge& a, const RegionEdge& b) const
  {
    if (this->Mesh.IsFrozenEdge(a.Mark) || this->Mesh.IsFrozenEdge(b.Mark))
    {
      return false;
    }
    const bool isStraight = (a.End == vertex) == (b.Start == vertex);
    const Id left = isStraight ? b.LeftRegion : b.RightRegion;
    const Id right = isStraight ? b.RightRegion : b.LeftRegion;
    return this->Mesh.HaveEqualTags(a.Mark, b.Mark) && a.LeftRegion == left &&
      a.RightRegion == right;
  }

  Id OtherEnd(Id edge, Id vertex) const
  {
    return this->Old[edge].Start == vertex ? this->Old[edge].End : this->Old[edge].Start;
  }

  Run Walk(Id vertex, Id edge)
  {
    Run run{ { vertex }, {} };
    while (true)
    {
      this->IsWalked[edge] = 1;
      run.Edges.push_back(edge);
      vertex = this->OtherEnd(edge, vertex);
      run.Vertices.push_back(vertex);
      if (!this->AreLoose[vertex])
      {
        return run;
      }
      const IdLists::List edges = this->Incidences[vertex];
      edge = edges[0] == edge ? edges[1] : edges[0];
    }
  }

  void Reduce(const Run& run, const Choice& choose)
  {
    std::vector<std::uint8_t> stays(run.Vertices.size(), 0);
    stays.front() = 1;
    stays.back() = 1;
    if (!this->Left)
    {
      this->Straighten(run, stays);
    }
    std::size_t first = 0;
    for (std::size_t last = 1; last < stays.size(); ++last)
    {
      if (stays[last])
      {
        choose(run.Vertices, first, last, stays);
        first = last;
      }
    }
    this->Emit(run, stays);
  }

  // Where small bends add up, the vertex farthest from the line stays, as in Douglas and Peucker,
  // "Algorithms for the reduction of the number of points required to represent a digitized line",
  // 1973.
  void Straighten(const Run& run, std::vector<std::uint8_t>& stays) const
  {
    std::vector<std::pair<std::size_t, std::size_t>> pieces{ { 0, run.Vertices.size() - 1 } };
    while (!pieces.empty())
    {
      const auto [first, last] = pieces.back();
      pieces.pop_back();
      double farthest = this->Mesh.Rounding;
      std::size_t middle = first;
      for (std::size_t k = first + 1; k < last; ++k)
      {
        const double distance = DistanceToLine(this->Place(run.Vertices[k]),
          this->Place(run.Vertices[first]), this->Place(run.Vertices[last]));
        middle = distance > farthest ? k : middle;
        farthest = std::max(farthest, distance);
      }
      if (middle != first)
      {
        stays[middle] = 1;
        pieces.emplace_back(first, middle);
        pieces.emplace_back(middle, last);
      }
    }
  }

  void Emit(const Run& run, const std::vector<std::uint8_t>& stays)
  {
    RegionEdge edge;
    for (std::size_t k = 0; k < run.Vertices.size(); ++k)
    {
      (stays[k] ? this->Result.IsKept : this->Result.IsGone)[run.Vertices[k]] = 1;
      if (stays[k] && k > 0)
      {
        edge.End = run.Vertices[k];
        this->Result.Edges.push_back(edge);
        this->Result.GoneOffsets.push_back(static_cast<Id>(this->Result.Gone.size()));
      }
      if (!stays[k])
      {
        this->Result.Gone.push_back(run.Vertices[k]);
      }
      if (stays[k] && k + 1 < run.Vertices.size())
      {
        edge = this->Old[run.Edges[k]];
        if (edge.Start != run.Vertices[k])
        {
          std::swap(edge.Start, edge.End);
          std::swap(edge.LeftRegion, edge.RightRegion);
        }
      }
    }
  }

  const Point2& Place(Id vertex) const { return this->Mesh.Points[this->Region.Vertices[vertex]]; }

  const OldMesh& Mesh;
  const ChangedRegion& Region;
  EdgePolicy Policy;
  const std::vector<std::uint8_t>* Left;
  std::vector<RegionEdge> Old;
  IdLists Incidences;                 ///< the edges at a vertex
  std::vector<std::uint8_t> AreLoose; ///< of a vertex: it may go, if its piece is straight
  std::vector<std::uint8_t> IsWalked; ///< of an edge
  RegionEdges Result;
};

/// Chooses vertices by lengths in units of f.
class Thinning
{
public:
  Thinning(const OldMesh& mesh, const ChangedRegion& region, const std::vector<double>& spacings,
    const KeepRules& rules)
    : Mesh(mesh)
    , Region(region)
    , Spacings(spacings)
    , Rules(rules)
  {
  }

  // Vertices that are not crowded stay; between these, of each run of crowded ones, those nearest
  // to the ends of equal parts, if they are near.
  void Choose(const std::vector<Id>& vertices, std::size_t first, std::size_t last,
    std::vector<std::uint8_t>& stays)
  {
    this->Sums.assign(1, 0.0);
    for (std::size_t k = first; k < last; ++k)
    {
      this->Sums.push_back(this->Sums.back() + this->Length(vertices[k], vertices[k + 1]));
    }
    std::size_t begin = 0;
    for (std::size_t k = 1; k <= last - first; ++k)
    {
      const bool isCrowded =
        k < last - first && 0.5 * (this->Sums[k + 1] - this->Sums[k - 1]) < this->Rules.Lowest;
      if (!isCrowded)
      {
        this->ChooseOfRun(begin, k, stays.data() + first);
        stays[first + k] = 1;
        begin = k;
      }
    }
  }

private:
  double Length(Id a, Id b) const
  {
    const double length = Distance(
      this->Mesh.Points[this->Region.Vertices[a]], this->Mesh.Points[this->Region.Vertices[b]]);
    return 2.0 * length / (this->Spacings[a] + this->Spacings[b]);
  }

  void ChooseOfRun(std::size_t begin, std::size_t end, std::uint8_t* stays) const
  {
    const double whole = this->Sums[end] - this->Sums[begin];
    const double parts = std::max(1.0, std::round(whole));
    std::size_t next = begin + 1;
    double shiftBefore = 0.0;
    for (double part = 1.0; part < parts && next < end; part += 1.0)
    {
      const double wanted = this->Sums[begin] + whole * part / parts;
      while (next + 1 < end && this->Sums[next + 1] - wanted < wanted - this->Sums[next])
      {
        ++next;
      }
      const double shift = (this->Sums[next] - wanted) * parts / whole;
      const bool isNear = std::abs(shift) <= this->Rules.GreatestShift &&
        std::abs(shift - shiftBefore) <= this->Rules.GreatestChangeOfShift;
      stays[next] |= isNear;
      shiftBefore = isNear ? shift : 0.0;
      ++next;
    }
  }

  const OldMesh& Mesh;
  const ChangedRegion& Region;
  const std::vector<double>& Spacings;
  const KeepRules& Rules;
  std::vector<double> Sums; ///< lengths from the beginning
};

void ChooseNone(const std::vector<Id>&, std::size_t, std::size_t, std::vector<std::uint8_t>&) {}

} // namespace

RegionEdges StraightPieces(const OldMesh& mesh, const ChangedRegion& region, EdgePolicy policy)
{
  return EdgeReader(mesh, region, policy, nullptr).Read(ChooseNone);
}

RegionEdges PiecesBetween(
  const OldMesh& mesh, const ChangedRegion& region, const std::vector<std::uint8_t>& left)
{
  return EdgeReader(mesh, region, EdgePolicy::Free, &left).Read(ChooseNone);
}

RegionEdges ThinnedEdges(const OldMesh& mesh, const ChangedRegion& region,
  const std::vector<double>& spacings, const KeepRules& rules, EdgePolicy policy,
  const std::vector<std::uint8_t>* left)
{
  Thinning thinning(mesh, region, spacings, rules);
  const auto choose = [&thinning](const std::vector<Id>& vertices, std::size_t first,
                        std::size_t last, std::vector<std::uint8_t>& stays)
  { thinning.Choose(vertices, first, last, stays); };
  return EdgeReader(mesh, region, policy, left).Read(choose);
}

} // namespace biting
