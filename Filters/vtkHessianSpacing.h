// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @class   vtkHessianSpacing
 * @brief   the spacing that a solution asks for, from its second derivatives
 *
 * vtkHessianSpacing makes the paper's numerical spacing (section 2.1) of a scalar that is known at
 * the points of a dataset: short edges where it bends, long ones where it is nearly linear. Its
 * output is ready to be the spacing source of vtkBitingMesher: solve on a mesh, make the spacing,
 * mesh again.
 *
 * @par Method:
 * At each point the quadratic polynomial is fitted, by least squares, to the values at the points
 * of the cells around it; where these are too few or lie badly, as at corners, the next cells are
 * added, up to four rings or 64 points. Its second derivatives are the Hessian, and lambda is their
 * largest absolute eigenvalue. Then f = sqrt(ErrorTolerance / lambda), within the bounds
 * MinimumSpacing and MaximumSpacing. The fit is exact for quadratics, also at the boundary, and
 * also on stretched meshes; it never looks across a hole or a slit.
 *
 * @par What ErrorTolerance means:
 * On an edge of length h the linear interpolant of the scalar is off by at most lambda h^2 / 8, so
 * with edges of length f by ErrorTolerance / 8; inside of an equilateral triangle by ErrorTolerance
 * / 6, and by lambda R^2 / 2 inside of any that fits in a circle of radius R. Quadratics reach
 * these bounds. They hold as far as the recovered lambda is that of the scalar: inside of a layer
 * that the given mesh does not resolve it is too small, and a second turn of the loop finds more.
 *
 * @par Input:
 * Any vtkDataSet whose cells are linear faces in one plane of space: triangles, quads, polygons,
 * pixels of an image. Lines and vertices are passed over, so are hidden and ghost cells. The scalar
 * is the point array that SetInputArrayToProcess(0, 0, 0, POINTS, name) names, one component;
 * default: the active scalars.
 *
 * @par Output:
 * The input with all of its arrays, and with these. Point data: `Spacing` (double, f > 0, in units
 * of the coordinates), `HessianNorm` (double, lambda, in units of the scalar by length squared).
 * Both are NaN, which a spacing source understands as "nothing known here", at points that no face
 * uses and where the scalar is not finite. HessianNorm is NaN also where the points around do not
 * determine a quadratic (a channel with only two rows of points); f is there what the largest
 * lambda of the points around, ring by ring, makes it, and NaN where faces lead to none (cells that
 * share no points). Field data: `ErrorTolerance` (the one that was used).
 *
 * @par Messages:
 * Warnings, with how many: points without a finite scalar, points without a Hessian. Errors, with
 * empty output: a cell that is neither face nor line nor vertex, coordinates that are not finite or
 * above 1e70, points farther than 1e-6 of the size from one plane, no scalar, parameters out of
 * range, no point with a Hessian. An empty input gives an empty output and no message; so does an
 * abort.
 * After an error GetErrorCode() is vtkErrorCode::UserError; the pipeline goes on, with an empty
 * output.
 *
 * @par Ranks:
 * The pieces are gathered on the first rank, which has the output; points and cells come in the
 * order of global ids where there are some, else in that of ranks. The values at a place are those
 * of one rank to the last bit, as they do not depend on the order of points and cells.
 *
 * @par Cost:
 * O(n log n), about 0.25 kB a point. One thread.
 *
 * @par Sources:
 * "Generate good triangular meshes, conforming to control spacing requirements" (the follow-up of
 * X.-Y. Li, S.-H. Teng, A. Ungor, "Biting: advancing front meets sphere packing", 2000), section
 * 2.1. Fitting polynomials over patches: Z. Zhang, A. Naga, "A new finite element gradient recovery
 * method: superconvergence property", 2005.
 */

#ifndef vtkHessianSpacing_h
#define vtkHessianSpacing_h

#include "vtkBitingCompat.h"        // for the ABI namespace
#include "vtkBitingFiltersModule.h" // for the export macro
#include "vtkDataSetAlgorithm.h"

VTK_ABI_NAMESPACE_BEGIN

class VTKBITINGFILTERS_EXPORT vtkHessianSpacing : public vtkDataSetAlgorithm
{
public:
  static vtkHessianSpacing* New();
  vtkTypeMacro(vtkHessianSpacing, vtkDataSetAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// What x and y are.
  enum CoordinatesType
  {
    PLANE = 0,
    LONGITUDE_LATITUDE = 1
  };

  ///@{
  /**
   * Eight times the error that linear interpolation may have along an edge, in units of the scalar,
   * >= 0. A quarter of it halves the edges. 0 (default): 1 % of the range of the scalar. Negative
   * or not finite: an error.
   */
  vtkSetMacro(ErrorTolerance, double);
  vtkGetMacro(ErrorTolerance, double);
  ///@}

  ///@{
  /**
   * The spacing is raised to at least this, in units of the coordinates, >= 0. 0 (default): no
   * bound. Negative, not finite, or above MaximumSpacing: an error.
   */
  vtkSetMacro(MinimumSpacing, double);
  vtkGetMacro(MinimumSpacing, double);
  ///@}

  ///@{
  /**
   * The spacing is lowered to at most this, in units of the coordinates, >= 0; it is that where the
   * scalar is linear. 0 (default): the diagonal of the bounding box, or MinimumSpacing where that
   * is larger. Negative or not finite: an error.
   */
  vtkSetMacro(MaximumSpacing, double);
  vtkGetMacro(MaximumSpacing, double);
  ///@}

  ///@{
  /**
   * PLANE (default), or LONGITUDE_LATITUDE: x and y are degrees, and spacings metres on a sphere of
   * 6,371,008.8 m: the Hessian is that in the stereographic plane about the middle of the input
   * (vtkBitingMesher), per square metre of the globe.
   */
  vtkSetClampMacro(Coordinates, int, PLANE, LONGITUDE_LATITUDE);
  vtkGetMacro(Coordinates, int);
  void SetCoordinatesToPlane() { this->SetCoordinates(PLANE); }
  void SetCoordinatesToLongitudeLatitude() { this->SetCoordinates(LONGITUDE_LATITUDE); }
  ///@}

protected:
  vtkHessianSpacing();
  ~vtkHessianSpacing() override = default;

  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkHessianSpacing(const vtkHessianSpacing&) = delete;
  void operator=(const vtkHessianSpacing&) = delete;

  class Execution;

  double ErrorTolerance = 0.0;
  double MinimumSpacing = 0.0;
  double MaximumSpacing = 0.0;
  int Coordinates = PLANE;
};
VTK_ABI_NAMESPACE_END

#endif
