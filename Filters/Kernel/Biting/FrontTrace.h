// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingFrontTrace_h
#define BitingFrontTrace_h

#include "../Base/Point2.h"
#include "../Domain/Domain.h"
#include "../Domain/DomainLocator.h"
#include "BiteGrid.h"
#include "Bites.h"

#include <vector> // for the pieces

namespace biting
{

/// The front as lines: the border of what the bites have left of the domain. Two points a piece:
/// pieces of bite sides that lie inside the domain and in no other bite, and pieces of the boundary
/// in no bite. To look at; nothing is decided by it.
std::vector<Point2> TraceFront(
  const Domain& domain, const DomainLocator& locator, const Bites& bites, const BiteGrid& grid);

} // namespace biting

#endif
