// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingClimbing_h
#define BitingClimbing_h

#include "../Base/Ids.h"
#include "../Base/Pulse.h"
#include "DelaunayFlips.h"
#include "MutableMesh.h"
#include "Patch.h"

#include <cstdint> // for flags
#include <vector>  // for the lists

namespace biting
{

/// Moves single vertices where triangles are worst.
///
/// The vertices of triangles with an angle below 40 degrees, and of edges out of the band (see
/// Hill), look in eight directions for a place where the hill is lower, in steps from 0.12
/// spacings down to 0.008, unless what is around them is good: above 45 degrees.
/// Where more than 500 and a twentieth of the triangles have such angles, only those below 35, 30
/// or 25 degrees count, and what is good is less in proportion; where more have such edges, these
/// do not. Law: no star gets an angle that is both below 32 degrees and smaller than its smallest.
class Climbing
{
public:
  Climbing(MutableMesh& mesh, DelaunayFlips& flips, Patch& patch)
    : Mesh(mesh)
    , Flips(flips)
    , Surroundings(patch)
  {
  }

  /// `rounds` over all such vertices and those at most `rings` edges from them.
  void Run(int rings, int rounds, Pulse& pulse);

  /// Moves one vertex, with flips around it, to the best place near it; whether there is one, and
  /// the hill here is higher than `good`.
  bool Climb(Id vertex, double good);

private:
  void ChooseLimits(Pulse& pulse);
  void FindPoor(Pulse& pulse);
  bool HasEdgeOutOfBand(Id triangle) const;
  void WakeAround(Id vertex);

  MutableMesh& Mesh;
  DelaunayFlips& Flips;
  Patch& Surroundings;
  double PoorCotangent = 0.0; ///< a triangle that is worse is poor
  bool AreLengthsPoor = true; ///< and so is one with an edge out of the band
  std::vector<Id> Poor;
  std::vector<Id> Climbers;
  std::vector<std::uint8_t> IsAtTop; ///< one a vertex: nothing near has changed since it was tried
};

} // namespace biting

#endif
