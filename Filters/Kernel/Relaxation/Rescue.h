// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingRescue_h
#define BitingRescue_h

#include "../Base/Ids.h"
#include "../Base/Pulse.h"
#include "Climbing.h"
#include "DelaunayFlips.h"
#include "MutableMesh.h"
#include "Patch.h"

#include <cstddef> // for the limit
#include <cstdint> // for flags
#include <vector>  // for the lists

namespace biting
{

/// The last resort for the few triangles that are still below 38 degrees.
///
/// Around each of them, the worst first, every edge nearby is collapsed and split on trial, and
/// what is near is smoothed and climbs. The trial after which the worst triangle of the patch is
/// best is kept, if it is better than before. All that are left are tried again as long as that
/// helps, those near which nothing has changed apart.
class Rescue
{
public:
  Rescue(MutableMesh& mesh, DelaunayFlips& flips, Patch& patch, Climbing& climbing)
    : Mesh(mesh)
    , Flips(flips)
    , Surroundings(patch)
    , Climber(climbing)
  {
  }

  /// Makes at most `limit` attempts; each takes about as long as relaxing two thousand vertices.
  void Run(std::size_t limit, Pulse& pulse);

private:
  struct PoorTriangle
  {
    double Cotangent;
    Id Triangle;
  };
  struct Trial
  {
    Id Edge = NoId;
    bool IsCollapse = false;
    double Worst = 0.0;
  };

  bool TryAll(std::size_t limit, Pulse& pulse);
  void FindPoor(Pulse& pulse);
  bool IsToBeTried(Id triangle) const;
  bool Improve(Id triangle, Pulse& pulse);
  void RenewHope();
  void FindEdges(const std::vector<Id>& corners);
  bool IsAllowed(const Trial& trial) const;
  Id Perform(const Trial& trial);
  double WorstOfPatch(Id added) const;
  double WorstAround(Id vertex) const;

  MutableMesh& Mesh;
  DelaunayFlips& Flips;
  Patch& Surroundings;
  Climbing& Climber;
  std::vector<PoorTriangle> Poor;
  std::vector<std::uint8_t> AreHopeless; ///< one a triangle: tried, and nothing near has changed
  std::size_t NumberOfAttempts = 0;
  std::vector<Id> Edges;  ///< to be tried
  std::vector<Id> Judged; ///< vertices whose triangles are compared before and after
  std::vector<Id> Moved;  ///< vertices that may move in a trial
};

} // namespace biting

#endif
