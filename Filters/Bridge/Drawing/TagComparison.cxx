// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "TagComparison.h"

#include "vtkAbstractArray.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkVariant.h"

#include <algorithm> // for all_of, find
#include <cstddef>   // for size_t
#include <cstdint>   // for flags
#include <cstring>   // for memcmp
#include <iterator>  // for begin, end
#include <string>    // for names
#include <vector>    // for arrays

namespace biting
{

namespace
{

// Numbers of the cells from which cells came, as our filters and VTK's write them: they differ from
// cell to cell, and say nothing of the boundary.
constexpr const char* CellNumbers[] = { "OriginalCellId", "vtkOriginalCellIds" };

bool IsTag(const Drawing& drawing, vtkAbstractArray* array)
{
  auto* data = vtkDataSetAttributes::SafeDownCast(drawing.CellArrays);
  const bool isId = data && (array == data->GetGlobalIds() || array == data->GetPedigreeIds());
  const std::string name = array->GetName() ? array->GetName() : "";
  return array->GetNumberOfTuples() >= drawing.NumberOfCells &&
    name != vtkDataSetAttributes::GhostArrayName() && !isId &&
    std::find(std::begin(CellNumbers), std::end(CellNumbers), name) == std::end(CellNumbers);
}

std::vector<std::uint8_t> FindFaces(const Drawing& drawing, const Polylines& chains)
{
  std::vector<std::uint8_t> isFace(static_cast<std::size_t>(drawing.NumberOfCells), 0);
  for (std::size_t chain = 0; chain < chains.Cells.size(); ++chain)
  {
    isFace[static_cast<std::size_t>(chains.Cells[chain])] = chains.Kinds[chain] == ChainKind::Face;
  }
  return isFace;
}

// Numbers by their bytes, where these lie in a row; all others by value.
bool AreEqual(vtkAbstractArray* array, vtkIdType first, vtkIdType second)
{
  const int components = array->GetNumberOfComponents();
  if (vtkDataArray::FastDownCast(array) && array->HasStandardMemoryLayout() &&
    array->GetDataType() != VTK_BIT)
  {
    const auto size = static_cast<std::size_t>(components * array->GetDataTypeSize());
    return std::memcmp(array->GetVoidPointer(components * first),
             array->GetVoidPointer(components * second), size) == 0;
  }
  for (int k = 0; k < components; ++k)
  {
    if (array->GetVariantValue(components * first + k) !=
      array->GetVariantValue(components * second + k))
    {
      return false;
    }
  }
  return true;
}

} // namespace

std::function<bool(Id, Id)> CompareTags(const Drawing& drawing, const Polylines& chains)
{
  std::vector<vtkAbstractArray*> tags;
  for (int k = 0; k < drawing.CellArrays->GetNumberOfArrays(); ++k)
  {
    vtkAbstractArray* array = drawing.CellArrays->GetAbstractArray(k);
    if (IsTag(drawing, array))
    {
      tags.push_back(array);
    }
  }
  if (tags.empty())
  {
    return {};
  }
  return [tags, isFace = FindFaces(drawing, chains)](Id first, Id second)
  {
    const bool areFaces =
      isFace[static_cast<std::size_t>(first)] && isFace[static_cast<std::size_t>(second)];
    return areFaces ||
      std::all_of(tags.begin(), tags.end(),
        [first, second](vtkAbstractArray* tag) { return AreEqual(tag, first, second); });
  };
}

} // namespace biting
