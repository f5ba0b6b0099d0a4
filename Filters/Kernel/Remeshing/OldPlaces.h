// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingOldPlaces_h
#define BitingOldPlaces_h

#include "../Base/Ids.h"
#include "../Base/Point.h"
#include "../Base/Pulse.h"
#include "OldMesh.h"

#include <array>  // for weights
#include <vector> // for the arrays

namespace biting
{

/// A place in an old triangle: the sum of its corners, each times its weight. Weights are not
/// negative, their sum is 1.
struct OldPlace
{
  Id Triangle = NoId;
  std::array<double, 3> Weights{ 1.0, 0.0, 0.0 };
};

/// The triangle among `triangles` of the mesh, at least one, that holds each of `places`; for those
/// that none holds, by rounding or where the boundary moved, the nearest place on their free edges.
/// Cost about O(n), and O(log m) for m free edges for each place that none holds.
std::vector<OldPlace> FindOldPlaces(const OldMesh& mesh, const std::vector<Id>& triangles,
  const std::vector<Point2>& places, Pulse& pulse);

} // namespace biting

#endif
