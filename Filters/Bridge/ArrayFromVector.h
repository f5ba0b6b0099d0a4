// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingArrayFromVector_h
#define BitingArrayFromVector_h

#include "../Kernel/Base/Ids.h"

#include "vtkCellArray.h"   // for cells
#include "vtkFieldData.h"   // for the owner of the array
#include "vtkIdTypeArray.h" // for connectivity
#include "vtkNew.h"         // for new arrays

#include <algorithm> // for transform
#include <vector>    // for the values

namespace biting
{

/// Adds the array `name` of type ArrayType with `values` to `data`.
template <typename ArrayType, typename Value>
void AddArray(vtkFieldData* data, const char* name, const std::vector<Value>& values)
{
  vtkNew<ArrayType> array;
  array->SetName(name);
  array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()));
  std::transform(values.begin(), values.end(), array->GetPointer(0),
    [](const Value& value) { return static_cast<typename ArrayType::ValueType>(value); });
  data->AddArray(array);
}

/// Makes `connectivity` cells of `cellSize` points each.
inline void SetCells(vtkCellArray* cells, vtkIdType cellSize, const std::vector<Id>& connectivity)
{
  vtkNew<vtkIdTypeArray> points;
  points->SetNumberOfValues(static_cast<vtkIdType>(connectivity.size()));
  std::copy(connectivity.begin(), connectivity.end(), points->GetPointer(0));
  vtkNew<vtkIdTypeArray> offsets;
  const vtkIdType numberOfCells = points->GetNumberOfValues() / cellSize;
  offsets->SetNumberOfValues(numberOfCells + 1);
  vtkIdType* offset = offsets->GetPointer(0);
  for (vtkIdType cell = 0; cell <= numberOfCells; ++cell)
  {
    offset[cell] = cell * cellSize;
  }
  cells->SetData(offsets, points);
}

} // namespace biting

#endif
