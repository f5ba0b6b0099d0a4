// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingFeatureLines_h
#define BitingFeatureLines_h

#include "SurfaceGround.h"

namespace biting
{

/// Sets Pinches, and Flags by the edges of the surface that are open, of more than two triangles,
/// between two regions, or where it turns by more than `angle` degrees.
void FlagFeatures(
  SurfaceGround& ground, const std::vector<Id>& regions, double angle, Pulse& pulse);

/// Sets Places and Chains by Flags. A corner is a pinch, or a vertex where the number of chains is
/// not two, where chains of two kinds meet, or where a chain turns by more than 50 degrees.
void FindChains(SurfaceGround& ground);

/// Merges the two corners of each chain shorter than a tenth of f as given. The other chains of the
/// corner that goes are continued along that chain, to the corner that stays. A chain that comes
/// back to its corner goes where it is shorter than a tenth of f, or became one shorter than .3 f
/// so; Vanished has that corner if it was no turning line.
void MergeCorners(SurfaceGround& ground);

/// Takes away the flags of chains of turning edges that are shorter than f and end in nothing:
/// noise of scans. Places and Chains follow.
void DropNoise(SurfaceGround& ground);

/// Takes away the flags of chains. Places, Chains and Across follow.
void DropChains(SurfaceGround& ground, const std::vector<Id>& chains, Pulse& pulse);

} // namespace biting

#endif
