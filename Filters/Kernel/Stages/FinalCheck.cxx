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

std::string CheckFinalMesh(const FinalCheckInput& input, Monitor& monitor)
{
  const BitingMesh& mesh = input.Mesh;
  PartOfStage checking(monitor, 0.0, MeshCheckEnd);
  MeshCheckInput whole{ mesh.Points, mesh.Corners, mesh.Neighbors, input.Constraints,
    input.Geometry.Area };
  whole.IsDelaunay = input.IsDelaunay;
  const std::string violation = CheckMesh(whole, checking);
  if (!violation.empty() || checking.HasStopped())
  {
    return violation;
  }
  PartOfStage covering(monitor, MeshCheckEnd, 1.0);
  return CheckSegmentCover(input.Geometry,
    { mesh.Points, mesh.Corners, mesh.Neighbors, input.Constraints, input.Segments }, covering);
}

} // namespace biting
