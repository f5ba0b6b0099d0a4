// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingMessagesFromProblems_h
#define BitingMessagesFromProblems_h

#include "../Kernel/Base/Problem.h"
#include "PolylinesFromPolyData.h"

#include <cstdint> // for counts
#include <string>  // for texts
#include <vector>  // for lists

namespace biting
{

/// How many ids a message shows before it only counts.
constexpr std::size_t ShownIds = 5;

/// The problems of `group` as one message: what, how many, which, where in space, and what was done
/// or can be done.
std::string MessageFrom(const ProblemGroup& group, const PlanarInput& input);

/// What and how many.
std::string HeadingOf(const ProblemGroup& group);

/// That of the error `group` among `problems`: where no loop is closed, and points were merged that
/// are too near to each other, it says that, too.
std::string RefusalFrom(
  const ProblemGroup& group, const ProblemList& problems, const PlanarInput& input);

/// What was found wrong and left as it is, when repair is switched off: the message for
/// ProblemCode::NotResolved, with the facts of every repair that would have been needed.
std::string NotResolvedMessageFrom(const ProblemList& problems, const PlanarInput& input);

/// One problem as one line: its kind in words, its ids, its place, and its figures.
std::string MessageOfPlace(const Problem& problem, const PlanarInput& input);

/// The same of a problem of space.
std::string MessageInSpace(const Problem& problem);

/// The ids of `problem` that number points and cells of the input, in the order that its code
/// states.
std::vector<std::int64_t> ShownIdsOf(const Problem& problem);

/// In space; where the problem is at a point of the input, exactly there.
Point3 PlaceInSpace(const Problem& problem, const PlanarInput& input);

/// "(x, y, z)".
std::string PlaceText(const Point3& place);

/// `first` joined by commas; where `count` is larger, "... and 37 more".
std::string ListText(const std::vector<std::string>& first, std::int64_t count);

} // namespace biting

#endif
