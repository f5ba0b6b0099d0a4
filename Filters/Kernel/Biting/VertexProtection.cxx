// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "VertexProtection.h"

#include "Orientation.h"

#include <cstddef> // for sizes
#include <numeric> // for iota

namespace biting
{

namespace
{

// For circles: one bite a vertex.
VertexAxes WithoutAxes(Id numberOfVertices)
{
  VertexAxes none;
  none.Axes.resize(numberOfVertices);
  none.Offsets.resize(static_cast<std::size_t>(numberOfVertices) + 1);
  std::iota(none.Offsets.begin(), none.Offsets.end(), 0);
  return none;
}

} // namespace

void AddDomainVertices(BitingState& state)
{
  state.Reserve();
  for (const Point2& vertex : state.Geometry.Vertices)
  {
    state.AddVertex(vertex, state.F(vertex), NoId);
    state.Step();
  }
}

void ProtectVertices(BitingState& state)
{
  state.Axes = state.Options.Shape == BiteShape::Circle
    ? WithoutAxes(state.Geometry.NumberOfVertices())
    : OrientVertexBites(state.Geometry, state.Progress);
  for (Id vertex = 0; vertex < state.Geometry.NumberOfVertices() && state.MayBite(); ++vertex)
  {
    for (Id k = state.Axes.Offsets[vertex]; k < state.Axes.Offsets[vertex + 1]; ++k)
    {
      state.Bite(vertex, state.Axes.Axes[k], 1.0, BitePhase::VertexProtection);
    }
    state.FinishBite();
  }
}

} // namespace biting
