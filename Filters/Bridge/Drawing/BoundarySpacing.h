// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingBoundarySpacing_h
#define BitingBoundarySpacing_h

#include "../../Kernel/Spacing/Spacing.h"
#include "../../vtkBitingCompat.h" // for the ABI namespace
#include "../Run/ProblemReport.h"
#include "../Source/SourceData.h"
#include "Drawing.h"
#include "PolylinesFromDrawing.h"

#include <string> // for the refusal

VTK_ABI_NAMESPACE_BEGIN
class vtkInformation;
VTK_ABI_NAMESPACE_END

namespace biting
{

/// The array of the drawing that `choice`, what SetInputArrayToProcess left, asks for: one of
/// points, or one of cells (IsOfCells) where cells are asked for, or no points have that name.
ChosenArray ChooseBoundaryArray(vtkInformation* choice, const Drawing& drawing);

/// Makes the spacing `chosen` of `drawing`, which was read as `input`, a source of `options`.
///
/// Of points: linear along the segments of every chain, all edges of faces too, and at every
/// embedded point. Points of blocks without the array give none.
/// Of cells: the value of a line along it, that of a vertex cell at its points, that of a
/// two-dimensional cell within 5 % anywhere in it. Zero and NaN ask for nothing.
/// Returns why the values cannot be used, empty where they can; `places` gets the values at points
/// that are no spacing. Where the monitor asks to stop the options have no meaning.
std::string AddBoundarySpacing(const Drawing& drawing, const PlanarInput& input,
  const ChosenArray& chosen, SpacingOptions& options, ProblemPlaces& places, Monitor& monitor);

} // namespace biting

#endif
