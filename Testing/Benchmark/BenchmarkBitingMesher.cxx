// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

// The whole filter: CPU microseconds per output vertex at about 10 000, 100 000 and 1 000 000
// vertices, and the exponent with which CPU time has grown since the size before (1 is linear).
// Links to Biting::Filters, VTK::CommonCore, VTK::CommonDataModel, VTK::CommonExecutionModel and
// benchmark::benchmark.

#include "PaperSpacing.h"

#include "vtkBitingMesher.h"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkRectilinearGrid.h>

#include <benchmark/benchmark.h>

#include <algorithm> // for min
#include <cmath>     // for log, sqrt
#include <cstdint>   // for sizes
#include <ctime>     // for CPU time
#include <iterator>  // for prev
#include <limits>    // for "not yet"
#include <map>       // for what is known

namespace
{

struct Measurement
{
  double Vertices = 0.0;
  double Seconds = 0.0;
};

using Measurements = std::map<std::int64_t, Measurement>; // by the wanted number of vertices

void MakeSquare(double side, vtkPolyData* square)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->InsertNextPoint(0.0, 0.0, 0.0);
  points->InsertNextPoint(side, 0.0, 0.0);
  points->InsertNextPoint(side, side, 0.0);
  points->InsertNextPoint(0.0, side, 0.0);
  const vtkIdType loop[] = { 0, 1, 2, 3, 0 };
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell(5, loop);
  square->SetPoints(points);
  square->SetLines(lines);
}

void MakeAxis(double length, int intervals, vtkDoubleArray* axis)
{
  for (int i = 0; i <= intervals; ++i)
  {
    axis->InsertNextValue(length * i / intervals);
  }
}

void MakePaperSource(vtkRectilinearGrid* source)
{
  vtkNew<vtkDoubleArray> x;
  vtkNew<vtkDoubleArray> y;
  vtkNew<vtkDoubleArray> z;
  MakeAxis(PaperSide, 1, x);
  MakeAxis(PaperSide, PaperIntervals, y);
  z->InsertNextValue(0.0);
  vtkNew<vtkDoubleArray> spacing;
  spacing->SetName("Spacing");
  for (vtkIdType row = 0; row < y->GetNumberOfValues(); ++row)
  {
    spacing->InsertNextValue(PaperSpacing(y->GetValue(row)));
    spacing->InsertNextValue(PaperSpacing(y->GetValue(row)));
  }
  source->SetDimensions(2, PaperIntervals + 1, 1);
  source->SetXCoordinates(x);
  source->SetYCoordinates(y);
  source->SetZCoordinates(z);
  source->GetPointData()->AddArray(spacing);
}

void PrepareUniform(double vertices, vtkBitingMesher* mesher)
{
  vtkNew<vtkPolyData> square;
  MakeSquare(1.0, square);
  mesher->SetInputData(square);
  // A mesh with mean edge length f has about 1.25 vertices for each square of side f.
  mesher->SetUniformSpacing(std::sqrt(1.25 / vertices));
}

void PreparePaper(double vertices, vtkBitingMesher* mesher)
{
  vtkNew<vtkPolyData> square;
  MakeSquare(PaperSide, square);
  vtkNew<vtkRectilinearGrid> source;
  MakePaperSource(source);
  mesher->SetInputData(square);
  mesher->SetSpacingSourceData(source);
  mesher->SetInputArrayToProcess(1, 1, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Spacing");
  mesher->SetGradation(0.0);
  // The integral of 1.25 / f^2.
  mesher->SetSpacingScale(std::sqrt(3000.0 / vertices));
}

double CpuSeconds()
{
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

// CPU time of the fastest of all updates.
Measurement Measure(benchmark::State& state, vtkBitingMesher* mesher)
{
  Measurement best{ 0.0, std::numeric_limits<double>::infinity() };
  for (auto step : state)
  {
    static_cast<void>(step);
    mesher->Modified();
    const double before = CpuSeconds();
    mesher->Update();
    best.Seconds = std::min(best.Seconds, CpuSeconds() - before);
  }
  best.Vertices = static_cast<double>(mesher->GetOutput()->GetNumberOfPoints());
  return best;
}

double GrowthExponent(const Measurement& small, const Measurement& large)
{
  return std::log(large.Seconds / small.Seconds) / std::log(large.Vertices / small.Vertices);
}

void Run(benchmark::State& state, void (*prepare)(double, vtkBitingMesher*), Measurements& known)
{
  vtkNew<vtkBitingMesher> mesher;
  prepare(static_cast<double>(state.range(0)), mesher);
  const Measurement measured = Measure(state, mesher);
  if (measured.Vertices == 0.0)
  {
    state.SkipWithError("no mesh");
    return;
  }
  state.counters["vertices"] = measured.Vertices;
  state.counters["us_per_vertex"] = 1e6 * measured.Seconds / measured.Vertices;
  const auto entry = known.insert_or_assign(state.range(0), measured).first;
  if (entry != known.begin())
  {
    state.counters["growth_exponent"] = GrowthExponent(std::prev(entry)->second, measured);
  }
}

void UniformSquare(benchmark::State& state)
{
  static Measurements known;
  Run(state, PrepareUniform, known);
}

void SectionSixOfThePaper(benchmark::State& state)
{
  static Measurements known;
  Run(state, PreparePaper, known);
}

} // namespace

BENCHMARK(UniformSquare)->RangeMultiplier(10)->Range(10000, 1000000)->Unit(benchmark::kMillisecond);
BENCHMARK(SectionSixOfThePaper)
  ->RangeMultiplier(10)
  ->Range(10000, 1000000)
  ->Unit(benchmark::kMillisecond);

BENCHMARK_MAIN();
