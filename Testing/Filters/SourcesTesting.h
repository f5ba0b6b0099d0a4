// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingSourcesTesting_h
#define BitingSourcesTesting_h

#include "FilterTesting.h"

#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkRectilinearGrid.h"
#include "vtkStructuredGrid.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <functional> // for what is expected
#include <string>     // for refusals

namespace testing_filters
{

constexpr int Points = vtkDataObject::FIELD_ASSOCIATION_POINTS;

// The spacing that every source here carries: linear, so that every interpolation is exact.
inline double Linear(const Place& place)
{
  return 0.05 + 0.1 * place[0] + 0.05 * place[1];
}

inline void AddLinearSpacing(vtkDataSet* data, const char* name = "Spacing")
{
  std::vector<double> values;
  for (vtkIdType point = 0; point < data->GetNumberOfPoints(); ++point)
  {
    Place place;
    data->GetPoint(point, place.data());
    values.push_back(Linear(place));
  }
  AddArray<vtkDoubleArray>(data->GetPointData(), name, values);
}

inline vtkSmartPointer<vtkImageData> Image(int nx, int ny, int nz)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(nx, ny, nz);
  image->SetSpacing(1.0 / (nx - 1), 1.0 / (ny - 1), nz > 1 ? 1.0 / (nz - 1) : 1.0);
  AddLinearSpacing(image);
  return image;
}

inline vtkSmartPointer<vtkPoints> PointsOf(vtkDataSet* data)
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  for (vtkIdType point = 0; point < data->GetNumberOfPoints(); ++point)
  {
    points->InsertNextPoint(data->GetPoint(point));
  }
  return points;
}

inline vtkSmartPointer<vtkDataSet> RectilinearGrid()
{
  auto grid = vtkSmartPointer<vtkRectilinearGrid>::New();
  vtkNew<vtkDoubleArray> nodes;
  for (const double node : { 0.0, 0.1, 0.3, 0.7, 1.0 })
  {
    nodes->InsertNextValue(node);
  }
  grid->SetDimensions(5, 5, 1);
  grid->SetXCoordinates(nodes);
  grid->SetYCoordinates(nodes);
  AddLinearSpacing(grid);
  return grid;
}

inline vtkSmartPointer<vtkDataSet> StructuredGrid()
{
  auto grid = vtkSmartPointer<vtkStructuredGrid>::New();
  grid->SetDimensions(6, 7, 1);
  grid->SetPoints(PointsOf(Image(6, 7, 1)));
  AddLinearSpacing(grid);
  return grid;
}

// The cells of an image as polygons: quads, or triangles where `isSplit`.
inline vtkSmartPointer<vtkDataSet> Polygons(bool isSplit)
{
  const auto image = Image(6, 7, 1);
  auto data = EmptyInput();
  data->SetPoints(PointsOf(image));
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < image->GetNumberOfCells(); ++cell)
  {
    image->GetCellPoints(cell, ids);
    const vtkIdType corner[4] = { ids->GetId(0), ids->GetId(1), ids->GetId(3), ids->GetId(2) };
    if (isSplit)
    {
      data->GetPolys()->InsertNextCell({ corner[0], corner[1], corner[2] });
      data->GetPolys()->InsertNextCell({ corner[0], corner[2], corner[3] });
    }
    else
    {
      data->GetPolys()->InsertNextCell(4, corner);
    }
  }
  AddLinearSpacing(data);
  return data;
}

// Tetrahedra about the plane z = 0: the six of each cube of a lattice in [0, 1] x [0, 1] x [low,
// high].
inline vtkSmartPointer<vtkDataSet> Tetrahedra(double low, double high)
{
  constexpr int Size = 4;
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  const auto id = [](int i, int j, int k)
  { return static_cast<vtkIdType>(i + Size * (j + Size * k)); };
  for (int k = 0; k < 3; ++k)
  {
    for (int j = 0; j < Size; ++j)
    {
      for (int i = 0; i < Size; ++i)
      {
        points->InsertNextPoint(i / (Size - 1.0), j / (Size - 1.0), low + 0.5 * k * (high - low));
      }
    }
  }
  grid->SetPoints(points);
  const int steps[6][3] = { { 0, 1, 2 }, { 0, 2, 1 }, { 1, 0, 2 }, { 1, 2, 0 }, { 2, 0, 1 },
    { 2, 1, 0 } };
  for (int cube = 0; cube < 2 * (Size - 1) * (Size - 1); ++cube)
  {
    for (const auto& step : steps)
    {
      int at[3] = { cube % (Size - 1), cube / (Size - 1) % (Size - 1),
        cube / ((Size - 1) * (Size - 1)) };
      vtkIdType tetrahedron[4] = { id(at[0], at[1], at[2]) };
      for (int corner = 1; corner < 4; ++corner)
      {
        ++at[step[corner - 1]];
        tetrahedron[corner] = id(at[0], at[1], at[2]);
      }
      grid->InsertNextCell(VTK_TETRA, 4, tetrahedron);
    }
  }
  AddLinearSpacing(grid);
  return grid;
}

// Meshes the unit square at height z with a source.
inline vtkSmartPointer<vtkBitingMesher> MesherWith(vtkDataSet* source, double z = 0.0)
{
  auto mesher = vtkSmartPointer<vtkBitingMesher>::New();
  mesher->SetInputData(UnitSquare(z));
  mesher->SetSpacingSourceData(source);
  return mesher;
}

// Expects the spacing of the mesh to be `expected` at every vertex.
inline void ExpectSpacing(vtkBitingMesher* mesher,
  const std::function<double(const Place&)>& expected, double tolerance = 1e-9)
{
  mesher->Update();
  vtkPolyData* mesh = mesher->GetOutput();
  vtkDataArray* spacing = mesh->GetPointData()->GetArray("Spacing");
  ASSERT_TRUE(spacing);
  ASSERT_GT(mesh->GetNumberOfPoints(), 4);
  for (vtkIdType point = 0; point < mesh->GetNumberOfPoints(); ++point)
  {
    const double wanted = expected(PointOf(mesh, point));
    ASSERT_NEAR(spacing->GetComponent(point, 0), wanted, tolerance * wanted);
  }
}

inline std::string RefusalOf(vtkBitingMesher* mesher)
{
  Messages messages(mesher);
  mesher->Update();
  EXPECT_EQ(messages.Errors.size(), 1u);
  EXPECT_TRUE(AreAllEmpty(mesher));
  return messages.Errors.empty() ? "" : messages.Errors.front();
}

} // namespace testing_filters

#endif
