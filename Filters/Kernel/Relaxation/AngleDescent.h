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

/// Moves single vertices where triangles are worst.
///
/// The vertices of triangles with an angle below 40 degrees, and of edges out of the band (see
/// StarObjective), look in eight directions, or in both along their segment, for a place where the
/// objective of their star is less, in steps from 0.12 spacings down to 0.008, unless it is good:
/// as above 45 degrees. A vertex is looked at again only where its star has changed.
/// Where more than 500 and a twentieth of the triangles have such angles, only those below 35, 30
/// or 25 degrees count, and what is good is less in proportion; where more have such edges, these
/// do not. Law: no star gets an angle that is both below 32 degrees and smaller than its smallest.
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
  std::size_t PoorLevel = 1;  ///< a triangle that is poor by so many limits is poor
  bool AreLengthsPoor = true; ///< and so is one with an edge out of the band
  std::vector<PoorTriangle> Poor;
  std::vector<Id> Corners;             ///< of the poor triangles
  std::vector<Id> Moved;               ///< since the poor triangles were looked for
  std::vector<std::uint8_t> IsSettled; ///< of a vertex: its star is as it was when it was looked at
};

} // namespace biting

#endif
