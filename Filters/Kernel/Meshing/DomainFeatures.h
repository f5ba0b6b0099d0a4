// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingDomainFeatures_h
#define BitingDomainFeatures_h

#include "../Domain/Domain.h"
#include "../Domain/DomainLocator.h"
#include "../Simplification/Simplification.h"
#include "../Spacing/Spacing.h"

#include <functional> // for what is outside
#include <memory>     // for sources

namespace biting
{

/// The segments and embedded points of a domain, for the limit by local feature size; of a mesh
/// that is refused if it has more vertices than that.
std::shared_ptr<const FeatureSource> FeaturesOf(
  const SimplifiedDomain& simplified, double mostVertices);

/// True for boxes that lie outside of a domain: nobody asks for f there. The locator must outlive
/// it.
std::function<bool(const Box2&)> OutsideOf(const DomainLocator& locator);

} // namespace biting

#endif
