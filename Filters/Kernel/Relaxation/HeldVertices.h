// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingHeldVertices_h
#define BitingHeldVertices_h

#include "../Base/Ids.h"
#include "../Base/Point.h"
#include "../Base/Pulse.h"
#include "MutableMesh.h"
#include "Relaxation.h"
#include "Star.h"

#include <array>   // for corners
#include <cstddef> // for places
#include <cstdint> // for flags
#include <vector>  // for the lists

namespace biting
{

/// Vertices that stay where they are unless a triangle or an edge at them is beyond the limits of
/// HoldOptions: then they are released, which makes them free. Released vertices return to their
/// places where the limits are met with them there.
class HeldVertices
{
public:
  /// Holds those of the `hold.Count` vertices of the input from `first` on that are free; `origins`
  /// tells which one of the input each vertex of the mesh is.
  HeldVertices(
    const HoldOptions& hold, Id first, const std::vector<Id>& origins, MutableMesh& mesh);

  /// Releases vertices of triangles and edges beyond the limits, and returns them. Each such
  /// triangle or edge is a complaint about its held vertices, and releases at most one of them: the
  /// one with the most complaints. A vertex marked as last goes only where no other vertex of the
  /// complaint is held.
  std::vector<Id> ReleaseThoseInTheWay(Pulse& pulse);

  /// A vertex that was released.
  struct Released
  {
    Id Vertex;
    Point2 Home; ///< where it was held
  };
  const std::vector<Released>& ListReleased() const { return this->WereReleased; }

  /// Puts the vertex back where it was and holds it there, if the objective of its star is then
  /// within the limit of angles, or less than it is now, and its edges are within theirs. Returns
  /// whether it did; the mesh may not be Delaunay around it then.
  bool TakeBack(const Released& released);

  /// Moves a free vertex to the place that HoldOptions::FindPlace names near it, and holds it
  /// there, if the objective of its star is then within GreatestCotangentAtPlaces and its edges are
  /// within their limits. Returns whether it did, as TakeBack does.
  bool HoldAtPlaceNear(Id vertex);

private:
  /// A triangle or an edge beyond the limits: its held vertices, NoId in place of the others.
  using Complaint = std::array<Id, 3>;

  struct Candidate
  {
    bool IsLast;
    Id Count; ///< of its complaints
    Id Vertex;
    std::size_t About; ///< one of them
  };

  void LookAt(Id triangle);
  bool IsWithinLimits(double squaredLength) const;
  bool IsFree(Id vertex) const
  {
    return this->Mesh.IsAlive(vertex) && this->Mesh.Freedoms[vertex] == Freedom::Free;
  }
  bool HoldAt(Id vertex, const Point2& place, double greatestCotangent, bool orIfBetter);
  bool AreLengthsWithinLimits(Id vertex, const Star& star, const Point2& place) const;
  void Complain(Complaint vertices);
  std::vector<Id> Choose() const;
  std::vector<Candidate> ListCandidates() const;

  const HoldOptions& Hold;
  MutableMesh& Mesh;
  std::vector<std::uint8_t> IsHeld; ///< one a vertex
  std::vector<std::uint8_t> IsLast; ///< one a vertex
  std::vector<Id> Counts;           ///< of complaints: one a vertex
  std::vector<Complaint> Complaints;
  std::vector<Released> WereReleased;
};

} // namespace biting

#endif
