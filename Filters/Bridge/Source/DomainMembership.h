// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingDomainMembership_h
#define BitingDomainMembership_h

#include "../../Kernel/Domain/Domain.h"
#include "../../Kernel/Domain/DomainLocator.h"

#include <optional> // for what is made when it is asked for

namespace biting
{

/// Whether places lie in the domain that chains bound. The domain is made at the first question,
/// which most inputs never ask.
class DomainMembership
{
public:
  /// The chains must outlive this.
  DomainMembership(
    const Polylines& chains, Monitor& monitor, DomainRule rule = DomainRule::EvenOdd);

  /// Also true on the boundary, and where the chains bound no domain.
  bool MayHold(const Point2& place);

private:
  bool IsOnBoundary(const Point2& place) const;

  const Polylines& Chains;
  biting::Monitor& Asked;
  const DomainRule Rule;
  biting::Domain Domain;
  std::optional<DomainLocator> Locator;
  bool IsMade = false;
};

} // namespace biting

#endif
