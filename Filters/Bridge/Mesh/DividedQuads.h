// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingDividedQuads_h
#define BitingDividedQuads_h

#include "../../vtkBitingCompat.h" // for the ABI namespace

#include "vtkSmartPointer.h" // for datasets
#include "vtkType.h"         // for ids

#include <string> // for the remark
#include <vector> // for ids

VTK_ABI_NAMESPACE_BEGIN
class vtkDataSet;
class vtkPolyData;
VTK_ABI_NAMESPACE_END

namespace biting
{

/// A poly data or unstructured grid with two triangles in place of each linear quad
/// (Quality/QuadDiagonal.h), and its arrays, without global ids of cells. Quads whose sides cross,
/// without area, or of points that do not exist stay. Data without quads is not copied.
class DividedQuads
{
public:
  DividedQuads() = default;
  explicit DividedQuads(vtkDataSet* data);

  vtkDataSet* Data() const { return this->Whole; }

  /// A sentence for the user; empty where no quad is divided.
  std::string Remark() const;

  /// Replaces the ids in the cell array `OriginalCellId` of `output` by those of the given
  /// dataset. The output, and the array, may be missing.
  void RestoreIds(vtkDataSet* output) const;

private:
  void Divide(vtkDataSet* data);

  vtkSmartPointer<vtkDataSet> Whole;
  std::vector<vtkIdType> Cells; // the given cell of each; empty where no quad is divided
  vtkIdType Count = 0;
};

} // namespace biting

#endif
