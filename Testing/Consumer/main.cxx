// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

// Meshes the unit square and checks that its triangles cover it.

#include "vtkBitingMesher.h"

#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTriangle.h"

#include <cmath>    // for abs
#include <cstdlib>  // for EXIT_SUCCESS
#include <iostream> // for the reason of a failure

namespace
{

vtkNew<vtkPolyData> MakeUnitSquare()
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->InsertNextPoint(0.0, 0.0, 0.0);
  points->InsertNextPoint(1.0, 0.0, 0.0);
  points->InsertNextPoint(1.0, 1.0, 0.0);
  points->InsertNextPoint(0.0, 1.0, 0.0);
  const vtkIdType loop[] = { 0, 1, 2, 3, 0 };
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell(5, loop);

  vtkNew<vtkPolyData> square;
  square->SetPoints(points);
  square->SetLines(lines);
  return square;
}

double Area(vtkPolyData* mesh)
{
  double area = 0.0;
  vtkNew<vtkIdList> corners;
  for (vtkIdType cellId = 0; cellId < mesh->GetNumberOfCells(); ++cellId)
  {
    mesh->GetCellPoints(cellId, corners);
    double a[3], b[3], c[3];
    mesh->GetPoint(corners->GetId(0), a);
    mesh->GetPoint(corners->GetId(1), b);
    mesh->GetPoint(corners->GetId(2), c);
    area += vtkTriangle::TriangleArea(a, b, c);
  }
  return area;
}

} // anonymous namespace

int main()
{
  const vtkNew<vtkPolyData> square = MakeUnitSquare();
  vtkNew<vtkBitingMesher> mesher;
  mesher->SetInputData(square);
  mesher->SetUniformSpacing(0.1);
  mesher->Update();

  vtkPolyData* mesh = mesher->GetOutput();
  const double area = Area(mesh);
  if (mesh->GetNumberOfCells() < 100 || std::abs(area - 1.0) > 1e-12)
  {
    std::cerr << mesh->GetNumberOfCells() << " triangles of area " << area
              << " for the unit square\n";
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
