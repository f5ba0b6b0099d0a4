// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Source.h"

#include "../Base/Numbers.h"
#include "../Base/Pulse.h"
#include "Spacing.h"

#include <algorithm> // for all_of, is_sorted, min
#include <cassert>   // for our own mistakes
#include <locale>    // for numbers that look the same everywhere
#include <sstream>   // for details
#include <utility>   // for swap

namespace biting
{

namespace
{

/// Where values between two nodes, which are linear, reach a value.
CellNode Between(const CellNode& low, const CellNode& high, double value)
{
  const double share = (value - low.Scaled) / (high.Scaled - low.Scaled);
  return { low.At + share * (high.At - low.At), value, value };
}

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
    const std::pair<const char*, double> parameters[] = { { "Uniform Spacing", options.Uniform },
      { "Spacing Scale", options.Scale }, { "Minimum Spacing", options.Minimum },
      { "Maximum Spacing", options.Maximum }, { "Gradation", options.Gradation } };
    for (const auto& [name, value] : parameters)
    {
      this->Require(std::isfinite(value) && value >= 0.0, name + (" is " + NumberText(value)));
    }
    this->Require(options.Scale != 0.0, "Spacing Scale is 0");
    this->Require(!(options.Maximum > 0.0 && options.Minimum > options.Maximum),
      "Minimum Spacing " + NumberText(options.Minimum) + " is above Maximum Spacing " +
        NumberText(options.Maximum));
  }

  void Check(const GridSource& grid, double scale)
  {
    const std::size_t columns = grid.XNodes.size();
    assert(grid.Values.size() == columns * grid.YNodes.size());
    for (const auto* nodes : { &grid.XNodes, &grid.YNodes })
    {
      this->Require(std::is_sorted(nodes->begin(), nodes->end()) &&
          std::all_of(
            nodes->begin(), nodes->end(), [](double node) { return std::isfinite(node); }),
        (nodes == &grid.XNodes ? "x" : "y") +
          std::string(" nodes do not ascend in the grid source"));
    }
    this->CheckValues("grid source", grid.Values, scale, true,
      [&grid, columns](std::size_t id) {
        return Point2{ grid.XNodes[id % columns], grid.YNodes[id / columns] };
      });
  }

  void Check(const TriangulatedSource& source, double scale)
  {
    this->Require(!source.Triangles.empty() || source.Points.empty(),
      "there are points but no triangles in the triangulated source");
    this->CheckPoints("triangulated source", source, scale, true);
  }

  void Check(const SegmentSource& source, double scale, const char* name = "segment source")
  {
    this->CheckPoints(name, source, scale, false);
  }

private:
  template <typename Source>
  void CheckPoints(const std::string& name, const Source& source, double scale, bool mayBeHoles)
  {
    assert(source.Values.size() == source.Points.size());
    for (std::size_t id = 0; id < source.Points.size() && this->Beats.Beat(1); ++id)
    {
      const Point2& place = source.Points[id];
      if (!std::isfinite(place.X) || !std::isfinite(place.Y))
      {
        this->Add("position in the " + name, { static_cast<std::int64_t>(id) }, place);
      }
    }
    this->CheckValues(name, source.Values, scale, mayBeHoles,
      [&source](std::size_t id) { return source.Points[id]; });
  }

  void Require(bool isRight, const std::string& otherwise)
  {
    if (!isRight)
    {
      this->Add(otherwise, {}, {});
    }
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
        this->Add("value " + NumberText(values[id]) + " in the " + name,
          { static_cast<std::int64_t>(id) }, positionOf(id));
      }
    }
    this->Require(!areHoles || this->Beats.HasStopped(), "every value is nan in the " + name);
  }

  void Add(const std::string& detail, const std::vector<std::int64_t>& ids, const Point2& place)
  {
    this->Problems.Add({ ProblemCode::BadSpacing, ids, place, detail });
    this->HasFound = true;
  }

  ProblemList& Problems;
  Pulse Beats;
  bool HasFound = false;
};

} // namespace

double DistanceOfPoints(double length, double slope)
{
  constexpr double UsualSlope = 0.3;
  return length * std::min(1.0, UsualSlope / std::min(slope, 1.0));
}

void AddLowEdge(CellNode low, CellNode high, const SteepRule& rule, SegmentSource& edges)
{
  constexpr double LengthOfPoint = 0.25;
  if (high.Scaled < low.Scaled)
  {
    std::swap(low, high);
  }
  if (low.Scaled < rule.Range.Most && high.Scaled > rule.Range.Most)
  {
    high = Between(low, high, rule.Range.Most);
  }
  if (low.Scaled < rule.Range.Least && high.Scaled > rule.Range.Least)
  {
    const CellNode least = Between(low, high, rule.Range.Least);
    edges.Add(low.At, least.At, least.Value, least.Value);
    low = least;
  }
  const double length = Distance(low.At, high.At);
  if (high.Value - low.Value <= rule.Slope * length &&
    length > DistanceOfPoints(LengthOfPoint, rule.Slope) * low.Value)
  {
    edges.Add(low.At, high.At, low.Value, high.Value);
  }
}

void AddLevelLine(const std::vector<CellNode>& nodes, const ValueRange& range, SegmentSource& edges)
{
  std::vector<Point2> crossings;
  for (std::size_t k = 0; k < nodes.size(); ++k)
  {
    const CellNode& next = nodes[(k + 1) % nodes.size()];
    if ((nodes[k].Scaled < range.Least) != (next.Scaled < range.Least))
    {
      crossings.push_back(Between(nodes[k], next, range.Least).At);
    }
  }
  for (std::size_t k = 0; k < crossings.size(); k += 2)
  {
    edges.Add(crossings[k], crossings[k + 1], range.Least, range.Least);
  }
}

double LeastGiven(const SpacingOptions& options)
{
  double least = options.Uniform > 0.0 ? options.Uniform : Infinity;
  const auto lower = [&least](const auto& source)
  {
    for (const double value : source->Values)
    {
      least = value > 0.0 && value < least ? value : least;
    }
  };
  for (const GivenSource& source : options.Sources)
  {
    std::visit(lower, source);
  }
  return least;
}

bool CheckSpacing(const SpacingOptions& options, ProblemList& problems, Monitor& monitor)
{
  Checker checker(problems, monitor);
  checker.CheckParameters(options);
  const auto check = [&checker, &options](const auto& source)
  { checker.Check(*source, options.Scale); };
  for (const GivenSource& source : options.Sources)
  {
    std::visit(check, source);
  }
  if (options.Floor)
  {
    checker.Check(*options.Floor, 1.0, "floor of the spacing");
  }
  return checker.IsGood();
}

} // namespace biting
