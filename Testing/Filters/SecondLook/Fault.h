// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef Fault_h
#define Fault_h

namespace second_look
{

/// One thing that a defective kernel would do to the mesh of a square.
enum class Fault
{
  None,
  SwappedCorners,      ///< a triangle turns clockwise
  MissingTriangle,     ///< one in the interior is dropped, and its neighbors know
  DoubledTriangle,     ///< one is there twice, as its own sheet
  MovedVertex,         ///< an interior vertex crosses an edge
  MovedBoundary,       ///< a vertex on the boundary bulges: all triangles stay counterclockwise
  UnlinkedNeighbor,    ///< two triangles forget each other
  OneSidedNeighbor,    ///< one of two triangles forgets the other
  ForgottenConstraint, ///< a boundary edge is not covered by a segment
  ForgottenInterface,  ///< nor is an edge between two triangles
  UnusedVertex,        ///< a vertex without triangle
  UncoveredSegment,    ///< no attempt to triangulate gets a part of a segment into the mesh
  MistakenSegment      ///< relaxation takes an edge on a segment for one of another
};

/// What the faulty sources do next.
extern Fault TheFault;

} // namespace second_look

#endif
