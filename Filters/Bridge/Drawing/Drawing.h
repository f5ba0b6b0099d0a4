// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingDrawing_h
#define BitingDrawing_h

#include "vtkDataSet.h"      // for the points
#include "vtkFieldData.h"    // for arrays
#include "vtkSmartPointer.h" // for datasets

#include <string> // for names
#include <vector> // for blocks

namespace biting
{

/// One dataset of a drawing. Its first point has the number FirstPoint, its first cell FirstCell.
struct DrawingBlock
{
  vtkSmartPointer<vtkDataSet> Data;
  std::string Name; ///< of the nearest block around it that has one
  vtkIdType FirstPoint = 0;
  vtkIdType FirstCell = 0;
};

/// Port 0 as one drawing: a dataset, or all datasets of a composite one after the other, in the
/// order of its tree.
///
/// The arrays of several blocks are put together by name, made alike as by MakeArraysAlike. Nothing
/// of the blocks is changed.
struct Drawing
{
  std::vector<DrawingBlock> Blocks;
  vtkSmartPointer<vtkDataSet> Points;       ///< all points, with their arrays
  vtkSmartPointer<vtkFieldData> CellArrays; ///< of all cells; of blocks with `BlockName`
  vtkIdType NumberOfPoints = 0;
  vtkIdType NumberOfCells = 0;

  /// For each point, 1 where its block has the point array `name`; empty where all have.
  std::vector<unsigned char> FindGiven(const char* name) const;

  /// The coarsest type that coordinates of a block have in VTK, as VTK_FLOAT.
  int CoordinateType() const;
};

/// Reads a dataset, or all datasets of a composite one; of other data objects nothing.
Drawing ReadDrawing(vtkDataObject* input);

} // namespace biting

#endif
