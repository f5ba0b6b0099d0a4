// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingMeshShapes_h
#define BitingMeshShapes_h

#include "PolylineShapes.h"
#include "Spacing/Spacing.h"

#include <cmath>  // for powers and angles
#include <memory> // for sources
#include <vector> // for places

namespace biting
{

constexpr double DegreesPerTurn = 360.0;

inline Point2 UnitVector(double degrees)
{
  const double turn = 2.0 * 3.14159265358979323846 * degrees / DegreesPerTurn;
  return { std::cos(turn), std::sin(turn) };
}

/// `corners` places on a circle, counterclockwise, the first at `degrees`.
inline std::vector<Point2> RegularPolygon(
  const Point2& center, double radius, int corners, double degrees = 0.0)
{
  std::vector<Point2> places;
  for (int k = 0; k < corners; ++k)
  {
    places.push_back(center + radius * UnitVector(degrees + DegreesPerTurn * k / corners));
  }
  return places;
}

/// The loop through `corners` with side k divided into parts[k] equal parts.
inline std::vector<Point2> DividedLoop(
  const std::vector<Point2>& corners, const std::vector<int>& parts)
{
  std::vector<Point2> places;
  for (std::size_t side = 0; side < corners.size(); ++side)
  {
    const Point2 span = corners[(side + 1) % corners.size()] - corners[side];
    for (int k = 0; k < parts[side]; ++k)
    {
      places.push_back(corners[side] + static_cast<double>(k) / parts[side] * span);
    }
  }
  return places;
}

/// The square [0, size]^2 without its upper right quarter.
inline std::vector<Point2> EllShape(double size)
{
  const double half = 0.5 * size;
  return { { 0.0, 0.0 }, { size, 0.0 }, { size, half }, { half, half }, { half, size },
    { 0.0, size } };
}

/// A comb of `teeth` upright teeth of width `width` with gaps of the same width, on a back.
inline std::vector<Point2> Comb(int teeth, double width)
{
  std::vector<Point2> places{ { 0.0, 0.0 }, { (2 * teeth - 1) * width, 0.0 } };
  for (int tooth = teeth; tooth-- > 0;)
  {
    const double left = 2 * tooth * width;
    places.push_back({ left + width, 1.0 });
    places.push_back({ left, 1.0 });
    if (tooth > 0)
    {
      places.push_back({ left, 0.5 });
      places.push_back({ left - width, 0.5 });
    }
  }
  return places;
}

inline SpacingOptions UniformSpacing(double length)
{
  SpacingOptions options;
  options.Uniform = length;
  options.Gradation = 0.0;
  return options;
}

/// Prepared for the unit square and a side of it around.
inline Spacing SpacingAroundUnitSquare(const SpacingOptions& options)
{
  ProblemList problems;
  return MakeSpacing(options, { { -1.0, -1.0 }, { 2.0, 2.0 } }, problems, NoMonitor());
}

/// low + slope y for y in [0, height].
inline SpacingOptions LinearSpacing(double low, double slope, double height)
{
  auto grid = std::make_shared<GridSource>();
  grid->XNodes = { 0.0 };
  grid->YNodes = { 0.0, height };
  grid->Values = { low, low + slope * height };
  SpacingOptions options;
  options.Gradation = 0.0;
  options.Sources.emplace_back(grid);
  return options;
}

/// Grows from `least` at `center` by `growth` a length.
inline SpacingOptions RadialSpacing(const Point2& center, double least, double growth)
{
  auto source = std::make_shared<SegmentSource>();
  source->Points = { center };
  source->Values = { least };
  source->Segments = { 0, 0 };
  SpacingOptions options;
  options.Gradation = growth;
  options.Sources.emplace_back(source);
  return options;
}

/// The spacing of the paper's section 6 over the square [0, 9]^2.
inline double SectionSixValue(double y)
{
  if (y <= 2.0)
  {
    return 1.0 - 0.95 * y / 2.0;
  }
  if (y <= 4.5)
  {
    return 0.05 * std::pow(20.0, (y - 2.0) / 2.5);
  }
  return y <= 7.0 ? std::pow(0.2, (y - 4.5) / 2.5) : 0.2 + 0.8 * std::pow(0.5 * (y - 7.0), 4.0);
}

/// Section 6 as linear pieces of length 0.025.
inline SpacingOptions SectionSixSpacing()
{
  constexpr int Steps = 360;
  auto grid = std::make_shared<GridSource>();
  grid->XNodes = { 0.0 };
  for (int step = 0; step <= Steps; ++step)
  {
    grid->YNodes.push_back(9.0 * step / Steps);
    grid->Values.push_back(SectionSixValue(grid->YNodes.back()));
  }
  SpacingOptions options;
  options.Gradation = 0.0;
  options.Sources.emplace_back(grid);
  return options;
}

} // namespace biting

#endif
