// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingPreparedSpacing_h
#define BitingPreparedSpacing_h

#include "../Base/Monitor.h"
#include "../Base/Problem.h"
#include "../Domain/Domain.h"
#include "../Mesh/BitingMeshOptions.h"
#include "../Spacing/Spacing.h"

#include <memory> // for features

namespace biting
{

/// f of a domain, limited by the features of its drawing, which may be none.
Spacing PrepareSpacing(const BitingMeshOptions& options, const Domain& domain,
  std::shared_ptr<const FeatureSource> features, ProblemList& problems, Monitor& monitor);

/// f before any limit by feature size. Many of the drawing's vertices will go: they are no reason
/// to refuse.
Spacing PrepareGivenSpacing(
  const BitingMeshOptions& options, const Domain& drawing, ProblemList& problems, Monitor& monitor);

} // namespace biting

#endif
