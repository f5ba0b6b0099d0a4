// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingProblemsToPolyData_h
#define BitingProblemsToPolyData_h

#include "../../vtkBitingCompat.h" // for the ABI namespace
#include "ProblemPlaces.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkPolyData;
VTK_ABI_NAMESPACE_END

namespace biting
{

/// Fills `output` with one vertex cell a place, and the arrays that the documentation of
/// vtkBitingMesher lists for output 3.
void ProblemsToPolyData(const ProblemPlaces& problems, vtkPolyData* output);

} // namespace biting

#endif
