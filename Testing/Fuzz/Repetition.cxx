// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Repetition.h"

#include <algorithm> // for all_of, transform
#include <cmath>     // for abs, isnan, ldexp
#include <cstring>   // for memcmp
#include <memory>    // for sources
#include <vector>    // for numbers

namespace biting
{

namespace
{

constexpr int Magnification = 5; // as a power of two
constexpr int ThreadsOfRepetition = 3;

double Magnified(double length)
{
  return std::ldexp(length, Magnification);
}

void Magnify(std::vector<double>& lengths)
{
  std::transform(lengths.begin(), lengths.end(), lengths.begin(), Magnified);
}

void Magnify(std::vector<Point2>& points)
{
  for (Point2& point : points)
  {
    point = { Magnified(point.X), Magnified(point.Y) };
  }
}

void MagnifyPlaces(GridSource& grid)
{
  Magnify(grid.XNodes);
  Magnify(grid.YNodes);
}

template <typename Source>
void MagnifyPlaces(Source& source)
{
  Magnify(source.Points);
}

FuzzCase Magnify(FuzzCase fuzzCase)
{
  SpacingOptions& spacing = fuzzCase.Options.Spacing;
  Magnify(fuzzCase.Input.Points);
  fuzzCase.Input.SeamNoise = Magnified(fuzzCase.Input.SeamNoise);
  spacing.Uniform = Magnified(spacing.Uniform);
  spacing.Minimum = Magnified(spacing.Minimum);
  spacing.Maximum = Magnified(spacing.Maximum);
  const auto magnified = [](const auto& source) -> GivenSource
  {
    auto copy = std::make_shared<std::decay_t<decltype(*source)>>(*source);
    MagnifyPlaces(*copy);
    Magnify(copy->Values);
    return copy;
  };
  for (GivenSource& source : spacing.Sources)
  {
    source = std::visit(magnified, source);
  }
  return fuzzCase;
}

/// Far from where numbers overflow, underflow or are taken for zero.
bool IsOrdinary(double x)
{
  return x == 0.0 || (std::abs(x) > 1e-40 && std::abs(x) < 1e40);
}

bool IsOrdinary(const std::vector<double>& numbers)
{
  return std::all_of(
    numbers.begin(), numbers.end(), [](double x) { return std::isnan(x) || IsOrdinary(x); });
}

bool IsOrdinary(const std::vector<Point2>& points)
{
  return std::all_of(points.begin(), points.end(),
    [](const Point2& p) { return IsOrdinary(p.X) && IsOrdinary(p.Y); });
}

bool HasOrdinaryPlaces(const GridSource&)
{
  return true;
}

template <typename Source>
bool HasOrdinaryPlaces(const Source& source)
{
  return IsOrdinary(source.Points);
}

bool IsOrdinary(const GivenSource& source)
{
  return std::visit([](const auto& given)
    { return IsOrdinary(given->Values) && HasOrdinaryPlaces(*given); },
    source);
}

bool IsOrdinary(const FuzzCase& fuzzCase)
{
  const SpacingOptions& spacing = fuzzCase.Options.Spacing;
  return IsOrdinary(fuzzCase.Input.Points) && IsOrdinary(spacing.Uniform) &&
    IsOrdinary(spacing.Minimum) && IsOrdinary(spacing.Maximum) && IsOrdinary(spacing.Scale) &&
    IsOrdinary(spacing.Gradation) &&
    std::all_of(spacing.Sources.begin(), spacing.Sources.end(),
      [](const GivenSource& source) { return IsOrdinary(source); });
}

template <typename Value>
bool IsSame(const std::vector<Value>& a, const std::vector<Value>& b)
{
  return a.size() == b.size() &&
    (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(Value)) == 0);
}

bool IsSame(const BitingMesh& a, const BitingMesh& b)
{
  return IsSame(a.Points, b.Points) && IsSame(a.Spacing, b.Spacing) &&
    IsSame(a.Corners, b.Corners) && IsSame(a.Neighbors, b.Neighbors) && IsSame(a.Kinds, b.Kinds) &&
    IsSame(a.Regions, b.Regions) && IsSame(a.BiteOrders, b.BiteOrders) &&
    IsSame(a.EdgeStarts, b.EdgeStarts) && IsSame(a.EdgeCells, b.EdgeCells) &&
    IsSame(a.Front, b.Front) && IsSame(a.Quality.AspectRatio, b.Quality.AspectRatio) &&
    IsSame(a.Bites.Centers, b.Bites.Centers);
}

} // namespace

std::string JudgeRepetition(const FuzzRun& run, const FuzzCase& fuzzCase)
{
  if (!IsSame(run.Mesh, Run(fuzzCase, ThreadsOfRepetition).Mesh))
  {
    return "the same input gives another mesh";
  }
  if (IsOrdinary(fuzzCase))
  {
    std::vector<Point2> points = run.Mesh.Points;
    Magnify(points);
    const FuzzRun magnified = Run(Magnify(fuzzCase));
    if (!IsSame(points, magnified.Mesh.Points) || !IsSame(run.Mesh.Corners, magnified.Mesh.Corners))
    {
      return "a larger unit of length gives another mesh";
    }
  }
  return "";
}

} // namespace biting
