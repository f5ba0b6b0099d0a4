// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @class   vtkBitingRemesher
 * @brief   refines and coarsens a triangle mesh to a new spacing, and leaves what fits
 *
 * vtkBitingRemesher changes a mesh where it must, and leaves it where it can: what stays needs no
 * interpolation. Where the mean length of the edges at each vertex is within [0.75, 1.3] f, with f
 * the spacing that is wanted now, vertices and triangles stay bit for bit. Elsewhere, and in two
 * `Rings` of triangles around, the mesh is made anew (paper, section 7): old vertices bite first,
 * where bites leave a part uncovered new vertices fill it as in vtkBitingMesher, and where old
 * vertices are too dense only those stay that no bite of an earlier one holds. What is made anew is
 * triangulated by Delaunay's criterion and relaxed, around the vertices that are kept.
 *
 * @par Input 0, the mesh:
 * vtkPolyData or vtkUnstructuredGrid of linear triangles in one plane of space, from any program,
 * of any orientation. Linear quads become two triangles each, by the diagonal with the larger
 * smallest angle, with a warning. Hidden and ghost cells are left out; points that no triangle uses
 * go where anything changes. Points of free edges at the same place are made one, with a warning;
 * and where points lie between the ends of a free edge, as where a coarse mesh and a fine one lie
 * side by side, its triangle is divided there, with a warning.
 *
 * @par What stays a line:
 * - Free edges are boundary; edges between triangles whose `RegionArray` differs are interfaces.
 * - Edges on lines carry tags: the lines of the dataset at input 2, as output 1 of vtkBitingMesher,
 *   or, where nothing is connected, the lines among the cells of the mesh. Their points are those
 *   of the mesh at the same coordinates, bit for bit; lines that are no edges are dropped, with a
 *   warning.
 * - Vertices whose point array `VertexKind` is 3 (embedded) stay, and those that `FrozenArray`
 *   marks.
 * The polygon of all these lines stays exactly what it was, but for rounding: where it is straight
 * and its tags and regions are the same on both sides, vertices may go and come. On a boundary that
 * bends at every vertex none goes, however coarse f is, and LimitByFeatureSize then keeps f near it
 * as fine as its edges; unless BoundaryTolerance lets it move.
 *
 * @par The spacing f:
 * That of the source at input 1, of the array that SetInputArrayToProcess(1, 1, 0, POINTS, name)
 * names, as vtkBitingMesher takes it. Where nothing is connected there and UniformSpacing is 0,
 * that of the point array of the mesh that SetInputArrayToProcess(0, 0, 0, POINTS, name) names,
 * linear on its triangles. An array named `Spacing` is taken where no other name was set. Then
 * SpacingScale, MinimumSpacing, MaximumSpacing, LimitByFeatureSize and Gradation, as in
 * vtkBitingMesher; the array of the mesh is limited to the gradation by distances through the mesh,
 * which takes far less time than a source does.
 *
 * @par Outputs:
 * 0, Mesh: with the arrays of vtkBitingMesher::MESH. `OriginalPointId` is the point of the input at
 * a vertex that is kept, else -1; the cell array `OriginalCellId` the cell of a triangle that is
 * unchanged, else -1. `RegionId` numbers the faces (triangles connected without an interface) from
 * 0; where it is the RegionArray and TransferData is on, it has the values of the input. With
 * TransferData the other arrays of the input besides. Field data also:
 * `KeptVertices`, `RemovedVertices`, `NewVertices`, `KeptTriangles`. Old vertices come first, in
 * their order, then new ones; so do triangles. Where nothing changes it is the input, points, cells
 * and arrays, with `OriginalPointId`, `OriginalCellId` and these counts added or replaced.
 * 1, Boundary Edges, 2, Bites (of what was made anew) and 3, Problems: as those of vtkBitingMesher.
 * An edge that no line covers has -1 as `OriginalCellId`, and NaN, -1, 0 where there is no -1, or
 * an empty text in the arrays of lines.
 *
 * @par Transfer:
 * At kept vertices and unchanged triangles values are what they were. Real point arrays are linear
 * in the old triangle at a new vertex, or at the nearest place of the old mesh where a boundary
 * has moved; of all others its nearest corner counts. New triangles have the cell data of the old
 * one at their middle, and of RegionArray that of their region.
 *
 * @par Messages:
 * As those of vtkBitingMesher. Triangles without area, as contours and clips leave them, and such
 * that rounding turned over are mended with a warning (FLAT_TRIANGLES): the triangle across their
 * longest side is divided, also where it is frozen; at the rim they go, unless all around them is
 * frozen. Errors, with empty outputs: edges of more than two triangles, triangles
 * folded or lying on top of others, none that has an area (BAD_TRIANGLES, with cells and places in
 * output 3 where they are known); a cell that is neither triangle, quad, line nor vertex;
 * coordinates that are not finite or not in one plane; no spacing, or one that is not positive;
 * more vertices than MaximumNumberOfVertices. Empty input: empty outputs, no message; so does an
 * abort. After an error GetErrorCode() is vtkErrorCode::UserError; the pipeline goes on.
 *
 * @par Guarantees and limits:
 * Each old vertex that is kept has its coordinates bit for bit; the area is covered as before; the
 * same input gives the same bytes. The mesh is constrained Delaunay within what is made anew;
 * unchanged triangles are as they are. The measures of the finished
 * mesh run on NumberOfThreads, the rest on one.
 * Cost: one pass over the mesh, about 0.3 us a vertex, and that of meshing what changes.
 *
 * @par Source:
 * "Generate good triangular meshes, conforming to control spacing requirements" (the follow-up of
 * X.-Y. Li, S.-H. Teng, A. Ungor, "Biting: advancing front meets sphere packing", 2000), section 7.
 *
 * @sa
 * vtkBitingMesher vtkHessianSpacing vtkMeshConformity
 */

#ifndef vtkBitingRemesher_h
#define vtkBitingRemesher_h

#include "vtkBitingAlgorithm.h"
#include "vtkBitingCompat.h"        // for the ABI namespace
#include "vtkBitingFiltersModule.h" // for the export macro

#include <string> // for names

VTK_ABI_NAMESPACE_BEGIN
class vtkDataObject;

class VTKBITINGFILTERS_EXPORT vtkBitingRemesher : public vtkBitingAlgorithm
{
public:
  static vtkBitingRemesher* New();
  vtkTypeMacro(vtkBitingRemesher, vtkBitingAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum EdgePolicyType
  {
    FREE = 0,
    SPLIT_ONLY = 1,
    FROZEN = 2
  };

  enum PreferenceType
  {
    KEEPING = 0,
    BALANCED = 1,
    SHAPE = 2
  };

  ///@{
  /**
   * Dataset with lines on edges of the mesh, and their tags as cell arrays (port 2). Optional: the
   * lines of the mesh count else, or, where it has none, the boundary edges of the vtkBitingMesher,
   * vtkBitingRemesher or vtkBitingMeshReader from which it comes, as long as its points are theirs.
   */
  void SetTaggedLinesData(vtkDataObject* lines);
  void SetTaggedLinesConnection(vtkAlgorithmOutput* lines);
  ///@}

  ///@{
  /**
   * What boundary, interfaces and tagged edges may do: FREE (default): vertices on their straight
   * parts go and come; SPLIT_ONLY: none goes; FROZEN: none goes and none comes, each edge stays.
   */
  vtkSetClampMacro(EdgePolicy, int, FREE, FROZEN);
  vtkGetMacro(EdgePolicy, int);
  void SetEdgePolicyToFree() { this->SetEdgePolicy(FREE); }
  void SetEdgePolicyToSplitOnly() { this->SetEdgePolicy(SPLIT_ONLY); }
  void SetEdgePolicyToFrozen() { this->SetEdgePolicy(FROZEN); }
  ///@}

  ///@{
  /**
   * How far boundary, interfaces and tagged edges may be from those of the input, in units of f at
   * the place before the limit by feature size, >= 0; sensible from 0.05 to 0.5. 0 (default):
   * exactly where they were. Above 0, with EdgePolicy FREE, vertices also go where they bend, where
   * these are closer than f asks for; f is limited by the features of what is left. Where the mesh
   * is refined new vertices lie on the old edges. Both paths are within that distance of one
   * another; topology, what stays, sharp angles and cost are as of vtkBitingMesher's
   * BoundaryTolerance; ends of tags, vertices that are frozen and the rim of what is unchanged
   * stay. The distance is from the mesh at hand: in a loop that coarsens again and again it adds
   * up. A change of the area by more than 5 % is a warning. New vertices outside of the old mesh
   * have the data of the nearest place in it. Negative or not finite: an error.
   */
  vtkSetMacro(BoundaryTolerance, double);
  vtkGetMacro(BoundaryTolerance, double);
  ///@}

  ///@{
  /**
   * With BoundaryTolerance: corners where edges turn by this or more stay where they are; in
   * degrees, as vtkBitingMesher's CornerAngle, seen from four tolerances away. >= 0; default 30.
   * Negative or not finite: an error.
   */
  vtkSetMacro(FeatureAngle, double);
  vtkGetMacro(FeatureAngle, double);
  ///@}

  ///@{
  /**
   * What counts where keeping vertices and good shapes exclude each other. KEEPING: all vertices
   * stay that can; where they would leave an angle below 28 degrees one is released, and comes
   * back if there is a place for it in the end. BALANCED (default): so they are below 36 degrees,
   * and beside an edge beyond [0.71, 1.41] f; all are where the mesh is too coarse for f by 1.4
   * to 1.6, or does not fit where f changes from one of its vertices to the next, and what is left
   * in narrow strips along these. In the end a new vertex takes the place of an old one near it,
   * and is that vertex, where all angles beside it stay above 42.5 degrees (KEEPING: 35). SHAPE:
   * more are released, and no place is taken.
   */
  vtkSetClampMacro(Preference, int, KEEPING, SHAPE);
  vtkGetMacro(Preference, int);
  void SetPreferenceToKeeping() { this->SetPreference(KEEPING); }
  void SetPreferenceToBalanced() { this->SetPreference(BALANCED); }
  void SetPreferenceToShape() { this->SetPreference(SHAPE); }
  ///@}

  ///@{
  /**
   * The name of a cell array of the mesh, of numbers or texts: where it differs is an interface.
   * The default `RegionId` may be missing, any other name may not. Empty or "None": all is one
   * region.
   */
  vtkSetStdStringFromCharMacro(RegionArray);
  vtkGetCharFromStdStringMacro(RegionArray);
  ///@}

  ///@{
  /**
   * The name of a point or cell array of numbers, or of one each: vertices, triangles and tagged
   * edges where it is not 0 stay as they are; that of tagged edges is among the cell arrays of
   * their lines, whether these are cells of the mesh or connected. An edge is not frozen by its
   * ends: it may be divided between them. A triangle beside one without area, which has to be
   * divided for that, does not stay. Empty or "None" (default): none. A name that does not exist is
   * an error.
   */
  vtkSetStdStringFromCharMacro(FrozenArray);
  vtkGetCharFromStdStringMacro(FrozenArray);
  ///@}

  ///@{
  /**
   * On (default): the arrays of the input are carried to the mesh. Off: it has our own ones only.
   */
  vtkSetMacro(TransferData, bool);
  vtkGetMacro(TransferData, bool);
  vtkBooleanMacro(TransferData, bool);
  ///@}

  ///@{
  /**
   * How many rings of triangles around what must change are made anew with it, >= 0. Default 2.
   * More: shapes get better along the rim, and fewer vertices are kept.
   */
  vtkSetClampMacro(Rings, int, 0, VTK_INT_MAX);
  vtkGetMacro(Rings, int);
  ///@}

  ///@{
  /**
   * On: all that is not frozen is made anew and relaxed, also where the spacing has not changed;
   * all vertices but those of edges and embedded ones count as new. For a mesh with poor triangles.
   * Off (default): what fits stays.
   */
  vtkSetMacro(RelaxAll, bool);
  vtkGetMacro(RelaxAll, bool);
  vtkBooleanMacro(RelaxAll, bool);
  ///@}

protected:
  vtkBitingRemesher();
  ~vtkBitingRemesher() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkBitingRemesher(const vtkBitingRemesher&) = delete;
  void operator=(const vtkBitingRemesher&) = delete;

  class Execution;

  int EdgePolicy = FREE;
  double BoundaryTolerance = 0.0;
  double FeatureAngle = 30.0;
  int Preference = BALANCED;
  std::string RegionArray = "RegionId";
  std::string FrozenArray;
  bool TransferData = true;
  int Rings = 2;
  bool RelaxAll = false;
};
VTK_ABI_NAMESPACE_END

#endif
