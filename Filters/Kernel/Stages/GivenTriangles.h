// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingGivenTriangles_h
#define BitingGivenTriangles_h

#include "../Base/Ids.h"
#include "../Base/Monitor.h"
#include "../Biting/BitingScheme.h"
#include "../Delaunay/Triangulation.h"
#include "../Domain/Domain.h"
#include "../Spacing/Spacing.h"

#include <vector> // for the arrays

namespace biting
{

/// Triangles of the input that become triangles of the mesh as they are: the rest of the domain is
/// meshed without them, and they are put back.
struct GivenTriangles
{
  std::vector<Id> Corners; ///< vertices of Whole, counterclockwise

  /// The domain with them. Edges between two of them that are of one region, and on no line, are no
  /// segments of it; their vertices are vertices of it all the same.
  Domain Whole;

  std::vector<Id> Vertices; ///< of Whole, for each of the rest
  std::vector<Id> Segments; ///< the same

  bool IsEmpty() const { return this->Corners.empty(); }
};

/// Takes triangles of `input` out of `domain`: those whose edges are whole segments of it and which
/// have no vertex inside. Of the rest, segments at which one was taken are preserved boundary.
/// Where there are none `domain` stays as it is.
GivenTriangles TakeGivenTriangles(const Polylines& input, Domain& domain, Monitor& monitor);

/// The spacing with the lengths of the preserved segments of `rest`: f is that length there.
SpacingOptions FollowPreserved(SpacingOptions spacing, const Domain& rest, Monitor& monitor);

/// Puts the triangles back: `bites` and `mesh`, which are of the rest, become those of the whole.
/// Regions are numbered by the first segment of the whole on their border. The spacing at vertices
/// that only triangles have is the mean length of their edges.
void PutBackTriangles(const GivenTriangles& given, BitingResult& bites, Triangulation& mesh);

} // namespace biting

#endif
