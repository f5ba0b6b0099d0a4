// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingCutFrame_h
#define BitingCutFrame_h

#include "../Base/Box.h"
#include "../Base/Point.h"
#include "../Base/Pulse.h"
#include "../Domain/Domain.h"

#include <optional> // for what is not so

namespace biting
{

/// Axes to which cuts are parallel. Where these are the axes of the coordinates, coordinates in the
/// frame are the same numbers.
struct CutFrame
{
  Point2 Axis{ 1.0, 0.0 }; ///< of unit length

  /// True: far more of the boundary runs along the second axis than along the first; false: along
  /// the first; empty: neither. Rows of lattices run along that axis.
  std::optional<bool> IsMostlyVertical;

  /// A place of the plane in the frame, and back.
  Point2 To(const Point2& p) const { return { Dot(this->Axis, p), Cross(this->Axis, p) }; }
  Point2 From(const Point2& p) const
  {
    return { p.X * this->Axis.X - p.Y * this->Axis.Y, p.X * this->Axis.Y + p.Y * this->Axis.X };
  }
};

/// Of the directions of the longest boundary segments, the one along and across which the most of
/// the boundary runs, if that is a good part of it; else the axes of the coordinates. Fronts that
/// leave the boundary and those that leave cuts then make one lattice, however the drawing is
/// turned. Depends on the domain alone. Where the monitor wants to stop the result has no meaning.
CutFrame FrameOf(const Domain& domain, Pulse& pulse);

/// The box of a domain in the frame.
Box2 BoundsIn(const CutFrame& frame, const Domain& domain);

/// For each axis the interval of the longest boundary segment that is parallel to it, in the frame;
/// that of the domain's box where no such segment is a good part of its width.
Box2 LongestSidesIn(const CutFrame& frame, const Domain& domain, Pulse& pulse);

} // namespace biting

#endif
