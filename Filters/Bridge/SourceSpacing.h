// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingSourceSpacing_h
#define BitingSourceSpacing_h

#include "../Kernel/Spacing/Spacing.h"
#include "../vtkBitingCompat.h" // for the ABI namespace
#include "PlaneFrame.h"
#include "ProblemPlaces.h"

#include <functional> // for what is asked of places
#include <string>     // for the refusal

VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;
class vtkDataSet;
VTK_ABI_NAMESPACE_END

namespace biting
{

/// Makes the spacing `values` at the points of `source` a source of `options`, in the plane `frame`.
///
/// Images and rectilinear grids of one layer along the plane, which is axis-aligned, are taken as
/// grids. Of any other data, cells with an area are triangulated and projected into the plane, and
/// cells with a volume are split into tetrahedra and cut by it. Hidden and ghost cells, cells with a
/// hidden point, and cells without area are no source.
/// Values that are zero, negative or infinite where `isWanted` says no are none, as NaN: fill values
/// outside of the domain.
/// Reads `source` without changing it. Returns why it cannot be used, empty where it can; `places`
/// gets the values that are no spacing. Where the monitor asks to stop nothing is refused, and the
/// options have no meaning.
std::string AddSourceSpacing(vtkDataSet* source, vtkDataArray* values, const PlaneFrame& frame,
  const std::function<bool(const Point2&)>& isWanted, SpacingOptions& options,
  ProblemPlaces& places, Monitor& monitor);

} // namespace biting

#endif
