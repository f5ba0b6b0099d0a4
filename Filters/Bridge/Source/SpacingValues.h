// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingSpacingValues_h
#define BitingSpacingValues_h

#include "../../Kernel/Base/Pulse.h"      // for progress
#include "../../Kernel/Spacing/Spacing.h" // for options
#include "../../vtkBitingCompat.h"        // for the ABI namespace
#include "../Run/ProblemReport.h"

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

/// The value that replaces zero and negative ones: MinimumSpacing / SpacingScale; 0 where there is
/// no MinimumSpacing.
double LeastValue(const SpacingOptions& options);

/// Whether `array` has no value for each point of `data`: in words, empty where it has.
std::string CheckShape(vtkDataSet* data, vtkDataArray* array);

/// Reads `values` of the input, one for each point, zero and negative ones as `least` where that is
/// above 0. Returns what is wrong with them at `points`, as CheckReadValues.
std::string ReadOwnValues(vtkDataSet* data, vtkDataArray* array,
  const std::vector<vtkIdType>& points, double least, std::vector<double>& values,
  ProblemPlaces& places, Pulse& pulse);

/// Checks values that were read from `array` at `points` of `data`, at all where that is null: they
/// are positive and finite. Returns what is wrong, with the points and their places, empty where
/// nothing is; all places are added to `places`. Where the monitor asks to stop nothing is wrong.
std::string CheckReadValues(vtkDataSet* data, vtkDataArray* array,
  const std::vector<double>& values, const std::vector<vtkIdType>* points, SpacingOwner owner,
  ProblemPlaces& places, Pulse& pulse);

/// Sorts the points of a source by place and value, and its triangles or segments by the numbers of
/// their corners. Points of the same place and value become one; then repeated cells, and
/// triangles of less than three points, go. Law: the source does not depend on the order in which
/// its points and cells were read, nor on whether cells share points. Cost O(n log n). Where
/// the monitor asks to stop the source has no meaning.
void SortSource(TriangulatedSource& source, Pulse& pulse);
void SortSource(SegmentSource& source, Pulse& pulse);

} // namespace biting

#endif
