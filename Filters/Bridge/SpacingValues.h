// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingSpacingValues_h
#define BitingSpacingValues_h

#include "../Kernel/Base/Pulse.h" // for progress
#include "../vtkBitingCompat.h"   // for the ABI namespace
#include "ProblemPlaces.h"

#include "vtkType.h" // for vtkIdType

#include <string> // for the refusal
#include <vector> // for points

VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;
class vtkDataSet;
VTK_ABI_NAMESPACE_END

namespace biting
{

/// The dataset that gives the spacing. Of a source, a value that is NaN says that there is none.
enum class SpacingOwner
{
  Input,
  Source
};

/// Checks the spacing in `values` at `points` of `data`: one component, positive, finite.
/// Returns what is wrong, with the points and their places, empty where nothing is; all places are
/// added to `places`. Where the monitor asks to stop nothing is wrong.
std::string CheckSpacingValues(vtkDataSet* data, vtkDataArray* values,
  const std::vector<vtkIdType>& points, SpacingOwner owner, ProblemPlaces& places, Pulse& pulse);

/// The same of values that were read from `array`, which has one for each point of `data`; of all
/// where `points` is null.
std::string CheckReadValues(vtkDataSet* data, vtkDataArray* array,
  const std::vector<double>& values, const std::vector<vtkIdType>* points, SpacingOwner owner,
  ProblemPlaces& places, Pulse& pulse);

} // namespace biting

#endif
