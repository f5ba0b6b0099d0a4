// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "FilterTesting.h"
#include "SeenProblems.h"

#include "vtkBitingSurfaceCheck.h"

#include "vtkAppendPolyData.h"
#include "vtkCellType.h"
#include "vtkCubeSource.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPoints.h"
#include "vtkSphereSource.h"
#include "vtkStripper.h"
#include "vtkTriangleFilter.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <algorithm> // for find_if
#include <cmath>     // for places
#include <limits>    // for NaN

using namespace testing_filters;

namespace
{

vtkSmartPointer<vtkPolyData> Cube(double center, double size)
{
  vtkNew<vtkCubeSource> source;
  source->SetCenter(center, center, center);
  source->SetXLength(size);
  source->SetYLength(size);
  source->SetZLength(size);
  source->Update();
  return source->GetOutput();
}

double FigureOf(vtkBitingSurfaceCheck* filter, const char* name)
{
  return Figure(filter->GetOutput(), name);
}

std::string ReasonOf(vtkDataObject* input)
{
  vtkNew<vtkBitingSurfaceCheck> filter;
  Messages messages(filter);
  filter->SetInputDataObject(input);
  filter->Update();
  EXPECT_EQ(messages.Errors.size(), 1u);
  EXPECT_TRUE(IsEmpty(filter->GetOutput()) && IsEmpty(filter->GetProblems()));
  EXPECT_TRUE(Has(filter->GetSummary(), "Error: "));
  return messages.Errors.empty() ? "" : messages.Errors.front();
}

} // namespace

TEST(BitingSurfaceCheck, HasNothingToSayOfACubeOfQuads)
{
  vtkNew<vtkBitingSurfaceCheck> filter;
  Messages messages(filter);
  auto cube = Cube(0.0, 2.0);
  AddArray<vtkIntArray>(cube->GetCellData(), "Tag", { 5.0, 6.0, 7.0, 8.0, 9.0, 10.0 });
  filter->SetInputData(cube);
  filter->Update();
  vtkPolyData* surface = filter->GetOutput();
  EXPECT_EQ(surface->GetNumberOfPoints(), 8);
  EXPECT_EQ(surface->GetNumberOfPolys(), 12);
  EXPECT_EQ(surface->GetPoints()->GetDataType(), VTK_FLOAT);
  EXPECT_DOUBLE_EQ(FigureOf(filter, "Volume"), 8.0);
  EXPECT_EQ(FigureOf(filter, "EulerNumber"), 2.0);
  vtkDataArray* tags = surface->GetCellData()->GetArray("Tag");
  vtkDataArray* cells = surface->GetCellData()->GetArray("OriginalCellId");
  ASSERT_TRUE(tags && cells && surface->GetCellData()->GetArray("RegionId"));
  for (vtkIdType cell = 0; cell < 12; ++cell)
  {
    EXPECT_EQ(tags->GetTuple1(cell), cells->GetTuple1(cell) + 5.0);
  }
  EXPECT_TRUE(surface->GetPointData()->GetArray("OriginalPointId"));
  EXPECT_EQ(filter->GetFeatureEdges()->GetNumberOfLines(), 12);
  EXPECT_EQ(filter->GetProblems()->GetNumberOfPoints(), 0);
  EXPECT_TRUE(Has(filter->GetSummary(), "closed and does not cross itself"));
  EXPECT_TRUE(messages.Errors.empty() && messages.Warnings.empty());
}

TEST(BitingSurfaceCheck, TakesBlocksAsOneSurfaceAndFindsTheCavity)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, Cube(0.0, 2.0));
  blocks->SetBlock(1, Cube(0.0, 1.0));
  vtkNew<vtkBitingSurfaceCheck> filter;
  filter->SetInputDataObject(blocks);
  filter->Update();
  EXPECT_DOUBLE_EQ(FigureOf(filter, "Volume"), 7.0);
  EXPECT_EQ(FigureOf(filter, "Cavities"), 1.0);
  EXPECT_EQ(FigureOf(filter, "Parts"), 2.0);
  EXPECT_TRUE(filter->GetOutput()->GetCellData()->HasArray("BlockName"));
}

TEST(BitingSurfaceCheck, TakesStripsAndGridsAsPolygons)
{
  vtkNew<vtkSphereSource> sphere;
  vtkNew<vtkStripper> strips;
  strips->SetInputConnection(sphere->GetOutputPort());
  vtkNew<vtkBitingSurfaceCheck> filter;
  filter->SetInputConnection(strips->GetOutputPort());
  filter->Update();
  const double volume = FigureOf(filter, "Volume");
  EXPECT_EQ(FigureOf(filter, "OpenEdges"), 0.0);
  EXPECT_GT(volume, 0.3);
  vtkNew<vtkUnstructuredGrid> grid;
  grid->SetPoints(sphere->GetOutput()->GetPoints());
  grid->SetCells(VTK_TRIANGLE, sphere->GetOutput()->GetPolys());
  filter->SetInputDataObject(grid);
  filter->Update();
  EXPECT_NEAR(FigureOf(filter, "Volume"), volume, 1e-12);
}

// No two of them have a triangle along the side between them, and so twice.
TEST(BitingSurfaceCheck, DividesQuadraticCellsAtThePointsOfTheirSides)
{
  // An octahedron whose sides are drawn out to a sphere.
  const int corners[8][3] = { { 0, 1, 2 }, { 1, 3, 2 }, { 3, 4, 2 }, { 4, 0, 2 }, { 1, 0, 5 },
    { 3, 1, 5 }, { 4, 3, 5 }, { 0, 4, 5 } };
  const double places[6][3] = { { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }, { 0.0, 0.0, 1.0 },
    { -1.0, 0.0, 0.0 }, { 0.0, -1.0, 0.0 }, { 0.0, 0.0, -1.0 } };
  vtkNew<vtkUnstructuredGrid> grid;
  vtkNew<vtkPoints> points;
  grid->SetPoints(points);
  for (const auto& triangle : corners)
  {
    vtkIdType ids[6];
    for (int k = 0; k < 3; ++k)
    {
      const double* a = places[triangle[k]];
      const double* b = places[triangle[(k + 1) % 3]];
      ids[k] = points->InsertNextPoint(a);
      const double half = std::sqrt(0.5);
      ids[k + 3] =
        points->InsertNextPoint(half * (a[0] + b[0]), half * (a[1] + b[1]), half * (a[2] + b[2]));
    }
    grid->InsertNextCell(VTK_QUADRATIC_TRIANGLE, 6, ids);
  }
  vtkNew<vtkBitingSurfaceCheck> filter;
  filter->SetInputData(grid);
  filter->Update();
  EXPECT_EQ(FigureOf(filter, "OpenEdges"), 0.0);
  EXPECT_EQ(FigureOf(filter, "EulerNumber"), 2.0);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 32);
}

TEST(BitingSurfaceCheck, KeepsTheAreaOfQuadraticPolygonsWithReflexCorners)
{
  const double corners[6][2] = { { 0.0, 0.0 }, { 2.0, 0.0 }, { 2.0, 1.0 }, { 1.0, 1.0 },
    { 1.0, 2.0 }, { 0.0, 2.0 } };
  vtkNew<vtkUnstructuredGrid> grid;
  vtkNew<vtkPoints> points;
  grid->SetPoints(points);
  vtkIdType ids[12];
  for (int k = 0; k < 6; ++k)
  {
    const double* a = corners[k];
    const double* b = corners[(k + 1) % 6];
    ids[k] = points->InsertNextPoint(a[0], a[1], 0.0);
    ids[k + 6] = points->InsertNextPoint(0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1]), 0.0);
  }
  grid->InsertNextCell(VTK_QUADRATIC_POLYGON, 12, ids);
  vtkNew<vtkBitingSurfaceCheck> filter;
  filter->SetInputData(grid);
  filter->Update();
  EXPECT_DOUBLE_EQ(FigureOf(filter, "Area"), 3.0);
}

TEST(BitingSurfaceCheck, TellsProblemsWithPlacesIdsAndWords)
{
  vtkNew<vtkAppendPolyData> both;
  both->AddInputData(Cube(0.0, 2.0));
  both->AddInputData(Cube(1.0, 1.5));
  both->Update();
  vtkNew<vtkBitingSurfaceCheck> filter;
  Messages messages(filter);
  filter->SetInputData(both->GetOutput());
  filter->Update();
  const auto problems = ReadProblems(filter->GetProblems());
  const auto crossing = std::find_if(problems.begin(), problems.end(),
    [](const SeenProblem& seen) { return seen.Kind == vtkBitingSurfaceCheck::SELF_CROSSINGS; });
  ASSERT_NE(crossing, problems.end());
  EXPECT_EQ(crossing->IsError, 1);
  EXPECT_TRUE(Has(crossing->Message, "Self-crossings: cell "));
  EXPECT_TRUE(crossing->FirstId < 12 && crossing->SecondId < 12);
  EXPECT_TRUE(Has(filter->GetSummary(), "Self-crossings ("));
  EXPECT_TRUE(messages.Errors.empty() && messages.Warnings.empty());
}

TEST(BitingSurfaceCheck, RefusesWhatIsNoSurfaceWithAReason)
{
  vtkNew<vtkUnstructuredGrid> grid;
  vtkNew<vtkPoints> points;
  for (int k = 0; k < 4; ++k)
  {
    points->InsertNextPoint(k == 1 ? 1.0 : 0.0, k == 2 ? 1.0 : 0.0, k == 3 ? 1.0 : 0.0);
  }
  grid->SetPoints(points);
  const vtkIdType corners[] = { 0, 1, 2, 3 };
  grid->InsertNextCell(VTK_TETRA, 4, corners);
  EXPECT_TRUE(Has(ReasonOf(grid), "Extract Surface"));
  auto cube = Cube(0.0, 1.0);
  cube->GetPoints()->SetPoint(3, std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0);
  EXPECT_TRUE(Has(ReasonOf(cube), "point 3 at "));
  EXPECT_TRUE(Has(ReasonOf(UnitSquare()), "no surface"));
  EXPECT_TRUE(Has(ReasonOf(Cube(0.0, 1e-60)), "no larger than the rounding"));
}

TEST(BitingSurfaceCheck, HasNothingToSayOfNothing)
{
  vtkNew<vtkBitingSurfaceCheck> filter;
  Messages messages(filter);
  filter->SetInputData(vtkNew<vtkPolyData>());
  filter->Update();
  EXPECT_TRUE(messages.Errors.empty() && messages.Warnings.empty());
  EXPECT_TRUE(IsEmpty(filter->GetOutput()));
  EXPECT_EQ(filter->GetFeatureAngle(), 40.0);
}
