// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingSpacePoints_h
#define BitingSpacePoints_h

#include "Space/Delaunay/RegularTriangulation.h"

#include <algorithm> // for sort
#include <array>     // for cells
#include <cmath>     // for ldexp, sqrt
#include <random>    // for mt19937_64, whose output is the same everywhere
#include <utility>   // for swap
#include <vector>    // for points

namespace space_test
{

using biting::Id;
using biting::NoId;
using biting::Point3;
using biting::TetMesh;

class SpaceDice
{
public:
  explicit SpaceDice(unsigned long long seed)
    : Generator(seed)
  {
  }

  int Below(int bound)
  {
    return static_cast<int>(this->Generator() % static_cast<unsigned long long>(bound));
  }

  double Unit() { return std::ldexp(static_cast<double>(this->Generator() >> 11), -53); }

  template <class Item>
  void Shuffle(std::vector<Item>& items)
  {
    for (std::size_t k = items.size(); k > 1; --k)
    {
      std::swap(items[k - 1], items[static_cast<std::size_t>(this->Below(static_cast<int>(k)))]);
    }
  }

private:
  std::mt19937_64 Generator;
};

/// What points look like.
enum class PointKind
{
  Uniform,
  Lattice,
  Fractions, ///< a lattice whose spacing is no binary fraction
  Sphere,
  LatticeSphere, ///< exactly on a sphere
  Plane,
  Line,
  Layers, ///< two planes
  Duplicates,
  Graded,
  Far,
  Tiny,
  Cross ///< two lines: all pairs of neighbours make tetrahedra
};
constexpr int NumberOfPointKinds = 13;

inline Point3 OnSphere(SpaceDice& dice)
{
  Point3 p;
  double length = 0.0;
  while (length < 0.1 || length > 1.0)
  {
    p = { 2.0 * dice.Unit() - 1.0, 2.0 * dice.Unit() - 1.0, 2.0 * dice.Unit() - 1.0 };
    length = Length(p);
  }
  return 1.0 / length * p;
}

inline Point3 RandomPoint(PointKind kind, SpaceDice& dice)
{
  const Point3 p{ dice.Unit(), dice.Unit(), dice.Unit() };
  const auto whole = [&dice](int size) { return static_cast<double>(dice.Below(size)); };
  switch (kind)
  {
    case PointKind::Lattice:
      return { whole(4), whole(4), whole(4) };
    case PointKind::Fractions:
      return { 0.1 * whole(4), 0.1 * whole(4), 0.3 * whole(4) };
    case PointKind::Sphere:
      return OnSphere(dice);
    case PointKind::LatticeSphere: // of radius 3 and 9
    {
      const int turn = dice.Below(3);
      const bool isLong = dice.Below(2) == 0;
      double values[3] = { isLong ? 1.0 : 3.0, isLong ? 2.0 : 0.0, isLong ? 2.0 : 0.0 };
      for (double& value : values)
      {
        value *= dice.Below(2) == 0 ? -1.0 : 1.0;
      }
      return { values[turn], values[(turn + 1) % 3], values[(turn + 2) % 3] };
    }
    case PointKind::Plane:
      return { p.X, p.Y, 0.5 * p.X };
    case PointKind::Line:
      return { p.X, 2.0 * p.X, -p.X };
    case PointKind::Layers:
      return { whole(5), whole(5), whole(2) };
    case PointKind::Duplicates:
      return { whole(2), p.Y < 0.5 ? 0.25 : whole(2), whole(2) };
    case PointKind::Graded:
      return { p.X * p.X * p.X * p.X, p.Y * p.Y * p.Y, p.Z * p.Z * 1e-6 };
    case PointKind::Far:
      return { 1e8 + p.X, p.Y - 1e8, p.Z };
    case PointKind::Tiny:
      return 1e-9 * p;
    case PointKind::Cross:
      return dice.Below(2) == 0 ? Point3{ whole(40), 0.0, 0.0 } : Point3{ 0.0, whole(40), 7.0 };
    default:
      return p;
  }
}

/// A cell by the places of its corners, in order; of ghosts the last is not finite.
using PlacedCell = std::array<std::array<double, 3>, 4>;

/// All cells, in order: equal for equal triangulations, however vertices are numbered.
inline std::vector<PlacedCell> PlacedCells(const TetMesh& mesh)
{
  std::vector<PlacedCell> cells;
  for (Id cell = 0; cell < mesh.NumberOfSlots(); ++cell)
  {
    if (mesh.IsFree(cell))
    {
      continue;
    }
    PlacedCell placed;
    for (std::size_t k = 0; k < 4; ++k)
    {
      const Id corner = mesh.Corners[TetMesh::Index(4 * cell) + k];
      const Point3 p = corner == NoId ? Point3{ HUGE_VAL, 0.0, 0.0 } : mesh.PointAt(corner);
      placed[k] = { p.X, p.Y, p.Z };
    }
    std::sort(placed.begin(), placed.end());
    cells.push_back(placed);
  }
  std::sort(cells.begin(), cells.end());
  return cells;
}

} // namespace space_test

#endif
