// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingMeasuredTetrahedra_h
#define BitingMeasuredTetrahedra_h

#include "../../Kernel/Base/Monitor.h"
#include "../../Kernel/Space/Quality/TetQuality.h"
#include "../../vtkBitingCompat.h" // for the ABI namespace

#include "vtkType.h" // for vtkIdType

#include <string> // for the refusal
#include <vector> // for the arrays

VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;
class vtkDataSet;
class vtkTable;
VTK_ABI_NAMESPACE_END

namespace biting
{

/// The tetrahedra of a grid, and what they are worth.
struct MeasuredTetrahedra
{
  std::vector<Point3> Points;   ///< all of the grid
  std::vector<double> Spacing;  ///< of each point; empty without one
  std::vector<vtkIdType> Cells; ///< of each tetrahedron; not needed where all cells are some
  std::vector<Id> Corners;
  TetQuality Quality;

  /// Whether `data` has a cell of three dimensions: then it is a mesh of space.
  static bool AreIn(vtkDataSet* data);

  /// Reads linear tetrahedra; passes over cells of less than three dimensions, hidden and ghost
  /// cells. `spacing` may be null. Returns why it cannot: another cell of three dimensions, ids
  /// beyond 32 bits or of no point, coordinates or a spacing at a corner that cannot be used.
  std::string Read(vtkDataSet* data, vtkDataArray* spacing, Monitor& monitor);

  /// Adds the measures to the grid that was read, as arrays and figures. The memory of those of
  /// tetrahedra is given back.
  void Write(vtkDataSet* output);

  /// How they are spread.
  void WriteHistograms(int bins, vtkTable* histograms) const;

  /// In a few lines.
  std::string Summary() const;
};

} // namespace biting

#endif
