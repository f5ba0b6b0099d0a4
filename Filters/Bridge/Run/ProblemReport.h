// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingProblemReport_h
#define BitingProblemReport_h

#include "../../Kernel/Base/Problem.h"
#include "../../vtkBitingCompat.h" // for the ABI namespace
#include "../Drawing/PlaneFrame.h"
#include "../Drawing/PolylinesFromDrawing.h"

#include "vtkType.h" // for vtkIdType

#include <array>      // for counts
#include <cstdint>    // for counts
#include <functional> // for questions
#include <string>     // for messages
#include <vector>     // for places

VTK_ABI_NAMESPACE_BEGIN
class vtkPolyData;
VTK_ABI_NAMESPACE_END

namespace biting
{

/// One thing that is wrong, where it can be seen.
struct ProblemPlace
{
  ProblemCode Kind = ProblemCode::CheckFailed;
  bool IsError = true; ///< refused, not repaired
  vtkIdType FirstId = -1;
  vtkIdType SecondId = -1;
  Point3 Place{ 0.0, 0.0, 0.0 }; ///< in space, finite
  std::string Message; ///< one line: its kind in words, its ids, its place, and its figures
};

/// All kinds but Aborted, which is none of the input.
constexpr std::size_t NumberOfProblemKinds = static_cast<std::size_t>(ProblemCode::Aborted);

/// What is wrong with the input, as points in space.
struct ProblemPlaces
{
  std::vector<ProblemPlace> Places;
  std::array<std::int64_t, NumberOfProblemKinds>
    Counts{}; ///< by kind, also of those without a place
};

/// Whether defects that RepairInput mends are repaired, or left and errors.
enum class RepairPolicy
{
  Repaired,
  Left
};

/// Adds those of `problems`, which are of `input`.
///
/// Problems without ids have no place: the too large mesh, the loop that nothing closes. A point of
/// the input stands where it is, bit for bit. One that is not finite stands at the finite point
/// before it in its chain, or after it, where there is no such; else nowhere.
void AddPlaces(const ProblemList& problems, const PlanarInput& input, RepairPolicy policy,
  ProblemPlaces& places);

/// The same of problems of space, whose places are what they are.
void AddPlacesInSpace(const ProblemList& problems, ProblemPlaces& places);

/// Fills `output` with one vertex cell a place, and the arrays that the documentation of
/// vtkBitingMesher lists for output 3.
void ProblemsToPolyData(const ProblemPlaces& problems, vtkPolyData* output);

/// How many ids a message shows before it only counts.
constexpr std::size_t ShownIds = 5;

/// The problems of `group` as one message: what, how many, which, where in space, and what was done
/// or can be done.
std::string MessageFrom(const ProblemGroup& group, const PlanarInput& input);

/// The same of problems of space.
std::string MessageInSpace(const ProblemGroup& group);

/// The kind of the problems, and their number.
std::string HeadingOf(const ProblemGroup& group);

/// That of the error `group` among `problems`: where no loop is closed, and points were merged that
/// are too near to each other, it says that, too.
std::string RefusalFrom(
  const ProblemGroup& group, const ProblemList& problems, const PlanarInput& input);

/// What was found wrong and left as it is, when repair is switched off: the message for
/// ProblemCode::NotResolved, with the facts of every repair that would have been needed.
std::string NotResolvedMessageFrom(const ProblemList& problems, const PlanarInput& input);

/// The ids of `problem` that number points and cells of the input, in the order that its code
/// states.
std::vector<std::int64_t> ShownIdsOf(const Problem& problem);

/// In space; where the problem is at a point of the input, exactly there.
Point3 PlaceInSpace(const Problem& problem, const PlanarInput& input);

/// "(x, y, z)".
std::string PlaceText(const Point3& place);

/// "<what> (n): point 3 at (x, y, z), .... <advice>" of the `points` among `coordinates` (three a
/// point) that are not as `isGood` wants; empty where all are.
std::string RefuseWhereNot(const std::function<bool(const double*)>& isGood,
  const std::vector<Id>& points, const double* coordinates, const std::string& what,
  const std::string& advice);

/// `first` joined by commas; where `count` is larger, "... and 37 more".
std::string ListText(const std::vector<std::string>& first, std::int64_t count);

} // namespace biting

#endif
