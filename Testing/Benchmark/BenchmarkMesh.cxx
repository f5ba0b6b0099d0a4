// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

// The whole kernel, from a drawing to a mesh. CPU times of one thread, medians.
//   BenchmarkMesh cost [vertices [name]]   a table; square meshes up to that size (1000000), cases
//                                          whose name has `name` in it
//   BenchmarkMesh quality                  28 pairs of drawing and spacing, and their means
//   BenchmarkMesh settings                 the means with the settings that Method.html compares
//   BenchmarkMesh blocks [vertices]        the pairs of at least so many vertices (10000) as one
//                                          block and as at least eight; means over all, the smaller
//                                          ones as one block in both
//
// The unit of the ratio is this kernel's own unconstrained Delaunay triangulation of the mesh's
// vertices, in the same run: what any mesher of these vertices has to pay.

#include "CountedMemory.h"
#include "MeshCases.h"

#include "Base/Pulse.h"
#include "Delaunay/ConstrainedMesh.h"
#include "Delaunay/SpatialOrder.h"

#include <algorithm> // for sort
#include <cmath>     // for logarithms
#include <cstdio>    // for tables
#include <cstdlib>   // for arguments
#include <ctime>     // for CPU time
#include <map>       // for stages, growth
#include <string>    // for names

namespace
{

using namespace biting;

double Seconds()
{
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Adds up the time of each stage.
class StageClock : public Monitor
{
public:
  bool Advance(double) override { return true; }

  void BeginStage(const char* text) override
  {
    this->Stop();
    this->Stage = text;
  }

  void Stop()
  {
    const double now = Seconds();
    this->Spent[this->Stage] += now - this->Begin;
    this->Begin = now;
  }

  double Of(const char* stage) const
  {
    const auto found = this->Spent.find(stage);
    return found == this->Spent.end() ? 0.0 : found->second;
  }

private:
  std::string Stage;
  double Begin = Seconds();
  std::map<std::string, double> Spent;
};

constexpr const char* Stages[] = { "Reading the domain", "Preparing the spacing", "Biting",
  "Triangulating", "Relaxing", "Measuring quality" };
constexpr int NumberOfStages = 6;

struct Cost
{
  double Vertices = 0.0;
  double Seconds = 0.0;
  double Unit = 0.0; ///< seconds of the triangulation alone
  double Bytes = 0.0;
  double Stage[NumberOfStages] = {};
};

double SecondsOfInsertion(const std::vector<Point2>& points)
{
  SilentMonitor monitor;
  Pulse pulse(monitor);
  const double begin = Seconds();
  const InsertionResult result = InsertPoints(points, SpatialOrder(points, pulse), 1.0, pulse);
  return result.Mesh.NumberOfTriangles > 0 ? Seconds() - begin : 0.0;
}

Cost RunOnce(const MeshCase& one)
{
  Cost cost;
  ProblemList problems;
  StageClock clock;
  const std::size_t bytes = BeginPeak();
  const double begin = Seconds();
  const BitingMesh mesh = MakeBitingMesh(one.Drawing, one.Options, problems, clock);
  cost.Seconds = Seconds() - begin;
  clock.Stop();
  cost.Vertices = static_cast<double>(mesh.Points.size());
  cost.Bytes = static_cast<double>(PeakBytes() - bytes);
  for (int stage = 0; stage < NumberOfStages; ++stage)
  {
    cost.Stage[stage] = clock.Of(Stages[stage]);
  }
  cost.Unit = SecondsOfInsertion(mesh.Points);
  return cost;
}

double Median(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

template <typename Member>
double MedianOf(const std::vector<Cost>& costs, Member member)
{
  std::vector<double> values;
  for (const Cost& cost : costs)
  {
    values.push_back(member(cost));
  }
  return Median(values);
}

/// As many runs as fit into some seconds.
Cost Measure(const MeshCase& one)
{
  constexpr double Enough = 4.0;
  constexpr std::size_t MostRuns = 15;
  std::vector<Cost> runs;
  double spent = 0.0;
  while (spent < Enough && runs.size() < MostRuns)
  {
    runs.push_back(RunOnce(one));
    spent += runs.back().Seconds;
  }
  Cost median = runs.front();
  median.Seconds = MedianOf(runs, [](const Cost& cost) { return cost.Seconds; });
  median.Unit = MedianOf(runs, [](const Cost& cost) { return cost.Unit; });
  for (int stage = 0; stage < NumberOfStages; ++stage)
  {
    median.Stage[stage] = MedianOf(runs, [stage](const Cost& cost) { return cost.Stage[stage]; });
  }
  return median;
}

void PrintRow(const std::string& name, const Cost& cost)
{
  const double perVertex = 1e6 / cost.Vertices;
  std::printf("| %-32s | %8.0f | %7.3f | %5.2f | %4.0f |", name.c_str(), cost.Vertices,
    perVertex * cost.Seconds, cost.Seconds / cost.Unit, cost.Bytes / cost.Vertices);
  for (const double seconds : cost.Stage)
  {
    std::printf(" %6.3f |", perVertex * seconds);
  }
  std::printf("\n");
  std::fflush(stdout);
}

/// The exponents from the first to the last of the cases that differ in size only.
void PrintGrowth(const std::map<std::string, std::vector<Cost>>& families)
{
  for (const auto& [family, costs] : families)
  {
    if (costs.size() > 1)
    {
      const double growth = std::log(costs.back().Seconds / costs.front().Seconds) /
        std::log(costs.back().Vertices / costs.front().Vertices);
      std::printf("%s: time grows with the power %.3f of the vertices, from %.0f to %.0f\n",
        family.c_str(), growth, costs.front().Vertices, costs.back().Vertices);
    }
  }
}

bool IsThere(const MeshCase& one)
{
  if (one.Drawing.Points.empty())
  {
    std::printf("%s: no such file\n", one.Name.c_str());
  }
  return !one.Drawing.Points.empty();
}

void PrintCosts(double mostVertices, const std::string& name)
{
  std::printf(
    "CPU microseconds a vertex; ratio to the triangulation of the vertices alone; bytes a "
    "vertex at the peak;\nof the microseconds: domain, spacing, biting, triangulation, "
    "relaxation, quality\n");
  std::map<std::string, std::vector<Cost>> families;
  for (const MeshCase& one : CostCases(mostVertices))
  {
    if (one.Name.find(name) == std::string::npos || !IsThere(one))
    {
      continue;
    }
    const Cost cost = Measure(one);
    PrintRow(one.Name, cost);
    if (one.Options.Spacing.Gradation == 0.0 || one.Drawing.Points.size() == 4)
    {
      const bool isRaw = !one.Options.Relaxation;
      families[one.Name.substr(0, 2) + (isRaw ? ", raw" : "")].push_back(cost);
    }
  }
  PrintGrowth(families);
}

struct Scores
{
  double Smallest, OnePercent, Mean, Conformity, InBand;
};

Scores ScoresOf(const BitingMesh& mesh)
{
  std::vector<double> angles = mesh.Quality.MinimumAngle;
  std::sort(angles.begin(), angles.end());
  double sum = 0.0;
  for (const double angle : angles)
  {
    sum += angle;
  }
  return { angles.front(), angles[angles.size() / 100], sum / static_cast<double>(angles.size()),
    mesh.Quality.MeanConformity, 100.0 * mesh.Quality.ShareOfEdgesInBand };
}

void Add(const Scores& scores, Scores& sum)
{
  sum = { sum.Smallest + scores.Smallest, sum.OnePercent + scores.OnePercent,
    sum.Mean + scores.Mean, sum.Conformity + scores.Conformity, sum.InBand + scores.InBand };
}

Scores Mean(const Scores& sum, double count)
{
  return { sum.Smallest / count, sum.OnePercent / count, sum.Mean / count, sum.Conformity / count,
    sum.InBand / count };
}

void PrintScores(const std::string& name, std::size_t vertices, const Scores& scores)
{
  std::printf("| %-32s | %7zu | %5.2f | %5.2f | %5.2f | %.4f | %6.2f |\n", name.c_str(), vertices,
    scores.Smallest, scores.OnePercent, scores.Mean, scores.Conformity, scores.InBand);
}

constexpr const char* Columns =
  "Vertices; degrees: the smallest angle, the smallest of 99 % of the triangles, the mean of their "
  "smallest;\nmean conformity; percentage of edges in band";

/// One way to make a mesh.
struct Setting
{
  const char* Name;
  BiteShape Shape;
  biting::Placement Placement;
  FrontOrder Order;
  bool IsRelaxed;
};

constexpr Setting Defaults = { "squares at bisectors, relaxed", BiteShape::Square,
  Placement::Bisectors, FrontOrder::Layers, true };
constexpr Setting Settings[] = {
  { "squares at corners, raw", BiteShape::Square, Placement::Corners, FrontOrder::Layers, false },
  { "squares at corners, relaxed", BiteShape::Square, Placement::Corners, FrontOrder::Layers,
    true },
  { "squares at bisectors, raw", BiteShape::Square, Placement::Bisectors, FrontOrder::Layers,
    false },
  Defaults,
  { "the same, best first", BiteShape::Square, Placement::Bisectors, FrontOrder::BestFirst, true },
  { "circles at bisectors, relaxed", BiteShape::Circle, Placement::Bisectors, FrontOrder::Layers,
    true },
};

BitingMesh MeshOf(const MeshCase& one, const Setting& setting)
{
  BitingMeshOptions options = one.Options;
  options.BiteShape = setting.Shape;
  options.Placement = setting.Placement;
  options.Order = setting.Order;
  options.Relaxation = setting.IsRelaxed;
  ProblemList problems;
  return MakeBitingMesh(one.Drawing, options, problems, NoMonitor());
}

void PrintQualities(const Setting& setting, bool printsAll)
{
  Scores sum{};
  std::size_t vertices = 0;
  double count = 0.0;
  for (const MeshCase& one : QualityCases())
  {
    const BitingMesh mesh = MeshOf(one, setting);
    if (mesh.Points.empty())
    {
      std::printf("| %-32s | no mesh\n", one.Name.c_str());
      continue;
    }
    const Scores scores = ScoresOf(mesh);
    if (printsAll)
    {
      PrintScores(one.Name, mesh.Points.size(), scores);
    }
    Add(scores, sum);
    vertices += mesh.Points.size();
    count += 1.0;
  }
  PrintScores(printsAll ? "mean of " + std::to_string(static_cast<int>(count)) : setting.Name,
    vertices, Mean(sum, count));
}

/// By ever smaller blocks, down to a thirtieth of the mesh each.
BitingMesh MeshOfBlocks(const MeshCase& one, std::size_t vertices)
{
  BitingMesh mesh;
  for (double share = 9.0; share < 30.0 && mesh.NumberOfBlocks < 8; share *= 1.3)
  {
    BitingMeshOptions options = one.Options;
    options.VerticesPerBlock = static_cast<std::int64_t>(static_cast<double>(vertices) / share);
    ProblemList problems;
    mesh = MakeBitingMesh(one.Drawing, options, problems, NoMonitor());
  }
  return mesh;
}

void PrintBlocks(std::size_t least)
{
  Scores ofOne{};
  Scores ofSeveral{};
  double count = 0.0;
  std::size_t vertices[2] = { 0, 0 };
  double worst = 0.0;
  for (const MeshCase& one : QualityCases())
  {
    MeshCase uncut = one;
    uncut.Options.VerticesPerBlock = 0;
    const BitingMesh whole = MeshOf(uncut, Defaults);
    if (whole.Points.empty())
    {
      std::printf("| %-32s | no mesh\n", one.Name.c_str());
      continue;
    }
    const bool isCut = whole.Points.size() >= least;
    const BitingMesh blocks = isCut ? MeshOfBlocks(one, whole.Points.size()) : whole;
    const Scores scores[2] = { ScoresOf(whole), ScoresOf(blocks) };
    if (isCut)
    {
      PrintScores(one.Name, whole.Points.size(), scores[0]);
      PrintScores(
        std::to_string(blocks.NumberOfBlocks) + " blocks", blocks.Points.size(), scores[1]);
    }
    Add(scores[0], ofOne);
    Add(scores[1], ofSeveral);
    vertices[0] += whole.Points.size();
    vertices[1] += blocks.Points.size();
    worst = std::max(worst, scores[0].Smallest - scores[1].Smallest);
    count += 1.0;
  }
  const std::string number = std::to_string(static_cast<int>(count));
  PrintScores("mean of " + number, vertices[0], Mean(ofOne, count));
  PrintScores("mean of " + number + " in blocks", vertices[1], Mean(ofSeveral, count));
  std::printf("The smallest angle falls by %.2f degrees at most\n", worst);
}

} // namespace

int main(int argc, char** argv)
{
  const std::string what = argc > 1 ? argv[1] : "cost";
  if (what == "cost")
  {
    PrintCosts(argc > 2 ? std::atof(argv[2]) : 1e6, argc > 3 ? argv[3] : "");
  }
  else if (what == "quality")
  {
    std::printf("%s\n", Columns);
    PrintQualities(Defaults, true);
  }
  else if (what == "settings")
  {
    std::printf("%s\n", Columns);
    for (const Setting& setting : Settings)
    {
      PrintQualities(setting, false);
    }
  }
  else if (what == "blocks")
  {
    std::printf("%s\n", Columns);
    PrintBlocks(argc > 2 ? static_cast<std::size_t>(std::atoll(argv[2])) : 10000);
  }
  else
  {
    std::printf("What is to be measured: cost, quality, settings or blocks?\n");
    return 1;
  }
  return 0;
}
