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

/// The triangles of a dataset, the spacing f at their vertices, and their quality.
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

/// Fills `output` with `input`, of which `mesh` was read, and the measures as arrays and figures;
/// NaN at points and cells that are not of the mesh.
void WriteMeasures(const MeasuredMesh& mesh, vtkDataSet* input, vtkDataSet* output);

/// `values` of the things with these ids, as one value for each of `size` things; NaN for the
/// others.
std::vector<double> Spread(
  const std::vector<double>& values, const std::vector<vtkIdType>& ids, vtkIdType size);

/// Adds the histogram of `values` from 0 to `highest` as two columns.
void AddHistogram(const std::vector<double>& values, double highest, int bins,
  const std::string& name, vtkTable* table);

/// Histograms of the angles, and, with a spacing, of conformity and relative lengths.
void WriteHistograms(const MeasuredMesh& mesh, int bins, vtkTable* output);

/// Warnings of triangles without area, of triangles turned against the majority, and of edges with
/// more than two triangles: one text for each kind.
std::vector<std::string> WarningsOfTriangles(const PlanarFaces& faces, const TriangleLinks& links);

/// A warning of points without triangles, given the number of points; empty where there are none.
std::string WarningOfUnusedPoints(const PlanarFaces& faces, vtkIdType numberOfPoints);

/// A warning of points at one place; empty where there are none.
std::string WarningOfRepeatedPoints(const PlanarFaces& faces);

} // namespace biting

#endif
