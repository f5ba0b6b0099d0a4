// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingMeasuredMesh_h
#define BitingMeasuredMesh_h

#include "../../Kernel/Quality/Quality.h"
#include "../../Kernel/Quality/TriangleLinks.h"
#include "../../vtkBitingCompat.h" // for the ABI namespace
#include "../Drawing/FacesFromDataSet.h"

#include <string> // for texts
#include <vector> // for values

VTK_ABI_NAMESPACE_BEGIN
class vtkDataSet;
class vtkTable;
VTK_ABI_NAMESPACE_END

namespace biting
{

/// The triangles of a dataset, the spacing that they are compared with, and what they are worth.
struct MeasuredMesh
{
  PlanarFaces Faces;
  TriangleLinks Links;
  std::vector<double> Spacing;       ///< at each vertex, NaN where none is given
  std::vector<double> MiddleSpacing; ///< at the middle of each edge; empty without a source
  bool HasSpacing = false;
  double GivenLipschitz = 0.0;
  double UsedLipschitz = 0.0;
  MeshQuality Quality;
  std::vector<double> Angles;
  std::vector<double> RelativeLengths;

  MeshView View() const
  {
    return { this->Faces.Points, this->Spacing, this->Faces.Corners, this->Links.Neighbors,
      this->MiddleSpacing.empty() ? nullptr : &this->MiddleSpacing };
  }
};

/// `input`, of which `mesh` was read, with its measures as arrays and figures; NaN where there is
/// nothing to measure.
void WriteMeasures(const MeasuredMesh& mesh, vtkDataSet* input, vtkDataSet* output);

/// How angles, and with a spacing conformity and lengths, are spread.
void WriteHistograms(const MeasuredMesh& mesh, int bins, vtkTable* output);

/// What users are told of triangles that are no good mesh: without area, turned, overlapping. One
/// text for each kind.
std::vector<std::string> WarningsOfTriangles(const PlanarFaces& faces, const TriangleLinks& links);

/// The same of points that no triangle uses, of that many; empty where there are none.
std::string WarningOfUnusedPoints(const PlanarFaces& faces, vtkIdType numberOfPoints);

/// The same of points at one place.
std::string WarningOfRepeatedPoints(const PlanarFaces& faces);

} // namespace biting

#endif
