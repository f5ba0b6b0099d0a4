// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "MeshChecker.h"
#include "RemesherTesting.h"

#include "vtkFloatArray.h"
#include "vtkStringArray.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <map> // for sums
#include <set> // for edges

using namespace testing_filters;

namespace
{

/// A plate of two regions with a bent interface, tagged: outer sides by four numbers and names, the
/// interface by one.
struct Plate
{
  vtkSmartPointer<vtkPolyData> Mesh;
  vtkSmartPointer<vtkPolyData> Edges;

  Plate()
  {
    auto drawing = EmptyInput();
    AddChain(drawing, { { 0, 0, 0 }, { 2, 0, 0 } }, false);
    AddChain(drawing, { { 2, 0, 0 }, { 2, 1, 0 } }, false);
    AddChain(drawing, { { 2, 1, 0 }, { 0, 1, 0 } }, false);
    AddChain(drawing, { { 0, 1, 0 }, { 0, 0, 0 } }, false);
    AddChain(drawing, { { 0.8, 0, 0 }, { 1.1, 0.4, 0 }, { 0.9, 0.7, 0 }, { 1.2, 1, 0 } }, false);
    AddArray<vtkIntArray>(drawing->GetCellData(), "Tag", { 1.0, 2.0, 3.0, 4.0, 9.0 });
    AddArray<vtkDoubleArray>(drawing->GetCellData(), "Flux", { 0.5, 1.5, 2.5, 3.5, 8.25 });
    vtkNew<vtkStringArray> names;
    names->SetName("Name");
    for (const char* name : { "south", "east", "north", "west", "between" })
    {
      names->InsertNextValue(name);
    }
    drawing->GetCellData()->AddArray(names);
    vtkPolyData* edges = nullptr;
    this->Mesh = Meshed(drawing, &edges);
    this->Edges.TakeReference(edges);
  }
};

double LengthOf(vtkPolyData* edges, vtkIdType cell)
{
  vtkNew<vtkIdList> ends;
  edges->GetCellPoints(cell, ends);
  const Place a = PointOf(edges, ends->GetId(0));
  const Place b = PointOf(edges, ends->GetId(1));
  return std::hypot(a[0] - b[0], a[1] - b[1]);
}

/// Of the edges with all their arrays as text: lengths.
std::map<std::string, double> LengthsByTags(vtkPolyData* edges)
{
  std::map<std::string, double> lengths;
  for (vtkIdType cell = 0; cell < edges->GetNumberOfCells(); ++cell)
  {
    std::string key;
    for (const char* name : { "Tag", "Flux", "Name" })
    {
      key += edges->GetCellData()->GetAbstractArray(name)->GetVariantValue(cell).ToString() + " ";
    }
    lengths[key] += LengthOf(edges, cell);
  }
  return lengths;
}

std::map<double, double> AreasOfRegions(vtkPolyData* mesh)
{
  std::map<double, double> areas;
  vtkDataArray* regions = mesh->GetCellData()->GetArray("RegionId");
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    vtkNew<vtkIdList> ids;
    mesh->GetCellPoints(cell, ids);
    const Place a = PointOf(mesh, ids->GetId(0));
    const Place b = PointOf(mesh, ids->GetId(1));
    const Place c = PointOf(mesh, ids->GetId(2));
    areas[regions->GetComponent(cell, 0)] +=
      0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
  }
  return areas;
}

} // namespace

TEST(BitingRemesher, TransfersRealArraysLinearlyAndOthersFromTheNearest)
{
  const auto mesh = Wanting(SquareMesh(), Half);
  AddField(mesh, "Linear", Linear);
  vtkNew<vtkIntArray> numbers;
  numbers->SetName("Number");
  vtkNew<vtkStringArray> texts;
  texts->SetName("Text");
  for (vtkIdType point = 0; point < mesh->GetNumberOfPoints(); ++point)
  {
    numbers->InsertNextValue(static_cast<int>(1000 * (point % 7)));
    texts->InsertNextValue("p" + std::to_string(point));
  }
  mesh->GetPointData()->AddArray(numbers);
  mesh->GetPointData()->AddArray(texts);
  vtkNew<vtkFloatArray> ofCells;
  ofCells->SetName("OfCells");
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    ofCells->InsertNextValue(static_cast<float>(cell));
  }
  mesh->GetCellData()->AddArray(ofCells);
  const auto remesher = RemesherOf(mesh);
  remesher->Update();
  vtkPolyData* output = remesher->GetOutput();
  vtkDataArray* linear = output->GetPointData()->GetArray("Linear");
  vtkDataArray* number = output->GetPointData()->GetArray("Number");
  vtkAbstractArray* text = output->GetPointData()->GetAbstractArray("Text");
  ASSERT_TRUE(linear && number && text && output->GetCellData()->HasArray("OfCells"));
  for (vtkIdType point = 0; point < output->GetNumberOfPoints(); ++point)
  {
    EXPECT_NEAR(linear->GetComponent(point, 0), Linear(PointOf(output, point)), 1e-12);
    EXPECT_EQ(static_cast<int>(number->GetComponent(point, 0)) % 1000, 0);
    EXPECT_TRUE(Has(text->GetVariantValue(point).ToString(), "p"));
  }
  remesher->TransferDataOff();
  remesher->Update();
  EXPECT_FALSE(remesher->GetOutput()->GetPointData()->HasArray("Linear"));
}

TEST(BitingRemesher, KeepsTagsOfLinesThatAreConnected)
{
  auto drawing = EmptyInput();
  AddChain(drawing, Rectangle(0.0, 0.0, 1.0, 1.0), true);
  AddChain(drawing, { { 0.3, 0.4, 0.0 }, { 0.7, 0.4, 0.0 } }, false);
  AddArray<vtkIntArray>(drawing->GetCellData(), "Tag", { 5.0, 9.0 });
  vtkPolyData* edges = nullptr;
  const auto mesh = Wanting(Meshed(drawing, &edges), Half);
  const auto remesher = RemesherOf(mesh);
  remesher->SetTaggedLinesData(edges);
  edges->UnRegister(nullptr);
  remesher->Update();
  vtkPolyData* output = remesher->GetOutput(1);
  vtkDataArray* tags = output->GetCellData()->GetArray("Tag");
  ASSERT_TRUE(tags);
  double length = 0.0;
  for (vtkIdType cell = 0; cell < output->GetNumberOfCells(); ++cell)
  {
    vtkNew<vtkIdList> ends;
    output->GetCellPoints(cell, ends);
    const Place a = PointOf(output, ends->GetId(0));
    const Place b = PointOf(output, ends->GetId(1));
    const bool isInner = a[1] == 0.4 && b[1] == 0.4;
    EXPECT_EQ(tags->GetComponent(cell, 0), isInner ? 9.0 : 5.0);
    length += isInner ? std::abs(a[0] - b[0]) : 0.0;
  }
  EXPECT_NEAR(length, 0.4, 1e-12);
  EXPECT_GT(output->GetNumberOfCells(), 150);
}

TEST(BitingRemesher, KeepsRegionsExactly)
{
  auto drawing = EmptyInput();
  AddChain(drawing, Rectangle(0.0, 0.0, 1.0, 1.0), true);
  AddChain(drawing, { { 0.0, 0.3, 0.0 }, { 1.0, 0.6, 0.0 } }, false);
  const auto mesh = Meshed(drawing);
  for (const double spacing : { 0.02, 0.11 })
  {
    const auto remesher = RemesherOf(mesh);
    remesher->SetUniformSpacing(spacing);
    remesher->Update();
    vtkPolyData* output = remesher->GetOutput();
    vtkDataArray* regions = output->GetCellData()->GetArray("RegionId");
    ASSERT_TRUE(regions);
    for (vtkIdType cell = 0; cell < output->GetNumberOfCells(); ++cell)
    {
      vtkNew<vtkIdList> corners;
      output->GetCellPoints(cell, corners);
      Place middle{ 0.0, 0.0, 0.0 };
      for (const vtkIdType corner : *corners)
      {
        middle[0] += PointOf(output, corner)[0] / 3.0;
        middle[1] += PointOf(output, corner)[1] / 3.0;
      }
      const bool isBelow = middle[1] < 0.3 + 0.3 * middle[0];
      EXPECT_EQ(regions->GetComponent(cell, 0), isBelow ? 0.0 : 1.0);
    }
  }
}

TEST(BitingRemesher, LeavesWhatIsFrozen)
{
  const auto mesh = Wanting(SquareMesh(), Half);
  AddField(mesh, "Stays", [](const Place& place) { return place[0] < 0.5 ? 1.0 : 0.0; });
  vtkNew<vtkIntArray> cells;
  cells->SetName("Stays");
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    cells->InsertNextValue(cell < 200 ? 1 : 0);
  }
  mesh->GetCellData()->AddArray(cells);
  const auto remesher = RemesherOf(mesh);
  remesher->SetFrozenArray("Stays");
  remesher->Update();
  vtkDataArray* originals = remesher->GetOutput()->GetCellData()->GetArray("OriginalCellId");
  for (int cell = 0; cell < 200; ++cell)
  {
    EXPECT_EQ(originals->GetComponent(cell, 0), cell);
  }
}

TEST(BitingRemesher, BringsInterfaceTagsAndAreasOfAPlateThrough)
{
  const Plate plate;
  const auto lengths = LengthsByTags(plate.Edges);
  const auto areas = AreasOfRegions(plate.Mesh);
  ASSERT_EQ(lengths.size(), 5u);
  ASSERT_EQ(areas.size(), 2u);
  for (const double spacing : { 0.02, 0.04, 0.1, 0.25 })
  {
    const auto remesher = RemesherOf(plate.Mesh);
    remesher->SetTaggedLinesData(plate.Edges);
    remesher->SetUniformSpacing(spacing);
    remesher->Update();
    const auto after = LengthsByTags(remesher->GetOutput(1));
    ASSERT_EQ(after.size(), lengths.size());
    for (const auto& [tags, length] : lengths)
    {
      EXPECT_NEAR(after.at(tags), length, 1e-12) << tags;
    }
    for (const auto& [region, area] : AreasOfRegions(remesher->GetOutput()))
    {
      EXPECT_NEAR(area, areas.at(region), 1e-12);
    }
  }
}

TEST(BitingRemesher, KeepsTaggedEdgesThatAreFrozen)
{
  const Plate plate;
  vtkNew<vtkIntArray> stays;
  stays->SetName("Stays");
  std::set<std::pair<Place, Place>> frozen;
  vtkDataArray* tags = plate.Edges->GetCellData()->GetArray("Tag");
  vtkNew<vtkIdList> ends;
  const auto edgeOf = [&ends](vtkPolyData* edges, vtkIdType cell)
  {
    edges->GetCellPoints(cell, ends);
    const Place a = PointOf(edges, ends->GetId(0));
    const Place b = PointOf(edges, ends->GetId(1));
    return std::make_pair(std::min(a, b), std::max(a, b));
  };
  for (vtkIdType cell = 0; cell < plate.Edges->GetNumberOfCells(); ++cell)
  {
    const bool isFrozen = tags->GetComponent(cell, 0) == 2.0 || tags->GetComponent(cell, 0) == 9.0;
    stays->InsertNextValue(isFrozen ? 1 : 0);
    if (isFrozen)
    {
      frozen.insert(edgeOf(plate.Edges, cell));
    }
  }
  plate.Edges->GetCellData()->AddArray(stays);
  for (const double spacing : { 0.02, 0.1 })
  {
    const auto remesher = RemesherOf(plate.Mesh);
    remesher->SetTaggedLinesData(plate.Edges);
    remesher->SetFrozenArray("Stays");
    remesher->SetUniformSpacing(spacing);
    remesher->SetBoundaryTolerance(spacing > 0.05 ? 0.2 : 0.0);
    remesher->Update();
    vtkPolyData* edges = remesher->GetOutput(1);
    std::set<std::pair<Place, Place>> found;
    vtkDataArray* after = edges->GetCellData()->GetArray("Tag");
    ASSERT_TRUE(after);
    for (vtkIdType cell = 0; cell < edges->GetNumberOfCells(); ++cell)
    {
      if (after->GetComponent(cell, 0) == 2.0 || after->GetComponent(cell, 0) == 9.0)
      {
        found.insert(edgeOf(edges, cell));
      }
    }
    EXPECT_EQ(found, frozen);
    EXPECT_EQ(MeshChecker(remesher->GetOutput()).CheckValidity(), "");
  }
}

TEST(BitingRemesher, LeavesPointsThatAreFrozen)
{
  const auto mesh = SquareMesh();
  AddField(mesh, "Stays", [](const Place& place) { return place[0] < 0.5 ? 1.0 : 0.0; });
  const auto remesher = RemesherOf(mesh);
  remesher->SetFrozenArray("Stays");
  remesher->SetUniformSpacing(3.0 * Spacing);
  remesher->Update();
  std::set<double> originals;
  vtkDataArray* ids = remesher->GetOutput()->GetPointData()->GetArray("OriginalPointId");
  for (vtkIdType point = 0; point < ids->GetNumberOfTuples(); ++point)
  {
    originals.insert(ids->GetComponent(point, 0));
  }
  for (vtkIdType point = 0; point < mesh->GetNumberOfPoints(); ++point)
  {
    EXPECT_TRUE(PointOf(mesh, point)[0] >= 0.5 || originals.count(static_cast<double>(point)) == 1);
  }
}

/// The nearest points of a place beside a slit lie across it: old triangles do not.
TEST(BitingRemesher, DataDoesNotLeakAcrossASlit)
{
  auto drawing = EmptyInput();
  AddChain(drawing, Rectangle(0.0, 0.0, 1.0, 1.0), true);
  AddChain(drawing, Rectangle(0.49, 0.1, 0.51, 0.9), true);
  const auto mesh = Wanting(Meshed(drawing), Half);
  const auto side = [](const Place& place) {
    return place[1] < 0.1 || place[1] > 0.9 ? 0.5 : place[0] < 0.5 ? 0.0 : 1.0;
  };
  AddField(mesh, "Side", side);
  const auto remesher = RemesherOf(mesh);
  remesher->Update();
  vtkPolyData* output = remesher->GetOutput();
  vtkDataArray* values = output->GetPointData()->GetArray("Side");
  for (vtkIdType point = 0; point < output->GetNumberOfPoints(); ++point)
  {
    const Place place = PointOf(output, point);
    const bool isBeside = place[1] > 0.2 && place[1] < 0.8;
    EXPECT_TRUE(!isBeside || std::abs(values->GetComponent(point, 0) - side(place)) < 1e-12);
  }
}

TEST(BitingRemesher, PassesAnUnstructuredGridWithLinesThrough)
{
  const Plate plate;
  vtkNew<vtkUnstructuredGrid> grid;
  grid->SetPoints(plate.Mesh->GetPoints());
  grid->Allocate();
  vtkNew<vtkIdList> ids;
  vtkNew<vtkStringArray> names;
  names->SetName("Name");
  for (vtkPolyData* part : { plate.Edges.Get(), plate.Mesh.Get() })
  {
    for (vtkIdType cell = 0; cell < part->GetNumberOfCells(); ++cell)
    {
      part->GetCellPoints(cell, ids);
      for (vtkIdType& id : *ids)
      {
        Place place = PointOf(part, id);
        id = plate.Mesh->FindPoint(place.data());
      }
      grid->InsertNextCell(part == plate.Edges ? VTK_LINE : VTK_TRIANGLE, ids);
      names->InsertNextValue("cell " + std::to_string(names->GetNumberOfValues()));
    }
  }
  grid->GetCellData()->AddArray(names);
  grid->GetPointData()->ShallowCopy(plate.Mesh->GetPointData());
  const auto remesher = RemesherOf(grid);
  remesher->SetUniformSpacing(Spacing);
  remesher->LimitByFeatureSizeOff();
  remesher->Update();
  vtkPolyData* output = remesher->GetOutput();
  EXPECT_EQ(Figure(output, "NewVertices"), 0.0);
  EXPECT_EQ(output->GetNumberOfPolys(), plate.Mesh->GetNumberOfPolys());
  EXPECT_TRUE(output->GetCellData()->HasArray("Name"));
  EXPECT_EQ(remesher->GetOutput(1)->GetNumberOfLines(), plate.Edges->GetNumberOfLines());
}

/// An outline of segments a sixteenth as long as the spacing, whose notches are as narrow.
TEST(BitingRemesher, CoarseningGivesNoMoreVerticesThanThereWere)
{
  std::vector<Place> outline{ { 0.0, 0.0, 0.0 }, { 0.5, 0.0, 0.0 }, { 0.25, -0.4330127, 0.0 } };
  for (int level = 0; level < 4; ++level)
  {
    std::vector<Place> finer;
    for (std::size_t k = 0; k < outline.size(); ++k)
    {
      const Place& a = outline[k];
      const Place& b = outline[(k + 1) % outline.size()];
      const double x = (b[0] - a[0]) / 3.0;
      const double y = (b[1] - a[1]) / 3.0;
      finer.insert(finer.end(),
        { a, { a[0] + x, a[1] + y, 0.0 },
          { a[0] + 1.5 * x - 0.8660254 * y, a[1] + 1.5 * y + 0.8660254 * x, 0.0 },
          { a[0] + 2.0 * x, a[1] + 2.0 * y, 0.0 } });
    }
    outline = finer;
  }
  auto drawing = EmptyInput();
  AddChain(drawing, outline, true);
  const auto mesh = Meshed(drawing);
  const auto remesher = RemesherOf(mesh);
  remesher->SetSpacingScale(2.0);
  remesher->Update();
  EXPECT_GT(remesher->GetOutput()->GetNumberOfPoints(), 768);
  EXPECT_LE(remesher->GetOutput()->GetNumberOfPoints(), mesh->GetNumberOfPoints());
}
