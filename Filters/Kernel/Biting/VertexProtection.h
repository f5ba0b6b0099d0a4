// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingVertexProtection_h
#define BitingVertexProtection_h

#include "BitingState.h"

namespace biting
{

/// The first phase (paper, section 3.1): a bite at each vertex of the domain, which are added as
/// the first vertices of the mesh, turned by the rule of figure 7.
void AddDomainVertices(BitingState& state);
void ProtectVertices(BitingState& state);

} // namespace biting

#endif
