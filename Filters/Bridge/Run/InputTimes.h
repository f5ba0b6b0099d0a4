// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingInputTimes_h
#define BitingInputTimes_h

#include "../../vtkBitingCompat.h" // for the ABI namespace

VTK_ABI_NAMESPACE_BEGIN
class vtkInformationVector;
VTK_ABI_NAMESPACE_END

namespace biting
{

/// In REQUEST_INFORMATION: the times of the outputs are those of all inputs, not of the first port
/// alone, as VTK has it. So a filter runs anew where only its spacing source changes with time.
/// Returns 1, as requests do.
int PassTimes(vtkInformationVector** inputs, int numberOfPorts, vtkInformationVector* outputs);

} // namespace biting

#endif
