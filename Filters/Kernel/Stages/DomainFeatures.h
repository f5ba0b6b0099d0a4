// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingDomainFeatures_h
#define BitingDomainFeatures_h

#include "../Simplification/Simplification.h"
#include "../Spacing/Spacing.h"

#include <memory> // for sources

namespace biting
{

/// The segments and embedded points of a domain, for the limit by local feature size; of a mesh
/// that is refused if it has more vertices than that.
std::shared_ptr<const FeatureSource> FeaturesOf(
  const SimplifiedDomain& simplified, double mostVertices);

} // namespace biting

#endif
