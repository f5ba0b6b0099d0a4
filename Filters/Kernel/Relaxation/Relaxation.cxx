// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Relaxation.h"

#include "../Base/Pulse.h"
#include "AngleDescent.h"
#include "DelaunayFlips.h"
#include "DividedSegments.h"
#include "HeldVertices.h"
#include "LongEdges.h"
#include "MeshExchange.h"
#include "MutableMesh.h"
#include "Patch.h"
#include "Smoothing.h"
#include "Star.h"
#include "StarObjective.h"
#include "TopologyTrials.h"
#include "ValenceRound.h"

#include <algorithm> // for max, min
#include <cstddef>   // for limits

namespace biting
{

namespace
{

// Attempts at single triangles. A small mesh has some for each of its vertices; their time counts
// in large ones only.
constexpr std::size_t LeastNumberOfTrials = 8;
constexpr std::size_t SmallVerticesPerTrial = 60;
constexpr std::size_t MostSmallTrials = 64;
constexpr std::size_t VerticesPerTrial = 20000;

constexpr int PassesOfTakingBack = 2;
constexpr int RingsOfReleased = 2; // about them, that are smoothed with them
constexpr double CotangentOf45Degrees = 1.0;
constexpr double MarginOfEstimates = 1.025; // spacings at new places are known to a few per cent

// Where steps end, as shares of the time.
constexpr double ReadingEnd = 0.06;
constexpr double WorkingEnd = 0.94;

/// The operations with all that they work on.
class Relaxer
{
public:
  Relaxer(MutableMesh& mesh, HeldVertices& held, Pulse& pulse)
    : Mesh(mesh)
    , Held(held)
    , Progress(pulse)
    , Flips(mesh)
    , Surroundings(mesh)
    , Valences(mesh, Flips, Surroundings)
    , Descent(mesh, Flips, Surroundings)
    , Trials(mesh, Flips, Surroundings, Descent)
  {
  }

  void Run(const RelaxationOptions& options)
  {
    this->TriesTopologies = options.TriesTopologies;
    this->MendValences(0.0, 0.2, 2);
    this->Smooth(0.2, 0.4, SweepKind::All);
    this->MendValences(0.4, 0.55, 1);
    this->Smooth(0.55, 0.75, SweepKind::Coarse);
    this->Descend(0.75, options.Hold.Count > 0 ? 0.8 : 0.95);
    this->SplitLong(0.8, 0.82, options.Hold);
    this->Release(0.82, 0.95, options.Hold.Rounds);
    this->TryTopologies(0.95, 0.98, options.Hold);
    this->TakeBack(0.98, 0.985);
    this->SmoothBetweenHeld(0.985, 0.99, options.Hold);
    const PulsePart part(this->Progress, 0.99, 1.0);
    this->Mesh.AskForEstimates(this->Progress);
  }

private:
  void MendValences(double begin, double end, int rings)
  {
    const PulsePart part(this->Progress, begin, end);
    this->Valences.Run(rings, 1, this->Progress);
  }

  void Smooth(double begin, double end, SweepKind kind)
  {
    const PulsePart part(this->Progress, begin, end);
    SmoothAll(this->Mesh, this->Flips, 1, kind, CotangentOf30Degrees, this->Progress);
  }

  void Descend(double begin, double end)
  {
    const PulsePart part(this->Progress, begin, end);
    this->Descent.Run(1, 2, this->Progress);
  }

  void SplitLong(double begin, double end, const HoldOptions& hold)
  {
    if (hold.Count > 0)
    {
      const PulsePart part(this->Progress, begin, end);
      LongEdges(this->Mesh, this->Flips, this->Surroundings)
        .Split(hold.LongestEdge, hold.GreatestCotangent, this->Progress);
    }
  }

  void Release(double begin, double end, int rounds)
  {
    const PulsePart part(this->Progress, begin, end);
    for (int round = 0; round < rounds && !this->Progress.HasStopped(); ++round)
    {
      const std::vector<Id> released = this->Held.ReleaseThoseInTheWay(this->Progress);
      if (released.empty())
      {
        return;
      }
      this->SmoothAround(released);
      this->Valences.Run(1, 1, this->Progress);
      this->DescendAround(this->SmoothAround(released));
    }
  }

  /// Returns the vertices that it looked at.
  std::vector<Id> SmoothAround(const std::vector<Id>& released)
  {
    std::vector<Id> alive;
    for (const Id vertex : released)
    {
      if (this->Mesh.IsAlive(vertex))
      {
        alive.push_back(vertex);
      }
    }
    const std::vector<Id> near = this->Surroundings.Around(alive, RingsOfReleased);
    this->Progress.ForEach(near.size(),
      [this, &near](std::size_t k)
      {
        if (SmoothVertex(this->Mesh, near[k], CotangentOf30Degrees))
        {
          this->Flips.RestoreAround(near[k]);
        }
      });
    return near;
  }

  /// What is beside a vertex that came back is improved, and may then make room for others.
  void TakeBack(double begin, double end)
  {
    const PulsePart part(this->Progress, begin, end);
    for (int pass = 0; pass < PassesOfTakingBack; ++pass)
    {
      std::vector<Id> returned;
      for (const HeldVertices::Released& released : this->Held.ListReleased())
      {
        if (this->Progress.Beat() && this->Held.TakeBack(released))
        {
          this->Flips.RestoreAround(released.Vertex);
          returned.push_back(released.Vertex);
        }
      }
      this->DescendAround(this->Surroundings.Around(returned, 1));
    }
  }

  /// The descent cares for the worst triangles alone: the others are brought back into shape.
  void SmoothBetweenHeld(double begin, double end, const HoldOptions& hold)
  {
    if (hold.Count > 0)
    {
      const PulsePart part(this->Progress, begin, end);
      const SmoothingLimits limits{ CotangentOf40Degrees, MarginOfEstimates * hold.ShortestEdge,
        hold.LongestEdge / MarginOfEstimates };
      SmoothWithin(this->Mesh, this->Flips, limits, this->Progress);
    }
  }

  void DescendAround(const std::vector<Id>& vertices)
  {
    this->Descent.Wake(vertices);
    std::vector<Id> one(1);
    for (int pass = 0; pass < 2; ++pass)
    {
      this->Progress.ForEach(vertices.size(),
        [this, &vertices, &one](std::size_t k)
        {
          one[0] = vertices[k];
          this->Descent.Improve(one, CotangentOf45Degrees);
        });
    }
  }

  void TryTopologies(double begin, double end, const HoldOptions& hold)
  {
    if (!this->TriesTopologies)
    {
      return;
    }
    const PulsePart part(this->Progress, begin, end);
    const std::size_t vertices = this->Mesh.Points.size();
    const std::size_t limit = LeastNumberOfTrials +
      std::min(vertices / SmallVerticesPerTrial, MostSmallTrials) + vertices / VerticesPerTrial;
    if (hold.Count > 0 && this->CountPoor() > limit)
    {
      const double allowed = std::min(hold.GreatestCotangent, CotangentOf35Degrees);
      this->Mesh.PoorCotangents =
        std::max(this->Mesh.PoorCotangents, allowed / CotangentOf38Degrees);
    }
    this->Trials.Run(limit, this->Progress);
  }

  std::size_t CountPoor()
  {
    std::size_t count = 0;
    this->Progress.ForEach(this->Mesh.Regions.size(),
      [this, &count](std::size_t triangle)
      {
        const Id id = static_cast<Id>(triangle);
        count += this->Mesh.IsEdge(4 * id) && IsWorseThan(this->Mesh, id, CotangentOf38Degrees);
      });
    return count;
  }

  MutableMesh& Mesh;
  HeldVertices& Held;
  Pulse& Progress;
  DelaunayFlips Flips;
  Patch Surroundings;
  ValenceRound Valences;
  AngleDescent Descent;
  TopologyTrials Trials;
  bool TriesTopologies = true;
};

void KeepPreserved(const Domain& domain, std::vector<std::uint8_t>& isDivided)
{
  for (std::size_t segment = 0; segment < domain.IsPreserved.size(); ++segment)
  {
    isDivided[segment] &= domain.IsPreserved[segment] == 0;
  }
}

} // namespace

RelaxationResult Relax(const Domain& domain, const Spacing& spacing,
  const RelaxationOptions& options, RelaxationMesh& mesh, Monitor& monitor)
{
  Pulse pulse(monitor);
  MutableMesh work(domain, spacing);
  std::vector<Id> origins;
  {
    const PulsePart reading(pulse, 0.0, ReadingEnd);
    work.IsDivided = FindDividedSegments(domain, mesh.Spacings, pulse);
    KeepPreserved(domain, work.IsDivided);
    work.DividesSegments = options.DividesSegments;
    work.PoorCotangents = options.PoorCotangents;
    origins = ReadMesh(mesh, work, pulse);
  }
  if (!pulse.HasStopped())
  {
    const PulsePart working(pulse, ReadingEnd, WorkingEnd);
    HeldVertices held(options.Hold, domain.NumberOfVertices(), origins, work);
    Relaxer(work, held, pulse).Run(options);
  }
  RelaxationResult result;
  if (!pulse.HasStopped())
  {
    const PulsePart writing(pulse, WorkingEnd, 1.0);
    result.Origins = WriteMesh(work, origins, mesh, pulse);
  }
  if (pulse.HasStopped())
  {
    mesh = {};
    result = {};
    result.WasAborted = true;
  }
  return result;
}

} // namespace biting
