// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingMeshRun_h
#define BitingMeshRun_h

#include "BitingMesh.h"
#include "Domain/Polylines.h"
#include "PolylineShapes.h"

#include <algorithm> // for max
#include <string>    // for texts
#include <vector>    // for lists

namespace biting
{

/// A mesh with what was said while it was made.
struct MeshRun
{
  BitingMesh Mesh;
  ProblemList Problems;

  Id NumberOfVertices() const { return static_cast<Id>(this->Mesh.Points.size()); }
  Id NumberOfTriangles() const { return static_cast<Id>(this->Mesh.Corners.size() / 3); }

  /// The first of the problems that leave no mesh, as text; empty where there is none.
  std::string Error() const
  {
    for (const ProblemGroup& group : this->Problems.Groups())
    {
      if (IsError(group.Code))
      {
        return "problem " + std::to_string(static_cast<int>(group.Code)) + ": " +
          group.First.front().Detail;
      }
    }
    return {};
  }
};

inline MeshRun RunMesh(const Polylines& input, const BitingMeshOptions& options)
{
  MeshRun run;
  SilentMonitor monitor;
  run.Mesh = MakeBitingMesh(input, options, run.Problems, monitor);
  return run;
}

/// Of the unit square.
inline BitingMesh SquareMesh(double spacing)
{
  BitingMeshOptions options;
  options.Spacing.Uniform = spacing;
  return RunMesh(PolylineBuilder().Box(0.0, 0.0, 1.0, 1.0).Lines(), options).Mesh;
}

inline double Area(const BitingMesh& mesh)
{
  double area = 0.0;
  for (std::size_t k = 0; k < mesh.Corners.size(); k += 3)
  {
    const Point2& a = mesh.Points[mesh.Corners[k]];
    area += 0.5 * Cross(mesh.Points[mesh.Corners[k + 1]] - a, mesh.Points[mesh.Corners[k + 2]] - a);
  }
  return area;
}

inline std::string Text(const Point2& place)
{
  return "(" + std::to_string(place.X) + ", " + std::to_string(place.Y) + ")";
}

/// Squares in buckets: which bites may reach a point, found without the structures under test.
class BiteBuckets
{
public:
  explicit BiteBuckets(const Bites& bites)
    : Squares(bites)
  {
    double reach = 0.0;
    for (Id bite = 0; bite < bites.Size(); ++bite)
    {
      this->Bounds.Add(bites.Centers[bite]);
      reach = std::max(reach, bites.HalfWidths[bite]);
    }
    this->Bounds.Grow(2.0 * reach);
    this->Lists.resize(static_cast<std::size_t>(Columns) * Columns);
    for (Id bite = 0; bite < bites.Size(); ++bite)
    {
      this->File(bite);
    }
  }

  /// Calls visit(bite) for all bites that may contain p.
  template <typename Visit>
  void VisitNear(const Point2& p, Visit&& visit) const
  {
    for (Id bite : this->Lists[Column(p.X, this->Bounds.Low.X, this->Bounds.Width()) +
           Columns * Column(p.Y, this->Bounds.Low.Y, this->Bounds.Height())])
    {
      visit(bite);
    }
  }

private:
  static constexpr std::size_t Columns = 80;

  static std::size_t Column(double x, double low, double width)
  {
    const double column = (x - low) / width * static_cast<double>(Columns);
    return std::min(Columns - 1, static_cast<std::size_t>(std::max(0.0, column)));
  }

  void File(Id bite)
  {
    const Point2 center = this->Squares.Centers[bite];
    const double reach = 1.5 * this->Squares.HalfWidths[bite];
    const Point2 low = this->Bounds.Low;
    const double height = this->Bounds.Height();
    const double width = this->Bounds.Width();
    const std::size_t lastRow = Column(center.Y + reach, low.Y, height);
    const std::size_t lastColumn = Column(center.X + reach, low.X, width);
    for (std::size_t row = Column(center.Y - reach, low.Y, height); row <= lastRow; ++row)
    {
      for (std::size_t c = Column(center.X - reach, low.X, width); c <= lastColumn; ++c)
      {
        this->Lists[row * Columns + c].push_back(bite);
      }
    }
  }

  const Bites& Squares;
  Box2 Bounds;
  std::vector<std::vector<Id>> Lists;
};

} // namespace biting

#endif
