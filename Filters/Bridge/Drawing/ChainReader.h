// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingChainReader_h
#define BitingChainReader_h

#include "../../Kernel/Base/Pulse.h"
#include "../../Kernel/Domain/Polylines.h"
#include "Drawing.h"

#include <cstdint> // for flags
#include <string>  // for the refusal
#include <vector>  // for the arrays

namespace biting
{

/// Reads the cells of `drawing` into `chains`, but for their points, in the order of the drawing:
/// verts, lines, polygons and strips of polydata, and the cells of other datasets as they come.
/// `regions` has a number for each cell, or is empty; `isUsed` gets 1 for points that chains use.
///
/// Lines are chains of automatic kind; two-dimensional cells are faces, strips a face for each
/// triangle; each point of a vertex cell is an embedded point. A numeric cell array `Kind` of the
/// block decides instead what a line is, and of faces whether they are interfaces (1) or embedded
/// points (2). Left out are hidden and duplicated cells, those with a hidden point, faces of less
/// than three points, and empty cells.
/// Returns why the drawing cannot be read, as text, empty where it can: a cell with a volume or of
/// an unknown kind, one whose points do not exist, more of anything than 32-bit ids can number.
std::string ReadChains(const Drawing& drawing, const std::vector<Id>& regions, Polylines& chains,
  std::vector<std::uint8_t>& isUsed, Pulse& pulse);

} // namespace biting

#endif
