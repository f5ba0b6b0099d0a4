// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

// The control spacing through the filter: limit by local feature size, and by gradation.

#include "FilterTesting.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"

#include <gtest/gtest.h>

#include <algorithm> // for min, max

using namespace testing_filters;

namespace
{

// A square of side 1 with a channel 0.02 wide and 1 long at its right side.
vtkSmartPointer<vtkPolyData> SquareWithChannel()
{
  auto data = EmptyInput();
  AddChain(data,
    { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 0.5, 0 }, { 2, 0.5, 0 }, { 2, 0.52, 0 }, { 1, 0.52, 0 },
      { 1, 1, 0 }, { 0, 1, 0 } },
    true);
  return data;
}

vtkSmartPointer<vtkBitingMesher> ChannelMesher(bool isLimited)
{
  auto mesher = vtkSmartPointer<vtkBitingMesher>::New();
  mesher->SetInputData(SquareWithChannel());
  mesher->SetUniformSpacing(0.05);
  mesher->SetLimitByFeatureSize(isLimited);
  mesher->Update();
  return mesher;
}

// Vertices within the channel, off its walls, where x is between 1.2 and 1.8.
int VerticesAmidTheChannel(vtkBitingMesher* mesher)
{
  int count = 0;
  vtkPolyData* mesh = mesher->GetOutput();
  for (vtkIdType point = 0; point < mesh->GetNumberOfPoints(); ++point)
  {
    const double* place = mesh->GetPoint(point);
    count += place[0] > 1.2 && place[0] < 1.8 && place[1] > 0.502 && place[1] < 0.518 ? 1 : 0;
  }
  return count;
}

double LeastSpacing(vtkBitingMesher* mesher)
{
  double range[2];
  mesher->GetOutput()->GetPointData()->GetArray("Spacing")->GetRange(range);
  return range[0];
}

double MeanMinimumAngle(vtkBitingMesher* mesher)
{
  vtkDataArray* angles = mesher->GetOutput()->GetCellData()->GetArray("MinimumAngle");
  double sum = 0.0;
  for (vtkIdType cell = 0; cell < angles->GetNumberOfTuples(); ++cell)
  {
    sum += angles->GetComponent(cell, 0);
  }
  return sum / static_cast<double>(angles->GetNumberOfTuples());
}

// 101 x 101 points over the unit square: 0.2, and 0.01 in the middle.
vtkSmartPointer<vtkImageData> JumpImage()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(101, 101, 1);
  image->SetSpacing(0.01, 0.01, 1.0);
  std::vector<double> values;
  for (vtkIdType point = 0; point < image->GetNumberOfPoints(); ++point)
  {
    Place place;
    image->GetPoint(point, place.data());
    values.push_back(std::hypot(place[0] - 0.5, place[1] - 0.5) < 0.2 ? 0.01 : 0.2);
  }
  AddArray<vtkDoubleArray>(image->GetPointData(), "Spacing", values);
  return image;
}

double LargestSlope(vtkBitingMesher* mesher)
{
  return mesher->GetOutput()->GetFieldData()->GetArray("UsedLipschitz")->GetComponent(0, 0);
}

} // namespace

// The channel is 0.02 wide: n rows of triangles have n - 1 rows of vertices between them.
TEST(BitingMesherControlSpacing, CellsAcrossAreRowsOfTrianglesInAChannel)
{
  auto mesher = ChannelMesher(true);
  EXPECT_EQ(mesher->GetCellsAcross(), 1);
  EXPECT_EQ(VerticesAmidTheChannel(mesher), 0);
  mesher->SetMinimumSpacing(1e-3);
  for (const int count : { 2, 4 })
  {
    mesher->SetCellsAcross(count);
    mesher->Update();
    const double aRow = 0.6 / (0.02 / count);
    EXPECT_GE(VerticesAmidTheChannel(mesher), 0.8 * aRow * (count - 1)) << count;
    EXPECT_LE(LeastSpacing(mesher), 0.02 / count * (1.0 + 1e-12));
  }
  mesher->SetMinimumSpacing(0.0);
  mesher->Update();
  EXPECT_GE(LeastSpacing(mesher), 0.25 * 0.05 * (1.0 - 1e-12)); // a quarter of what is given
  mesher->SetCellsAcross(0);
  EXPECT_EQ(mesher->GetCellsAcross(), 1);
}

TEST(BitingMesherControlSpacing, IsAsNarrowAsAChannel)
{
  const auto mesher = ChannelMesher(true);
  EXPECT_NEAR(LeastSpacing(mesher), 0.02, 0.0002);
  EXPECT_LT(LargestSlope(mesher), 0.31);
}

TEST(BitingMesherControlSpacing, MakesBetterTrianglesInAChannel)
{
  const auto limited = ChannelMesher(true);
  const auto plain = ChannelMesher(false);
  EXPECT_GT(MeanMinimumAngle(limited), MeanMinimumAngle(plain));
  EXPECT_LT(limited->GetOutput()->GetNumberOfPoints(), 3 * plain->GetOutput()->GetNumberOfPoints());
}

TEST(BitingMesherControlSpacing, IsAsGivenWhereTheLimitIsOff)
{
  EXPECT_EQ(LeastSpacing(ChannelMesher(false)), 0.05);
}

TEST(BitingMesherControlSpacing, IsNotBelowAQuarterOfWhatIsGiven)
{
  const auto mesher = ChannelMesher(true);
  mesher->SetUniformSpacing(0.2);
  mesher->Update();
  vtkDataArray* spacing = mesher->GetOutput()->GetPointData()->GetArray("Spacing");
  int count = 0;
  for (vtkIdType point = 0; point < spacing->GetNumberOfTuples(); ++point)
  {
    const Place place = PointOf(mesher->GetOutput(), point);
    if (place[0] > 1.3 && place[0] < 1.7)
    {
      EXPECT_NEAR(spacing->GetComponent(point, 0), 0.05, 0.0005);
      ++count;
    }
  }
  EXPECT_GT(count, 10);
}

TEST(BitingMesherControlSpacing, IsAtMostOnePointFourLengthsOfAShortSegment)
{
  const auto mesher = ChannelMesher(true);
  mesher->SetUniformSpacing(0.5);
  mesher->Update();
  EXPECT_NEAR(LeastSpacing(mesher), 1.4 * 0.02, 0.0003);
}

TEST(BitingMesherControlSpacing, IsOffWhereTheBoundaryIsPreserved)
{
  const auto mesher = ChannelMesher(true);
  mesher->PreserveBoundaryOn();
  mesher->Update();
  const vtkIdType count = mesher->GetOutput()->GetNumberOfPoints();
  mesher->LimitByFeatureSizeOff();
  mesher->Update();
  EXPECT_EQ(mesher->GetOutput()->GetNumberOfPoints(), count);
}

TEST(BitingMesherControlSpacing, GrowsByTheGradationAroundAJump)
{
  vtkNew<vtkBitingMesher> mesher;
  mesher->SetInputData(UnitSquare());
  mesher->SetSpacingSourceData(JumpImage());
  mesher->Update();
  EXPECT_LT(LargestSlope(mesher), 0.33);
  vtkDataArray* spacing = mesher->GetOutput()->GetPointData()->GetArray("Spacing");
  for (vtkIdType point = 0; point < spacing->GetNumberOfTuples(); ++point)
  {
    const Place place = PointOf(mesher->GetOutput(), point);
    const double beyond = std::max(0.0, std::hypot(place[0] - 0.5, place[1] - 0.5) - 0.2);
    ASSERT_GE(spacing->GetComponent(point, 0), 0.95 * std::min(0.01 + 0.3 * beyond, 0.2));
    ASSERT_LE(spacing->GetComponent(point, 0), 1.05 * (0.01 + 0.3 * (beyond + 0.0142)));
  }
}

TEST(BitingMesherControlSpacing, IsAsGivenWithAGradationOfZero)
{
  vtkNew<vtkBitingMesher> mesher;
  mesher->SetInputData(UnitSquare());
  mesher->SetSpacingSourceData(JumpImage());
  mesher->SetGradation(0.0);
  mesher->Update();
  EXPECT_GT(LargestSlope(mesher), 1.0);
}
