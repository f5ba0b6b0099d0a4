// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "BodyRelaxation.h"

namespace biting
{

void RelaxBody(const SurfaceGround& /*ground*/, const std::function<double(const Point3&)>& /*f*/,
  RelaxedBody& /*body*/, Pulse& /*pulse*/)
{
}

} // namespace biting
