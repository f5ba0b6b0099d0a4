// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "MeasuredMesh.h"

#include "../../Kernel/Predicates/Predicates.h"
#include "../../Kernel/Quality/Histogram.h"
#include "../Data/ArrayFromVector.h"
#include "../Run/ProblemReport.h"
#include "MeshToPolyData.h"

#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkPointData.h"
#include "vtkTable.h"

#include <algorithm> // for min, sort
#include <cstdint>   // for counts
#include <limits>    // for NaN
#include <numeric>   // for iota
#include <string>    // for names
#include <tuple>     // for keys

namespace biting
{

namespace
{

constexpr double HighestAngle = 180.0;
constexpr double HighestConformity = 1.0;
constexpr double HighestRelativeLength = 3.0;

/// Nothing where there are none.
void AddWarning(const char* what, const std::vector<Id>& triangles, const char* advice,
  const PlanarFaces& faces, std::vector<std::string>& warnings)
{
  if (triangles.empty())
  {
    return;
  }
  std::vector<std::string> first;
  for (std::size_t k = 0; k < std::min(triangles.size(), ShownIds); ++k)
  {
    const auto triangle = static_cast<std::size_t>(triangles[k]);
    first.push_back("cell " + std::to_string(faces.CellIds[triangle]) + " at " +
      PlaceText(faces.Frame.ToSpace(faces.Points[faces.Corners[3 * triangle]])));
  }
  const auto count = static_cast<std::int64_t>(triangles.size());
  warnings.push_back(std::string(what) + " (" + std::to_string(count) +
    "): " + ListText(first, count) + ". " + advice);
}

} // namespace

std::vector<double> Spread(
  const std::vector<double>& values, const std::vector<vtkIdType>& ids, vtkIdType size)
{
  std::vector<double> all(static_cast<std::size_t>(size), std::numeric_limits<double>::quiet_NaN());
  for (std::size_t k = 0; k < ids.size(); ++k)
  {
    all[ids[k]] = values[k];
  }
  return all;
}

void AddHistogram(const std::vector<double>& values, double highest, int bins,
  const std::string& name, vtkTable* table)
{
  const Histogram histogram = MakeHistogram(values, 0.0, highest, bins);
  AddArray<vtkDoubleArray>(table->GetRowData(), name.c_str(), histogram.Centers);
  AddArray<vtkDoubleArray>(table->GetRowData(), (name + "Percent").c_str(), histogram.Percents);
}

void WriteMeasures(const MeasuredMesh& mesh, vtkDataSet* input, vtkDataSet* output)
{
  output->ShallowCopy(input);
  const vtkIdType numberOfPoints = input->GetNumberOfPoints();
  const vtkIdType numberOfCells = input->GetNumberOfCells();
  MeshQuality all;
  for (const auto member : { &MeshQuality::NearestNeighborDistance, &MeshQuality::Conformity })
  {
    all.*member = Spread(mesh.Quality.*member, mesh.Faces.PointIds, numberOfPoints);
  }
  for (const auto member :
    { &MeshQuality::MinimumAngle, &MeshQuality::RadiusEdgeRatio, &MeshQuality::AspectRatio })
  {
    all.*member = Spread(mesh.Quality.*member, mesh.Faces.CellIds, numberOfCells);
  }
  Pulse pulse(NoMonitor());
  AddShapeArrays(all, output->GetCellData(), pulse);
  output->GetCellData()->SetActiveScalars("MinimumAngle");
  AddShapeSummary(mesh.Quality, output->GetFieldData());
  if (!mesh.HasSpacing)
  {
    AddArray<vtkDoubleArray>(
      output->GetPointData(), "NearestNeighborDistance", all.NearestNeighborDistance);
    return;
  }
  AddConformityArrays(
    all, Spread(mesh.Spacing, mesh.Faces.PointIds, numberOfPoints), output->GetPointData(), pulse);
  output->GetPointData()->SetActiveScalars("Conformity");
  AddConformitySummary(mesh.Quality, output->GetFieldData());
  AddFigure(output->GetFieldData(), "GivenLipschitz", mesh.GivenLipschitz);
  AddFigure(output->GetFieldData(), "UsedLipschitz", mesh.UsedLipschitz);
}

void WriteHistograms(const MeasuredMesh& mesh, int bins, vtkTable* output)
{
  AddHistogram(mesh.Angles, HighestAngle, bins, "Angle", output);
  if (mesh.HasSpacing)
  {
    AddHistogram(mesh.Quality.Conformity, HighestConformity, bins, "Conformity", output);
    AddHistogram(mesh.RelativeLengths, HighestRelativeLength, bins, "RelativeLength", output);
  }
}

std::vector<std::string> WarningsOfTriangles(const PlanarFaces& faces, const TriangleLinks& links)
{
  std::vector<Id> flat;
  std::vector<Id> turned[2]; // clockwise, counterclockwise
  for (std::size_t slot = 0; slot < faces.Corners.size(); slot += 3)
  {
    const auto place = [&faces, slot](std::size_t corner) -> const Point2&
    { return faces.Points[faces.Corners[slot + corner]]; };
    const int sign = Orient2D(place(0), place(1), place(2));
    (sign == 0 ? flat : turned[sign > 0 ? 1 : 0]).push_back(static_cast<Id>(slot / 3));
  }
  std::vector<std::string> warnings;
  AddWarning(
    "Triangles without area", flat, "They have the angle 0 and infinite ratios.", faces, warnings);
  AddWarning("Triangles oriented against the majority",
    turned[turned[1].size() < turned[0].size() ? 1 : 0],
    "The mesh may overlap itself there; they are measured as if turned.", faces, warnings);
  AddWarning("Edges of more than two triangles", links.Crowded, "The mesh is not a surface there.",
    faces, warnings);
  return warnings;
}

std::string WarningOfUnusedPoints(const PlanarFaces& faces, vtkIdType numberOfPoints)
{
  const vtkIdType unused = numberOfPoints - static_cast<vtkIdType>(faces.PointIds.size());
  return unused > 0
    ? "Points that no triangle uses (" + std::to_string(unused) + ") are not measured."
    : "";
}

std::string WarningOfRepeatedPoints(const PlanarFaces& faces)
{
  const std::vector<Point2>& points = faces.Points;
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{ 0 });
  const auto key = [&points](std::size_t k)
  { return std::make_tuple(points[k].X, points[k].Y, k); };
  std::sort(
    order.begin(), order.end(), [&key](std::size_t a, std::size_t b) { return key(a) < key(b); });
  std::size_t count = 0;
  std::size_t first = points.size();
  for (std::size_t k = 1; k < order.size(); ++k)
  {
    if (points[order[k]] == points[order[k - 1]])
    {
      ++count;
      first = std::min(first, order[k]);
    }
  }
  return count == 0 ? std::string()
                    : "Points at the place of others (" + std::to_string(count) + "): point " +
      std::to_string(faces.PointIds[first]) + " at " +
      PlaceText(faces.Frame.ToSpace(points[first])) +
      ". Triangles that only touch there share no edges; merge the points (Clean) if they are "
      "meant to be one.";
}

} // namespace biting
