// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

// Longitude and latitude. Lengths and angles on the globe are judged by formulas of this test.

#include "FilterTesting.h"

#include "vtkBitingRemesher.h"
#include "vtkHessianSpacing.h"
#include "vtkMeshConformity.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkSMPTools.h"

#include <gtest/gtest.h>

#include <algorithm> // for min, max
#include <set>       // for longitudes

using namespace testing_filters;

namespace
{

constexpr double Radius = 6371008.8;
constexpr double Degree = 3.14159265358979323846 / 180.0;
constexpr double Metres = Radius * Degree; // of a degree
constexpr int PointArrays = vtkDataObject::FIELD_ASSOCIATION_POINTS;

// Haversines.
double GreatCircle(const double* a, const double* b)
{
  const double dLatitude = std::sin(0.5 * Degree * (b[1] - a[1]));
  const double dLongitude = std::sin(0.5 * Degree * (b[0] - a[0]));
  const double h = dLatitude * dLatitude +
    std::cos(Degree * a[1]) * std::cos(Degree * b[1]) * dLongitude * dLongitude;
  return 2.0 * Radius * std::asin(std::sqrt(h));
}

// At a, of a spherical triangle, by its sides.
double AngleAt(const double* a, const double* b, const double* c)
{
  const double ab = GreatCircle(a, b) / Radius;
  const double ac = GreatCircle(a, c) / Radius;
  const double bc = GreatCircle(b, c) / Radius;
  const double s = 0.5 * (ab + ac + bc);
  const double square = std::sin(s - ab) * std::sin(s - ac) / (std::sin(s) * std::sin(s - bc));
  return 2.0 * std::atan(std::sqrt(std::max(square, 0.0))) / Degree;
}

// What a mesh is on the globe.
struct GlobeMeasures
{
  vtkIdType Points = 0;
  double MeanAngle = 0.0; // mean of the smallest angles
  double LeastAngle = 180.0;
  double MeanLength = 0.0;   // of edges, by the mean of Spacing at the ends
  double Area = 0.0;         // square metres
  double WorstNearest = 0.0; // of NearestNeighborDistance, relative
};

GlobeMeasures Judge(vtkPolyData* mesh)
{
  GlobeMeasures result;
  result.Points = mesh->GetNumberOfPoints();
  vtkDataArray* spacing = mesh->GetPointData()->GetArray("Spacing");
  vtkDataArray* nearest = mesh->GetPointData()->GetArray("NearestNeighborDistance");
  std::vector<double> shortest(static_cast<std::size_t>(result.Points), 1e30);
  vtkNew<vtkIdList> corners;
  double edges = 0.0;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    mesh->GetCellPoints(cell, corners);
    double places[3][3];
    for (int k = 0; k < 3; ++k)
    {
      mesh->GetPoint(corners->GetId(k), places[k]);
    }
    double least = 180.0;
    double excess = -180.0;
    for (int k = 0; k < 3; ++k)
    {
      const double angle = AngleAt(places[k], places[(k + 1) % 3], places[(k + 2) % 3]);
      least = std::min(least, angle);
      excess += angle;
      const double length = GreatCircle(places[k], places[(k + 1) % 3]);
      const vtkIdType a = corners->GetId(k);
      const vtkIdType b = corners->GetId((k + 1) % 3);
      result.MeanLength += 2.0 * length / (spacing->GetTuple1(a) + spacing->GetTuple1(b));
      edges += 1.0;
      for (const vtkIdType end : { a, b })
      {
        double& known = shortest[static_cast<std::size_t>(end)];
        known = std::min(known, length);
      }
    }
    result.MeanAngle += least;
    result.LeastAngle = std::min(result.LeastAngle, least);
    result.Area += excess * Degree * Radius * Radius;
  }
  for (vtkIdType point = 0; point < result.Points; ++point)
  {
    const double length = shortest[static_cast<std::size_t>(point)];
    result.WorstNearest =
      std::max(result.WorstNearest, std::abs(nearest->GetTuple1(point) / length - 1.0));
  }
  result.MeanAngle /= static_cast<double>(std::max<vtkIdType>(mesh->GetNumberOfCells(), 1));
  result.MeanLength /= std::max(edges, 1.0);
  return result;
}

// The place at a distance in metres and a bearing in degrees from the middle.
Place From(const Place& middle, double distance, double bearing)
{
  const double c = distance / Radius;
  const double north[2] = { std::cos(Degree * middle[1]), std::sin(Degree * middle[1]) };
  const double along = std::sin(c) * std::cos(Degree * bearing);
  // Towards the middle's meridian, towards the east, towards the pole.
  const double x = std::cos(c) * north[0] - along * north[1];
  const double y = std::sin(c) * std::sin(Degree * bearing);
  const double z = std::cos(c) * north[1] + along * north[0];
  const double longitude = middle[0] + std::atan2(y, x) / Degree;
  return { longitude > 180.0 ? longitude - 360.0 : longitude,
    std::atan2(z, std::hypot(x, y)) / Degree, 0.0 };
}

// A bay of 300 km about the middle, with an island: the same on the globe wherever it is, as its
// lines are so short that those which are straight in degrees are straight on the globe.
vtkSmartPointer<vtkPolyData> Bay(const Place& middle, double size = 300e3)
{
  auto data = EmptyInput();
  std::vector<Place> shore;
  std::vector<Place> island;
  for (int k = 0; k < 180; ++k)
  {
    const double bearing = 2.0 * k;
    shore.push_back(From(middle, size * (1.0 + 0.2 * std::sin(3.0 * Degree * bearing)), -bearing));
    if (k % 3 == 0)
    {
      island.push_back(From(middle, 0.4 * size, bearing + 1.0));
    }
  }
  AddChain(data, shore, true);
  AddChain(data, island, true);
  return data;
}

vtkSmartPointer<vtkBitingMesher> OnGlobe(vtkPolyData* drawing, double spacing)
{
  auto mesher = vtkSmartPointer<vtkBitingMesher>::New();
  mesher->SetInputData(drawing);
  mesher->SetCoordinatesToLongitudeLatitude();
  mesher->SetUniformSpacing(spacing);
  return mesher;
}

double LargestJump(vtkPolyData* mesh)
{
  double largest = 0.0;
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    mesh->GetCellPoints(cell, corners);
    for (int k = 0; k < 3; ++k)
    {
      largest = std::max(largest,
        std::abs(
          mesh->GetPoint(corners->GetId(k))[0] - mesh->GetPoint(corners->GetId((k + 1) % 3))[0]));
    }
  }
  return largest;
}

// A linear function of the latitude, in metres, on the whole globe, every `step` degrees.
vtkSmartPointer<vtkImageData> ByLatitude(int step, double atEquator, double perDegree)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetOrigin(-180.0, -90.0, 0.0);
  image->SetSpacing(step, step, 1.0);
  image->SetDimensions(360 / step + 1, 180 / step + 1, 1);
  std::vector<double> values;
  for (vtkIdType k = 0; k < image->GetNumberOfPoints(); ++k)
  {
    values.push_back(atEquator + perDegree * std::abs(image->GetPoint(k)[1]));
  }
  AddArray<vtkDoubleArray>(image->GetPointData(), "Spacing", values);
  return image;
}

} // namespace

TEST(BitingMesherGlobe, TheSameDrawingHasTheSameMeshWhereverItIs)
{
  std::vector<GlobeMeasures> all;
  for (const Place& middle : { Place{ 10.0, 0.0, 0.0 }, Place{ 10.0, 65.0, 0.0 },
         Place{ 180.0, 20.0, 0.0 }, Place{ 0.0, 90.0, 0.0 }, Place{ -100.0, -85.0, 0.0 } })
  {
    const auto mesher = OnGlobe(Bay(middle), 12e3);
    const Messages messages(mesher);
    mesher->Update();
    EXPECT_TRUE(messages.Errors.empty());
    EXPECT_TRUE(messages.Warnings.empty()) << messages.Warnings.front();
    all.push_back(Judge(mesher->GetOutput()));
    const GlobeMeasures& own = all.back();
    EXPECT_NEAR(own.Points, all.front().Points, 0.01 * all.front().Points);
    EXPECT_NEAR(own.MeanAngle, all.front().MeanAngle, 0.5);
    EXPECT_NEAR(own.Area, all.front().Area, 1e-3 * own.Area);
    EXPECT_NEAR(own.MeanLength, 1.0, 0.02);
    EXPECT_GT(own.MeanAngle, 50.0);
    EXPECT_GT(own.LeastAngle, 25.0);
    EXPECT_LT(own.WorstNearest, 1e-3);
  }
}

TEST(BitingMesherGlobe, AMeshAcrossThe180thMeridianContinues)
{
  const auto drawing = Bay({ 179.5, 65.0, 0.0 });
  const auto mesher = OnGlobe(drawing, 20e3);
  mesher->Update();
  vtkPolyData* mesh = mesher->GetOutput();
  EXPECT_LT(LargestJump(mesh), 10.0);
  double bounds[6];
  mesh->GetBounds(bounds);
  EXPECT_GT(bounds[0], 160.0);
  EXPECT_GT(bounds[1], 185.0);
  EXPECT_LT(bounds[1], 200.0);
  // Vertices of the input are those of it, up to whole turns.
  vtkDataArray* originals = mesh->GetPointData()->GetArray("OriginalPointId");
  vtkIdType count = 0;
  for (vtkIdType point = 0; point < mesh->GetNumberOfPoints(); ++point)
  {
    const auto original = static_cast<vtkIdType>(originals->GetTuple1(point));
    if (original >= 0)
    {
      const double given = drawing->GetPoint(original)[0];
      EXPECT_EQ(mesh->GetPoint(point)[0], given < 0.0 ? given + 360.0 : given);
      EXPECT_EQ(mesh->GetPoint(point)[1], drawing->GetPoint(original)[1]);
      ++count;
    }
  }
  EXPECT_EQ(count, drawing->GetNumberOfPoints());
}

TEST(BitingMesherGlobe, LongitudesStayInTheRangeOfTheInput)
{
  for (const double turn : { 0.0, 360.0 })
  {
    const auto drawing = EmptyInput();
    AddChain(drawing, Rectangle(turn - 100.0, 10.0, turn - 95.0, 14.0), true);
    const auto mesher = OnGlobe(drawing, 40e3);
    mesher->Update();
    double bounds[6];
    mesher->GetOutput()->GetBounds(bounds);
    EXPECT_EQ(bounds[0], turn - 100.0);
    EXPECT_EQ(bounds[1], turn - 95.0);
  }
}

TEST(BitingMesherGlobe, LinesAreStraightInDegrees)
{
  const auto drawing = EmptyInput();
  AddChain(drawing, Rectangle(-10.0, 60.0, 30.0, 70.0), true);
  constexpr double Spacing = 50e3;
  const auto mesher = OnGlobe(drawing, Spacing);
  mesher->Update();
  vtkPolyData* mesh = mesher->GetOutput();
  const double exact =
    Radius * Radius * 40.0 * Degree * (std::sin(70.0 * Degree) - std::sin(60.0 * Degree));
  EXPECT_NEAR(Judge(mesh).Area, exact, 1e-3 * exact);
  vtkDataArray* originals = mesh->GetPointData()->GetArray("OriginalPointId");
  vtkDataArray* kinds = mesh->GetPointData()->GetArray("VertexKind");
  int ofInput = 0;
  double farthest = 0.0;
  for (vtkIdType point = 0; point < mesh->GetNumberOfPoints(); ++point)
  {
    const double* place = mesh->GetPoint(point);
    ofInput += originals->GetTuple1(point) >= 0.0 ? 1 : 0;
    EXPECT_EQ(originals->GetTuple1(point) >= 0.0, kinds->GetTuple1(point) == 0.0);
    if (kinds->GetTuple1(point) == 1.0)
    {
      const double offNorth =
        Metres * std::min(std::abs(place[1] - 60.0), std::abs(place[1] - 70.0));
      const double offEast = Metres * std::cos(place[1] * Degree) *
        std::min(std::abs(place[0] + 10.0), std::abs(place[0] - 30.0));
      farthest = std::max(farthest, std::min(offNorth, offEast));
    }
  }
  EXPECT_EQ(ofInput, 4);
  EXPECT_LT(farthest, 0.03 * Spacing);
  // Straight in the plane, as a line of the stereographic map.
  mesher->PreserveBoundaryOn();
  mesher->Update();
  EXPECT_EQ(mesher->GetOutput(1)->GetNumberOfCells(), 4);
}

TEST(BitingMesherGlobe, DividedLinesDoNotMakeTheMeshFiner)
{
  for (const double spacing : { 20e3, 60e3, 120e3 })
  {
    const auto drawing = EmptyInput();
    AddChain(drawing, Rectangle(-20.0, 60.0, 20.0, 75.0), true);
    const auto mesher = OnGlobe(drawing, spacing);
    mesher->Update();
    const GlobeMeasures own = Judge(mesher->GetOutput());
    EXPECT_NEAR(own.MeanLength, 1.0, 0.02) << spacing;
    EXPECT_GT(own.MeanAngle, 49.0) << spacing;
  }
}

TEST(BitingMesherGlobe, SourcesAreInDegreesAndMetres)
{
  // f = 10 km + 200 m a degree of latitude, on the whole globe: with a seam and two poles.
  for (const int step : { 1, 10 })
  {
    for (const Place& middle :
      { Place{ 0.0, 20.0, 0.0 }, Place{ 180.0, 70.0, 0.0 }, Place{ 0.0, 90.0, 0.0 } })
    {
      const auto mesher = OnGlobe(Bay(middle, 600e3), 0.0);
      mesher->SetSpacingSourceData(ByLatitude(step, 10e3, 200.0));
      mesher->LimitByFeatureSizeOff();
      const Messages messages(mesher);
      mesher->Update();
      EXPECT_TRUE(messages.Errors.empty() && messages.Warnings.empty());
      vtkPolyData* mesh = mesher->GetOutput();
      EXPECT_NEAR(Judge(mesh).MeanLength, 1.0, 0.025); // vertices of the shore are near each other
      vtkDataArray* spacing = mesh->GetPointData()->GetArray("Spacing");
      vtkDataArray* kinds = mesh->GetPointData()->GetArray("VertexKind");
      double worst = 0.0;
      for (vtkIdType point = 0; point < mesh->GetNumberOfPoints(); ++point)
      {
        const double wanted = 10e3 + 200.0 * std::abs(mesh->GetPoint(point)[1]);
        const double error = std::abs(spacing->GetTuple1(point) / wanted - 1.0);
        worst = kinds->GetTuple1(point) == 2.0 ? std::max(worst, error) : worst;
      }
      EXPECT_LT(worst, 0.02) << step << " " << middle[1];
    }
  }
}

TEST(BitingMesherGlobe, BoundaryValuesAndBoundsAreInMetres)
{
  const auto drawing = Bay({ 0.0, 80.0, 0.0 }, 2000e3);
  AddArray<vtkDoubleArray>(drawing->GetPointData(), "Spacing",
    std::vector<double>(static_cast<std::size_t>(drawing->GetNumberOfPoints()), 80e3));
  const auto mesher = OnGlobe(drawing, 0.0);
  mesher->SetGradation(0.2);
  mesher->LimitByFeatureSizeOff();
  mesher->SetMaximumSpacing(120e3);
  mesher->Update();
  vtkDataArray* spacing = mesher->GetOutput()->GetPointData()->GetArray("Spacing");
  double range[2];
  spacing->GetRange(range);
  EXPECT_NEAR(range[0], 80e3, 1.5e3);
  EXPECT_NEAR(range[1], 120e3, 1e-6);
  EXPECT_NEAR(Judge(mesher->GetOutput()).MeanLength, 1.0, 0.02);
}

TEST(BitingMesherGlobe, SeamsAndPolesAreOnePlace)
{
  // Two boxes that meet along the 180th meridian, given from both sides, and two at the pole.
  for (const double north : { 10.0, 90.0 })
  {
    const auto drawing = EmptyInput();
    for (const auto& box : { Rectangle(170.0, north - 10.0, 180.0, north),
           Rectangle(-180.0, north - 10.0, -170.0, north) })
    {
      AddChain(drawing, box, true);
    }
    // As cells: what they share is no boundary.
    const auto cells = EmptyInput();
    cells->SetPoints(drawing->GetPoints());
    cells->GetPolys()->InsertNextCell({ 0, 1, 2, 3 });
    cells->GetPolys()->InsertNextCell({ 4, 5, 6, 7 });
    const auto mesher = OnGlobe(cells, 50e3);
    mesher->Update();
    const double exact = Radius * Radius * 20.0 * Degree *
      (std::sin(north * Degree) - std::sin((north - 10.0) * Degree));
    EXPECT_NEAR(Judge(mesher->GetOutput()).Area, exact, 2e-3 * exact); // 0.01 f
    EXPECT_LT(LargestJump(mesher->GetOutput()), 30.0);
    double regions[2];
    mesher->GetOutput()->GetCellData()->GetArray("RegionId")->GetRange(regions);
    EXPECT_EQ(regions[1], 0.0);
  }
}

TEST(BitingMesherGlobe, WhatIsNotOnTheGlobeIsRefused)
{
  const auto high = EmptyInput();
  AddChain(high, Rectangle(0.0, 80.0, 10.0, 91.0), true);
  const auto mesher = OnGlobe(high, 50e3);
  {
    const Messages messages(mesher);
    mesher->Update();
    ASSERT_EQ(messages.Errors.size(), 1U);
    EXPECT_NE(messages.Errors.front().find("point 2 at (10, 91, 0)"), std::string::npos);
    EXPECT_EQ(mesher->GetOutput()->GetNumberOfPoints(), 0);
  }
  const auto wide = EmptyInput();
  for (const auto& box : { Rectangle(-1.0, -1.0, 1.0, 1.0), Rectangle(179.0, -1.0, 181.0, 1.0),
         Rectangle(0.0, 85.0, 10.0, 89.0), Rectangle(0.0, -89.0, 10.0, -85.0) })
  {
    AddChain(wide, box, true);
  }
  mesher->SetInputData(wide);
  const Messages messages(mesher);
  mesher->Update();
  ASSERT_EQ(messages.Errors.size(), 1U);
  EXPECT_NE(messages.Errors.front().find("170 degrees"), std::string::npos);
}

TEST(BitingMesherGlobe, ABeltAroundTheGlobeIsMeshedFromAPole)
{
  const auto drawing = EmptyInput();
  for (const double latitude : { -20.0, 20.0 })
  {
    std::vector<Place> parallel;
    for (int k = 0; k < 36; ++k)
    {
      parallel.push_back({ -180.0 + 10.0 * k, latitude, 0.0 });
    }
    AddChain(drawing, parallel, true);
  }
  const auto mesher = OnGlobe(drawing, 300e3);
  mesher->Update();
  const GlobeMeasures own = Judge(mesher->GetOutput());
  const double exact = Radius * Radius * 720.0 * Degree * std::sin(20.0 * Degree);
  EXPECT_NEAR(own.Area, exact, 2e-3 * exact);
  EXPECT_NEAR(own.MeanLength, 1.0, 0.02);
}

TEST(BitingMesherGlobe, TheMeshDoesNotDependOnThreadsNorOnTheOrderOfPoints)
{
  const auto mesher = OnGlobe(Bay({ 180.0, 70.0, 0.0 }), 3e3);
  mesher->SetVerticesPerBlock(4000);
  mesher->SetNumberOfThreads(1);
  mesher->Update();
  vtkNew<vtkPolyData> one;
  one->DeepCopy(mesher->GetOutput());
  mesher->SetNumberOfThreads(3);
  mesher->Update();
  ASSERT_EQ(one->GetNumberOfPoints(), mesher->GetOutput()->GetNumberOfPoints());
  for (vtkIdType point = 0; point < one->GetNumberOfPoints(); ++point)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      ASSERT_EQ(one->GetPoint(point)[axis], mesher->GetOutput()->GetPoint(point)[axis]);
    }
  }
}

TEST(BitingMesherGlobe, RemeshingAndJudgingAgree)
{
  const auto mesher = OnGlobe(Bay({ 180.0, 70.0, 0.0 }), 20e3);
  mesher->Update();
  vtkNew<vtkMeshConformity> conformity;
  conformity->SetInputData(mesher->GetOutput());
  conformity->SetCoordinatesToLongitudeLatitude();
  conformity->SetInputArrayToProcess(0, 0, 0, PointArrays, "Spacing");
  conformity->Update();
  auto* judged = vtkPolyData::SafeDownCast(conformity->GetOutputDataObject(0));
  for (const char* name : { "Spacing", "NearestNeighborDistance", "Conformity" })
  {
    vtkDataArray* own = mesher->GetOutput()->GetPointData()->GetArray(name);
    vtkDataArray* other = judged->GetPointData()->GetArray(name);
    for (vtkIdType point = 0; point < own->GetNumberOfTuples(); ++point)
    {
      // The middles of mesh and drawing differ.
      ASSERT_NEAR(other->GetTuple1(point), own->GetTuple1(point), 1e-3 * own->GetTuple1(point));
    }
  }
  vtkNew<vtkBitingRemesher> remesher;
  remesher->SetInputData(mesher->GetOutput());
  remesher->SetCoordinatesToLongitudeLatitude();
  remesher->SetUniformSpacing(10e3);
  remesher->Update();
  const GlobeMeasures finer = Judge(remesher->GetOutput());
  EXPECT_NEAR(finer.MeanLength, 1.06, 0.02); // as in a plane: old vertices stay
  EXPECT_NEAR(finer.Area, Judge(mesher->GetOutput()).Area, 1e-3 * finer.Area);
  EXPECT_LT(LargestJump(remesher->GetOutput()), 10.0);
}

TEST(BitingMesherGlobe, TheHessianIsInMetres)
{
  // u = 1 - cos c at the angle c from (180, 70): it bends by cos(c) / R^2 along meridians of that
  // place.
  const Place middle{ 180.0, 70.0, 0.0 };
  const auto mesher = OnGlobe(Bay(middle), 20e3);
  mesher->Update();
  vtkNew<vtkPolyData> mesh;
  mesh->ShallowCopy(mesher->GetOutput());
  std::vector<double> values;
  for (vtkIdType point = 0; point < mesh->GetNumberOfPoints(); ++point)
  {
    values.push_back(1.0 - std::cos(GreatCircle(middle.data(), mesh->GetPoint(point)) / Radius));
  }
  AddArray<vtkDoubleArray>(mesh->GetPointData(), "u", values);
  vtkNew<vtkHessianSpacing> hessian;
  hessian->SetInputData(mesh);
  hessian->SetCoordinatesToLongitudeLatitude();
  hessian->SetInputArrayToProcess(0, 0, 0, PointArrays, "u");
  hessian->SetErrorTolerance(1e-4);
  hessian->Update();
  auto* output = vtkPolyData::SafeDownCast(hessian->GetOutputDataObject(0));
  double range[2];
  output->GetPointData()->GetArray("Spacing")->GetRange(range);
  EXPECT_NEAR(range[0], 1e-2 * Radius, 0.03e-2 * Radius);
  EXPECT_NEAR(range[1], 1e-2 * Radius, 0.03e-2 * Radius);
}
