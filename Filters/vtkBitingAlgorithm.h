// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @class   vtkBitingAlgorithm
 * @brief   what vtkBitingMesher and vtkBitingRemesher have in common
 *
 * Both make a mesh that follows a spacing f, by bites: the parameters of f, ports, the summary, and
 * how an execution is ended.
 */

#ifndef vtkBitingAlgorithm_h
#define vtkBitingAlgorithm_h

#include "vtkBitingCompat.h"        // for the ABI namespace
#include "vtkBitingFiltersModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"

#include <string> // for the summary

VTK_ABI_NAMESPACE_BEGIN
class vtkDataObject;

class VTKBITINGFILTERS_EXPORT vtkBitingAlgorithm : public vtkPolyDataAlgorithm
{
public:
  vtkAbstractTypeMacro(vtkBitingAlgorithm, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum OutputPort
  {
    MESH = 0,
    BOUNDARY_EDGES = 1,
    BITES = 2,
    PROBLEMS = 3
  };

  ///@{
  /**
   * Dataset with a point array of the spacing (port 1), as data or as a connection. Optional.
   */
  void SetSpacingSourceData(vtkDataObject* source);
  void SetSpacingSourceConnection(vtkAlgorithmOutput* source);
  ///@}

  ///@{
  /**
   * Constant spacing, in units of the coordinates, >= 0. Where other sources give a spacing too,
   * the minimum counts: above all of them it has no effect, and the summary says so. 0 (default):
   * none, or, of vtkBitingMesher, 2 % of the diagonal of the domain's bounding box where nothing
   * else is given. Negative or not finite: an error.
   */
  vtkSetMacro(UniformSpacing, double);
  vtkGetMacro(UniformSpacing, double);
  ///@}

  ///@{
  /**
   * Factor on the whole spacing, without unit, > 0. Default 1. Other values: an error.
   */
  vtkSetMacro(SpacingScale, double);
  vtkGetMacro(SpacingScale, double);
  ///@}

  ///@{
  /**
   * The spacing is raised to at least this, in units of the coordinates, >= 0. Values of arrays
   * that are zero or negative count as this. 0 (default): no bound, and such values are errors.
   * Negative, not finite, or above MaximumSpacing: an error.
   */
  vtkSetMacro(MinimumSpacing, double);
  vtkGetMacro(MinimumSpacing, double);
  ///@}

  ///@{
  /**
   * The spacing is lowered to at most this, in units of the coordinates, >= 0. 0 (default): no
   * bound. Negative or not finite: an error.
   */
  vtkSetMacro(MaximumSpacing, double);
  vtkGetMacro(MaximumSpacing, double);
  ///@}

  ///@{
  /**
   * The largest slope that f may have, without unit and >= 0. Default 0.3; above 0.5 triangles
   * become thin. Where what is given is steeper, or jumps, f is the largest function below it that
   * is not (paper, section 2.1): distances are those of the plane, also across holes. A spacing
   * that is given on the boundary grows inwards with this slope. 0: f is as given, boundary values
   * grow with the largest slope that they have themselves, but not from the smallest to the largest
   * one within less than an edge. Negative or not finite: an error.
   */
  vtkSetMacro(Gradation, double);
  vtkGetMacro(Gradation, double);
  ///@}

  ///@{
  /**
   * On (default): f is capped by the local feature size on the segments of the input (paper,
   * section 2.1: the control spacing). There it is at most the distance through the domain to the
   * nearest segment or embedded point that does not share an end with it, so that narrow channels
   * get triangles as narrow, but not lowered below a quarter of what is given: a slit far narrower
   * than the spacing gets thin triangles, not a multitude of them. With BoundaryTolerance, where
   * long segments run along slits, it may also go down to 1.4 times the shortest of the input's
   * segments there: triangles no finer than without a tolerance, and as good. And it is at most
   * 1.4 times the length of the segment, which is an edge of the mesh in any case, so that short
   * segments have good triangles too, some hundred each; but not lowered below 1.2e-7 of what is
   * given: floats do not tell lengths apart below that. Neither goes below MinimumSpacing. Segments
   * that meet in a sharp angle do not count for each other. From there f grows with the Gradation
   * (0.3 where it is 0). Off: f is what is given, whatever the domain. Without effect where
   * PreserveBoundary is on. vtkBitingRemesher caps f where the mesh is made anew, by distances not
   * below the length of the edges that are there, so that what was capped is not capped again.
   */
  vtkSetMacro(LimitByFeatureSize, bool);
  vtkGetMacro(LimitByFeatureSize, bool);
  vtkBooleanMacro(LimitByFeatureSize, bool);
  ///@}

  ///@{
  /**
   * On (default): the mesh of the bites is relaxed. Edges far too short or too long, and those that
   * vertices have too many or too few of, are collapsed and split; vertices are moved for the mean
   * ratio of their triangles; the worst triangles are improved one by one. New vertices on segments
   * of the input slide along these, and are inserted and removed there, except with
   * PreserveBoundary; vertices and embedded points of the input stay, bit for bit. f is the target
   * of the lengths, and the number of vertices changes by a few percent.
   * Off: vertices are the centres of bites, as in the paper, which is what its theorems are about.
   * So it is also where MaximumNumberOfBites is set. vtkBitingRemesher relaxes what is made anew,
   * around the vertices that are kept.
   */
  vtkSetMacro(Relaxation, bool);
  vtkGetMacro(Relaxation, bool);
  vtkBooleanMacro(Relaxation, bool);
  ///@}

  ///@{
  /**
   * Inputs whose estimated number of vertices is larger are refused before any work is done, with
   * the estimate in the error. >= 1. Default 20 000 000. Whatever it is, a process takes no more
   * than 238 million vertices; several ranks may share a mesh of up to 1070 million.
   */
  vtkSetMacro(MaximumNumberOfVertices, vtkIdType);
  vtkGetMacro(MaximumNumberOfVertices, vtkIdType);
  ///@}

  ///@{
  /**
   * How many threads work on the mesh (Cost, above), >= 0; it does not depend on it. 0 (default):
   * as many as there are cores for this process. 1: none is started. Threads come from vtkSMPTools,
   * by its backend, or by STDThread where that is Sequential.
   */
  vtkSetClampMacro(NumberOfThreads, int, 0, VTK_INT_MAX);
  vtkGetMacro(NumberOfThreads, int);
  ///@}

  ///@{
  /**
   * Whether output 2 shows the bites and the front that is left. Default off.
   */
  vtkSetMacro(GenerateBites, bool);
  vtkGetMacro(GenerateBites, bool);
  vtkBooleanMacro(GenerateBites, bool);
  ///@}

  /**
   * The mesh in a few lines: size, time, angles, conformity, and what keeps it from being better.
   * Where there is no mesh, why; empty where there is no input.
   */
  const char* GetSummary() const { return this->Summary.c_str(); }

  /**
   * Ends a running execution, for observers of its progress. Unlike SetAbortExecute, after which
   * newer pipelines execute again when they are asked, this is an error: outputs are empty, and
   * stay so until something changes.
   */
  void Stop();

protected:
  vtkBitingAlgorithm();
  ~vtkBitingAlgorithm() override = default;

  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  double UniformSpacing = 0.0;
  double SpacingScale = 1.0;
  double MinimumSpacing = 0.0;
  double MaximumSpacing = 0.0;
  double Gradation = 0.3;
  bool LimitByFeatureSize = true;
  bool Relaxation = true;
  vtkIdType MaximumNumberOfVertices = 20000000;
  int NumberOfThreads = 0;
  bool GenerateBites = false;
  std::string Summary;
  bool IsStopping = false; // Stop was called in this execution

private:
  vtkBitingAlgorithm(const vtkBitingAlgorithm&) = delete;
  void operator=(const vtkBitingAlgorithm&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
