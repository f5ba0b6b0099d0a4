// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "LowerBound.h"

namespace biting
{
namespace
{

SegmentSource Negated(SegmentSource source)
{
  for (double& value : source.Values)
  {
    value = -value;
  }
  return source;
}

} // namespace

LowerBound::LowerBound(const SegmentSource& source, double slope, Monitor& monitor)
  : Negative(Negated(source), slope, monitor)
{
}

} // namespace biting
