// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "MeasuredMesh.h"

#include "../../Kernel/Quality/Histogram.h"
#include "../Data/ArrayFromVector.h"
#include "QualityArrays.h"

#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkPointData.h"
#include "vtkTable.h"

#include <limits> // for NaN
#include <string> // for names

namespace biting
{

namespace
{

constexpr double HighestAngle = 180.0;
constexpr double HighestConformity = 1.0;
constexpr double HighestRelativeLength = 3.0;

// `values` of the things with these ids, as one value for each of `size` things; NaN for the
// others.
std::vector<double> Spread(
  const std::vector<double>& values, const std::vector<vtkIdType>& ids, vtkIdType size)
{
  std::vector<double> all(static_cast<std::size_t>(size), std::numeric_limits<double>::quiet_NaN());
  for (std::size_t k = 0; k < ids.size(); ++k)
  {
    all[static_cast<std::size_t>(ids[k])] = values[k];
  }
  return all;
}

void AddHistogram(const Histogram& histogram, const std::string& name, vtkTable* table)
{
  AddArray<vtkDoubleArray>(table->GetRowData(), name.c_str(), histogram.Centers);
  AddArray<vtkDoubleArray>(table->GetRowData(), (name + "Percent").c_str(), histogram.Percents);
}

} // namespace

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
  AddHistogram(MakeHistogram(mesh.Angles, 0.0, HighestAngle, bins), "Angle", output);
  if (mesh.HasSpacing)
  {
    AddHistogram(
      MakeHistogram(mesh.Quality.Conformity, 0.0, HighestConformity, bins), "Conformity", output);
    AddHistogram(MakeHistogram(mesh.RelativeLengths, 0.0, HighestRelativeLength, bins),
      "RelativeLength", output);
  }
}

} // namespace biting
