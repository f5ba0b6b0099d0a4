// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "FilterTesting.h"
#include "SeenProblems.h"
#include "SurfaceTesting.h"

#include "vtkBitingSurfaceMesher.h"

#include "vtkAppendPolyData.h"
#include "vtkCellArray.h"
#include "vtkDiskSource.h"
#include "vtkFeatureEdges.h"
#include "vtkImageData.h"
#include "vtkMarchingCubes.h"
#include "vtkMassProperties.h"
#include "vtkPlaneSource.h"
#include "vtkStructuredGrid.h"
#include "vtkTriangleFilter.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <cmath>   // for spheres
#include <numeric> // for means
#include <vector>  // for values

using namespace testing_filters;

namespace
{

vtkSmartPointer<vtkBitingSurfaceMesher> Meshed(vtkPolyData* surface, double spacing)
{
  auto filter = vtkSmartPointer<vtkBitingSurfaceMesher>::New();
  filter->SetInputData(surface);
  filter->SetUniformSpacing(spacing);
  filter->Update();
  return filter;
}

int NumberOfOpenEdges(vtkPolyData* mesh)
{
  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputData(mesh);
  edges->FeatureEdgesOff();
  edges->BoundaryEdgesOn();
  edges->NonManifoldEdgesOn();
  edges->Update();
  return static_cast<int>(edges->GetOutput()->GetNumberOfLines());
}

double VolumeOf(vtkPolyData* mesh)
{
  vtkNew<vtkMassProperties> mass;
  mass->SetInputData(mesh);
  return mass->GetVolume();
}

double MeanOf(vtkDataArray* values)
{
  double sum = 0.0;
  for (vtkIdType k = 0; k < values->GetNumberOfTuples(); ++k)
  {
    sum += values->GetTuple1(k);
  }
  return sum / static_cast<double>(values->GetNumberOfTuples());
}

/// The length of each edge over f at its ends, twice where the mesh is closed.
double MeanLengthOverSpacing(vtkPolyData* mesh)
{
  vtkDataArray* spacing = mesh->GetPointData()->GetArray("Spacing");
  vtkNew<vtkIdList> corners;
  double sum = 0.0;
  double count = 0.0;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    mesh->GetCellPoints(cell, corners);
    for (vtkIdType k = 0; k < 3; ++k)
    {
      const vtkIdType a = corners->GetId(k);
      const vtkIdType b = corners->GetId((k + 1) % 3);
      const Place from = PointOf(mesh, a);
      const Place to = PointOf(mesh, b);
      sum += 2.0 * std::hypot(to[0] - from[0], to[1] - from[1], to[2] - from[2]) /
        (spacing->GetTuple1(a) + spacing->GetTuple1(b));
      count += 1.0;
    }
  }
  return sum / count;
}

std::string ReasonOf(vtkBitingSurfaceMesher* filter)
{
  Messages messages(filter);
  filter->Update();
  EXPECT_EQ(messages.Errors.size(), 1u);
  EXPECT_TRUE(IsEmpty(filter->GetOutput()) && IsEmpty(filter->GetOutput(1)));
  EXPECT_TRUE(Has(filter->GetSummary(), "Error: "));
  return messages.Errors.empty() ? "" : messages.Errors.front();
}

} // namespace

TEST(BitingSurfaceMesher, CoversASphereWithGoodTrianglesOfTheWantedSize)
{
  const auto filter = Meshed(Sphere(), 0.05);
  vtkPolyData* mesh = filter->GetOutput();
  EXPECT_EQ(Figure(mesh, "EulerNumber"), 2.0);
  EXPECT_EQ(NumberOfOpenEdges(mesh), 0);
  EXPECT_GT(Figure(mesh, "SmallestAngle"), 25.0);
  EXPECT_NEAR(MeanLengthOverSpacing(mesh), 1.0, 0.06);
  EXPECT_NEAR(VolumeOf(mesh), 4.0 / 3.0 * std::acos(-1.0) * 0.125, 0.01);
  EXPECT_LT(Figure(mesh, "LargestDeviation"), 0.15);
  EXPECT_EQ(filter->GetOutput(1)->GetNumberOfLines(), 0);
  EXPECT_EQ(filter->GetOutput(3)->GetNumberOfPoints(), 0);
  for (const char* name : { "Spacing", "NearestNeighborDistance", "Conformity", "BiteOrder",
         "VertexKind", "OriginalPointId" })
  {
    EXPECT_TRUE(mesh->GetPointData()->GetArray(name)) << name;
  }
  for (const char* name :
    { "OriginalCellId", "RegionId", "Deviation", "MinimumAngle", "RadiusEdgeRatio", "AspectRatio" })
  {
    EXPECT_TRUE(mesh->GetCellData()->GetArray(name)) << name;
  }
}

TEST(BitingSurfaceMesher, KeepsCornersAndEdgesOfACube)
{
  auto cube = Cube();
  AddArray<vtkIntArray>(cube->GetCellData(), "Tag", { 5.0, 6.0, 7.0, 8.0, 9.0, 10.0 });
  const auto filter = Meshed(cube, 0.1);
  vtkPolyData* mesh = filter->GetOutput();
  EXPECT_EQ(Figure(mesh, "EulerNumber"), 2.0);
  EXPECT_NEAR(VolumeOf(mesh), 1.0, 1e-9);
  vtkDataArray* kinds = mesh->GetPointData()->GetArray("VertexKind");
  vtkDataArray* original = mesh->GetPointData()->GetArray("OriginalPointId");
  ASSERT_TRUE(kinds && original && mesh->GetCellData()->GetArray("Tag"));
  int corners = 0;
  for (vtkIdType point = 0; point < mesh->GetNumberOfPoints(); ++point)
  {
    if (kinds->GetTuple1(point) == vtkBitingSurfaceMesher::CORNER)
    {
      ++corners;
      const auto of = static_cast<vtkIdType>(original->GetTuple1(point));
      EXPECT_EQ(PointOf(mesh, point), PointOf(cube, of));
    }
  }
  EXPECT_EQ(corners, 8);
  EXPECT_GE(filter->GetOutput(1)->GetNumberOfLines(), 12 * 9);
  EXPECT_TRUE(filter->GetOutput(1)->GetCellData()->GetArray("EdgeKind"));
}

TEST(BitingSurfaceMesher, FollowsASourceOfSpace)
{
  const auto image = GradedImage("Size", 0.02, 0.1);
  vtkNew<vtkBitingSurfaceMesher> filter;
  filter->SetInputData(Sphere());
  filter->SetSpacingSourceData(image);
  filter->Update();
  vtkPolyData* mesh = filter->GetOutput();
  ASSERT_GT(mesh->GetNumberOfPoints(), 0);
  EXPECT_NEAR(MeanLengthOverSpacing(mesh), 1.0, 0.08);
  EXPECT_GT(MeanOf(mesh->GetPointData()->GetArray("Conformity")), 0.8);
  const vtkIdType ofImage = mesh->GetNumberOfPoints();

  // The same field on cells of any kind.
  vtkNew<vtkUnstructuredGrid> grid;
  vtkNew<vtkPoints> points;
  for (vtkIdType point = 0; point < image->GetNumberOfPoints(); ++point)
  {
    points->InsertNextPoint(image->GetPoint(point));
  }
  grid->SetPoints(points);
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < image->GetNumberOfCells(); ++cell)
  {
    image->GetCellPoints(cell, corners);
    grid->InsertNextCell(VTK_VOXEL, corners);
  }
  grid->GetPointData()->ShallowCopy(image->GetPointData());
  filter->SetSpacingSourceData(grid);
  filter->Update();
  EXPECT_NEAR(static_cast<double>(filter->GetOutput()->GetNumberOfPoints()),
    static_cast<double>(ofImage), 0.01 * static_cast<double>(ofImage));
}

TEST(BitingSurfaceMesher, FollowsATurnedImageWithHolesTooAndHeedsNoHiddenPoint)
{
  // A field of x, in an image whose first axis runs along y; a corner is unknown, a side hidden.
  vtkNew<vtkImageData> image;
  image->SetDimensions(3, 21, 3);
  image->SetOrigin(-0.5, 0.5, -0.5);
  image->SetSpacing(0.5, 0.05, 0.5);
  image->SetDirectionMatrix(0, 1, 0, -1, 0, 0, 0, 0, 1);
  std::vector<double> values;
  for (vtkIdType point = 0; point < image->GetNumberOfPoints(); ++point)
  {
    values.push_back(0.02 + 0.1 * (image->GetPoint(point)[0] + 0.5));
  }
  AddArray<vtkDoubleArray>(image->GetPointData(), "Size", values);
  vtkNew<vtkBitingSurfaceMesher> filter;
  filter->SetInputData(Sphere());
  filter->SetSpacingSourceData(GradedImage("Size", 0.02, 0.1));
  filter->Update();
  const auto expected = static_cast<double>(filter->GetOutput()->GetNumberOfPoints());
  filter->SetSpacingSourceData(image);
  filter->Update();
  EXPECT_NEAR(static_cast<double>(filter->GetOutput()->GetNumberOfPoints()), expected, 9.0);

  vtkDataArray* sizes = image->GetPointData()->GetArray("Size");
  vtkIdType corner = image->FindPoint(0.5, 0.5, 0.5);
  sizes->SetTuple1(corner, std::nan(""));
  sizes->Modified();
  image->Modified();
  filter->Update();
  EXPECT_NEAR(static_cast<double>(filter->GetOutput()->GetNumberOfPoints()), expected, 9.0);

  // Ghosts of another piece have values.
  image->AllocateCellGhostArray();
  image->GetCellGhostArray()->Fill(vtkDataSetAttributes::DUPLICATECELL);
  image->Modified();
  filter->Update();
  EXPECT_NEAR(static_cast<double>(filter->GetOutput()->GetNumberOfPoints()), expected, 9.0);

  sizes->SetTuple1(corner, 1e-4);
  image->AllocatePointGhostArray();
  image->GetPointGhostArray()->SetValue(corner, vtkDataSetAttributes::HIDDENPOINT);
  image->Modified();
  filter->Update();
  EXPECT_NEAR(static_cast<double>(filter->GetOutput()->GetNumberOfPoints()), expected, 9.0);
}

// A step of zero made indices of NaN; VTK finds no place in a cell that is so far away.
TEST(BitingSurfaceMesher, TakesSlicesWithoutThicknessAndGridsFarAway)
{
  vtkNew<vtkImageData> slice;
  slice->SetDimensions(9, 9, 1);
  slice->SetOrigin(-0.5, -0.5, 0.0);
  slice->SetSpacing(0.125, 0.125, 0.0);
  AddArray<vtkDoubleArray>(slice->GetPointData(), "Size", std::vector<double>(81, 0.1));
  vtkNew<vtkPlaneSource> plane;
  vtkNew<vtkBitingSurfaceMesher> filter;
  filter->SetInputConnection(plane->GetOutputPort());
  filter->SetSpacingSourceData(slice);
  filter->Update();
  EXPECT_NEAR(MeanLengthOverSpacing(filter->GetOutput()), 1.0, 0.1);
  EXPECT_NEAR(MeanOf(filter->GetOutput()->GetPointData()->GetArray("Spacing")), 0.1, 1e-9);

  vtkNew<vtkStructuredGrid> grid;
  vtkNew<vtkPoints> points;
  grid->SetDimensions(9, 9, 9);
  for (int k = 0; k < 729; ++k)
  {
    points->InsertNextPoint(100.0 + k % 9 / 8.0, 100.0 + k / 9 % 9 / 8.0, 100.0 + k / 81 / 8.0);
  }
  grid->SetPoints(points);
  AddArray<vtkDoubleArray>(grid->GetPointData(), "Size", std::vector<double>(729, 0.1));
  filter->SetInputData(Sphere());
  filter->SetSpacingSourceData(grid);
  filter->Update();
  EXPECT_NEAR(MeanLengthOverSpacing(filter->GetOutput()), 1.0, 0.1);
}

TEST(BitingSurfaceMesher, GradesAFieldThatJumps)
{
  vtkNew<vtkPolyData> one;
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0.5, 0.0, 0.0);
  points->InsertNextPoint(-0.5, 0.0, 0.0);
  one->SetPoints(points);
  vtkNew<vtkCellArray> vertices;
  for (vtkIdType point = 0; point < 2; ++point)
  {
    vertices->InsertNextCell(1, &point);
  }
  one->SetVerts(vertices);
  AddArray<vtkDoubleArray>(one->GetPointData(), "Spacing", { 0.02, 0.02 });
  vtkNew<vtkBitingSurfaceMesher> filter;
  filter->SetInputData(Sphere());
  filter->SetUniformSpacing(0.1);
  filter->SetSpacingSourceData(one);
  filter->Update();
  EXPECT_NEAR(MeanLengthOverSpacing(filter->GetOutput()), 1.0, 0.08);
}

TEST(BitingSurfaceMesher, KeepsBordersAndLinesBetweenRegions)
{
  vtkNew<vtkDiskSource> disk;
  disk->SetInnerRadius(0.4);
  disk->SetOuterRadius(1.0);
  disk->SetCircumferentialResolution(48);
  disk->SetRadialResolution(2);
  disk->Update();
  vtkSmartPointer<vtkPolyData> surface = disk->GetOutput();
  std::vector<double> materials;
  for (vtkIdType cell = 0; cell < surface->GetNumberOfCells(); ++cell)
  {
    materials.push_back(cell % 2 == 0 ? 3.0 : 7.0);
  }
  AddArray<vtkIntArray>(surface->GetCellData(), "Material", materials);
  auto filter = Meshed(surface, 0.1);
  vtkPolyData* mesh = filter->GetOutput();
  EXPECT_EQ(Figure(mesh, "EulerNumber"), 0.0);
  const vtkIdType borders = filter->GetOutput(1)->GetNumberOfLines();
  EXPECT_EQ(borders, NumberOfOpenEdges(mesh));
  EXPECT_GT(Figure(mesh, "SmallestAngle"), 20.0);
  filter->SetRegionArray("Material");
  filter->Update();
  EXPECT_GT(filter->GetOutput(1)->GetNumberOfLines(), borders + 30);
  double range[2];
  mesh->GetCellData()->GetArray("RegionId")->GetRange(range);
  EXPECT_EQ(range[1] - range[0], 1.0);
}

TEST(BitingSurfaceMesher, MakesOneWallOfTheContoursOfTwoLabels)
{
  constexpr int Voxels = 12;
  vtkNew<vtkAppendPolyData> contours;
  for (const bool isFirst : { true, false }) // halves of a ball
  {
    vtkNew<vtkImageData> image;
    image->SetDimensions(Voxels, Voxels, Voxels);
    image->AllocateScalars(VTK_DOUBLE, 1);
    for (vtkIdType voxel = 0; voxel < image->GetNumberOfPoints(); ++voxel)
    {
      double place[3];
      image->GetPoint(voxel, place);
      const auto square = [&place](int axis) { return (place[axis] - 5.5) * (place[axis] - 5.5); };
      const bool isOfFirst = place[0] + 0.31 * place[1] > 7.2;
      const bool isIn = square(0) + square(1) + square(2) < 25.4 && isOfFirst == isFirst;
      image->GetPointData()->GetScalars()->SetTuple1(voxel, isIn ? 1.0 : 0.0);
    }
    vtkNew<vtkMarchingCubes> contour;
    contour->SetInputData(image);
    contour->SetValue(0, 0.5);
    contour->ComputeNormalsOff();
    contour->Update();
    vtkPolyData* surface = contour->GetOutput();
    const auto count = static_cast<std::size_t>(surface->GetNumberOfCells());
    AddArray<vtkIntArray>(
      surface->GetCellData(), "Label", std::vector<double>(count, isFirst ? 4.0 : 5.0));
    contours->AddInputData(surface);
  }
  vtkNew<vtkBitingSurfaceMesher> filter;
  filter->SetInputConnection(contours->GetOutputPort());
  filter->SetRegionArray("Label");
  filter->SetUniformSpacing(2.0);
  filter->Update();
  vtkPolyData* mesh = filter->GetOutput();
  ASSERT_GT(mesh->GetNumberOfCells(), 0);
  EXPECT_EQ(Figure(mesh, "EulerNumber"), 3.0); // of a sphere and of a disk
  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputData(mesh);
  edges->FeatureEdgesOff();
  edges->NonManifoldEdgesOff();
  edges->Update();
  EXPECT_EQ(edges->GetOutput()->GetNumberOfLines(), 0);
  edges->BoundaryEdgesOff();
  edges->NonManifoldEdgesOn();
  edges->Update();
  EXPECT_GT(edges->GetOutput()->GetNumberOfLines(), 10);
}

TEST(BitingSurfaceMesher, ClosesSlitsAtVerticesOnEdgesOfOtherTriangles)
{
  vtkSmartPointer<vtkPolyData> cube = Cube(); // each face has its own points
  vtkNew<vtkCellArray> polys;
  const auto add = [&polys](const std::vector<vtkIdType>& face)
  {
    for (std::size_t k = 2; k < face.size(); ++k)
    {
      const vtkIdType ids[3] = { face[0], face[k - 1], face[k] };
      polys->InsertNextCell(3, ids);
    }
  };
  for (vtkIdType face = 0; face < 6; ++face)
  {
    vtkIdList* own = cube->GetCell(face)->GetPointIds();
    std::vector<vtkIdType> corners{ own->GetId(0), own->GetId(1), own->GetId(2), own->GetId(3) };
    if (face == 0)
    {
      double a[3];
      double b[3];
      cube->GetPoint(corners[2], a);
      cube->GetPoint(corners[3], b);
      corners.insert(corners.begin() + 3,
        cube->GetPoints()->InsertNextPoint(
          0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1]), 0.5 * (a[2] + b[2])));
    }
    add(corners);
  }
  vtkNew<vtkPolyData> surface;
  surface->SetPoints(cube->GetPoints());
  surface->SetPolys(polys);
  const auto filter = Meshed(surface, 0.2);
  ASSERT_GT(filter->GetOutput()->GetNumberOfCells(), 0);
  EXPECT_EQ(NumberOfOpenEdges(filter->GetOutput()), 0);
  EXPECT_NEAR(VolumeOf(filter->GetOutput()), 1.0, 1e-9);
}

TEST(BitingSurfaceMesher, KeepsSheetsAboveEachOtherApart)
{
  vtkNew<vtkAppendPolyData> both;
  for (const double z : { 0.0, 0.04 }) // of the same orientation
  {
    vtkNew<vtkPlaneSource> plane;
    plane->SetOrigin(0.0, 0.0, z);
    plane->SetPoint1(1.0, 0.0, z + 0.02);
    plane->SetPoint2(0.0, 1.0, z);
    plane->SetResolution(9, 7);
    plane->Update();
    both->AddInputData(plane->GetOutput());
  }
  both->Update();
  const auto filter = Meshed(both->GetOutput(), 0.1);
  vtkPolyData* mesh = filter->GetOutput();
  EXPECT_EQ(Figure(mesh, "EulerNumber"), 2.0);
  EXPECT_LT(Figure(mesh, "LargestDeviation"), 1e-6);
  EXPECT_GT(Figure(mesh, "SmallestAngle"), 25.0);
}

TEST(BitingSurfaceMesher, RefusesWithAPlaceWhatItCannotMesh)
{
  vtkNew<vtkAppendPolyData> both;
  both->AddInputData(Cube(2.0));
  both->AddInputData(Sphere(1.2));
  both->Update();
  vtkNew<vtkBitingSurfaceMesher> filter;
  filter->SetInputConnection(both->GetOutputPort());
  filter->SetUniformSpacing(0.2);
  filter->Update();
  EXPECT_EQ(Figure(filter->GetOutput(), "EulerNumber"), 2.0); // of the union
  vtkPolyData* open = both->GetOutput();
  open->BuildCells();
  open->DeleteCell(0);
  open->RemoveDeletedCells();
  filter->SetInputData(open);
  EXPECT_TRUE(Has(ReasonOf(filter), "Self-crossings"));
  EXPECT_GT(filter->GetOutput(3)->GetNumberOfPoints(), 0);
  filter->SetInputData(Cube());
  filter->SetSpacingScale(0.0);
  EXPECT_TRUE(Has(ReasonOf(filter), "Spacing Scale"));
  filter->SetSpacingScale(1.0);
  filter->SetRegionArray("Nothing");
  EXPECT_TRUE(Has(ReasonOf(filter), "Nothing"));
  filter->SetRegionArray("");
  filter->SetUniformSpacing(1e-6);
  EXPECT_TRUE(Has(ReasonOf(filter), "Maximum Number Of Vertices"));
  filter->SetInputData(UnitSquare());
  EXPECT_TRUE(Has(ReasonOf(filter), "no surface"));
  filter->SetInputData(Sphere(0.0));
  EXPECT_TRUE(Has(ReasonOf(filter), "no larger than the rounding"));
}

TEST(BitingSurfaceMesher, IsTheSameWithAnyNumberOfThreadsAndInAnyRun)
{
  auto filter = Meshed(Sphere(), 0.06);
  vtkNew<vtkPolyData> first;
  first->DeepCopy(filter->GetOutput());
  filter->SetNumberOfThreads(1);
  filter->Update();
  EXPECT_TRUE(AreSame(first, filter->GetOutput()));
  filter->SetNumberOfThreads(3);
  filter->SetGenerateBites(true);
  filter->Update();
  EXPECT_TRUE(AreSame(first, filter->GetOutput()));
  EXPECT_GT(filter->GetOutput(2)->GetNumberOfPoints(), 100);
  EXPECT_TRUE(filter->GetOutput(2)->GetPointData()->GetArray("Radius"));
}

TEST(BitingSurfaceMesher, HasNothingToSayOfNothing)
{
  vtkNew<vtkBitingSurfaceMesher> filter;
  Messages messages(filter);
  filter->SetInputData(vtkNew<vtkPolyData>());
  filter->Update();
  EXPECT_TRUE(messages.Errors.empty() && messages.Warnings.empty());
  EXPECT_TRUE(IsEmpty(filter->GetOutput()));
}
