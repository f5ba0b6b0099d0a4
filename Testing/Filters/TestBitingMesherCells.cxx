// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "FilterTesting.h"
#include "MeshChecker.h"

#include "vtkCellType.h"
#include "vtkDataSetAttributes.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <set>
#include <utility>

using namespace testing_filters;

namespace
{

/// What a run of the filter gave.
struct CellRun
{
  vtkSmartPointer<vtkBitingMesher> Mesher = vtkSmartPointer<vtkBitingMesher>::New();
  std::vector<std::string> Warnings;
  std::vector<std::string> Errors;

  explicit CellRun(vtkSmartPointer<vtkDataObject> input)
    : Input(std::move(input))
  {
    this->Mesher->SetUniformSpacing(0.5);
  }

  void Update()
  {
    Messages messages(this->Mesher);
    this->Mesher->SetInputDataObject(this->Input);
    this->Mesher->Update();
    this->Warnings = messages.Warnings;
    this->Errors = messages.Errors;
  }

  double Area() const { return AreaOf(this->Mesher->GetOutput()); }

  int Regions() const
  {
    vtkDataArray* regions = this->Mesher->GetOutput()->GetCellData()->GetArray("RegionId");
    return regions ? static_cast<int>(regions->GetRange()[1]) + 1 : 0;
  }

  /// Of the boundary edges.
  std::set<std::string> ValuesOf(const char* name) const
  {
    vtkAbstractArray* array = this->Mesher->GetOutput(1)->GetCellData()->GetAbstractArray(name);
    std::set<std::string> values;
    for (vtkIdType edge = 0; array && edge < array->GetNumberOfTuples(); ++edge)
    {
      values.insert(array->GetVariantValue(edge).ToString());
    }
    return values;
  }

private:
  vtkSmartPointer<vtkDataObject> Input;
};

void ExpectQuietArea(CellRun run, double area, int regions = 1)
{
  run.Update();
  EXPECT_TRUE(run.Errors.empty());
  EXPECT_TRUE(run.Warnings.empty()) << run.Warnings.front();
  EXPECT_EQ(MeshChecker(run.Mesher->GetOutput()).CheckValidity(), "");
  EXPECT_NEAR(run.Area(), area, 1e-12 * area);
  EXPECT_EQ(run.Regions(), regions);
}

vtkSmartPointer<vtkUnstructuredGrid> GridWithPoints(const std::vector<Place>& places)
{
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Place& place : places)
  {
    points->InsertNextPoint(place.data());
  }
  grid->SetPoints(points);
  return grid;
}

void AddCell(vtkUnstructuredGrid* grid, int type, const std::vector<vtkIdType>& points)
{
  grid->InsertNextCell(type, static_cast<vtkIdType>(points.size()), points.data());
}

/// 3 x 2 points, numbered by rows.
vtkSmartPointer<vtkUnstructuredGrid> TwoSquares()
{
  auto grid = GridWithPoints(
    { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 0, 1, 0 }, { 1, 1, 0 }, { 2, 1, 0 } });
  AddCell(grid, VTK_QUAD, { 0, 1, 4, 3 });
  AddCell(grid, VTK_PIXEL, { 1, 2, 4, 5 });
  return grid;
}

template <typename Array, typename Value>
void AddValues(vtkDataSet* data, const char* name, const std::vector<Value>& values)
{
  vtkNew<Array> array;
  array->SetName(name);
  for (const Value& value : values)
  {
    array->InsertNextValue(value);
  }
  data->GetCellData()->AddArray(array);
}

} // namespace

TEST(BitingMesherCells, OfAllFlatKindsCountByTheirArea)
{
  auto grid = GridWithPoints({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 2, 0, 0 },
    { 2, 1, 0 }, { 3, 0, 0 }, { 3, 1, 0 }, { 1, 2, 0 }, { 0.5, 2.25, 0 }, { 0, 2, 0 } });
  AddCell(grid, VTK_TRIANGLE, { 0, 1, 2 });
  AddCell(grid, VTK_TRIANGLE, { 0, 3, 2 });
  AddCell(grid, VTK_TRIANGLE_STRIP, { 1, 2, 4, 5 });
  AddCell(grid, VTK_QUAD, { 4, 6, 7, 5 });
  AddCell(grid, VTK_POLYGON, { 2, 8, 9, 10, 3 });
  ExpectQuietArea(CellRun(grid), 4.125);
}

TEST(BitingMesherCells, QuadraticOnesHaveStraightSidesThroughTheirPoints)
{
  auto grid = GridWithPoints(
    { { 0, 0, 0 }, { 2, 0, 0 }, { 2, 2, 0 }, { 0, 2, 0 }, { 1, -0.5, 0 }, { 2, 1, 0 }, { 1, 2, 0 },
      { 0, 1, 0 }, { 1, 1, 0 }, { 3, 0, 0 }, { 2.5, 0, 0 }, { 2.5, 1, 0 } });
  AddCell(grid, VTK_BIQUADRATIC_QUAD, { 0, 1, 2, 3, 4, 5, 6, 7, 8 });
  AddCell(grid, VTK_QUADRATIC_TRIANGLE, { 1, 9, 2, 10, 11, 5 });
  ExpectQuietArea(CellRun(grid), 5.5);
}

TEST(BitingMesherCells, MayBePixelsOfAnImage)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(4, 3, 1);
  ExpectQuietArea(CellRun(image.GetPointer()), 6.0);
}

TEST(BitingMesherCells, OfDifferentValuesInTheRegionArrayAreRegions)
{
  const auto check = [](vtkUnstructuredGrid* grid)
  {
    CellRun run(grid);
    run.Mesher->SetRegionArray("material");
    ExpectQuietArea(run, 2.0, 2);
  };
  auto ints = TwoSquares();
  AddValues<vtkIdTypeArray, vtkIdType>(ints, "material", { 9007199254740993, 9007199254740992 });
  check(ints);
  auto reals = TwoSquares();
  AddValues<vtkDoubleArray, double>(reals, "material", { 0.5, std::nan("") });
  check(reals);
  auto texts = TwoSquares();
  AddValues<vtkStringArray, std::string>(texts, "material", { "steel", "air" });
  check(texts);
}

TEST(BitingMesherCells, OfEqualValuesInTheRegionArrayAreOne)
{
  auto grid = TwoSquares();
  AddValues<vtkDoubleArray, double>(grid, "material", { 0.0, -0.0 });
  CellRun run(grid);
  run.Mesher->SetRegionArray("material");
  ExpectQuietArea(run, 2.0);
}

/// A square of side 4, and one of side 2 whose middle is its upper right corner.
vtkSmartPointer<vtkUnstructuredGrid> OverlappingSquares()
{
  auto grid = GridWithPoints({ { 0, 0, 0 }, { 4, 0, 0 }, { 4, 4, 0 }, { 0, 4, 0 }, { 3, 3, 0 },
    { 5, 3, 0 }, { 5, 5, 0 }, { 3, 5, 0 } });
  AddCell(grid, VTK_QUAD, { 0, 1, 2, 3 });
  AddCell(grid, VTK_QUAD, { 4, 5, 6, 7 });
  return grid;
}

TEST(BitingMesherCells, AreOneDomainByEachRule)
{
  CellRun evenOdd(OverlappingSquares());
  evenOdd.Update();
  EXPECT_NEAR(evenOdd.Area(), 18.0, 1e-12);
  ASSERT_EQ(evenOdd.Warnings.size(), 1u);
  EXPECT_NE(evenOdd.Warnings.front().find("Domain Rule"), std::string::npos);
  CellRun outer(OverlappingSquares());
  outer.Mesher->SetDomainRuleToOuterMinusOthers();
  ExpectQuietArea(outer, 15.0, 1);
  CellRun whole(OverlappingSquares());
  whole.Mesher->SetDomainRuleToUnion();
  ExpectQuietArea(whole, 19.0, 2);
  auto alike = OverlappingSquares();
  AddValues<vtkDoubleArray, double>(alike, "material", { 1.0, 1.0 });
  CellRun region(alike);
  region.Mesher->SetDomainRuleToUnion();
  region.Mesher->SetRegionArray("material");
  ExpectQuietArea(region, 19.0, 1);
}

TEST(BitingMesherCells, RefuseARegionArrayThatIsNotThere)
{
  CellRun run(TwoSquares());
  run.Mesher->SetRegionArray("material");
  run.Update();
  ASSERT_EQ(run.Errors.size(), 1u);
  EXPECT_NE(run.Errors.front().find("no cell array named material"), std::string::npos);
}

TEST(BitingMesherCells, KeepTheirEdgesOnDemand)
{
  CellRun run(TwoSquares());
  run.Mesher->SetKeepCellEdges(true);
  ExpectQuietArea(run, 2.0, 2);
}

// A rectangle of 6 by 4 with n by n squares within, each two triangles, in the middle.
vtkSmartPointer<vtkUnstructuredGrid> TrianglesInARectangle(int n)
{
  std::vector<Place> places = Rectangle(-3.0, -2.0, 3.0, 2.0);
  const auto pointAt = [n](int i, int j) { return vtkIdType{ 4 } + i + j * (n + 1); };
  for (int j = 0; j <= n; ++j)
  {
    for (int i = 0; i <= n; ++i)
    {
      places.push_back({ double(i) / n - 0.5, double(j) / n - 0.5, 0.0 });
    }
  }
  auto grid = GridWithPoints(places);
  AddCell(grid, VTK_QUAD, { 0, 1, 2, 3 });
  for (int j = 0; j < n; ++j)
  {
    for (int i = 0; i < n; ++i)
    {
      AddCell(grid, VTK_TRIANGLE, { pointAt(i, j), pointAt(i + 1, j), pointAt(i + 1, j + 1) });
      AddCell(grid, VTK_TRIANGLE, { pointAt(i, j), pointAt(i, j + 1), pointAt(i + 1, j + 1) });
    }
  }
  return grid;
}

// Triangles of the mesh whose corners are points of the input but for the first four.
int CountGivenTriangles(vtkPolyData* mesh)
{
  vtkDataArray* originals = mesh->GetPointData()->GetArray("OriginalPointId");
  int count = 0;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    mesh->GetCellPoints(cell, ids);
    bool isGiven = true;
    for (vtkIdType k = 0; k < 3; ++k)
    {
      isGiven = isGiven && originals->GetComponent(ids->GetId(k), 0) >= 4.0;
    }
    count += isGiven ? 1 : 0;
  }
  return count;
}

TEST(BitingMesherCells, ThatAreTrianglesStayAsTheyAreAsOneRegion)
{
  for (const double spacing : { 0.3, 0.04, 1.0 })
  {
    CellRun run(TrianglesInARectangle(20));
    run.Mesher->SetKeepCellEdges(true);
    run.Mesher->SetDomainRuleToUnion();
    run.Mesher->SetUniformSpacing(spacing);
    ExpectQuietArea(run, 24.0, 2);
    vtkPolyData* mesh = run.Mesher->GetOutput();
    EXPECT_EQ(CountGivenTriangles(mesh), 800);
    EXPECT_GT(Figure(mesh, "SmallestAngle"), 25.0) << spacing;
    EXPECT_EQ(run.ValuesOf("Kind"), std::set<std::string>({ "0", "1" }));
  }
}

TEST(BitingMesherCells, ThatAreTrianglesAreAllOfAMeshWhereThereIsNothingElse)
{
  auto grid = GridWithPoints(Rectangle(0.0, 0.0, 1.0, 1.0));
  AddCell(grid, VTK_TRIANGLE, { 0, 1, 2 });
  AddCell(grid, VTK_TRIANGLE, { 0, 3, 2 });
  CellRun run(grid);
  run.Mesher->SetKeepCellEdges(true);
  ExpectQuietArea(run, 1.0, 1);
  EXPECT_EQ(run.Mesher->GetOutput()->GetNumberOfCells(), 2);
  EXPECT_EQ(run.Mesher->GetOutput(1)->GetNumberOfCells(), 4);
  AddValues<vtkIntArray, int>(grid, "material", { 1, 2 });
  CellRun parted(grid);
  parted.Mesher->SetKeepCellEdges(true);
  parted.Mesher->SetRegionArray("material");
  ExpectQuietArea(parted, 1.0, 2);
  EXPECT_EQ(parted.Mesher->GetOutput(1)->GetNumberOfCells(), 5);
}

TEST(BitingMesherCells, ThatAreHiddenOrGhostsAreLeftOut)
{
  auto grid = TwoSquares();
  AddValues<vtkUnsignedCharArray, unsigned char>(
    grid, vtkDataSetAttributes::GhostArrayName(), { 0, vtkDataSetAttributes::DUPLICATECELL });
  ExpectQuietArea(CellRun(grid), 1.0);
}

TEST(BitingMesherCells, GiveTheirTagsToTheOutlineAndLinesOverruleThem)
{
  auto grid = TwoSquares();
  AddCell(grid, VTK_LINE, { 0, 1 });
  AddCell(grid, VTK_LINE, { 1, 4 });
  AddValues<vtkStringArray, std::string>(grid, "tag", { "left", "right", "inflow", "wall" });
  CellRun run(grid);
  ExpectQuietArea(run, 2.0, 2);
  EXPECT_EQ(run.ValuesOf("tag"), std::set<std::string>({ "left", "right", "inflow", "wall" }));
  EXPECT_EQ(run.ValuesOf("OriginalCellId"), std::set<std::string>({ "0", "1", "2", "3" }));
}

TEST(BitingMesherCells, ThatOverlapInPartAreTold)
{
  auto grid = TwoSquares();
  AddCell(grid, VTK_TRIANGLE, { 0, 2, 4 });
  CellRun run(grid);
  run.Update();
  ASSERT_EQ(run.Warnings.size(), 1u);
  EXPECT_NE(run.Warnings.front().find("on top of others"), std::string::npos);
  EXPECT_NEAR(run.Area(), 1.0, 1e-12);
}

TEST(BitingMesherCells, WithAVolumeAreRefusedWithAWayOut)
{
  auto grid = GridWithPoints({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } });
  AddCell(grid, VTK_TRIANGLE, { 0, 1, 2 });
  AddCell(grid, VTK_TETRA, { 0, 1, 2, 3 });
  CellRun run(grid);
  run.Update();
  ASSERT_EQ(run.Errors.size(), 1u);
  for (const char* word : { "Cell 1", "Extract Surface", "Slice", "Feature Edges" })
  {
    EXPECT_NE(run.Errors.front().find(word), std::string::npos) << word;
  }
}

TEST(BitingMesherCells, OfCurvedKindsAreRefusedWithAWayOut)
{
  auto grid = GridWithPoints({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } });
  AddCell(grid, VTK_LAGRANGE_TRIANGLE, { 0, 1, 2 });
  CellRun run(grid);
  run.Update();
  ASSERT_EQ(run.Errors.size(), 1u);
  EXPECT_NE(run.Errors.front().find("Tessellate"), std::string::npos);
}

namespace
{

/// A square of 3, and a hole of 1 in it; with arrays that only one of them has.
vtkSmartPointer<vtkMultiBlockDataSet> SquareAndHole()
{
  auto hole = EmptyInput();
  AddChain(hole, Rectangle(1.0, 1.0, 2.0, 2.0), true);
  AddValues<vtkStringArray, std::string>(hole, "tag", { "hole" });
  auto square = EmptyInput();
  AddChain(square, Rectangle(0.0, 0.0, 3.0, 3.0), true);
  AddValues<vtkIdTypeArray, vtkIdType>(square, "number", { 7 });
  vtkNew<vtkDoubleArray> spacing;
  spacing->SetName("Spacing");
  spacing->SetNumberOfTuples(4);
  spacing->Fill(0.25);
  square->GetPointData()->AddArray(spacing);
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  blocks->SetBlock(0, square);
  blocks->GetMetaData(0u)->Set(vtkCompositeDataSet::NAME(), "outer");
  blocks->SetBlock(2, hole);
  blocks->GetMetaData(2u)->Set(vtkCompositeDataSet::NAME(), "inner");
  return blocks;
}

} // namespace

TEST(BitingMesherBlocks, AreOneDrawing)
{
  CellRun run(SquareAndHole());
  ExpectQuietArea(run, 8.0);
  EXPECT_EQ(run.ValuesOf("BlockName"), std::set<std::string>({ "outer", "inner" }));
  EXPECT_EQ(run.ValuesOf("tag"), std::set<std::string>({ "", "hole" }));
  EXPECT_EQ(run.ValuesOf("number"), std::set<std::string>({ "0", "7" }));
  EXPECT_EQ(run.ValuesOf("OriginalCellId"), std::set<std::string>({ "0", "1" }));
}

TEST(BitingMesherBlocks, OfACollectionAreOneDrawing)
{
  auto blocks = SquareAndHole();
  vtkNew<vtkPartitionedDataSetCollection> collection;
  for (unsigned int k = 0; k < 2; ++k)
  {
    vtkNew<vtkPartitionedDataSet> parts;
    parts->SetPartition(0, vtkDataSet::SafeDownCast(blocks->GetBlock(2 * k)));
    collection->SetPartitionedDataSet(k, parts);
  }
  ExpectQuietArea(CellRun(collection.GetPointer()), 8.0);
}

TEST(BitingMesherBlocks, MayBeMeshedOneByOne)
{
  vtkNew<vtkBitingMesher> mesher;
  mesher->SetUniformSpacing(0.5);
  mesher->MeshBlocksSeparatelyOn();
  mesher->SetInputDataObject(SquareAndHole());
  mesher->Update();
  auto* blocks = vtkMultiBlockDataSet::SafeDownCast(mesher->GetOutputDataObject(0));
  ASSERT_TRUE(blocks);
  EXPECT_NEAR(AreaOf(vtkPolyData::SafeDownCast(blocks->GetBlock(0))), 9.0, 1e-12);
  EXPECT_NEAR(AreaOf(vtkPolyData::SafeDownCast(blocks->GetBlock(2))), 1.0, 1e-12);
  mesher->MeshBlocksSeparatelyOff();
  mesher->Update();
  EXPECT_NEAR(AreaOf(mesher->GetOutput()), 8.0, 1e-12);
}
