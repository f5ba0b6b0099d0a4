// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Relaxation.h"

#include "../Base/Pulse.h"
#include "AngleDescent.h"
#include "DelaunayMesh.h"
#include "DividedSegments.h"
#include "EdgeOperations.h"
#include "HeldVertices.h"
#include "MeshExchange.h"
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
constexpr int PassesOfDescent = 2;
constexpr int RingsOfReleased = 2; // about them, that are smoothed with them
constexpr double CotangentOf45Degrees = 1.0;
constexpr double MarginOfEstimates = 1.025; // spacings at new places are known to a few per cent

// Where steps end, as shares of the time.
constexpr double ReadingEnd = 0.06;
constexpr double WorkingEnd = 0.94;

/// The steps of relaxation, on one mesh.
class Relaxer
{
public:
  Relaxer(DelaunayMesh& mesh, const RelaxationOptions& options, HeldVertices& held, Pulse& pulse)
    : Mesh(mesh)
    , Options(options)
    , Held(held)
    , Progress(pulse)
    , Valences(mesh)
    , Descent(mesh)
    , Trials(mesh, Descent)
  {
  }

  void Run()
  {
    const bool holds = this->Options.Hold.Count > 0 || this->Options.Hold.FindPlace;
    this->Do(0.0, 0.2, [this]() { this->Valences.Run(2, this->Progress); });
    this->Do(0.2, 0.4, [this]() { SmoothAll(this->Mesh, SweepKind::All, this->Progress); });
    this->Do(0.4, 0.55, [this]() { this->Valences.Run(1, this->Progress); });
    this->Do(0.55, 0.75, [this]() { SmoothAll(this->Mesh, SweepKind::Coarse, this->Progress); });
    this->Do(0.75, holds ? 0.8 : 0.95, [this]() { this->Descent.Run(this->Progress); });
    if (holds)
    {
      this->Do(0.8, 0.82, [this]() { this->SplitLong(); });
      this->Do(0.82, 0.95, [this]() { this->Release(); });
    }
    this->Do(0.95, 0.98, [this]() { this->TryTopologies(); });
    if (holds)
    {
      this->Do(0.98, 0.983, [this]() { this->TakeBack(); });
      this->Do(0.983, 0.985, [this]() { this->HoldAtPlaces(); });
      this->Do(0.985, 0.99, [this]() { this->SmoothBetweenHeld(); });
    }
    this->Do(0.99, 1.0, [this]() { this->Mesh.AskForEstimates(this->Progress); });
  }

private:
  /// A step, from `begin` to `end` as shares of the time of all.
  template <typename Step>
  void Do(double begin, double end, const Step& step)
  {
    const PulsePart part(this->Progress, begin, end);
    step();
  }

  void TryTopologies()
  {
    if (!this->Options.TriesTopologies)
    {
      return;
    }
    const std::size_t vertices = this->Mesh.Points.size();
    const std::size_t limit = LeastNumberOfTrials +
      std::min(vertices / SmallVerticesPerTrial, MostSmallTrials) + vertices / VerticesPerTrial;
    if (this->Options.Hold.Count > 0 && this->CountPoor() > limit)
    {
      const double allowed = std::min(this->Options.Hold.GreatestCotangent, CotangentOf35Degrees);
      this->Mesh.PoorCotangents =
        std::max(this->Mesh.PoorCotangents, allowed / CotangentOf38Degrees);
    }
    this->Trials.Run(limit, this->Progress);
  }

  std::size_t CountPoor() const
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

  // Where vertices are held.
  void SplitLong()
  {
    const HoldOptions& hold = this->Options.Hold;
    SplitLongEdges(this->Mesh, hold.LongestEdge, hold.GreatestCotangent, this->Progress);
  }

  void Release()
  {
    for (int round = 0; round < this->Options.Hold.Rounds && !this->Progress.HasStopped(); ++round)
    {
      const std::vector<Id> released = this->Held.ReleaseThoseInTheWay(this->Progress);
      if (released.empty())
      {
        return;
      }
      this->SmoothAround(released);
      this->Valences.Run(1, this->Progress);
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
    const std::vector<Id> near = this->Mesh.Around(alive, RingsOfReleased);
    this->Progress.ForEach(
      near.size(), [this, &near](std::size_t k) { SmoothVertex(this->Mesh, near[k]); });
    return near;
  }

  /// What is beside a vertex that came back is improved, and may then make room for others.
  void TakeBack()
  {
    for (int pass = 0; pass < PassesOfTakingBack; ++pass)
    {
      std::vector<Id> returned;
      for (const HeldVertices::Released& released : this->Held.ListReleased())
      {
        if (this->Progress.Beat() && this->Held.TakeBack(released))
        {
          this->Mesh.RestoreAround(released.Vertex);
          returned.push_back(released.Vertex);
        }
      }
      this->DescendAround(this->Mesh.Around(returned, 1));
    }
  }

  /// One after the other, each where the ones before have gone. A second pass finds few more.
  void HoldAtPlaces()
  {
    if (!this->Options.Hold.FindPlace)
    {
      return;
    }
    std::vector<Id> held;
    this->Progress.ForEach(this->Mesh.Points.size(),
      [this, &held](std::size_t k)
      {
        const Id vertex = static_cast<Id>(k);
        if (this->Held.HoldAtPlaceNear(vertex))
        {
          this->Mesh.RestoreAround(vertex);
          held.push_back(vertex);
        }
      });
    this->DescendAround(this->Mesh.Around(held, 1));
  }

  void DescendAround(const std::vector<Id>& vertices)
  {
    this->Descent.Wake(vertices);
    std::vector<Id> one(1);
    for (int pass = 0; pass < PassesOfDescent; ++pass)
    {
      this->Progress.ForEach(vertices.size(),
        [this, &vertices, &one](std::size_t k)
        {
          one[0] = vertices[k];
          this->Descent.Improve(one, CotangentOf45Degrees);
        });
    }
  }

  /// The descent cares for the worst triangles alone: the others are brought back into shape.
  void SmoothBetweenHeld()
  {
    const HoldOptions& hold = this->Options.Hold;
    const SmoothingLimits limits{ CotangentOf40Degrees, MarginOfEstimates * hold.ShortestEdge,
      hold.LongestEdge / MarginOfEstimates };
    SmoothWithin(this->Mesh, limits, this->Progress);
  }

  DelaunayMesh& Mesh;
  const RelaxationOptions& Options;
  HeldVertices& Held;
  Pulse& Progress;
  ValenceRound Valences;
  AngleDescent Descent;
  TopologyTrials Trials;
};

} // namespace

RelaxationResult Relax(const Domain& domain, const Spacing& spacing,
  const RelaxationOptions& options, RelaxationMesh& mesh, Monitor& monitor)
{
  Pulse pulse(monitor);
  DelaunayMesh work(domain, spacing);
  std::vector<Id> origins;
  {
    const PulsePart reading(pulse, 0.0, ReadingEnd);
    work.IsDivided = FindDividedSegments(domain, mesh.Spacings, pulse);
    for (std::size_t segment = 0; segment < domain.IsPreserved.size(); ++segment)
    {
      work.IsDivided[segment] &= domain.IsPreserved[segment] == 0;
    }
    work.DividesSegments = options.DividesSegments;
    work.PoorCotangents = options.PoorCotangents;
    origins = ReadMesh(mesh, work, pulse);
  }
  if (!pulse.HasStopped())
  {
    const PulsePart working(pulse, ReadingEnd, WorkingEnd);
    HeldVertices held(options.Hold, domain.NumberOfVertices(), origins, work);
    Relaxer(work, options, held, pulse).Run();
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
