// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingCellShapes_h
#define BitingCellShapes_h

#include "vtkType.h" // for vtkIdType

#include <string> // for what is said
#include <vector> // for outlines

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

/// Says that a cell of `what` refers to a point that does not exist; empty where all of its `size`
/// points do.
std::string MissingPointText(const char* what, vtkIdType cell, vtkIdType size,
  const vtkIdType* points, vtkIdType numberOfPoints);

} // namespace biting

#endif
