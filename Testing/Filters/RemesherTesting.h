// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingRemesherTesting_h
#define BitingRemesherTesting_h

#include "FilterTesting.h"

#include "vtkBitingRemesher.h"

#include <algorithm>  // for min, max
#include <functional> // for fields
#include <string>     // for names

/// Meshes with fields, and remeshers of them.
namespace testing_filters
{

constexpr double Spacing = 0.05;

inline vtkSmartPointer<vtkPolyData> Meshed(vtkPolyData* drawing, vtkPolyData** edges = nullptr)
{
  vtkNew<vtkBitingMesher> mesher;
  mesher->SetInputData(drawing);
  mesher->SetUniformSpacing(Spacing);
  mesher->Update();
  if (edges)
  {
    *edges = mesher->GetOutput(1);
    (*edges)->Register(nullptr);
  }
  return mesher->GetOutput();
}

inline vtkSmartPointer<vtkPolyData> SquareMesh()
{
  return Meshed(UnitSquare());
}

inline double Linear(const Place& place)
{
  return 3.0 * place[0] - 2.0 * place[1] + 1.0;
}

inline double Half(const Place& /*place*/)
{
  return 0.5 * Spacing;
}

/// Half of the spacing at the left, with slope 0.2.
inline double Left(const Place& place)
{
  return std::min(Spacing, 0.5 * Spacing + 0.2 * std::max(place[0] - 0.2, 0.0));
}

inline void AddField(
  vtkDataSet* mesh, const char* name, const std::function<double(const Place&)>& field)
{
  vtkNew<vtkDoubleArray> values;
  values->SetName(name);
  for (vtkIdType point = 0; point < mesh->GetNumberOfPoints(); ++point)
  {
    Place place;
    mesh->GetPoint(point, place.data());
    values->InsertNextValue(field(place));
  }
  mesh->GetPointData()->AddArray(values);
}

/// The mesh with a field `Wanted`.
inline vtkSmartPointer<vtkPolyData> Wanting(
  vtkPolyData* mesh, const std::function<double(const Place&)>& field)
{
  auto wanting = vtkSmartPointer<vtkPolyData>::New();
  wanting->ShallowCopy(mesh);
  AddField(wanting, "Wanted", field);
  return wanting;
}

inline vtkNew<vtkBitingRemesher> RemesherOf(vtkDataSet* mesh)
{
  vtkNew<vtkBitingRemesher> remesher;
  remesher->SetInputDataObject(mesh);
  if (mesh->GetPointData()->HasArray("Wanted"))
  {
    remesher->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Wanted");
  }
  return remesher;
}

} // namespace testing_filters

#endif
