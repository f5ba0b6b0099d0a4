// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingWrittenParts_h
#define BitingWrittenParts_h

#include "../../vtkBitingCompat.h" // for the ABI namespace

#include "vtkType.h" // for ids

#include <vector> // for lists

VTK_ABI_NAMESPACE_BEGIN
class vtkDataSet;
VTK_ABI_NAMESPACE_END

namespace biting
{

/// What of a mesh goes into a file: all of it, or, where cells or points are hidden or another
/// piece's, each visible cell and each of their points once, in the order of their global ids. So
/// what several ranks have saved together is the mesh of one. Without these ids, or where two
/// visible cells have the same one, cells stay in their order; where points at different places
/// have the same one, all points of these cells are written.
class WrittenParts
{
public:
  explicit WrittenParts(vtkDataSet* mesh);

  /// Points and cells of the mesh, in the order of the file.
  const std::vector<vtkIdType>& Points() const { return this->PointIds; }
  const std::vector<vtkIdType>& Cells() const { return this->CellIds; }

  /// The number in the file of a point of the mesh; -1 where it is not written.
  vtkIdType NumberOf(vtkIdType point) const
  {
    return this->Numbers[static_cast<std::size_t>(point)];
  }

private:
  void ListCells(vtkDataSet* mesh);
  void ListPointsOfCells(vtkDataSet* mesh);

  std::vector<vtkIdType> PointIds;
  std::vector<vtkIdType> CellIds;
  std::vector<vtkIdType> Numbers;
};

} // namespace biting

#endif
