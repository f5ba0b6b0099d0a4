// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingSourceCheck_h
#define BitingSourceCheck_h

#include "Spacing.h"

namespace biting
{

/// Adds a ProblemCode::BadSpacing for everything in `options` that cannot be a spacing; true if
/// there was none. It checks:
/// - Uniform, Scale, Minimum, Maximum and Gradation are finite and not negative, Scale is not zero,
///   Minimum is not above a given Maximum (no ids; the detail names the parameter);
/// - every value times Scale is positive and finite (id: point of the source), except that a NaN in
///   a grid or triangulated source is a hole, as long as the source is not one single hole;
/// - every position in use is finite, the nodes of a grid ascend.
///
/// Also false if the monitor asks to stop.
bool CheckSpacing(
  const SpacingOptions& options, ProblemList& problems, Monitor& monitor = NoMonitor());

/// The least of all values given, before they are scaled; infinite where there is none.
double LeastGiven(const SpacingOptions& options);

} // namespace biting

#endif
