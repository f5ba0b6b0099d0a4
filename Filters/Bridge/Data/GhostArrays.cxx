// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "GhostArrays.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm> // for any_of

namespace biting
{

namespace
{

bool HasFlag(vtkUnsignedCharArray* ghosts, vtkIdType item, int flags)
{
  return ghosts && (ghosts->GetValue(item) & flags) != 0;
}

} // namespace

vtkUnsignedCharArray* GhostsOf(vtkDataSet* data, int association)
{
  auto* ghosts = vtkUnsignedCharArray::SafeDownCast(
    data->GetAttributes(association)->GetArray(vtkDataSetAttributes::GhostArrayName()));
  const bool isOfAll = ghosts && ghosts->GetNumberOfComponents() == 1 &&
    ghosts->GetNumberOfTuples() >= data->GetNumberOfElements(association);
  return isOfAll ? ghosts : nullptr;
}

GhostArrays::GhostArrays(vtkDataSet* data)
  : OfCells(GhostsOf(data, vtkDataObject::CELL))
  , OfPoints(GhostsOf(data, vtkDataObject::POINT))
{
}

bool GhostArrays::LeaveOut(vtkIdType cell, vtkIdType size, const vtkIdType* points) const
{
  return HasFlag(this->OfCells, cell, CellsNotHere) ||
    (this->OfPoints &&
      std::any_of(points, points + size,
        [this](vtkIdType point)
        { return HasFlag(this->OfPoints, point, vtkDataSetAttributes::HIDDENPOINT); }));
}

bool HasGhosts(vtkDataSet* data, int association, int flags)
{
  vtkUnsignedCharArray* ghosts = GhostsOf(data, association);
  const vtkIdType size = ghosts ? ghosts->GetNumberOfTuples() : 0;
  bool isAny = false;
  for (vtkIdType item = 0; item < size && !isAny; ++item)
  {
    isAny = HasFlag(ghosts, item, flags);
  }
  return isAny;
}

void ForgetDuplicates(vtkDataSet* whole)
{
  // The flag of points has the same value.
  constexpr unsigned char Kept = static_cast<unsigned char>(~vtkDataSetAttributes::DUPLICATECELL);
  for (const int association : { vtkDataObject::POINT, vtkDataObject::CELL })
  {
    vtkUnsignedCharArray* ghosts = GhostsOf(whole, association);
    const vtkIdType size = ghosts ? ghosts->GetNumberOfTuples() : 0;
    for (vtkIdType item = 0; item < size; ++item)
    {
      ghosts->SetValue(item, ghosts->GetValue(item) & Kept);
    }
    if (!HasGhosts(whole, association, Kept))
    {
      whole->GetAttributes(association)->RemoveArray(vtkDataSetAttributes::GhostArrayName());
    }
  }
}

} // namespace biting
