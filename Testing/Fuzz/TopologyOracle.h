// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingTopologyOracle_h
#define BitingTopologyOracle_h

#include "JudgedMesh.h"

namespace biting
{

/// Sizes, ids, places; that triangles fit together and cover their area once; regions. Fills what
/// is sorted of the judged mesh.
class TopologyOracle
{
public:
  explicit TopologyOracle(JudgedMesh& judged)
    : Judged(judged)
  {
  }

  bool Holds();

private:
  bool HasSizes();
  bool HasBiteSizes();
  bool HasIds();
  bool HasPlaces();
  bool HasPointsOnce();
  bool UsesAllPoints();
  bool IsCounterclockwise();
  bool IsManifold();
  bool IsNeighbor(const HalfEdge& half);
  bool HasCoveringEdges();
  bool CoversOnce();
  int WindingAbout(const Point2& p) const;
  bool HasRegions();

  JudgedMesh& Judged;
};

} // namespace biting

#endif
