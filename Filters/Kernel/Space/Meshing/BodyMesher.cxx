// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "BodyMesher.h"

namespace biting
{

BitingBody MakeBitingBody(const CheckedSurface& /*surface*/, const BodyMesherOptions& /*options*/,
  ProblemList& /*problems*/, Monitor& /*monitor*/)
{
  return {};
}

} // namespace biting
