// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SourceCheck.h"

#include "../Base/Numbers.h"
#include "../Base/Pulse.h"

#include <algorithm> // for is_sorted, all_of
#include <cassert>   // for our own mistakes
#include <locale>    // for numbers that look the same everywhere
#include <sstream>   // for details

namespace biting
{
namespace
{

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

/// Adds a problem for everything that it finds.
class Checker
{
public:
  Checker(ProblemList& problems, Monitor& monitor)
    : Problems(problems)
    , Beats(monitor)
  {
  }

  /// Whether all was checked, and nothing found.
  bool IsGood() const { return !this->HasFound && !this->Beats.HasStopped(); }

  void CheckParameters(const SpacingOptions& options)
  {
    const std::pair<const char*, double> parameters[] = { { "UniformSpacing", options.Uniform },
      { "SpacingScale", options.Scale }, { "MinimumSpacing", options.Minimum },
      { "MaximumSpacing", options.Maximum }, { "Gradation", options.Gradation } };
    for (const auto& [name, value] : parameters)
    {
      if (!std::isfinite(value) || value < 0.0)
      {
        this->Refuse(std::string(name) + " is " + NumberText(value));
      }
    }
    if (options.Scale == 0.0)
    {
      this->Refuse("SpacingScale is 0");
    }
    if (options.Maximum > 0.0 && options.Minimum > options.Maximum)
    {
      this->Refuse("MinimumSpacing " + NumberText(options.Minimum) + " is above MaximumSpacing " +
        NumberText(options.Maximum));
    }
  }

  void CheckGrid(const GridSource& grid, double scale)
  {
    const std::size_t columns = grid.XNodes.size();
    assert(grid.Values.size() == columns * grid.YNodes.size());
    this->CheckNodes("x", grid.XNodes);
    this->CheckNodes("y", grid.YNodes);
    this->CheckValues("grid source", grid.Values, scale, true,
      [&grid, columns](std::size_t id) {
        return Point2{ grid.XNodes[id % columns], grid.YNodes[id / columns] };
      });
  }

  void CheckTriangulation(const TriangulatedSource& source, double scale)
  {
    assert(source.Triangles.size() % 3 == 0);
    if (source.Triangles.empty() && !source.Points.empty())
    {
      this->Refuse("there are points but no triangles in the triangulated source");
      return;
    }
    this->CheckPoints("triangulated source", source, scale, true);
  }

  void CheckSegments(const std::string& name, const SegmentSource& source, double scale)
  {
    assert(source.Segments.size() % 2 == 0);
    this->CheckPoints(name, source, scale, false);
  }

private:
  void CheckNodes(const std::string& axis, const std::vector<double>& nodes)
  {
    const bool areFinite = std::all_of(
      nodes.begin(), nodes.end(), [](double coordinate) { return std::isfinite(coordinate); });
    if (!areFinite || !std::is_sorted(nodes.begin(), nodes.end()))
    {
      this->Refuse(axis + " nodes do not ascend in the grid source");
    }
  }

  template <typename Source>
  void CheckPoints(const std::string& name, const Source& source, double scale, bool mayBeHoles)
  {
    assert(source.Values.size() == source.Points.size());
    for (std::size_t id = 0; id < source.Points.size() && this->Beats.Beat(1); ++id)
    {
      if (!std::isfinite(source.Points[id].X) || !std::isfinite(source.Points[id].Y))
      {
        this->Add(id, source.Points[id], "position in the " + name);
      }
    }
    this->CheckValues(name, source.Values, scale, mayBeHoles,
      [&source](std::size_t id) { return source.Points[id]; });
  }

  /// `positionOf(id)` is where value id is given.
  template <typename PositionOf>
  void CheckValues(const std::string& name, const std::vector<double>& values, double scale,
    bool mayBeHoles, PositionOf positionOf)
  {
    bool areHoles = mayBeHoles && !values.empty();
    for (std::size_t id = 0; id < values.size() && this->Beats.Beat(1); ++id)
    {
      const double scaled = scale > 0.0 ? scale * values[id] : values[id];
      const bool isHole = mayBeHoles && std::isnan(scaled);
      areHoles = areHoles && isHole;
      if (!isHole && !(scaled > 0.0 && std::isfinite(scaled)))
      {
        this->Add(id, positionOf(id), "value " + NumberText(values[id]) + " in the " + name);
      }
    }
    if (areHoles && !this->Beats.HasStopped())
    {
      this->Refuse("every value is nan in the " + name);
    }
  }

  void Refuse(const std::string& detail)
  {
    this->Problems.Add({ ProblemCode::BadSpacing, {}, {}, detail });
    this->HasFound = true;
  }

  void Add(std::size_t id, const Point2& place, const std::string& detail)
  {
    this->Problems.Add(
      { ProblemCode::BadSpacing, { static_cast<std::int64_t>(id) }, place, detail });
    this->HasFound = true;
  }

  ProblemList& Problems;
  Pulse Beats;
  bool HasFound = false;
};

/// Of the values that are a spacing.
template <typename Source>
double LeastOf(const std::shared_ptr<const Source>& source)
{
  double least = Infinity;
  if (source)
  {
    for (const double value : source->Values)
    {
      least = value > 0.0 && value < least ? value : least;
    }
  }
  return least;
}

} // namespace

double LeastGiven(const SpacingOptions& options)
{
  const double uniform = options.Uniform > 0.0 ? options.Uniform : Infinity;
  return std::min(
    { uniform, LeastOf(options.Grid), LeastOf(options.Triangulation), LeastOf(options.Segments) });
}

bool CheckSpacing(const SpacingOptions& options, ProblemList& problems, Monitor& monitor)
{
  Checker checker(problems, monitor);
  checker.CheckParameters(options);
  if (options.Grid)
  {
    checker.CheckGrid(*options.Grid, options.Scale);
  }
  if (options.Triangulation)
  {
    checker.CheckTriangulation(*options.Triangulation, options.Scale);
  }
  if (options.Segments)
  {
    checker.CheckSegments("segment source", *options.Segments, options.Scale);
  }
  if (options.Floor)
  {
    checker.CheckSegments("floor of the spacing", *options.Floor, 1.0);
  }
  return checker.IsGood();
}

} // namespace biting
