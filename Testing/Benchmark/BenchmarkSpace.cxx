// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

// Triangulations of points of space. CPU times of one thread.
//   BenchmarkSpace [points [kind]]   a table; 100000 points; kinds whose name has `kind` in it
//
// Where CGAL was found when this was built, its Delaunay_triangulation_3 (exact predicates, inexact
// constructions) is measured in the same run: a yardstick, which no library of ours contains.
// `same`: the share of our cells that CGAL has, too; the rest are ties.

#include "CountedMemory.h"

#include "Space/Delaunay/RegularTriangulation.h"
#include "Space/Delaunay/SpaceTriangulation.h"

#ifdef BITING_HAS_CGAL
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>
#endif

#include <algorithm> // for comparing cells
#include <array>     // for corners
#include <cmath>     // for cbrt
#include <cstdio>    // for tables
#include <cstdlib>   // for arguments
#include <ctime>     // for CPU time
#include <iterator>  // for cells of both
#include <random>    // for points
#include <string>    // for names
#include <utility>   // for points with numbers
#include <vector>    // for points

namespace
{

using namespace biting;

double Seconds()
{
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

class Dice
{
public:
  double Unit() { return std::ldexp(static_cast<double>(this->Generator() >> 11u), -53); }

  Point3 Point()
  {
    const double x = this->Unit();
    const double y = this->Unit();
    return { x, y, this->Unit() };
  }

private:
  std::mt19937_64 Generator{ 7 };
};

struct Kind
{
  const char* Name;
  Point3 (*Make)(Dice& dice, double k, double side);
};

Point3 LatticePoint(double k, double side)
{
  return { std::fmod(k, side), std::fmod(std::floor(k / side), side), std::floor(k / side / side) };
}

Point3 OnSphere(Dice& dice)
{
  Point3 p;
  do
  {
    p = 2.0 * dice.Point() - Point3{ 1.0, 1.0, 1.0 };
  } while (Length(p) > 1.0 || Length(p) < 0.1);
  return 1.0 / Length(p) * p;
}

const Kind Kinds[] = {
  { "uniform", [](Dice& dice, double, double) { return dice.Point(); } },
  { "graded",
    [](Dice& dice, double, double)
    {
      const Point3 p = dice.Point();
      return Point3{ p.X * p.X * p.X, p.Y * p.Y * p.Y, p.Z * p.Z * p.Z };
    } },
  { "sphere", [](Dice& dice, double, double) { return OnSphere(dice); } },
  { "lattice", [](Dice&, double k, double side) { return LatticePoint(k, side); } },
  { "lattice of 0.1", [](Dice&, double k, double side) { return 0.1 * LatticePoint(k, side); } },
  { "tiny", [](Dice& dice, double, double) { return 1e-9 * dice.Point(); } },
  { "far",
    [](Dice& dice, double, double) {
      return dice.Point() + Point3{ 1e8, -1e8, 1e8 };
    } },
};

using Cells = std::vector<std::array<Id, 4>>;

Cells Sorted(Cells cells)
{
  for (std::array<Id, 4>& cell : cells)
  {
    std::sort(cell.begin(), cell.end());
  }
  std::sort(cells.begin(), cells.end());
  return cells;
}

#ifdef BITING_HAS_CGAL
using CgalKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using CgalVertices = CGAL::Triangulation_vertex_base_with_info_3<Id, CgalKernel>;
using CgalDelaunay = CGAL::Delaunay_triangulation_3<CgalKernel,
  CGAL::Triangulation_data_structure_3<CgalVertices,
    CGAL::Delaunay_triangulation_cell_base_3<CgalKernel>>>;

Cells CgalCells(const std::vector<Point3>& points)
{
  std::vector<std::pair<CgalKernel::Point_3, Id>> others;
  others.reserve(points.size());
  for (std::size_t k = 0; k < points.size(); ++k)
  {
    others.emplace_back(
      CgalKernel::Point_3(points[k].X, points[k].Y, points[k].Z), static_cast<Id>(k));
  }
  const CgalDelaunay triangulation(others.begin(), others.end());
  Cells cells;
  cells.reserve(triangulation.number_of_finite_cells());
  for (auto cell = triangulation.finite_cells_begin(); cell != triangulation.finite_cells_end();
       ++cell)
  {
    cells.push_back({ cell->vertex(0)->info(), cell->vertex(1)->info(), cell->vertex(2)->info(),
      cell->vertex(3)->info() });
  }
  return Sorted(std::move(cells));
}

double SecondsOfCgal(const std::vector<Point3>& points)
{
  std::vector<CgalKernel::Point_3> others;
  others.reserve(points.size());
  for (const Point3& p : points)
  {
    others.emplace_back(p.X, p.Y, p.Z);
  }
  const double begin = Seconds();
  const CGAL::Delaunay_triangulation_3<CgalKernel> triangulation(others.begin(), others.end());
  return Seconds() - begin;
}
#else
Cells CgalCells(const std::vector<Point3>&)
{
  return {};
}

double SecondsOfCgal(const std::vector<Point3>&)
{
  return 0.0;
}
#endif

double SharedCells(const SpaceTriangulation& ours, const std::vector<Point3>& points)
{
  Cells cells;
  for (Id cell = 0; cell < ours.Mesh.NumberOfSlots(); ++cell)
  {
    if (ours.Mesh.IsTetrahedron(cell))
    {
      std::array<Id, 4>& corners = cells.emplace_back();
      std::transform(ours.Mesh.Corners.begin() + 4 * cell, ours.Mesh.Corners.begin() + 4 * cell + 4,
        corners.begin(), [&](Id vertex) { return ours.Order[static_cast<std::size_t>(vertex)]; });
    }
  }
  cells = Sorted(std::move(cells));
  const Cells others = CgalCells(points);
  Cells both;
  std::set_intersection(
    cells.begin(), cells.end(), others.begin(), others.end(), std::back_inserter(both));
  return static_cast<double>(both.size()) /
    static_cast<double>(std::max(cells.size(), others.size()));
}

/// µs of removing and inserting again, a vertex.
double CostOfChange(const std::vector<Point3>& points)
{
  RegularTriangulation triangulation;
  const std::size_t size = std::min<std::size_t>(points.size(), 20000);
  for (std::size_t k = 0; k < size; ++k)
  {
    triangulation.Insert(points[k]);
  }
  const std::size_t changes = size / 10;
  const double begin = Seconds();
  for (std::size_t k = 0; k < changes; ++k)
  {
    const Id hint = triangulation.Mesh().VertexCells[k] == NoId ? NoId : static_cast<Id>(k + 1);
    triangulation.Remove(static_cast<Id>(k));
    triangulation.Insert(points[k], 0.0, hint);
  }
  return 1e6 * (Seconds() - begin) / static_cast<double>(changes);
}

void Measure(const Kind& kind, std::size_t count)
{
  Dice dice;
  const double side = std::ceil(std::cbrt(static_cast<double>(count)));
  std::vector<Point3> points;
  points.reserve(count);
  for (std::size_t k = 0; k < count; ++k)
  {
    points.push_back(kind.Make(dice, static_cast<double>(k), side));
  }
  const std::size_t bytes = BeginPeak();
  const double begin = Seconds();
  const SpaceTriangulation result = TriangulateSpace(points, {}, NoMonitor());
  const double seconds = Seconds() - begin;
  const auto n = static_cast<double>(count);
  const double memory = static_cast<double>(PeakBytes() - bytes) / n;
  const double cgal = SecondsOfCgal(points);
  std::printf("%-16s %8zu %7.2f %7.2f %7.2f %7.1f %6.2f %8.6f %8.1f\n", kind.Name, count,
    1e6 * seconds / n, 1e6 * cgal / n, cgal > 0.0 ? seconds / cgal : 0.0, memory,
    static_cast<double>(result.Mesh.NumberOfCells()) / n, SharedCells(result, points),
    CostOfChange(points));
}

} // namespace

int main(int argc, char** argv)
{
  const std::size_t count = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 100000;
  const std::string wanted = argc > 2 ? argv[2] : "";
  std::printf("%-16s %8s %7s %7s %7s %7s %6s %8s %8s\n", "kind", "points", "us", "CGAL", "ratio",
    "bytes", "cells", "same", "change");
  for (const Kind& kind : Kinds)
  {
    if (std::string(kind.Name).find(wanted) != std::string::npos)
    {
      Measure(kind, count);
    }
  }
  return 0;
}
