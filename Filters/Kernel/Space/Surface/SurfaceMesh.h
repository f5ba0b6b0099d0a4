// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingSurfaceMesh_h
#define BitingSurfaceMesh_h

#include "../../Base/Box.h"
#include "../../Base/Ids.h"
#include "../../Base/Point.h"
#include "../../Base/TriangleSlots.h"

#include <array>  // for the corners of a triangle
#include <vector> // for the arrays

namespace biting
{

/// The place of an item in an array.
inline std::size_t At(Id id)
{
  return static_cast<std::size_t>(id);
}

/// Numbers of the regions that a triangle bounds, on either side; the second is NoId where only one
/// is told.
using RegionPair = std::array<Id, 2>;

/// A triangulated surface of space, as a structure of arrays. Slots are as in TriangleSlots.h.
struct SurfaceMesh
{
  std::vector<Point3> Points;
  std::vector<Id> PointIds; ///< of each vertex, the first point of the input at its place
  std::vector<Id> Corners;  ///< triangle t has the vertices Corners[3 t], [3 t + 1], [3 t + 2]
  std::vector<Id> Cells;    ///< of each triangle, the cell of the input that it came from
  std::vector<RegionPair> Regions; ///< of each triangle; empty: not known

  std::size_t NumberOfTriangles() const { return this->Cells.size(); }

  /// Triangle `to` becomes what triangle `from` is.
  void CopyTriangle(std::size_t from, std::size_t to)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      this->Corners[3 * to + k] = this->Corners[3 * from + k];
    }
    this->Cells[to] = this->Cells[from];
    if (!this->Regions.empty())
    {
      this->Regions[to] = this->Regions[from];
    }
  }

  /// Keeps the first triangles, or makes room for more.
  void Resize(std::size_t triangles)
  {
    this->Corners.resize(3 * triangles);
    this->Cells.resize(triangles);
    this->Regions.resize(this->Regions.empty() ? 0 : triangles);
  }

  const Point3& At(std::size_t slot) const
  {
    return this->Points[static_cast<std::size_t>(this->Corners[slot])];
  }

  std::array<Point3, 3> Triangle(std::size_t t) const
  {
    return { this->At(3 * t), this->At(3 * t + 1), this->At(3 * t + 2) };
  }

  /// Towards where the triangle is counterclockwise; as long as twice its area.
  Point3 Normal(std::size_t t) const
  {
    return Cross(this->At(3 * t + 1) - this->At(3 * t), this->At(3 * t + 2) - this->At(3 * t));
  }

  Point3 Middle(std::size_t t) const
  {
    return (1.0 / 3.0) * (this->At(3 * t) + this->At(3 * t + 1) + this->At(3 * t + 2));
  }

  /// Of triangle t.
  Box3 BoxOf(std::size_t t) const { return Box3::Around(this->Triangle(t)); }

  /// Of the triangles.
  Box3 Bounds() const
  {
    Box3 box;
    for (const Id corner : this->Corners)
    {
      box.Add(this->Points[static_cast<std::size_t>(corner)]);
    }
    return box;
  }
};

/// A triangle as an item of a BoxTree.
struct SurfaceItem
{
  Box3 Bounds;
  Id Triangle;

  const Box3& Box() const { return this->Bounds; }
  double Least() const { return 0.0; }
};

} // namespace biting

#endif
