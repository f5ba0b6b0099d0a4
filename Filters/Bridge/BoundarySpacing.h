// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingBoundarySpacing_h
#define BitingBoundarySpacing_h

#include "../Kernel/Spacing/Spacing.h"
#include "../vtkBitingCompat.h" // for the ABI namespace
#include "PolylinesFromPolyData.h"
#include "ProblemPlaces.h"

#include <string> // for the refusal

VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;
class vtkPolyData;
VTK_ABI_NAMESPACE_END

namespace biting
{

/// Makes the spacing `values` at the points of `polyData`, which was read as `input`, a source of
/// `options`: linear along the segments of every chain, and at every embedded point.
/// Returns why the values cannot be used, empty where they can; `places` gets the values that are no
/// spacing. Where the monitor asks to stop the options have no meaning.
std::string AddBoundarySpacing(vtkPolyData* polyData, const PlanarInput& input,
  vtkDataArray* values, SpacingOptions& options, ProblemPlaces& places, Monitor& monitor);

} // namespace biting

#endif
