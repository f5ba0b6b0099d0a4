// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

// What remeshing keeps, what the mesh is worth, and what it costs: CPU time of one thread for each
// vertex of the result.
//   BenchmarkRemesh [vertices] [domain] [preference]
//     about so many (10000), on "square" or "holes", with 0 (Keeping), 1 (Balanced, default) or
//     2 (Shape)
//   BenchmarkRemesh [vertices] coast [preference]
//     the coast of Data, made finer: f halved in a disc, and doubled
//   BenchmarkRemesh [vertices] layer [preference]
//     each step of the layer that moves
//   BenchmarkRemesh [vertices] curve
//     what is kept against what it is worth: doubled, and the last step of the layer, with each
//     preference, and meshed anew

#include "../Kernel/Support/MeshShapes.h"
#include "../Kernel/Support/PolylineShapes.h"
#include "../Kernel/Support/RemeshLaws.h"
#include "BitingMesh.h"
#include "BitingRemesh.h"
#include "Domain/Polylines.h"
#include "MeshCases.h"

#include <algorithm>  // for sort
#include <cmath>      // for fields
#include <cstdio>     // for tables
#include <cstdlib>    // for arguments
#include <ctime>      // for CPU time
#include <functional> // for fields
#include <limits>     // for epsilon
#include <string>     // for names

namespace
{

using namespace biting;

constexpr double Gradation = 0.3;
constexpr int Steps = 20;
constexpr double StepLength = 0.02;
constexpr double CoastVertices = 14100.0; ///< of the coast of Data as it is

using Field = std::function<double(const Point2&)>;

double Seconds()
{
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// That makes about so many vertices of the unit square.
double SpacingOf(double vertices)
{
  return std::sqrt(1.1547 / vertices);
}

/// The same of the layer: its least.
double LayerSpacingOf(double vertices)
{
  return 0.19 / std::sqrt(vertices);
}

/// The unit square, with seven by seven round holes or none.
Polylines DomainNamed(const std::string& name)
{
  PolylineBuilder builder;
  builder.Box(0.0, 0.0, 1.0, 1.0);
  for (int hole = 0; name == "holes" && hole < 49; ++hole)
  {
    const Point2 middle{ (hole % 7 + 0.5) / 7.0, (hole / 7 + 0.5) / 7.0 };
    builder.Loop(RegularPolygon(middle, 0.02, 24));
  }
  return builder.Lines();
}

BitingMesh MeshOf(const Polylines& domain, double spacing)
{
  BitingMeshOptions options;
  options.Spacing.Uniform = spacing;
  ProblemList problems;
  return MakeBitingMesh(domain, options, problems, NoMonitor());
}

/// As the filter takes it, of doubles.
double RoundingOf(const std::vector<Point2>& points)
{
  double largest = 0.0;
  for (const Point2& point : points)
  {
    largest = std::max({ largest, std::abs(point.X), std::abs(point.Y) });
  }
  return NoiseInUlp * std::numeric_limits<double>::epsilon() * largest;
}

struct Outcome
{
  RemeshInput Input;
  RemeshResult Result;
  std::vector<double> Before; ///< f at the vertices of the input that it was made for, or none
  double Time = 0.0;

  const BitingMesh& Mesh() const { return this->Result.Mesh; }
};

std::vector<double> ValuesAt(const std::vector<Point2>& points, const Field& f)
{
  std::vector<double> values;
  for (const Point2& point : points)
  {
    values.push_back(f(point));
  }
  return values;
}

Outcome RemeshTo(
  const BitingMesh& mesh, const std::vector<double>& values, RemeshPreference preference)
{
  Outcome outcome;
  outcome.Input = RemeshInputOf(mesh, RoundingOf(mesh.Points));
  outcome.Before = mesh.Spacing;
  RemeshOptions options;
  options.Preference = preference;
  options.Spacing.Gradation = Gradation;
  options.Values = values;
  ProblemList problems;
  const double begin = Seconds();
  outcome.Result = Remesh(outcome.Input, options, problems, NoMonitor());
  outcome.Time = Seconds() - begin;
  if (outcome.Result.IsUnchanged)
  {
    outcome.Result.Mesh = mesh;
    for (std::size_t vertex = 0; vertex < mesh.Points.size(); ++vertex)
    {
      outcome.Result.Mesh.OriginalPoints[vertex] = static_cast<Id>(vertex);
    }
  }
  return outcome;
}

Outcome RemeshTo(const BitingMesh& mesh, const Field& f, RemeshPreference preference)
{
  return RemeshTo(mesh, ValuesAt(mesh.Points, f), preference);
}

/// What the mesher makes of the same spacing.
Outcome MeshedAnew(const Polylines& domain, const Outcome& outcome)
{
  auto source = std::make_shared<TriangulatedSource>();
  source->Points = outcome.Mesh().Points;
  source->Values = outcome.Mesh().Spacing;
  source->Triangles = outcome.Mesh().Corners;
  BitingMeshOptions options;
  options.Spacing.Sources.emplace_back(source);
  Outcome anew = outcome;
  ProblemList problems;
  const double begin = Seconds();
  anew.Result.Mesh = MakeBitingMesh(domain, options, problems, NoMonitor());
  anew.Time = Seconds() - begin;
  anew.Result.Mesh.OriginalPoints.assign(anew.Mesh().Points.size(), NoId);
  return anew;
}

/// Of the old vertices, in per cent; where `isCounted` says so.
template <typename Predicate>
double ShareOfKept(const Outcome& outcome, const Predicate& isCounted)
{
  std::vector<std::uint8_t> isKept(outcome.Input.Points.size(), 0);
  for (const Id original : outcome.Mesh().OriginalPoints)
  {
    isKept[original == NoId ? 0 : original] |= original != NoId;
  }
  double kept = 0.0;
  double all = 0.0;
  for (std::size_t vertex = 0; vertex < isKept.size(); ++vertex)
  {
    if (isCounted(vertex))
    {
      kept += isKept[vertex];
      all += 1.0;
    }
  }
  return all > 0.0 ? 100.0 * kept / all : 100.0;
}

/// Where the spacing changed by less than a tenth.
double ShareOfKeptWhereAlike(const Outcome& outcome)
{
  const std::vector<double>& now = outcome.Result.OldSpacings;
  return ShareOfKept(outcome,
    [&outcome, &now](std::size_t vertex)
    { return std::abs(now[vertex] - outcome.Before[vertex]) < 0.1 * outcome.Before[vertex]; });
}

void PrintHead()
{
  std::printf("case            vertices   kept   alike    min   1 %%  mean   conf   band    us\n");
}

void Print(const std::string& name, const Outcome& outcome)
{
  const BitingMesh& mesh = outcome.Mesh();
  std::vector<double> angles;
  for (std::size_t slot = 0; slot < mesh.Corners.size(); slot += 3)
  {
    angles.push_back(MinimumAngle(mesh.Points[mesh.Corners[slot]],
      mesh.Points[mesh.Corners[slot + 1]], mesh.Points[mesh.Corners[slot + 2]]));
  }
  std::sort(angles.begin(), angles.end());
  double sum = 0.0;
  for (const double angle : angles)
  {
    sum += angle;
  }
  std::printf("%-14s %9zu %6.2f %7.2f %6.1f %5.1f %5.1f %6.3f %6.2f %5.2f\n", name.c_str(),
    mesh.Points.size(), ShareOfKept(outcome, [](std::size_t) { return true; }),
    ShareOfKeptWhereAlike(outcome), angles.front(), angles[angles.size() / 100],
    sum / static_cast<double>(angles.size()), mesh.Quality.MeanConformity,
    100.0 * mesh.Quality.ShareOfEdgesInBand,
    1e6 * outcome.Time / static_cast<double>(mesh.Points.size()));
}

void RunUniform(const Polylines& domain, double spacing, RemeshPreference preference)
{
  const BitingMesh mesh = MeshOf(domain, spacing);
  const auto uniform = [](double value) { return [value](const Point2&) { return value; }; };
  const Field disc = [spacing](const Point2& x)
  {
    const double distance = std::max(Distance(x, { 0.5, 0.5 }) - 0.2, 0.0);
    return std::min(0.5 * spacing + Gradation * distance, spacing);
  };
  Print("a: same", RemeshTo(mesh, uniform(spacing), preference));
  const Outcome b = RemeshTo(mesh, disc, preference);
  Print("b: disc halved", b);
  std::printf("   kept inside and outside of the disc, and its rim: %.2f\n",
    ShareOfKept(b,
      [&b, spacing](std::size_t vertex)
      {
        const double distance = Distance(b.Input.Points[vertex], { 0.5, 0.5 }) - 0.2;
        return distance < 0.0 || distance > 0.5 * spacing / Gradation;
      }));
  Print("   meshed anew", MeshedAnew(domain, b));
  Print("   all halved", RemeshTo(mesh, uniform(0.5 * spacing), preference));
  const Outcome doubled = RemeshTo(mesh, uniform(2.0 * spacing), preference);
  Print("c: doubled", doubled);
  Print("d: and back", RemeshTo(doubled.Mesh(), uniform(spacing), preference));
}

/// `spacing` is that of the mesh: f is half of it in a disc, and twice as large.
void RunCoast(double vertices, RemeshPreference preference)
{
  const MeshCase coast = OfFile("coast.vtk", Gradation, std::sqrt(CoastVertices / vertices));
  ProblemList problems;
  const BitingMesh mesh = MakeBitingMesh(coast.Drawing, coast.Options, problems, NoMonitor());
  Box2 box;
  for (const Point2& point : mesh.Points)
  {
    box.Add(point);
  }
  const double radius = 0.2 * (box.High.Y - box.Low.Y);
  std::vector<double> halved = mesh.Spacing;
  std::vector<double> doubled = mesh.Spacing;
  for (std::size_t vertex = 0; vertex < halved.size(); ++vertex)
  {
    const double distance = Distance(mesh.Points[vertex], box.Center()) - radius;
    halved[vertex] =
      std::min(halved[vertex], 0.5 * halved[vertex] + Gradation * std::max(distance, 0.0));
    doubled[vertex] *= 2.0;
  }
  Print("a: same", RemeshTo(mesh, mesh.Spacing, preference));
  for (const auto& [name, values] :
    { std::make_pair("b: disc halved", halved), std::make_pair("c: doubled", doubled) })
  {
    const Outcome outcome = RemeshTo(mesh, values, preference);
    Print(name, outcome);
    std::printf("   kept where f is as it was, half or twice of it: %.2f\n",
      ShareOfKept(outcome,
        [&outcome](std::size_t vertex)
        {
          const double ratio = outcome.Result.OldSpacings[vertex] / outcome.Before[vertex];
          return ratio < 0.501 || std::abs(ratio - 1.0) < 0.001 || ratio > 1.999;
        }));
    Print("   meshed anew", MeshedAnew(coast.Drawing, outcome));
  }
}

/// What interpolation of a steep tanh asks for.
Field LayerAt(double place, double spacing)
{
  return [place, spacing](const Point2& x)
  {
    const double u = std::tanh(90.0 * (x.X - place - 0.05 * std::sin(6.0 * x.Y)));
    const double curvature = 2.0 * std::abs(u) * (1.0 - u * u);
    return std::min(spacing / std::sqrt(std::max(curvature, 1e-9)), 20.0 * spacing);
  };
}

void RunLayer(const Polylines& domain, double spacing, RemeshPreference preference, bool isEach)
{
  BitingMesh mesh = MeshOf(domain, 10.0 * spacing);
  for (int round = 0; round < 5; ++round)
  {
    mesh = RemeshTo(mesh, LayerAt(0.2, spacing), RemeshPreference::Shape).Mesh();
  }
  Outcome outcome;
  double time = 0.0;
  for (int step = 1; step <= Steps; ++step)
  {
    outcome = RemeshTo(mesh, LayerAt(0.2 + StepLength * step, spacing), preference);
    time += outcome.Time;
    mesh = outcome.Mesh();
    if (isEach || step == Steps)
    {
      Print("e: step " + std::to_string(step), outcome);
    }
  }
  std::printf("all steps: %.3f s\n", time);
  Print("   meshed anew", MeshedAnew(domain, outcome));
}

void RunCurve(const Polylines& domain, double vertices)
{
  const double spacing = SpacingOf(vertices);
  const BitingMesh mesh = MeshOf(domain, spacing);
  for (const RemeshPreference preference :
    { RemeshPreference::Keeping, RemeshPreference::Balanced, RemeshPreference::Shape })
  {
    std::printf("preference %d\n", static_cast<int>(preference));
    const Field twice = [spacing](const Point2&) { return 2.0 * spacing; };
    Print("c: doubled", RemeshTo(mesh, twice, preference));
    RunLayer(domain, LayerSpacingOf(vertices), preference, false);
  }
}

} // namespace

int main(int count, char** texts)
{
  const double vertices = count > 1 ? std::atof(texts[1]) : 10000.0;
  const std::string domain = count > 2 ? texts[2] : "square";
  const auto preference =
    static_cast<biting::RemeshPreference>(count > 3 ? std::atoi(texts[3]) : 1);
  PrintHead();
  if (domain == "coast")
  {
    RunCoast(vertices, preference);
    return 0;
  }
  if (domain == "curve")
  {
    RunCurve(DomainNamed(domain), vertices);
    return 0;
  }
  if (domain != "layer")
  {
    RunUniform(DomainNamed(domain), SpacingOf(vertices), preference);
  }
  RunLayer(DomainNamed(domain), LayerSpacingOf(vertices), preference, domain == "layer");
  return 0;
}
