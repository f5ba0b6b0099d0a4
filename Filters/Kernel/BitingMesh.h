// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingMesh_h
#define BitingMesh_h

#include "Base/Crew.h"
#include "Base/Ids.h"
#include "Base/Monitor.h"
#include "Base/MostVertices.h"
#include "Base/Point2.h"
#include "Base/Problem.h"
#include "Biting/Bites.h"
#include "Biting/CandidateQueue.h" // for FrontOrder
#include "Blocks/CutTree.h"
#include "Domain/Domain.h"
#include "Domain/Polylines.h"
#include "Quality/Quality.h"
#include "Simplification/Simplification.h"
#include "Spacing/Spacing.h"

#include <cstdint> // for limits
#include <memory>  // for the border
#include <vector>  // for the arrays

namespace biting
{

struct BitingMeshOptions
{
  DomainOptions Domain;
  SpacingOptions Spacing;

  /// By the spacing before the limit by feature size, which then sees the simplified drawing.
  /// Without effect where the boundary is preserved, but for the loops that are left out.
  SimplificationOptions Simplification;

  /// True: f is capped by the local feature size of the domain (SpacingOptions::Features, which is
  /// replaced). Without effect where the boundary is preserved.
  bool LimitByFeatureSize = true;

  double BitingConstant = 0.0; ///< c_b in [0.1, 1]; 0 = automatic: mean edge length = f
  biting::BiteShape BiteShape = biting::BiteShape::Square;
  biting::Placement Placement = biting::Placement::Bisectors;
  FrontOrder Order = FrontOrder::Layers;
  std::int64_t MaximumNumberOfBites = -1; ///< -1 = until the front is empty
  std::int64_t MaximumNumberOfVertices = 20000000;
  double Phi = 1.0; ///< of the phi-Delaunay criterion, (0, 1]; relaxed meshes are Delaunay anyway

  /// True: vertices are moved, added and removed until triangles and lengths are good
  /// (Relaxation/Relaxation.h). False: the mesh of the bites. It is that, too, where
  /// MaximumNumberOfBites is set.
  bool Relaxation = true;

  /// True: no vertex is added on segments; each is one edge of the mesh. The spacing is then that
  /// of FollowSegments (Meshing/PreservedSpacing.h). Repairs of the input still make vertices where
  /// segments meet.
  bool PreserveBoundary = false;

  /// How many vertices a block is expected to have, roughly, where the mesh has at least twice as
  /// many: then the domain is cut, and blocks are meshed by themselves, on all threads of the
  /// monitor (Blocks/BlockMesher.h). The mesh depends on this number, but not on that of threads.
  /// With 64000, squares and polygons of 450000 vertices lose at most .15 degrees of the mean
  /// smallest angle; smaller blocks lose more. 0: one block. It is one, too, for the order
  /// LargestY, MaximumNumberOfBites, KeepBites and PreserveBoundary, and without relaxation.
  std::int64_t VerticesPerBlock = 64000;

  /// How many vertices one process may have: numbers of half-edges, eight a vertex, have 32 bits. A
  /// mesh that is spread over the members of a crew may have as many for each, up to some 10^9:
  /// bites are counted in 32 bits, too. Less is for tests.
  std::int64_t MostVerticesOfProcess = MostVerticesInIds;

  /// How many rings of triangles around its own a member of a crew gets, where the mesh is spread.
  int GhostLevels = 0;

  bool KeepBites = false; ///< fill Bites and Front of the mesh
};

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

struct BitingMesh
{
  // Vertices.
  std::vector<Point2> Points;
  std::vector<double> Spacing;
  std::vector<Id> BiteOrders; ///< NoId: biting was stopped before, or relaxation made the vertex
  std::vector<VertexKind> Kinds;
  std::vector<Id> OriginalPoints; ///< input point id, NoId = new

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
  Id NumberOfSharpCornerTriangles = 0; ///< poor only because the input is (SharpCornerTriangles.h)

  Id RemovedVertices = 0;   ///< of the input's chains (SimplificationOptions::Tolerance)
  Id LeftOutLoops = 0;      ///< (SimplificationOptions::MinimumLoopSize)
  double LeftOutArea = 0.0; ///< that they enclose
  double ShareOfDrawing =
    0.0; ///< of the vertices: those that only the drawing asks for (FineDrawing.h)

  Id NumberOfBlocks = 1;
  CutTree Cuts; ///< that made the blocks; without nodes: one block

  /// Why the mesh is of one block though the domain was cut: what the check said of the mesh of
  /// several blocks, or that two of its vertices are at one place. Empty: nothing was wrong.
  std::string BlocksViolation;

  // Only with KeepBites.
  biting::Bites Bites;
  std::vector<Point2> Front; ///< two points a piece of the front that is left
};

/// The way of the data: polylines -> domain -> simplification -> spacing -> biting -> Delaunay ->
/// relaxation -> quality -> mesh.
/// Repairs and refusals are added to `problems`; where it has errors afterwards the mesh is empty.
/// Deterministic: the same input gives the same mesh, bit for bit. Members of a crew call it with
/// the same input and options; where it is meshed in blocks these stay with those that made them,
/// and each gets a piece. The first one calls the others as soon as there are blocks, else never;
/// where it has no piece of several it has the whole. Throws bad_alloc where another is lost.
BitingMesh MakeBitingMesh(const Polylines& input, const BitingMeshOptions& options,
  ProblemList& problems, Monitor& monitor, Crew& crew = NoCrew());

} // namespace biting

#endif
