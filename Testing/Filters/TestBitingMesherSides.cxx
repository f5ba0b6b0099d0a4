// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

// Sides that belong together: those of a periodic cell, and those of a crack.

#include "FilterTesting.h"
#include "MeshChecker.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkErrorCode.h"

#include <gtest/gtest.h>

#include <algorithm> // for max, min
#include <map>       // for places

using namespace testing_filters;

namespace
{

vtkSmartPointer<vtkBitingMesher> MesherOf(vtkPolyData* drawing, double spacing)
{
  auto mesher = vtkSmartPointer<vtkBitingMesher>::New();
  mesher->SetInputData(drawing);
  mesher->SetUniformSpacing(spacing);
  return mesher;
}

// How many points have a partner; those that are off by more than rounding are failures.
int CountPartners(vtkPolyData* mesh, const char* name, const Place& vector)
{
  vtkDataArray* partners = mesh->GetPointData()->GetArray(name);
  int count = 0;
  for (vtkIdType point = 0; partners && point < mesh->GetNumberOfPoints(); ++point)
  {
    const auto partner = static_cast<vtkIdType>(partners->GetComponent(point, 0));
    if (partner < 0)
    {
      continue;
    }
    ++count;
    EXPECT_EQ(partners->GetComponent(partner, 0), static_cast<double>(point));
    const Place a = PointOf(mesh, point);
    const Place b = PointOf(mesh, partner);
    const double sign = (b[0] - a[0]) * vector[0] + (b[1] - a[1]) * vector[1] > 0.0 ? 1.0 : -1.0;
    EXPECT_NEAR(b[0] - a[0], sign * vector[0], 4e-16);
    EXPECT_NEAR(b[1] - a[1], sign * vector[1], 4e-16);
  }
  return count;
}

// Points whose first coordinate is x.
int CountPointsAt(vtkPolyData* mesh, double x)
{
  int count = 0;
  for (vtkIdType point = 0; point < mesh->GetNumberOfPoints(); ++point)
  {
    count += PointOf(mesh, point)[0] == x ? 1 : 0;
  }
  return count;
}

vtkSmartPointer<vtkBitingMesher> RunPeriodic(
  vtkPolyData* drawing, double spacing, double x, double y = 0.0)
{
  auto mesher = MesherOf(drawing, spacing);
  mesher->SetPeriodicTranslation(x, 0.0, 0.0);
  mesher->SetPeriodicTranslation2(0.0, y, 0.0);
  return mesher;
}

// Half of a circle about (x, 0.5), on the right of its centre for a positive radius.
std::vector<Place> HalfCircle(double x, double radius)
{
  std::vector<Place> places;
  for (int k = 0; k <= 12; ++k)
  {
    const double angle = (k / 12.0 - 0.5) * 3.14159265358979324;
    const double out = k == 0 || k == 12 ? 0.0 : radius * std::cos(angle);
    places.push_back({ x + out, 0.5 + std::abs(radius) * std::sin(angle), 0.0 });
  }
  return places;
}

// Three polylines, told by the cell array Crack: the outline, and two lines that open.
vtkSmartPointer<vtkBitingMesher> CrackMesher(
  const std::vector<Place>& first, const std::vector<Place>& second)
{
  auto drawing = UnitSquare();
  AddChain(drawing, first, false);
  AddChain(drawing, second, false);
  AddArray<vtkDoubleArray>(drawing->GetCellData(), "Crack", { 0.0, 1.0, 2.0 });
  return MesherOf(drawing, 0.1);
}

// How many places have so many points.
std::map<int, int> CountCopies(vtkPolyData* mesh)
{
  std::map<Place, int> copies;
  for (vtkIdType point = 0; point < mesh->GetNumberOfPoints(); ++point)
  {
    ++copies[PointOf(mesh, point)];
  }
  std::map<int, int> counts;
  for (const auto& [place, count] : copies)
  {
    ++counts[count];
  }
  return counts;
}

int CountInterfaceEdges(vtkBitingMesher* mesher)
{
  vtkDataArray* kinds = mesher->GetOutput(1)->GetCellData()->GetArray("Kind");
  int count = 0;
  for (vtkIdType edge = 0; edge < kinds->GetNumberOfTuples(); ++edge)
  {
    count += kinds->GetComponent(edge, 0) == 1.0 ? 1 : 0;
  }
  return count;
}

} // namespace

TEST(PeriodicSides, OfACellHavePartnersAlongEachVector)
{
  auto mesher = RunPeriodic(UnitSquare(), 0.05, 1.0, 1.0);
  Messages messages(mesher);
  mesher->Update();
  EXPECT_TRUE(messages.Errors.empty() && messages.Warnings.empty());
  vtkPolyData* mesh = mesher->GetOutput();
  EXPECT_EQ(MeshChecker(mesh).CheckValidity(), "");
  EXPECT_EQ(CountPartners(mesh, "PeriodicPartner", { 1, 0, 0 }), 42);
  EXPECT_EQ(CountPartners(mesh, "PeriodicPartner2", { 0, 1, 0 }), 42);
  EXPECT_GT(Figure(mesh, "SmallestAngle"), 30.0);
}

TEST(PeriodicSides, AreCrossedByAnInclusion)
{
  auto drawing = UnitSquare();
  AddChain(drawing, HalfCircle(0.0, 0.25), false);
  AddChain(drawing, HalfCircle(1.0, -0.25), false);
  auto mesher = RunPeriodic(drawing, 0.04, 1.0);
  mesher->Update();
  vtkPolyData* mesh = mesher->GetOutput();
  EXPECT_EQ(CountPartners(mesh, "PeriodicPartner", { 1, 0, 0 }), 2 * CountPointsAt(mesh, 0.0));
  EXPECT_EQ(CountPointsAt(mesh, 0.0), CountPointsAt(mesh, 1.0));
  EXPECT_TRUE(MeshChecker(mesh).HasVertex({ 1.0, 0.75 }));
  EXPECT_EQ(mesh->GetPointData()->GetArray("PeriodicPartner2"), nullptr);
}

TEST(PeriodicSides, HaveTheLowerSpacingOfBothAndAVertexWhereALineEndsAtOne)
{
  auto drawing = UnitSquare();
  AddChain(drawing, HalfCircle(0.0, 0.25), false);
  AddChain(drawing, Rectangle(0.97, 0.1, 0.98, 0.11), true);
  auto mesher = RunPeriodic(drawing, 0.1, 1.0);
  mesher->Update();
  vtkPolyData* mesh = mesher->GetOutput();
  EXPECT_TRUE(MeshChecker(mesh).HasVertex({ 1.0, 0.75 }));
  const int count = CountPointsAt(mesh, 0.0);
  EXPECT_EQ(count, CountPointsAt(mesh, 1.0));
  EXPECT_GT(count, 15); // 11 by the spacing, 2 where the circle ends
  EXPECT_EQ(CountPartners(mesh, "PeriodicPartner", { 1, 0, 0 }), 2 * count);
}

TEST(PeriodicSides, AreRefusedWithPlacesWhereTheyDoNotMatch)
{
  auto beside = EmptyInput();
  AddChain(beside, { { 0, 0, 0 }, { 1, 0, 0 }, { 1.005, 0.5, 0 }, { 1, 1, 0 }, { 0, 1, 0 } }, true);
  auto inPart = EmptyInput();
  AddChain(inPart, { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 0.5, 0 }, { 0.5, 1, 0 }, { 0, 1, 0 } }, true);
  const std::map<std::string, vtkPolyData*> cases{ { "beside cell 0", beside.Get() },
    { "only a part of it", inPart.Get() } };
  for (const auto& [words, drawing] : cases)
  {
    auto mesher = RunPeriodic(drawing, 0.1, 1.0);
    Messages messages(mesher);
    mesher->Update();
    ASSERT_EQ(messages.Errors.size(), 1u) << words;
    EXPECT_TRUE(Has(messages.Errors.front(), words)) << messages.Errors.front();
    EXPECT_TRUE(AreAllEmpty(mesher));
    vtkPolyData* problems = mesher->GetOutput(3);
    ASSERT_GT(problems->GetNumberOfPoints(), 0);
    EXPECT_EQ(problems->GetPointData()->GetArray("ProblemKind")->GetComponent(0, 0),
      vtkBitingMesher::UNMATCHED_SIDES);
  }
  for (const Place& vector : { Place{ 2, 0, 0 }, Place{ 1, 0, 1 } })
  {
    auto mesher = MesherOf(UnitSquare(), 0.1);
    mesher->SetPeriodicTranslation(vector.data());
    Messages messages(mesher);
    mesher->Update();
    EXPECT_EQ(messages.Errors.size(), 1u);
    EXPECT_EQ(mesher->GetErrorCode(), vtkErrorCode::UserError);
  }
}

TEST(PeriodicSides, StayAlikeInBlocks)
{
  auto mesher = RunPeriodic(UnitSquare(), 0.02, 1.0, 1.0);
  mesher->SetVerticesPerBlock(500);
  mesher->Update();
  EXPECT_EQ(MeshChecker(mesher->GetOutput()).CheckValidity(), "");
  EXPECT_EQ(CountPartners(mesher->GetOutput(), "PeriodicPartner", { 1, 0, 0 }), 102);
}

TEST(Cracks, DoubleTheirPointsButForTheEnds)
{
  const std::vector<Place> along{ { 0.2, 0.5, 0 }, { 0.8, 0.5, 0 } };
  const std::vector<Place> fromSide{ { 0.0, 0.2, 0 }, { 0.4, 0.2, 0 } };
  auto closed = CrackMesher(along, fromSide);
  closed->Update();
  auto mesher = CrackMesher(along, fromSide);
  mesher->SetSplitInterfaces("Crack");
  Messages messages(mesher);
  mesher->Update();
  EXPECT_TRUE(messages.Errors.empty() && messages.Warnings.empty());
  vtkPolyData* mesh = mesher->GetOutput();
  // 6 edges with 5 points between, 4 with 4 that open.
  EXPECT_EQ(CountCopies(mesh)[2], 9);
  EXPECT_EQ(CountInterfaceEdges(mesher), 2 * CountInterfaceEdges(closed));
  EXPECT_EQ(mesh->GetNumberOfPoints(), closed->GetOutput()->GetNumberOfPoints() + 9);
  EXPECT_EQ(Figure(mesh, "NumberOfVertices"), static_cast<double>(mesh->GetNumberOfPoints()));
  EXPECT_EQ(MeshChecker(mesh).CheckValidity(MeshChecker::Coinciding::Allowed), "");
}

TEST(Cracks, ThatMeetLeaveAPointForEachSector)
{
  auto mesher = CrackMesher({ { 0.2, 0.5, 0 }, { 0.5, 0.5, 0 }, { 0.8, 0.5, 0 } },
    { { 0.5, 0.2, 0 }, { 0.5, 0.5, 0 }, { 0.5, 0.8, 0 } });
  mesher->SetSplitInterfaces("Crack");
  mesher->Update();
  const auto copies = CountCopies(mesher->GetOutput());
  EXPECT_EQ(copies.at(4), 1);
  EXPECT_EQ(copies.at(2), 8);
  auto unknown =
    CrackMesher({ { 0.2, 0.5, 0 }, { 0.8, 0.5, 0 } }, { { 0, 0.2, 0 }, { 0.4, 0.2, 0 } });
  unknown->SetSplitInterfaces("Crevice");
  Messages messages(unknown);
  unknown->Update();
  ASSERT_EQ(messages.Errors.size(), 1u);
  EXPECT_TRUE(Has(messages.Errors.front(), "Crevice"));
}

// Points of two pieces that a crack parts are on one of them each.
TEST(Cracks, FromSideToSidePartTheMesh)
{
  auto mesher = CrackMesher({ { 0, 0.4, 0 }, { 1, 0.6, 0 } }, { { 0, 0.2, 0 }, { 1, 0.2, 0 } });
  mesher->SetSplitInterfaces("Crack");
  mesher->Update();
  vtkPolyData* mesh = mesher->GetOutput();
  std::vector<int> regions(static_cast<std::size_t>(mesh->GetNumberOfPoints()), -1);
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    const double value = mesh->GetCellData()->GetArray("RegionId")->GetComponent(cell, 0);
    mesh->GetCellPoints(cell, ids);
    for (vtkIdType k = 0; k < 3; ++k)
    {
      int& region = regions[static_cast<std::size_t>(ids->GetId(k))];
      ASSERT_TRUE(region == -1 || region == static_cast<int>(value));
      region = static_cast<int>(value);
    }
  }
  EXPECT_EQ(*std::max_element(regions.begin(), regions.end()), 2);
}
