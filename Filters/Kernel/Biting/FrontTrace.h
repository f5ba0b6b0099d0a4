// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingFrontTrace_h
#define BitingFrontTrace_h

#include "../Base/Point.h"
#include "../Base/Pulse.h"
#include "../Domain/Domain.h"
#include "../Domain/DomainLocator.h"
#include "BiteGrid.h"
#include "Bites.h"

#include <vector> // for the pieces

namespace biting
{

/// The front as lines: the border of what the bites have left of the domain. Two points a piece:
/// pieces of bite sides that lie inside the domain and in no other bite, and pieces of the boundary
/// in no bite. Circles are drawn as chords of up to 1/25 of a
/// turn, which are cut at the boundary beside where the circle meets it. To look at; nothing is
/// decided by it. Incomplete on abort.
std::vector<Point2> TraceFront(const Domain& domain, const DomainLocator& locator,
  const Bites& bites, const BiteGrid& grid, Pulse& pulse);

} // namespace biting

#endif
