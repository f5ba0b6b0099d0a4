// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "FilterTesting.h"
#include "SeenProblems.h"
#include "SurfaceTesting.h"

#include "vtkBitingTetrahedralizer.h"

#include "vtkAppendPolyData.h"
#include "vtkCellType.h"
#include "vtkErrorCode.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <algorithm> // for is_permutation, min
#include <cmath>     // for NaN
#include <map>       // for regions

using namespace testing_filters;

namespace
{

vtkSmartPointer<vtkBitingTetrahedralizer> Filled(vtkDataObject* surface, double spacing)
{
  auto filter = vtkSmartPointer<vtkBitingTetrahedralizer>::New();
  filter->SetInputData(surface);
  filter->SetUniformSpacing(spacing);
  filter->Update();
  return filter;
}

double VolumeOf(vtkDataSet* mesh, vtkIdType cell)
{
  vtkNew<vtkIdList> corners;
  mesh->GetCellPoints(cell, corners);
  EXPECT_EQ(corners->GetNumberOfIds(), 4);
  std::array<Place, 4> at;
  for (vtkIdType k = 0; k < 4; ++k)
  {
    at[static_cast<std::size_t>(k)] = PointOf(mesh, corners->GetId(k));
  }
  std::array<Place, 3> side;
  for (std::size_t k = 0; k < 3; ++k)
  {
    for (std::size_t d = 0; d < 3; ++d)
    {
      side[k][d] = at[k + 1][d] - at[0][d];
    }
  }
  double six = 0.0;
  for (std::size_t d = 0; d < 3; ++d)
  {
    const std::size_t e = (d + 1) % 3;
    const std::size_t f = (d + 2) % 3;
    six += side[2][d] * (side[0][e] * side[1][f] - side[0][f] * side[1][e]);
  }
  return six / 6.0;
}

/// Of each region; all cells are tetrahedra of positive volume.
std::map<int, double> VolumesOf(vtkUnstructuredGrid* mesh)
{
  std::map<int, double> volumes;
  vtkDataArray* regions = mesh->GetCellData()->GetArray("RegionId");
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    EXPECT_EQ(mesh->GetCellType(cell), VTK_TETRA);
    const double volume = VolumeOf(mesh, cell);
    EXPECT_GT(volume, 0.0);
    volumes[static_cast<int>(regions->GetTuple1(cell))] += volume;
  }
  return volumes;
}

/// Each triangle of the boundary is a facet of the cell that it names, with the region of that.
void CheckBoundary(vtkBitingTetrahedralizer* filter)
{
  vtkUnstructuredGrid* mesh = filter->GetOutput();
  vtkPolyData* boundary = filter->GetBoundary();
  vtkDataArray* points = boundary->GetPointData()->GetArray("MeshPointId");
  vtkDataArray* cells = boundary->GetCellData()->GetArray("MeshCellId");
  vtkDataArray* regions = boundary->GetCellData()->GetArray("RegionId");
  ASSERT_TRUE(points && cells && regions);
  vtkNew<vtkIdList> triangle;
  vtkNew<vtkIdList> corners;
  for (vtkIdType k = 0; k < boundary->GetNumberOfCells(); ++k)
  {
    const auto cell = static_cast<vtkIdType>(cells->GetTuple1(k));
    boundary->GetCellPoints(k, triangle);
    mesh->GetCellPoints(cell, corners);
    EXPECT_EQ(regions->GetTuple1(k), mesh->GetCellData()->GetArray("RegionId")->GetTuple1(cell));
    for (const vtkIdType corner : *triangle)
    {
      const auto of = static_cast<vtkIdType>(points->GetTuple1(corner));
      EXPECT_GE(corners->IsId(of), 0);
      EXPECT_EQ(PointOf(boundary, corner), PointOf(mesh, of));
    }
  }
}

bool AreSameGrids(vtkUnstructuredGrid* a, vtkUnstructuredGrid* b)
{
  return AreSameBytes(a->GetPoints()->GetData(), b->GetPoints()->GetData()) &&
    AreSameBytes(a->GetCells()->GetConnectivityArray(), b->GetCells()->GetConnectivityArray()) &&
    AreSameArrays(a->GetPointData(), b->GetPointData()) &&
    AreSameArrays(a->GetCellData(), b->GetCellData()) &&
    AreSameArrays(a->GetFieldData(), b->GetFieldData());
}

vtkSmartPointer<vtkUnstructuredGrid> CopyOf(vtkUnstructuredGrid* mesh)
{
  auto copy = vtkSmartPointer<vtkUnstructuredGrid>::New();
  copy->DeepCopy(mesh);
  return copy;
}

vtkSmartPointer<vtkPolyData> Together(const std::vector<vtkSmartPointer<vtkPolyData>>& surfaces)
{
  vtkNew<vtkAppendPolyData> all;
  for (const auto& surface : surfaces)
  {
    all->AddInputData(surface);
  }
  all->Update();
  return all->GetOutput();
}

vtkSmartPointer<vtkPolyData> WithMaterial(vtkSmartPointer<vtkPolyData> surface, double material)
{
  const auto count = static_cast<std::size_t>(surface->GetNumberOfCells());
  AddArray<vtkIntArray>(surface->GetCellData(), "Material", std::vector<double>(count, material));
  return surface;
}

/// A box between two corners of integer coordinates; `turned`: the diagonal of its low face along x
/// is the other one. Points are numbered by places, so that boxes may be joined.
void AddBox(vtkPolyData* all, const std::array<int, 3>& low, bool isTurned)
{
  const auto point = [all, &low](int corner)
  {
    const std::array<double, 3> place{ 1.0 * low[0] + corner % 2, 1.0 * low[1] + corner / 2 % 2,
      1.0 * low[2] + corner / 4 };
    return all->GetPoints()->InsertNextPoint(place.data());
  };
  const int faces[6][4] = { { 0, 4, 6, 2 }, { 1, 3, 7, 5 }, { 0, 1, 5, 4 }, { 2, 6, 7, 3 },
    { 0, 2, 3, 1 }, { 4, 5, 7, 6 } };
  for (int face = 0; face < 6; ++face)
  {
    const int shift = face == 0 && isTurned ? 1 : 0;
    const auto corner = [&faces, &point, face, shift](int k)
    { return point(faces[face][(k + shift) % 4]); };
    for (const int first : { 0, 2 })
    {
      const vtkIdType ids[3] = { corner(first), corner(first + 1), corner(first + 2) };
      all->GetPolys()->InsertNextCell(3, ids);
    }
  }
}

vtkSmartPointer<vtkPolyData> Boxes(const std::vector<std::array<int, 3>>& lows)
{
  auto all = vtkSmartPointer<vtkPolyData>::New();
  all->SetPoints(vtkSmartPointer<vtkPoints>::New());
  all->SetPolys(vtkSmartPointer<vtkCellArray>::New());
  std::vector<double> labels;
  for (const auto& low : lows)
  {
    AddBox(all, low, labels.size() % 24 == 12);
    labels.resize(labels.size() + 12, 5.0 + 2.0 * static_cast<double>(labels.size() / 12));
  }
  AddArray<vtkIntArray>(all->GetCellData(), "Label", labels);
  return all;
}

std::string ReasonOf(vtkBitingTetrahedralizer* filter)
{
  Messages messages(filter);
  filter->Update();
  EXPECT_EQ(messages.Errors.size(), 1u);
  EXPECT_EQ(filter->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::UserError));
  EXPECT_TRUE(IsEmpty(filter->GetOutput()) && IsEmpty(filter->GetBoundary()));
  EXPECT_TRUE(Has(filter->GetSummary(), "Error: "));
  return messages.Errors.empty() ? "" : messages.Errors.front();
}

} // namespace

TEST(BitingTetrahedralizer, HasTheDefaultsOfTheMesherOfSurfaces)
{
  vtkNew<vtkBitingTetrahedralizer> filter;
  EXPECT_EQ(filter->GetBiteShape(), vtkBitingTetrahedralizer::SPHERE);
  EXPECT_EQ(filter->GetBitingConstant(), 0.0);
  EXPECT_EQ(filter->GetMaximumNumberOfBites(), -1);
  EXPECT_EQ(filter->GetFeatureAngle(), 40.0);
  EXPECT_EQ(filter->GetBoundaryTolerance(), 0.1);
  EXPECT_TRUE(filter->GetRelaxation() && filter->GetLimitByFeatureSize());
  EXPECT_EQ(filter->GetNumberOfOutputPorts(), 4);
  filter->SetInputData(Cube());
  filter->Update();
  double range[2]; // 4 % of the diagonal, such that edges have whole numbers of it
  filter->GetOutput()->GetPointData()->GetArray("Spacing")->GetRange(range);
  EXPECT_NEAR(range[1], 0.04 * std::sqrt(3.0), 0.003);
}

TEST(BitingTetrahedralizer, FillsABallWithGoodTetrahedraOfTheWantedSize)
{
  const auto filter = Filled(Sphere(), 0.1);
  vtkUnstructuredGrid* mesh = filter->GetOutput();
  const double volume = VolumesOf(mesh)[0];
  EXPECT_NEAR(volume, 4.0 / 3.0 * std::acos(-1.0) * 0.125, 0.02);
  EXPECT_NEAR(volume, Figure(mesh, "Volume"), 1e-12);
  EXPECT_EQ(Figure(mesh, "EulerNumber"), 2.0);
  EXPECT_LT(Figure(mesh, "LargestDeviation"), 0.15);
  EXPECT_NEAR(Figure(mesh, "MeanRelativeLength"), 1.0, 0.07);
  EXPECT_GT(Figure(mesh, "MeanConformity"), 0.8);
  EXPECT_GT(Figure(mesh, "SmallestDihedralAngle"), 25.0);
  CheckBoundary(filter);
  EXPECT_EQ(filter->GetProblems()->GetNumberOfPoints(), 0);
  EXPECT_EQ(filter->GetBites()->GetNumberOfPoints(), 0);
  for (const char* name : { "Spacing", "NearestNeighborDistance", "Conformity", "BiteOrder",
         "VertexKind", "OriginalPointId" })
  {
    EXPECT_TRUE(mesh->GetPointData()->GetArray(name)) << name;
  }
  for (const char* name : { "RegionId", "MinimumDihedralAngle", "RadiusEdgeRatio", "AspectRatio" })
  {
    EXPECT_TRUE(mesh->GetCellData()->GetArray(name)) << name;
  }
  EXPECT_TRUE(Has(filter->GetSummary(), "Euler number of the boundary: 2"));
}

TEST(BitingTetrahedralizer, KeepsCornersAndTagsOfACube)
{
  auto cube = Cube();
  AddArray<vtkIntArray>(cube->GetCellData(), "Tag", { 5.0, 6.0, 7.0, 8.0, 9.0, 10.0 });
  const auto filter = Filled(cube, 0.15);
  vtkUnstructuredGrid* mesh = filter->GetOutput();
  EXPECT_NEAR(VolumesOf(mesh)[0], 1.0, 1e-9);
  CheckBoundary(filter);
  vtkDataArray* kinds = mesh->GetPointData()->GetArray("VertexKind");
  vtkDataArray* original = mesh->GetPointData()->GetArray("OriginalPointId");
  std::map<int, int> counts;
  for (vtkIdType point = 0; point < mesh->GetNumberOfPoints(); ++point)
  {
    const auto kind = static_cast<int>(kinds->GetTuple1(point));
    ++counts[kind];
    if (kind == vtkBitingTetrahedralizer::CORNER)
    {
      const auto of = static_cast<vtkIdType>(original->GetTuple1(point));
      EXPECT_EQ(PointOf(mesh, point), PointOf(cube, of));
    }
  }
  EXPECT_EQ(counts[vtkBitingTetrahedralizer::CORNER], 8);
  EXPECT_GE(counts[vtkBitingTetrahedralizer::FEATURE], 12 * 5);
  EXPECT_GE(counts[vtkBitingTetrahedralizer::SURFACE], 6 * 25);
  EXPECT_GE(counts[vtkBitingTetrahedralizer::INSIDE], 100);
  std::map<int, double> areas; // of tags
  vtkPolyData* boundary = filter->GetBoundary();
  vtkDataArray* tags = boundary->GetCellData()->GetArray("Tag");
  ASSERT_TRUE(tags);
  for (vtkIdType cell = 0; cell < boundary->GetNumberOfCells(); ++cell)
  {
    vtkNew<vtkPolyData> one;
    one->SetPoints(boundary->GetPoints());
    one->AllocateExact(1, 3);
    vtkNew<vtkIdList> corners;
    boundary->GetCellPoints(cell, corners);
    one->InsertNextCell(VTK_TRIANGLE, corners);
    areas[static_cast<int>(tags->GetTuple1(cell))] += AreaOf(one);
  }
  EXPECT_EQ(areas.size(), 6u);
  for (const auto& [tag, area] : areas)
  {
    EXPECT_NEAR(area, 1.0, 1e-9) << tag;
  }
}

TEST(BitingTetrahedralizer, LeavesCavitiesEmptyAndFillsTwoMaterialsWithAWallBetween)
{
  const double ball = VolumesOf(Filled(Sphere(0.25, 30), 0.12)->GetOutput())[0];
  const auto cavity = Filled(Together({ Cube(), Sphere(0.25, 30) }), 0.12);
  EXPECT_EQ(Figure(cavity->GetOutput(), "EulerNumber"), 4.0);
  EXPECT_NEAR(VolumesOf(cavity->GetOutput())[0], 1.0 - ball, 0.005);
  CheckBoundary(cavity);

  auto both = vtkSmartPointer<vtkBitingTetrahedralizer>::New();
  both->SetInputData(Together({ WithMaterial(Cube(), 3.0), WithMaterial(Sphere(0.25, 30), 7.0) }));
  both->SetUniformSpacing(0.12);
  both->SetRegionArray("Material");
  both->Update();
  std::map<int, double> volumes = VolumesOf(both->GetOutput());
  ASSERT_EQ(volumes.size(), 2u);
  EXPECT_NEAR(volumes[0] + volumes[1], 1.0, 1e-9);
  EXPECT_NEAR(volumes[1], ball, 0.005);
  CheckBoundary(both);
  EXPECT_TRUE(both->GetBoundary()->GetCellData()->GetArray("Material"));
}

TEST(BitingTetrahedralizer, MakesOneWallOfTwoWithOtherTrianglesAndTellsTheLabelsOfTetrahedra)
{
  vtkNew<vtkBitingTetrahedralizer> filter;
  Messages messages(filter);
  filter->SetInputData(Boxes({ { 0, 0, 0 }, { 1, 0, 0 } }));
  filter->SetRegionArray("Label");
  filter->SetUniformSpacing(0.3);
  filter->Update();
  std::map<int, double> volumes = VolumesOf(filter->GetOutput());
  ASSERT_EQ(volumes.size(), 2u);
  EXPECT_NEAR(volumes[0], 1.0, 1e-9);
  EXPECT_NEAR(volumes[1], 1.0, 1e-9);
  CheckBoundary(filter);
  double range[2];
  filter->GetOutput()->GetCellData()->GetArray("Label")->GetRange(range);
  EXPECT_EQ(range[0], 5.0);
  EXPECT_EQ(range[1], 7.0);
  EXPECT_NEAR(AreaOf(filter->GetBoundary()), 11.0, 1e-9); // the wall once
  ASSERT_EQ(messages.Warnings.size(), 1u);
  EXPECT_TRUE(Has(messages.Warnings[0], "were made alike"));
  EXPECT_TRUE(Has(filter->GetSummary(), "Duplicate triangles (3)"));
}

TEST(BitingTetrahedralizer, TakesTheLabelsOfBothSides)
{
  auto boxes = Boxes({ { 0, 0, 0 }, { 1, 0, 0 } });
  std::vector<double> sides;
  boxes->BuildCells();
  for (vtkIdType cell = 0; cell < 24; ++cell)
  {
    const bool isWall = cell == 2 || cell == 3;
    sides.insert(sides.end(), { cell < 12 ? 4.0 : 9.0, isWall ? 9.0 : 0.0 });
    if (cell == 12 || cell == 13)
    {
      boxes->DeleteCell(cell); // the wall, given again
    }
  }
  auto labels = vtkSmartPointer<vtkIntArray>::New();
  labels->SetName("BoundaryLabels");
  labels->SetNumberOfComponents(2);
  for (const double side : sides)
  {
    labels->InsertNextValue(static_cast<int>(side));
  }
  boxes->GetCellData()->AddArray(labels);
  boxes->RemoveDeletedCells();
  vtkNew<vtkBitingTetrahedralizer> filter;
  filter->SetInputData(boxes);
  filter->SetRegionArray("BoundaryLabels");
  filter->SetUniformSpacing(0.3);
  filter->Update();
  EXPECT_EQ(VolumesOf(filter->GetOutput()).size(), 2u);
  vtkDataArray* values = filter->GetOutput()->GetCellData()->GetArray("BoundaryLabels");
  ASSERT_TRUE(values && values->GetNumberOfComponents() == 1);
  double range[2];
  values->GetRange(range);
  EXPECT_EQ(range[0], 4.0);
  EXPECT_EQ(range[1], 9.0);
}

TEST(BitingTetrahedralizer, FillsBodiesThatTouchAtAVertexOrAnEdge)
{
  for (const int height : { 0, 1 })
  {
    vtkNew<vtkBitingTetrahedralizer> filter;
    filter->SetInputData(Boxes({ { 0, 0, 0 }, { 1, 1, height } }));
    filter->SetUniformSpacing(0.3);
    filter->Update();
    EXPECT_EQ(VolumesOf(filter->GetOutput()).size(), 2u) << height;
    EXPECT_NEAR(Figure(filter->GetOutput(), "Volume"), 2.0, 1e-9) << height;
  }
}

TEST(BitingTetrahedralizer, FollowsASourceOfSpace)
{
  vtkNew<vtkBitingTetrahedralizer> filter;
  filter->SetInputData(Sphere());
  filter->SetSpacingSourceData(GradedImage("Spacing", 0.05, 0.15));
  filter->Update();
  EXPECT_NEAR(Figure(filter->GetOutput(), "MeanRelativeLength"), 1.0, 0.1);
  EXPECT_GT(Figure(filter->GetOutput(), "MeanConformity"), 0.75);
}

TEST(BitingTetrahedralizer, ClosesNarrowHolesWithAWarningAndTheirPlaces)
{
  auto holes = Sphere();
  vtkNew<vtkBitingTetrahedralizer> filter;
  filter->SetInputData(holes);
  filter->SetUniformSpacing(0.2);
  filter->Update();
  const double whole = Figure(filter->GetOutput(), "Volume");
  const std::vector<double> tags(static_cast<std::size_t>(holes->GetNumberOfCells()), 7.0);
  AddArray<vtkIntArray>(holes->GetCellData(), "Tag", tags);
  holes->BuildCells();
  for (const vtkIdType cell : { 100, 1000, 1001, 3000 })
  {
    holes->DeleteCell(cell);
  }
  holes->RemoveDeletedCells();
  const Messages messages(filter);
  filter->SetInputData(holes);
  filter->Update();
  EXPECT_TRUE(messages.Errors.empty());
  ASSERT_EQ(messages.Warnings.size(), 1u);
  EXPECT_TRUE(Has(messages.Warnings.front(), "Holes and slits in the surface (3)"))
    << messages.Warnings.front();
  const std::vector<SeenProblem> problems = ReadProblems(filter->GetProblems());
  ASSERT_EQ(problems.size(), 3u);
  EXPECT_EQ(problems.front().Kind, vtkBitingTetrahedralizer::CLOSED_HOLES);
  EXPECT_EQ(problems.front().IsError, 0);
  EXPECT_NEAR(Figure(filter->GetOutput(), "Volume"), whole, 0.005 * whole);
  EXPECT_EQ(Figure(filter->GetOutput(), "EulerNumber"), 2.0);
  double range[2];
  filter->GetBoundary()->GetCellData()->GetArray("Tag")->GetRange(range);
  EXPECT_TRUE(range[0] == 7.0 && range[1] == 7.0);
  filter->SetUniformSpacing(0.03);
  EXPECT_TRUE(Has(ReasonOf(filter), "Open edges"));
}

TEST(BitingTetrahedralizer, FillsTheUnionOfBodiesThatCrossWithAWarningAndTheirPlaces)
{
  auto first = Cube(2.0);
  auto second = Cube(2.0);
  const std::vector<double> ones(static_cast<std::size_t>(first->GetNumberOfCells()), 1.0);
  const std::vector<double> twos(static_cast<std::size_t>(second->GetNumberOfCells()), 2.0);
  AddArray<vtkIntArray>(first->GetCellData(), "Tag", ones);
  AddArray<vtkIntArray>(second->GetCellData(), "Tag", twos);
  for (vtkIdType k = 0; k < second->GetNumberOfPoints(); ++k)
  {
    const Place at = PointOf(second, k);
    second->GetPoints()->SetPoint(k, at[0] + 1.0, at[1] + 0.5, at[2] + 0.25);
  }
  vtkNew<vtkBitingTetrahedralizer> filter;
  filter->SetInputData(Together({ first, second }));
  filter->SetUniformSpacing(0.25);
  const Messages messages(filter);
  filter->Update();
  EXPECT_TRUE(messages.Errors.empty());
  ASSERT_EQ(messages.Warnings.size(), 1u);
  EXPECT_TRUE(Has(messages.Warnings.front(), "Closed surfaces that cross or touch"));
  EXPECT_NEAR(Figure(filter->GetOutput(), "Volume"), 16.0 - 1.0 * 1.5 * 1.75, 1e-3);
  EXPECT_EQ(Figure(filter->GetOutput(), "EulerNumber"), 2.0);
  for (const SeenProblem& problem : ReadProblems(filter->GetProblems()))
  {
    EXPECT_TRUE(problem.IsError == 0 && problem.SecondId >= 0);
  }
  double range[2];
  filter->GetBoundary()->GetCellData()->GetArray("Tag")->GetRange(range);
  EXPECT_TRUE(range[0] == 1.0 && range[1] == 2.0);
}

TEST(BitingTetrahedralizer, RefusesWithAPlaceWhatItCannotFill)
{
  vtkNew<vtkBitingTetrahedralizer> filter;
  filter->SetInputData(UnitSquare());
  EXPECT_TRUE(Has(ReasonOf(filter), "no surface"));
  auto open = Cube();
  open->BuildCells();
  open->DeleteCell(0);
  open->RemoveDeletedCells();
  filter->SetInputData(open);
  const std::string reason = ReasonOf(filter);
  EXPECT_TRUE(Has(reason, "Open edges") && Has(reason, "near (")) << reason;
  EXPECT_EQ(ReadProblems(filter->GetProblems()).size(), 1u);
  auto regions = Together({ Cube(2.0), Sphere(1.2) });
  const std::vector<double> numbers(static_cast<std::size_t>(regions->GetNumberOfCells()), 7.0);
  AddArray<vtkIntArray>(regions->GetCellData(), "Region", numbers);
  filter->SetInputData(regions);
  filter->SetRegionArray("Region");
  EXPECT_TRUE(Has(ReasonOf(filter), "Self-crossings"));
  filter->SetRegionArray("");
  filter->SetInputData(Cube());
  filter->SetBitingConstant(2.0);
  EXPECT_TRUE(Has(ReasonOf(filter), "Biting Constant"));
  filter->SetBitingConstant(0.0);
  filter->SetMaximumNumberOfBites(0);
  EXPECT_TRUE(Has(ReasonOf(filter), "Maximum Number Of Bites"));
  filter->SetMaximumNumberOfBites(-1);
  filter->SetRegionArray("Nothing");
  EXPECT_TRUE(Has(ReasonOf(filter), "Nothing"));
  filter->SetRegionArray("");
  filter->SetUniformSpacing(1e-3);
  EXPECT_TRUE(Has(ReasonOf(filter), "Maximum Number Of Vertices"));
  filter->SetUniformSpacing(0.0);
  filter->SetInputData(Cube(1e-20));
  EXPECT_TRUE(Has(ReasonOf(filter), "Scale it"));
  filter->SetFeatureAngle(std::nan(""));
  EXPECT_TRUE(Has(ReasonOf(filter), "Feature Angle"));
}

TEST(BitingTetrahedralizer, SaysHowManyVerticesCapsMakeAndRefusesTooManyBeforeItBites)
{
  vtkNew<vtkBitingTetrahedralizer> filter;
  filter->SetInputData(Sphere());
  filter->SetUniformSpacing(0.4);
  filter->SetBoundaryTolerance(0.001); // caps f at its floor, a quarter
  filter->Update();
  EXPECT_GT(filter->GetOutput()->GetNumberOfPoints(), 300);
  EXPECT_TRUE(Has(filter->GetSummary(), "times the vertices that the spacing asks for"));
  filter->SetMaximumNumberOfVertices(100);
  const std::string reason = ReasonOf(filter);
  EXPECT_TRUE(Has(reason, "vertices on the surface") && Has(reason, "at most 100")) << reason;
}

TEST(BitingTetrahedralizer, HasNothingToSayOfNothing)
{
  vtkNew<vtkBitingTetrahedralizer> filter;
  Messages messages(filter);
  filter->SetInputData(vtkNew<vtkPolyData>());
  filter->Update();
  EXPECT_TRUE(messages.Errors.empty() && messages.Warnings.empty());
  EXPECT_TRUE(IsEmpty(filter->GetOutput()));
}

TEST(BitingTetrahedralizer, IsTheSameWithAnyNumberOfThreadsAndForAnyKindOfInput)
{
  auto sphere = Sphere(0.5, 30);
  auto filter = Filled(sphere, 0.15);
  const auto first = CopyOf(filter->GetOutput());
  for (const int threads : { 1, 2, 8 })
  {
    filter->SetNumberOfThreads(threads);
    filter->Update();
    EXPECT_TRUE(AreSameGrids(first, filter->GetOutput())) << threads;
  }
  filter->SetGenerateBites(true);
  filter->Update();
  EXPECT_TRUE(AreSameGrids(first, filter->GetOutput()));
  EXPECT_GE(filter->GetBites()->GetNumberOfPoints(), 200);
  EXPECT_TRUE(filter->GetBites()->GetPointData()->GetArray("Radius"));

  vtkNew<vtkUnstructuredGrid> grid;
  grid->SetPoints(sphere->GetPoints());
  grid->SetCells(VTK_TRIANGLE, sphere->GetPolys());
  EXPECT_TRUE(AreSameGrids(first, Filled(grid, 0.15)->GetOutput()));
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, sphere);
  EXPECT_TRUE(AreSameGrids(first, Filled(blocks, 0.15)->GetOutput()));
}

TEST(BitingTetrahedralizer, BitesCubesAndStopsEarly)
{
  vtkNew<vtkBitingTetrahedralizer> filter;
  filter->SetInputData(Cube());
  filter->SetUniformSpacing(0.15);
  filter->SetBiteShapeToCube();
  filter->Update();
  EXPECT_NEAR(VolumesOf(filter->GetOutput())[0], 1.0, 1e-9);
  EXPECT_NEAR(Figure(filter->GetOutput(), "MeanRelativeLength"), 1.0, 0.15);
  const vtkIdType all = filter->GetOutput()->GetNumberOfPoints();
  filter->SetMaximumNumberOfBites(all - 100);
  filter->Update();
  EXPECT_LT(filter->GetOutput()->GetNumberOfPoints(), all - 90);
  EXPECT_NEAR(Figure(filter->GetOutput(), "Volume"), 1.0, 1e-9);
}

TEST(BitingTetrahedralizer, LeavesNothingWhenItIsAbortedAndWorksAgain)
{
  auto sphere = Sphere(0.5, 30);
  const std::vector<double> regions(static_cast<std::size_t>(sphere->GetNumberOfCells()), 1.0);
  AddArray<vtkIntArray>(sphere->GetCellData(), "Region", regions);
  auto filter = Filled(sphere, 0.12);
  filter->SetRegionArray("Region");
  filter->Update();
  const auto first = CopyOf(filter->GetOutput());
  for (const double at : { 0.0, 0.005, 0.01, 0.02, 0.03, 0.05, 0.1, 0.2, 0.5, 0.8 })
  {
    vtkNew<vtkCallbackCommand> stop;
    double limit = at;
    stop->SetClientData(&limit);
    stop->SetCallback(
      [](vtkObject* caller, unsigned long, void* data, void* progress)
      {
        if (*static_cast<double*>(progress) > *static_cast<double*>(data))
        {
          vtkAlgorithm::SafeDownCast(caller)->SetAbortExecute(1);
        }
      });
    const unsigned long tag = filter->AddObserver(vtkCommand::ProgressEvent, stop);
    filter->Modified();
    filter->Update();
    filter->RemoveObserver(tag);
    EXPECT_TRUE(IsEmpty(filter->GetOutput()) && IsEmpty(filter->GetBoundary())) << at;
  }
  filter->Modified();
  filter->Update();
  EXPECT_TRUE(AreSameGrids(first, filter->GetOutput()));
}
