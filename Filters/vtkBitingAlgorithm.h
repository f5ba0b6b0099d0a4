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

  /// What x and y are.
  enum CoordinatesType
  {
    PLANE = 0,
    LONGITUDE_LATITUDE = 1
  };

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
   * PLANE (default): coordinates are lengths, in a plane of space.
   * LONGITUDE_LATITUDE: x is the longitude and y the latitude, in degrees, of inputs, of the
   * source, and of the outputs; spacings, bounds and the arrays Spacing and NearestNeighborDistance
   * are in metres on a sphere of 6,371,008.8 m, the mean radius of the Earth. Cells of the source
   * are up to 10 degrees wide. The mesh is made in the stereographic plane about the middle of the
   * input, which is the direction of the mean of its points' unit vectors, as all angles there are
   * those on the globe; lengths are 2 / (1 + cos c) times as large at the angle c from the middle,
   * and f is multiplied by that. So neither poles nor the 180th meridian are a border: all
   * longitudes of a pole are one point, and 179.9 and -179.9 are neighbors. The inside of a loop is
   * what the stereographic plane has inside. Lengths in messages, in LeftOutArea and of tolerances
   * that are relative to the diagonal are those of that plane. Lines of the input are straight in
   * degrees, the shorter way around the globe, and along the meridian to a pole; they are divided,
   * where PreserveBoundary is off, so that the mesh is less than 0.01 f from them, where parts are
   * no longer than an edge 0.03 f (f without the feature size); points that divide have
   * OriginalPointId -1. Gradation is a slope in that plane; on the globe it may be larger by f
   * tan(c / 2) / 6,371 km. Longitudes of the mesh are within [-180, 180), or [0, 360) where those
   * of the input are; of an input that jumps, as across 180 degrees, they continue beyond, within
   * 180 degrees of the middle, and vertices of the input that lie on the other side are moved by
   * 360 degrees. All others are those of the input, bit for bit. Around a pole a jump remains.
   * Latitudes beyond 90 degrees, and points more than 170 degrees from the middle, are errors;
   * where a pole is less than 170 degrees from all of them that is the middle instead. z is one
   * level.
   */
  vtkSetClampMacro(Coordinates, int, PLANE, LONGITUDE_LATITUDE);
  vtkGetMacro(Coordinates, int);
  void SetCoordinatesToPlane() { this->SetCoordinates(PLANE); }
  void SetCoordinatesToLongitudeLatitude() { this->SetCoordinates(LONGITUDE_LATITUDE); }
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
  int Coordinates = PLANE;
  bool GenerateBites = false;
  std::string Summary;
  bool IsStopping = false; // Stop was called in this execution

private:
  vtkBitingAlgorithm(const vtkBitingAlgorithm&) = delete;
  void operator=(const vtkBitingAlgorithm&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
