// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef FilterTesting_h
#define FilterTesting_h

#include "vtkBitingMesher.h"

#include "vtkCallbackCommand.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCommand.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkExecutive.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <array>   // for places
#include <cmath>   // for circles
#include <cstring> // for comparing bytes
#include <string>  // for messages
#include <vector>  // for lists

/// Small inputs, messages and comparisons that the tests of the filter share.
namespace testing_filters
{

using Place = std::array<double, 3>;

/// Adds points and one polyline through them; a closed one repeats its first point id.
inline void AddChain(vtkPolyData* data, const std::vector<Place>& places, bool isClosed)
{
  vtkIdType first = 0;
  for (std::size_t k = 0; k < places.size(); ++k)
  {
    const vtkIdType id = data->GetPoints()->InsertNextPoint(places[k].data());
    first = k == 0 ? id : first;
  }
  const auto size = static_cast<vtkIdType>(places.size());
  data->GetLines()->InsertNextCell(static_cast<int>(size + (isClosed ? 1 : 0)));
  for (vtkIdType k = 0; k < size; ++k)
  {
    data->GetLines()->InsertCellPoint(first + k);
  }
  if (isClosed)
  {
    data->GetLines()->InsertCellPoint(first);
  }
}

inline vtkSmartPointer<vtkPolyData> EmptyInput(int pointType = VTK_DOUBLE)
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataType(pointType);
  data->SetPoints(points);
  data->SetVerts(vtkNew<vtkCellArray>());
  data->SetLines(vtkNew<vtkCellArray>());
  data->SetPolys(vtkNew<vtkCellArray>());
  return data;
}

inline std::vector<Place> Rectangle(double x0, double y0, double x1, double y1, double z = 0.0)
{
  return { { x0, y0, z }, { x1, y0, z }, { x1, y1, z }, { x0, y1, z } };
}

/// The unit square as one closed polyline, points 0 to 3.
inline vtkSmartPointer<vtkPolyData> UnitSquare(double z = 0.0, int pointType = VTK_DOUBLE)
{
  auto data = EmptyInput(pointType);
  AddChain(data, Rectangle(0.0, 0.0, 1.0, 1.0, z), true);
  return data;
}

inline void AddVertex(vtkPolyData* data, const Place& place)
{
  const vtkIdType id = data->GetPoints()->InsertNextPoint(place.data());
  data->GetVerts()->InsertNextCell(1, &id);
}

template <typename ArrayType>
void AddArray(vtkFieldData* data, const char* name, const std::vector<double>& values)
{
  vtkNew<ArrayType> array;
  array->SetName(name);
  for (const double value : values)
  {
    array->InsertNextValue(static_cast<typename ArrayType::ValueType>(value));
  }
  data->AddArray(array);
}

/// Errors and warnings of a filter, as text; while it listens nothing is printed.
class Messages
{
public:
  explicit Messages(vtkAlgorithm* filter)
  {
    this->Listen(filter, vtkCommand::ErrorEvent, &this->Errors);
    this->Listen(filter, vtkCommand::WarningEvent, &this->Warnings);
    // The executive would add a word of its own if a filter failed.
    this->Listen(filter->GetExecutive(), vtkCommand::ErrorEvent, &this->OfExecutive);
  }

  ~Messages()
  {
    for (const auto& listener : this->Listeners)
    {
      listener.Object->RemoveObserver(listener.Tag);
    }
  }

  Messages(const Messages&) = delete;
  void operator=(const Messages&) = delete;

  std::vector<std::string> Errors;
  std::vector<std::string> Warnings;
  std::vector<std::string> OfExecutive;

private:
  struct Listener
  {
    vtkSmartPointer<vtkObject> Object;
    unsigned long Tag;
  };

  void Listen(vtkObject* object, unsigned long event, std::vector<std::string>* list)
  {
    vtkNew<vtkCallbackCommand> command;
    command->SetClientData(list);
    command->SetCallback([](vtkObject*, unsigned long, void* data, void* text)
      { static_cast<std::vector<std::string>*>(data)->push_back(static_cast<const char*>(text)); });
    this->Listeners.push_back({ object, object->AddObserver(event, command) });
  }

  std::vector<Listener> Listeners;
};

inline bool Has(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

inline double Figure(vtkDataSet* mesh, const char* name)
{
  vtkDataArray* array = mesh->GetFieldData()->GetArray(name);
  return array && array->GetNumberOfTuples() == 1 ? array->GetComponent(0, 0) : std::nan("");
}

inline Place PointOf(vtkDataSet* data, vtkIdType point)
{
  Place place;
  data->GetPoint(point, place.data());
  return place;
}

/// Sum of the triangles' areas in space.
inline double AreaOf(vtkPolyData* mesh)
{
  double area = 0.0;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfPolys(); ++cell)
  {
    vtkNew<vtkIdList> ids;
    mesh->GetCellPoints(cell, ids);
    const Place a = PointOf(mesh, ids->GetId(0));
    const Place b = PointOf(mesh, ids->GetId(1));
    const Place c = PointOf(mesh, ids->GetId(2));
    Place cross;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const std::size_t l = (k + 1) % 3;
      const std::size_t m = (k + 2) % 3;
      cross[k] = (b[l] - a[l]) * (c[m] - a[m]) - (b[m] - a[m]) * (c[l] - a[l]);
    }
    area += 0.5 * std::sqrt(cross[0] * cross[0] + cross[1] * cross[1] + cross[2] * cross[2]);
  }
  return area;
}

inline bool AreSameBytes(vtkDataArray* a, vtkDataArray* b)
{
  const bool isSameSize = a && b && a->GetDataType() == b->GetDataType() &&
    a->GetNumberOfValues() == b->GetNumberOfValues();
  const auto size = static_cast<std::size_t>(isSameSize ? a->GetNumberOfValues() : 0) *
    static_cast<std::size_t>(isSameSize ? a->GetDataTypeSize() : 0);
  return isSameSize &&
    (size == 0 || std::memcmp(a->GetVoidPointer(0), b->GetVoidPointer(0), size) == 0);
}

inline bool AreSameArrays(vtkFieldData* a, vtkFieldData* b)
{
  bool isSame = a->GetNumberOfArrays() == b->GetNumberOfArrays();
  for (int k = 0; isSame && k < a->GetNumberOfArrays(); ++k)
  {
    isSame = AreSameBytes(a->GetArray(k), b->GetArray(a->GetArrayName(k)));
  }
  return isSame;
}

/// Whether points, cells and all arrays are equal, byte for byte.
inline bool AreSame(vtkPolyData* a, vtkPolyData* b)
{
  return AreSameBytes(a->GetPoints()->GetData(), b->GetPoints()->GetData()) &&
    AreSameBytes(a->GetPolys()->GetConnectivityArray(), b->GetPolys()->GetConnectivityArray()) &&
    AreSameBytes(a->GetLines()->GetConnectivityArray(), b->GetLines()->GetConnectivityArray()) &&
    AreSameArrays(a->GetPointData(), b->GetPointData()) &&
    AreSameArrays(a->GetCellData(), b->GetCellData()) &&
    AreSameArrays(a->GetFieldData(), b->GetFieldData());
}

inline bool IsEmpty(vtkDataSet* data)
{
  return data && data->GetNumberOfPoints() == 0 && data->GetNumberOfCells() == 0;
}

inline bool AreAllEmpty(vtkBitingMesher* mesher)
{
  return IsEmpty(mesher->GetOutput(0)) && IsEmpty(mesher->GetOutput(1)) &&
    IsEmpty(mesher->GetOutput(2));
}

} // namespace testing_filters

#endif
