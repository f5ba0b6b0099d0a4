// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingEdgeRemoval_h
#define BitingEdgeRemoval_h

#include "CellChange.h"
#include "GroundNormals.h"

#include <algorithm> // for transform
#include <array>     // for tables
#include <cstddef>   // for counts
#include <iterator>  // for begin, end

namespace biting
{

/// Changes of the connections between vertices. Each makes the worst of the tetrahedra that it
/// changes better, and leaves all positive, exactly.
class EdgeRemoval
{
public:
  EdgeRemoval(BodyTets& tets, const GroundNormals& normals)
    : Tets(tets)
    , Normals(normals)
  {
  }

  /// Tries all edges of the cell, then its facets.
  bool Improve(Id cell);

  /// Takes an edge away. The link of the edge is a polygon; the tetrahedra about the edge are
  /// replaced by two for each triangle of a triangulation of the polygon: of all the one whose
  /// worst tetrahedron is best, by dynamic programming (G. Klincsek, "Minimal triangulations of
  /// polygonal domains", 1980). 3-2 and 4-4 flips are those of short links.
  /// Of an edge on the boundary the link is open, and its ends become the new edge: a 2-2 flip of
  /// the two facets, which lie in one patch. Of a single tetrahedron nothing is left. At an
  /// interface both sides have such a link.
  /// `edge`: 0 to 5, a row of EdgeCorners.
  bool Remove(Id cell, std::size_t edge);

  /// Inserts a vertex at the middle of the edge, or near it: each cell about the edge becomes two.
  /// Of an edge of the boundary, but of lines: on the ground.
  bool Split(Id cell, std::size_t edge);

  /// The ends of the edge, and the other two corners.
  BodyTets::Tetrahedron CornersFrom(Id cell, std::size_t edge) const
  {
    const BodyTets::Tetrahedron corners = this->Tets.CornersOf(cell);
    BodyTets::Tetrahedron sorted;
    std::transform(std::begin(EdgeCorners[edge]), std::end(EdgeCorners[edge]), sorted.begin(),
      [&corners](int k) { return corners[At(k)]; });
    return sorted;
  }

  /// Takes a facet away: two tetrahedra become three about the edge between their apexes.
  bool Flip(Id slot);

private:
  /// Two ends and the other two corners, which are an even permutation.
  static constexpr int EdgeCorners[6][4] = { { 0, 1, 2, 3 }, { 0, 2, 3, 1 }, { 0, 3, 1, 2 },
    { 1, 2, 0, 3 }, { 1, 3, 2, 0 }, { 2, 3, 0, 1 } };
  static constexpr std::size_t MostOfLink = 9; ///< vertices on a side: up to 8 tetrahedra

  /// The cells about an edge on one side of its facets, or all.
  struct Link
  {
    std::array<Id, MostOfLink> Vertices;
    std::size_t Size; ///< of the vertices
    Id Region;
    std::array<std::array<double, MostOfLink>, MostOfLink> Costs; ///< of polygons from i to j
    std::array<std::array<std::size_t, MostOfLink>, MostOfLink> Apexes;
  };

  bool FindLinks(Id cell, std::size_t edge);
  Id Rewind(Id cell, Id& p, Id& q) const;
  bool Wind(Id first, Id p, Id q);
  bool Triangulate(Link& link, double limit);
  double Cost(const std::array<Id, 3>& triangle, double limit) const;
  void Fill(const Link& link, std::size_t i, std::size_t j);
  bool FlipFacets();
  bool IsInPatch() const;
  bool FillFromInside();
  bool SplitFacets(const GroundPlace& place);
  void FillAround(Id vertex);
  double WorstOfFilling(const Point3& place, double limit);
  bool IsNewEdge(Id p, Id q, bool isInCell);
  bool IsPositive(const BodyTets::Tetrahedron& t) const;

  BodyTets& Tets;
  const GroundNormals& Normals;
  CellChange Change;
  Id A = NoId; ///< the edge is from A to B
  Id B = NoId;
  Id Fresh = NoId;     ///< a vertex that no cell has, for splits
  double Before = 0.0; ///< badness of the worst cell about it
  std::array<Link, 2> Links;
  std::size_t NumberOfLinks = 0;
  std::array<Id, 2> Records; ///< of the facets at the edge
  std::size_t NumberOfRecords = 0;
};

} // namespace biting

#endif
