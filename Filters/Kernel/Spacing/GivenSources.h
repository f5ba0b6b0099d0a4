// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingGivenSources_h
#define BitingGivenSources_h

#include "Spacing.h"

#include <memory> // for sources

namespace biting
{

bool HasSegments(const std::shared_ptr<const SegmentSource>& source);

/// Whether a source is given that is not one value everywhere.
bool HasGrid(const SpacingOptions& options);
bool HasTriangulation(const SpacingOptions& options);

/// The same for boundary values, from which f grows.
bool HasExtension(const SpacingOptions& options);

/// The least of what is one value everywhere; infinite where there is none.
double UniformOf(const SpacingOptions& options);

} // namespace biting

#endif
