# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause

# The one list of bridge sources, relative to this folder; the module reads it.
set(biting_bridge_sources
  BitesToPolyData.cxx
  BoundaryEdgesToPolyData.cxx
  BoundarySpacing.cxx
  CellShapes.cxx
  ChainReader.cxx
  ChosenArray.cxx
  CoordinateRounding.cxx
  DataTree.cxx
  DomainMembership.cxx
  DoubleArray.cxx
  Drawing.cxx
  FacesFromDataSet.cxx
  FilterRun.cxx
  MeshFromPieces.cxx
  MeshPieces.cxx
  MeshToPolyData.cxx
  MessagesFromProblems.cxx
  MonitorOfFilter.cxx
  PieceBytes.cxx
  PieceTransfer.cxx
  PlaneCut.cxx
  PlaneFrame.cxx
  PolylinesFromPolyData.cxx
  ProblemPlaces.cxx
  ProblemsToPolyData.cxx
  ProducedEdges.cxx
  QualityArrays.cxx
  Ranks.cxx
  RegionNumbers.cxx
  RemeshInputFromDataSet.cxx
  RemeshedData.cxx
  SourceBorder.cxx
  SourceCells.cxx
  SourceCover.cxx
  SourceData.cxx
  SourceOrder.cxx
  SourceSpacing.cxx
  SpacingValues.cxx
  StructuredFromPieces.cxx
  SummaryText.cxx
  TagComparison.cxx
  ThreadsOfVtk.cxx
  WholeFromPieces.cxx)
