// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "RegionNumbers.h"

#include "vtkAbstractArray.h"
#include "vtkDataArray.h"
#include "vtkVariant.h"

#include <cmath>   // for isnan
#include <cstdint> // for whole numbers
#include <cstring> // for memcpy
#include <map>     // for numbers

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

} // namespace biting
