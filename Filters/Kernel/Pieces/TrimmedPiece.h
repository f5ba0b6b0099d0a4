// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingTrimmedPiece_h
#define BitingTrimmedPiece_h

#include "../Mesh/BitingMesh.h"

namespace biting
{

/// Leaves out the triangles of a piece beyond the ghost level, and vertices that no other triangle
/// uses, with what is measured of them. Neighbors are not kept.
void TrimPiece(int ghostLevels, BitingMesh& mesh);

} // namespace biting

#endif
