// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingRemeshRegion_h
#define BitingRemeshRegion_h

#include "../Base/Monitor.h"
#include "../Base/Problem.h"
#include "../Spacing/Spacing.h"
#include "ChangedRegion.h"
#include "EdgeSimplification.h"
#include "OldMesh.h"
#include "RegionEdges.h"
#include "RemeshOptions.h"

#include <functional> // for the lengths
#include <memory>     // for sources
#include <vector>     // for spacings

namespace biting
{

/// Lowers `values` v, one a vertex, to the largest with v(b) - v(a) <= gradation * d(a, b) through
/// the mesh, to 2 % of the gradation; where all grow from one vertex they may be 5 % above that. d
/// is the distance in the plane where triangles have no obtuse angles, along edges where they have;
/// no way leads through holes. The linear interpolation between the vertices is at most twice as
/// steep where no angle is above 120 degrees. In other triangles it may be steeper. A gradation of
/// 0 lowers nothing.
///
/// Method: the eikonal equation by fast marching. Vertices hand on what they allow to the corners
/// of the triangles around them, lowest first, over the edge across (Kimmel and Sethian, "Computing
/// geodesic paths on manifolds", 1998). Cost: one pass over the triangles; where something is
/// steep, O(n) once more, and O(m log m) for m vertices that are lowered. Where the monitor asks to
/// stop the values have no meaning.
void LowerToGradation(
  const OldMesh& mesh, double gradation, std::vector<double>& values, Monitor& monitor);

/// The spacing wanted of an old mesh.
///
/// Where values at the vertices give it, they are lowered to the gradation through the mesh
/// (GradedValues). It is linear between them, and preparing it for a region costs no more than
/// the region. A grid or a triangulation is prepared for all of the mesh.
class WantedSpacing
{
public:
  /// `values`, one a vertex or none, count where `options` have neither a grid nor a triangulation.
  WantedSpacing(const OldMesh& mesh, const SpacingOptions& options,
    const std::vector<double>& values, ProblemList& problems, Monitor& monitor);

  /// f at the vertices, before any limit by feature size; but at those of the last region that
  /// there were pieces for, with it.
  const std::vector<double>& AtVertices() const
  {
    return this->Limited.empty() ? this->Values : this->Limited;
  }

  /// f for the region, at most the local feature size of `pieces`, if there are any, but for
  /// distances not below 1.4 times the lengths of the old edges.
  Spacing Prepare(const ChangedRegion& region, const RegionEdges* pieces, double mostVertices,
    ProblemList& problems, Monitor& monitor);

private:
  void Combine(const std::vector<double>& values, ProblemList& problems);
  std::shared_ptr<const TriangulatedSource> SourceOn(const ChangedRegion& region) const;
  double LeastOf(const ChangedRegion& region) const;
  std::shared_ptr<const FeatureSource> FeaturesOf(const ChangedRegion& region,
    const RegionEdges& pieces, double mostVertices, Monitor& monitor) const;
  std::function<double(const Point2&)> LengthsOn(
    const ChangedRegion& region, Monitor& monitor) const;

  const OldMesh& Mesh;
  SpacingOptions Options;
  std::vector<double> Values;
  std::vector<double> Limited; ///< by feature size
  bool IsLocal = false;        ///< f is linear between the values
};

/// What of a mesh must change, and the spacing that it is to have.
struct RemeshRegion
{
  ChangedRegion Region;            ///< empty: nothing must
  Spacing F;                       ///< in the region and around it
  std::vector<double> OldSpacings; ///< f at the vertices of the mesh
  EdgeTolerance Tolerance;         ///< how far edges may move
};

/// Compares the mesh with the spacing that is wanted of it. Where the limit by feature size makes
/// the region larger, f is limited around it, too: in a region that grows until the two agree. What
/// is wrong is added to `problems`; then, and where the monitor asks to stop, the result has no
/// meaning.
RemeshRegion FindRemeshRegion(
  const OldMesh& mesh, const RemeshOptions& options, ProblemList& problems, Monitor& monitor);

} // namespace biting

#endif
