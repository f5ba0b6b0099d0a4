// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "FinalCheck.h"

#include "../Base/PartOfStage.h"
#include "../Quality/MeshCheck.h"
#include "SegmentCover.h"

namespace biting
{

namespace
{

constexpr double MeshCheckEnd = 0.95; // of the time

} // namespace

std::string CheckFinalMesh(const Domain& domain, const BitingMesh& mesh,
  const std::vector<Id>& constraints, const std::vector<Id>& segments, Monitor& monitor)
{
  PartOfStage checking(monitor, 0.0, MeshCheckEnd);
  const std::string violation =
    CheckMesh({ mesh.Points, mesh.Corners, mesh.Neighbors, constraints, domain.Area }, checking);
  if (!violation.empty() || checking.HasStopped())
  {
    return violation;
  }
  PartOfStage covering(monitor, MeshCheckEnd, 1.0);
  return CheckSegmentCover(
    domain, { mesh.Points, mesh.Corners, mesh.Neighbors, constraints, segments }, covering);
}

} // namespace biting
