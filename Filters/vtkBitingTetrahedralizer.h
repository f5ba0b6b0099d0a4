// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @class   vtkBitingTetrahedralizer
 * @brief   fills what a closed surface encloses with tetrahedra as large as a spacing asks for
 *
 * vtkBitingTetrahedralizer meshes the surface anew as vtkBitingSurfaceMesher does, and bites inward
 * from it: spheres as large as the spacing wants edges to be there, one after the other, first in
 * first out, until nothing is left (X.-Y. Li, S.-H. Teng, A. Uengoer, 2000; with cubes the last
 * section of their follow-up). No bite inside comes into a ball of a boundary triangle, so that all
 * of these are facets of the regular triangulation of the bites. Then vertices move to where the
 * error of interpolation is least (L. Chen, 2004), flips and the removal of edges take slivers
 * away (L. A. Freitag, C. Ollivier-Gooch, 1997), and the vertices of the worst tetrahedra move by
 * trial, those of the boundary along the surface.
 *
 * @par Input 0, the surfaces:
 * As of vtkBitingSurfaceMesher, closed but for holes and cracks none of whose places is farther
 * from the border than f / (4 sqrt(2)): the generalized winding number is clear at f / 4 from the
 * surface then. These are closed, with a warning; cell arrays are those beside. Surfaces that cross
 * are united; else a surface in another one bounds a cavity. With RegionArray closed surfaces
 * enclose the region of their value, and a surface in another one with another value is the wall
 * between two regions. Walls that two regions have, each its own, become one, also where their
 * triangles differ, as in contours of labels (vtkDiscreteMarchingCubes): no vertex moves, regions
 * change by the space between the triangles, and a warning says where. An array of two components
 * has the values on both sides (vtkSurfaceNets3D); the value at the outside is no region. Regions
 * may touch themselves or others at single edges and vertices.
 *
 * @par Input 1, the spacing source (optional), and the spacing f:
 * As of vtkBitingSurfaceMesher, in the whole body; 4 % of the diagonal where nothing is given.
 *
 * @par Output 0, the mesh (vtkUnstructuredGrid):
 * Tetrahedra, all of positive volume. Point data: `Spacing` (f as used), `NearestNeighborDistance`
 * (N: the shortest edge), `Conformity` (min(N/f, f/N)), `BiteOrder`, `VertexKind`
 * (VertexKindType), `OriginalPointId` (of corners; -1: new). Cell data: `RegionId` (numbers of the
 * values of RegionArray, or of bodies), the array RegionArray of these values,
 * `MinimumDihedralAngle`, `MaximumDihedralAngle` (degrees), `RadiusEdgeRatio` (0.612 is best),
 * `AspectRatio` (radii of the circumscribed and of the inscribed sphere; 3 is best). Field data,
 * one value each: `NumberOfVertices`, `NumberOfTetrahedra`, `NumberOfSlivers`,
 * `SmallestDihedralAngle`, `LargestDihedralAngle`, `LargestRadiusEdgeRatio`, `SmallestConformity`,
 * `MeanConformity`, `MeanRelativeLength`, `ShareOfEdgesInBand`, `LargestDeviation` (of the
 * boundary from the surface, in f), `EulerNumber` (of the boundary), `Volume`.
 *
 * @par Output 1, the boundary (vtkPolyData):
 * The facets of the mesh on the surfaces, walls between regions once, with all arrays that output 0
 * of vtkBitingSurfaceMesher has, the cell arrays of the input among them. `RegionId` is that of the
 * tetrahedron `MeshCellId`; point data `MeshPointId`.
 *
 * @par Output 2, bites (only with GenerateBites):
 * A vertex cell each, with `BiteOrder` and `Radius`, of cubes half of the side.
 *
 * @par Output 3, problems:
 * As that of vtkBitingSurfaceMesher.
 *
 * @par Messages:
 * Errors, with empty outputs: those of vtkBitingSurfaceMesher; surfaces that are open. The mesh is
 * checked before it is handed out: all tetrahedra positive, by exact signs, their boundary closed
 * and the surface's, the volume of each region. Empty input: empty outputs.
 *
 * The outputs depend on neither the number of threads nor that of ranks.
 */

#ifndef vtkBitingTetrahedralizer_h
#define vtkBitingTetrahedralizer_h

#include "vtkBitingSpaceMesher.h"

#include "vtkPolyData.h" // for the return value

VTK_ABI_NAMESPACE_BEGIN
class vtkUnstructuredGrid;

class VTKBITINGFILTERS_EXPORT vtkBitingTetrahedralizer : public vtkBitingSpaceMesher
{
public:
  static vtkBitingTetrahedralizer* New();
  vtkTypeMacro(vtkBitingTetrahedralizer, vtkBitingSpaceMesher);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum BiteShapeType
  {
    SPHERE = 0,
    CUBE = 1
  };

  ///@{
  /**
   * The shape of bites inside. SPHERE (default); or CUBE, as in the last section of the paper: with
   * axes of the nearest flat boundary for the first layers, then those of the world.
   */
  vtkSetClampMacro(BiteShape, int, SPHERE, CUBE);
  vtkGetMacro(BiteShape, int);
  void SetBiteShapeToSphere() { this->SetBiteShape(SPHERE); }
  void SetBiteShapeToCube() { this->SetBiteShape(CUBE); }
  ///@}

  ///@{
  /**
   * The biting constant c_b: the radius of a bite inside is c_b f, of cubes half of the side.
   * Without unit, in [0.1, 1]. 0 (default): automatic, so that the mean edge length of the mesh is
   * f. Other values: an error.
   */
  vtkSetMacro(BitingConstant, double);
  vtkGetMacro(BitingConstant, double);
  ///@}

  ///@{
  /**
   * Biting ends after so many bites, >= 1, to see how it goes on; those of the boundary, which is
   * covered in any case, are counted. The tetrahedra are those between the bites until then, and
   * not relaxed. -1 (default): when nothing is left.
   */
  vtkSetMacro(MaximumNumberOfBites, vtkIdType);
  vtkGetMacro(MaximumNumberOfBites, vtkIdType);
  ///@}

  ///@{
  /**
   * The outputs.
   */
  vtkUnstructuredGrid* GetOutput();
  vtkPolyData* GetBoundary() { return this->Superclass::GetOutput(BOUNDARY_EDGES); }
  vtkPolyData* GetBites() { return this->Superclass::GetOutput(BITES); }
  vtkPolyData* GetProblems() { return this->Superclass::GetOutput(PROBLEMS); }
  ///@}

protected:
  vtkBitingTetrahedralizer() = default;
  ~vtkBitingTetrahedralizer() override = default;

  std::unique_ptr<vtkBitingSpaceMesher::Execution> NewExecution() override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;

private:
  vtkBitingTetrahedralizer(const vtkBitingTetrahedralizer&) = delete;
  void operator=(const vtkBitingTetrahedralizer&) = delete;

  class Execution;

  int BiteShape = SPHERE;
  double BitingConstant = 0.0;
  vtkIdType MaximumNumberOfBites = -1;
};
VTK_ABI_NAMESPACE_END

#endif
