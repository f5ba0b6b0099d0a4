// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "PolylinesFromPolyData.h"

#include "../Kernel/Base/Box2.h"
#include "../Kernel/Base/Pulse.h"
#include "../Kernel/Base/SortInSteps.h"
#include "DoubleArray.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkPolyData.h"
#include "vtkVariant.h"

#include <algorithm> // for all_of
#include <cmath>     // for isfinite
#include <limits>    // for the size check
#include <utility>   // for pair

namespace biting
{

namespace
{

// Where steps end, as shares of the time: of all, and of what follows the cells.
constexpr double CellsEnd = 0.4;
constexpr double FrameEnd = 0.5;
constexpr double MapEnd = 0.7;

// Reads one kind of cells after the other into the chains of a PlanarInput.
class ChainReader
{
public:
  ChainReader(vtkPolyData* input, PlanarInput& result, Pulse& pulse)
    : Input(input)
    , Result(result)
    , Beats(pulse)
  {
  }

  std::string Read();

private:
  std::string FindKinds();
  std::string ReadCells(vtkCellArray* cells, ChainKind kind);
  std::string UsePoints(Id cell, vtkIdType size, const vtkIdType* points);
  std::string AddChain(Id cell, vtkIdType size, const vtkIdType* points, ChainKind kind);
  std::string KindOf(Id cell, ChainKind& kind) const;

  vtkPolyData* Input;
  PlanarInput& Result;
  Pulse& Beats;
  vtkDataArray* Kinds = nullptr;
  vtkIdType NextCell = 0;
};

bool IsTooLarge(vtkPolyData* input)
{
  const vtkIdType corners = input->GetLines()->GetNumberOfConnectivityIds() +
    input->GetPolys()->GetNumberOfConnectivityIds() + input->GetPolys()->GetNumberOfCells() +
    input->GetVerts()->GetNumberOfConnectivityIds();
  constexpr vtkIdType Limit = std::numeric_limits<Id>::max();
  return input->GetNumberOfPoints() > Limit || input->GetNumberOfCells() > Limit || corners > Limit;
}

std::string ChainReader::Read()
{
  if (IsTooLarge(this->Input))
  {
    return "The input has more points or cells than 32-bit ids can number.";
  }
  this->Result.IsUsed.assign(static_cast<std::size_t>(this->Input->GetNumberOfPoints()), 0);
  std::string refusal = this->FindKinds();
  if (refusal.empty())
  {
    refusal = this->ReadCells(this->Input->GetVerts(), ChainKind::EmbeddedPoint);
  }
  if (refusal.empty())
  {
    refusal = this->ReadCells(this->Input->GetLines(), ChainKind::Automatic);
  }
  if (refusal.empty())
  {
    refusal = this->ReadCells(this->Input->GetPolys(), ChainKind::Boundary);
  }
  return refusal;
}

std::string ChainReader::FindKinds()
{
  vtkCellData* cellData = this->Input->GetCellData();
  this->Kinds = cellData->GetArray("Kind");
  if (cellData->GetAbstractArray("Kind") && !this->Kinds)
  {
    return "The cell array Kind is not numeric; it takes 0 (boundary), 1 (interface) and 2 "
           "(embedded points).";
  }
  const vtkIdType kinds = this->Kinds ? this->Kinds->GetNumberOfTuples() : 0;
  const vtkIdType cells = this->Input->GetNumberOfCells();
  if (this->Kinds && kinds < cells)
  {
    return "The cell array Kind has " + std::to_string(kinds) + " values for " +
      std::to_string(cells) + " cells.";
  }
  return {};
}

std::string ChainReader::ReadCells(vtkCellArray* cells, ChainKind kind)
{
  std::string refusal;
  auto iterator = vtk::TakeSmartPointer(cells->NewIterator());
  for (iterator->GoToFirstCell();
       !iterator->IsDoneWithTraversal() && refusal.empty() && this->Beats.Beat();
       iterator->GoToNextCell(), ++this->NextCell)
  {
    this->Beats.SetFraction(
      CellsEnd * static_cast<double>(this->NextCell) / this->Input->GetNumberOfCells());
    vtkIdType size = 0;
    const vtkIdType* points = nullptr;
    iterator->GetCurrentCell(size, points);
    const Id cell = static_cast<Id>(this->NextCell);
    refusal = this->UsePoints(cell, size, points);
    if (refusal.empty())
    {
      refusal = this->AddChain(cell, size, points, kind);
    }
  }
  return refusal;
}

std::string ChainReader::UsePoints(Id cell, vtkIdType size, const vtkIdType* points)
{
  for (vtkIdType k = 0; k < size && this->Beats.Beat(); ++k)
  {
    if (points[k] < 0 || points[k] >= this->Input->GetNumberOfPoints())
    {
      return "Cell " + std::to_string(cell) + " refers to point " + std::to_string(points[k]) +
        ", which does not exist.";
    }
    this->Result.IsUsed[static_cast<std::size_t>(points[k])] = 1;
  }
  return {};
}

std::string ChainReader::AddChain(Id cell, vtkIdType size, const vtkIdType* points, ChainKind kind)
{
  const bool isPolygon = kind == ChainKind::Boundary;
  const std::string refusal = this->KindOf(cell, kind);
  if (size == 0 || !refusal.empty())
  {
    return refusal;
  }
  Polylines& chains = this->Result.Chains;
  for (vtkIdType k = 0; k < size; ++k)
  {
    chains.Connectivity.push_back(static_cast<Id>(points[k]));
  }
  if (isPolygon && kind != ChainKind::EmbeddedPoint && points[0] != points[size - 1])
  {
    chains.Connectivity.push_back(static_cast<Id>(points[0]));
  }
  chains.Offsets.push_back(static_cast<Id>(chains.Connectivity.size()));
  chains.Kinds.push_back(kind);
  chains.Cells.push_back(cell);
  return {};
}

std::string ChainReader::KindOf(Id cell, ChainKind& kind) const
{
  // A vertex cell has no segments: it is embedded, whatever the array says.
  if (!this->Kinds || kind == ChainKind::EmbeddedPoint)
  {
    return {};
  }
  const double value = this->Kinds->GetComponent(cell, 0);
  if (value != 0.0 && value != 1.0 && value != 2.0)
  {
    return "Cell " + std::to_string(cell) + " has an unknown Kind, " +
      vtkVariant(value).ToString() +
      "; it takes 0 (boundary), 1 (interface) and 2 (embedded "
      "points).";
  }
  kind = static_cast<ChainKind>(static_cast<int>(value));
  return {};
}

void ListUsedPoints(PlanarInput& input, Pulse& pulse)
{
  const PulsePart part(pulse, 0.0, 0.0);
  pulse.ForEach(input.IsUsed.size(),
    [&input](std::size_t point)
    {
      if (input.IsUsed[point])
      {
        input.UsedPoints.push_back(static_cast<Id>(point));
      }
    });
}

void RefuseNotFinite(const PlanarInput& input, ProblemList& problems, Pulse& pulse)
{
  const PulsePart part(pulse, 0.0, 0.0);
  pulse.ForEach(input.UsedPoints.size(),
    [&input, &problems](std::size_t k)
    {
      const Id point = input.UsedPoints[k];
      const double* place = input.Place(point);
      if (!std::all_of(place, place + 3, [](double value) { return std::isfinite(value); }))
      {
        problems.Add({ ProblemCode::NotFinite, { point }, {}, {} });
      }
    });
}

void MapToPlane(PlanarInput& input, Pulse& pulse)
{
  const PulsePart part(pulse, FrameEnd, MapEnd);
  input.Chains.Points.resize(input.IsUsed.size());
  pulse.ForEach(input.UsedPoints.size(),
    [&input](std::size_t k)
    {
      const Id point = input.UsedPoints[k];
      input.Chains.Points[static_cast<std::size_t>(point)] =
        input.Frame.ToPlane(input.Place(point));
    });
}

double Diagonal(const PlanarInput& input, Pulse& pulse)
{
  Box2 box;
  pulse.ForEach(input.UsedPoints.size(),
    [&input, &box](std::size_t k)
    { box.Add(input.Chains.Points[static_cast<std::size_t>(input.UsedPoints[k])]); });
  return box.Diagonal();
}

// A point and its distance from the plane, worst first.
using Distances = std::vector<std::pair<double, Id>>;

Distances FindNotPlanar(const PlanarInput& input, Pulse& pulse)
{
  const double size = Diagonal(input, pulse);
  Distances off;
  pulse.ForEach(input.UsedPoints.size(),
    [&input, size, &off](std::size_t k)
    {
      const Id point = input.UsedPoints[k];
      const double distance = std::abs(input.Frame.Distance(input.Place(point)));
      if (distance > PlanarTolerance * size)
      {
        off.emplace_back(distance, point);
      }
    });
  SortInSteps(
    off,
    [](const auto& a, const auto& b)
    { return a.first != b.first ? a.first > b.first : a.second < b.second; },
    pulse);
  return off;
}

void RefuseNotPlanar(const PlanarInput& input, ProblemList& problems, Pulse& pulse)
{
  const PulsePart part(pulse, MapEnd, 1.0);
  for (const auto& [distance, point] : FindNotPlanar(input, pulse))
  {
    if (!pulse.Beat())
    {
      return;
    }
    problems.Add(
      { ProblemCode::NotPlanar, { point }, input.Chains.Points[static_cast<std::size_t>(point)],
        "it lies " + vtkVariant(distance).ToString() + " from the plane" });
  }
}

} // namespace

std::string PolylinesFromPolyData(
  vtkPolyData* input, PlanarInput& result, ProblemList& problems, Monitor& monitor)
{
  Pulse pulse(monitor);
  const std::string refusal = ChainReader(input, result, pulse).Read();
  if (!refusal.empty() || result.Chains.NumberOfChains() == 0)
  {
    return refusal;
  }
  const PulsePart part(pulse, CellsEnd, 1.0);
  result.Coordinates = AsDoubles(input->GetPoints()->GetData());
  ListUsedPoints(result, pulse);
  RefuseNotFinite(result, problems, pulse);
  if (problems.HasErrors() || pulse.HasStopped())
  {
    return {};
  }
  result.Frame = PlaneFrame::FitTo(result.Coordinates->GetPointer(0), result.UsedPoints, pulse);
  MapToPlane(result, pulse);
  RefuseNotPlanar(result, problems, pulse);
  return {};
}

} // namespace biting
