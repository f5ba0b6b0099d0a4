// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingChosenArray_h
#define BitingChosenArray_h

#include "../../vtkBitingCompat.h" // for the ABI namespace

#include <string> // for refusals

VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;
class vtkDataSet;
class vtkInformation;
VTK_ABI_NAMESPACE_END

namespace biting
{

/// The point array that a filter takes where no other was chosen, if it is there.
constexpr const char* SpacingArrayName = "Spacing";

/// What helps whoever has cell data.
constexpr const char* CellDataAdvice = " Cell Data to Point Data makes it of cell data.";

/// A point array of a dataset, or why there is none; neither where none is wanted.
struct ChosenArray
{
  vtkDataArray* Array = nullptr;
  bool IsMissing = false; ///< there is no SpacingArrayName, and no other was chosen
  bool IsOfCells = false; ///< and there is a cell array of that name
  std::string Refusal;
};

/// The words for an array in messages: "The spacing array ... of the input".
struct ArrayRole
{
  const char* Array; ///< "spacing array"
  const char* Owner; ///< "input"
};

/// Finds the array that `choice`, what SetInputArrayToProcess left, asks for in `data`. Where it
/// asks for none, that is SpacingArrayName. The names "None", "" and SpacingArrayName may be
/// missing; any other may not.
ChosenArray ChooseArray(vtkInformation* choice, vtkDataSet* data, const ArrayRole& role);

/// The same of a name.
ChosenArray ArrayNamed(const char* name, vtkDataSet* data, const ArrayRole& role);

} // namespace biting

#endif
