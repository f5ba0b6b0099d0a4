// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Hessian/HessianRecovery.h"

#include "../Spacing/SpacingSources.h"

#include <gtest/gtest.h>

#include <limits> // for infinity

namespace
{

using biting::CellsView;
using biting::Hessian2;
using biting::Id;
using biting::NumericalSpacing;
using biting::Point2;
using biting::RecoverHessians;
using biting::Sampler;
using biting::SilentMonitor;
using biting::SpectralNorm;

// Points and cells of any number of corners.
struct Cells
{
  std::vector<Point2> Points;
  std::vector<Id> Offsets{ 0 };
  std::vector<Id> Corners;

  void Add(const std::vector<Id>& corners)
  {
    this->Corners.insert(this->Corners.end(), corners.begin(), corners.end());
    this->Offsets.push_back(static_cast<Id>(this->Corners.size()));
  }

  CellsView View() const { return { this->Points, this->Offsets, this->Corners }; }
};

// Triangles over a lattice of the unit square, its inner points moved.
Cells Lattice(int columns, int rows, std::uint64_t seed = 1)
{
  Sampler sampler(seed);
  Cells cells;
  for (int j = 0; j < rows; ++j)
  {
    for (int i = 0; i < columns; ++i)
    {
      const bool isInner = i > 0 && j > 0 && i + 1 < columns && j + 1 < rows;
      const double dx = isInner ? 0.5 * (sampler.Next() - 0.5) : 0.0;
      const double dy = isInner ? 0.5 * (sampler.Next() - 0.5) : 0.0;
      cells.Points.push_back({ (i + dx) / (columns - 1), (j + dy) / (rows - 1) });
    }
  }
  for (int j = 0; j + 1 < rows; ++j)
  {
    for (int i = 0; i + 1 < columns; ++i)
    {
      const Id corner = i + j * columns;
      cells.Add({ corner, corner + 1, corner + columns + 1 });
      cells.Add({ corner + columns + 1, corner + columns, corner });
    }
  }
  return cells;
}

std::vector<double> ValuesOf(const Cells& cells, const biting::Field& field)
{
  std::vector<double> values;
  for (const Point2& point : cells.Points)
  {
    values.push_back(field(point));
  }
  return values;
}

std::vector<Hessian2> Recover(const Cells& cells, const std::vector<double>& values)
{
  SilentMonitor monitor;
  return RecoverHessians(cells.View(), values, monitor);
}

double Quadratic(const Point2& x)
{
  return 7.0 + 3.0 * x.X - 2.0 * x.Y + 1.5 * x.X * x.X - 4.0 * x.X * x.Y + 0.25 * x.Y * x.Y;
}

void ExpectHessian(
  const std::vector<Hessian2>& hessians, const Hessian2& expected, double tolerance)
{
  const double margin = tolerance * SpectralNorm(expected);
  for (const Hessian2& hessian : hessians)
  {
    ASSERT_NEAR(hessian.XX, expected.XX, margin);
    ASSERT_NEAR(hessian.XY, expected.XY, margin);
    ASSERT_NEAR(hessian.YY, expected.YY, margin);
  }
}

bool IsUnknown(const Hessian2& hessian)
{
  return std::isnan(hessian.XX) && std::isnan(hessian.XY) && std::isnan(hessian.YY);
}

TEST(RecoverHessians, IsExactForQuadraticsAtTheBoundaryAsInside)
{
  for (const int size : { 3, 4, 9, 30 })
  {
    const Cells cells = Lattice(size, size, static_cast<std::uint64_t>(size));
    ExpectHessian(Recover(cells, ValuesOf(cells, Quadratic)), { 3.0, -4.0, 0.5 }, 1e-9);
  }
}

TEST(RecoverHessians, IsExactOnCellsOfAnyNumberOfCorners)
{
  Cells cells = Lattice(8, 6);
  cells.Offsets = { 0 };
  cells.Corners.clear();
  for (Id j = 0; j + 1 < 6; ++j)
  {
    for (Id i = 0; i + 1 < 8; i += i == 2 ? 2 : 1)
    {
      const Id corner = i + 8 * j;
      i == 2 ? cells.Add({ corner, corner + 1, corner + 2, corner + 10, corner + 9, corner + 8 })
             : cells.Add({ corner, corner + 1, corner + 9, corner + 8 });
    }
  }
  ExpectHessian(Recover(cells, ValuesOf(cells, Quadratic)), { 3.0, -4.0, 0.5 }, 1e-9);
}

TEST(RecoverHessians, IsExactFarFromTheOriginAndOnStretchedMeshes)
{
  Cells cells = Lattice(12, 12);
  const std::vector<double> values = ValuesOf(cells, Quadratic);
  // x = (u, 1e-3 v + 0.7 u) + a shift by a power of two: the function of x keeps its values.
  for (Point2& point : cells.Points)
  {
    point = { 1024.0 + point.X, 1e-3 * point.Y + 0.7 * point.X };
  }
  const double uu = 3.0;
  const double uv = -4.0;
  const double vv = 0.5;
  const double vx = -0.7e3;
  const double vy = 1e3;
  ExpectHessian(Recover(cells, values),
    { uu + 2.0 * uv * vx + vv * vx * vx, uv * vy + vv * vx * vy, vv * vy * vy }, 1e-6);
}

TEST(RecoverHessians, ScalesWithValuesAndLengths)
{
  const Cells cells = Lattice(10, 10);
  std::vector<double> values =
    ValuesOf(cells, [](const Point2& x) { return std::sin(5.0 * x.X) * std::exp(x.Y); });
  const std::vector<Hessian2> before = Recover(cells, values);
  Cells wide = cells;
  for (std::size_t k = 0; k < values.size(); ++k)
  {
    values[k] *= 0x1p10;
    wide.Points[k] = 0x1p20 * wide.Points[k];
  }
  const std::vector<Hessian2> after = Recover(wide, values);
  for (std::size_t k = 0; k < before.size(); ++k)
  {
    EXPECT_EQ(after[k].XX, 0x1p-30 * before[k].XX);
    EXPECT_EQ(after[k].XY, 0x1p-30 * before[k].XY);
    EXPECT_EQ(after[k].YY, 0x1p-30 * before[k].YY);
  }
}

TEST(RecoverHessians, ConvergesForSmoothFunctions)
{
  const auto field = [](const Point2& x) { return std::sin(3.0 * x.X + x.Y); };
  double previous = 0.0;
  for (const int size : { 17, 33, 65 })
  {
    const Cells cells = Lattice(size, size);
    const std::vector<Hessian2> hessians = Recover(cells, ValuesOf(cells, field));
    double largest = 0.0;
    for (std::size_t k = 0; k < hessians.size(); ++k)
    {
      const double expected = 10.0 * std::abs(field(cells.Points[k]));
      largest = std::max(largest, std::abs(SpectralNorm(hessians[k]) - expected));
    }
    EXPECT_TRUE(previous == 0.0 || largest < 0.65 * previous) << size;
    previous = largest;
  }
}

TEST(RecoverHessians, OfAConstantIsZero)
{
  const Cells cells = Lattice(6, 6);
  for (const Hessian2& hessian : Recover(cells, std::vector<double>(36, 0.1)))
  {
    EXPECT_EQ(SpectralNorm(hessian), 0.0);
  }
}

TEST(RecoverHessians, LeavesOutValuesThatAreNotFinite)
{
  const Cells cells = Lattice(9, 9);
  std::vector<double> values = ValuesOf(cells, Quadratic);
  values[40] = biting::NotANumber;
  values[0] = std::numeric_limits<double>::infinity();
  std::vector<Hessian2> hessians = Recover(cells, values);
  EXPECT_TRUE(IsUnknown(hessians[40]));
  EXPECT_TRUE(IsUnknown(hessians[0]));
  hessians.erase(hessians.begin() + 40);
  hessians.erase(hessians.begin());
  ExpectHessian(hessians, { 3.0, -4.0, 0.5 }, 1e-9);
}

TEST(RecoverHessians, IsUnknownWherePointsDoNotDetermineAQuadratic)
{
  const auto areAllUnknown = [](const Cells& cells)
  {
    const std::vector<Hessian2> hessians = Recover(cells, ValuesOf(cells, Quadratic));
    return std::all_of(hessians.begin(), hessians.end(), IsUnknown);
  };
  EXPECT_TRUE(areAllUnknown(Lattice(2, 2)));
  EXPECT_TRUE(areAllUnknown(Lattice(20, 2)));
  Cells flat = Lattice(5, 5);
  for (Point2& point : flat.Points)
  {
    point.Y = 0.3 * point.X;
  }
  EXPECT_TRUE(areAllUnknown(flat));
  Cells lonely = Lattice(5, 5);
  lonely.Points.push_back({ 0.5, 0.5 });
  EXPECT_TRUE(IsUnknown(Recover(lonely, ValuesOf(lonely, Quadratic)).back()));
}

// Two halves that touch without a common point: a jump between them is no curvature.
TEST(RecoverHessians, DoesNotLookAcrossASlit)
{
  Cells cells = Lattice(7, 7);
  const Cells upper = Lattice(7, 7);
  for (const Point2& point : upper.Points)
  {
    cells.Points.push_back({ point.X, 1.0 + point.Y });
  }
  const std::size_t size = upper.Corners.size();
  for (std::size_t k = 0; k < size; k += 3)
  {
    cells.Add({ 49 + upper.Corners[k], 49 + upper.Corners[k + 1], 49 + upper.Corners[k + 2] });
  }
  std::vector<double> values = ValuesOf(cells, Quadratic);
  std::for_each(values.begin() + 49, values.end(), [](double& value) { value += 1000.0; });
  ExpectHessian(Recover(cells, values), { 3.0, -4.0, 0.5 }, 1e-9);
}

// All triangles at one point: each patch is cut at its limit, so the cost stays linear.
TEST(RecoverHessians, StandsAFanOfManyTriangles)
{
  constexpr Id Count = 20000;
  Cells cells;
  cells.Points.push_back({ 0.0, 0.0 });
  for (Id k = 0; k < Count; ++k)
  {
    const double angle = 6.283185307179586 * k / Count;
    const double radius = k % 2 == 0 ? 1.0 : 0.7;
    cells.Points.push_back({ radius * std::cos(angle), radius * std::sin(angle) });
    cells.Add({ 0, 1 + k, 1 + (k + 1) % Count });
  }
  for (const Hessian2& hessian : Recover(cells, ValuesOf(cells, Quadratic)))
  {
    EXPECT_TRUE(IsUnknown(hessian) || std::abs(hessian.XX - 3.0) < 1e-2);
  }
}

TEST(RecoverHessians, StopsWhenAsked)
{
  class Stop : public SilentMonitor
  {
  public:
    bool Advance(double) override { return false; }
  };
  Stop stop;
  const Cells cells = Lattice(100, 100);
  EXPECT_TRUE(RecoverHessians(cells.View(), ValuesOf(cells, Quadratic), stop).empty());
}

TEST(WithThoseAround, TheLargestOfTheNearestRingCounts)
{
  const Cells cells = Lattice(6, 2); // 0 .. 5 below, 6 .. 11 above
  const double none = biting::NotANumber;
  std::vector<double> values(12, 1.0);
  std::vector<double> norms(12, none);
  norms[0] = 2.0;
  norms[6] = 3.0;
  norms[11] = 1.0;
  const std::vector<double> all = WithThoseAround(cells.View(), values, norms);
  EXPECT_EQ(all[0], 2.0);
  EXPECT_EQ(all[1], 2.0); // no cell joins it with 6
  EXPECT_EQ(all[7], 3.0);
  EXPECT_EQ(all[8], 3.0);
  EXPECT_EQ(all[10], 1.0);
  EXPECT_EQ(all[11], 1.0);
  values[1] = none;
  EXPECT_TRUE(std::isnan(WithThoseAround(cells.View(), values, norms)[1]));
  norms.assign(12, none);
  EXPECT_TRUE(std::isnan(WithThoseAround(cells.View(), values, norms)[5]));
}

TEST(SpectralNorm, IsTheLargestSecondDerivativeInAnyDirection)
{
  Sampler sampler(9);
  for (int round = 0; round < 100; ++round)
  {
    const Hessian2 hessian{ sampler.Next() - 0.5, sampler.Next() - 0.5, sampler.Next() - 0.5 };
    double largest = 0.0;
    for (int step = 0; step < 3600; ++step)
    {
      const double angle = 3.141592653589793 * step / 3600;
      const double c = std::cos(angle);
      const double s = std::sin(angle);
      largest = std::max(
        largest, std::abs(c * c * hessian.XX + 2.0 * c * s * hessian.XY + s * s * hessian.YY));
    }
    EXPECT_NEAR(SpectralNorm(hessian), largest, 1e-6);
  }
}

TEST(SpectralNorm, IsInfiniteWhereDerivativesAre)
{
  constexpr double Infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(SpectralNorm({ Infinity, Infinity, 1.0 }), Infinity);
  EXPECT_EQ(SpectralNorm({ 1.0, -Infinity, 1.0 }), Infinity);
}

/// It was 0 or the maximum there, where squares of derivatives leave what numbers can hold.
TEST(NumericalSpacing, ScalesWithLengthsHoweverLargeOrSmall)
{
  const Cells cells = Lattice(9, 9);
  const std::vector<double> values = ValuesOf(cells, Quadratic);
  const std::vector<Hessian2> hessians = Recover(cells, values);
  for (const double scale : { 0x1p498, 0x1p-498 })
  {
    Cells scaled = cells;
    for (Point2& point : scaled.Points)
    {
      point = scale * point;
    }
    const std::vector<Hessian2> found = Recover(scaled, values);
    for (std::size_t k = 0; k < found.size(); ++k)
    {
      const double spacing = NumericalSpacing(SpectralNorm(hessians[k]), 0.01, 0.0, 1e300);
      const double wanted = NumericalSpacing(SpectralNorm(found[k]), 0.01, 0.0, 1e300);
      ASSERT_NEAR(wanted / scale / spacing, 1.0, 1e-12);
    }
  }
}

TEST(NumericalSpacing, StaysWithinItsBounds)
{
  EXPECT_DOUBLE_EQ(NumericalSpacing(4.0, 0.01, 0.0, 9.0), 0.05);
  EXPECT_EQ(NumericalSpacing(4.0, 0.01, 0.1, 9.0), 0.1);
  EXPECT_EQ(NumericalSpacing(4.0, 0.01, 0.0, 0.01), 0.01);
  EXPECT_EQ(NumericalSpacing(0.0, 0.01, 0.0, 9.0), 9.0);
  EXPECT_EQ(NumericalSpacing(0.0, 0.0, 0.0, 9.0), 9.0);
  EXPECT_EQ(NumericalSpacing(1e-20, 0.0, 0.0, 9.0), 9.0);
  EXPECT_GT(NumericalSpacing(std::numeric_limits<double>::infinity(), 0.01, 0.0, 9.0), 0.0);
  EXPECT_TRUE(std::isnan(NumericalSpacing(biting::NotANumber, 0.01, 0.0, 9.0)));
}

// The bound of the header: linear interpolation over edges of length f of a quadratic with the
// second derivative lambda is off by epsilon / 8 along an edge in its direction, and by epsilon / 6
// inside of equilateral triangles where all directions have it.
TEST(NumericalSpacing, BoundsTheInterpolationErrorAndQuadraticsReachIt)
{
  constexpr double Lambda = 3.0;
  constexpr double Tolerance = 0.012;
  const double length = NumericalSpacing(Lambda, Tolerance, 0.0, 1e9);
  const double onEdge = 0.5 * Lambda * (0.5 * length) * (0.5 * length);
  EXPECT_NEAR(onEdge, Tolerance / 8.0, 1e-15);
  const double radius = length / std::sqrt(3.0);
  EXPECT_NEAR(0.5 * Lambda * radius * radius, Tolerance / 6.0, 1e-15);
}

} // namespace
