// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "DoubleArray.h"

#include "vtkFloatArray.h"
#include "vtkPointSet.h"
#include "vtkRectilinearGrid.h"

#include <algorithm> // for all_of
#include <cmath>     // for isfinite

namespace biting
{

vtkSmartPointer<vtkDoubleArray> AsDoubles(vtkDataArray* array)
{
  vtkSmartPointer<vtkDoubleArray> doubles = vtkDoubleArray::FastDownCast(array);
  if (!doubles)
  {
    doubles = vtkSmartPointer<vtkDoubleArray>::New();
    doubles->DeepCopy(array);
  }
  return doubles;
}

std::vector<double> ReadDoubles(vtkDataArray* array, vtkIdType count)
{
  if (auto* floats = vtkFloatArray::FastDownCast(array))
  {
    return { floats->GetPointer(0), floats->GetPointer(0) + count };
  }
  const auto doubles = AsDoubles(array);
  return { doubles->GetPointer(0), doubles->GetPointer(0) + count };
}

vtkSmartPointer<vtkDoubleArray> CoordinatesOf(vtkDataSet* data)
{
  auto* pointSet = vtkPointSet::SafeDownCast(data);
  if (pointSet && pointSet->GetPoints())
  {
    return AsDoubles(pointSet->GetPoints()->GetData());
  }
  auto coordinates = vtkSmartPointer<vtkDoubleArray>::New();
  coordinates->SetNumberOfComponents(3);
  coordinates->SetNumberOfTuples(data->GetNumberOfPoints());
  for (vtkIdType point = 0; point < data->GetNumberOfPoints(); ++point)
  {
    data->GetPoint(point, coordinates->GetPointer(3 * point));
  }
  return coordinates;
}

int TypeOfCoordinates(vtkDataSet* data)
{
  if (auto* pointSet = vtkPointSet::SafeDownCast(data))
  {
    return pointSet->GetPoints() ? pointSet->GetPoints()->GetDataType() : VTK_DOUBLE;
  }
  auto* grid = vtkRectilinearGrid::SafeDownCast(data);
  const bool isFloat = grid && grid->GetXCoordinates()->GetDataType() == VTK_FLOAT;
  return isFloat ? VTK_FLOAT : VTK_DOUBLE;
}

bool AreFinite(const double* place)
{
  return std::all_of(place, place + 3, [](double value) { return std::isfinite(value); });
}

} // namespace biting
