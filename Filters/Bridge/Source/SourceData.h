// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingSourceData_h
#define BitingSourceData_h

#include "../../vtkBitingCompat.h" // for the ABI namespace

#include "vtkSmartPointer.h" // for datasets

#include <string> // for refusals

VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;
class vtkDataObject;
class vtkDataSet;
class vtkInformation;
VTK_ABI_NAMESPACE_END

namespace biting
{

/// The point array that a filter takes where no other was chosen, if it is there.
constexpr const char* SpacingArrayName = "Spacing";

/// Advice where a point array is wanted.
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

/// A spacing source as one dataset, with the array of its spacing.
struct SourceData
{
  vtkSmartPointer<vtkDataSet> Data; ///< null where there is none to use
  ChosenArray Chosen;
};

/// Finds the array that `choice` asks for in `source`, a dataset or blocks of such. Where none was
/// chosen and there is no SpacingArrayName, it is the only point array with one component, if there
/// is just one. Blocks are one source: those that have the array, as one grid where they tile it
/// and agree where they meet, else by their cells; where these overlap, the smallest value counts.
SourceData ChooseSource(vtkInformation* choice, vtkDataObject* source);

/// The mask of VTK's probes and resamplings: 0 at points outside of their source.
constexpr const char* ValidMaskName = "vtkValidPointMask";

/// A source as one dataset with all point arrays of its blocks: itself where it is one, else the
/// cells of all. Null where there are no points.
vtkSmartPointer<vtkDataSet> WholeSource(vtkDataObject* source);

/// The mask of a dataset, null where it has none.
vtkDataArray* MaskOf(vtkDataSet* data);

} // namespace biting

#endif
