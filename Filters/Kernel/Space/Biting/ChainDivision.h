// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingChainDivision_h
#define BitingChainDivision_h

#include "SurfaceBites.h"

namespace biting
{

/// Adds the corners and the vertices of chains, and their pieces. Each chain is divided into pieces
/// of equal integrals of 1/f, closed ones into at least three, and where chains have the same ends
/// all but one into at least two.
void DivideChains(const SurfaceGround& ground, SurfaceBites& bites, Pulse& pulse);

} // namespace biting

#endif
