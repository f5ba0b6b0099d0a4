// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingSpacingValues_h
#define BitingSpacingValues_h

#include "../vtkBitingCompat.h" // for the ABI namespace

#include "vtkType.h" // for vtkIdType

#include <string> // for the refusal
#include <vector> // for points

VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;
class vtkDataSet;
VTK_ABI_NAMESPACE_END

namespace biting
{

/// Whether a value that is no number is allowed, as a place where there is no source.
enum class NotANumber
{
  Refused,
  Allowed
};

/// Checks the spacing in `values` at `points` of `data`: one component, positive, finite.
/// Returns what is wrong, with the points and their places, empty where nothing is.
std::string CheckSpacingValues(vtkDataSet* data, vtkDataArray* values,
  const std::vector<vtkIdType>& points, NotANumber notANumber);

} // namespace biting

#endif
