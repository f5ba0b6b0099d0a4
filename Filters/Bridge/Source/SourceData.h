// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingSourceData_h
#define BitingSourceData_h

#include "../../vtkBitingCompat.h" // for the ABI namespace
#include "ChosenArray.h"

#include "vtkSmartPointer.h" // for datasets

VTK_ABI_NAMESPACE_BEGIN
class vtkDataObject;
class vtkDataSet;
VTK_ABI_NAMESPACE_END

namespace biting
{

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

} // namespace biting

#endif
