// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SourceData.h"

#include "DataTree.h"
#include "MeshFromPieces.h"
#include "StructuredFromPieces.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkPointData.h"

#include <string> // for names
#include <vector> // for blocks

namespace biting
{

namespace
{

using DataSets = std::vector<vtkSmartPointer<vtkDataSet>>;

constexpr ArrayRole Role{ "spacing array", "spacing source" };

bool IsOfThePipeline(vtkPointData* data, int array)
{
  const std::string name = data->GetArrayName(array) ? data->GetArrayName(array) : "";
  const int attribute = data->IsArrayAnAttribute(array);
  return name == vtkDataSetAttributes::GhostArrayName() || name == "vtkValidPointMask" ||
    attribute == vtkDataSetAttributes::GLOBALIDS || attribute == vtkDataSetAttributes::PEDIGREEIDS;
}

// Null where there is none, or more than one.
vtkDataArray* OnlyScalar(vtkPointData* data)
{
  vtkDataArray* only = nullptr;
  int count = 0;
  for (int k = 0; k < data->GetNumberOfArrays(); ++k)
  {
    vtkDataArray* array = data->GetArray(k);
    if (array && array->GetNumberOfComponents() == 1 && !IsOfThePipeline(data, k))
    {
      only = array;
      ++count;
    }
  }
  return count == 1 ? only : nullptr;
}

ChosenArray ChooseIn(vtkInformation* choice, vtkDataSet* block)
{
  ChosenArray chosen = ChooseArray(choice, block, Role);
  if (chosen.IsMissing)
  {
    chosen.Array = OnlyScalar(block->GetPointData());
    chosen.IsMissing = !chosen.Array;
  }
  return chosen;
}

std::string NameOf(vtkDataArray* array)
{
  return array->GetName() ? array->GetName() : "";
}

// The blocks with an array of this name, and nothing else of them.
DataSets BlocksWith(const std::string& name, const DataSets& blocks)
{
  DataSets with;
  for (const auto& block : blocks)
  {
    vtkDataArray* array = block->GetPointData()->GetArray(name.c_str());
    if (array)
    {
      auto bare = vtk::TakeSmartPointer(block->NewInstance());
      bare->CopyStructure(block);
      bare->GetPointData()->AddArray(array);
      for (const int association : { vtkDataObject::POINT, vtkDataObject::CELL })
      {
        vtkDataArray* ghosts =
          block->GetAttributes(association)->GetArray(vtkDataSetAttributes::GhostArrayName());
        if (ghosts)
        {
          bare->GetAttributes(association)->AddArray(ghosts);
        }
      }
      with.push_back(bare);
    }
  }
  return with;
}

vtkSmartPointer<vtkDataSet> AsOne(const DataSets& blocks)
{
  const auto grid = StructuredFromPieces(blocks);
  return grid ? grid : MeshFromPieces(blocks);
}

} // namespace

SourceData ChooseSource(vtkInformation* choice, vtkDataObject* source)
{
  SourceData found;
  const DataSets blocks = LeavesOf(source);
  if (blocks.empty())
  {
    // A dataset without points is refused, or not used, for what it lacks.
    found.Data = vtkDataSet::SafeDownCast(source);
    found.Chosen.IsMissing = true;
    found.Chosen = found.Data ? ChooseIn(choice, found.Data) : found.Chosen;
    return found;
  }
  for (const auto& block : blocks)
  {
    const ChosenArray chosen = ChooseIn(choice, block);
    if (!found.Data || (chosen.Array && !found.Chosen.Array))
    {
      found.Data = block;
      found.Chosen = chosen;
    }
  }
  if (blocks.size() > 1 && found.Chosen.Array)
  {
    const std::string name = NameOf(found.Chosen.Array);
    const DataSets with = BlocksWith(name, blocks);
    found.Data = with.size() > 1 ? AsOne(with) : found.Data;
    found.Chosen.Array = found.Data->GetPointData()->GetArray(name.c_str());
  }
  return found;
}

} // namespace biting
