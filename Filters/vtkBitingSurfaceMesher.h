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
 * Triangles, oriented as the surface; shared walls of regions, as of contours of labels, are there
 * once, turned away from the region that comes first. Point data: `Spacing` (f as used),
 * `NearestNeighborDistance` (N: the shortest edge), `Conformity` (min(N/f, f/N)), `BiteOrder`,
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
 * Errors, with empty outputs: what vtkBitingSurfaceCheck refuses, but for closed surfaces without
 * RegionArray that cross or fold (they become the union, with a warning, where it is clear; what is
 * below f / 3 is cut out); walls or faces too near to each other for f; a source without values;
 * too many vertices. The mesh is checked before it is handed out: closed where the input is, each
 * facet within 60 degrees of the surface, the Euler number, the area and the volume of each part,
 * all feature lines there, no self-crossing. Warnings: what was repaired; fins and holes too small
 * for f, feature lines that were given up, and edges too sharp for f that were cut off, where
 * facets may turn by more and points of the surface be up to 1.5 f away. Empty input: no outputs.
 *
 * The outputs depend on neither the number of threads nor that of ranks.
 */

#ifndef vtkBitingSurfaceMesher_h
#define vtkBitingSurfaceMesher_h

#include "vtkBitingSpaceMesher.h"

VTK_ABI_NAMESPACE_BEGIN
class VTKBITINGFILTERS_EXPORT vtkBitingSurfaceMesher : public vtkBitingSpaceMesher
{
public:
  static vtkBitingSurfaceMesher* New();
  vtkTypeMacro(vtkBitingSurfaceMesher, vtkBitingSpaceMesher);

protected:
  vtkBitingSurfaceMesher() = default;
  ~vtkBitingSurfaceMesher() override = default;

  std::unique_ptr<vtkBitingSpaceMesher::Execution> NewExecution() override;

private:
  vtkBitingSurfaceMesher(const vtkBitingSurfaceMesher&) = delete;
  void operator=(const vtkBitingSurfaceMesher&) = delete;

  class Execution;
};
VTK_ABI_NAMESPACE_END

#endif
