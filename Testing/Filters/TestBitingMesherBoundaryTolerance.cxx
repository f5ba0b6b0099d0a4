// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "FilterTesting.h"

#include "vtkMath.h"
#include "vtkOutputWindow.h"
#include "vtkStringArray.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace testing_filters;

namespace
{

constexpr double Spacing = 10.0;

/// Keeps the lines of text that are shown while it lives.
class LineCatcher : public vtkOutputWindow
{
public:
  static LineCatcher* New();
  vtkTypeMacro(LineCatcher, vtkOutputWindow);
  void DisplayText(const char* text) override { this->Text += text; }

  std::string Text;
};
vtkStandardNewMacro(LineCatcher);

std::string LinesOf(vtkBitingMesher* mesher)
{
  const vtkSmartPointer<vtkOutputWindow> before = vtkOutputWindow::GetInstance();
  vtkNew<LineCatcher> catcher;
  vtkOutputWindow::SetInstance(catcher);
  mesher->Update();
  vtkOutputWindow::SetInstance(before);
  return catcher->Text;
}

/// A square of 100 with a wave of one unit on all sides.
std::vector<Place> WavySquare()
{
  std::vector<Place> places;
  const auto wave = [](int k) { return k % 4 == 1 ? 0.5 : k % 4 == 3 ? -0.5 : 0.0; };
  for (int k = 0; k < 100; ++k)
  {
    places.push_back({ static_cast<double>(k), wave(k), 0.0 });
  }
  for (int k = 0; k < 100; ++k)
  {
    places.push_back({ 100.0 + wave(k), static_cast<double>(k), 0.0 });
  }
  for (int k = 0; k < 100; ++k)
  {
    places.push_back({ 100.0 - k, 100.0 + wave(k), 0.0 });
  }
  for (int k = 0; k < 100; ++k)
  {
    places.push_back({ wave(k), 100.0 - k, 0.0 });
  }
  return places;
}

/// With a cell for each segment, and a tag for each run of so many.
vtkSmartPointer<vtkPolyData> TaggedWavySquare(int segmentsOfTag)
{
  auto data = EmptyInput();
  const std::vector<Place> places = WavySquare();
  vtkNew<vtkStringArray> tags;
  tags->SetName("Tag");
  for (std::size_t k = 0; k < places.size(); ++k)
  {
    AddChain(data, { places[k], places[(k + 1) % places.size()] }, false);
    tags->InsertNextValue("tag " + std::to_string(static_cast<int>(k) / segmentsOfTag));
  }
  data->GetCellData()->AddArray(tags);
  return data;
}

vtkSmartPointer<vtkBitingMesher> MesherOf(vtkPolyData* input, double tolerance)
{
  auto mesher = vtkSmartPointer<vtkBitingMesher>::New();
  mesher->SetInputData(input);
  mesher->SetUniformSpacing(Spacing);
  mesher->SetBoundaryTolerance(tolerance);
  return mesher;
}

} // namespace

TEST(BoundaryTolerance, MakesAFineDrawingAnOrdinaryOne)
{
  auto input = EmptyInput();
  AddChain(input, WavySquare(), true);
  const auto mesher = MesherOf(input, 0.2);
  EXPECT_EQ(LinesOf(mesher), "");
  vtkPolyData* mesh = mesher->GetOutput();
  EXPECT_LT(mesh->GetNumberOfPoints(), 1.5 * 1.1547 * 100.0);
  EXPECT_GT(Figure(mesh, "SmallestAngle"), 30.0);
  EXPECT_GT(Figure(mesh, "RemovedVertices"), 300.0);
  EXPECT_NEAR(AreaOf(mesh), 10000.0, 400.0 * 0.2 * Spacing);
}

TEST(BoundaryTolerance, WarnsWhereItChangesTheAreaByMoreThanFivePercent)
{
  std::vector<Place> circle;
  for (int k = 0; k < 64; ++k)
  {
    const double angle = vtkMath::RadiansFromDegrees(360.0 / 64 * k);
    circle.push_back({ 10.0 * std::cos(angle), 10.0 * std::sin(angle), 0.0 });
  }
  auto input = EmptyInput();
  AddChain(input, circle, true);
  for (const double tolerance : { 0.05, 0.5 })
  {
    const auto mesher = MesherOf(input, tolerance);
    const Messages messages(mesher);
    mesher->Update();
    const double change = 100.0 * (AreaOf(mesher->GetOutput()) / 313.65 - 1.0);
    ASSERT_EQ(std::abs(change) > 5.0, tolerance == 0.5);
    ASSERT_EQ(messages.Warnings.size(), tolerance == 0.5 ? 1 : 0);
    if (tolerance == 0.5)
    {
      EXPECT_TRUE(Has(messages.Warnings[0], "Boundary Tolerance changed the area"));
      EXPECT_TRUE(Has(messages.Warnings[0], std::to_string(static_cast<int>(change))));
      EXPECT_TRUE(Has(messages.Warnings[0], "smaller Boundary Tolerance"));
    }
  }
}

TEST(BoundaryTolerance, IsNamedWhereTheDrawingIsMuchFinerThanTheSpacing)
{
  auto input = EmptyInput();
  AddChain(input, WavySquare(), true);
  const auto mesher = MesherOf(input, 0.0);
  const Messages messages(mesher);
  EXPECT_TRUE(Has(LinesOf(mesher), "Boundary Tolerance"));
  EXPECT_TRUE(messages.Warnings.empty() && messages.Errors.empty());
  EXPECT_GT(Figure(mesher->GetOutput(), "ShareOfDrawing"), 0.5);
}

TEST(BoundaryTolerance, IsNotNamedWhereTheUserWantsNoWords)
{
  auto input = EmptyInput();
  AddChain(input, WavySquare(), true);
  const auto mesher = MesherOf(input, 0.0);
  vtkObject::GlobalWarningDisplayOff();
  EXPECT_EQ(LinesOf(mesher), "");
  vtkObject::GlobalWarningDisplayOn();
}

TEST(BoundaryTolerance, KeepsTheVerticesBetweenTags)
{
  const auto input = TaggedWavySquare(37);
  const auto mesher = MesherOf(input, 0.2);
  mesher->Update();
  vtkPolyData* edges = mesher->GetOutput(vtkBitingMesher::BOUNDARY_EDGES);
  auto* tags = vtkStringArray::SafeDownCast(edges->GetCellData()->GetAbstractArray("Tag"));
  auto* cells = edges->GetCellData()->GetArray("OriginalCellId");
  ASSERT_TRUE(tags && cells);
  double total = 0.0;
  std::map<std::string, double> lengths;
  for (vtkIdType edge = 0; edge < edges->GetNumberOfCells(); ++edge)
  {
    const auto cell = static_cast<int>(cells->GetTuple1(edge));
    EXPECT_EQ(tags->GetValue(edge), "tag " + std::to_string(cell / 37));
    vtkNew<vtkIdList> ends;
    edges->GetCellPoints(edge, ends);
    const Place a = PointOf(edges, ends->GetId(0));
    const Place b = PointOf(edges, ends->GetId(1));
    const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
    lengths[tags->GetValue(edge)] += length;
    total += length;
  }
  EXPECT_EQ(lengths.size(), 11u);
  EXPECT_NEAR(total, 400.0, 4.0);
  EXPECT_NEAR(lengths["tag 3"], 37.0, 2.0);
}

TEST(MinimumLoopSize, LeavesSmallLoopsOutAndShowsWhere)
{
  auto input = EmptyInput();
  AddChain(input, Rectangle(0.0, 0.0, 100.0, 100.0), true);
  AddChain(input, Rectangle(50.0, 20.0, 54.0, 26.0), true);
  AddChain(input, Rectangle(20.0, 50.0, 60.0, 60.0), true);
  const auto mesher = MesherOf(input, 0.0);
  mesher->SetMinimumLoopSize(1.0);
  const Messages messages(mesher);
  EXPECT_TRUE(Has(LinesOf(mesher), "Minimum Loop Size (1): cell 1 near (52, 23, 0)"));
  EXPECT_TRUE(messages.Warnings.empty() && messages.Errors.empty());
  EXPECT_NEAR(AreaOf(mesher->GetOutput()), 9600.0, 1e-6);
  EXPECT_EQ(Figure(mesher->GetOutput(), "LeftOutLoops"), 1.0);
  EXPECT_EQ(Figure(mesher->GetOutput(), "LeftOutArea"), 24.0);
  vtkPolyData* problems = mesher->GetOutput(vtkBitingMesher::PROBLEMS);
  ASSERT_EQ(problems->GetNumberOfPoints(), 1);
  EXPECT_EQ(
    problems->GetPointData()->GetArray("ProblemKind")->GetTuple1(0), vtkBitingMesher::SMALL_LOOPS);
  EXPECT_EQ(problems->GetPointData()->GetArray("IsError")->GetTuple1(0), 0.0);
}

TEST(BoundaryTolerance, RefusesWhatIsNoNumberOfSpacings)
{
  for (const double value : { -1.0, std::numeric_limits<double>::quiet_NaN() })
  {
    const auto mesher = MesherOf(UnitSquare(), value);
    const Messages messages(mesher);
    mesher->Update();
    ASSERT_EQ(messages.Errors.size(), 1u);
    EXPECT_TRUE(Has(messages.Errors[0], "Boundary Tolerance"));
  }
}
