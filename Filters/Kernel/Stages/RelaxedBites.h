// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingRelaxedBites_h
#define BitingRelaxedBites_h

#include "../Biting/BitingScheme.h"
#include "../Delaunay/Triangulation.h"
#include "../Domain/Domain.h"
#include "../Relaxation/Relaxation.h"
#include "../Spacing/Spacing.h"

#include <string> // for the violation

namespace biting
{

/// Relaxes the triangulation of `bites` (Relaxation/Relaxation.h): its vertices and edges, and the
/// triangles and constraints of `mesh`, are then those of the relaxed mesh. A vertex keeps the
/// number of its bite; one that is new has none.
/// Looks a second time at what relaxation promises of segments: the edges on each must be as long
/// together as before. Returns what is wrong as text, empty where nothing is.
/// Where the monitor asks to stop the result has no meaning.
std::string RelaxBites(const Domain& domain, const Spacing& spacing,
  const RelaxationOptions& options, BitingResult& bites, Triangulation& mesh, Monitor& monitor);

} // namespace biting

#endif
