// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "MeasuredTetrahedra.h"

#include "../../Kernel/Base/Problem.h"
#include "../../Kernel/Base/Pulse.h"
#include "../Data/ArrayFromVector.h"
#include "../Data/Arrays.h"
#include "../Data/Cells.h"
#include "MeasuredMesh.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkCellTypes.h"
#include "vtkDataSet.h"
#include "vtkIdList.h"
#include "vtkPointData.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>  // for isfinite
#include <limits> // for NaN

namespace biting
{

namespace
{

constexpr double Unmeasured = std::numeric_limits<double>::quiet_NaN();

} // namespace

bool MeasuredTetrahedra::AreIn(vtkDataSet* data)
{
  auto* grid = vtkUnstructuredGrid::SafeDownCast(data);
  vtkIdType cell = grid ? grid->GetNumberOfCells() : 0;
  while (cell > 0 && grid->GetCellType(cell - 1) != VTK_TETRA)
  {
    --cell;
  }
  return cell > 0;
}

std::string MeasuredTetrahedra::Read(vtkDataSet* data, vtkDataArray* spacing, Monitor& monitor)
{
  constexpr vtkIdType Limit = std::numeric_limits<Id>::max();
  const vtkIdType numberOfPoints = data->GetNumberOfPoints();
  if (numberOfPoints > Limit || data->GetNumberOfCells() > Limit / 4)
  {
    return "The input has more points or cells than 32-bit ids can number.";
  }
  Pulse pulse(monitor);
  const auto coordinates = CoordinatesOf(data);
  this->Points.resize(static_cast<std::size_t>(numberOfPoints));
  for (std::size_t point = 0; point < this->Points.size(); ++point)
  {
    coordinates->GetTuple(static_cast<vtkIdType>(point), this->Points[point].Data());
  }
  if (spacing)
  {
    this->Spacing = ReadDoubles(spacing, numberOfPoints);
  }
  const GhostArrays ghosts(data);
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells() && pulse.Beat(); ++cell)
  {
    const int type = data->GetCellType(cell);
    data->GetCellPoints(cell, corners);
    const vtkIdType size = corners->GetNumberOfIds();
    const std::string missing =
      MissingPointText("the input", cell, size, corners->GetPointer(0), numberOfPoints);
    if (!missing.empty() || (type != VTK_TETRA && ShapeOf(type) == CellShape::Volume))
    {
      return !missing.empty()
        ? missing
        : "Cell " + std::to_string(cell) + " is a " + vtkCellTypes::GetClassNameFromTypeId(type) +
          "; of the cells of three dimensions only linear tetrahedra are measured (apply "
          "Tetrahedralize before it).";
    }
    if (type != VTK_TETRA || ghosts.LeaveOut(cell, size, corners->GetPointer(0)))
    {
      continue;
    }
    this->Cells.push_back(cell);
    for (const vtkIdType corner : *corners)
    {
      const bool isPlace = AreFinite(this->Points[corner].Data());
      const bool isSize = this->Spacing.empty() ||
        (std::isfinite(this->Spacing[corner]) && this->Spacing[corner] > 0.0);
      if (!isPlace || !isSize)
      {
        return std::string(isPlace ? "The spacing is not positive and finite"
                                   : "Coordinates that are not finite") +
          " at point " + std::to_string(corner) + ".";
      }
      this->Corners.push_back(static_cast<Id>(corner));
    }
  }
  return {};
}

void MeasuredTetrahedra::Write(vtkDataSet* output)
{
  TetQuality& quality = this->Quality;
  const auto addOfCells = [this, output](const char* name, std::vector<double>& values)
  {
    if (static_cast<vtkIdType>(values.size()) != output->GetNumberOfCells())
    {
      values = Spread(values, this->Cells, output->GetNumberOfCells());
    }
    AddArray<vtkDoubleArray>(output->GetCellData(), name, values);
    std::vector<double>().swap(values);
  };
  addOfCells("MinimumDihedralAngle", quality.MinimumDihedralAngle);
  addOfCells("MaximumDihedralAngle", quality.MaximumDihedralAngle);
  addOfCells("RadiusEdgeRatio", quality.RadiusEdgeRatio);
  addOfCells("AspectRatio", quality.AspectRatio);
  output->GetCellData()->SetActiveScalars("MinimumDihedralAngle");
  std::vector<double> distances = quality.NearestNeighborDistance;
  for (double& distance : distances)
  {
    distance = std::isfinite(distance) ? distance : Unmeasured;
  }
  AddArray<vtkDoubleArray>(output->GetPointData(), "NearestNeighborDistance", distances);
  vtkFieldData* figures = output->GetFieldData();
  AddCount(figures, "NumberOfVertices", quality.NumberOfVertices);
  AddCount(figures, "NumberOfTetrahedra", static_cast<std::int64_t>(this->Corners.size() / 4));
  AddCount(figures, "NumberOfSlivers", quality.NumberOfSlivers);
  AddFigure(figures, "SmallestDihedralAngle", quality.SmallestDihedralAngle);
  AddFigure(figures, "LargestDihedralAngle", quality.LargestDihedralAngle);
  AddFigure(figures, "LargestRadiusEdgeRatio", quality.LargestRadiusEdgeRatio);
  if (!this->Spacing.empty())
  {
    AddArray<vtkDoubleArray>(output->GetPointData(), "Spacing", this->Spacing);
    AddArray<vtkDoubleArray>(output->GetPointData(), "Conformity", quality.Conformity);
    AddFigure(figures, "SmallestConformity", quality.SmallestConformity);
    AddFigure(figures, "MeanConformity", quality.MeanConformity);
    AddFigure(figures, "MeanRelativeLength", quality.MeanRelativeLength);
    AddFigure(figures, "ShareOfEdgesInBand", quality.ShareOfEdgesInBand);
  }
}

void MeasuredTetrahedra::WriteHistograms(int bins, vtkTable* histograms) const
{
  constexpr double HighestDihedral = 180.0;
  AddHistogram(this->Quality.DihedralAngles, HighestDihedral, bins, "DihedralAngle", histograms);
  if (!this->Spacing.empty())
  {
    constexpr double HighestLength = 3.0;
    AddHistogram(this->Quality.Conformity, 1.0, bins, "Conformity", histograms);
    AddHistogram(this->Quality.RelativeLengths, HighestLength, bins, "RelativeLength", histograms);
  }
}

std::string MeasuredTetrahedra::Summary() const
{
  const TetQuality& quality = this->Quality;
  return std::to_string(quality.NumberOfVertices) + " vertices, " +
    std::to_string(this->Corners.size() / 4) + " tetrahedra\nDihedral angles " +
    Figure(quality.SmallestDihedralAngle) + " to " + Figure(quality.LargestDihedralAngle) +
    " degrees\nSlivers: " + std::to_string(quality.NumberOfSlivers) + "\n" +
    (this->Spacing.empty() ? ""
                           : "Mean conformity " + Figure(quality.MeanConformity) +
          " (best: 1)\nMean length of edges " + Figure(quality.MeanRelativeLength) + " spacings\n");
}

} // namespace biting
