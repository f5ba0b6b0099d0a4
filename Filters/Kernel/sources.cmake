# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause

# The one list of kernel sources, relative to this folder; the module and the tests read it.
set(biting_kernel_sources
  Base/Problem.cxx
  Predicates/Predicates.cxx
  Spacing/Spacing.cxx
  Domain/Domain.cxx
  Biting/BiteSquares.cxx
  Delaunay/Triangulation.cxx
  Quality/Quality.cxx
  BitingMesh.cxx)
