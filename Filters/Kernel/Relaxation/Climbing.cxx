// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Climbing.h"

#include "Hill.h"
#include "Star.h"

#include <cstddef>  // for counts
#include <iterator> // for size

namespace biting
{

namespace
{

constexpr double FirstStep = 0.12; // spacings
constexpr double LastStep = 0.008;
constexpr int MostSteps = 40;
constexpr double GoodPerPoor = 0.84; // cotangents: of 45 degrees to that of 40
constexpr double GreatestShareOfPoor = 0.05;
constexpr std::size_t FewTriangles = 500; // so many may be poor in any mesh
constexpr double PoorCotangents[] = { CotangentOf40Degrees, CotangentOf35Degrees,
  CotangentOf30Degrees, CotangentOf25Degrees };
constexpr int NumberOfLevels = static_cast<int>(std::size(PoorCotangents));

constexpr double Diagonal = 0.7071067811865476;
constexpr Point2 Directions[] = { { 1.0, 0.0 }, { Diagonal, Diagonal }, { 0.0, 1.0 },
  { -Diagonal, Diagonal }, { -1.0, 0.0 }, { -Diagonal, -Diagonal }, { 0.0, -1.0 },
  { Diagonal, -Diagonal } };

/// The way to the lowest place that the search finds, and how high it is there.
struct Descent
{
  Point2 Shift;
  double Height;
};

/// Goes one step in the best of all directions; stays where none leads down.
Descent Step(const MutableMesh& mesh, Id vertex, const Star& star, const Hill& hill,
  const Descent& from, double length)
{
  Descent best = from;
  for (const Point2& direction : Directions)
  {
    const Point2 place = mesh.PlaceFor(vertex, star.Center + from.Shift + length * direction);
    const Point2 shift = place - star.Center;
    const double height = hill.Height(shift, best.Height);
    if (height < best.Height)
    {
      best = { shift, height };
    }
  }
  return best;
}

} // namespace

void Climbing::Run(int rings, int rounds, Pulse& pulse)
{
  this->IsAtTop.assign(this->Mesh.Points.size(), 0);
  this->ChooseLimits(pulse);
  for (int round = 0; round < rounds; ++round)
  {
    const PulsePart part(
      pulse, static_cast<double>(round) / rounds, static_cast<double>(round + 1) / rounds);
    this->FindPoor(pulse);
    this->Climbers = this->Surroundings.Around(this->Poor, rings);
    const double good = GoodPerPoor * this->PoorCotangent;
    for (const Id vertex : this->Climbers)
    {
      if (!pulse.Beat())
      {
        return;
      }
      if (!this->IsAtTop[vertex] && this->Climb(vertex, good))
      {
        this->WakeAround(vertex);
      }
      this->IsAtTop[vertex] = 1;
    }
  }
}

void Climbing::ChooseLimits(Pulse& pulse)
{
  std::size_t numbersOfPoor[NumberOfLevels] = {};
  std::size_t numberOutOfBand = 0;
  const Id numberOfTriangles = static_cast<Id>(this->Mesh.Regions.size());
  for (Id triangle = 0; triangle < numberOfTriangles && pulse.Beat(); ++triangle)
  {
    const bool isAlive = this->Mesh.IsEdge(4 * triangle);
    for (int level = 0; level < NumberOfLevels && isAlive &&
         IsWorseThan(this->Mesh, triangle, PoorCotangents[level]);
         ++level)
    {
      ++numbersOfPoor[level];
    }
    numberOutOfBand += isAlive && this->HasEdgeOutOfBand(triangle) ? 1 : 0;
  }
  const auto most =
    FewTriangles + static_cast<std::size_t>(GreatestShareOfPoor * numberOfTriangles);
  int level = 0;
  while (level + 1 < NumberOfLevels && numbersOfPoor[level] > most)
  {
    ++level;
  }
  this->PoorCotangent = PoorCotangents[level];
  this->AreLengthsPoor = numberOutOfBand <= most;
}

void Climbing::FindPoor(Pulse& pulse)
{
  this->Poor.clear();
  const Id numberOfTriangles = static_cast<Id>(this->Mesh.Regions.size());
  for (Id triangle = 0; triangle < numberOfTriangles && pulse.Beat(); ++triangle)
  {
    if (this->Mesh.IsEdge(4 * triangle) &&
      (IsWorseThan(this->Mesh, triangle, this->PoorCotangent) ||
        (this->AreLengthsPoor && this->HasEdgeOutOfBand(triangle))))
    {
      const Id* corners = this->Mesh.Corners.data() + 4 * static_cast<std::size_t>(triangle);
      this->Poor.insert(this->Poor.end(), corners, corners + 3);
    }
  }
}

bool Climbing::HasEdgeOutOfBand(Id triangle) const
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

void Climbing::WakeAround(Id vertex)
{
  const Id first = this->Mesh.FirstAround(vertex);
  Id edge = first;
  do
  {
    this->IsAtTop[this->Mesh.Origin(edge)] = 0;
    this->IsAtTop[this->Mesh.Target(edge)] = 0;
    edge = this->Mesh.Turn(edge);
  } while (edge != NoId && edge != first);
}

bool Climbing::Climb(Id vertex, double good)
{
  Star star;
  if (this->Mesh.Freedoms[vertex] == Freedom::Fixed || !star.Read(this->Mesh, vertex))
  {
    return false;
  }
  const Hill hill(this->Mesh, vertex, star);
  const Descent start{ {}, hill.HeightHere() };
  if (!(start.Height > good))
  {
    return false;
  }
  Descent best = start;
  double length = FirstStep * this->Mesh.Spacings[vertex];
  const double lastLength = LastStep * this->Mesh.Spacings[vertex];
  for (int step = 0; step < MostSteps && length >= lastLength; ++step)
  {
    const Descent next = Step(this->Mesh, vertex, star, hill, best, length);
    length = next.Height < best.Height ? length : 0.5 * length;
    best = next;
  }
  const Point2 place = this->Mesh.PlaceFor(vertex, star.Center + best.Shift);
  if (!(best.Height < start.Height) || !IsValidAt(this->Mesh, star, place))
  {
    return false;
  }
  this->Mesh.Move(vertex, place);
  this->Mesh.RefreshSpacing(vertex);
  this->Flips.RestoreAround(vertex);
  return true;
}

} // namespace biting
