// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "PolylinesFromPolyData.h"

#include "../../Kernel/Base/Box.h"
#include "../../Kernel/Base/Pulse.h"
#include "../../Kernel/Base/SortInSteps.h"
#include "../Data/DoubleArray.h"
#include "ChainReader.h"
#include "CoordinateRounding.h"
#include "RegionNumbers.h"

#include "vtkVariant.h"

#include <algorithm> // for max, max_element
#include <cmath>     // for abs
#include <limits>    // for epsilon
#include <utility>   // for pair

namespace biting
{

namespace
{

// Where steps end, as shares of the time: of all, and of what follows the cells.
constexpr double PolylinesEnd = 0.4;
constexpr double FrameEnd = 0.5;
constexpr double MapEnd = 0.7;

std::string ReadCells(
  const Drawing& drawing, const std::string& regionArray, PlanarInput& result, Pulse& pulse)
{
  std::vector<Id> regions;
  const std::string refusal = FindRegionNumbers(drawing, regionArray, regions, pulse);
  const PulsePart part(pulse, 0.0, PolylinesEnd);
  return refusal.empty() ? ReadChains(drawing, regions, result.Chains, result.IsUsed, pulse)
                         : refusal;
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
      if (!AreFinite(place))
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

// Along the axes of the plane; in a slanted plane they mix those of space.
Point2 InPlane(const CoordinateRounding& rounding, const PlaneFrame& frame)
{
  const auto along = [&rounding, &frame](int axis)
  { return rounding.Axes[static_cast<std::size_t>(frame.Axis(axis))]; };
  const double most = *std::max_element(rounding.Axes.begin(), rounding.Axes.end());
  return frame.IsAxisAligned() ? Point2{ along(0), along(1) } : Point2{ most, most };
}

double Diagonal(const PlanarInput& input, Pulse& pulse)
{
  const PulsePart part(pulse, MapEnd, MapEnd);
  Box2 box;
  pulse.ForEach(input.UsedPoints.size(),
    [&input, &box](std::size_t k)
    { box.Add(input.Chains.Points[static_cast<std::size_t>(input.UsedPoints[k])]); });
  return box.Diagonal();
}

// A point and its distance from the plane, worst first.
using Distances = std::vector<std::pair<double, Id>>;

Distances FindNotPlanar(const PlanarInput& input, double farthest, Pulse& pulse)
{
  Distances off;
  pulse.ForEach(input.UsedPoints.size(),
    [&input, farthest, &off](std::size_t k)
    {
      const Id point = input.UsedPoints[k];
      const double distance = std::abs(input.Frame.Distance(input.Place(point)));
      if (distance > farthest)
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

void RefuseNotPlanar(const PlanarInput& input, double farthest, ProblemList& problems, Pulse& pulse)
{
  const PulsePart part(pulse, MapEnd, 1.0);
  for (const auto& [distance, point] : FindNotPlanar(input, farthest, pulse))
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

std::string PolylinesFromDrawing(const Drawing& drawing, const std::string& regionArray,
  PlanarInput& result, ProblemList& problems, Monitor& monitor)
{
  Pulse pulse(monitor);
  const std::string refusal = ReadCells(drawing, regionArray, result, pulse);
  if (!refusal.empty() || result.Chains.NumberOfChains() == 0)
  {
    return refusal;
  }
  const PulsePart part(pulse, PolylinesEnd, 1.0);
  result.Coordinates = CoordinatesOf(drawing.Points);
  ListUsedPoints(result, pulse);
  RefuseNotFinite(result, problems, pulse);
  if (problems.HasErrors() || pulse.HasStopped())
  {
    return {};
  }
  const double* places = result.Coordinates->GetPointer(0);
  const CoordinateRounding rounding =
    RoundingOfCoordinates(drawing.CoordinateType(), places, result.UsedPoints, pulse);
  result.Frame = PlaneFrame::FitTo(places, result.UsedPoints, rounding.Most, pulse);
  result.Chains.Rounding = InPlane(rounding, result.Frame);
  MapToPlane(result, pulse);
  const double diagonal = Diagonal(result, pulse);
  result.Chains.SeamNoise = SeamInUlp * std::numeric_limits<double>::epsilon() * diagonal;
  RefuseNotPlanar(result, std::max(PlanarTolerance * diagonal, rounding.Most), problems, pulse);
  return {};
}

} // namespace biting
