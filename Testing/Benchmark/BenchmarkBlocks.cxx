// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

// Large meshes as one block and as several, on one thread and on more.
//   BenchmarkBlocks [vertices [vertices of a block [threads [name]]]]
// Cases whose name has `name` in it, of so many vertices (1000000): one block, then blocks of that
// size on one thread, and on 2 to `threads` (2). Seconds by the clock and of CPU, room by room, the
// second also of the calling thread alone, which is what is serial where there are others; quality.
// By the clock threads can be compared where the machine has nothing else to do.

#include "../Kernel/Support/TestThreads.h"
#include "MeshCases.h"

#include <algorithm> // for sort
#include <chrono>    // for the clock
#include <cstdio>    // for tables
#include <cstdlib>   // for arguments
#include <ctime>     // for CPU time
#include <map>       // for stages

namespace
{

using namespace biting;

double CpuSeconds(clockid_t clock)
{
  timespec time{};
  clock_gettime(clock, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

double ClockSeconds()
{
  using Clock = std::chrono::steady_clock;
  return std::chrono::duration<double>(Clock::now().time_since_epoch()).count();
}

/// Adds up the times of each stage. Looks after its threads as often as the filters do.
class StageClock : public MonitorWithThreads
{
public:
  explicit StageClock(int numberOfThreads)
    : MonitorWithThreads(numberOfThreads, std::chrono::milliseconds(20))
  {
  }

  struct Time
  {
    double Wall = ClockSeconds();
    double Cpu = CpuSeconds(CLOCK_PROCESS_CPUTIME_ID);
    double Serial = CpuSeconds(CLOCK_THREAD_CPUTIME_ID);
  };

  void BeginStage(const char* text) override
  {
    this->Stop();
    this->Stage = text;
  }

  void Stop()
  {
    const Time now;
    Time& spent = this->Spent.try_emplace(this->Stage, Time{ 0.0, 0.0, 0.0 }).first->second;
    spent.Wall += now.Wall - this->Begin.Wall;
    spent.Cpu += now.Cpu - this->Begin.Cpu;
    spent.Serial += now.Serial - this->Begin.Serial;
    this->Begin = now;
  }

  std::map<std::string, Time> Spent;

private:
  std::string Stage;
  Time Begin;
};

constexpr const char* Stages[] = { "Reading the domain", "Preparing the spacing", "Biting",
  "Triangulating", "Relaxing", "Measuring quality" };

void PrintTimes(const StageClock& clock)
{
  StageClock::Time sum{ 0.0, 0.0, 0.0 };
  for (const auto& [stage, time] : clock.Spent)
  {
    sum.Wall += time.Wall;
    sum.Cpu += time.Cpu;
    sum.Serial += time.Serial;
  }
  std::printf(" %6.2f %6.2f %6.2f |", sum.Wall, sum.Cpu, sum.Serial);
  for (const char* stage : Stages)
  {
    const auto found = clock.Spent.find(stage);
    const StageClock::Time time =
      found == clock.Spent.end() ? StageClock::Time{ 0.0, 0.0, 0.0 } : found->second;
    std::printf(" %5.2f %5.2f %5.3f |", time.Wall, time.Cpu, time.Serial);
  }
}

void PrintQuality(const BitingMesh& mesh)
{
  std::vector<double> angles = mesh.Quality.MinimumAngle;
  std::sort(angles.begin(), angles.end());
  double sum = 0.0;
  for (const double angle : angles)
  {
    sum += angle;
  }
  std::printf(" %5.2f %5.2f %6.3f %.4f %6.2f\n", angles.front(), angles[angles.size() / 100],
    sum / static_cast<double>(angles.size()), mesh.Quality.MeanConformity,
    100.0 * mesh.Quality.ShareOfEdgesInBand);
}

void RunOnce(const MeshCase& one, std::int64_t verticesPerBlock, int numberOfThreads)
{
  BitingMeshOptions options = one.Options;
  options.VerticesPerBlock = verticesPerBlock;
  options.MaximumNumberOfVertices = 200000000;
  ProblemList problems;
  StageClock clock(numberOfThreads);
  const BitingMesh mesh = MakeBitingMesh(one.Drawing, options, problems, clock);
  clock.Stop();
  if (mesh.Points.empty())
  {
    std::printf("| %-24s | no mesh\n", one.Name.c_str());
    return;
  }
  std::printf("| %-24s | %8zu | %4d | %2d |", one.Name.c_str(), mesh.Points.size(),
    static_cast<int>(mesh.NumberOfBlocks), numberOfThreads);
  PrintTimes(clock);
  PrintQuality(mesh);
  std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv)
{
  const double vertices = argc > 1 ? std::atof(argv[1]) : 1e6;
  const std::int64_t perBlock = argc > 2 ? std::atoll(argv[2]) : 64000;
  const int threads = argc > 3 ? std::atoi(argv[3]) : 2;
  const std::string name = argc > 4 ? argv[4] : "";
  std::printf("Case, vertices, blocks, threads; seconds by the clock and of CPU: all, domain, "
              "spacing, biting,\ntriangulation, relaxation, quality; smallest angle, 1 %%, mean; "
              "conformity; edges in band\n");
  const double ofCoast = 22466.0;
  for (const MeshCase& one : { UniformSquare(vertices), SectionSix(vertices),
         OfFile("coast.vtk", 0.15, std::sqrt(ofCoast / vertices)) })
  {
    if (one.Name.find(name) == std::string::npos || one.Drawing.Points.empty())
    {
      continue;
    }
    if (threads >= 1)
    {
      RunOnce(one, 0, 1);
    }
    for (int number = 1; number <= threads; ++number)
    {
      RunOnce(one, perBlock, number);
    }
  }
  return 0;
}
