// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

// The relaxation, which then takes the first edge of a segment for one of the next segment.
#define Relax RelaxFaultlessly
#include "Kernel/Relaxation/Relaxation.cxx" // NOLINT: under another name
#undef Relax

#include "Fault.h"

namespace biting
{

RelaxationResult Relax(const Domain& domain, const Spacing& spacing,
  const RelaxationOptions& options, RelaxationMesh& mesh, Monitor& monitor)
{
  RelaxationResult result = RelaxFaultlessly(domain, spacing, options, mesh, monitor);
  if (second_look::TheFault == second_look::Fault::MistakenSegment)
  {
    ++mesh.EdgeSegments.front();
  }
  return result;
}

} // namespace biting
