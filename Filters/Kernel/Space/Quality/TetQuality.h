// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingTetQuality_h
#define BitingTetQuality_h

#include "../../Base/Ids.h"
#include "../../Base/Monitor.h"
#include "../../Base/Point.h"

#include <array>   // for angles
#include <cstdint> // for counts
#include <vector>  // for the arrays

namespace biting
{

/// A mesh of tetrahedra to judge: vertices, the spacing wanted at each (empty: none is given), and
/// tetrahedra (four vertex ids each, of either orientation).
struct TetView
{
  const std::vector<Point3>& Points;
  const std::vector<double>& Spacing;
  const std::vector<Id>& Corners;
  bool HasHistograms = false; ///< whether the lists for them are wanted
};

/// What it is worth: the sister of MeshQuality. Judges only.
struct TetQuality
{
  // One a vertex; infinite and NaN where no tetrahedron has it.
  std::vector<double> NearestNeighborDistance; ///< N: the length of the shortest edge at it
  std::vector<double> Conformity;              ///< min(N / f, f / N)

  // One a tetrahedron.
  std::vector<double> MinimumDihedralAngle; ///< degrees; 70.53 is best
  std::vector<double> MaximumDihedralAngle;
  std::vector<double> RadiusEdgeRatio; ///< circumradius / shortest edge; 0.612 is best
  std::vector<double> AspectRatio;     ///< circumradius / radius of the inscribed sphere; 3 is best

  // For histograms: six dihedral angles a tetrahedron, and length / mean f of the ends an edge.
  std::vector<double> DihedralAngles;
  std::vector<double> RelativeLengths;

  // The whole.
  std::int64_t NumberOfVertices = 0; ///< that a tetrahedron has
  std::int64_t NumberOfSlivers = 0;  ///< ratio at most 2, and an angle below 10 degrees
  double SmallestDihedralAngle = 0.0;
  double LargestDihedralAngle = 0.0;
  double LargestRadiusEdgeRatio = 0.0;
  double SmallestConformity = 0.0;
  double MeanConformity = 0.0;
  double MeanRelativeLength = 0.0;
  double ShareOfEdgesInBand = 0.0; ///< of edges with length within [1/sqrt(2), sqrt(2)] f
};

/// Cost O(n log n). Where the monitor asks to stop the result has no meaning.
TetQuality MeasureTetrahedra(const TetView& mesh, Monitor& monitor = NoMonitor());

/// The dihedral angles at the edges 01, 02, 03, 12, 13, 23, in degrees; NaN at faces without area.
std::array<double, 6> DihedralAngles(const std::array<Point3, 4>& tetrahedron);

/// Of the sign that Orient3D has.
double VolumeOf(const std::array<Point3, 4>& tetrahedron);

} // namespace biting

#endif
