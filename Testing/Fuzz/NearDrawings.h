// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingNearDrawings_h
#define BitingNearDrawings_h

#include "Oracle.h"

namespace biting
{

/// A drawing that nearly meets itself, and what is meant by it. Its own angles are 10 degrees or
/// more.
struct NearCase
{
  FuzzCase Case;
  double Area = 0.0;         ///< of the domain that is meant
  double Slack = 0.0;        ///< by how much the gaps may change it
  bool MayBeRefused = false; ///< outlines that do not close
};

/// Outlines that do not close, with a hole; interfaces that end beside a side, a corner or each
/// other; neighbors of a map, as faces or as loops, with borders that differ; holes beside each
/// other. Gaps are 1e-15 to 1e-1 of the spacing. Some are turned, scaled, far away, or of floats.
NearCase MakeNearCase(FuzzNumbers& numbers);

/// The laws of near misses:
/// - without an error, the area is the one that is meant; only an outline may be refused;
/// - no mesh has an angle below 1 degree without a word;
/// - the MergeTolerance that a near miss names joins it.
FuzzOutcome RunNearCase(const NearCase& nearCase);

} // namespace biting

#endif
