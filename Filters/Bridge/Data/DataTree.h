// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingDataTree_h
#define BitingDataTree_h

#include "../../vtkBitingCompat.h" // for the ABI namespace

#include "vtkDataObjectTree.h"
#include "vtkSmartPointer.h" // for children

#include <string> // for names
#include <vector> // for leaves

VTK_ABI_NAMESPACE_BEGIN
class vtkDataSet;
VTK_ABI_NAMESPACE_END

namespace biting
{

/// Multi-block datasets, partitioned datasets and collections of these, all alike: children with
/// names.
unsigned int NumberOfChildren(vtkDataObjectTree* tree);
vtkDataObject* ChildOf(vtkDataObjectTree* tree, unsigned int child); ///< may be null
std::string NameOfChild(vtkDataObjectTree* tree, unsigned int child);
void SetChild(
  vtkDataObjectTree* tree, unsigned int child, vtkDataObject* object, const std::string& name);

/// The datasets in `object` that have points, in order: itself, or those of its blocks.
std::vector<vtkSmartPointer<vtkDataSet>> LeavesOf(vtkDataObject* object);

} // namespace biting

#endif
