// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingLongEdges_h
#define BitingLongEdges_h

#include "../Base/Ids.h"
#include "../Base/Pulse.h"
#include "DelaunayFlips.h"
#include "MutableMesh.h"
#include "Patch.h"

#include <vector> // for lists

namespace biting
{

/// Splits edges that are too long between vertices that are held: what smoothing cannot mend there,
/// a vertex more may, so that none of them has to go.
class LongEdges
{
public:
  LongEdges(MutableMesh& mesh, DelaunayFlips& flips, Patch& patch)
    : Mesh(mesh)
    , Flips(flips)
    , Surroundings(patch)
  {
  }

  /// Splits inner edges of more than `longest` spacings, the longest first, and smooths around the
  /// new vertices. A split is kept where no triangle near by then is both worse than the worst one
  /// was and beyond `greatestCotangent`, and no edge of the new vertex is shorter than 0.75
  /// spacings. Edges beside vertices with more triangles than a Star holds stay.
  void Split(double longest, double greatestCotangent, Pulse& pulse);

private:
  std::vector<Id> Find(double longest, Pulse& pulse) const;
  bool IsLong(Id edge, double longest) const;
  bool TrySplit(Id edge, double limit);
  void SmoothAround(Id vertex);
  double WorstOf(const std::vector<Id>& vertices) const;
  bool HasShortEdge(Id vertex) const;

  MutableMesh& Mesh;
  DelaunayFlips& Flips;
  Patch& Surroundings;
};

} // namespace biting

#endif
