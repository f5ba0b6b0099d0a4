// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "FilterTesting.h"

#include "vtkBitingDelaunay3D.h"

#include "vtkCellType.h"
#include "vtkErrorCode.h"
#include "vtkIdList.h"
#include "vtkTetra.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <limits> // for NaN
#include <set>    // for used points

using namespace testing_filters;

namespace
{

/// Points alone, with an array of their numbers.
vtkSmartPointer<vtkPolyData> Points(const std::vector<Place>& places, int type = VTK_DOUBLE)
{
  auto data = EmptyInput(type);
  std::vector<double> numbers;
  for (const Place& place : places)
  {
    numbers.push_back(static_cast<double>(numbers.size()));
    data->GetPoints()->InsertNextPoint(place.data());
  }
  AddArray<vtkDoubleArray>(data->GetPointData(), "Number", numbers);
  return data;
}

std::vector<Place> Lattice(int size, double step = 1.0)
{
  std::vector<Place> places;
  for (int k = 0; k < size * size * size; ++k)
  {
    places.push_back({ step * (k % size), step * (k / size % size), step * (k / size / size) });
  }
  return places;
}

double VolumeOf(vtkUnstructuredGrid* grid)
{
  double volume = 0.0;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    double p[4][3];
    for (int k = 0; k < 4; ++k)
    {
      grid->GetPoint(grid->GetCell(cell)->GetPointId(k), p[k]);
    }
    const double part = vtkTetra::ComputeVolume(p[0], p[1], p[2], p[3]);
    EXPECT_GT(part, 0.0);
    volume += part;
  }
  return volume;
}

std::set<vtkIdType> UsedPoints(vtkUnstructuredGrid* grid)
{
  std::set<vtkIdType> used;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    EXPECT_EQ(grid->GetCellType(cell), VTK_TETRA);
    for (int k = 0; k < 4; ++k)
    {
      used.insert(grid->GetCell(cell)->GetPointId(k));
    }
  }
  return used;
}

struct Outcome
{
  explicit Outcome(vtkPolyData* input, double alpha = 0.0)
  {
    this->Filter->SetInputData(input);
    this->Filter->SetAlpha(alpha);
    const Messages messages(this->Filter);
    this->Filter->Update();
    this->Errors = messages.Errors;
    this->Warnings = messages.Warnings;
  }

  vtkUnstructuredGrid* Output() { return this->Filter->GetOutput(); }

  bool IsEmpty()
  {
    return this->Output()->GetNumberOfPoints() == 0 && this->Output()->GetNumberOfCells() == 0;
  }

  vtkNew<vtkBitingDelaunay3D> Filter;
  std::vector<std::string> Errors;
  std::vector<std::string> Warnings;
};

} // namespace

TEST(BitingDelaunay3D, FillsTheHullAndLosesNoPoint)
{
  for (const double step : { 1.0, 0.1, 1e-9 })
  {
    Outcome run(Points(Lattice(7, step)));
    EXPECT_TRUE(run.Errors.empty() && run.Warnings.empty());
    EXPECT_EQ(UsedPoints(run.Output()).size(), 343u);
    EXPECT_NEAR(VolumeOf(run.Output()), 216.0 * step * step * step, 1e-9 * step * step * step);
  }
}

TEST(BitingDelaunay3D, PassesPointsAndTheirArraysOn)
{
  const auto input = Points(Lattice(3), VTK_FLOAT);
  Outcome run(input);
  EXPECT_TRUE(AreSameBytes(run.Output()->GetPoints()->GetData(), input->GetPoints()->GetData()));
  EXPECT_TRUE(AreSameBytes(
    run.Output()->GetPointData()->GetArray("Number"), input->GetPointData()->GetArray("Number")));
}

TEST(BitingDelaunay3D, TellsDuplicates)
{
  std::vector<Place> places = Lattice(3);
  places.push_back(places[13]);
  Outcome run(Points(places));
  ASSERT_EQ(run.Warnings.size(), 1u);
  EXPECT_TRUE(
    Has(run.Warnings[0], "point 27 at point 13") || Has(run.Warnings[0], "point 13 at point 27"));
  EXPECT_EQ(UsedPoints(run.Output()).size(), 27u);
  EXPECT_EQ(run.Output()->GetNumberOfPoints(), 28);
}

TEST(BitingDelaunay3D, SaysWhyThereIsNoTetrahedron)
{
  const std::pair<std::vector<Place>, const char*> cases[] = {
    { { { 1, 2, 3 } }, "at one place" },
    { { { 1, 2, 3 }, { 1, 2, 3 } }, "at one place" },
    { { { 0, 0, 0 }, { 1, 2, 3 }, { 2, 4, 6 } }, "on one line" },
    { Rectangle(0, 0, 1, 1), "in one plane" },
  };
  for (const auto& [places, words] : cases)
  {
    Outcome run(Points(places));
    EXPECT_TRUE(run.IsEmpty() && run.Errors.empty());
    ASSERT_EQ(run.Warnings.size(), 1u);
    EXPECT_TRUE(Has(run.Warnings[0], words));
  }
  Outcome none(Points({}));
  EXPECT_TRUE(none.IsEmpty() && none.Errors.empty() && none.Warnings.empty());
}

TEST(BitingDelaunay3D, RefusesWhatIsNotFinite)
{
  std::vector<Place> places = Lattice(3);
  places[5][1] = std::numeric_limits<double>::quiet_NaN();
  places[7][2] = std::numeric_limits<double>::infinity();
  Outcome run(Points(places));
  ASSERT_EQ(run.Errors.size(), 1u);
  EXPECT_TRUE(Has(run.Errors[0], "Point 5 ") && Has(run.Errors[0], "1 more"));
  EXPECT_EQ(run.Filter->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::UserError));
  EXPECT_TRUE(run.IsEmpty());
  Outcome negative(Points(Lattice(3)), -1.0);
  EXPECT_EQ(negative.Errors.size(), 1u);
}

// Two cubes apart: no tetrahedron between them where the radius is bounded.
TEST(BitingDelaunay3D, LeavesGapsOpenThatAreWiderThanAlpha)
{
  std::vector<Place> places = Lattice(4);
  for (Place place : Lattice(4))
  {
    place[0] += 8.0;
    places.push_back(place);
  }
  Outcome all(Points(places));
  EXPECT_NEAR(VolumeOf(all.Output()), 99.0, 1e-9);
  Outcome bounded(Points(places), 0.9);
  EXPECT_NEAR(VolumeOf(bounded.Output()), 54.0, 1e-9);
  Outcome nothing(Points(places), 0.1);
  EXPECT_EQ(nothing.Output()->GetNumberOfCells(), 0);
}

TEST(BitingDelaunay3D, StopsWhereItIsAsked)
{
  std::vector<Place> places = Lattice(30);
  vtkNew<vtkBitingDelaunay3D> filter;
  filter->SetInputData(Points(places));
  vtkNew<vtkCallbackCommand> command;
  command->SetCallback(
    [](vtkObject* caller, unsigned long, void*, void*)
    {
      auto* algorithm = static_cast<vtkAlgorithm*>(caller);
      if (algorithm->GetProgress() > 0.3)
      {
        vtkBitingCompat::Abort(algorithm);
      }
    });
  filter->AddObserver(vtkCommand::ProgressEvent, command);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 0);
  EXPECT_EQ(filter->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::NoError));
}
