// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingSurfaceShapes_h
#define BitingSurfaceShapes_h

#include "Space/Surface/SurfaceCheck.h"
#include "Support/Dice.h"

#include <cmath>            // for spheres
#include <initializer_list> // for corners
#include <utility>          // for swap
#include <vector>           // for points

namespace biting
{

/// Surfaces for tests: triangles with three points of their own each, as in STL files.
struct Soup
{
  SurfaceMesh Mesh;

  void Add(const Point3& a, const Point3& b, const Point3& c)
  {
    for (const Point3& point : { a, b, c })
    {
      const Id id = static_cast<Id>(this->Mesh.Points.size());
      this->Mesh.Points.push_back(point);
      this->Mesh.PointIds.push_back(id);
      this->Mesh.Corners.push_back(id);
    }
    this->Mesh.Cells.push_back(static_cast<Id>(this->Mesh.Cells.size()));
  }

  /// From corner to corner, its sides divided into n, facing outwards.
  void AddBox(const Point3& low, const Point3& high, int n = 1)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      for (const bool isHigh : { false, true })
      {
        this->AddSide(low, high, axis, isHigh, n);
      }
    }
  }

  void AddSide(const Point3& low, const Point3& high, std::size_t axis, bool isHigh, int n)
  {
    const std::size_t u = (axis + 1) % 3;
    const std::size_t v = (axis + 2) % 3;
    const auto at = [&](int i, int j)
    {
      Point3 point = isHigh ? high : low;
      point[u] = i == n ? high[u] : low[u] + (high[u] - low[u]) * i / n;
      point[v] = j == n ? high[v] : low[v] + (high[v] - low[v]) * j / n;
      return point;
    };
    for (int i = 0; i < n; ++i)
    {
      for (int j = 0; j < n; ++j)
      {
        const int turn = isHigh ? 1 : 0;
        this->Add(at(i, j), at(i + turn, j + 1 - turn), at(i + 1 - turn, j + turn));
        this->Add(at(i + 1, j + 1), at(i + 1 - turn, j + turn), at(i + turn, j + 1 - turn));
      }
    }
  }

  void Turn(std::size_t triangle)
  {
    std::swap(this->Mesh.Corners[3 * triangle + 1], this->Mesh.Corners[3 * triangle + 2]);
  }

  void Remove(std::size_t triangle)
  {
    const auto first = this->Mesh.Corners.begin() + static_cast<std::ptrdiff_t>(3 * triangle);
    this->Mesh.Corners.erase(first, first + 3);
    this->Mesh.Cells.erase(this->Mesh.Cells.begin() + static_cast<std::ptrdiff_t>(triangle));
  }
};

/// A sphere of rings about the z axis, about the origin.
inline Soup Sphere(double radius, int rings)
{
  constexpr double Pi = 3.14159265358979323846;
  Soup soup;
  const auto at = [radius, rings](int i, int j)
  {
    const double polar = Pi * i / rings;
    const double turn = Pi * (j % (2 * rings)) / rings;
    return i == 0  ? Point3{ 0.0, 0.0, radius }
      : i == rings ? Point3{ 0.0, 0.0, -radius }
                   : Point3{ radius * std::sin(polar) * std::cos(turn),
                       radius * std::sin(polar) * std::sin(turn), radius * std::cos(polar) };
  };
  for (int j = 0; j < 2 * rings; ++j)
  {
    soup.Add(at(0, 0), at(1, j), at(1, j + 1));
    soup.Add(at(rings, 0), at(rings - 1, j + 1), at(rings - 1, j));
    for (int i = 1; i + 1 < rings; ++i)
    {
      soup.Add(at(i, j), at(i + 1, j), at(i + 1, j + 1));
      soup.Add(at(i, j), at(i + 1, j + 1), at(i, j + 1));
    }
  }
  return soup;
}

/// A checked surface with what was told of it.
struct Verdict
{
  CheckedSurface Surface;
  ProblemList Problems;

  std::int64_t Count(ProblemCode code) const { return this->Problems.Count(code); }
  const SurfaceFigures& Figures() const { return this->Surface.Figures; }
};

/// With a spacing: holes and slits that are narrow for it are closed.
inline Verdict Judge(const Soup& soup, double noise = 1e-12, Monitor& monitor = NoMonitor(),
  const SpacingField& spacing = {})
{
  Verdict verdict;
  SurfaceCheckOptions options;
  options.Rounding = { noise, noise, noise };
  options.Noise = noise;
  options.Spacing = spacing;
  verdict.Surface = CheckSurface(soup.Mesh, options, verdict.Problems, monitor);
  return verdict;
}

inline Verdict JudgeClosed(const Soup& soup, double spacing)
{
  return Judge(soup, 1e-12, NoMonitor(), [spacing](const Point3&) { return spacing; });
}

} // namespace biting

#endif
