// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingArrayFromVector_h
#define BitingArrayFromVector_h

#include "../../Kernel/Base/Ids.h"
#include "../../Kernel/Base/Pulse.h"

#include "vtkCellArray.h"             // for cells
#include "vtkDoubleArray.h"           // for figures
#include "vtkFieldData.h"             // for the owner of the array
#include "vtkIdTypeArray.h"           // for connectivity
#include "vtkInformation.h"           // for what is not offered
#include "vtkInformationIntegerKey.h" // for the mark of it
#include "vtkNew.h"                   // for new arrays
#include "vtkSmartPointer.h"          // for new arrays

#include <cstdint> // for counts
#include <vector>  // for the values

namespace biting
{

/// An array of the type, the name and the components of `given`, of `size` tuples without values.
inline vtkSmartPointer<vtkAbstractArray> NewArrayLike(vtkAbstractArray* given, vtkIdType size)
{
  auto array = vtk::TakeSmartPointer(given->NewInstance());
  array->SetName(given->GetName());
  array->SetNumberOfComponents(given->GetNumberOfComponents());
  array->CopyComponentNames(given);
  array->SetNumberOfTuples(size);
  return array;
}

/// Adds the array `name` of type ArrayType with `values` to `data`. On abort its values have no
/// meaning; so it is with all that is below.
template <typename ArrayType, typename Value>
void AddArray(vtkFieldData* data, const char* name, const std::vector<Value>& values, Pulse& pulse)
{
  vtkNew<ArrayType> array;
  array->SetName(name);
  array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()));
  auto* to = array->GetPointer(0);
  pulse.ForEach(values.size(),
    [&values, to](std::size_t k)
    { to[k] = static_cast<typename ArrayType::ValueType>(values[k]); });
  data->AddArray(array);
}

/// The same for few values.
template <typename ArrayType, typename Value>
void AddArray(vtkFieldData* data, const char* name, const std::vector<Value>& values)
{
  Pulse pulse(NoMonitor());
  AddArray<ArrayType>(data, name, values, pulse);
}

/// Keeps the array `name` out of the lists of arrays that programs offer to colour by: its value is
/// one of the whole mesh.
inline void HideFromChoices(vtkFieldData* data, const char* name)
{
  data->GetAbstractArray(name)->GetInformation()->Set(vtkAbstractArray::GUI_HIDE(), 1);
}

/// Adds an array of one value, which is not offered.
inline void AddCount(vtkFieldData* data, const char* name, std::int64_t count)
{
  AddArray<vtkIdTypeArray>(data, name, std::vector<std::int64_t>{ count });
  HideFromChoices(data, name);
}

inline void AddFigure(vtkFieldData* data, const char* name, double figure)
{
  AddArray<vtkDoubleArray>(data, name, std::vector<double>{ figure });
  HideFromChoices(data, name);
}

/// Makes `connectivity` cells of `cellSize` points each.
inline void SetCells(
  vtkCellArray* cells, vtkIdType cellSize, const std::vector<Id>& connectivity, Pulse& pulse)
{
  vtkNew<vtkIdTypeArray> points;
  points->SetNumberOfValues(static_cast<vtkIdType>(connectivity.size()));
  vtkIdType* point = points->GetPointer(0);
  pulse.ForEach(
    connectivity.size(), [&connectivity, point](std::size_t k) { point[k] = connectivity[k]; });
  vtkNew<vtkIdTypeArray> offsets;
  const vtkIdType numberOfCells = points->GetNumberOfValues() / cellSize;
  offsets->SetNumberOfValues(numberOfCells + 1);
  vtkIdType* offset = offsets->GetPointer(0);
  pulse.ForEach(static_cast<std::size_t>(numberOfCells + 1),
    [offset, cellSize](std::size_t cell)
    { offset[cell] = static_cast<vtkIdType>(cell) * cellSize; });
  cells->SetData(offsets, points);
}

/// The same for few cells.
inline void SetCells(vtkCellArray* cells, vtkIdType cellSize, const std::vector<Id>& connectivity)
{
  Pulse pulse(NoMonitor());
  SetCells(cells, cellSize, connectivity, pulse);
}

} // namespace biting

#endif
