// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

// Each vertex v starts with the squared length of its shortest edge, r^2. Let w be a vertex in the
// open disc B(v, r). If no edge at v is a boundary edge, the triangles at v surround it, none
// contains w, and none of their corners is in B; so the way from v to w leaves one of them, vab,
// through the inside of ab. Let d be the apex beyond ab. Then w is d, or the way leaves abd through
// ad or bd, which B meets. So N(v) is known from the corners of the triangles at v and the apexes
// beyond them, unless v has a boundary edge, or B meets a boundary edge ab, or both ab and ad (or
// bd). Where the angles vad and vbd are at least 90 degrees, B does not meet ad or bd outside of a
// and b, and vd is longer than va: the usual case costs two dot products for both v and d. The
// other vertices are suspects: they are searched for in a tree. The argument uses no property of
// the triangulation but that triangles do not overlap.

#include "NearestNeighbors.h"

#include "../Base/Marks.h"
#include "../Base/Numbers.h"
#include "../Base/Pulse.h"
#include "../Base/Tasks.h"
#include "CellMask.h"
#include "PointTree.h"

#include <algorithm> // for min, max
#include <atomic>    // for what threads share
#include <cmath>     // for sqrt, abs
#include <cstdint>   // for flags
#include <numeric>   // for iota
#include <utility>   // for move

namespace biting
{

namespace
{

constexpr double Close = 1e-13; // of the largest coordinate: some hundred ulp

// Where steps end, as shares of the time for a mesh with few suspects; of all points, the tree.
constexpr double VisitEnd = 0.8;
constexpr double SearchEnd = 0.95;
constexpr double TreeEnd = 0.4;

double SquaredDistance(const Point2& a, const Point2& b)
{
  const Point2 offset = b - a;
  return Dot(offset, offset);
}

// False only if the segment ab stays out of the open disc about `center`. Its ends must do so.
// Cross is rounded by at most 4 epsilon |ca| |ab|; as 2 x y <= k x^2 + y^2 / k, that is covered by
// k = 1e-6 of its square and 1e6 (4 epsilon)^2 < 1e-24 of |ca|^2 |ab|^2.
bool Reaches(const Point2& center, double squaredRadius, const Point2& a, const Point2& b)
{
  const Point2 side = b - a;
  const Point2 offset = center - a;
  const double squaredLength = Dot(side, side);
  const double along = Dot(offset, side);
  if (along <= 0.0 || along >= squaredLength)
  {
    return false;
  }
  const double height = Cross(side, offset);
  return height * height * (1.0 - 1e-6) <
    squaredLength * (squaredRadius + 1e-24 * Dot(offset, offset));
}

// The least of what is told for each of so many things, infinite at first; from several threads.
class LeastValues
{
public:
  explicit LeastValues(std::size_t count)
    : Values(count)
  {
  }

  std::size_t Size() const { return this->Values.size(); }
  double operator[](std::size_t k) const { return this->Values[k].load(std::memory_order_relaxed); }
  void Set(std::size_t k, double value) { this->Values[k].store(value, std::memory_order_relaxed); }

  /// The plain way is for one thread only.
  void Lower(std::size_t k, double value, bool isAlone)
  {
    double known = (*this)[k];
    if (isAlone)
    {
      this->Set(k, std::min(known, value));
      return;
    }
    while (value < known &&
      !this->Values[k].compare_exchange_weak(known, value, std::memory_order_relaxed))
    {
    }
  }

private:
  std::vector<std::atomic<double>> Values;
};

// Vertices whose distances are not known, in their order.
struct SuspectList
{
  std::vector<Id> Vertices;
  bool AreAllUsed = true; ///< by triangles

  void Join(const SuspectList& other)
  {
    this->Vertices.insert(this->Vertices.end(), other.Vertices.begin(), other.Vertices.end());
    this->AreAllUsed = this->AreAllUsed && other.AreAllUsed;
  }
};

// Vertices that may be the nearest of suspects, in their order.
struct CandidateList
{
  std::vector<PointTree::Item> Items;

  void Join(const CandidateList& other)
  {
    this->Items.insert(this->Items.end(), other.Items.begin(), other.Items.end());
  }
};

struct Largest
{
  double Value = 0.0;

  void Join(const Largest& other) { this->Value = std::max(this->Value, other.Value); }
};

class NeighborSearch
{
public:
  NeighborSearch(const std::vector<Point2>& points, const std::vector<Id>& corners,
    const std::vector<Id>& neighbors, Pulse& pulse);
  void VisitEdges();
  void SearchSuspects(std::vector<Id>* found);
  std::vector<double> Distances() const;

private:
  void VisitTriangle(Id triangle);
  void VisitEdge(Id triangle, int corner);
  void JudgeBoundaryEdge(Id a, Id b, Id apex);
  void JudgeInnerEdge(Id a, Id b, Id apex, Id beyond);
  void JudgeApex(Id apex, Id a, Id b, Id beyond);
  void Shorten(Id vertex, double squaredDistance);
  double LargestCoordinate() const;
  std::vector<Id> Suspects() const;
  PointTree TreeFor(const std::vector<Id>& suspects) const;
  CellMask CellsOf(const std::vector<Id>& suspects) const;
  std::vector<PointTree::Item> Candidates(const CellMask& cells) const;

  const Point2& Place(Id vertex) const { return this->Points[static_cast<std::size_t>(vertex)]; }

  const std::vector<Point2>& Points;
  const std::vector<Id>& Corners;
  const std::vector<Id>& Neighbors;
  Pulse& Beats;
  bool IsAlone; ///< one thread visits the edges
  LeastValues SquaredDistances;
  Marks IsSuspect;
};

NeighborSearch::NeighborSearch(const std::vector<Point2>& points, const std::vector<Id>& corners,
  const std::vector<Id>& neighbors, Pulse& pulse)
  : Points(points)
  , Corners(corners)
  , Neighbors(neighbors)
  , Beats(pulse)
  , IsAlone(pulse.Threads().NumberOfThreads() == 1)
  , SquaredDistances(points.size())
  , IsSuspect(points.size())
{
}

void NeighborSearch::VisitEdges()
{
  const PulsePart part(this->Beats, 0.0, VisitEnd);
  ForEachAtOnce(this->Beats, this->Points.size(),
    [this](std::size_t vertex) { this->SquaredDistances.Set(vertex, Infinity); });
  ForEachAtOnce(this->Beats, this->Corners.size() / 3,
    [this](std::size_t triangle) { this->VisitTriangle(static_cast<Id>(triangle)); });
}

void NeighborSearch::VisitTriangle(Id triangle)
{
  for (int corner = 0; corner < 3; ++corner)
  {
    // An inner edge is visited from the triangle with the larger id.
    if (this->Neighbors[3 * static_cast<std::size_t>(triangle) + corner] < triangle)
    {
      this->VisitEdge(triangle, corner);
    }
  }
}

void NeighborSearch::VisitEdge(Id triangle, int corner)
{
  const Id* own = &this->Corners[3 * static_cast<std::size_t>(triangle)];
  const Id apex = own[corner];
  const Id a = own[corner == 2 ? 0 : corner + 1];
  const Id b = own[corner == 0 ? 2 : corner - 1];
  const double squaredLength = SquaredDistance(this->Place(a), this->Place(b));
  this->Shorten(a, squaredLength);
  this->Shorten(b, squaredLength);
  const Id across = this->Neighbors[3 * static_cast<std::size_t>(triangle) + corner];
  if (across == NoId)
  {
    this->JudgeBoundaryEdge(a, b, apex);
    return;
  }
  const Id* other = &this->Corners[3 * static_cast<std::size_t>(across)];
  this->JudgeInnerEdge(a, b, apex, other[0] ^ other[1] ^ other[2] ^ a ^ b);
}

void NeighborSearch::JudgeInnerEdge(Id a, Id b, Id apex, Id beyond)
{
  const Point2& p = this->Place(apex);
  const Point2& q = this->Place(beyond);
  if (Dot(p - this->Place(a), q - this->Place(a)) > 0.0 ||
    Dot(p - this->Place(b), q - this->Place(b)) > 0.0)
  {
    this->JudgeApex(apex, a, b, beyond);
    this->JudgeApex(beyond, a, b, apex);
  }
}

void NeighborSearch::JudgeBoundaryEdge(Id a, Id b, Id apex)
{
  // The boundary runs on from b: another edge marks that.
  this->IsSuspect.Set(static_cast<std::size_t>(a), 1);
  const Point2& p = this->Place(apex);
  const double squaredRadius =
    std::min(SquaredDistance(p, this->Place(a)), SquaredDistance(p, this->Place(b)));
  if (Reaches(p, squaredRadius, this->Place(a), this->Place(b)))
  {
    this->IsSuspect.Set(static_cast<std::size_t>(apex), 1);
  }
}

void NeighborSearch::JudgeApex(Id apex, Id a, Id b, Id beyond)
{
  const Point2& p = this->Place(apex);
  const Point2& q = this->Place(beyond);
  this->Shorten(apex, SquaredDistance(p, q));
  const double squaredRadius = std::min({ this->SquaredDistances[static_cast<std::size_t>(apex)],
    SquaredDistance(p, this->Place(a)), SquaredDistance(p, this->Place(b)) });
  if (Reaches(p, squaredRadius, this->Place(a), this->Place(b)) &&
    (Reaches(p, squaredRadius, this->Place(a), q) || Reaches(p, squaredRadius, this->Place(b), q)))
  {
    this->IsSuspect.Set(static_cast<std::size_t>(apex), 1);
  }
}

void NeighborSearch::Shorten(Id vertex, double squaredDistance)
{
  this->SquaredDistances.Lower(static_cast<std::size_t>(vertex), squaredDistance, this->IsAlone);
}

void NeighborSearch::SearchSuspects(std::vector<Id>* found)
{
  const PulsePart part(this->Beats, VisitEnd, SearchEnd);
  const std::vector<Id> suspects = this->Suspects();
  if (suspects.empty() || this->Beats.HasStopped())
  {
    return;
  }
  const PointTree tree = this->TreeFor(suspects);
  const PulsePart search(this->Beats, TreeEnd, 1.0);
  ForEachAtOnce(this->Beats, suspects.size(),
    [this, &suspects, &tree](std::size_t k)
    {
      const std::size_t vertex = static_cast<std::size_t>(suspects[k]);
      const double known = this->SquaredDistances[vertex];
      this->SquaredDistances.Set(
        vertex, tree.NearestSquaredDistance(this->Place(suspects[k]), suspects[k], known));
    });
  if (found)
  {
    *found = suspects;
  }
}

PointTree NeighborSearch::TreeFor(const std::vector<Id>& suspects) const
{
  const PulsePart part(this->Beats, 0.0, 0.0);
  return PointTree(this->Candidates(this->CellsOf(suspects)), this->Beats);
}

// A vertex without triangle is hidden from all others: where there is one, all are suspects. So are
// vertices whose neighbors are so close that rounding decides where they are seen.
std::vector<Id> NeighborSearch::Suspects() const
{
  const double close = Close * this->LargestCoordinate();
  SuspectList list = SumAtOnce(this->Beats, this->Points.size(), SuspectList(),
    [this, close](SuspectList& own, std::size_t i)
    {
      const double distance = this->SquaredDistances[i];
      own.AreAllUsed = own.AreAllUsed && distance < Infinity;
      if (this->IsSuspect[i] != 0 || distance <= close * close)
      {
        own.Vertices.push_back(static_cast<Id>(i));
      }
    });
  if (!list.AreAllUsed)
  {
    list.Vertices.resize(this->Points.size());
    std::iota(list.Vertices.begin(), list.Vertices.end(), 0);
  }
  return std::move(list.Vertices);
}

double NeighborSearch::LargestCoordinate() const
{
  return SumAtOnce(this->Beats, this->Points.size(), Largest(),
    [this](Largest& own, std::size_t i) {
      own.Value = std::max({ own.Value, std::abs(this->Points[i].X), std::abs(this->Points[i].Y) });
    })
    .Value;
}

CellMask NeighborSearch::CellsOf(const std::vector<Id>& suspects) const
{
  CellMask cells(this->Points, suspects.size(), this->Beats);
  this->Beats.ForEach(suspects.size(),
    [this, &suspects, &cells](std::size_t k)
    {
      const auto suspect = static_cast<std::size_t>(suspects[k]);
      cells.Add(this->Points[suspect], std::sqrt(this->SquaredDistances[suspect]));
    });
  return cells;
}

std::vector<PointTree::Item> NeighborSearch::Candidates(const CellMask& cells) const
{
  return SumAtOnce(this->Beats, this->Points.size(), CandidateList(),
    [this, &cells](CandidateList& own, std::size_t i)
    {
      if (cells.IsFull() || cells.Contains(this->Points[i]))
      {
        own.Items.push_back({ this->Points[i], static_cast<Id>(i) });
      }
    })
    .Items;
}

std::vector<double> NeighborSearch::Distances() const
{
  const PulsePart part(this->Beats, SearchEnd, 1.0);
  std::vector<double> distances;
  GrowInSteps(distances, this->SquaredDistances.Size(), 0.0, this->Beats);
  ForEachAtOnce(this->Beats, distances.size(),
    [this, &distances](std::size_t i) { distances[i] = std::sqrt(this->SquaredDistances[i]); });
  return this->Beats.HasStopped() ? std::vector<double>() : distances;
}

} // namespace

std::vector<double> NearestNeighborDistances(const std::vector<Point2>& points,
  const std::vector<Id>& corners, const std::vector<Id>& neighbors, Monitor& monitor,
  std::vector<Id>* suspects)
{
  Pulse pulse(monitor);
  NeighborSearch search(points, corners, neighbors, pulse);
  search.VisitEdges();
  search.SearchSuspects(suspects);
  return search.Distances();
}

std::vector<double> NearestNeighborDistances(const std::vector<Point2>& points, Monitor& monitor)
{
  Pulse pulse(monitor);
  std::vector<PointTree::Item> items(points.size());
  std::vector<double> distances(points.size());
  for (std::size_t i = 0; i < points.size() && pulse.Beat(); ++i)
  {
    items[i] = { points[i], static_cast<Id>(i) };
  }
  const PointTree tree(std::move(items), pulse);
  for (std::size_t i = 0; i < points.size() && pulse.Beat(); ++i)
  {
    pulse.SetFraction(static_cast<double>(i) / static_cast<double>(points.size()));
    const double square = tree.NearestSquaredDistance(points[i], static_cast<Id>(i), Infinity);
    distances[i] = std::sqrt(square);
  }
  return pulse.HasStopped() ? std::vector<double>() : distances;
}

} // namespace biting
