// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingSimplificationOracle_h
#define BitingSimplificationOracle_h

#include "RandomInput.h"
#include "Simplification/Simplification.h"

#include <string> // for the violation

namespace biting
{

/// What a simplified drawing must be, told without any help of what made it, by comparing all with
/// all and by exact signs of its own:
/// - its vertices are vertices of the drawing, and embedded points are all there;
/// - each segment stands for a path through vertices that went and end two segments of a kind; each
///   of them lies within the tolerance of the segment; every path has its segment, none twice;
/// - segments meet at common ends only;
/// - each vertex lies on the same side of the boundary of every other piece as before;
/// - what is left out are closed chains smaller than asked for.
/// Returns the first violation, empty where there is none, or where the drawing is large.
std::string FindSimplificationViolation(const Domain& before, const SimplifiedDomain& after,
  const SimplificationOptions& options, const std::function<double(const Point2&)>& spacing);

/// Judges the simplification of a case, whatever became of its mesh; by the uniform spacing of the
/// case, or one that is linear in place where there are other sources.
std::string JudgeSimplification(const FuzzCase& fuzzCase);

/// Whether the simplified drawing of the case is known as lines: its spacing is uniform and no
/// crossing made a vertex. Then `lines` are these, with points and cells of the input.
bool ReadSimplified(const FuzzCase& fuzzCase, Polylines& lines);

} // namespace biting

#endif
