// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingRandomDrawing_h
#define BitingRandomDrawing_h

#include "Domain/Polylines.h"
#include "FuzzNumbers.h"

namespace biting
{

/// Makes a drawing up: loops, open chains and points on a coarse grid, merged or not, in one piece
/// or in many, of every kind; or faces: grids with gaps, quad trees, loops on top of them; then
/// moves it.
Polylines MakeRandomDrawing(FuzzNumbers& numbers);

} // namespace biting

#endif
