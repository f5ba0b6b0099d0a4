// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "QualityArrays.h"

#include "../Data/ArrayFromVector.h"

namespace biting
{

void AddConformityArrays(
  const MeshQuality& quality, const std::vector<double>& spacing, vtkFieldData* data, Pulse& pulse)
{
  AddArray<vtkDoubleArray>(data, "Spacing", spacing, pulse);
  AddArray<vtkDoubleArray>(data, "NearestNeighborDistance", quality.NearestNeighborDistance, pulse);
  AddArray<vtkDoubleArray>(data, "Conformity", quality.Conformity, pulse);
}

void AddShapeArrays(const MeshQuality& quality, vtkFieldData* data, Pulse& pulse)
{
  AddArray<vtkDoubleArray>(data, "MinimumAngle", quality.MinimumAngle, pulse);
  AddArray<vtkDoubleArray>(data, "RadiusEdgeRatio", quality.RadiusEdgeRatio, pulse);
  AddArray<vtkDoubleArray>(data, "AspectRatio", quality.AspectRatio, pulse);
}

void AddShapeSummary(const MeshQuality& quality, vtkFieldData* data)
{
  AddCount(data, "NumberOfVertices", quality.NumberOfVertices);
  AddCount(data, "NumberOfTriangles", quality.NumberOfTriangles);
  AddFigure(data, "SmallestAngle", quality.SmallestAngle);
  AddFigure(data, "LargestRadiusEdgeRatio", quality.LargestRadiusEdgeRatio);
}

void AddConformitySummary(const MeshQuality& quality, vtkFieldData* data)
{
  AddFigure(data, "SmallestConformity", quality.SmallestConformity);
  AddFigure(data, "MeanConformity", quality.MeanConformity);
  AddFigure(data, "MeanRelativeLength", quality.MeanRelativeLength);
  AddFigure(data, "ShareOfEdgesInBand", quality.ShareOfEdgesInBand);
}

} // namespace biting
