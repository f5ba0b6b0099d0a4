// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "GlobeSource.h"

#include "../Drawing/Globe.h"
#include "SpacingValues.h"

#include <algorithm> // for clamp, max
#include <array>     // for corners
#include <cmath>     // for ceil, remainder

namespace biting
{

namespace
{

constexpr double WidestCell = 2.0;    // degrees
constexpr double LeastLevel = -0.996; // about the cosine of 175 degrees

// In degrees: each cell two triangles.
TriangulatedSource TrianglesOf(const GridSource& grid)
{
  TriangulatedSource source;
  source.Values = grid.Values;
  source.Points.reserve(grid.Values.size());
  source.Triangles.reserve(6 * grid.Values.size());
  for (const double y : grid.YNodes)
  {
    for (const double x : grid.XNodes)
    {
      source.Points.push_back({ x, y });
    }
  }
  const auto width = static_cast<Id>(grid.XNodes.size());
  for (Id row = 1; row < static_cast<Id>(grid.YNodes.size()); ++row)
  {
    for (Id k = row * width + 1; k < (row + 1) * width; ++k)
    {
      const Id below = k - width;
      source.Triangles.insert(source.Triangles.end(), { below - 1, below, k, below - 1, k, k - 1 });
    }
  }
  return source;
}

// Takes triangles in degrees to the plane.
class GlobeMapper
{
public:
  GlobeMapper(const PlaneFrame& frame, bool isTurned, const TriangulatedSource& degrees)
    : Frame(frame)
    , IsTurned(isTurned)
    , Degrees(degrees)
    , Mapped(std::make_shared<TriangulatedSource>())
  {
    for (std::size_t point = 0; point < degrees.Points.size(); ++point)
    {
      this->AddPoint(degrees.Points[point], degrees.Values[point]);
    }
  }

  void AddTriangle(const Id* corners);
  std::shared_ptr<TriangulatedSource> Take() { return std::move(this->Mapped); }

private:
  void AddPoint(const Point2& degrees, double value);
  void Divide(const std::array<Point2, 3>& places, const std::array<double, 3>& values, Id parts);
  void Add(Id a, Id b, Id c);

  const PlaneFrame& Frame;
  const bool IsTurned;
  const TriangulatedSource& Degrees;
  std::shared_ptr<TriangulatedSource> Mapped;
  std::vector<std::uint8_t> IsFar; ///< one a point
};

void GlobeMapper::AddPoint(const Point2& degrees, double value)
{
  const Point3 place{ degrees.X, std::clamp(degrees.Y, -90.0, 90.0), 0.0 };
  this->IsFar.push_back(!(this->Frame.LevelOf(place.Data()) > LeastLevel));
  this->Mapped->Points.push_back(this->IsFar.back() ? Point2() : this->Frame.ToPlane(place.Data()));
  this->Mapped->Values.push_back(value);
}

void GlobeMapper::AddTriangle(const Id* corners)
{
  std::array<Point2, 3> places;
  std::array<double, 3> values{};
  double width = 0.0;
  for (std::size_t k = 0; k < 3; ++k)
  {
    places[k] = this->Degrees.Points[static_cast<std::size_t>(corners[k])];
    values[k] = this->Degrees.Values[static_cast<std::size_t>(corners[k])];
    const double across = places[k].X - places[0].X;
    places[k].X = this->IsTurned && std::abs(across) > 180.0
      ? places[0].X + std::remainder(across, 360.0)
      : places[k].X;
  }
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Point2 side = places[k] - places[(k + 1) % 3];
    width = std::max({ width, std::abs(side.X), std::abs(side.Y) });
  }
  constexpr double MostParts = 1024.0;
  const auto parts = static_cast<Id>(std::min(std::ceil(width / WidestCell), MostParts));
  if (parts <= 1)
  {
    this->Add(corners[0], corners[1], corners[2]);
  }
  else
  {
    this->Divide(places, values, parts);
  }
}

// Row i of points has those with a share of i / parts of corner 0, from corner 1 to corner 2.
void GlobeMapper::Divide(
  const std::array<Point2, 3>& places, const std::array<double, 3>& values, Id parts)
{
  Id previous = 0;
  for (Id row = 0; row <= parts; ++row)
  {
    const Id first = static_cast<Id>(this->Mapped->Points.size());
    for (Id k = 0; k <= parts - row; ++k)
    {
      const double a = static_cast<double>(row) / parts;
      const double c = static_cast<double>(k) / parts;
      const double b = static_cast<double>(parts - row - k) / parts;
      this->AddPoint(a * places[0] + (b * places[1] + c * places[2]),
        a * values[0] + (b * values[1] + c * values[2]));
    }
    for (Id k = 0; row > 0 && k <= parts - row; ++k)
    {
      this->Add(previous + k, previous + k + 1, first + k);
      if (k < parts - row)
      {
        this->Add(previous + k + 1, first + k + 1, first + k);
      }
    }
    previous = first;
  }
}

void GlobeMapper::Add(Id a, Id b, Id c)
{
  const auto isFar = [this](Id point) { return this->IsFar[static_cast<std::size_t>(point)] != 0; };
  if (!isFar(a) && !isFar(b) && !isFar(c))
  {
    this->Mapped->Triangles.insert(this->Mapped->Triangles.end(), { a, b, c });
  }
}

} // namespace

void SourceOnGlobe(const PlaneFrame& frame, SpacingOptions& options, Pulse& pulse)
{
  if (!options.Grid && !options.Triangulation)
  {
    return;
  }
  const TriangulatedSource degrees =
    options.Grid ? TrianglesOf(*options.Grid) : *options.Triangulation;
  GlobeMapper mapper(frame, !options.Grid, degrees);
  for (std::size_t k = 0; k < degrees.Triangles.size() && pulse.Beat(); k += 3)
  {
    mapper.AddTriangle(&degrees.Triangles[k]);
  }
  const auto mapped = mapper.Take();
  SortSource(*mapped, pulse);
  mapped->MayOverlap = true;
  options.Triangulation = mapped;
  options.Grid = nullptr;
}

} // namespace biting
