// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "CutStrip.h"

#include "../Base/Monitor.h"
#include "../Base/Pulse.h"
#include "../Base/Tasks.h"
#include "../Relaxation/Relaxation.h"
#include "../Stages/MeshedBites.h" // for Exchange
#include "StripParts.h"
#include "StripReturn.h"
#include "TakenStrip.h"

#include <numeric> // for iota
#include <utility> // for move

namespace biting
{

namespace
{

constexpr std::size_t TrianglesOfPart = 8000;

// Angles below 46 degrees are made better, below 44 also one by one.
constexpr double PoorInStrip = 0.80;

// Where steps end, as shares of the time.
constexpr double TakingEnd = 0.1;
constexpr double RelaxingEnd = 0.8;
constexpr double PartsEnd = 0.9;

TakenStrip TakeNearCuts(const Domain& domain, const std::vector<std::uint8_t>& areTouching,
  const JoinedMesh& mesh, Pulse& pulse)
{
  StripSource source(domain, areTouching, mesh);
  return TakeStrip(source, mesh.NearCuts, pulse);
}

RelaxedStrip RelaxStrip(TakenStrip strip, const Spacing& spacing, Monitor& monitor)
{
  RelaxedStrip relaxed;
  relaxed.Origins =
    Relax(strip.Border, spacing, { false, true, PoorInStrip }, strip.Mesh, monitor).Origins;
  relaxed.Strip = std::move(strip);
  return relaxed;
}

// Takes, relaxes and returns parts, as tasks. False where the monitor wants to stop.
bool RelaxParts(const Domain& domain, const Spacing& spacing, std::vector<TriangleList> parts,
  JoinedMesh& mesh, Pulse& pulse)
{
  const std::vector<std::uint8_t> touchesNone;
  StripSource source(domain, touchesNone, mesh);
  std::vector<RelaxedStrip> strips(parts.size());
  DoTasks(pulse, parts.size(),
    [&spacing, &parts, &source, &strips](std::size_t k, Monitor& own)
    {
      PartOfStage taking(own, 0.0, TakingEnd);
      Pulse takingPulse(taking);
      TakenStrip strip = TakeStrip(source, std::move(parts[k]), takingPulse);
      PartOfStage relaxing(own, TakingEnd, 1.0);
      if (!takingPulse.HasStopped())
      {
        strips[k] = RelaxStrip(std::move(strip), spacing, relaxing);
      }
    });
  if (!pulse.HasStopped())
  {
    ReturnStrips(strips, mesh, pulse);
  }
  return !pulse.HasStopped();
}

// The strip as a mesh that strips may be taken from; the number of a vertex is that of its bite.
JoinedMesh AsWhole(RelaxationMesh& mesh)
{
  JoinedMesh whole;
  whole.Bites.BiteOrders.resize(mesh.Points.size());
  std::iota(whole.Bites.BiteOrders.begin(), whole.Bites.BiteOrders.end(), 0);
  Exchange(whole.Bites, whole.Triangles, mesh);
  return whole;
}

// The connected neighbourhoods of the triangles before `end`.
std::vector<TriangleList> PlacesAround(const JoinedMesh& mesh, std::size_t end, Pulse& pulse)
{
  const std::size_t vertices = mesh.Bites.Points.size();
  const Id* corners = mesh.Triangles.Corners.data();
  const std::vector<Id> seeds(corners, corners + 3 * end);
  return ConnectedParts(
    mesh.Triangles, vertices, TrianglesAround(mesh.Triangles, vertices, seeds, pulse), pulse);
}

// Part by part as tasks, then where parts meet.
RelaxedStrip RelaxByParts(TakenStrip strip, const Spacing& spacing, Monitor& monitor)
{
  Pulse pulse(monitor);
  JoinedMesh mesh = AsWhole(strip.Mesh);
  std::vector<TriangleList> parts =
    DivideIntoParts(mesh.Triangles, mesh.Bites.Points.size(), TrianglesOfPart, pulse);
  if (parts.size() < 2)
  {
    Exchange(mesh.Bites, mesh.Triangles, strip.Mesh);
    return RelaxStrip(std::move(strip), spacing, monitor);
  }
  std::size_t between = mesh.Triangles.Regions.size();
  for (const TriangleList& part : parts)
  {
    between -= part.size();
  }
  {
    const PulsePart ofParts(pulse, 0.0, PartsEnd);
    RelaxParts(strip.Border, spacing, std::move(parts), mesh, pulse);
  }
  if (between > 0 && !pulse.HasStopped())
  {
    // Returned triangles come last: those before are between the parts.
    RelaxParts(strip.Border, spacing, PlacesAround(mesh, between, pulse), mesh, pulse);
  }
  RelaxedStrip relaxed;
  relaxed.Origins = std::move(mesh.Bites.BiteOrders);
  Exchange(mesh.Bites, mesh.Triangles, strip.Mesh);
  relaxed.Strip = std::move(strip);
  return relaxed;
}

} // namespace

StripChange RelaxCuts(const Domain& domain, const std::vector<std::uint8_t>& areTouching,
  const Spacing& spacing, JoinedMesh& mesh, Monitor& monitor)
{
  PartOfStage taking(monitor, 0.0, TakingEnd);
  Pulse takingPulse(taking);
  TakenStrip strip = TakeNearCuts(domain, areTouching, mesh, takingPulse);
  if (takingPulse.HasStopped() || strip.IsEmpty())
  {
    return {};
  }
  PartOfStage relaxing(monitor, TakingEnd, RelaxingEnd);
  std::vector<RelaxedStrip> relaxed;
  relaxed.push_back(RelaxByParts(std::move(strip), spacing, relaxing));
  PartOfStage returning(monitor, RelaxingEnd, 1.0);
  Pulse pulse(returning);
  return relaxing.HasStopped() ? StripChange() : ReturnStrips(relaxed, mesh, pulse);
}

} // namespace biting
