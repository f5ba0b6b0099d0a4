// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "MeshChecker.h"
#include "RemesherTesting.h"

#include "vtkDelaunay2D.h"
#include "vtkErrorCode.h"
#include "vtkTransform.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <array> // for corners

using namespace testing_filters;

namespace
{

bool AreAllEmpty(vtkBitingRemesher* remesher)
{
  return IsEmpty(remesher->GetOutput(0)) && IsEmpty(remesher->GetOutput(1)) &&
    IsEmpty(remesher->GetOutput(2));
}

} // namespace

TEST(BitingRemesher, PassesAMeshThroughThatHasTheSpacingThatIsWanted)
{
  const auto mesh = SquareMesh();
  const auto remesher = RemesherOf(mesh);
  remesher->Update();
  vtkPolyData* output = remesher->GetOutput();
  EXPECT_EQ(output->GetPoints(), mesh->GetPoints());
  EXPECT_TRUE(AreSameBytes(
    output->GetPolys()->GetConnectivityArray(), mesh->GetPolys()->GetConnectivityArray()));
  for (int k = 0; k < mesh->GetPointData()->GetNumberOfArrays(); ++k)
  {
    const std::string name = mesh->GetPointData()->GetArrayName(k);
    EXPECT_TRUE(name == "OriginalPointId" ||
      output->GetPointData()->GetAbstractArray(name.c_str()) ==
        mesh->GetPointData()->GetAbstractArray(k));
  }
  EXPECT_EQ(output->GetPointData()->GetArray("OriginalPointId")->GetComponent(7, 0), 7.0);
  EXPECT_EQ(output->GetCellData()->GetArray("OriginalCellId")->GetComponent(7, 0), 7.0);
  EXPECT_NE(mesh->GetPointData()->GetArray("OriginalPointId")->GetComponent(7, 0), 7.0);
  EXPECT_EQ(Figure(output, "NewVertices"), 0.0);
  EXPECT_GT(remesher->GetOutput(1)->GetNumberOfLines(), 70);
  EXPECT_TRUE(Has(remesher->GetSummary(), "0 removed, 0 new"));
}

TEST(BitingRemesher, RefinesWhereItIsAskedTo)
{
  const auto mesh = Wanting(SquareMesh(), Left);
  const auto remesher = RemesherOf(mesh);
  remesher->Update();
  vtkPolyData* output = remesher->GetOutput();
  const MeshChecker checker(output);
  EXPECT_EQ(checker.CheckValidity(), "");
  EXPECT_EQ(checker.CheckArea(1.0, 1e-12), "");
  EXPECT_GT(output->GetNumberOfPoints(), 1.3 * static_cast<double>(mesh->GetNumberOfPoints()));
  vtkDataArray* originals = output->GetPointData()->GetArray("OriginalPointId");
  vtkIdType kept = 0;
  for (vtkIdType point = 0; point < output->GetNumberOfPoints(); ++point)
  {
    const auto original = static_cast<vtkIdType>(originals->GetComponent(point, 0));
    kept += original >= 0;
    EXPECT_TRUE(original < 0 || PointOf(output, point) == PointOf(mesh, original));
  }
  EXPECT_EQ(static_cast<double>(kept), Figure(output, "KeptVertices"));
  EXPECT_EQ(Figure(output, "KeptVertices") + Figure(output, "NewVertices"),
    static_cast<double>(output->GetNumberOfPoints()));
  EXPECT_GT(static_cast<double>(kept), 0.9 * static_cast<double>(mesh->GetNumberOfPoints()));
  EXPECT_GT(Figure(output, "KeptTriangles"), 100.0);
  EXPECT_GT(Figure(output, "SmallestAngle"), 28.0);
}

TEST(BitingRemesher, CoarsensToAUniformSpacing)
{
  const auto mesh = SquareMesh();
  const auto remesher = RemesherOf(mesh);
  remesher->SetUniformSpacing(2.0 * Spacing);
  remesher->Update();
  const MeshChecker checker(remesher->GetOutput());
  EXPECT_EQ(checker.CheckValidity(), "");
  EXPECT_EQ(checker.CheckArea(1.0, 1e-12), "");
  EXPECT_LT(static_cast<double>(remesher->GetOutput()->GetNumberOfPoints()),
    0.35 * static_cast<double>(mesh->GetNumberOfPoints()));
  EXPECT_TRUE(Has(remesher->GetSummary(), " removed, "));
  EXPECT_FALSE(Has(remesher->GetSummary(), "of the drawing not needed"));
}

TEST(BitingRemesher, ReadsMeshesInAnyPlaneOfOtherPrograms)
{
  vtkNew<vtkPoints> points;
  for (int k = 0; k < 400; ++k)
  {
    const double x = (k % 20) / 19.0 + 0.01 * std::sin(7.0 * k);
    points->InsertNextPoint(x, (k / 20) / 19.0 + 0.01 * std::cos(5.0 * k), 0.0);
  }
  vtkNew<vtkPolyData> cloud;
  cloud->SetPoints(points);
  vtkNew<vtkDelaunay2D> delaunay;
  delaunay->SetInputData(cloud);
  vtkNew<vtkTransform> turn;
  turn->RotateX(30.0);
  turn->RotateY(50.0);
  turn->Translate(5.0, 6.0, 7.0);
  delaunay->Update();
  vtkNew<vtkPoints> places;
  turn->TransformPoints(points, places);
  vtkPolyData* turned = delaunay->GetOutput();
  turned->SetPoints(places);
  for (const double spacing : { 0.02, 0.09 })
  {
    const auto remesher = RemesherOf(turned);
    const Messages messages(remesher);
    remesher->SetUniformSpacing(spacing);
    remesher->Update();
    EXPECT_TRUE(messages.Errors.empty());
    EXPECT_NEAR(AreaOf(remesher->GetOutput()), AreaOf(turned), 1e-5);
  }
}

TEST(BitingRemesher, TakesTheTrianglesOfAnUnstructuredGrid)
{
  const auto mesh = SquareMesh();
  vtkNew<vtkUnstructuredGrid> grid;
  grid->SetPoints(mesh->GetPoints());
  grid->SetCells(VTK_TRIANGLE, mesh->GetPolys());
  grid->GetPointData()->ShallowCopy(mesh->GetPointData());
  grid->GetCellData()->ShallowCopy(mesh->GetCellData());
  const auto same = RemesherOf(grid);
  same->Update();
  EXPECT_EQ(same->GetOutput()->GetNumberOfPolys(), mesh->GetNumberOfPolys());
  EXPECT_TRUE(AreSameBytes(same->GetOutput()->GetCellData()->GetArray("MinimumAngle"),
    mesh->GetCellData()->GetArray("MinimumAngle")));
  const auto finer = RemesherOf(grid);
  finer->SetUniformSpacing(0.5 * Spacing);
  finer->Update();
  EXPECT_EQ(MeshChecker(finer->GetOutput()).CheckValidity(), "");
}

TEST(BitingRemesher, FollowsASpacingSource)
{
  const auto mesh = SquareMesh();
  const auto source = Wanting(mesh, Left);
  source->GetPointData()->RemoveArray("Spacing");
  const auto remesher = RemesherOf(mesh);
  remesher->SetSpacingSourceData(source);
  remesher->SetInputArrayToProcess(1, 1, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Wanted");
  remesher->Update();
  EXPECT_EQ(MeshChecker(remesher->GetOutput()).CheckValidity(), "");
  EXPECT_GT(remesher->GetOutput()->GetNumberOfPoints(), mesh->GetNumberOfPoints());
  EXPECT_GT(Figure(remesher->GetOutput(), "MeanConformity"), 0.9);
}

TEST(BitingRemesher, RefusesTolerancesThatAreNone)
{
  for (const char* name : { "Boundary Tolerance", "Feature Angle" })
  {
    const auto remesher = RemesherOf(SquareMesh());
    const Messages messages(remesher);
    remesher->SetBoundaryTolerance(std::string(name) == "Boundary Tolerance" ? -0.1 : 0.1);
    remesher->SetFeatureAngle(std::string(name) == "Feature Angle" ? -1.0 : 30.0);
    remesher->Update();
    ASSERT_EQ(messages.Errors.size(), 1u);
    EXPECT_TRUE(Has(messages.Errors[0], name));
  }
}

TEST(BitingRemesher, SaysOnceWhatIsWrong)
{
  const auto mesh = SquareMesh();
  const auto expectError = [](vtkBitingRemesher* remesher, const char* part)
  {
    const Messages messages(remesher);
    remesher->Update();
    ASSERT_EQ(messages.Errors.size(), 1u) << part;
    EXPECT_TRUE(Has(messages.Errors[0], part)) << messages.Errors[0];
    EXPECT_TRUE(AreAllEmpty(remesher));
    EXPECT_EQ(remesher->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::UserError));
    EXPECT_TRUE(Has(remesher->GetSummary(), "Error: "));
  };
  const auto none = RemesherOf(mesh);
  none->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "None");
  expectError(none, "There is no spacing to remesh to");
  const auto missing = RemesherOf(mesh);
  missing->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Absent");
  expectError(missing, "no point array named Absent");
  const auto negative = RemesherOf(Wanting(mesh, [](const Place&) { return -1.0; }));
  expectError(negative, "spacing");
  const auto scaled = RemesherOf(mesh);
  scaled->SetSpacingScale(0.0);
  expectError(scaled, "Spacing Scale is 0");
  const auto frozen = RemesherOf(mesh);
  frozen->SetFrozenArray("Absent");
  expectError(frozen, "Absent");
  const auto large = RemesherOf(mesh);
  large->SetUniformSpacing(0.0001);
  large->SetMaximumNumberOfVertices(1000);
  expectError(large, "Maximum Number Of Vertices");
  const auto lines = RemesherOf(UnitSquare());
  expectError(lines, "no triangles");
}

TEST(BitingRemesher, MendsFlatTrianglesWithAWord)
{
  // The middle of the diagonal is a corner on one side of it only, but for a triangle on it.
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Place& place : { Place{ 0, 0, 0 }, Place{ 1, 0, 0 }, Place{ 1, 1, 0 },
         Place{ 0, 1, 0 }, Place{ 0.5, 0.5, 0 } })
  {
    points->InsertNextPoint(place.data());
  }
  mesh->SetPoints(points);
  vtkNew<vtkCellArray> triangles;
  for (const std::array<vtkIdType, 3>& corners :
    { std::array<vtkIdType, 3>{ 0, 1, 4 }, { 1, 2, 4 }, { 0, 4, 2 }, { 0, 2, 3 } })
  {
    triangles->InsertNextCell(3, corners.data());
  }
  mesh->SetPolys(triangles);
  vtkNew<vtkIntArray> tags;
  tags->SetName("Tag");
  for (const int tag : { 1, 1, 2, 3 })
  {
    tags->InsertNextValue(tag);
  }
  mesh->GetCellData()->AddArray(tags);
  for (const double spacing : { 0.1, 0.7 })
  {
    const auto remesher = RemesherOf(mesh);
    remesher->SetUniformSpacing(spacing);
    remesher->SetRegionArray("None");
    const Messages messages(remesher);
    remesher->Update();
    EXPECT_TRUE(messages.Errors.empty());
    ASSERT_EQ(messages.Warnings.size(), 1u);
    EXPECT_TRUE(Has(messages.Warnings[0], "Triangles without area (1): cell 2"));
    vtkPolyData* output = remesher->GetOutput();
    const MeshChecker checker(output);
    EXPECT_EQ(checker.CheckValidity(), "");
    EXPECT_EQ(checker.CheckArea(1.0, 1e-12), "");
    EXPECT_EQ(Figure(output, "RepairedFlatTriangles"), 1.0);
    vtkDataArray* given = output->GetCellData()->GetArray("Tag");
    for (vtkIdType cell = 0; cell < output->GetNumberOfCells(); ++cell)
    {
      EXPECT_NE(given->GetComponent(cell, 0), 2.0);
    }
  }
}

// One below the square, on its side; where all is frozen it stays.
TEST(BitingRemesher, HasDataForAllTrianglesWhereAFlatOneIsAtTheRim)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Place& place :
    { Place{ 0, 0, 0 }, Place{ 2, 0, 0 }, Place{ 1, 1, 0 }, Place{ 1, 0, 0 } })
  {
    points->InsertNextPoint(place.data());
  }
  vtkNew<vtkCellArray> triangles;
  for (const std::array<vtkIdType, 3>& corners :
    { std::array<vtkIdType, 3>{ 0, 1, 3 }, { 0, 3, 2 }, { 3, 1, 2 } })
  {
    triangles->InsertNextCell(3, corners.data());
  }
  vtkNew<vtkIntArray> tags;
  tags->SetName("Tag");
  for (const int tag : { 1, 2, 3 })
  {
    tags->InsertNextValue(tag);
  }
  vtkNew<vtkPolyData> surface;
  surface->SetPolys(triangles);
  vtkNew<vtkUnstructuredGrid> grid;
  grid->SetCells(VTK_TRIANGLE, triangles);
  for (vtkPointSet* mesh : { static_cast<vtkPointSet*>(surface), static_cast<vtkPointSet*>(grid) })
  {
    mesh->SetPoints(points);
    mesh->GetCellData()->AddArray(tags);
    for (const bool isFrozen : { false, true })
    {
      vtkNew<vtkBitingRemesher> remesher;
      remesher->SetInputDataObject(mesh);
      remesher->SetUniformSpacing(1.2);
      remesher->SetFrozenArray(isFrozen ? "Tag" : "");
      const Messages messages(remesher);
      remesher->Update();
      EXPECT_TRUE(messages.Errors.empty());
      EXPECT_EQ(messages.Warnings.size(), 1u);
      vtkPolyData* output = remesher->GetOutput();
      const vtkIdType count = output->GetNumberOfCells();
      EXPECT_EQ(count == 3, isFrozen);
      EXPECT_GE(count, 2);
      EXPECT_EQ(output->GetCellData()->GetArray("Tag")->GetNumberOfTuples(), count);
      EXPECT_EQ(output->GetCellData()->GetArray("OriginalCellId")->GetNumberOfTuples(), count);
      EXPECT_EQ(MeshChecker(output).CheckValidity().empty(), !isFrozen);
    }
  }
}

TEST(BitingRemesher, ShowsCellsThatFormNoMesh)
{
  auto folded = EmptyInput();
  for (const Place& place :
    { Place{ 0, 0, 0 }, Place{ 1, 0, 0 }, Place{ 1, 1, 0 }, Place{ 0.2, 0.7, 0 } })
  {
    folded->GetPoints()->InsertNextPoint(place.data());
  }
  const vtkIdType first[] = { 0, 1, 2 };
  const vtkIdType second[] = { 0, 1, 3 };
  folded->GetPolys()->InsertNextCell(3, first);
  folded->GetPolys()->InsertNextCell(3, second);
  const auto remesher = RemesherOf(folded);
  remesher->SetUniformSpacing(0.1);
  const Messages messages(remesher);
  remesher->Update();
  ASSERT_EQ(messages.Errors.size(), 1u);
  EXPECT_TRUE(Has(messages.Errors[0], "Triangles that form no mesh (2): cell 0"));
  EXPECT_TRUE(AreAllEmpty(remesher));
  EXPECT_EQ(remesher->GetOutput(3)->GetNumberOfPoints(), 2);
  EXPECT_EQ(remesher->GetOutput(3)->GetCellData()->GetNumberOfArrays() +
        remesher->GetOutput(3)->GetPointData()->GetNumberOfArrays() >
      0,
    true);
}

TEST(BitingRemesher, MakesNothingOfNothing)
{
  const auto remesher = RemesherOf(EmptyInput());
  const Messages messages(remesher);
  remesher->Update();
  EXPECT_TRUE(messages.Errors.empty() && messages.Warnings.empty());
  EXPECT_TRUE(AreAllEmpty(remesher));
}

TEST(BitingRemesher, StopsWhenItIsAskedToAndWorksAgain)
{
  const auto remesher = RemesherOf(SquareMesh());
  remesher->SetUniformSpacing(0.005);
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback([](vtkObject* filter, unsigned long, void*, void*)
    { static_cast<vtkAlgorithm*>(filter)->SetAbortExecute(1); });
  const unsigned long tag = remesher->AddObserver(vtkCommand::ProgressEvent, stop);
  remesher->Update();
  EXPECT_TRUE(AreAllEmpty(remesher));
  remesher->RemoveObserver(tag);
  remesher->Modified();
  remesher->Update();
  EXPECT_GT(remesher->GetOutput()->GetNumberOfPoints(), 20000);
}

TEST(BitingRemesher, EndsByStopWithAnErrorThatStaysUntilSomethingChanges)
{
  const auto remesher = RemesherOf(SquareMesh());
  remesher->SetUniformSpacing(0.005);
  const Messages messages(remesher);
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback([](vtkObject* filter, unsigned long, void*, void*)
    { static_cast<vtkBitingRemesher*>(filter)->Stop(); });
  const unsigned long tag = remesher->AddObserver(vtkCommand::ProgressEvent, stop);
  remesher->Update();
  remesher->RemoveObserver(tag);
  remesher->Update();
  EXPECT_TRUE(AreAllEmpty(remesher));
  ASSERT_EQ(messages.Errors.size(), 1u);
  EXPECT_TRUE(Has(messages.Errors[0], "Stopped")) << messages.Errors[0];
  remesher->SetUniformSpacing(0.01);
  remesher->Update();
  EXPECT_GT(remesher->GetOutput()->GetNumberOfPoints(), 5000);
}

TEST(BitingRemesher, ChangesNothingOfItsInput)
{
  const auto mesh = Wanting(SquareMesh(), Half);
  vtkNew<vtkPolyData> before;
  before->DeepCopy(mesh);
  const auto remesher = RemesherOf(mesh);
  remesher->GenerateBitesOn();
  remesher->Update();
  EXPECT_TRUE(AreSame(mesh, before));
  EXPECT_GT(remesher->GetOutput(2)->GetNumberOfPolys(), 100);
}
