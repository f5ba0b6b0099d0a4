# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause

# The one list of kernel sources, relative to this folder; the module and the tests read it.
set(biting_kernel_sources
  Base/Problem.cxx
  Predicates/Predicates.cxx
  Spacing/Spacing.cxx
  Domain/AreaSum.cxx
  Domain/Arrangement.cxx
  Domain/BoundaryComponents.cxx
  Domain/ChainKinds.cxx
  Domain/Domain.cxx
  Domain/DomainCheck.cxx
  Domain/Meetings.cxx
  Domain/Nesting.cxx
  Domain/SegmentTree.cxx
  Domain/VertexGrid.cxx
  Domain/VertexStars.cxx
  Domain/Welding.cxx
  Domain/DomainLocator.cxx
  Biting/BiteGrid.cxx
  Biting/BiteOutline.cxx
  Biting/BitingScheme.cxx
  Biting/CandidateQueue.cxx
  Biting/EdgeDivision.cxx
  Biting/FrontTrace.cxx
  Biting/Orientation.cxx
  Biting/VertexEstimate.cxx
  Delaunay/SpatialOrder.cxx
  Delaunay/Flips.cxx
  Delaunay/Insertion.cxx
  Delaunay/Cavity.cxx
  Delaunay/ConstraintRecovery.cxx
  Delaunay/RegionFill.cxx
  Delaunay/Triangulation.cxx
  Delaunay/TriangulationCheck.cxx
  Quality/MeshCheck.cxx
  Quality/NearestNeighbors.cxx
  Quality/PointTree.cxx
  Quality/Quality.cxx
  BitingMesh.cxx
  Calibration.cxx
  MeshAssembly.cxx)
