# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause

# The one list of bridge sources, relative to this folder; the module reads it.
set(biting_bridge_sources
  BitesToPolyData.cxx
  BoundaryEdgesToPolyData.cxx
  BoundarySpacing.cxx
  ChosenArray.cxx
  DoubleArray.cxx
  FacesFromDataSet.cxx
  MeshToPolyData.cxx
  MessagesFromProblems.cxx
  MonitorOfFilter.cxx
  PlaneCut.cxx
  PlaneFrame.cxx
  PolylinesFromPolyData.cxx
  ProblemPlaces.cxx
  ProblemsToPolyData.cxx
  QualityArrays.cxx
  SourceSpacing.cxx
  SpacingValues.cxx
  SummaryText.cxx)
