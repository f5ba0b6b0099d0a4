// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingRandomInput_h
#define BitingRandomInput_h

#include "BitingMesh.h"
#include "FuzzNumbers.h"

#include <cstdint> // for counts
#include <iosfwd>  // for the file
#include <string>  // for texts

namespace biting
{

/// One call of the kernel.
struct FuzzCase
{
  Polylines Input;
  BitingMeshOptions Options;
  std::int64_t StopAtCall = -1; ///< the monitor says stop at this call of Advance, counted from 0
};

/// How meshes are cut.
enum class FuzzBlocks
{
  None, ///< not at all
  Small ///< half of the cases, into blocks of 30 to 300 vertices
};

/// Makes a case up. Most drawings are small and lie on a coarse grid, where chains touch, cross,
/// overlap and repeat each other all the time; some are turned, scaled, shifted far away, flattened
/// or shaken by a few ulp. Spacing and options go to the ends of their ranges, and beyond where the
/// kernel promises to refuse.
FuzzCase MakeFuzzCase(FuzzNumbers& numbers, FuzzBlocks blocks = FuzzBlocks::Small);

/// Writes the chains as legacy VTK polygonal data, to be looked at: cell data Kind and Cell.
void WriteLegacyVtk(std::ostream& file, const Polylines& input, const std::string& title);

/// The options that are not default, in one line.
std::string Describe(const FuzzCase& fuzzCase);

} // namespace biting

#endif
