// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @class   vtkBitingSurfaceCheck
 * @brief   says what is wrong with a surface, and where; hands it out repaired and oriented
 *
 * Whoever meshes a body needs a closed surface that does not cross itself, and most surfaces are
 * not quite that. vtkBitingSurfaceCheck looks for each thing that can be wrong, says how many there
 * are and where, and repairs what has one answer only. Nothing else is guessed: an open surface
 * stays open, a crossing one crosses.
 *
 * @par Input 0:
 * Any surface: vtkPolyData with triangles, polygons and strips, other datasets by their cells of
 * two dimensions, or a composite of such, which is one surface. Points may be shared or not. Lines
 * and vertices are passed over, so are hidden and ghost cells. Quadratic cells count with the
 * points on their sides.
 *
 * @par Steps:
 * Points at one place become one vertex. Vertices of edges that are open then, and nearer than the
 * rounding of the type of their coordinates, become one: 8 units of float or double of the largest
 * coordinate, or less. Duplicate triangles go. Triangles whose corners lie on one line go, by an
 * edge flip that changes no place of the surface. Triangles are oriented alike within each shell,
 * closed shells outwards where an even number of closed shells is around them, else inwards.
 * Crossings are found by a tree of boxes. All signs are exact; the only tolerance is the rounding:
 * triangles that meet no deeper only touch.
 *
 * @par Output 0, the surface:
 * Triangles, the points bit for bit and of the type of the input, with all arrays of its points and
 * cells. Point data `OriginalPointId`; cell data `OriginalCellId` and `RegionId` (the part: what
 * hangs together by vertices, from 0 on). Field data, one value each: `NumberOfVertices`,
 * `NumberOfTriangles`, `OpenEdges`, `NonManifoldEdges`, `PinchedVertices`, `Folds`,
 * `SelfCrossings`, `Touches`, `FlatTriangles`, `DuplicateTriangles` (found), `WeldedPoints`,
 * `Parts`, `Cavities` (closed shells inside an odd number of others), `EulerNumber` (vertices -
 * edges + triangles), `Area`, `Volume` (NaN where an edge is open), `SmallestThickness`; and
 * `SmallestThicknessPlace`, three.
 *
 * @par Output 1, feature edges:
 * Lines: edges where the surface turns by more than FeatureAngle, open edges, and edges of more
 * than two triangles. Cell data `EdgeKind` (0, 1, 2 in this order), point data `MeshPointId`.
 *
 * @par Output 2, problems:
 * One vertex cell for each, with `ProblemKind` (ProblemKindType), `IsError` (0: repaired or only
 * noted), `FirstId` and `SecondId` (of the input; -1: none), and `Message`. At most 10,000 of a
 * kind; field data `ProblemCounts` has all.
 *
 * @par Messages:
 * What is wrong is a result, and no message. Errors, with empty outputs: a cell of three dimensions
 * or of higher order, coordinates that are not finite or beyond 1e50. An empty input gives empty
 * outputs and no message; so does an abort.
 *
 * @par What is approximate:
 * The smallest thickness of closed shells, by balls that touch them from inside at two places with
 * opposite normals (within 20 degrees): at the middles of at most 100,000 triangles, evenly taken,
 * and for 4 million tests of a ball with a triangle. Lengths, areas and volumes are rounded.
 * Nesting is that of one vertex; shells that cross each other are not in each other.
 *
 * @par Cost:
 * O(n log n), and the pairs of triangles whose boxes meet; about 3 seconds for a million triangles
 * on one thread. The outputs do not depend on the number of threads.
 */

#ifndef vtkBitingSurfaceCheck_h
#define vtkBitingSurfaceCheck_h

#include "vtkBitingCompat.h"        // for the ABI namespace
#include "vtkBitingFiltersModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"

#include <string> // for the summary

VTK_ABI_NAMESPACE_BEGIN
class VTKBITINGFILTERS_EXPORT vtkBitingSurfaceCheck : public vtkPolyDataAlgorithm
{
public:
  static vtkBitingSurfaceCheck* New();
  vtkTypeMacro(vtkBitingSurfaceCheck, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The values of `ProblemKind`; in brackets, what `FirstId` and `SecondId` number.
   */
  enum ProblemKindType
  {
    FLAT_TRIANGLES = 22,      ///< corners on one line; removed, unless the message says no (cell)
    OPEN_EDGES = 28,          ///< a loop, or a chain between non-manifold edges (point)
    NON_MANIFOLD_EDGES = 29,  ///< of more than two triangles (cell, cell)
    PINCHED_VERTICES = 30,    ///< where several fans of triangles meet (point)
    FOLDS = 31,               ///< neighbors that lie on each other (cell, cell)
    SELF_CROSSINGS = 32,      ///< two triangles deeper in each other than rounding (cell, cell)
    NOT_ORIENTABLE = 33,      ///< a shell with one side only (cell, cell)
    DUPLICATE_TRIANGLES = 34, ///< of the same vertices; removed (cell, cell: the one that stays)
    INCONSISTENT_EDGES = 35,  ///< triangles oriented against each other; turned (cell, cell)
    SURFACE_TOUCHES = 36      ///< two triangles that meet, no deeper than rounding (cell, cell)
  };

  ///@{
  /**
   * The surface has a feature edge where it turns by more than this, in degrees, in [0, 180].
   * Default 40.
   */
  vtkSetClampMacro(FeatureAngle, double, 0.0, 180.0);
  vtkGetMacro(FeatureAngle, double);
  ///@}

  ///@{
  /**
   * Number of threads; 0 (default): as many as the machine has cores.
   */
  vtkSetClampMacro(NumberOfThreads, int, 0, VTK_INT_MAX);
  vtkGetMacro(NumberOfThreads, int);
  ///@}

  /**
   * Outputs 1 and 2.
   */
  vtkPolyData* GetFeatureEdges() { return this->GetOutput(1); }
  vtkPolyData* GetProblems() { return this->GetOutput(2); }

  /**
   * The surface in a few lines, and what is wrong with it; or why nothing could be checked.
   */
  const char* GetSummary() const { return this->Summary.c_str(); }

protected:
  vtkBitingSurfaceCheck();
  ~vtkBitingSurfaceCheck() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkBitingSurfaceCheck(const vtkBitingSurfaceCheck&) = delete;
  void operator=(const vtkBitingSurfaceCheck&) = delete;

  class Execution;

  double FeatureAngle = 40.0;
  int NumberOfThreads = 0;
  std::string Summary;
};
VTK_ABI_NAMESPACE_END

#endif
