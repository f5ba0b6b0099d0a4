// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingOracle_h
#define BitingOracle_h

#include "RandomInput.h"

#include <string> // for the violation

namespace biting
{

enum class Verdict
{
  Mesh,         ///< valid, nothing to tell
  RepairedMesh, ///< valid, and the user was told of repairs
  Refusal,      ///< one error, no mesh
  Aborted,
  Violation ///< the kernel broke a promise
};

struct FuzzOutcome
{
  Verdict Kind = Verdict::Violation;
  std::string Violation; ///< which promise, empty where none
  bool IsOfBlocks = false;
};

/// Runs the kernel on the case and judges what it says and makes:
/// - a mesh, a refusal, or what stopping leaves, and nothing between these;
/// - a mesh is what JudgedMesh.h says, of a simplified drawing where that is known;
/// - a simplified drawing is what SimplificationOracle.h says;
/// - a refusal has one kind of error, ids that exist, a place, and no mesh;
/// - a drawing that encloses a safe area is not refused for want of a closed loop;
/// - with Repair, a drawing is resolved, unless most of it is smaller than rounding;
/// - without Repair, nothing that Repair resolves is in a mesh;
/// - faces that overlap in part are told of, faces that share no area are not;
/// - only a monitor that said stop makes an abort, and it is heard;
/// - progress is a number in [0, 1];
/// - no mesh of blocks was given up;
/// - for some of the cases: the same again, on three threads, is the same to the last bit; and so
///   is, but for the factor, all of it magnified by a power of two: nothing depends on the unit of
///   length.
FuzzOutcome RunFuzzCase(const FuzzCase& fuzzCase);

} // namespace biting

#endif
