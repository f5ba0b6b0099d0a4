// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingMeshWarnings_h
#define BitingMeshWarnings_h

#include "../../Kernel/Quality/TriangleLinks.h"
#include "../Drawing/FacesFromDataSet.h"

#include <string> // for texts
#include <vector> // for lists

namespace biting
{

/// What users are told of triangles that are no good mesh: without area, turned, overlapping. One
/// text for each kind.
std::vector<std::string> WarningsOfTriangles(const PlanarFaces& faces, const TriangleLinks& links);

/// The same of points that no triangle uses, of that many; empty where there are none.
std::string WarningOfUnusedPoints(const PlanarFaces& faces, vtkIdType numberOfPoints);

/// The same of points at one place.
std::string WarningOfRepeatedPoints(const PlanarFaces& faces);

} // namespace biting

#endif
