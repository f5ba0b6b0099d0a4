// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "DataTree.h"

#include "../../vtkBitingCompat.h"

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"

namespace biting
{

namespace
{

vtkInformation* MetaDataOf(vtkDataObjectTree* tree, unsigned int child)
{
  if (auto* blocks = vtkMultiBlockDataSet::SafeDownCast(tree))
  {
    return blocks->GetMetaData(child);
  }
  if (auto* partitions = vtkPartitionedDataSet::SafeDownCast(tree))
  {
    return partitions->GetMetaData(child);
  }
  auto* collection = vtkPartitionedDataSetCollection::SafeDownCast(tree);
  return collection ? collection->GetMetaData(child) : nullptr;
}

// Asking for what is not there would make it.
bool HasMetaData(vtkDataObjectTree* tree, unsigned int child)
{
  if (auto* blocks = vtkMultiBlockDataSet::SafeDownCast(tree))
  {
    return blocks->HasMetaData(child) != 0;
  }
  if (auto* partitions = vtkPartitionedDataSet::SafeDownCast(tree))
  {
    return partitions->HasMetaData(child);
  }
  auto* collection = vtkPartitionedDataSetCollection::SafeDownCast(tree);
  return collection && collection->HasMetaData(child);
}

} // namespace

unsigned int NumberOfChildren(vtkDataObjectTree* tree)
{
  if (auto* blocks = vtkMultiBlockDataSet::SafeDownCast(tree))
  {
    return blocks->GetNumberOfBlocks();
  }
  if (auto* partitions = vtkPartitionedDataSet::SafeDownCast(tree))
  {
    return partitions->GetNumberOfPartitions();
  }
  auto* collection = vtkPartitionedDataSetCollection::SafeDownCast(tree);
  return collection ? collection->GetNumberOfPartitionedDataSets() : 0;
}

vtkDataObject* ChildOf(vtkDataObjectTree* tree, unsigned int child)
{
  if (auto* blocks = vtkMultiBlockDataSet::SafeDownCast(tree))
  {
    return blocks->GetBlock(child);
  }
  if (auto* partitions = vtkPartitionedDataSet::SafeDownCast(tree))
  {
    return partitions->GetPartitionAsDataObject(child);
  }
  auto* collection = vtkPartitionedDataSetCollection::SafeDownCast(tree);
  return collection ? collection->GetPartitionedDataSet(child) : nullptr;
}

std::string NameOfChild(vtkDataObjectTree* tree, unsigned int child)
{
  vtkInformation* info = HasMetaData(tree, child) ? MetaDataOf(tree, child) : nullptr;
  const char* name = info ? info->Get(vtkCompositeDataSet::NAME()) : nullptr;
  return name ? name : "";
}

void SetChild(
  vtkDataObjectTree* tree, unsigned int child, vtkDataObject* object, const std::string& name)
{
  if (auto* blocks = vtkMultiBlockDataSet::SafeDownCast(tree))
  {
    blocks->SetBlock(child, object);
  }
  else if (auto* partitions = vtkPartitionedDataSet::SafeDownCast(tree))
  {
    partitions->SetPartition(child, object);
  }
  else if (auto* collection = vtkPartitionedDataSetCollection::SafeDownCast(tree))
  {
    collection->SetPartitionedDataSet(child, vtkPartitionedDataSet::SafeDownCast(object));
  }
  vtkInformation* info = name.empty() ? nullptr : MetaDataOf(tree, child);
  if (info)
  {
    info->Set(vtkCompositeDataSet::NAME(), name.c_str());
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
