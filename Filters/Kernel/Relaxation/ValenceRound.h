// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingValenceRound_h
#define BitingValenceRound_h

#include "../Base/Ids.h"
#include "../Base/Pulse.h"
#include "DelaunayMesh.h"

#include <cstdint> // for locks
#include <limits>  // for infinity
#include <utility> // for swap
#include <vector>  // for the candidates

namespace biting
{

// The change of the sum of squared excesses (MutableMesh::Excess) of the vertices that an operation
// touches: negative where their numbers of triangles come nearer to the ideal ones.

inline double ChangeOfSquaredExcess(double excess, double change)
{
  return change * (2.0 * excess + change);
}

/// The change by the collapse of an edge; infinite where both of its ends are fixed.
inline double ValenceChangeOfCollapse(const MutableMesh& mesh, Id edge)
{
  Id kept = mesh.Origin(edge);
  Id gone = mesh.Target(edge);
  if (mesh.Freedoms[gone] < mesh.Freedoms[kept])
  {
    std::swap(kept, gone);
  }
  if (mesh.Freedoms[gone] == Freedom::Fixed)
  {
    return std::numeric_limits<double>::infinity();
  }
  const Id twin = mesh.Twins[edge];
  const double sides = twin == NoId ? 1.0 : 2.0;
  const double goneExcess = mesh.Excess(gone);
  const double change = ChangeOfSquaredExcess(mesh.Excess(kept), mesh.Degrees[gone] - 2.0 * sides) -
    goneExcess * goneExcess + ChangeOfSquaredExcess(mesh.Excess(mesh.Corners[edge]), -1.0);
  return twin == NoId ? change
                      : change + ChangeOfSquaredExcess(mesh.Excess(mesh.Corners[twin]), -1.0);
}

/// The change by the split of an edge.
inline double ValenceChangeOfSplit(const MutableMesh& mesh, Id edge)
{
  const Id twin = mesh.Twins[edge];
  const double excess = twin == NoId ? -1.0 : -2.0; // of the vertex between the ends
  const double change =
    excess * excess + ChangeOfSquaredExcess(mesh.Excess(mesh.Corners[edge]), 1.0);
  return twin == NoId ? change
                      : change + ChangeOfSquaredExcess(mesh.Excess(mesh.Corners[twin]), 1.0);
}

/// Collapses and splits edges where vertices have too many or too few triangles, or edges are too
/// short or too long.
///
/// An operation is scored by the change of the sum of squared excesses (see MutableMesh::Excess)
/// of the vertices it touches, plus 12 (l - 0.67 - s) for a collapse and 12 (1.28 + s - l) for a
/// split of an edge of l spacings, where s = clamp(5 (1 - mean of l), -0.1, 0.1). For parts of
/// segments (SegmentParts.h): no collapse leaves a part that is too long, and the second term of
/// the split of a part that is too long counts five times. Operations with a negative score are
/// done, the lowest first, each vertex at most once; then the vertices nearby are smoothed. No
/// operation is done that would leave a triangle with an angle below 20 degrees that is worse than
/// the worst one around it before.
class ValenceRound
{
public:
  explicit ValenceRound(DelaunayMesh& mesh)
    : Mesh(mesh)
  {
  }

  /// One round; the `rings` around each operation are smoothed.
  void Run(int rings, Pulse& pulse);

private:
  struct Candidate
  {
    double Score;
    Id Edge;
    bool IsCollapse;
  };

  void ChooseShift(Pulse& pulse);
  void FindCandidates(Pulse& pulse);
  void AddCandidates(Id edge);
  double Score(Id edge, bool isCollapse, double length) const;
  double CollapseScore(Id edge, double length) const;
  double SplitScore(Id edge, double length) const;
  bool IsLocked(Id edge) const;
  Id Perform(const Candidate& candidate);
  void Lock(Id vertex);
  void SmoothAround(Id vertex, int rings);

  DelaunayMesh& Mesh;
  double Shift = 0.0; ///< of the lengths at which edges collapse and split
  std::vector<Candidate> Candidates;
  std::vector<std::uint8_t> Locks; ///< one a vertex
};

} // namespace biting

#endif
