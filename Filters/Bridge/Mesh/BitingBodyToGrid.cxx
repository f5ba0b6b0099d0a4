// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "BitingBodyToGrid.h"

#include "../Data/ArrayFromVector.h"
#include "MeasuredTetrahedra.h"
#include "SurfaceToPolyData.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm> // for transform
#include <numeric>   // for iota
#include <utility>   // for move

namespace biting
{

namespace
{

constexpr std::uint8_t InsideKind = 3; // after those of SurfaceVertexKind

void BoundaryToPolyData(BitingBody& body, const CheckedSurface& surface, const Drawing& drawing,
  vtkPolyData* output, Pulse& pulse)
{
  BitingSurface& boundary = body.Boundary;
  std::transform(body.BoundaryCells.begin(), body.BoundaryCells.end(), boundary.Regions.begin(),
    [&body](Id cell) { return body.Regions[cell]; });
  BitingSurfaceToPolyData(boundary, surface, drawing, output, pulse);
  std::vector<Id> numbers(boundary.Points.size());
  std::iota(numbers.begin(), numbers.end(), 0);
  AddArray<vtkIdTypeArray>(output->GetPointData(), "MeshPointId", numbers, pulse);
  AddArray<vtkIdTypeArray>(output->GetCellData(), "MeshCellId", body.BoundaryCells, pulse);
}

std::vector<std::uint8_t> KindsOf(const BitingBody& body)
{
  std::vector<std::uint8_t> kinds(body.BiteOrders.size(), InsideKind);
  std::transform(body.Boundary.Kinds.begin(), body.Boundary.Kinds.end(), kinds.begin(),
    [](SurfaceVertexKind kind) { return static_cast<std::uint8_t>(kind); });
  return kinds;
}

double WholeVolume(const BitingBody& body)
{
  double volume = 0.0;
  for (std::size_t corner = 0; corner < body.Corners.size(); corner += 4)
  {
    const auto at = [&body, corner](std::size_t k) -> const Point3&
    { return body.Points[body.Corners[corner + k]]; };
    volume += VolumeOf({ at(0), at(1), at(2), at(3) });
  }
  return volume;
}

} // namespace

std::string BitingBodyToGrid(BitingBody& body, const CheckedSurface& surface,
  const Drawing& drawing, vtkUnstructuredGrid* mesh, vtkPolyData* boundary, Monitor& monitor)
{
  Pulse pulse(monitor);
  BoundaryToPolyData(body, surface, drawing, boundary, pulse);
  const double volume = WholeVolume(body);
  MeasuredTetrahedra measured;
  measured.Points = std::move(body.Points);
  measured.Spacing = std::move(body.Spacing);
  measured.Corners = std::move(body.Corners);
  measured.Quality =
    MeasureTetrahedra({ measured.Points, measured.Spacing, measured.Corners }, monitor);
  mesh->Initialize();
  mesh->SetPoints(MakePoints(measured.Points, VTK_DOUBLE, pulse));
  vtkNew<vtkCellArray> cells;
  SetCells(cells, 4, measured.Corners, pulse);
  mesh->SetCells(VTK_TETRA, cells);
  vtkPointData* pointData = mesh->GetPointData();
  AddArray<vtkIntArray>(pointData, "BiteOrder", body.BiteOrders, pulse);
  AddArray<vtkUnsignedCharArray>(pointData, "VertexKind", KindsOf(body), pulse);
  AddArray<vtkIdTypeArray>(pointData, "OriginalPointId", body.OriginalPoints, pulse);
  AddArray<vtkIdTypeArray>(mesh->GetCellData(), "RegionId", body.Regions, pulse);
  const std::size_t vertices = measured.Points.size();
  ReleaseInSteps(pulse, measured.Points, body.BiteOrders, body.OriginalPoints);
  measured.Write(mesh);
  vtkFieldData* figures = mesh->GetFieldData();
  for (const char* name : { "EulerNumber", "LargestDeviation" })
  {
    figures->AddArray(boundary->GetFieldData()->GetArray(name));
  }
  AddFigure(figures, "Volume", volume);
  const auto figure = [figures](const char* name, int digits)
  { return Figure(figures->GetArray(name)->GetComponent(0, 0), digits); };
  return measured.Summary() + "Largest deviation from the surface " +
    figure("LargestDeviation", 3) + " spacings\nVolume: " + figure("Volume", 6) +
    "\nEuler number of the boundary: " + figure("EulerNumber", 6) + "\n" +
    CapsText(body.Boundary.AskedVertices, vertices);
}

} // namespace biting
