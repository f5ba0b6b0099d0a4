// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "TransferredArrays.h"

#include "../../Kernel/Base/Box.h"
#include "../../Kernel/Quality/TriangleLinks.h"
#include "../../Kernel/Remeshing/OldPlaces.h"
#include "../Data/ArrayFromVector.h"
#include "../Data/CarriedArrays.h"
#include "SourceCells.h"
#include "SourceData.h"
#include "SourceSpacing.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm> // for clamp, max, min, none_of, upper_bound
#include <cmath>     // for isfinite
#include <numeric>   // for iota
#include <string>    // for names

namespace biting
{

namespace
{

// Of the size of the source: places no farther outside are inside.
constexpr double BorderTolerance = 1e-6;

// Where each place is among the points of the source; and whether it is in a cell.
struct FoundPlaces
{
  std::vector<TupleMix> Mixes;
  std::vector<unsigned char> AreInside;
};

bool IsMasked(vtkDataArray* mask, const TupleMix& mix)
{
  return mask &&
    std::any_of(mix.Tuples.begin(), mix.Tuples.begin() + mix.Size,
      [mask](vtkIdType point) { return mask->GetComponent(point, 0) == 0.0; });
}

// The interval of ascending nodes that holds x, or is nearest to it, and how far along it x is.
std::pair<std::size_t, double> IntervalOf(const std::vector<double>& nodes, double x)
{
  if (nodes.size() == 1)
  {
    return { 0, 0.0 };
  }
  const auto above = std::upper_bound(nodes.begin() + 1, nodes.end() - 1, x);
  const auto first = static_cast<std::size_t>(above - nodes.begin()) - 1;
  return { first, std::clamp((x - nodes[first]) / (nodes[first + 1] - nodes[first]), 0.0, 1.0) };
}

FoundPlaces PlacesInGrid(const PlaneGrid& grid, const std::vector<Point2>& places, Pulse& pulse)
{
  Box2 bounds{ { grid.XNodes.front(), grid.YNodes.front() },
    { grid.XNodes.back(), grid.YNodes.back() } };
  bounds.Grow(BorderTolerance * bounds.Diagonal());
  FoundPlaces found;
  pulse.ForEach(places.size(),
    [&grid, &places, &bounds, &found](std::size_t k)
    {
      const auto [column, x] = IntervalOf(grid.XNodes, places[k].X);
      const auto [row, y] = IntervalOf(grid.YNodes, places[k].Y);
      const auto point = [&grid](std::size_t i, std::size_t j)
      { return static_cast<vtkIdType>(i * grid.Along + j * grid.Across); };
      TupleMix mix;
      mix.Add(point(column, row), (1.0 - x) * (1.0 - y));
      mix.Add(point(column + 1, row), x * (1.0 - y));
      mix.Add(point(column, row + 1), (1.0 - x) * y);
      mix.Add(point(column + 1, row + 1), x * y);
      found.Mixes.push_back(mix);
      found.AreInside.push_back(bounds.Contains(places[k]) ? 1 : 0);
    });
  return found;
}

// The triangles of the plane with an area and without a masked point, as a mesh to look places up.
OldMesh TrianglesOf(const TriangulatedSource& source, const std::vector<TupleMix>& origins,
  vtkDataArray* mask, Pulse& pulse)
{
  OldMesh mesh;
  mesh.Points = source.Points;
  for (std::size_t k = 0; k + 2 < source.Triangles.size() && pulse.Beat(1); k += 3)
  {
    const Id* corners = source.Triangles.data() + k;
    const bool isMasked = std::any_of(corners, corners + 3,
      [mask, &origins](Id corner) { return IsMasked(mask, origins[corner]); });
    const double area = AreaOfTriangle(mesh.Points, corners);
    if (!isMasked && area != 0.0 && std::isfinite(area))
    {
      mesh.Corners.insert(mesh.Corners.end(), corners, corners + 3);
    }
  }
  mesh.Neighbors = LinkTriangles(mesh.Corners, static_cast<Id>(mesh.Points.size())).Neighbors;
  return mesh;
}

FoundPlaces PlacesInCells(
  vtkDataSet* source, const PlaneFrame& frame, const std::vector<Point2>& places, Pulse& pulse)
{
  FoundPlaces found;
  SourceCells cells(source, frame, pulse);
  if (!cells.Collect().empty() || pulse.HasStopped())
  {
    return found;
  }
  const std::vector<TupleMix> origins = cells.Origins();
  const std::vector<double> noValues(static_cast<std::size_t>(source->GetNumberOfPoints()), 0.0);
  const auto triangulation = cells.Triangulation(noValues.data());
  const OldMesh mesh = TrianglesOf(*triangulation, origins, MaskOf(source), pulse);
  if (mesh.Corners.empty() || pulse.HasStopped())
  {
    return found;
  }
  const Box2 bounds = Box2::Around(mesh.Points, mesh.Corners);
  std::vector<Id> all(static_cast<std::size_t>(mesh.NumberOfTriangles()));
  std::iota(all.begin(), all.end(), 0);
  const std::vector<OldPlace> olds = FindOldPlaces(mesh, all, places, pulse);
  for (std::size_t k = 0; k < olds.size() && pulse.Beat(1); ++k)
  {
    TupleMix mix;
    Point2 place{};
    for (std::size_t corner = 0; corner < 3; ++corner)
    {
      const Id vertex = mesh.Corners[3 * olds[k].Triangle + static_cast<Id>(corner)];
      const double weight = olds[k].Weights[corner];
      const TupleMix& origin = origins[vertex];
      place = place + weight * mesh.Points[vertex];
      for (std::size_t point = 0; point < origin.Size; ++point)
      {
        mix.Add(origin.Tuples[point], weight * origin.Weights[point]);
      }
    }
    found.Mixes.push_back(mix);
    found.AreInside.push_back(
      Distance(place, places[k]) <= BorderTolerance * bounds.Diagonal() ? 1 : 0);
  }
  return found;
}

std::vector<vtkAbstractArray*> ArraysToTransfer(vtkDataSet* source, vtkPointData* to)
{
  vtkPointData* data = source->GetPointData();
  std::vector<vtkAbstractArray*> arrays;
  for (int k = 0; k < data->GetNumberOfArrays(); ++k)
  {
    vtkAbstractArray* array = data->GetAbstractArray(k);
    const std::string name = array->GetName() ? array->GetName() : "";
    const int attribute = data->IsArrayAnAttribute(k);
    if (!name.empty() && !to->HasArray(name.c_str()) && name != ValidMaskName &&
      name != vtkDataSetAttributes::GhostArrayName() &&
      attribute != vtkDataSetAttributes::GLOBALIDS &&
      attribute != vtkDataSetAttributes::PEDIGREEIDS &&
      array->GetNumberOfTuples() >= source->GetNumberOfPoints())
    {
      arrays.push_back(array);
    }
  }
  return arrays;
}

bool HasMasked(vtkDataArray* mask)
{
  return mask && mask->GetRange(0)[0] == 0.0;
}

} // namespace

void TransferArrays(vtkDataObject* source, const PlaneFrame& frame,
  const std::vector<Point2>& places, vtkPointData* to, Pulse& pulse)
{
  const vtkSmartPointer<vtkDataSet> whole = WholeSource(source);
  if (!whole || places.empty())
  {
    return;
  }
  const std::vector<vtkAbstractArray*> arrays = ArraysToTransfer(whole, to);
  if (arrays.empty())
  {
    return;
  }
  const auto grid = HasMasked(MaskOf(whole)) ? std::nullopt : GridOf(whole, frame);
  const FoundPlaces found =
    grid ? PlacesInGrid(*grid, places, pulse) : PlacesInCells(whole, frame, places, pulse);
  for (std::size_t k = 0; k < arrays.size() && found.Mixes.size() == places.size(); ++k)
  {
    const auto array = NewArrayLike(arrays[k], static_cast<vtkIdType>(places.size()));
    pulse.ForEach(places.size(),
      [&array, &arrays, &found, k](std::size_t place)
      { SetMixed(array, static_cast<vtkIdType>(place), found.Mixes[place], arrays[k]); });
    to->AddArray(array);
  }
  if (found.Mixes.size() == places.size())
  {
    AddArray<vtkUnsignedCharArray>(to, ValidMaskName, found.AreInside, pulse);
  }
}

} // namespace biting
