// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

// Surface meshes of about as many vertices as their surfaces have triangles. CPU times of one
// thread, and memory beside the surface, a vertex.
//   BenchmarkSurface [vertices [surface]]   a table; from 10000 up to 1000000 in steps of 10
//
// torus: curved, no features. needles: a prism of 96 sides, whose triangles are long strips. plate:
// a box of 1 x 1 x .04, thinner than f at first.

#include "CountedMemory.h"

#include "Base/Numbers.h"
#include "Space/Meshing/SurfaceMesher.h"

#include <algorithm> // for max
#include <cmath>     // for shapes
#include <cstdio>    // for tables
#include <cstdlib>   // for arguments
#include <ctime>     // for CPU time
#include <string>    // for names
#include <utility>   // for move
#include <vector>    // for points

namespace
{

using namespace biting;

constexpr double TwoPi = 6.283185307179586;

double Seconds()
{
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Numbers of points and cells follow.
SurfaceMesh Numbered(SurfaceMesh mesh)
{
  for (std::size_t k = 0; k < mesh.Points.size(); ++k)
  {
    mesh.PointIds.push_back(static_cast<Id>(k));
  }
  for (std::size_t t = 0; t < mesh.Corners.size() / 3; ++t)
  {
    mesh.Cells.push_back(static_cast<Id>(t));
  }
  return mesh;
}

void AddQuad(SurfaceMesh& mesh, Id a, Id b, Id c, Id d)
{
  mesh.Corners.insert(mesh.Corners.end(), { a, b, c, a, c, d });
}

SurfaceMesh Torus(double triangles)
{
  constexpr double Thin = 0.35;
  const Id across = static_cast<Id>(std::lround(std::sqrt(0.5 * Thin * triangles)));
  const Id along = static_cast<Id>(std::lround(0.5 * triangles / across));
  SurfaceMesh mesh;
  for (Id i = 0; i < along; ++i)
  {
    for (Id j = 0; j < across; ++j)
    {
      const double u = TwoPi * i / along;
      const double v = TwoPi * j / across;
      const double radius = 1.0 + Thin * std::cos(v);
      mesh.Points.push_back({ radius * std::cos(u), radius * std::sin(u), Thin * std::sin(v) });
      const Id next = (i + 1) % along * across;
      AddQuad(
        mesh, i * across + j, next + j, next + (j + 1) % across, i * across + (j + 1) % across);
    }
  }
  return Numbered(std::move(mesh));
}

SurfaceMesh Prism(Id sides, double radius, double height)
{
  SurfaceMesh mesh;
  for (Id i = 0; i < sides; ++i)
  {
    const double u = TwoPi * i / sides;
    for (const double z : { 0.0, height })
    {
      mesh.Points.push_back({ radius * std::cos(u), radius * std::sin(u), z });
    }
    const Id next = (i + 1) % sides;
    AddQuad(mesh, 2 * i, 2 * next, 2 * next + 1, 2 * i + 1);
    if (i > 1)
    {
      mesh.Corners.insert(mesh.Corners.end(), { 0, 2 * i, 2 * i - 2, 1, 2 * i - 1, 2 * i + 1 });
    }
  }
  return Numbered(std::move(mesh));
}

double AreaOf(const SurfaceMesh& mesh)
{
  double area = 0.0;
  for (std::size_t t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    area += 0.5 * Length(mesh.Normal(t));
  }
  return area;
}

void Measure(const char* name, const std::string& only, SurfaceMesh mesh, double vertices)
{
  if (!only.empty() && only != name)
  {
    return;
  }
  ProblemList problems;
  const CheckedSurface surface = CheckSurface(std::move(mesh), {}, problems, NoMonitor());
  SurfaceMesherOptions options;
  // A vertex has the area of two equilateral triangles of side f.
  const double size = std::sqrt(AreaOf(surface.Mesh) / vertices / std::sqrt(0.75));
  options.Spacing = [size](const Point3&) { return size; };
  const std::size_t bytes = BeginPeak();
  const double begin = Seconds();
  const BitingSurface made = MakeBitingSurface(surface, options, problems, NoMonitor());
  const double seconds = Seconds() - begin;
  const auto n = static_cast<double>(made.Points.size());
  std::printf("%-8s %9zu %9.0f %8.1f %8.0f\n", name, surface.Mesh.NumberOfTriangles(), n,
    1e6 * seconds / n, static_cast<double>(PeakBytes() - bytes) / n);
}

} // namespace

int main(int argc, char** argv)
{
  const double only = argc > 1 ? std::strtod(argv[1], nullptr) : 0.0;
  const std::string surface = argc > 2 ? argv[2] : "";
  std::printf("%-8s %9s %9s %8s %8s\n", "surface", "triangles", "vertices", "us", "bytes");
  for (double vertices = only > 0.0 ? only : 1e4; vertices <= std::max(only, 1e6);
       vertices *= only > 0.0 ? Infinity : 10.0)
  {
    Measure("torus", surface, Torus(vertices), vertices);
    Measure("needles", surface, Prism(96, 0.5, 2.0), vertices);
    Measure("plate", surface, Prism(4, std::sqrt(0.5), 0.04), vertices);
  }
  return 0;
}
