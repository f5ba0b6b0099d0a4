// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

// Quads where triangles are asked for.

#include "MeshChecker.h"
#include "RemesherTesting.h"

#include "vtkCellType.h"
#include "vtkMeshConformity.h"
#include "vtkPlaneSource.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <algorithm> // for any_of, equal

using namespace testing_filters;

namespace
{

vtkSmartPointer<vtkPolyData> Quads(int columns, int rows)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetResolution(columns, rows);
  plane->Update();
  const vtkSmartPointer<vtkPolyData> quads = plane->GetOutput();
  std::vector<double> numbers;
  while (static_cast<vtkIdType>(numbers.size()) < quads->GetNumberOfCells())
  {
    numbers.push_back(static_cast<double>(numbers.size()));
  }
  AddArray<vtkDoubleArray>(quads->GetCellData(), "Number", numbers);
  return quads;
}

vtkSmartPointer<vtkUnstructuredGrid> AsPixels(vtkPolyData* quads)
{
  auto pixels = vtkSmartPointer<vtkUnstructuredGrid>::New();
  pixels->SetPoints(quads->GetPoints());
  for (vtkIdType cell = 0; cell < quads->GetNumberOfCells(); ++cell)
  {
    vtkIdList* corners = quads->GetCell(cell)->GetPointIds();
    const vtkIdType rows[] = { corners->GetId(0), corners->GetId(1), corners->GetId(3),
      corners->GetId(2) };
    pixels->InsertNextCell(VTK_PIXEL, 4, rows);
  }
  pixels->GetCellData()->ShallowCopy(quads->GetCellData());
  return pixels;
}

double ValueIn(vtkCellData* data, const char* array, vtkIdType cell)
{
  return data->GetArray(array)->GetComponent(cell, 0);
}

bool AreSaid(const Messages& messages)
{
  return messages.Errors.empty() &&
    std::any_of(messages.Warnings.begin(), messages.Warnings.end(),
      [](const std::string& text) { return Has(text, ": each is two triangles"); });
}

} // namespace

TEST(DividedQuads, AreMeasuredAsTwoTrianglesEachWithTheirArrays)
{
  const auto quads = Quads(3, 2);
  const auto pixels = AsPixels(quads);
  for (vtkDataSet* input : { static_cast<vtkDataSet*>(quads), static_cast<vtkDataSet*>(pixels) })
  {
    vtkNew<vtkMeshConformity> filter;
    const Messages messages(filter);
    filter->SetInputData(input);
    filter->Update();
    EXPECT_TRUE(AreSaid(messages));
    auto* output = vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0));
    ASSERT_EQ(output->GetNumberOfCells(), 12);
    for (vtkIdType cell = 0; cell < 12; ++cell)
    {
      EXPECT_EQ(output->GetCellType(cell), VTK_TRIANGLE);
      EXPECT_EQ(ValueIn(output->GetCellData(), "Number", cell), static_cast<double>(cell / 2));
      EXPECT_GT(ValueIn(output->GetCellData(), "MinimumAngle", cell), 30.0);
    }
    EXPECT_EQ(input->GetNumberOfCells(), 6);
  }
}

TEST(DividedQuads, AreRemeshedAndHaveTheNumbersOfTheirCells)
{
  const auto quads = Quads(20, 20);
  AddField(quads, "Wanted", [](const Place& place) { return place[0] < -0.3 ? 0.02 : 0.06; });
  const auto remesher = RemesherOf(quads);
  const Messages messages(remesher);
  remesher->Update();
  EXPECT_TRUE(AreSaid(messages));
  vtkPolyData* output = remesher->GetOutput();
  EXPECT_EQ(MeshChecker(output).CheckArea(1.0, 1e-12), "");
  vtkDataArray* originals = output->GetCellData()->GetArray("OriginalCellId");
  vtkIdType kept = 0;
  for (vtkIdType cell = 0; cell < output->GetNumberOfCells(); ++cell)
  {
    const auto original = static_cast<vtkIdType>(originals->GetComponent(cell, 0));
    ASSERT_LT(original, 400);
    if (original >= 0)
    {
      ++kept;
      double quad[6];
      double triangle[6];
      quads->GetCell(original)->GetBounds(quad);
      output->GetCell(cell)->GetBounds(triangle);
      EXPECT_TRUE(std::equal(quad, quad + 6, triangle));
      EXPECT_EQ(ValueIn(output->GetCellData(), "Number", cell), static_cast<double>(original));
    }
  }
  EXPECT_GT(kept, 100);
}
