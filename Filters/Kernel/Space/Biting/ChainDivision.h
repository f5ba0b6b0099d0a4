// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingChainDivision_h
#define BitingChainDivision_h

#include "SurfaceBites.h"

namespace biting
{

/// Adds the corners and the vertices of chains, and their pieces. Each chain is divided into pieces
/// of equal integrals of 1/f, closed ones into at least three; of chains with the same two ends all
/// but one into at least two. Where two chains run along each other, .3 to .8 f apart, vertices
/// move along their chain to the middles between the vertices of the other chain, and pieces longer
/// than 1.35 f after that are halved. Law: vertices lie on their chains.
void DivideChains(const SurfaceGround& ground, SurfaceBites& bites, Pulse& pulse);

} // namespace biting

#endif
