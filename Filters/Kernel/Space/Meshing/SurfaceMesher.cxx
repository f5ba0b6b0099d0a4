// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SurfaceMesher.h"

namespace biting
{

BitingSurface MakeBitingSurface(const CheckedSurface& /*surface*/,
  const SurfaceMesherOptions& /*options*/, ProblemList& /*problems*/, Monitor& /*monitor*/)
{
  return {};
}

} // namespace biting
