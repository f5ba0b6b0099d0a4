// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingMeshOfBites_h
#define BitingMeshOfBites_h

#include "../Base/Ids.h"
#include "../Base/Point.h"
#include "../Biting/Bites.h"
#include "../Quality/Quality.h"

#include <cstdint> // for flags
#include <memory>  // for the border
#include <string>  // for the violation
#include <vector>  // for the arrays

namespace biting
{

enum class VertexKind : std::uint8_t
{
  Input = 0,
  Boundary = 1, ///< new, on a boundary or interface segment
  Interior = 2,
  Embedded = 3
};

/// Of a mesh that members of a crew share: where what one of them has is in the whole. Vertices and
/// triangles have the order of the whole.
struct MeshPiece
{
  bool IsPart = false; ///< false: the mesh is whole, and nothing follows
  std::vector<std::int64_t> PointIds;
  std::vector<std::int64_t> TriangleIds;
  std::vector<std::uint8_t>
    ForeignPoints;                  ///< 1: another member, before this one, has it as its own
  std::vector<std::uint8_t> Levels; ///< of triangles: 0 for its own; those of others are ghosts
};

/// A mesh with all that is handed out with it.
struct BitingMesh
{
  // Vertices.
  std::vector<Point2> Points;
  std::vector<double> Spacing;
  std::vector<Id> BiteOrders; ///< NoId: biting was stopped before, or relaxation made the vertex
  std::vector<VertexKind> Kinds;
  std::vector<Id> OriginalPoints; ///< input point id, NoId = new

  /// One list for each of BitingMeshOptions::PeriodicTranslations: the vertex that the translation,
  /// or its inverse, maps each vertex onto; NoId where there is none.
  std::vector<std::vector<Id>> Partners;

  // Triangles, counterclockwise; Neighbors as in Triangulation.
  std::vector<Id> Corners;
  std::vector<Id> Neighbors;
  std::vector<Id> Regions;

  // Mesh edges that cover boundary and interfaces.
  std::vector<Id> EdgeStarts;
  std::vector<Id> EdgeEnds;
  std::vector<Id> EdgeCells; ///< input cell
  std::vector<std::uint8_t> EdgeIsBoundary;

  MeshPiece Piece;

  /// Where the mesh is a piece, on the first member: the edges of the whole, over vertices of their
  /// own (Points, OriginalPoints, Piece.PointIds); the piece has none.
  std::shared_ptr<const BitingMesh> Border;

  MeshQuality Quality; ///< of a piece: arrays of its own; on the first member figures of the whole
  double GivenLipschitz = 0.0;         ///< of the spacing as given
  double UsedLipschitz = 0.0;          ///< of the spacing as used, over the edges of the mesh
  Id NumberOfSharpCornerTriangles = 0; ///< poor only because the input is (SharpSectors.h)

  Id RemovedVertices = 0;   ///< of the input's chains (SimplificationOptions::Tolerance)
  Id LeftOutLoops = 0;      ///< (SimplificationOptions::MinimumLoopSize)
  double LeftOutArea = 0.0; ///< that they enclose
  double ShareOfDrawing =
    0.0; ///< of the vertices: those that only the drawing asks for (FineDrawing.h)

  Id NumberOfBlocks = 1;

  /// Why the mesh is of one block though the domain was cut: what the check said of the mesh of
  /// several blocks, or that two of its vertices are at one place. Empty: nothing was wrong.
  std::string BlocksViolation;

  // Only with KeepBites.
  biting::Bites Bites;
  std::vector<Point2> Front; ///< two points a piece of the front that is left
};

} // namespace biting

#endif
