// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Relaxation.h"

#include "../Base/Pulse.h"
#include "AngleDescent.h"
#include "DelaunayFlips.h"
#include "DividedSegments.h"
#include "MeshExchange.h"
#include "MutableMesh.h"
#include "Patch.h"
#include "Smoothing.h"
#include "Star.h"
#include "TopologyTrials.h"
#include "ValenceRound.h"

#include <algorithm> // for min
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

// Where steps end, as shares of the time.
constexpr double ReadingEnd = 0.06;
constexpr double WorkingEnd = 0.94;

/// The operations with all that they work on.
class Relaxer
{
public:
  Relaxer(MutableMesh& mesh, Pulse& pulse)
    : Mesh(mesh)
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
    this->Descend(0.75, 0.95);
    this->TryTopologies(0.95, 0.99);
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

  void TryTopologies(double begin, double end)
  {
    if (!this->TriesTopologies)
    {
      return;
    }
    const PulsePart part(this->Progress, begin, end);
    const std::size_t vertices = this->Mesh.Points.size();
    this->Trials.Run(LeastNumberOfTrials +
        std::min(vertices / SmallVerticesPerTrial, MostSmallTrials) + vertices / VerticesPerTrial,
      this->Progress);
  }

  MutableMesh& Mesh;
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
    work.IsDivided = FindDividedSegments(domain, spacing, pulse);
    KeepPreserved(domain, work.IsDivided);
    work.DividesSegments = options.DividesSegments;
    work.PoorCotangents = options.PoorCotangents;
    origins = ReadMesh(mesh, work, pulse);
  }
  if (!pulse.HasStopped())
  {
    const PulsePart working(pulse, ReadingEnd, WorkingEnd);
    Relaxer(work, pulse).Run(options);
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
