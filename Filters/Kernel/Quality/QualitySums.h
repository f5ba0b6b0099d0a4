// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingQualitySums_h
#define BitingQualitySums_h

#include "ExactSum.h"

#include <algorithm> // for min, max
#include <cstdint>   // for counts
#include <limits>    // for none

namespace biting
{

/// Sums over parts of a mesh. Joined in any order they have the same bits.
struct QualitySums
{
  std::int64_t Vertices = 0;
  std::int64_t Triangles = 0;
  std::int64_t Edges = 0;
  std::int64_t EdgesInBand = 0; ///< (MeshQuality::ShareOfEdgesInBand)
  double SmallestAngle = std::numeric_limits<double>::infinity();
  double LargestRadiusEdgeRatio = 0.0;
  double SmallestConformity = std::numeric_limits<double>::infinity();
  double LargestSlope = 0.0;
  ExactSum Conformities;
  ExactSum RelativeLengths; ///< of edges

  void Join(const QualitySums& other)
  {
    this->Vertices += other.Vertices;
    this->Triangles += other.Triangles;
    this->Edges += other.Edges;
    this->EdgesInBand += other.EdgesInBand;
    this->SmallestAngle = std::min(this->SmallestAngle, other.SmallestAngle);
    this->LargestRadiusEdgeRatio =
      std::max(this->LargestRadiusEdgeRatio, other.LargestRadiusEdgeRatio);
    this->SmallestConformity = std::min(this->SmallestConformity, other.SmallestConformity);
    this->LargestSlope = std::max(this->LargestSlope, other.LargestSlope);
    this->Conformities.Join(other.Conformities);
    this->RelativeLengths.Join(other.RelativeLengths);
  }
};

} // namespace biting

#endif
