// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "FilterTesting.h"

#include "vtkHessianSpacing.h"

#include "vtkCellArray.h"
#include "vtkCellType.h"
#include "vtkDataObject.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <algorithm>  // for max_element
#include <cmath>      // for exp
#include <functional> // for fields

using namespace testing_filters;

namespace
{

constexpr int Points = vtkDataObject::FIELD_ASSOCIATION_POINTS;

using Field = std::function<double(const Place&)>;

// Second derivatives 6, 4 and 0 (mixed): lambda = 6.
double Quadratic(const Place& place)
{
  return 3.0 * place[0] * place[0] - 2.0 * place[1] * place[1] + place[0] + 5.0;
}

void AddField(vtkDataSet* data, const Field& field, const char* name = "u")
{
  std::vector<double> values;
  for (vtkIdType point = 0; point < data->GetNumberOfPoints(); ++point)
  {
    Place place;
    data->GetPoint(point, place.data());
    values.push_back(field(place));
  }
  AddArray<vtkDoubleArray>(data->GetPointData(), name, values);
  data->GetPointData()->SetActiveScalars(name);
}

vtkSmartPointer<vtkImageData> Image(int nx, int ny, int nz = 1)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(nx, ny, nz);
  image->SetSpacing(1.0 / (nx - 1), 1.0 / (ny - 1), 1.0);
  AddField(image, Quadratic);
  return image;
}

vtkSmartPointer<vtkPolyData> Mesh(double spacing, const Field& field)
{
  vtkNew<vtkBitingMesher> mesher;
  mesher->SetInputData(UnitSquare());
  mesher->SetUniformSpacing(spacing);
  mesher->Update();
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->CopyStructure(mesher->GetOutput());
  AddField(mesh, field);
  return mesh;
}

double ValueAt(vtkDataSet* data, const char* name, vtkIdType point)
{
  vtkDataArray* array = data->GetPointData()->GetArray(name);
  return array ? array->GetComponent(point, 0) : -1.0;
}

/// The same mesh with points and cells the other way round, and other corners first.
vtkSmartPointer<vtkPolyData> Backwards(vtkPolyData* mesh)
{
  const vtkIdType last = mesh->GetNumberOfPoints() - 1;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  std::vector<double> values;
  for (vtkIdType point = last; point >= 0; --point)
  {
    points->InsertNextPoint(mesh->GetPoint(point));
    values.push_back(ValueAt(mesh, "u", point));
  }
  vtkNew<vtkCellArray> cells;
  for (vtkIdType cell = mesh->GetNumberOfCells() - 1; cell >= 0; --cell)
  {
    vtkNew<vtkIdList> corners;
    mesh->GetCellPoints(cell, corners);
    cells->InsertNextCell(
      { last - corners->GetId(2), last - corners->GetId(0), last - corners->GetId(1) });
  }
  auto backwards = vtkSmartPointer<vtkPolyData>::New();
  backwards->SetPoints(points);
  backwards->SetPolys(cells);
  AddArray<vtkDoubleArray>(backwards->GetPointData(), "u", values);
  backwards->GetPointData()->SetActiveScalars("u");
  return backwards;
}

void ExpectSpacing(vtkDataSet* input, double tolerance, double expected)
{
  vtkNew<vtkHessianSpacing> filter;
  Messages messages(filter);
  filter->SetInputData(input);
  filter->SetErrorTolerance(tolerance);
  filter->Update();
  vtkDataSet* output = filter->GetOutput();
  ASSERT_EQ(output->GetNumberOfPoints(), input->GetNumberOfPoints());
  for (vtkIdType point = 0; point < output->GetNumberOfPoints(); ++point)
  {
    ASSERT_NEAR(ValueAt(output, "Spacing", point), expected, 1e-8 * expected) << point;
  }
  EXPECT_TRUE(messages.Errors.empty());
  EXPECT_TRUE(messages.Warnings.empty());
}

std::string RefusalOf(vtkHessianSpacing* filter)
{
  Messages messages(filter);
  filter->Update();
  EXPECT_EQ(messages.Errors.size(), 1u);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  return messages.Errors.empty() ? "" : messages.Errors.front();
}

std::string RefusalOf(vtkDataSet* input)
{
  vtkNew<vtkHessianSpacing> filter;
  filter->SetInputData(input);
  return RefusalOf(filter);
}

// The error of linear interpolation at the middle of an edge.
struct EdgeError
{
  double Error;
  double RelativeLength; // by the mean spacing of its ends
};

// Of all sides of the triangles.
std::vector<EdgeError> EdgeErrorsOn(vtkPolyData* mesh, const Field& field)
{
  std::vector<EdgeError> errors;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    mesh->GetCellPoints(cell, ids);
    for (vtkIdType k = 0; k < 3; ++k)
    {
      const vtkIdType start = ids->GetId(k);
      const vtkIdType end = ids->GetId((k + 1) % 3);
      const Place a = PointOf(mesh, start);
      const Place b = PointOf(mesh, end);
      const Place middle{ 0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1]), 0.0 };
      const double spacing =
        0.5 * (ValueAt(mesh, "Spacing", start) + ValueAt(mesh, "Spacing", end));
      errors.push_back({ std::abs(0.5 * (field(a) + field(b)) - field(middle)),
        std::hypot(b[0] - a[0], b[1] - a[1]) / spacing });
    }
  }
  return errors;
}

double LargestError(const std::vector<EdgeError>& errors)
{
  return std::max_element(errors.begin(), errors.end(),
    [](const EdgeError& left, const EdgeError& right) { return left.Error < right.Error; })
    ->Error;
}

} // namespace

TEST(HessianSpacing, ValuesAreTheSameBitsInWhateverOrderPointsAndCellsCome)
{
  const auto mesh =
    Mesh(0.05, [](const Place& x) { return std::exp(x[0] - 2.0 * x[1]) / (0.3 + x[0]); });
  vtkNew<vtkHessianSpacing> forth;
  forth->SetInputData(mesh);
  forth->Update();
  vtkNew<vtkHessianSpacing> back;
  back->SetInputData(Backwards(mesh));
  back->Update();
  const vtkIdType last = mesh->GetNumberOfPoints() - 1;
  ASSERT_GT(last, 100);
  for (vtkIdType point = 0; point <= last; ++point)
  {
    ASSERT_EQ(ValueAt(forth->GetOutput(), "HessianNorm", point),
      ValueAt(back->GetOutput(), "HessianNorm", last - point));
    ASSERT_EQ(ValueAt(forth->GetOutput(), "Spacing", point),
      ValueAt(back->GetOutput(), "Spacing", last - point));
  }
}

TEST(HessianSpacing, OfAQuadraticIsExactOnMeshesAndImages)
{
  const double expected = std::sqrt(0.06 / 6.0);
  ExpectSpacing(Image(5, 9), 0.06, expected);
  ExpectSpacing(Image(3, 3), 0.06, expected);
  ExpectSpacing(Mesh(0.1, Quadratic), 0.06, expected);
  const auto mesh = Mesh(0.2, Quadratic);
  vtkNew<vtkUnstructuredGrid> grid;
  grid->SetPoints(mesh->GetPoints());
  grid->SetCells(VTK_TRIANGLE, mesh->GetPolys());
  AddField(grid, Quadratic);
  ExpectSpacing(grid, 0.06, expected);
}

TEST(HessianSpacing, IsExactInAPlaneOfSpace)
{
  const auto mesh = Mesh(0.2, Quadratic);
  for (vtkIdType point = 0; point < mesh->GetNumberOfPoints(); ++point)
  {
    const Place place = PointOf(mesh, point);
    mesh->GetPoints()->SetPoint(point, 0.6 * place[0], 3.0 + place[1], 0.8 * place[0]);
  }
  ExpectSpacing(mesh, 0.06, std::sqrt(0.06 / 6.0));
}

// What the class promises: an edge of length r f interpolates with an error of at most r^2 times an
// eighth of the tolerance. f varies along it: hence the 30 percent.
TEST(HessianSpacing, GivesMeshesWithTheErrorThatItPromises)
{
  const auto field = [](const Place& place)
  { return std::exp(4.0 * place[0]) * std::cos(4.0 * place[1]); };
  constexpr double Tolerance = 0.2;
  vtkNew<vtkHessianSpacing> spacing;
  spacing->SetInputData(Mesh(0.02, field));
  spacing->SetErrorTolerance(Tolerance);
  vtkNew<vtkBitingMesher> mesher;
  mesher->SetInputData(UnitSquare());
  mesher->SetSpacingSourceConnection(spacing->GetOutputPort());
  mesher->Update();
  vtkPolyData* mesh = mesher->GetOutput();
  const std::vector<EdgeError> errors = EdgeErrorsOn(mesh, field);
  for (const EdgeError& edge : errors)
  {
    EXPECT_LT(edge.Error, 1.3 * edge.RelativeLength * edge.RelativeLength * Tolerance / 8.0);
  }
  EXPECT_GT(LargestError(errors), 0.5 * Tolerance / 8.0);

  const auto uniform = Mesh(std::sqrt(1.0 / mesh->GetNumberOfPoints()), field);
  EXPECT_GE(uniform->GetNumberOfPoints(), mesh->GetNumberOfPoints());
  EXPECT_LT(LargestError(errors), 0.7 * LargestError(EdgeErrorsOn(uniform, field)));
}

TEST(HessianSpacing, TakesOnePercentOfTheRangeByDefault)
{
  vtkNew<vtkHessianSpacing> filter;
  filter->SetInputData(Image(5, 5));
  filter->Update();
  // From 3 at (0, 1) to 9 at (1, 0).
  EXPECT_DOUBLE_EQ(
    filter->GetOutput()->GetFieldData()->GetArray("ErrorTolerance")->GetComponent(0, 0), 0.06);
  EXPECT_NEAR(ValueAt(filter->GetOutput(), "Spacing", 7), 0.1, 1e-9);
  EXPECT_NEAR(ValueAt(filter->GetOutput(), "HessianNorm", 7), 6.0, 1e-9);
}

TEST(HessianSpacing, StaysWithinItsBounds)
{
  const auto spacingWith = [](double minimum, double maximum, const Field& field)
  {
    const auto image = Image(4, 4);
    AddField(image, field);
    vtkNew<vtkHessianSpacing> filter;
    filter->SetInputData(image);
    filter->SetErrorTolerance(0.06);
    filter->SetMinimumSpacing(minimum);
    filter->SetMaximumSpacing(maximum);
    filter->Update();
    return ValueAt(filter->GetOutput(), "Spacing", 5);
  };
  const auto constant = [](const Place&) { return 0.3; };
  const auto linear = [](const Place& place) { return 0.1 + 0.7 * place[0] - 0.3 * place[1]; };
  EXPECT_EQ(spacingWith(0.2, 0.0, Quadratic), 0.2);
  EXPECT_EQ(spacingWith(0.0, 0.05, Quadratic), 0.05);
  EXPECT_DOUBLE_EQ(spacingWith(0.0, 0.0, constant), std::sqrt(2.0));
  EXPECT_DOUBLE_EQ(spacingWith(0.0, 0.0, linear), std::sqrt(2.0));
  EXPECT_EQ(spacingWith(0.0, 0.7, linear), 0.7);
  EXPECT_EQ(spacingWith(3.0, 0.0, linear), 3.0);
}

TEST(HessianSpacing, IsNeverZeroHoweverLargeOrSmallValuesAre)
{
  vtkNew<vtkHessianSpacing> filter;
  for (const double scale : { 0.0, 1e-300, 1.0, 5e306 })
  {
    const auto image = Image(5, 9);
    AddField(image, [scale](const Place& place) { return scale * Quadratic(place); });
    filter->SetInputData(image);
    filter->Update();
    for (vtkIdType point = 0; point < image->GetNumberOfPoints(); ++point)
    {
      const double expected = scale > 0.0 ? 0.1 : std::sqrt(2.0);
      ASSERT_NEAR(ValueAt(filter->GetOutput(), "Spacing", point), expected, 1e-8) << scale;
    }
  }
}

TEST(HessianSpacing, PassesEverythingOn)
{
  const auto image = Image(4, 4);
  AddArray<vtkDoubleArray>(image->GetCellData(), "Tag", std::vector<double>(9, 4.0));
  vtkNew<vtkHessianSpacing> filter;
  filter->SetInputData(image);
  filter->Update();
  ASSERT_TRUE(vtkImageData::SafeDownCast(filter->GetOutput()));
  EXPECT_TRUE(filter->GetOutput()->GetCellData()->HasArray("Tag"));
  EXPECT_TRUE(filter->GetOutput()->GetPointData()->HasArray("u"));
  EXPECT_FALSE(image->GetPointData()->HasArray("Spacing"));
}

TEST(HessianSpacing, TakesTheArrayThatWasChosen)
{
  const auto image = Image(4, 4);
  std::vector<double> flat(16, 1.0);
  AddArray<vtkFloatArray>(image->GetPointData(), "flat", flat);
  vtkNew<vtkHessianSpacing> filter;
  filter->SetInputData(image);
  filter->SetInputArrayToProcess(0, 0, 0, Points, "flat");
  filter->Update();
  EXPECT_EQ(ValueAt(filter->GetOutput(), "HessianNorm", 0), 0.0);
}

TEST(HessianSpacing, SaysNothingWhereNothingIsKnown)
{
  const auto image = Image(7, 7);
  image->GetPointData()->GetArray("u")->SetComponent(24, 0, std::nan(""));
  vtkNew<vtkHessianSpacing> filter;
  Messages messages(filter);
  filter->SetInputData(image);
  filter->SetErrorTolerance(0.06);
  filter->Update();
  EXPECT_TRUE(std::isnan(ValueAt(filter->GetOutput(), "Spacing", 24)));
  EXPECT_TRUE(std::isnan(ValueAt(filter->GetOutput(), "HessianNorm", 24)));
  EXPECT_NEAR(ValueAt(filter->GetOutput(), "Spacing", 23), 0.1, 1e-8);
  ASSERT_EQ(messages.Warnings.size(), 1u);
  EXPECT_TRUE(Has(messages.Warnings[0], "not finite at 1 points"));
}

/// A square with a channel of two rows of points, as in meshes of coasts.
TEST(HessianSpacing, GivesPointsWithoutAHessianTheSpacingOfThoseAround)
{
  vtkNew<vtkPolyData> mesh;
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> quads;
  std::vector<double> values;
  for (int k = 0; k < 25 + 16; ++k)
  {
    const double x = k < 25 ? k % 5 : 5 + (k - 25) / 2;
    const double y = k < 25 ? k / 5 : (k - 25) % 2;
    points->InsertNextPoint(x, y, 0.0);
    values.push_back(1.5 * x * x);
  }
  const auto add = [&quads](vtkIdType a, vtkIdType b, vtkIdType c, vtkIdType d) {
    quads->InsertNextCell({ a, b, c, d });
  };
  for (vtkIdType k = 0; k < 16; ++k)
  {
    const vtkIdType low = k % 4 + 5 * (k / 4);
    add(low, low + 1, low + 6, low + 5);
  }
  add(4, 25, 26, 9);
  for (vtkIdType k = 25; k < 39; k += 2)
  {
    add(k, k + 2, k + 3, k + 1);
  }
  mesh->SetPoints(points);
  mesh->SetPolys(quads);
  AddArray<vtkDoubleArray>(mesh->GetPointData(), "u", values);
  mesh->GetPointData()->SetActiveScalars("u");
  vtkNew<vtkHessianSpacing> filter;
  Messages messages(filter);
  filter->SetInputData(mesh);
  filter->SetErrorTolerance(0.03);
  filter->Update();
  ASSERT_EQ(messages.Warnings.size(), 1u);
  EXPECT_TRUE(Has(messages.Warnings[0], "points around them"));
  EXPECT_TRUE(std::isnan(ValueAt(filter->GetOutput(), "HessianNorm", 40)));
  for (vtkIdType point = 0; point < 41; ++point)
  {
    EXPECT_NEAR(ValueAt(filter->GetOutput(), "Spacing", point), 0.1, 1e-6);
  }
}

TEST(HessianSpacing, RefusesWhatHasNoHessian)
{
  EXPECT_TRUE(Has(RefusalOf(Image(9, 2)), "No point has enough"));
  EXPECT_TRUE(Has(RefusalOf(Image(3, 3, 3)), "Cell 0 is a vtkVoxel with 8 points"));
  EXPECT_TRUE(Has(RefusalOf(UnitSquare()), "no faces"));
  const auto without = Image(4, 4);
  without->GetPointData()->Initialize();
  EXPECT_TRUE(Has(RefusalOf(without), "no active point array"));
  vtkNew<vtkHessianSpacing> filter;
  filter->SetInputData(Image(4, 4));
  filter->SetInputArrayToProcess(0, 0, 0, Points, "v");
  EXPECT_TRUE(Has(RefusalOf(filter), "no point array named v"));
}

TEST(HessianSpacing, RefusesParametersOutOfRange)
{
  vtkNew<vtkHessianSpacing> filter;
  filter->SetInputData(Image(4, 4));
  filter->SetErrorTolerance(-1.0);
  EXPECT_TRUE(Has(RefusalOf(filter), "Error Tolerance is -1"));
  filter->SetErrorTolerance(0.0);
  filter->SetMinimumSpacing(2.0);
  filter->SetMaximumSpacing(1.0);
  EXPECT_TRUE(Has(RefusalOf(filter), "Minimum Spacing is above Maximum Spacing"));
}

TEST(HessianSpacing, OfNothingIsNothing)
{
  vtkNew<vtkHessianSpacing> filter;
  Messages messages(filter);
  filter->SetInputData(EmptyInput());
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_TRUE(messages.Errors.empty());
  EXPECT_TRUE(messages.Warnings.empty());
}

TEST(HessianSpacing, LeavesNothingAfterAnAbortAndWorksAgain)
{
  vtkNew<vtkHessianSpacing> filter;
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback([](vtkObject* caller, unsigned long, void*, void*)
    { vtkAlgorithm::SafeDownCast(caller)->SetAbortExecute(1); });
  const unsigned long tag = filter->AddObserver(vtkCommand::ProgressEvent, stop);
  filter->SetInputData(Image(50, 50));
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetPointData()->GetNumberOfArrays(), 0);
  filter->RemoveObserver(tag);
  filter->Modified();
  filter->Update();
  EXPECT_TRUE(filter->GetOutput()->GetPointData()->HasArray("Spacing"));
}
