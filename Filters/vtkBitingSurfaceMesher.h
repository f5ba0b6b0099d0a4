// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @class   vtkBitingSurfaceMesher
 * @brief   meshes a surface of space anew, with triangles as large as a spacing asks for
 *
 * The triangles that a scanner, a CAD program or a contour leaves are as long and thin as it suits
 * these. vtkBitingSurfaceMesher covers the surface with bites, spheres as large as the spacing
 * wants edges to be there, one after the other, and makes the triangles between their centres: the
 * facets of a regular triangulation of space that the surface cuts in two (Boissonnat and Oudot,
 * 2005; Cheng, Dey and Ramos, 2010). Corners and feature lines come first and stay.
 *
 * @par Input 0, the surface:
 * As that of vtkBitingSurfaceCheck: cells of two dimensions of any dataset, or a composite of such,
 * closed or open. It is welded and oriented as there.
 *
 * @par Input 1, the spacing source (optional):
 * A dataset with a point array of lengths, chosen by SetInputArrayToProcess(1, 1, 0, POINTS, name),
 * `Spacing` by default: an image or cells of three dimensions, interpolated; outside of them, and
 * from surfaces, lines and points, the value of the nearest place.
 *
 * @par The spacing f:
 * The minimum of UniformSpacing and of the source, times SpacingScale, within MinimumSpacing and
 * MaximumSpacing, no steeper than Gradation (along the edges of the cells of the source); 2 % of
 * the diagonal where nothing is given. LimitByFeatureSize caps it by the thickness of the body and
 * of the gaps around it, and by the distance of feature lines, down to a quarter of what is given.
 * The mean edge is as long as f.
 *
 * @par Output 0, the mesh:
 * Triangles, oriented as the surface. Point data: `Spacing` (f as used), `NearestNeighborDistance`
 * (N: the shortest edge), `Conformity` (min(N/f, f/N)), `BiteOrder`,
 * `VertexKind` (VertexKindType), `OriginalPointId` (of corners; -1: new). Cell data: all arrays of
 * the cells of the input, of the triangle below the middle, `OriginalCellId` of it, `RegionId`,
 * `Deviation` (distance of the middle from the surface, in f), `MinimumAngle`, `RadiusEdgeRatio`,
 * `AspectRatio` as vtkBitingMesher has them. Field data, one value each: `NumberOfVertices`,
 * `NumberOfTriangles`, `SmallestAngle`, `MeanConformity`, `LargestDeviation`, `EulerNumber`.
 *
 * @par Output 1, feature edges:
 * Lines of the mesh along features: `EdgeKind` (0: the surface turns there, or RegionArray changes;
 * 1: border; 2: more than two triangles) and point data `MeshPointId`.
 *
 * @par Output 2, bites (only with GenerateBites):
 * A vertex cell each, with `BiteOrder` and `Radius`.
 *
 * @par Output 3, problems:
 * As output 2 of vtkBitingSurfaceCheck, with the kinds of ProblemKindType beside those of there.
 *
 * @par Messages:
 * Errors, with empty outputs: what vtkBitingSurfaceCheck refuses; a surface that crosses itself,
 * is folded, pinched or not orientable; walls or faces too near to each other for f (the place is
 * named); a source without values; too many vertices. The mesh is checked before it is handed out:
 * closed where the input is, each facet within 60 degrees of the surface, the Euler number, the
 * area and the volume of each part, all feature lines there, no self-crossing. Warnings: what was
 * repaired, and feature lines that were given up. Empty input: empty outputs.
 *
 * The outputs depend on neither the number of threads nor that of ranks.
 */

#ifndef vtkBitingSurfaceMesher_h
#define vtkBitingSurfaceMesher_h

#include "vtkBitingAlgorithm.h"

#include <string> // for names

VTK_ABI_NAMESPACE_BEGIN
class VTKBITINGFILTERS_EXPORT vtkBitingSurfaceMesher : public vtkBitingAlgorithm
{
public:
  static vtkBitingSurfaceMesher* New();
  vtkTypeMacro(vtkBitingSurfaceMesher, vtkBitingAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Values of `VertexKind`.
   */
  enum VertexKindType
  {
    CORNER = 0,  ///< where feature lines meet, end or turn
    FEATURE = 1, ///< on a feature line
    SURFACE = 2
  };

  /**
   * Values of `ProblemKind`, beside those of vtkBitingSurfaceCheck.
   */
  enum ProblemKindType
  {
    TOO_THIN = 38,     ///< walls or feature lines too near to each other for f (cell)
    TOO_SHARP = 39,    ///< faces at too small an angle for f (cell)
    LOST_FEATURES = 40 ///< a feature line that is not in the mesh (point)
  };

  ///@{
  /**
   * Edges where the surface turns by more are kept as lines, in degrees, in [0, 180]. Default 40.
   */
  vtkSetClampMacro(FeatureAngle, double, 0.0, 180.0);
  vtkGetMacro(FeatureAngle, double);
  ///@}

  ///@{
  /**
   * How far the mesh may be from the surface where that curves, in f: f is lowered there, down to a
   * quarter. 0: any distance. Default 0.1.
   */
  vtkSetMacro(BoundaryTolerance, double);
  vtkGetMacro(BoundaryTolerance, double);
  ///@}

  ///@{
  /**
   * Vertices of open edges that are nearer to each other become one; relative to the diagonal, in
   * [0, 1). 0 (default): only as near as rounding.
   */
  vtkSetMacro(MergeTolerance, double);
  vtkGetMacro(MergeTolerance, double);
  ///@}

  ///@{
  /**
   * Name of a cell array of input 0: where its value changes there is a feature line, and RegionId
   * numbers its values in the order of the cells. Empty (default): RegionId numbers the parts.
   */
  vtkSetStdStringFromCharMacro(RegionArray);
  vtkGetCharFromStdStringMacro(RegionArray);
  ///@}

protected:
  vtkBitingSurfaceMesher();
  ~vtkBitingSurfaceMesher() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkBitingSurfaceMesher(const vtkBitingSurfaceMesher&) = delete;
  void operator=(const vtkBitingSurfaceMesher&) = delete;

  class Execution;

  double FeatureAngle = 40.0;
  double BoundaryTolerance = 0.1;
  double MergeTolerance = 0.0;
  std::string RegionArray;
};
VTK_ABI_NAMESPACE_END

#endif
