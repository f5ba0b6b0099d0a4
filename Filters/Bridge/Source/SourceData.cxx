// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SourceData.h"

#include "../Data/Arrays.h"
#include "../Data/Cells.h"
#include "../Data/DataTree.h"
#include "../Ranks/WholeFromPieces.h"

#include "vtkAppendFilter.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkStructuredData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm> // for all_of, any_of, equal
#include <array>     // for extents
#include <cmath>     // for isnan
#include <limits>    // for NaN
#include <string>    // for names
#include <vector>    // for blocks

namespace biting
{

namespace
{

ChosenArray Refused(const std::string& refusal)
{
  ChosenArray chosen;
  chosen.Refusal = refusal;
  return chosen;
}

ChosenArray ActiveArray(int attribute, vtkDataSet* data, const ArrayRole& role)
{
  ChosenArray chosen;
  chosen.Array = data->GetPointData()->GetAttribute(attribute);
  return chosen.Array
    ? chosen
    : Refused("The " + std::string(role.Owner) + " has no active point array of the chosen kind.");
}

using DataSets = std::vector<vtkSmartPointer<vtkDataSet>>;

constexpr ArrayRole Role{ "spacing array", "spacing source" };

bool IsOfThePipeline(vtkPointData* data, int array)
{
  const std::string name = data->GetArrayName(array) ? data->GetArrayName(array) : "";
  const int attribute = data->IsArrayAnAttribute(array);
  return name == vtkDataSetAttributes::GhostArrayName() || name == ValidMaskName ||
    attribute == vtkDataSetAttributes::GLOBALIDS || attribute == vtkDataSetAttributes::PEDIGREEIDS;
}

std::string NameOf(vtkAbstractArray* array)
{
  return array->GetName() ? array->GetName() : "";
}

// The array of one component where there are none of other names, nor two in a block; else no data.
SourceData OnlyScalar(const DataSets& blocks)
{
  SourceData only;
  for (const auto& block : blocks)
  {
    for (int k = 0; k < block->GetPointData()->GetNumberOfArrays(); ++k)
    {
      vtkDataArray* array = block->GetPointData()->GetArray(k);
      if (!array || array->GetNumberOfComponents() != 1 ||
        IsOfThePipeline(block->GetPointData(), k))
      {
        continue;
      }
      if (only.Data && (only.Data == block || NameOf(array) != NameOf(only.Chosen.Array)))
      {
        return {};
      }
      only.Data = only.Data ? only.Data : block;
      only.Chosen.Array = only.Chosen.Array ? only.Chosen.Array : array;
    }
  }
  return only;
}

// The array, with NaN where the mask of the block says that nothing was found.
vtkSmartPointer<vtkAbstractArray> Valid(vtkAbstractArray* given, vtkDataSet* block)
{
  vtkDataArray* mask = MaskOf(block);
  auto* array = vtkDataArray::SafeDownCast(given);
  if (!mask || !array || array->GetNumberOfComponents() != 1 ||
    array->GetNumberOfTuples() != mask->GetNumberOfTuples())
  {
    return given;
  }
  auto valid = vtkSmartPointer<vtkDoubleArray>::New();
  valid->SetName(array->GetName());
  valid->SetNumberOfTuples(array->GetNumberOfTuples());
  for (vtkIdType point = 0; point < valid->GetNumberOfTuples(); ++point)
  {
    const bool isKnown = mask->GetComponent(point, 0) != 0.0;
    valid->SetValue(
      point, isKnown ? array->GetComponent(point, 0) : std::numeric_limits<double>::quiet_NaN());
  }
  return valid;
}

// The blocks with an array of this name, and nothing else of them; the arrays are alike. Only the
// block whose array has too few values, if there is one: it is refused for that.
DataSets BlocksWith(const std::string& name, const DataSets& blocks)
{
  DataSets with;
  for (const auto& block : blocks)
  {
    if (vtkAbstractArray* array = block->GetPointData()->GetAbstractArray(name.c_str()))
    {
      auto bare = vtk::TakeSmartPointer(block->NewInstance());
      bare->CopyStructure(block);
      bare->GetPointData()->AddArray(Valid(array, block));
      for (const int association : { vtkDataObject::POINT, vtkDataObject::CELL })
      {
        if (vtkUnsignedCharArray* ghosts = GhostsOf(block, association))
        {
          bare->GetAttributes(association)->AddArray(ghosts);
        }
      }
      if (array->GetNumberOfTuples() < block->GetNumberOfPoints())
      {
        return { bare };
      }
      with.push_back(bare);
    }
  }
  MakeArraysAlike(with);
  return with;
}

bool AreSame(double a, double b)
{
  return a == b || (std::isnan(a) && std::isnan(b));
}

// Whether a block of `grid`, whose extent is within that of the grid, has the same places and
// values.
bool Agrees(vtkDataSet* grid, vtkDataSet* block, const std::string& name)
{
  vtkDataArray* all = grid->GetPointData()->GetArray(name.c_str());
  vtkDataArray* own = block->GetPointData()->GetArray(name.c_str());
  std::array<int, 6> whole{};
  std::array<int, 6> part{};
  FindExtent(grid, whole);
  FindExtent(block, part);
  bool isSame = own->GetNumberOfTuples() >= block->GetNumberOfPoints();
  for (vtkIdType point = 0; point < block->GetNumberOfPoints() && isSame; ++point)
  {
    int place[3];
    vtkStructuredData::ComputePointStructuredCoordsForExtent(point, part.data(), place);
    const vtkIdType same = vtkStructuredData::ComputePointIdForExtent(whole.data(), place);
    double wanted[3];
    double given[3];
    grid->GetPoint(same, wanted);
    block->GetPoint(point, given);
    isSame = std::equal(wanted, wanted + 3, given) &&
      AreSame(all->GetComponent(same, 0), own->GetComponent(point, 0));
  }
  return isSame;
}

// Null where blocks are no grid, or have several values at one point of it.
vtkSmartPointer<vtkDataSet> AsGrid(const DataSets& blocks, const std::string& name)
{
  const auto grid = StructuredFromPieces(blocks);
  const auto agrees = [&grid, &name](vtkDataSet* block) { return Agrees(grid, block, name); };
  return grid && std::all_of(blocks.begin(), blocks.end(), agrees) ? grid : nullptr;
}

// All cells, with points of their own for each block.
vtkSmartPointer<vtkDataSet> Appended(const DataSets& blocks)
{
  vtkNew<vtkAppendFilter> append;
  for (const auto& block : blocks)
  {
    append->AddInputData(block);
  }
  append->Update();
  return append->GetOutput();
}

// The order of the results of blocks: found, refused, missing with a cell array, missing.
int RankOf(const ChosenArray& chosen)
{
  const int ofNothing = chosen.Refusal.empty() ? static_cast<int>(chosen.IsOfCells) : 2;
  return chosen.Array ? 3 : ofNothing;
}

SourceData ChooseBlock(vtkInformation* choice, const DataSets& blocks)
{
  SourceData found;
  for (const auto& block : blocks)
  {
    const ChosenArray chosen = ChooseArray(choice, block, Role);
    if (!found.Data || RankOf(chosen) > RankOf(found.Chosen))
    {
      found.Data = block;
      found.Chosen = chosen;
    }
  }
  const SourceData only = found.Chosen.IsMissing ? OnlyScalar(blocks) : SourceData();
  return only.Data ? only : found;
}

// Makes one source of all blocks that have the array found in one of them.
void JoinBlocks(const DataSets& blocks, SourceData& found)
{
  const std::string name = NameOf(found.Chosen.Array);
  const DataSets with = BlocksWith(name, blocks);
  if (with.empty())
  {
    return;
  }
  found.Data = with.front();
  found.Chosen = ArrayNamed(name.c_str(), found.Data, Role);
  if (with.size() > 1 && found.Chosen.Array)
  {
    const auto grid = AsGrid(with, name);
    found.Data = grid ? grid : Appended(with);
    found.Chosen.Array = found.Data->GetPointData()->GetArray(name.c_str());
  }
}

} // namespace

ChosenArray ArrayNamed(const char* name, vtkDataSet* data, const ArrayRole& role)
{
  ChosenArray chosen;
  chosen.Array = data->GetPointData()->GetArray(name);
  const std::string text = name;
  const std::string owner = role.Owner;
  const bool mayBeMissing = text.empty() || text == "None" || text == SpacingArrayName;
  if (!chosen.Array && data->GetPointData()->GetAbstractArray(name))
  {
    return Refused(
      "The " + std::string(role.Array) + " " + text + " of the " + owner + " is not numeric.");
  }
  if (!chosen.Array && !mayBeMissing)
  {
    return Refused("The " + owner + " has no point array named " + text + "." +
      (data->GetCellData()->HasArray(name) ? CellDataAdvice : ""));
  }
  chosen.IsMissing = !chosen.Array && text == SpacingArrayName;
  chosen.IsOfCells = chosen.IsMissing && data->GetCellData()->HasArray(name);
  return chosen;
}

ChosenArray ChooseArray(vtkInformation* choice, vtkDataSet* data, const ArrayRole& role)
{
  const bool isSet = choice->Has(vtkDataObject::FIELD_ASSOCIATION());
  if (isSet &&
    choice->Get(vtkDataObject::FIELD_ASSOCIATION()) != vtkDataObject::FIELD_ASSOCIATION_POINTS)
  {
    return Refused("The " + std::string(role.Array) + " of the " + std::string(role.Owner) +
      " must be point data." + CellDataAdvice);
  }
  if (choice->Has(vtkDataObject::FIELD_NAME()))
  {
    return ArrayNamed(choice->Get(vtkDataObject::FIELD_NAME()), data, role);
  }
  if (choice->Has(vtkDataObject::FIELD_ATTRIBUTE_TYPE()))
  {
    return ActiveArray(choice->Get(vtkDataObject::FIELD_ATTRIBUTE_TYPE()), data, role);
  }
  return ArrayNamed(SpacingArrayName, data, role);
}

vtkSmartPointer<vtkDataSet> WholeSource(vtkDataObject* source)
{
  DataSets blocks = LeavesOf(source);
  if (blocks.size() < 2)
  {
    return blocks.empty() ? nullptr : blocks.front();
  }
  for (auto& block : blocks)
  {
    auto copy = vtk::TakeSmartPointer(block->NewInstance());
    copy->ShallowCopy(block);
    block = copy;
  }
  MakeArraysAlike(blocks);
  return Appended(blocks);
}

vtkDataArray* MaskOf(vtkDataSet* data)
{
  vtkDataArray* mask = data->GetPointData()->GetArray(ValidMaskName);
  return mask && mask->GetNumberOfComponents() == 1 &&
      mask->GetNumberOfTuples() == data->GetNumberOfPoints()
    ? mask
    : nullptr;
}

SourceData ChooseSource(vtkInformation* choice, vtkDataObject* source)
{
  DataSets blocks = LeavesOf(source);
  if (blocks.empty() && vtkDataSet::SafeDownCast(source))
  {
    // A dataset without points is refused, or not used, for what it lacks.
    blocks.emplace_back(vtkDataSet::SafeDownCast(source));
  }
  if (blocks.empty())
  {
    SourceData nothing;
    nothing.Chosen.IsMissing = true;
    return nothing;
  }
  SourceData found = ChooseBlock(choice, blocks);
  const auto hasMask = [](vtkDataSet* block) { return MaskOf(block) != nullptr; };
  const bool isMasked = std::any_of(blocks.begin(), blocks.end(), hasMask);
  if ((blocks.size() > 1 || isMasked) && found.Chosen.Array)
  {
    JoinBlocks(blocks, found);
  }
  return found;
}

} // namespace biting
