// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingSpokes_h
#define BitingSpokes_h

#include "../Base/IdLists.h"
#include "../Base/Point.h"
#include "../Domain/Domain.h"

#include <vector> // for the arrays

namespace biting
{

/// A segment as seen from one of its ends.
struct Spoke
{
  Id Segment = NoId;
  Point2 End;
  Point2 Direction;        ///< a unit vector
  bool LeftInside = false; ///< the sector counterclockwise of it lies in the domain
};

/// A part of the domain between neighbouring segments of a vertex that enclose less than 60
/// degrees.
struct SharpSector
{
  Spoke First;
  Spoke Last; ///< counterclockwise of it
};

/// The segments about each vertex of a domain. The domain must outlive this object.
class SpokesOfVertices
{
public:
  explicit SpokesOfVertices(const Domain& domain);

  /// Counterclockwise, beginning at the direction of negative x.
  std::vector<Spoke> Around(Id vertex) const;

  /// Counterclockwise. Cheap where the vertex has two segments that are further apart.
  std::vector<SharpSector> SharpSectorsAt(Id vertex) const;

private:
  bool MayBeSharp(Id vertex) const;
  Spoke MakeSpoke(Id vertex, Id segment) const;

  const Domain& Geometry;
  IdLists Segments; ///< at each vertex
};

} // namespace biting

#endif
