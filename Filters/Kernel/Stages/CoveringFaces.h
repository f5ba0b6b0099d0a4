// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingCoveringFaces_h
#define BitingCoveringFaces_h

#include "../Base/BoxTree.h"
#include "../Base/Ids.h"
#include "../Base/Pulse.h"
#include "../Domain/Domain.h"
#include "../Domain/Polylines.h"
#include "../Mesh/BitingMesh.h"

#include <cstdint> // for counts
#include <map>     // for votes
#include <utility> // for pair
#include <vector>  // for faces

namespace biting
{

/// On which face of a drawing each triangle of its mesh lies: that which covers the middle of the
/// triangle, decided exactly. Of several, by DomainRule::Union the last one; else the one with the
/// smallest area (of nested faces the innermost), of equal ones the last. Where none covers it, as
/// beside a simplified outline, the nearest one, of equally near ones the first.
///
/// A connected region of the mesh lies on faces of one class, between which no edge stays: where a
/// simplified interface leaves middles of its triangles to faces of another one, CorrectBy takes
/// the nearest face of the class that most of its triangles have.
///
/// A query costs O(log n) and the edges of the faces around it; the answer is that of a neighbor at
/// hand where no edge is between the two. The chains must outlive this.
class CoveringFaces
{
public:
  CoveringFaces(const Polylines& chains, const DomainOptions& options, Pulse& pulse);

  bool IsEmpty() const { return this->Faces.Items().empty(); } ///< no chain is a face

  /// The chain of each triangle.
  std::vector<Id> FacesOf(const BitingMesh& mesh, Pulse& pulse) const;

  /// The number of triangles by region and class.
  struct Vote
  {
    Id Region;
    Id Class;
    std::int64_t Triangles;
  };
  using Votes = std::vector<Vote>;

  /// Of the triangles that are the piece's own.
  Votes Count(const BitingMesh& mesh, const std::vector<Id>& faces) const;

  /// With the votes of all pieces.
  void CorrectBy(
    const Votes& votes, const BitingMesh& mesh, std::vector<Id>& faces, Pulse& pulse) const;

private:
  struct Face
  {
    biting::Box2 Extent;
    Id Chain;
    double Area;

    const biting::Box2& Box() const { return this->Extent; }
    double Least() const { return 0.0; }
  };

  struct Edge
  {
    Point2 Start; ///< the end to the left
    Point2 End;
    Id Chain;

    biting::Box2 Box() const { return biting::Box2::Around(this->Start, this->End); }
    double Least() const { return 0.0; }
    bool IsAbove(const Point2& place) const;
  };

  static Edge EdgeAt(const Polylines& chains, Id chain, Id place);
  bool IsClear(const Box2& box) const;
  bool Covers(const Face& face, const Point2& place) const;
  bool IsOver(const Face& first, const Face& second) const;
  Id At(const Point2& place) const;
  Id NearestOfClass(const Point2& place, Id wanted) const;
  Id ClassOf(Id chain) const;

  const Polylines& Chains;
  const bool IsUnion;
  const bool AreApart; ///< every face is a class of its own
  BoxTree<Face> Faces;
  BoxTree<Edge> Edges;
};

} // namespace biting

#endif
