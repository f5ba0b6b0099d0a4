// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingQualityArrays_h
#define BitingQualityArrays_h

#include "../../Kernel/Base/Pulse.h"
#include "../../Kernel/Quality/Quality.h"
#include "../../vtkBitingCompat.h" // for the ABI namespace

#include <vector> // for values

VTK_ABI_NAMESPACE_BEGIN
class vtkFieldData;
VTK_ABI_NAMESPACE_END

namespace biting
{

/// Adds `Spacing`, `NearestNeighborDistance` and `Conformity` to point data.
void AddConformityArrays(
  const MeshQuality& quality, const std::vector<double>& spacing, vtkFieldData* data, Pulse& pulse);

/// Adds `MinimumAngle`, `RadiusEdgeRatio` and `AspectRatio` to cell data.
void AddShapeArrays(const MeshQuality& quality, vtkFieldData* data, Pulse& pulse);

/// Adds the numbers of vertices and triangles and the worst shapes, one value each.
void AddShapeSummary(const MeshQuality& quality, vtkFieldData* data);

/// Adds what the whole is worth against the spacing, one value each.
void AddConformitySummary(const MeshQuality& quality, vtkFieldData* data);

} // namespace biting

#endif
