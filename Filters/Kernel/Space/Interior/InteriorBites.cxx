// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "InteriorBites.h"

namespace biting
{

InteriorBites BiteInterior(
  const BodyBoundary& /*boundary*/, SpaceBiteShape /*shape*/, std::size_t /*mostBites*/, Pulse&)
{
  return {};
}

} // namespace biting
