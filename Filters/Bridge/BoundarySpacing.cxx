// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "BoundarySpacing.h"

#include "../Kernel/Base/Pulse.h"
#include "DoubleArray.h"
#include "SpacingValues.h"

#include "vtkPolyData.h"

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
    segments.push_back(newIds[static_cast<std::size_t>(chains.Connectivity[k])]);
    segments.push_back(newIds[static_cast<std::size_t>(chains.Connectivity[k + step])]);
  }
}

} // namespace

std::string AddBoundarySpacing(vtkPolyData* polyData, const PlanarInput& input,
  vtkDataArray* values, SpacingOptions& options, ProblemPlaces& places, Monitor& monitor)
{
  Pulse pulse(monitor);
  const std::vector<vtkIdType> used(input.UsedPoints.begin(), input.UsedPoints.end());
  const std::string refusal =
    CheckSpacingValues(polyData, values, used, SpacingOwner::Input, places, pulse);
  if (!refusal.empty())
  {
    return refusal;
  }
  const auto doubles = AsDoubles(values);
  auto source = std::make_shared<SegmentSource>();
  std::vector<Id> newIds(input.IsUsed.size(), NoId);
  for (std::size_t k = 0; k < input.UsedPoints.size() && pulse.Beat(); ++k)
  {
    const Id point = input.UsedPoints[k];
    newIds[static_cast<std::size_t>(point)] = static_cast<Id>(k);
    source->Points.push_back(input.Chains.Points[static_cast<std::size_t>(point)]);
    source->Values.push_back(doubles->GetValue(point));
  }
  for (Id chain = 0; chain < input.Chains.NumberOfChains() && pulse.Beat(); ++chain)
  {
    AddSegments(input.Chains, chain, newIds, source->Segments, pulse);
  }
  options.Segments = source;
  return {};
}

} // namespace biting
