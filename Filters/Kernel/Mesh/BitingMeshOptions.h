// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingMeshOptions_h
#define BitingMeshOptions_h

#include "../Base/Ids.h"
#include "../Biting/Bites.h"
#include "../Biting/FrontOrder.h" // for FrontOrder
#include "../Domain/Domain.h"
#include "../Simplification/Simplification.h"
#include "../Spacing/Spacing.h"

#include <cstdint>    // for limits
#include <functional> // for cracks
#include <vector>     // for translations

namespace biting
{

/// What the user asks of a mesh.
struct BitingMeshOptions
{
  DomainOptions Domain;
  SpacingOptions Spacing;

  /// By the spacing before the limit by feature size, which then sees the simplified drawing.
  /// Without effect where the boundary is preserved, but for the loops that are left out.
  SimplificationOptions Simplification;

  /// Sides that one of them maps onto each other are divided alike (Domain/PeriodicSides.h).
  std::vector<Point2> PeriodicTranslations;

  /// Which input cells are cracks: the mesh is cut along their interfaces
  /// (Stages/MeshAssembly.h). May be empty. With it, with translations, and with
  /// DomainOptions::KeepCellEdges no crew shares the mesh.
  std::function<bool(Id)> Opens;

  /// True: f is capped by the local feature size of the domain (SpacingOptions::Features, which is
  /// replaced). Without effect where the boundary is preserved.
  bool LimitByFeatureSize = true;
  int CellsAcross = 1; ///< with it, at least 1: FeatureSource::CellsAcross

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
  /// of FollowSegments (Stages/PreservedSpacing.h). Repairs of the input still make vertices where
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

} // namespace biting

#endif
