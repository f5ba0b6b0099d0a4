// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingGhostArrays_h
#define BitingGhostArrays_h

#include "../../vtkBitingCompat.h" // for the ABI namespace

#include "vtkDataSetAttributes.h" // for flags

VTK_ABI_NAMESPACE_BEGIN
class vtkDataSet;
class vtkUnsignedCharArray;
VTK_ABI_NAMESPACE_END

namespace biting
{

/// Cells that are hidden, that another piece has, or that finer ones stand for.
constexpr int CellsNotHere = vtkDataSetAttributes::HIDDENCELL |
  vtkDataSetAttributes::DUPLICATECELL | vtkDataSetAttributes::REFINEDCELL;

/// The ghost array of points or cells; null where there is none. One of another type, or with fewer
/// values than there are points or cells, is none.
vtkUnsignedCharArray* GhostsOf(vtkDataSet* data, int association);

/// What the ghost arrays of a dataset say of its cells.
class GhostArrays
{
public:
  explicit GhostArrays(vtkDataSet* data);

  /// Whether a cell is not here, or has a hidden point.
  bool LeaveOut(vtkIdType cell, vtkIdType size, const vtkIdType* points) const;

private:
  vtkUnsignedCharArray* OfCells;
  vtkUnsignedCharArray* OfPoints;
};

/// Whether the ghost array of points or cells, if there is one, has one of `flags`.
bool HasGhosts(vtkDataSet* data, int association, int flags);

/// Of pieces that are one now duplicates are gone; ghost arrays stay where they say more than that.
void ForgetDuplicates(vtkDataSet* whole);

} // namespace biting

#endif
