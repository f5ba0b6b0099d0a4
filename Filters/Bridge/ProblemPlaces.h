// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingProblemPlaces_h
#define BitingProblemPlaces_h

#include "../Kernel/Base/Problem.h"
#include "PlaneFrame.h"
#include "PolylinesFromPolyData.h"

#include "vtkType.h" // for vtkIdType

#include <array>   // for counts
#include <cstdint> // for counts
#include <string>  // for messages
#include <vector>  // for places

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
  std::string Message;
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

/// Whether what RepairInput mends is mended, or left as it is and an error.
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

} // namespace biting

#endif
