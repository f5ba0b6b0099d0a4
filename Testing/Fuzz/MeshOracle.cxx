// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "MeshOracle.h"

#include "DrawingOracle.h"
#include "FiguresOracle.h"
#include "TopologyOracle.h"

namespace biting
{

std::string FindMeshViolation(
  const BitingMesh& mesh, const Polylines& input, const BitingMeshOptions& options)
{
  JudgedMesh judged(mesh, input, options);
  (void)(TopologyOracle(judged).Holds() && DrawingOracle(judged).Holds() &&
    FiguresOracle(judged).Holds());
  return judged.Violation;
}

} // namespace biting
