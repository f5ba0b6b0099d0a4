// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef MeshChecker_h
#define MeshChecker_h

#include "Kernel/Predicates/Predicates.h"

#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <algorithm> // for sort
#include <cmath>     // for abs
#include <map>       // for places
#include <set>       // for visited vertices
#include <string>    // for the verdict
#include <vector>    // for the arrays

/// A judge of meshes in the plane z = constant that shares nothing with the mesher but the exact
/// orientation: it knows only the output, the input and what is expected.
namespace testing_filters
{

class MeshChecker
{
public:
  enum class Coinciding
  {
    Refused,
    Allowed
  };

  explicit MeshChecker(vtkPolyData* mesh);

  /// Checks: all cells triangles; each exactly counterclockwise; every directed edge used once; no
  /// duplicate and no unused points; the area by triangles is that by the boundary, so that nothing
  /// overlaps. Returns the first violation, empty where there is none. Of meshes with cracks points
  /// may coincide.
  std::string CheckValidity(Coinciding points = Coinciding::Refused) const;

  /// Checks the area, within `tolerance`.
  std::string CheckArea(double expected, double tolerance) const;

  /// Checks that the segment from `a` to `b` is a union of edges whose vertices lie within
  /// `tolerance` of it.
  bool Covers(const biting::Point2& a, const biting::Point2& b, double tolerance) const;

  bool HasVertex(const biting::Point2& p) const { return this->Vertices.count(p) > 0; }
  double Area() const;

private:
  struct Edge
  {
    vtkIdType Start;
    vtkIdType End;
    bool operator<(const Edge& other) const
    {
      return this->Start < other.Start || (this->Start == other.Start && this->End < other.End);
    }
    bool operator==(const Edge& other) const
    {
      return this->Start == other.Start && this->End == other.End;
    }
  };

  const biting::Point2& At(vtkIdType point) const
  {
    return this->Points[static_cast<std::size_t>(point)];
  }
  double SignedArea(vtkIdType a, vtkIdType b) const;
  double BoundaryArea() const;
  void AddNextOnSegment(vtkIdType vertex, const biting::Point2& a, const biting::Point2& b,
    double tolerance, std::vector<vtkIdType>& next) const;

  std::vector<biting::Point2> Points;
  std::vector<vtkIdType> Corners;
  std::vector<Edge> Edges;      // directed, sorted
  std::vector<Edge> Undirected; // both directions of each, sorted
  std::map<biting::Point2, vtkIdType> Vertices;
  bool HasOtherCells = false;
};

inline MeshChecker::MeshChecker(vtkPolyData* mesh)
{
  for (vtkIdType point = 0; point < mesh->GetNumberOfPoints(); ++point)
  {
    const double* place = mesh->GetPoint(point);
    this->Points.push_back({ place[0], place[1] });
    this->Vertices[this->Points.back()] = point;
  }
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    mesh->GetCellPoints(cell, ids);
    this->HasOtherCells = this->HasOtherCells || ids->GetNumberOfIds() != 3;
    for (vtkIdType k = 0; k < 3 && !this->HasOtherCells; ++k)
    {
      const Edge edge{ ids->GetId(k), ids->GetId((k + 1) % 3) };
      this->Corners.push_back(edge.Start);
      this->Edges.push_back(edge);
      this->Undirected.push_back(edge);
      this->Undirected.push_back({ edge.End, edge.Start });
    }
  }
  std::sort(this->Edges.begin(), this->Edges.end());
  std::sort(this->Undirected.begin(), this->Undirected.end());
}

inline std::string MeshChecker::CheckValidity(Coinciding points) const
{
  if (this->HasOtherCells || this->Corners.empty())
  {
    return this->HasOtherCells ? "a cell is no triangle" : "there are no triangles";
  }
  std::vector<bool> isUsed(this->Points.size(), false);
  for (std::size_t k = 0; k < this->Corners.size(); k += 3)
  {
    const biting::Point2& a = this->At(this->Corners[k]);
    if (biting::Orient2D(a, this->At(this->Corners[k + 1]), this->At(this->Corners[k + 2])) <= 0)
    {
      return "triangle " + std::to_string(k / 3) + " is not counterclockwise";
    }
  }
  for (const vtkIdType corner : this->Corners)
  {
    isUsed[static_cast<std::size_t>(corner)] = true;
  }
  if (std::find(isUsed.begin(), isUsed.end(), false) != isUsed.end())
  {
    return "a point is not used";
  }
  if (points == Coinciding::Refused && this->Vertices.size() != this->Points.size())
  {
    return "two points coincide";
  }
  if (std::adjacent_find(this->Edges.begin(), this->Edges.end()) != this->Edges.end())
  {
    return "an edge is used twice in one direction";
  }
  return std::abs(this->BoundaryArea() - this->Area()) <= 1e-9 * this->Area()
    ? ""
    : "triangles overlap: the area by the boundary is another";
}

inline std::string MeshChecker::CheckArea(double expected, double tolerance) const
{
  return std::abs(this->Area() - expected) <= tolerance
    ? ""
    : "the area is " + std::to_string(this->Area() / expected) + " of the expected";
}

// The area left of the edge, as seen from the first vertex.
inline double MeshChecker::SignedArea(vtkIdType a, vtkIdType b) const
{
  const biting::Point2& origin = this->Points.front();
  return 0.5 * Cross(this->At(a) - origin, this->At(b) - origin);
}

inline double MeshChecker::Area() const
{
  long double area = 0.0L;
  for (std::size_t k = 0; k < this->Corners.size(); k += 3)
  {
    const biting::Point2& a = this->At(this->Corners[k]);
    area += 0.5 * Cross(this->At(this->Corners[k + 1]) - a, this->At(this->Corners[k + 2]) - a);
  }
  return static_cast<double>(area);
}

inline double MeshChecker::BoundaryArea() const
{
  long double area = 0.0L;
  for (const Edge& edge : this->Edges)
  {
    if (!std::binary_search(this->Edges.begin(), this->Edges.end(), Edge{ edge.End, edge.Start }))
    {
      area += this->SignedArea(edge.Start, edge.End);
    }
  }
  return static_cast<double>(area);
}

inline bool MeshChecker::Covers(
  const biting::Point2& a, const biting::Point2& b, double tolerance) const
{
  const auto start = this->Vertices.find(a);
  const auto end = this->Vertices.find(b);
  if (start == this->Vertices.end() || end == this->Vertices.end())
  {
    return false;
  }
  // Where two chains nearly coincide there are several ways on: all are tried.
  std::vector<vtkIdType> open{ start->second };
  std::set<vtkIdType> seen;
  while (!open.empty() && open.back() != end->second)
  {
    const vtkIdType vertex = open.back();
    open.pop_back();
    if (seen.insert(vertex).second)
    {
      this->AddNextOnSegment(vertex, a, b, tolerance, open);
    }
  }
  return !open.empty();
}

// The neighbours of `vertex` that are nearer to b, and near enough to the segment.
inline void MeshChecker::AddNextOnSegment(vtkIdType vertex, const biting::Point2& a,
  const biting::Point2& b, double tolerance, std::vector<vtkIdType>& next) const
{
  const double length = Distance(a, b);
  const double remaining = Distance(this->At(vertex), b);
  for (auto edge =
         std::lower_bound(this->Undirected.begin(), this->Undirected.end(), Edge{ vertex, -1 });
       edge != this->Undirected.end() && edge->Start == vertex; ++edge)
  {
    const biting::Point2& p = this->At(edge->End);
    if (std::abs(Cross(b - a, p - a)) <= tolerance * length && Distance(p, b) < remaining)
    {
      next.push_back(edge->End);
    }
  }
}

} // namespace testing_filters

#endif
