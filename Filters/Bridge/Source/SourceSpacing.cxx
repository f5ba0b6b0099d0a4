// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SourceSpacing.h"

#include "../../Kernel/Base/Pulse.h"
#include "../Data/Arrays.h"
#include "../Run/ProblemReport.h"
#include "SourceCells.h"
#include "SpacingValues.h"

#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkPointData.h"
#include "vtkRectilinearGrid.h"

#include <algorithm> // for adjacent_find, all_of, clamp, none_of
#include <array>     // for axes
#include <cmath>     // for isfinite, isnan
#include <cstddef>   // for steps
#include <cstdint>   // for marks
#include <limits>    // for NaN
#include <utility>   // for move

namespace biting
{

namespace
{

using AxisNodes = std::array<std::vector<double>, 3>;

// Whether cells are left out; a ghost array alone says nothing.
bool LeavesOutCells(vtkDataSet* source)
{
  return HasGhosts(source, vtkDataObject::POINT, vtkDataSetAttributes::HIDDENPOINT) ||
    HasGhosts(source, vtkDataObject::CELL, CellsNotHere);
}

// The coordinates of the grid lines of an image whose axes are those of space; empty for others.
AxisNodes NodesOfImage(vtkImageData* image)
{
  AxisNodes nodes;
  if (!image->GetDirectionMatrix()->IsIdentity())
  {
    return nodes;
  }
  const int* extent = image->GetExtent();
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    for (int k = extent[2 * axis]; k <= extent[2 * axis + 1]; ++k)
    {
      nodes[axis].push_back(image->GetOrigin()[axis] + k * image->GetSpacing()[axis]);
    }
  }
  return nodes;
}

AxisNodes NodesOfRectilinearGrid(vtkRectilinearGrid* grid)
{
  AxisNodes nodes;
  vtkDataArray* arrays[3] = { grid->GetXCoordinates(), grid->GetYCoordinates(),
    grid->GetZCoordinates() };
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const auto doubles = AsDoubles(arrays[axis]);
    const double* first = doubles->GetPointer(0);
    nodes[axis].assign(first, first + doubles->GetNumberOfValues());
  }
  return nodes;
}

AxisNodes NodesOfGrid(vtkDataSet* source)
{
  if (auto* image = vtkImageData::SafeDownCast(source))
  {
    return NodesOfImage(image);
  }
  if (auto* grid = vtkRectilinearGrid::SafeDownCast(source))
  {
    return NodesOfRectilinearGrid(grid);
  }
  return {};
}

// Why an image lies nowhere; empty where it does not, or the source is no image.
std::string CheckImage(vtkDataSet* source)
{
  auto* image = vtkImageData::SafeDownCast(source);
  if (!image || (AreFinite(image->GetOrigin()) && AreFinite(image->GetSpacing())))
  {
    return {};
  }
  const double* origin = image->GetOrigin();
  const double* steps = image->GetSpacing();
  return "The spacing source lies nowhere: the origin of the image is " +
    PlaceText({ origin[0], origin[1], origin[2] }) + " and its spacing of points " +
    PlaceText({ steps[0], steps[1], steps[2] }) + ". Both must be finite.";
}

// Which of `points` of the source lie nowhere.
std::string CheckPoints(vtkDataSet* source, const std::vector<vtkIdType>& points, Pulse& pulse)
{
  std::vector<std::string> first;
  std::int64_t count = 0;
  for (const vtkIdType point : points)
  {
    Point3 place;
    source->GetPoint(point, place.Data());
    if (pulse.Beat(1) && !AreFinite(place.Data()) && ++count <= static_cast<std::int64_t>(ShownIds))
    {
      first.push_back("point " + std::to_string(point) + " at " + PlaceText(place));
    }
  }
  return count == 0 ? ""
                    : "The spacing source has coordinates that are not finite (" +
      std::to_string(count) + "): " + ListText(first, count) + ". Correct or remove these points.";
}

bool IsAscending(const std::vector<double>& nodes)
{
  const bool isFinite =
    std::all_of(nodes.begin(), nodes.end(), [](double node) { return std::isfinite(node); });
  const auto repeated = std::adjacent_find(
    nodes.begin(), nodes.end(), [](double node, double next) { return !(node < next); });
  return isFinite && !nodes.empty() && repeated == nodes.end();
}

// The source as a grid of the plane, which takes the values; null where it is none.
std::shared_ptr<GridSource> GridFrom(
  vtkDataSet* source, std::vector<double>& values, const PlaneFrame& frame, Pulse& pulse)
{
  const PulsePart part(pulse, 0.0, GridEnd);
  std::optional<PlaneGrid> plane = GridOf(source, frame);
  if (!plane)
  {
    return nullptr;
  }
  auto grid = std::make_shared<GridSource>();
  grid->XNodes = std::move(plane->XNodes);
  grid->YNodes = std::move(plane->YNodes);
  const std::size_t width = grid->XNodes.size();
  const bool isInOrder = plane->Along == 1 && plane->Across == width;
  if (isInOrder)
  {
    grid->Values = std::move(values);
    return grid;
  }
  grid->Values.resize(width * grid->YNodes.size(), 0.0);
  pulse.ForEach(grid->Values.size(),
    [&values, &grid, width, along = plane->Along, across = plane->Across](std::size_t k)
    { grid->Values[k] = values[k % width * along + k / width * across]; });
  return grid;
}

bool HasArea(const TriangulatedSource& source, Pulse& pulse)
{
  for (std::size_t k = 0; k < source.Triangles.size() && pulse.Beat(); k += 3)
  {
    const Point2& a = source.Points[source.Triangles[k]];
    const Point2& b = source.Points[source.Triangles[k + 1]];
    const Point2& c = source.Points[source.Triangles[k + 2]];
    if (Cross(b - a, c - a) != 0.0)
    {
      return true;
    }
  }
  return false;
}

std::string AddGrid(const SourceData& chosen, const std::vector<double>& values,
  const std::shared_ptr<const GridSource>& grid, SpacingOptions& options, ProblemPlaces& places,
  Pulse& pulse)
{
  options.Sources.emplace_back(grid);
  return CheckReadValues(chosen.Data, chosen.Chosen.Array, values.empty() ? grid->Values : values,
    nullptr, SpacingOwner::Source, places, pulse);
}

std::string AddCells(const SourceData& chosen, const std::vector<double>& values,
  const PlaneFrame& frame, SpacingOptions& options, ProblemPlaces& places, Pulse& pulse)
{
  vtkDataSet* source = chosen.Data;
  SourceCells cells(source, frame, pulse);
  std::string refusal = cells.Collect();
  const std::vector<vtkIdType> points = cells.UsedPoints();
  if (refusal.empty())
  {
    refusal = CheckPoints(source, points, pulse);
  }
  if (refusal.empty())
  {
    refusal = CheckReadValues(
      source, chosen.Chosen.Array, values, &points, SpacingOwner::Source, places, pulse);
  }
  if (!refusal.empty())
  {
    return refusal;
  }
  const auto triangulation = cells.Triangulation(values.data());
  const PulsePart part(pulse, TrianglesEnd, 1.0);
  SortSource(*triangulation, pulse);
  triangulation->MayOverlap = true;
  options.Sources.emplace_back(triangulation);
  return HasArea(*triangulation, pulse)
    ? ""
    : "The cells of the spacing source have no area in the plane of the input.";
}

bool IsFillValue(double value)
{
  return !std::isnan(value) && !(value > 0.0 && std::isfinite(value));
}

// The values, NaN for those that are no spacing where none is wanted; elsewhere zero and negative
// ones are `least` where that is above 0.
std::vector<double> KnownValues(vtkDataSet* source, vtkDataArray* given, const PlaneFrame& frame,
  const std::function<bool(const Point2&)>& isWanted, double least, Pulse& pulse)
{
  std::vector<double> values = ReadDoubles(given, source->GetNumberOfPoints());
  bool isAnyKnown = false;
  pulse.ForEach(values.size(),
    [source, &frame, &isWanted, least, &values, &isAnyKnown](std::size_t point)
    {
      double& value = values[point];
      if (!IsFillValue(value))
      {
        isAnyKnown = isAnyKnown || value > 0.0;
        return;
      }
      double place[3];
      source->GetPoint(static_cast<vtkIdType>(point), place);
      if (!isWanted(frame.ToPlane(place)))
      {
        value = std::numeric_limits<double>::quiet_NaN();
      }
      else if (least > 0.0 && value <= 0.0)
      {
        value = least;
        isAnyKnown = true;
      }
    });
  if (!isAnyKnown) // what is given is refused by its values
  {
    return ReadDoubles(given, source->GetNumberOfPoints());
  }
  return values;
}

constexpr double LeastLevel = -0.996; // about the cosine of 175 degrees

// In degrees: each cell two triangles.
TriangulatedSource TrianglesOf(const GridSource& grid)
{
  TriangulatedSource source;
  source.Values = grid.Values;
  source.Points.reserve(grid.Values.size());
  source.Triangles.reserve(6 * grid.Values.size());
  for (const double y : grid.YNodes)
  {
    for (const double x : grid.XNodes)
    {
      source.Points.push_back({ x, y });
    }
  }
  const auto width = static_cast<Id>(grid.XNodes.size());
  for (Id row = 1; row < static_cast<Id>(grid.YNodes.size()); ++row)
  {
    for (Id k = row * width + 1; k < (row + 1) * width; ++k)
    {
      const Id below = k - width;
      source.Triangles.insert(source.Triangles.end(), { below - 1, below, k, below - 1, k, k - 1 });
    }
  }
  return source;
}

// Takes a source, which is in degrees, into the stereographic plane `frame`, as triangles that are
// straight and linear there: of cells up to 10 degrees wide that is as in degrees but for about 2
// % of what f changes in one, up to 90 degrees from the middle (w tan(c / 2) / 8 for the width w
// and the distance c, as the scale changes). Triangles with a corner more than 175 degrees from
// the middle are left out.
std::shared_ptr<const TriangulatedSource> SourceOnGlobe(
  const PlaneFrame& frame, const GivenSource& source, Pulse& pulse)
{
  const auto* grid = std::get_if<std::shared_ptr<const GridSource>>(&source);
  auto mapped = std::make_shared<TriangulatedSource>(
    grid ? TrianglesOf(**grid) : *std::get<std::shared_ptr<const TriangulatedSource>>(source));
  std::vector<std::uint8_t> isFar;
  isFar.reserve(mapped->Points.size());
  for (Point2& point : mapped->Points)
  {
    const Point3 degrees{ point.X, std::clamp(point.Y, -90.0, 90.0), 0.0 };
    isFar.push_back(frame.LevelOf(degrees.Data()) < LeastLevel);
    point = isFar.back() ? Point2() : frame.ToPlane(degrees.Data());
  }
  std::vector<Id> near;
  near.reserve(mapped->Triangles.size());
  for (std::size_t k = 0; k < mapped->Triangles.size() && pulse.Beat(); k += 3)
  {
    const auto first = mapped->Triangles.begin() + static_cast<std::ptrdiff_t>(k);
    if (std::none_of(first, first + 3, [&isFar](Id point) { return isFar[point] != 0; }))
    {
      near.insert(near.end(), first, first + 3);
    }
  }
  mapped->Triangles = std::move(near);
  SortSource(*mapped, pulse);
  mapped->MayOverlap = true;
  return mapped;
}

} // namespace

std::optional<PlaneGrid> GridOf(vtkDataSet* source, const PlaneFrame& frame)
{
  const AxisNodes nodes = NodesOfGrid(source);
  const auto first = static_cast<std::size_t>(frame.Axis(0));
  const auto second = static_cast<std::size_t>(frame.Axis(1));
  const auto normal = static_cast<std::size_t>(frame.Axis(2));
  if (!frame.IsAxisAligned() || nodes[normal].size() != 1 || !IsAscending(nodes[first]) ||
    !IsAscending(nodes[second]) || LeavesOutCells(source))
  {
    return std::nullopt;
  }
  const std::array<std::size_t, 3> strides{ 1, nodes[0].size(), nodes[0].size() * nodes[1].size() };
  return PlaneGrid{ nodes[first], nodes[second], strides[first], strides[second] };
}

std::string AddSourceSpacing(const SourceData& chosen, const PlaneFrame& frame,
  const std::function<bool(const Point2&)>& isWanted, SpacingOptions& options,
  ProblemPlaces& places, Monitor& monitor)
{
  if (frame.IsOnGlobe())
  {
    const auto isWantedInDegrees = [&frame, &isWanted](const Point2& degrees)
    { return isWanted(frame.ToPlane(Point3(degrees).Data())); };
    const std::size_t count = options.Sources.size();
    const std::string refusal =
      AddSourceSpacing(chosen, frame.OfDegrees(), isWantedInDegrees, options, places, monitor);
    if (!refusal.empty() || options.Sources.size() == count)
    {
      return refusal;
    }
    Pulse pulse(monitor);
    const auto source = SourceOnGlobe(frame, options.Sources.back(), pulse);
    options.Sources.back() = source;
    return source->IsEmpty() && !pulse.HasStopped()
      ? "The spacing source has no cells on this side of the globe, or they are wider than a "
        "quarter of it."
      : "";
  }
  Pulse pulse(monitor);
  vtkDataSet* source = chosen.Data;
  vtkDataArray* given = chosen.Chosen.Array;
  const std::string shape = CheckShape(source, given);
  const std::string unusable = shape.empty() ? CheckImage(source) : shape;
  if (!unusable.empty())
  {
    return unusable;
  }
  std::vector<double> values =
    KnownValues(source, given, frame, isWanted, LeastValue(options), pulse);
  const std::shared_ptr<const GridSource> grid = GridFrom(source, values, frame, pulse);
  const std::string refusal = grid ? AddGrid(chosen, values, grid, options, places, pulse)
                                   : AddCells(chosen, values, frame, options, places, pulse);
  return pulse.HasStopped() ? "" : refusal;
}

} // namespace biting
