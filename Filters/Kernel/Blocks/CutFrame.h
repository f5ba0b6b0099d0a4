// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingCutFrame_h
#define BitingCutFrame_h

#include "../Base/Point2.h"
#include "../Domain/Domain.h"

namespace biting
{

/// Axes to which cuts are parallel. Where these are the axes of the coordinates, coordinates in the
/// frame are the same numbers.
struct CutFrame
{
  Point2 Axis{ 1.0, 0.0 }; ///< of unit length

  /// A place of the plane in the frame, and back.
  Point2 To(const Point2& p) const { return { Dot(this->Axis, p), Cross(this->Axis, p) }; }
  Point2 From(const Point2& p) const
  {
    return { p.X * this->Axis.X - p.Y * this->Axis.Y, p.X * this->Axis.Y + p.Y * this->Axis.X };
  }
};

/// The axes along which, or across, the most of the boundary runs, of the directions of its longest
/// segments, where that is a good part of it; else those of the coordinates. Fronts that leave the
/// boundary and those that leave cuts then make one lattice, however the drawing is turned. Depends
/// on the domain alone.
CutFrame FrameOf(const Domain& domain);

} // namespace biting

#endif
