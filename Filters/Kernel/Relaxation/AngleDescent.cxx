// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "AngleDescent.h"

#include "Star.h"
#include "StarObjective.h"

#include <algorithm> // for sort, unique, remove_if
#include <cstddef>   // for counts
#include <iterator>  // for size

namespace biting
{

namespace
{

constexpr int Rounds = 2;
constexpr double FirstStep = 0.12; // spacings
constexpr double LastStep = 0.008;
constexpr int MostSteps = 40;
constexpr double GoodPerPoor = 0.84; // cotangents: of 45 degrees to that of 40
constexpr double GreatestShareOfPoor = 0.05;
constexpr std::size_t FewTriangles = 500; // so many may be poor in any mesh
constexpr double PoorCotangents[] = { CotangentOf40Degrees, CotangentOf35Degrees,
  CotangentOf30Degrees, CotangentOf25Degrees };
constexpr std::size_t NumberOfLevels = std::size(PoorCotangents);

constexpr double Diagonal = 0.7071067811865476;
constexpr Point2 Directions[] = { { 1.0, 0.0 }, { Diagonal, Diagonal }, { 0.0, 1.0 },
  { -Diagonal, Diagonal }, { -1.0, 0.0 }, { -Diagonal, -Diagonal }, { 0.0, -1.0 },
  { Diagonal, -Diagonal } };

/// The best place that the search finds, and the objective there.
struct Place
{
  Point2 Shift;
  double Value;
};

/// Goes one step in the best of all directions; stays where none is better.
Place StepFree(const StarObjective& objective, const Place& from, double length)
{
  Place best = from;
  for (const Point2& direction : Directions)
  {
    const Point2 shift = from.Shift + length * direction;
    const double value = objective.At(shift, best.Value);
    best = value < best.Value ? Place{ shift, value } : best;
  }
  return best;
}

/// The same along the segment of a vertex that slides.
Place StepAlong(const MutableMesh& mesh, Id segment, const Star& star,
  const StarObjective& objective, const Place& from, double length)
{
  const Point2 along = length * mesh.DirectionOf(segment);
  Place best = from;
  for (const Point2& step : { along, -1.0 * along })
  {
    const Point2 place = mesh.PlaceOnSegment(segment, star.Center + from.Shift + step);
    const Point2 shift = place - star.Center;
    const double value = objective.At(shift, best.Value);
    best = value < best.Value ? Place{ shift, value } : best;
  }
  return best;
}

/// Steps of half the length each time that none is better.
Place Descend(const MutableMesh& mesh, Id vertex, const Star& star, const StarObjective& objective)
{
  const bool isFree = mesh.Freedoms[vertex] == Freedom::Free;
  Place best{ {}, objective.Here() };
  double length = FirstStep * mesh.Spacings[vertex];
  const double lastLength = LastStep * mesh.Spacings[vertex];
  for (int step = 0; step < MostSteps && length >= lastLength; ++step)
  {
    const Place next = isFree
      ? StepFree(objective, best, length)
      : StepAlong(mesh, mesh.Segments[vertex], star, objective, best, length);
    length = next.Value < best.Value ? length : 0.5 * length;
    best = next;
  }
  return best;
}

} // namespace

void AngleDescent::Run(Pulse& pulse)
{
  this->IsSettled.assign(this->Mesh.Points.size(), 0);
  this->LookAtAll(pulse);
  this->ChooseLimits();
  const double good = GoodPerPoor * this->Mesh.PoorCotangents * PoorCotangents[this->PoorLevel - 1];
  for (int round = 0; round < Rounds; ++round)
  {
    const PulsePart part(
      pulse, static_cast<double>(round) / Rounds, static_cast<double>(round + 1) / Rounds);
    if (round > 0)
    {
      this->FindChanged();
    }
    this->ListCorners();
    this->Moved.clear();
    const std::vector<Id> vertices = this->Mesh.Around(this->Corners, 1);
    for (std::size_t k = 0; k < vertices.size() && pulse.Beat(); ++k)
    {
      if (this->ImproveVertex(vertices[k], good))
      {
        this->Moved.push_back(vertices[k]);
      }
    }
  }
}

// Those that may be poor, whatever the limits.
void AngleDescent::LookAtAll(Pulse& pulse)
{
  this->Poor.clear();
  pulse.ForEach(this->Mesh.Regions.size(),
    [this](std::size_t slot)
    {
      const Id triangle = static_cast<Id>(slot);
      const PoorTriangle judged =
        this->Mesh.IsEdge(4 * triangle) ? this->Judge(triangle) : PoorTriangle{};
      if (judged.Levels > 0 || judged.IsOutOfBand)
      {
        this->Poor.push_back(judged);
      }
    });
}

AngleDescent::PoorTriangle AngleDescent::Judge(Id triangle) const
{
  std::uint8_t levels = 0;
  while (levels < NumberOfLevels &&
    IsWorseThan(this->Mesh, triangle, this->Mesh.PoorCotangents * PoorCotangents[levels]))
  {
    ++levels;
  }
  return { triangle, levels, this->HasEdgeOutOfBand(triangle) };
}

void AngleDescent::ChooseLimits()
{
  std::size_t numbersOfPoor[NumberOfLevels] = {};
  std::size_t numberOutOfBand = 0;
  for (const PoorTriangle& triangle : this->Poor)
  {
    for (std::size_t level = 0; level < triangle.Levels; ++level)
    {
      ++numbersOfPoor[level];
    }
    numberOutOfBand += triangle.IsOutOfBand ? 1 : 0;
  }
  const auto most = FewTriangles +
    static_cast<std::size_t>(GreatestShareOfPoor * static_cast<double>(this->Mesh.Regions.size()));
  this->PoorLevel = 1;
  while (this->PoorLevel < NumberOfLevels && numbersOfPoor[this->PoorLevel - 1] > most)
  {
    ++this->PoorLevel;
  }
  this->AreLengthsPoor = numberOutOfBand <= most;
}

bool AngleDescent::IsPoor(const PoorTriangle& triangle) const
{
  return triangle.Levels >= this->PoorLevel || (this->AreLengthsPoor && triangle.IsOutOfBand);
}

// Of those that are poor by the limits; the others are left out from now on.
void AngleDescent::ListCorners()
{
  this->Poor.erase(std::remove_if(this->Poor.begin(), this->Poor.end(),
                     [this](const PoorTriangle& triangle) { return !this->IsPoor(triangle); }),
    this->Poor.end());
  this->Corners.clear();
  for (const PoorTriangle& triangle : this->Poor)
  {
    const Id* corners = this->Mesh.Corners.data() + 4 * static_cast<std::size_t>(triangle.Triangle);
    this->Corners.insert(this->Corners.end(), corners, corners + 3);
  }
}

// Only triangles about vertices that moved may have become poor, or cease to be.
void AngleDescent::FindChanged()
{
  std::vector<Id> triangles;
  for (const PoorTriangle& triangle : this->Poor)
  {
    triangles.push_back(triangle.Triangle);
  }
  for (const Id vertex : this->Mesh.Around(this->Moved, 1))
  {
    this->Mesh.ForEachAround(
      vertex, [&triangles](Id edge) { triangles.push_back(MutableMesh::TriangleOf(edge)); });
  }
  std::sort(triangles.begin(), triangles.end());
  triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
  this->Poor.clear();
  for (const Id triangle : triangles)
  {
    this->Poor.push_back(this->Judge(triangle));
  }
}

bool AngleDescent::HasEdgeOutOfBand(Id triangle) const
{
  for (Id edge = 4 * triangle; edge < 4 * triangle + 3; ++edge)
  {
    if (this->Mesh.IsFirstHalf(edge) && IsOutOfBand(this->Mesh, edge))
    {
      return true;
    }
  }
  return false;
}

void AngleDescent::Wake(const std::vector<Id>& vertices)
{
  this->IsSettled.resize(this->Mesh.Points.size(), 0);
  for (const Id vertex : vertices)
  {
    this->IsSettled[vertex] = 0;
  }
}

void AngleDescent::Improve(const std::vector<Id>& vertices, double good)
{
  for (const Id vertex : vertices)
  {
    this->ImproveVertex(vertex, good);
  }
}

bool AngleDescent::ImproveVertex(Id vertex, double good)
{
  const bool isMoved = this->IsSettled[vertex] == 0 && this->Move(vertex, good);
  if (isMoved)
  {
    this->WakeAround(vertex);
  }
  this->IsSettled[vertex] = 1;
  return isMoved;
}

void AngleDescent::WakeAround(Id vertex)
{
  this->Mesh.ForEachAround(vertex,
    [this](Id edge)
    {
      this->IsSettled[this->Mesh.Origin(edge)] = 0;
      this->IsSettled[this->Mesh.Target(edge)] = 0;
    });
}

// To the best place near it, with flips; false where there is none, or it is good where it is.
bool AngleDescent::Move(Id vertex, double good)
{
  Star star;
  if (this->Mesh.Freedoms[vertex] == Freedom::Fixed || !star.Read(this->Mesh, vertex))
  {
    return false;
  }
  StarObjective objective(this->Mesh, vertex, star);
  if (!(objective.Here() > good))
  {
    return false;
  }
  objective.FitSlope();
  const Place best = Descend(this->Mesh, vertex, star, objective);
  const Point2 place = this->Mesh.PlaceFor(vertex, star.Center + best.Shift);
  if (!(best.Value < objective.Here()) || !IsValidAt(this->Mesh, vertex, star, place))
  {
    return false;
  }
  MoveWithSpacing(this->Mesh, vertex, star, place);
  this->Mesh.RestoreAround(vertex);
  return true;
}

} // namespace biting
