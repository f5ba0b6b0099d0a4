// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @class   vtkMeshConformity
 * @brief   judges a mesh of triangles or tetrahedra: its shapes, and how well it follows a spacing
 *
 * vtkMeshConformity measures a mesh of any origin against the spacing f that was wanted of it: how
 * far each vertex is from the nearest one along its edges, how long each edge is in units of f, how
 * well shaped the triangles are. It measures as vtkBitingMesher measures its own meshes, under the
 * same names.
 *
 * @par Input 0, the mesh:
 * vtkPolyData, or vtkUnstructuredGrid with cells of two dimensions, of linear triangles in one
 * plane of space, whatever their orientation. Linear quads become two triangles each, by the
 * diagonal with the larger smallest angle, with a warning; the output has these. Lines and vertices
 * are passed over, so are hidden and ghost cells. Points that no triangle uses are not measured.
 *
 * @par Tetrahedra:
 * A vtkUnstructuredGrid with linear tetrahedra, of either orientation, is a mesh of space: its
 * cells of two dimensions and less are passed over, and another cell of three dimensions is an
 * error. The spacing is the point array of the mesh, read as below; a source is not used, with a
 * warning. Cell data: `MinimumDihedralAngle`, `MaximumDihedralAngle` (degrees, 70.53 is best; 0 and
 * 180 where a face has no area), `RadiusEdgeRatio` (0.612 is best), `AspectRatio` (radii of the
 * circumscribed and of the inscribed sphere, 3 is best), both infinite where there is no volume.
 * Point data and the figures of the spacing are those below, but for the slopes. Field data:
 * `NumberOfVertices`, `NumberOfTetrahedra`, `NumberOfSlivers` (ratio at most 2, and a dihedral
 * angle below 10 degrees), `SmallestDihedralAngle`, `LargestDihedralAngle`,
 * `LargestRadiusEdgeRatio`. Histograms: `DihedralAngle` (all six of each) in place of `Angle`.
 *
 * @par The spacing:
 * Where a dataset is connected to input 1, the point array of it that SetInputArrayToProcess(1, 1,
 * 0, POINTS, name) names, read as vtkBitingMesher reads its source: interpolated, and outside of it
 * the nearest value of its border. Otherwise the point array of the mesh that
 * SetInputArrayToProcess(0, 0, 0, POINTS, name) names: f at the vertices, linear along edges. An
 * array named `Spacing` is taken where no other name was set. f is not changed: it is not limited
 * in its slope, nor capped. Without a spacing only shapes are measured, with a warning.
 *
 * @par Output 0, the mesh:
 * The input with all of its arrays, of the same type, and with these. Point data, in units of the
 * coordinates: `Spacing` (f), `NearestNeighborDistance` (N, the length of the shortest edge at
 * the vertex); `Conformity` (min(N/f, f/N), the paper's section 2.1, 1 is best). Cell data:
 * `MinimumAngle` (degrees), `RadiusEdgeRatio` (circumradius / shortest edge, 0.577 is best),
 * `AspectRatio` (radii of the smallest containing and the inscribed circle, 2 is best). All are
 * doubles, and NaN at points and cells that are not measured. Field data, one value each:
 * `NumberOfVertices` and `NumberOfTriangles` (that count), `SmallestAngle`,
 * `LargestRadiusEdgeRatio`, `SmallestConformity`, `MeanConformity`, `MeanRelativeLength` and
 * `ShareOfEdgesInBand` (of [1/sqrt(2), sqrt(2)] f, 0 to 1), `GivenLipschitz` (slope of the spacing
 * as given), `UsedLipschitz` (its largest slope along an edge of the mesh).
 * The relative length of an edge is its length divided by f at its middle (the integral of 1/f
 * along it, by the midpoint rule): f of the source there, or the mean of f at its ends.
 *
 * @par Output 1, the histograms:
 * A table with NumberOfBins rows and a pair of columns for each histogram, the middle of the bin
 * and the percentage in it: `Angle` (degrees, 0 to 180) and `AnglePercent` (of all angles),
 * `Conformity` (0 to 1) and `ConformityPercent` (of the vertices), `RelativeLength` (0 to 3, the
 * last bin holds what is above) and `RelativeLengthPercent` (of the edges).
 *
 * @par Messages:
 * Warnings, each with how many, which and where: triangles without area (they have the angle 0 and
 * infinite ratios), triangles that are oriented against the majority (folds), edges of more than
 * two triangles, points at the place of others, unused points. Errors, with empty outputs: a
 * cell that is neither triangle, quad, line nor vertex, coordinates that are not finite or above
 * 1e70, points farther than 1e-6 of the size from one plane, a spacing that is not positive and
 * finite at a vertex. An empty input gives empty outputs and no message; so does an abort.
 * After an error GetErrorCode() is vtkErrorCode::UserError; the pipeline goes on, with empty
 * outputs.
 *
 * @par Ranks:
 * The pieces are gathered on the first rank, which has the output; points and cells come in the
 * order of global ids where there are some, else in that of ranks. The values of points, cells and
 * histograms are those of one rank to the last bit; means are sums in the order of what was
 * gathered, so that their last digits may differ.
 *
 * @par Cost:
 * O(n log n). One thread.
 *
 * @par Sources:
 * "Generate good triangular meshes, conforming to control spacing requirements" (the follow-up of
 * X.-Y. Li, S.-H. Teng, A. Ungor, "Biting: advancing front meets sphere packing", 2000), sections
 * 2.1 and 6: the measures, and the histograms of angles and conformity.
 */

#ifndef vtkMeshConformity_h
#define vtkMeshConformity_h

#include "vtkBitingCompat.h"        // for the ABI namespace
#include "vtkBitingFiltersModule.h" // for the export macro
#include "vtkDataSetAlgorithm.h"

#include <string> // for the summary

VTK_ABI_NAMESPACE_BEGIN
class vtkDataObject;
class vtkTable;

class VTKBITINGFILTERS_EXPORT vtkMeshConformity : public vtkDataSetAlgorithm
{
public:
  static vtkMeshConformity* New();
  vtkTypeMacro(vtkMeshConformity, vtkDataSetAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// What x and y are.
  enum CoordinatesType
  {
    PLANE = 0,
    LONGITUDE_LATITUDE = 1
  };

  ///@{
  /**
   * Dataset with a point array of the spacing (port 1), as data or as a connection. Optional.
   */
  void SetSpacingSourceData(vtkDataObject* source);
  void SetSpacingSourceConnection(vtkAlgorithmOutput* source);
  ///@}

  /**
   * Output 1.
   */
  vtkTable* GetHistograms();

  ///@{
  /**
   * Number of bins of each histogram, in [1, 10000]. Default 60: bins of 3 degrees, of 1/60 in
   * conformity, of 0.05 in relative length.
   */
  vtkSetClampMacro(NumberOfBins, int, 1, 10000);
  vtkGetMacro(NumberOfBins, int);
  ///@}

  ///@{
  /**
   * PLANE (default), or LONGITUDE_LATITUDE: x and y of mesh and source are degrees, spacings and
   * distances metres on a sphere of 6,371,008.8 m, and angles those on the globe, measured in the
   * stereographic plane about the middle of the mesh (vtkBitingMesher). Triangles go the shorter
   * way around the globe. Lengths are taken with the scale at the vertex. Not for tetrahedra.
   */
  vtkSetClampMacro(Coordinates, int, PLANE, LONGITUDE_LATITUDE);
  vtkGetMacro(Coordinates, int);
  void SetCoordinatesToPlane() { this->SetCoordinates(PLANE); }
  void SetCoordinatesToLongitudeLatitude() { this->SetCoordinates(LONGITUDE_LATITUDE); }
  ///@}

  /**
   * The mesh in a few lines: size, time, angles, conformity. Where
   * nothing could be measured, why.
   */
  const char* GetSummary() const { return this->Summary.c_str(); }

protected:
  vtkMeshConformity();
  ~vtkMeshConformity() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkMeshConformity(const vtkMeshConformity&) = delete;
  void operator=(const vtkMeshConformity&) = delete;

  class Execution;

  int NumberOfBins = 60;
  int Coordinates = PLANE;
  std::string Summary;
};
VTK_ABI_NAMESPACE_END

#endif
