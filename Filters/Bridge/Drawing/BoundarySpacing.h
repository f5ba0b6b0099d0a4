// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingBoundarySpacing_h
#define BitingBoundarySpacing_h

#include "../../Kernel/Spacing/Spacing.h"
#include "../../vtkBitingCompat.h" // for the ABI namespace
#include "../Run/ProblemReport.h"
#include "Drawing.h"
#include "PolylinesFromDrawing.h"

#include <string> // for the refusal

VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;
VTK_ABI_NAMESPACE_END

namespace biting
{

/// Makes the spacing `values` at the points of `drawing`, which was read as `input`, a source of
/// `options`: linear along the segments of every chain, all edges of faces too, and at every
/// embedded point. Points of blocks without the array give none.
/// Returns why the values cannot be used, empty where they can; `places` gets the values that are
/// no spacing. Where the monitor asks to stop the options have no meaning.
std::string AddBoundarySpacing(const Drawing& drawing, const PlanarInput& input,
  vtkDataArray* values, SpacingOptions& options, ProblemPlaces& places, Monitor& monitor);

} // namespace biting

#endif
