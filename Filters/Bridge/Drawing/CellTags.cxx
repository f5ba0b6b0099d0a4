// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "CellTags.h"

#include "vtkAbstractArray.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkSmartPointer.h"
#include "vtkVariant.h"

#include <algorithm> // for all_of, find
#include <cmath>     // for isnan
#include <cstddef>   // for size_t
#include <cstdint>   // for whole numbers
#include <cstring>   // for memcpy
#include <iterator>  // for begin, end
#include <map>       // for numbers
#include <string>    // for names
#include <vector>    // for arrays

namespace biting
{

namespace
{

// What is told apart of one cell.
using RegionKey = std::string;

template <typename Value>
void AppendBytes(Value value, RegionKey& key)
{
  char bytes[sizeof(Value)];
  std::memcpy(bytes, &value, sizeof(Value));
  key.append(bytes, sizeof(Value));
}

void AppendReal(double value, RegionKey& key)
{
  constexpr double Zero = 0.0;
  AppendBytes(value == Zero ? Zero : value, key);
}

// Of texts with the length, so that no two of them look like two others.
void AppendComponent(vtkAbstractArray* array, vtkIdType place, RegionKey& key)
{
  const vtkVariant value = array->GetVariantValue(place);
  if (value.IsFloat() || value.IsDouble())
  {
    const double real = value.ToDouble();
    std::isnan(real) ? AppendBytes('n', key) : AppendReal(real, key);
  }
  else if (value.IsNumeric())
  {
    AppendBytes(static_cast<std::int64_t>(value.ToTypeInt64()), key);
  }
  else
  {
    const std::string text = value.ToString();
    AppendBytes(text.size(), key);
    key += text;
  }
}

void SetKey(vtkAbstractArray* array, vtkIdType cell, RegionKey& key)
{
  key.clear();
  const int components = array->GetNumberOfComponents();
  for (int component = 0; component < components; ++component)
  {
    AppendComponent(array, cell * components + component, key);
  }
}

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
    isFace[chains.Cells[chain]] = chains.Kinds[chain] == ChainKind::Face;
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

std::string FindRegionNumbers(
  const Drawing& drawing, const std::string& name, std::vector<Id>& numbers, Pulse& pulse)
{
  numbers.clear();
  if (name.empty() || name == "None" || drawing.NumberOfCells == 0)
  {
    return {};
  }
  vtkAbstractArray* array = drawing.CellArrays->GetAbstractArray(name.c_str());
  if (!array)
  {
    return "The input has no cell array named " + name + ", which Region Array asks for.";
  }
  if (array->GetNumberOfTuples() < drawing.NumberOfCells)
  {
    return "The cell array " + name + " has " + std::to_string(array->GetNumberOfTuples()) +
      " values for " + std::to_string(drawing.NumberOfCells) + " cells.";
  }
  std::map<RegionKey, Id> known;
  RegionKey last;
  RegionKey key;
  for (vtkIdType cell = 0; cell < drawing.NumberOfCells && pulse.Beat(); ++cell)
  {
    SetKey(array, cell, key);
    const bool isSame = !numbers.empty() && key == last;
    numbers.push_back(
      isSame ? numbers.back() : known.emplace(key, static_cast<Id>(known.size())).first->second);
    last.swap(key);
  }
  return {};
}

std::string FindRegionValues(
  const Drawing& drawing, const std::string& name, RegionValues& values, Pulse& pulse)
{
  std::vector<Id>& numbers = values.Numbers;
  const std::string refusal = FindRegionNumbers(drawing, name, numbers, pulse);
  if (numbers.empty())
  {
    return refusal;
  }
  values.Array = drawing.CellArrays->GetAbstractArray(name.c_str());
  values.IsPairs = values.Array->GetNumberOfComponents() == 2;
  std::map<RegionKey, Id> known;
  RegionKey key;
  values.Pairs.assign(numbers.size(), { NoId, NoId });
  for (std::size_t cell = 0; cell < numbers.size() && pulse.Beat(); ++cell)
  {
    for (std::size_t k = 0; k < (values.IsPairs ? 2 : 1); ++k)
    {
      const auto place = static_cast<vtkIdType>(values.IsPairs ? 2 * cell + k : cell);
      key.clear();
      values.IsPairs ? AppendComponent(values.Array, place, key) : AppendBytes(numbers[cell], key);
      const auto added = known.emplace(key, static_cast<Id>(known.size()));
      values.Pairs[cell][k] = added.first->second;
      if (added.second)
      {
        values.Places.push_back(place);
      }
    }
  }
  return {};
}

void AddRegionValues(
  const RegionValues& values, const std::vector<Id>& regions, vtkFieldData* cells)
{
  if (!values.Array || std::string(values.Array->GetName()) == "RegionId")
  {
    return;
  }
  const auto own = vtkSmartPointer<vtkAbstractArray>::Take(values.Array->NewInstance());
  own->SetName(values.Array->GetName());
  own->SetNumberOfComponents(values.IsPairs ? 1 : values.Array->GetNumberOfComponents());
  own->SetNumberOfTuples(static_cast<vtkIdType>(regions.size()));
  for (std::size_t cell = 0; cell < regions.size(); ++cell)
  {
    const vtkIdType place = values.Places[regions[cell]];
    const auto at = static_cast<vtkIdType>(cell);
    values.IsPairs ? own->SetVariantValue(at, values.Array->GetVariantValue(place))
                   : own->SetTuple(at, place, values.Array);
  }
  cells->AddArray(own);
}

std::string FindCracks(
  const Drawing& drawing, const std::string& name, std::function<bool(Id)>& opens)
{
  if (name.empty() || name == "None" || drawing.NumberOfCells == 0)
  {
    return {};
  }
  vtkDataArray* array = drawing.CellArrays->GetArray(name.c_str());
  if (!array || array->GetNumberOfTuples() < drawing.NumberOfCells)
  {
    return "The input has no cell array of numbers named " + name +
      " with a value for each cell, which Split Interfaces asks for.";
  }
  opens = [array](Id cell)
  {
    const double value = array->GetComponent(cell, 0);
    return value != 0.0 && !std::isnan(value);
  };
  return {};
}

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
    const bool areFaces = isFace[first] && isFace[second];
    return areFaces ||
      std::all_of(tags.begin(), tags.end(),
        [first, second](vtkAbstractArray* tag) { return AreEqual(tag, first, second); });
  };
}

} // namespace biting
