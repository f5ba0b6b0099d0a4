// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "FilterTesting.h"
#include "MeshChecker.h"

#include "vtkIdTypeArray.h"
#include "vtkStringArray.h"

#include <gtest/gtest.h>

#include <set>

using namespace testing_filters;

namespace
{

constexpr double Pi = 3.14159265358979323846;

vtkSmartPointer<vtkBitingMesher> MesherOf(vtkPolyData* input, double spacing = 0.1)
{
  auto mesher = vtkSmartPointer<vtkBitingMesher>::New();
  mesher->SetInputData(input);
  mesher->SetUniformSpacing(spacing);
  mesher->Update();
  return mesher;
}

// How many edges of output 1 have a cell array's value.
vtkIdType CountEdges(vtkBitingMesher* mesher, const char* name, double value)
{
  vtkDataArray* array = mesher->GetOutput(1)->GetCellData()->GetArray(name);
  vtkIdType count = 0;
  for (vtkIdType edge = 0; array && edge < array->GetNumberOfTuples(); ++edge)
  {
    count += array->GetComponent(edge, 0) == value ? 1 : 0;
  }
  return count;
}

// A square with a diagonal inside; Kind as given for both.
vtkSmartPointer<vtkPolyData> SquareWithChain(const std::vector<Place>& chain, bool isClosed)
{
  auto input = UnitSquare();
  AddChain(input, chain, isClosed);
  return input;
}

// A wiggly loop in the plane through `origin` with axes `u` and `v`, as wanted for any plane.
vtkSmartPointer<vtkPolyData> LoopInPlane(const Place& origin, const Place& u, const Place& v)
{
  constexpr int Size = 24;
  std::vector<Place> places;
  for (int k = 0; k < Size; ++k)
  {
    const double angle = 2.0 * Pi * k / Size;
    const double radius = 1.0 + 0.2 * std::cos(3.0 * angle);
    Place place = origin;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      place[axis] += radius * (std::cos(angle) * u[axis] + std::sin(angle) * v[axis]);
    }
    places.push_back(place);
  }
  auto input = EmptyInput();
  AddChain(input, places, true);
  return input;
}

// Twice the area vector of the first triangle: the side from which it is counterclockwise.
Place NormalOf(vtkPolyData* mesh)
{
  vtkNew<vtkIdList> ids;
  mesh->GetCellPoints(0, ids);
  const Place a = PointOf(mesh, ids->GetId(0));
  const Place b = PointOf(mesh, ids->GetId(1));
  const Place c = PointOf(mesh, ids->GetId(2));
  Place normal;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const std::size_t l = (k + 1) % 3;
    const std::size_t m = (k + 2) % 3;
    normal[k] = (b[l] - a[l]) * (c[m] - a[m]) - (b[m] - a[m]) * (c[l] - a[l]);
  }
  return normal;
}

void ExpectInputBitForBit(vtkPolyData* input, vtkPolyData* mesh)
{
  std::set<Place> places;
  for (vtkIdType point = 0; point < mesh->GetNumberOfPoints(); ++point)
  {
    places.insert(PointOf(mesh, point));
  }
  vtkDataArray* originals = mesh->GetPointData()->GetArray("OriginalPointId");
  for (vtkIdType point = 0; point < input->GetNumberOfPoints(); ++point)
  {
    EXPECT_EQ(places.count(PointOf(input, point)), 1u) << "point " << point;
  }
  for (vtkIdType point = 0; point < mesh->GetNumberOfPoints(); ++point)
  {
    const auto original = static_cast<vtkIdType>(originals->GetComponent(point, 0));
    if (original >= 0)
    {
      EXPECT_EQ(PointOf(mesh, point), PointOf(input, original));
    }
  }
}

} // namespace

TEST(BitingMesherInput, MayBeOnePolyline)
{
  const auto mesher = MesherOf(UnitSquare());
  EXPECT_EQ(MeshChecker(mesher->GetOutput()).CheckValidity(), "");
  EXPECT_NEAR(AreaOf(mesher->GetOutput()), 1.0, 1e-12);
}

TEST(BitingMesherInput, MayBeSegmentsThatShareNoPoints)
{
  auto input = EmptyInput();
  const auto corners = Rectangle(0.0, 0.0, 1.0, 1.0);
  for (const std::size_t k : { 2, 0, 3, 1 })
  {
    AddChain(input, { corners[(k + 1) % 4], corners[k] }, false);
  }
  vtkNew<vtkBitingMesher> mesher;
  Messages messages(mesher);
  mesher->SetInputData(input);
  mesher->Update();
  EXPECT_NEAR(AreaOf(mesher->GetOutput()), 1.0, 1e-12);
  EXPECT_TRUE(messages.Errors.empty());
  EXPECT_TRUE(messages.Warnings.empty());
}

TEST(BitingMesherInput, MayBeAPolygon)
{
  auto input = EmptyInput();
  for (const Place& place : Rectangle(0.0, 0.0, 3.0, 2.0))
  {
    input->GetPoints()->InsertNextPoint(place.data());
  }
  input->GetPolys()->InsertNextCell({ 0, 1, 2, 3 });
  EXPECT_NEAR(AreaOf(MesherOf(input)->GetOutput()), 6.0, 1e-12);
}

TEST(BitingMesherInput, MayHaveFloatPoints)
{
  auto input = UnitSquare(0.0, VTK_FLOAT);
  const Place odd{ 0.1, 1.0 / 3.0, 0.0 };
  AddVertex(input, odd);
  const auto mesher = MesherOf(input);
  EXPECT_EQ(mesher->GetOutput()->GetPoints()->GetDataType(), VTK_DOUBLE);
  EXPECT_NEAR(AreaOf(mesher->GetOutput()), 1.0, 1e-12);
  ExpectInputBitForBit(input, mesher->GetOutput());
}

TEST(BitingMesherInput, MayHoldPointsThatNoCellUses)
{
  auto input = UnitSquare();
  const Place far{ 1e9, std::nan(""), 7.0 };
  input->GetPoints()->InsertNextPoint(far.data());
  const auto mesher = MesherOf(input);
  EXPECT_NEAR(AreaOf(mesher->GetOutput()), 1.0, 1e-12);
}

TEST(BitingMesherInput, MayHoldCellsWithTooFewPoints)
{
  auto input = UnitSquare();
  AddChain(input, { { 0.5, 0.5, 0.0 } }, false);
  AddChain(input, { { 0.25, 0.5, 0.0 } }, true);
  input->GetLines()->InsertNextCell(0);
  input->GetVerts()->InsertNextCell(0);
  input->GetPolys()->InsertNextCell({ 0 });
  input->GetPolys()->InsertNextCell({ 0, 1 });
  vtkNew<vtkBitingMesher> mesher;
  Messages messages(mesher);
  mesher->SetInputData(input);
  mesher->Update();
  EXPECT_TRUE(messages.Errors.empty());
  EXPECT_NEAR(AreaOf(mesher->GetOutput()), 1.0, 1e-12);
}

TEST(BitingMesherInput, BecomesAHoleByNestingWhateverItsOrientation)
{
  for (const bool isReversed : { false, true })
  {
    auto hole = Rectangle(0.25, 0.25, 0.75, 0.75);
    if (isReversed)
    {
      std::reverse(hole.begin(), hole.end());
    }
    const auto mesher = MesherOf(SquareWithChain(hole, true));
    EXPECT_NEAR(AreaOf(mesher->GetOutput()), 0.75, 1e-12);
  }
}

TEST(BitingMesherInput, BecomesAnInterfaceWhereItIsOpen)
{
  const auto mesher = MesherOf(SquareWithChain({ { 0.2, 0.2, 0.0 }, { 0.8, 0.7, 0.0 } }, false));
  const MeshChecker checker(mesher->GetOutput());
  EXPECT_NEAR(checker.Area(), 1.0, 1e-12);
  EXPECT_TRUE(checker.Covers({ 0.2, 0.2 }, { 0.8, 0.7 }, 1e-15));
  EXPECT_GT(CountEdges(mesher, "Kind", 1.0), 3);
  EXPECT_EQ(CountEdges(mesher, "Kind", 1.0), CountEdges(mesher, "OriginalCellId", 1.0));
}

TEST(BitingMesherKind, MakesAClosedLoopAnInterface)
{
  for (const bool isDouble : { false, true })
  {
    auto input = SquareWithChain(Rectangle(0.25, 0.25, 0.75, 0.75), true);
    if (isDouble)
    {
      AddArray<vtkDoubleArray>(input->GetCellData(), "Kind", { 0.0, 1.0 });
    }
    else
    {
      AddArray<vtkIntArray>(input->GetCellData(), "Kind", { 0.0, 1.0 });
    }
    const auto mesher = MesherOf(input);
    EXPECT_NEAR(AreaOf(mesher->GetOutput()), 1.0, 1e-12);
    EXPECT_TRUE(MeshChecker(mesher->GetOutput()).Covers({ 0.25, 0.25 }, { 0.75, 0.25 }, 1e-15));
  }
}

TEST(BitingMesherKind, MakesTheEndsOfALineEmbeddedPoints)
{
  auto input = SquareWithChain({ { 0.21, 0.23, 0.0 }, { 0.81, 0.77, 0.0 } }, false);
  AddArray<vtkIntArray>(input->GetCellData(), "Kind", { 0.0, 2.0 });
  const auto mesher = MesherOf(input);
  const MeshChecker checker(mesher->GetOutput());
  EXPECT_TRUE(checker.HasVertex({ 0.21, 0.23 }));
  EXPECT_TRUE(checker.HasVertex({ 0.81, 0.77 }));
  EXPECT_EQ(CountEdges(mesher, "OriginalCellId", 1.0), 0);
}

TEST(BitingMesherVertexCells, BecomeVerticesOfTheMesh)
{
  auto input = UnitSquare();
  AddVertex(input, { 0.123456789, 0.3, 0.0 });
  // Cells are numbered vertices first: the square is cell 1.
  AddArray<vtkIntArray>(input->GetCellData(), "Kind", { 0.0, 0.0 });
  const auto mesher = MesherOf(input);
  EXPECT_TRUE(MeshChecker(mesher->GetOutput()).HasVertex({ 0.123456789, 0.3 }));
  vtkDataArray* kinds = mesher->GetOutput()->GetPointData()->GetArray("VertexKind");
  vtkIdType embedded = 0;
  for (vtkIdType point = 0; point < kinds->GetNumberOfTuples(); ++point)
  {
    embedded += kinds->GetComponent(point, 0) == 3.0 ? 1 : 0;
  }
  EXPECT_EQ(embedded, 1);
  EXPECT_EQ(CountEdges(mesher, "OriginalCellId", 1.0), mesher->GetOutput(1)->GetNumberOfCells());
}

TEST(BitingMesherTags, OfAnyTypeAreCarriedToTheBoundaryEdges)
{
  auto input = SquareWithChain(Rectangle(0.25, 0.25, 0.75, 0.75), true);
  AddArray<vtkDoubleArray>(input->GetCellData(), "Tag", { 1.5, 2.5 });
  vtkNew<vtkStringArray> names;
  names->SetName("Name");
  names->InsertNextValue("outside");
  names->InsertNextValue("hole");
  input->GetCellData()->AddArray(names);
  const auto mesher = MesherOf(input);
  vtkCellData* carried = mesher->GetOutput(1)->GetCellData();
  auto* carriedNames = vtkStringArray::SafeDownCast(carried->GetAbstractArray("Name"));
  vtkDataArray* cells = carried->GetArray("OriginalCellId");
  ASSERT_TRUE(carriedNames);
  ASSERT_GT(cells->GetNumberOfTuples(), 40);
  for (vtkIdType edge = 0; edge < cells->GetNumberOfTuples(); ++edge)
  {
    const bool isHole = cells->GetComponent(edge, 0) == 1.0;
    EXPECT_EQ(carried->GetArray("Tag")->GetComponent(edge, 0), isHole ? 2.5 : 1.5);
    EXPECT_EQ(carriedNames->GetValue(edge), isHole ? "hole" : "outside");
  }
  EXPECT_GT(CountEdges(mesher, "OriginalCellId", 0.0), CountEdges(mesher, "Tag", 2.5));
}

TEST(BitingMesherPlane, OfConstantZKeepsCoordinatesAsTheyAre)
{
  const auto input = UnitSquare(5.0);
  const auto mesher = MesherOf(input);
  vtkPolyData* mesh = mesher->GetOutput();
  for (vtkIdType point = 0; point < mesh->GetNumberOfPoints(); ++point)
  {
    EXPECT_EQ(PointOf(mesh, point)[2], 5.0);
  }
  ExpectInputBitForBit(input, mesh);
  const auto flat = MesherOf(UnitSquare());
  EXPECT_TRUE(AreSameArrays(mesh->GetPointData(), flat->GetOutput()->GetPointData()));
}

TEST(BitingMesherPlane, OfConstantXOrYIsExactAndCounterclockwiseSeenFromAbove)
{
  for (const std::size_t normal : { 0, 1 })
  {
    Place u{};
    Place v{};
    u[(normal + 1) % 3] = 1.0;
    v[(normal + 2) % 3] = 1.0;
    const auto input = LoopInPlane({ 0.3, 0.3, 0.3 }, v, u);
    const auto mesher = MesherOf(input);
    vtkPolyData* mesh = mesher->GetOutput();
    ASSERT_GT(mesh->GetNumberOfCells(), 100);
    for (vtkIdType point = 0; point < mesh->GetNumberOfPoints(); ++point)
    {
      EXPECT_EQ(PointOf(mesh, point)[normal], 0.3);
    }
    EXPECT_GT(NormalOf(mesh)[normal], 0.0);
    ExpectInputBitForBit(input, mesh);
  }
}

TEST(BitingMesherPlane, MayBeTilted)
{
  const double s = std::sqrt(0.5);
  const auto flat = MesherOf(LoopInPlane({ 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }));
  const auto input = LoopInPlane({ 10.0, -20.0, 30.0 }, { s, s, 0.0 }, { 0.0, 0.6, -0.8 });
  const auto mesher = MesherOf(input);
  vtkPolyData* mesh = mesher->GetOutput();
  ASSERT_GT(mesh->GetNumberOfCells(), 100);
  ExpectInputBitForBit(input, mesh);
  // u x v: its length is the factor between areas.
  const Place normal{ -0.8 * s, 0.8 * s, 0.6 * s };
  for (vtkIdType point = 0; point < mesh->GetNumberOfPoints(); ++point)
  {
    const Place place = PointOf(mesh, point);
    const double offset =
      (place[0] - 10.0) * normal[0] + (place[1] + 20.0) * normal[1] + (place[2] - 30.0) * normal[2];
    EXPECT_NEAR(offset, 0.0, 1e-13);
  }
  const double sine =
    std::sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
  EXPECT_NEAR(AreaOf(mesh), AreaOf(flat->GetOutput()) * sine, 1e-12);
}

TEST(BitingMesherPlane, WithPointsCollinearInSpaceIsNoCrash)
{
  auto input = EmptyInput();
  AddChain(input, { { 0, 0, 0 }, { 1, 2, 3 }, { 2, 4, 6 } }, true);
  vtkNew<vtkBitingMesher> mesher;
  Messages messages(mesher);
  mesher->SetInputData(input);
  mesher->Update();
  EXPECT_TRUE(IsEmpty(mesher->GetOutput()));
  EXPECT_GT(messages.Errors.size() + messages.Warnings.size(), 0u);
}
