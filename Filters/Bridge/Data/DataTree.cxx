// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "DataTree.h"

#include "../../vtkBitingCompat.h"

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkInformation.h"

namespace biting
{

namespace
{

// The children of all kinds of trees alike, which VTK has, but keeps protected.
struct Children : vtkDataObjectTree
{
  using vtkDataObjectTree::GetChild;
  using vtkDataObjectTree::GetChildMetaData;
  using vtkDataObjectTree::GetNumberOfChildren;
  using vtkDataObjectTree::HasChildMetaData;
  using vtkDataObjectTree::SetChild;
};

} // namespace

unsigned int NumberOfChildren(vtkDataObjectTree* tree)
{
  return (tree->*&Children::GetNumberOfChildren)();
}

vtkDataObject* ChildOf(vtkDataObjectTree* tree, unsigned int child)
{
  return (tree->*&Children::GetChild)(child);
}

// Asking for metadata that is not there would make it.
std::string NameOfChild(vtkDataObjectTree* tree, unsigned int child)
{
  const bool hasData = (tree->*&Children::HasChildMetaData)(child) != 0;
  const char* name = hasData
    ? (tree->*&Children::GetChildMetaData)(child)->Get(vtkCompositeDataSet::NAME())
    : nullptr;
  return name ? name : "";
}

void SetChild(
  vtkDataObjectTree* tree, unsigned int child, vtkDataObject* object, const std::string& name)
{
  (tree->*&Children::SetChild)(child, object);
  if (!name.empty())
  {
    (tree->*&Children::GetChildMetaData)(child)->Set(vtkCompositeDataSet::NAME(), name.c_str());
  }
}

std::vector<vtkSmartPointer<vtkDataSet>> LeavesOf(vtkDataObject* object)
{
  std::vector<vtkSmartPointer<vtkDataSet>> leaves;
  const auto add = [&leaves](vtkDataObject* leaf)
  {
    auto* dataSet = vtkDataSet::SafeDownCast(leaf);
    if (dataSet && dataSet->GetNumberOfPoints() > 0)
    {
      leaves.emplace_back(dataSet);
    }
  };
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(object))
  {
    const auto iterator = vtk::TakeSmartPointer(composite->NewIterator());
    for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
    {
      add(iterator->GetCurrentDataObject());
    }
    return leaves;
  }
  add(object);
  return leaves;
}

} // namespace biting
