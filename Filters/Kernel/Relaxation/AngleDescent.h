// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingAngleDescent_h
#define BitingAngleDescent_h

#include "../Base/Ids.h"
#include "../Base/Pulse.h"
#include "DelaunayMesh.h"

#include <cstdint> // for flags
#include <vector>  // for the lists

namespace biting
{

/// Moves single vertices where triangles are worst: a compass search for the least objective of the
/// star (StarObjective).
///
/// Tried are the vertices of triangles with an angle below 40 degrees, or with an edge out of the
/// band, and their neighbors. A vertex stays if its objective is at most 0.84 cot 40 = cot 45. The
/// others are moved in eight directions, or in both along their segment, by steps from 0.12
/// spacings down to 0.008. A vertex is tried again only after a change of its star.
/// Where more than 500 + n / 20 of n triangles have an angle below 40 degrees, the limit of 40
/// becomes 35, 30 or 25. Where more than that have an edge out of the band, edges do not count.
/// Law: no star gets an angle that is both below 32 degrees and smaller than its smallest.
class AngleDescent
{
public:
  explicit AngleDescent(DelaunayMesh& mesh)
    : Mesh(mesh)
  {
  }

  /// Two rounds over all such vertices and their neighbors.
  void Run(Pulse& pulse);

  /// Says that the stars of these vertices have changed.
  void Wake(const std::vector<Id>& vertices);

  /// Moves those of the vertices whose stars have changed, once each, where the objective is above
  /// `good`.
  void Improve(const std::vector<Id>& vertices, double good);

private:
  struct PoorTriangle
  {
    Id Triangle = NoId;
    std::uint8_t Levels = 0; ///< by how many of the limits of angles it is poor
    bool IsOutOfBand = false;
  };

  void LookAtAll(Pulse& pulse);
  void ChooseLimits();
  void FindChanged();
  void ListCorners();
  PoorTriangle Judge(Id triangle) const;
  bool IsPoor(const PoorTriangle& triangle) const;
  bool HasEdgeOutOfBand(Id triangle) const;
  bool ImproveVertex(Id vertex, double good);
  bool Move(Id vertex, double good);
  void WakeAround(Id vertex);

  DelaunayMesh& Mesh;
  std::size_t PoorLevel = 1;  ///< a triangle with at least as many Levels is poor
  bool AreLengthsPoor = true; ///< a triangle with an edge out of the band is poor
  std::vector<PoorTriangle> Poor;
  std::vector<Id> Corners;             ///< of the poor triangles
  std::vector<Id> Moved;               ///< since the poor triangles were looked for
  std::vector<std::uint8_t> IsSettled; ///< of a vertex: its star is as it was when it was looked at
};

} // namespace biting

#endif
