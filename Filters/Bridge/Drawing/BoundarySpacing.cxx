// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "BoundarySpacing.h"

#include "../../Kernel/Base/Pulse.h"
#include "../Source/SpacingValues.h"

#include "vtkDataArray.h"

namespace biting
{

namespace
{

void AddSegments(const Polylines& chains, Id chain, const std::vector<Id>& newIds,
  std::vector<Id>& segments, Pulse& pulse)
{
  const auto first = static_cast<std::size_t>(chains.Offsets[static_cast<std::size_t>(chain)]);
  const auto end = static_cast<std::size_t>(chains.Offsets[static_cast<std::size_t>(chain) + 1]);
  const bool isPoints =
    chains.Kinds[static_cast<std::size_t>(chain)] == ChainKind::EmbeddedPoint || end - first == 1;
  const std::size_t step = isPoints ? 0 : 1;
  for (std::size_t k = first; k + step < end && pulse.Beat(); ++k)
  {
    const Id start = newIds[static_cast<std::size_t>(chains.Connectivity[k])];
    if (start != NoId)
    {
      segments.push_back(start);
      segments.push_back(newIds[static_cast<std::size_t>(chains.Connectivity[k + step])]);
    }
  }
}

// The points that chains use, of blocks with the array; ascending.
std::vector<vtkIdType> PointsWith(
  vtkDataArray* values, const Drawing& drawing, const PlanarInput& input)
{
  const std::vector<unsigned char> isGiven =
    values->GetName() ? drawing.FindGiven(values->GetName()) : std::vector<unsigned char>();
  std::vector<vtkIdType> points;
  for (const Id point : input.UsedPoints)
  {
    if (isGiven.empty() || isGiven[static_cast<std::size_t>(point)])
    {
      points.push_back(point);
    }
  }
  return points;
}

} // namespace

std::string AddBoundarySpacing(const Drawing& drawing, const PlanarInput& input,
  vtkDataArray* values, SpacingOptions& options, ProblemPlaces& places, Monitor& monitor)
{
  Pulse pulse(monitor);
  const std::vector<vtkIdType> used = PointsWith(values, drawing, input);
  std::vector<double> read;
  const std::string refusal =
    ReadOwnValues(drawing.Points, values, used, LeastValue(options), read, places, pulse);
  if (!refusal.empty())
  {
    return refusal;
  }
  auto source = std::make_shared<SegmentSource>();
  std::vector<Id> newIds(input.IsUsed.size(), NoId);
  for (std::size_t k = 0; k < used.size() && pulse.Beat(); ++k)
  {
    const auto point = static_cast<std::size_t>(used[k]);
    newIds[point] = static_cast<Id>(k);
    source->Points.push_back(input.Chains.Points[point]);
    source->Values.push_back(read[point]);
  }
  for (Id chain = 0; chain < input.Chains.NumberOfChains() && pulse.Beat(); ++chain)
  {
    AddSegments(input.Chains, chain, newIds, source->Segments, pulse);
  }
  SortSource(*source, pulse);
  options.Segments = source;
  return {};
}

} // namespace biting
