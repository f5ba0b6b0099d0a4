// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingPreparedInput_h
#define BitingPreparedInput_h

#include "../Base/Monitor.h"
#include "../Base/Problem.h"
#include "../Domain/Domain.h"
#include "../Mesh/BitingMeshOptions.h"
#include "../Simplification/Simplification.h"
#include "../Spacing/Spacing.h"

#include <functional> // for floors

namespace biting
{

/// f of a domain, limited by the features of its drawing where the options say so. The minimum is
/// the rounding of vertices at least, unless bounds say otherwise: vertices nearer to each other
/// are one. Where less than that is given, it is told once (ProblemCode::RaisedSpacing).
/// `floor` is FeatureSource::Floor.
Spacing PrepareSpacing(const BitingMeshOptions& options, const SimplifiedDomain& simplified,
  ProblemList& problems, Monitor& monitor, std::function<double(const Point2&)> floor = {});

/// f before any limit by feature size. Many of the drawing's vertices will go: they are no reason
/// to refuse.
Spacing PrepareGivenSpacing(
  const BitingMeshOptions& options, const Domain& drawing, ProblemList& problems, Monitor& monitor);

/// The domain of a drawing; without segments where there is none.
Domain ReadDrawing(const Polylines& input, const BitingMeshOptions& options, ProblemList& problems,
  Monitor& monitor);

/// The drawing as it is meshed: with fewer vertices, where that is asked for. Refuses a drawing
/// with more vertices than the mesh may have: all are vertices of the mesh.
SimplifiedDomain SimplifyDrawing(
  Domain drawing, const BitingMeshOptions& options, ProblemList& problems, PartOfStage& part);

/// The spacing for a domain whose segments are not divided: what `spacing` asks for, as far as the
/// lengths of the segments leave a choice.
///
/// With L(x) = min_i(l_i + g |x - segment i|), the lengths l_i and their extension with the
/// gradation g, f is at most L, and at least L(y) - g |x - y| for each end and middle y of a
/// segment. So f is L on the boundary, whatever `spacing` is there, and may differ from it by 2 g d
/// at a distance d. Where nothing else is given, f is L. A gradation of 0 becomes the default. The
/// scale does not apply to L, and where a segment source is given, to its values only, not to g.
/// Minimum and maximum apply, but not below the lower bound. A floor that was set is replaced.
/// Cost O(n log n) for n segments. Where the monitor asks to stop the result has no meaning.
SpacingOptions FollowSegments(
  SpacingOptions spacing, const Domain& domain, Monitor& monitor = NoMonitor());

} // namespace biting

#endif
