// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "GivenSources.h"

#include "../Base/Numbers.h"

#include <algorithm> // for min
#include <cmath>     // for isnan
#include <vector>    // for values

namespace biting
{

namespace
{

/// The one value that all have, holes apart; infinite where they differ or there is none.
double OnlyValue(const std::vector<double>& values)
{
  double only = Infinity;
  for (double value : values)
  {
    if (only == Infinity && !std::isnan(value))
    {
      only = value;
    }
    if (value < only || value > only)
    {
      return Infinity;
    }
  }
  return only;
}

bool HasValues(const std::shared_ptr<const GridSource>& source)
{
  return source && !source->Values.empty();
}

bool HasTriangles(const std::shared_ptr<const TriangulatedSource>& source)
{
  return source && !source->Triangles.empty();
}

} // namespace

bool HasSegments(const std::shared_ptr<const SegmentSource>& source)
{
  return source && !source->Segments.empty();
}

bool HasGrid(const SpacingOptions& options)
{
  return HasValues(options.Grid) && OnlyValue(options.Grid->Values) == Infinity;
}

bool HasTriangulation(const SpacingOptions& options)
{
  return HasTriangles(options.Triangulation) &&
    OnlyValue(options.Triangulation->Values) == Infinity;
}

bool HasExtension(const SpacingOptions& options)
{
  return HasSegments(options.Segments) &&
    (options.Gradation > 0.0 || OnlyValue(options.Segments->Values) == Infinity);
}

double UniformOf(const SpacingOptions& options)
{
  double uniform = options.Uniform > 0.0 ? options.Uniform : Infinity;
  if (HasValues(options.Grid))
  {
    uniform = std::min(uniform, OnlyValue(options.Grid->Values));
  }
  if (HasTriangles(options.Triangulation))
  {
    uniform = std::min(uniform, OnlyValue(options.Triangulation->Values));
  }
  if (HasSegments(options.Segments) && !HasExtension(options))
  {
    uniform = std::min(uniform, OnlyValue(options.Segments->Values));
  }
  return uniform;
}

} // namespace biting
