// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingCellShapes_h
#define BitingCellShapes_h

#include "../../Kernel/Base/Pulse.h"
#include "../../vtkBitingCompat.h" // for the ABI namespace

#include "vtkType.h" // for vtkIdType

#include <functional> // for what is done with cells
#include <string>     // for what is said
#include <vector>     // for outlines

VTK_ABI_NAMESPACE_BEGIN
class vtkDataSet;
VTK_ABI_NAMESPACE_END

namespace biting
{

/// What a cell of VTK is in a drawing.
enum class CellShape
{
  Nothing, ///< an empty cell
  Points,  ///< vertices
  Line,    ///< a chain
  Face,    ///< an outline
  Strip,   ///< a strip of triangles
  Volume,  ///< of three dimensions
  Curved   ///< of a kind whose points do not say where it runs
};
CellShape ShapeOf(int cellType);

/// The points of a line from end to end, or those around a face, of the `size` points of a cell.
/// Those of quadratic and cubic cells are joined by straight segments, and points within a face are
/// left out.
void PointsAlong(
  int cellType, vtkIdType size, const vtkIdType* points, std::vector<vtkIdType>& along);

/// A cell of a dataset.
struct SeenCell
{
  vtkIdType Id = 0;
  int Type = 0; ///< in polydata VTK_POLY_VERTEX, VTK_POLY_LINE, VTK_POLYGON or VTK_TRIANGLE_STRIP
  vtkIdType Size = 0;
  const vtkIdType* Points = nullptr;
};

/// Visits the cells of `data` in their order, until the visit of one returns a refusal, which is
/// returned, or the pulse stops. Changes nothing of the data.
std::string VisitCells(
  vtkDataSet* data, const std::function<std::string(const SeenCell&)>& visit, Pulse& pulse);

/// Says that a cell of `what` refers to a point that does not exist; empty where all of its `size`
/// points do.
std::string MissingPointText(const char* what, vtkIdType cell, vtkIdType size,
  const vtkIdType* points, vtkIdType numberOfPoints);

} // namespace biting

#endif
