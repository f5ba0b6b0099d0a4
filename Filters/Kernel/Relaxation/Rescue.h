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
#include <vector>  // for the lists

namespace biting
{

/// The last resort for the few triangles that are still below 38 degrees.
///
/// Around each of them, the worst first, every edge nearby is collapsed and split on trial, and
/// what is near is smoothed and climbs. The trial after which the worst triangle of the patch is
/// best is kept, if it is better than before.
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

  /// Tries at most `limit` triangles; each takes about as long as relaxing a thousand vertices.
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

  void FindPoor(Pulse& pulse);
  bool Improve(Id triangle, Pulse& pulse);
  void FindEdges(const std::vector<Id>& corners);
  Id Perform(const Trial& trial);
  double WorstOfPatch(Id added) const;
  double WorstAround(Id vertex) const;

  MutableMesh& Mesh;
  DelaunayFlips& Flips;
  Patch& Surroundings;
  Climbing& Climber;
  std::vector<PoorTriangle> Poor;
  std::vector<Id> Edges;  ///< to be tried
  std::vector<Id> Judged; ///< vertices whose triangles are compared before and after
  std::vector<Id> Moved;  ///< vertices that may move in a trial
};

} // namespace biting

#endif
