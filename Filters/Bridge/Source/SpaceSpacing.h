// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingSpaceSpacing_h
#define BitingSpaceSpacing_h

#include "../../Kernel/Base/Box.h"
#include "../../Kernel/Base/Monitor.h"
#include "../../Kernel/Spacing/Spacing.h" // for options
#include "../Run/ProblemReport.h"
#include "SourceData.h"

#include <functional> // for the spacing
#include <string>     // for the refusal

namespace biting
{

/// f(x) in space, which any number of threads may ask at once.
using SpaceSpacing = std::function<double(const Point3&)>;

/// The spacing of `options` (Uniform to Gradation), and what the source gives, if there is one.
///
/// Given is the minimum of Uniform and the value of the source: interpolated in its cells, of three
/// dimensions or less; outside of all cells that of the nearest place in one. Cells with a NaN and
/// hidden ones give nothing. Of cells that overlap the smallest value counts. It is scaled and
/// clamped; then f is the largest function below that is no steeper than the gradation, where cells
/// are steeper by their edges: within cells much larger than f it may be larger.
///
/// `bounds`: where f will be asked for. Returns what is wrong with the source, empty where nothing
/// is; `spacing` is empty where nothing is given. Where the monitor asks to stop it has no meaning.
std::string MakeSpaceSpacing(const SourceData& source, const SpacingOptions& options,
  const Box3& bounds, SpaceSpacing& spacing, ProblemPlaces& places, Monitor& monitor);

} // namespace biting

#endif
