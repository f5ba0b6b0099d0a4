// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @class   vtkBitingSpaceMesher
 * @brief   what vtkBitingSurfaceMesher and vtkBitingTetrahedralizer have in common
 *
 * Both read a surface and a spacing in space, and mesh: the one the surface, the other what it
 * encloses. The class documentation of vtkBitingSurfaceMesher says what is read.
 */

#ifndef vtkBitingSpaceMesher_h
#define vtkBitingSpaceMesher_h

#include "vtkBitingAlgorithm.h"

#include <memory> // for an execution
#include <string> // for names

VTK_ABI_NAMESPACE_BEGIN
class VTKBITINGFILTERS_EXPORT vtkBitingSpaceMesher : public vtkBitingAlgorithm
{
public:
  vtkAbstractTypeMacro(vtkBitingSpaceMesher, vtkBitingAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Values of `VertexKind`.
   */
  enum VertexKindType
  {
    CORNER = 0,  ///< where feature lines meet, end or turn
    FEATURE = 1, ///< on a feature line
    SURFACE = 2,
    INSIDE = 3 ///< of vtkBitingTetrahedralizer
  };

  /**
   * Values of `ProblemKind`, beside those of vtkBitingSurfaceCheck.
   */
  enum ProblemKindType
  {
    TOO_THIN = 38,        ///< walls or feature lines too near to each other for f (cell)
    TOO_SHARP = 39,       ///< faces at too small an angle for f (cell)
    LOST_FEATURES = 40,   ///< a feature that the mesh cuts off or leaves out (point)
    CLOSED_HOLES = 41,    ///< of vtkBitingTetrahedralizer: a hole that was closed (point)
    SMALL_CROSSINGS = 42, ///< a crossing or fold too small to be seen (cell, cell)
    UNITED_SURFACES = 43  ///< a crossing of surfaces that were united (cell, cell)
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
   * How far the mesh may be from the surface where that curves, in f: f goes down to a quarter
   * there, of the surface mesher to a sixteenth where that turns by 69 degrees within a triangle.
   * Triangles farther away than f / 4, and than twice this, are told. 0: any distance. Default 0.1.
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
  class Execution; // vtkBitingSpaceMesherExecution.h

  vtkBitingSpaceMesher();
  ~vtkBitingSpaceMesher() override = default;

  /**
   * One execution of this filter.
   */
  virtual std::unique_ptr<Execution> NewExecution() = 0;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkBitingSpaceMesher(const vtkBitingSpaceMesher&) = delete;
  void operator=(const vtkBitingSpaceMesher&) = delete;

  double FeatureAngle = 40.0;
  double BoundaryTolerance = 0.1;
  double MergeTolerance = 0.0;
  std::string RegionArray;
};
VTK_ABI_NAMESPACE_END

#endif
