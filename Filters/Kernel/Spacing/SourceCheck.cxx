// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SourceCheck.h"

#include "../Base/Pulse.h"

#include <algorithm> // for is_sorted, all_of
#include <cassert>   // for our own mistakes
#include <locale>    // for numbers that look the same everywhere
#include <sstream>   // for details

namespace biting
{
namespace
{

enum class HolePolicy
{
  Allowed,
  Refused
};

std::string NumberText(double value)
{
  if (std::isnan(value))
  {
    return "nan";
  }
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(12);
  text << value;
  return text.str();
}

void Refuse(ProblemList& problems, const std::string& detail)
{
  problems.Add({ ProblemCode::BadSpacing, {}, {}, detail });
}

bool CheckParameter(const char* name, double value, ProblemList& problems)
{
  if (std::isfinite(value) && value >= 0.0)
  {
    return true;
  }
  Refuse(problems, std::string(name) + " is " + NumberText(value));
  return false;
}

bool CheckParameters(const SpacingOptions& options, ProblemList& problems)
{
  bool valid = CheckParameter("UniformSpacing", options.Uniform, problems);
  valid = CheckParameter("SpacingScale", options.Scale, problems) && valid;
  valid = CheckParameter("MinimumSpacing", options.Minimum, problems) && valid;
  valid = CheckParameter("MaximumSpacing", options.Maximum, problems) && valid;
  valid = CheckParameter("Gradation", options.Gradation, problems) && valid;
  if (options.Scale == 0.0)
  {
    Refuse(problems, "SpacingScale is 0");
    valid = false;
  }
  if (options.Maximum > 0.0 && options.Minimum > options.Maximum)
  {
    Refuse(problems,
      "MinimumSpacing " + NumberText(options.Minimum) + " is above MaximumSpacing " +
        NumberText(options.Maximum));
    valid = false;
  }
  return valid;
}

bool AreFinite(const std::vector<double>& coordinates)
{
  return std::all_of(coordinates.begin(), coordinates.end(),
    [](double coordinate) { return std::isfinite(coordinate); });
}

/// Checks the values and positions of one source; `positionOf(id)` is where value id is given.
/// Where all positions are known to be finite, only those of bad values are asked for.
class ValueCheck
{
public:
  ValueCheck(
    const char* sourceName, double scale, HolePolicy holes, ProblemList& problems, Pulse& pulse)
    : SourceName(sourceName)
    , Scale(scale)
    , Holes(holes)
    , Problems(problems)
    , Beats(pulse)
  {
  }

  template <typename PositionOf>
  bool operator()(
    const std::vector<double>& values, PositionOf positionOf, bool hasFinitePositions = false)
  {
    bool valid = true;
    for (std::size_t id = 0; id < values.size() && this->Beats.Beat(1); ++id)
    {
      if (hasFinitePositions && this->IsSpacing(values[id]))
      {
        continue;
      }
      const Point2 place = positionOf(id);
      if (!std::isfinite(place.X) || !std::isfinite(place.Y))
      {
        this->Add(id, place, "position");
        valid = false;
      }
      else if (!this->IsSpacing(values[id]))
      {
        this->Add(id, place, "value " + NumberText(values[id]));
        valid = false;
      }
    }
    return valid && !this->Beats.HasStopped() && this->CheckNotAllHoles(values);
  }

private:
  bool IsSpacing(double value) const
  {
    if (std::isnan(value))
    {
      return this->Holes == HolePolicy::Allowed;
    }
    const double scaled = this->Scale > 0.0 ? this->Scale * value : value;
    return scaled > 0.0 && std::isfinite(scaled);
  }

  bool CheckNotAllHoles(const std::vector<double>& values)
  {
    const bool onlyHoles = !values.empty() &&
      std::all_of(values.begin(), values.end(), [](double value) { return std::isnan(value); });
    if (onlyHoles)
    {
      Refuse(this->Problems, "every value is nan in the " + this->SourceName);
    }
    return !onlyHoles;
  }

  void Add(std::size_t id, const Point2& place, const std::string& what)
  {
    this->Problems.Add({ ProblemCode::BadSpacing, { static_cast<std::int64_t>(id) }, place,
      what + " in the " + this->SourceName });
  }

  std::string SourceName;
  double Scale;
  HolePolicy Holes;
  ProblemList& Problems;
  Pulse& Beats;
};

bool CheckNodes(const char* axis, const std::vector<double>& nodes, ProblemList& problems)
{
  if (std::is_sorted(nodes.begin(), nodes.end()))
  {
    return true;
  }
  Refuse(problems, std::string(axis) + " nodes do not ascend in the grid source");
  return false;
}

bool CheckGrid(const GridSource& grid, double scale, ProblemList& problems, Pulse& pulse)
{
  const std::size_t columns = grid.XNodes.size();
  assert(grid.Values.size() == columns * grid.YNodes.size());
  ValueCheck check("grid source", scale, HolePolicy::Allowed, problems, pulse);
  const bool valid = check(
    grid.Values,
    [&grid, columns](std::size_t id) {
      return Point2{ grid.XNodes[id % columns], grid.YNodes[id / columns] };
    },
    AreFinite(grid.XNodes) && AreFinite(grid.YNodes));
  return valid && CheckNodes("x", grid.XNodes, problems) && CheckNodes("y", grid.YNodes, problems);
}

bool CheckTriangulation(
  const TriangulatedSource& source, double scale, ProblemList& problems, Pulse& pulse)
{
  assert(source.Values.size() == source.Points.size() && source.Triangles.size() % 3 == 0);
  if (source.Triangles.empty() && !source.Points.empty())
  {
    Refuse(problems, "there are points but no triangles in the triangulated source");
    return false;
  }
  ValueCheck check("triangulated source", scale, HolePolicy::Allowed, problems, pulse);
  return check(source.Values, [&source](std::size_t id) { return source.Points[id]; });
}

bool CheckSegments(
  const char* name, const SegmentSource& source, double scale, ProblemList& problems, Pulse& pulse)
{
  assert(source.Values.size() == source.Points.size() && source.Segments.size() % 2 == 0);
  ValueCheck check(name, scale, HolePolicy::Refused, problems, pulse);
  return check(source.Values, [&source](std::size_t id) { return source.Points[id]; });
}

} // namespace

bool CheckSpacing(const SpacingOptions& options, ProblemList& problems, Monitor& monitor)
{
  Pulse pulse(monitor);
  bool valid = CheckParameters(options, problems);
  if (options.Grid)
  {
    valid = CheckGrid(*options.Grid, options.Scale, problems, pulse) && valid;
  }
  if (options.Triangulation)
  {
    valid = CheckTriangulation(*options.Triangulation, options.Scale, problems, pulse) && valid;
  }
  if (options.Segments)
  {
    valid =
      CheckSegments("segment source", *options.Segments, options.Scale, problems, pulse) && valid;
  }
  if (options.Floor)
  {
    valid = CheckSegments("floor of the spacing", *options.Floor, 1.0, problems, pulse) && valid;
  }
  return valid;
}

} // namespace biting
