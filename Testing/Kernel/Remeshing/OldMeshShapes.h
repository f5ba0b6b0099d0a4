// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingOldMeshShapes_h
#define BitingOldMeshShapes_h

#include "../Support/MeshShapes.h"
#include "Remeshing/OldMesh.h"

namespace biting
{

/// Six triangles about a point, all edges of length 1.
inline RemeshInput Hexagon()
{
  RemeshInput input;
  input.Points = RegularPolygon({ 0.0, 0.0 }, 1.0, 6);
  input.Points.push_back({ 0.0, 0.0 });
  for (Id k = 0; k < 6; ++k)
  {
    input.Corners.insert(input.Corners.end(), { 6, k, (k + 1) % 6 });
  }
  input.Rounding = 1e-15;
  return input;
}

} // namespace biting

#endif
