// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @class   vtkBitingDelaunay3D
 * @brief   tetrahedra between points: the Delaunay triangulation, which loses no point
 *
 * vtkBitingDelaunay3D connects points of space by tetrahedra whose spheres have no point inside.
 * All decisions are exact signs: the result is a valid triangulation of the convex hull for points
 * on lattices, spheres and planes, for tiny and for far away coordinates.
 *
 * @par Input:
 * Any vtkPointSet. Cells of it are passed over.
 *
 * @par Output:
 * All points of the input, in their order, with all point arrays, and tetrahedra that are
 * oriented positively. Every point is a corner of a tetrahedron, but for duplicates: of points at
 * one place the others are told by a warning; and but for what Alpha leaves out. Where the Delaunay
 * triangulation is not unique, as on lattices, it is still one and the same for the same places, in
 * whatever order they come (O. Devillers, M. Teillaud, 2011).
 *
 * @par Messages:
 * Warnings: duplicates, with ids; points that lie in one plane, on one line or at one place, which
 * make no tetrahedron: the output is empty then. Errors, with an empty output: coordinates that
 * are not finite; more points than ids of 32 bits allow. An empty input gives an empty output and
 * no message; so does an abort. After an error GetErrorCode() is vtkErrorCode::UserError.
 * Coordinates below 1e-50 times the largest are taken as 0.
 *
 * @par Ranks:
 * The pieces are gathered on the first rank, which has the output.
 *
 * @par Cost:
 * O(n log n) for points that are spread in space; one thread. There are inputs with O(n^2)
 * tetrahedra: points on two skew lines.
 *
 * @par Sources:
 * A. Bowyer, "Computing Dirichlet tessellations", D. F. Watson, "Computing the n-dimensional
 * Delaunay tessellation", 1981; N. Amenta, S. Choi, G. Rote, "Incremental constructions con BRIO",
 * 2003; J. R. Shewchuk, "Adaptive precision floating-point arithmetic", 1997.
 */

#ifndef vtkBitingDelaunay3D_h
#define vtkBitingDelaunay3D_h

#include "vtkBitingCompat.h"        // for the ABI namespace
#include "vtkBitingFiltersModule.h" // for the export macro
#include "vtkUnstructuredGridAlgorithm.h"

VTK_ABI_NAMESPACE_BEGIN

class VTKBITINGFILTERS_EXPORT vtkBitingDelaunay3D : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkBitingDelaunay3D* New();
  vtkTypeMacro(vtkBitingDelaunay3D, vtkUnstructuredGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Only tetrahedra whose sphere has at most this radius are put out, in units of the coordinates:
   * the alpha shape's tetrahedra. 0 (default): all, which fill the convex hull. At least 0.
   */
  vtkSetMacro(Alpha, double);
  vtkGetMacro(Alpha, double);
  ///@}

protected:
  vtkBitingDelaunay3D() = default;
  ~vtkBitingDelaunay3D() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkBitingDelaunay3D(const vtkBitingDelaunay3D&) = delete;
  void operator=(const vtkBitingDelaunay3D&) = delete;

  class Execution;

  double Alpha = 0.0;
};
VTK_ABI_NAMESPACE_END

#endif
