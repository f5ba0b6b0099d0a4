# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause

# The one list of bridge sources, relative to this folder; the module reads it.
set(biting_bridge_sources
  Data/Arrays.cxx
  Data/CarriedArrays.cxx
  Data/Cells.cxx
  Data/DataTree.cxx
  Drawing/BoundarySpacing.cxx
  Drawing/CellTags.cxx
  Drawing/CoordinateRounding.cxx
  Drawing/Drawing.cxx
  Drawing/FacesFromDataSet.cxx
  Drawing/Globe.cxx
  Drawing/PlaneFrame.cxx
  Drawing/PolylinesFromDrawing.cxx
  Drawing/RemeshInputFromDataSet.cxx
  Drawing/SurfaceFromDrawing.cxx
  Mesh/BitesToPolyData.cxx
  Mesh/BitingBodyToGrid.cxx
  Mesh/DividedQuads.cxx
  Mesh/MeasuredMesh.cxx
  Mesh/MeasuredTetrahedra.cxx
  Mesh/MeshFileFromDataSet.cxx
  Mesh/MeshToPolyData.cxx
  Mesh/RemeshedData.cxx
  Mesh/SurfaceToPolyData.cxx
  Ranks/RankCrew.cxx
  Ranks/Ranks.cxx
  Ranks/WholeFromPieces.cxx
  Run/FilterRun.cxx
  Run/MonitorOfFilter.cxx
  Run/ProblemReport.cxx
  Run/SummaryText.cxx
  Source/DomainMembership.cxx
  Source/SourceCells.cxx
  Source/SourceCover.cxx
  Source/SourceData.cxx
  Source/SourceSpacing.cxx
  Source/SpaceSpacing.cxx
  Source/SpacingValues.cxx
  Source/TransferredArrays.cxx)
