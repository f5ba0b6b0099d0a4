// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Cells.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>        // for any_of
#include <initializer_list> // for orders
#include <utility>          // for pair

namespace biting
{

namespace
{

bool HasFlag(vtkUnsignedCharArray* ghosts, vtkIdType item, int flags)
{
  return ghosts && (ghosts->GetValue(item) & flags) != 0;
}

void Take(std::initializer_list<int> order, vtkIdType size, const vtkIdType* points,
  std::vector<vtkIdType>& along)
{
  for (const int place : order)
  {
    if (place < size)
    {
      along.push_back(points[place]);
    }
  }
}

// Corners come first, then one point of each side.
void TakeQuadraticPolygon(vtkIdType size, const vtkIdType* points, std::vector<vtkIdType>& along)
{
  const vtkIdType corners = size / 2;
  for (vtkIdType corner = 0; corner < corners; ++corner)
  {
    along.push_back(points[corner]);
    along.push_back(points[corners + corner]);
  }
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

GhostArrays::GhostArrays(vtkDataSet* data, int notHere)
  : OfCells(GhostsOf(data, vtkDataObject::CELL))
  , OfPoints(GhostsOf(data, vtkDataObject::POINT))
  , NotHere(notHere)
{
}

bool GhostArrays::IsHidden(vtkIdType point) const
{
  return HasFlag(this->OfPoints, point, vtkDataSetAttributes::HIDDENPOINT);
}

bool GhostArrays::LeaveOut(vtkIdType cell, vtkIdType size, const vtkIdType* points) const
{
  return HasFlag(this->OfCells, cell, this->NotHere) ||
    std::any_of(points, points + size, [this](vtkIdType point) { return this->IsHidden(point); });
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

CellShape ShapeOf(int cellType)
{
  switch (cellType)
  {
    case VTK_EMPTY_CELL:
      return CellShape::Nothing;
    case VTK_VERTEX:
    case VTK_POLY_VERTEX:
      return CellShape::Points;
    case VTK_LINE:
    case VTK_POLY_LINE:
    case VTK_QUADRATIC_EDGE:
    case VTK_CUBIC_LINE:
      return CellShape::Line;
    case VTK_TRIANGLE_STRIP:
      return CellShape::Strip;
    case VTK_TRIANGLE:
    case VTK_POLYGON:
    case VTK_PIXEL:
    case VTK_QUAD:
    case VTK_QUADRATIC_TRIANGLE:
    case VTK_QUADRATIC_QUAD:
    case VTK_QUADRATIC_POLYGON:
    case VTK_BIQUADRATIC_QUAD:
    case VTK_QUADRATIC_LINEAR_QUAD:
    case VTK_BIQUADRATIC_TRIANGLE:
      return CellShape::Face;
    case VTK_LAGRANGE_CURVE:
    case VTK_LAGRANGE_TRIANGLE:
    case VTK_LAGRANGE_QUADRILATERAL:
    case VTK_BEZIER_CURVE:
    case VTK_BEZIER_TRIANGLE:
    case VTK_BEZIER_QUADRILATERAL:
    case VTK_PARAMETRIC_CURVE:
    case VTK_PARAMETRIC_SURFACE:
    case VTK_PARAMETRIC_TRI_SURFACE:
    case VTK_PARAMETRIC_QUAD_SURFACE:
    case VTK_HIGHER_ORDER_EDGE:
    case VTK_HIGHER_ORDER_TRIANGLE:
    case VTK_HIGHER_ORDER_QUAD:
    case VTK_HIGHER_ORDER_POLYGON:
      return CellShape::Curved;
    default:
      return CellShape::Volume;
  }
}

void PointsAlong(
  int cellType, vtkIdType size, const vtkIdType* points, std::vector<vtkIdType>& along)
{
  along.clear();
  switch (cellType)
  {
    case VTK_PIXEL:
      return Take({ 0, 1, 3, 2 }, size, points, along);
    case VTK_QUADRATIC_EDGE:
      return Take({ 0, 2, 1 }, size, points, along);
    case VTK_CUBIC_LINE:
      return Take({ 0, 2, 3, 1 }, size, points, along);
    case VTK_QUADRATIC_TRIANGLE:
    case VTK_BIQUADRATIC_TRIANGLE:
      return Take({ 0, 3, 1, 4, 2, 5 }, size, points, along);
    case VTK_QUADRATIC_QUAD:
    case VTK_BIQUADRATIC_QUAD:
      return Take({ 0, 4, 1, 5, 2, 6, 3, 7 }, size, points, along);
    case VTK_QUADRATIC_LINEAR_QUAD:
      return Take({ 0, 4, 1, 2, 5, 3 }, size, points, along);
    case VTK_QUADRATIC_POLYGON:
      return TakeQuadraticPolygon(size, points, along);
    default:
      along.assign(points, points + size);
  }
}

// Polydata by its lists: asking it for a cell by its id would build something in it.
std::string VisitCells(
  vtkDataSet* data, const std::function<std::string(const SeenCell&)>& visit, Pulse& pulse)
{
  std::string refusal;
  vtkNew<vtkIdList> points;
  SeenCell seen;
  const auto visitSeen = [&refusal, &points, &seen, &visit]()
  {
    seen.Size = points->GetNumberOfIds();
    seen.Points = points->GetPointer(0);
    refusal = visit(seen);
    ++seen.Id;
  };
  if (auto* polyData = vtkPolyData::SafeDownCast(data))
  {
    const std::pair<vtkCellArray*, int> lists[] = { { polyData->GetVerts(), VTK_POLY_VERTEX },
      { polyData->GetLines(), VTK_POLY_LINE }, { polyData->GetPolys(), VTK_POLYGON },
      { polyData->GetStrips(), VTK_TRIANGLE_STRIP } };
    for (const auto& [cells, type] : lists)
    {
      seen.Type = type;
      const vtkIdType count = cells->GetNumberOfCells();
      for (vtkIdType k = 0; k < count && refusal.empty() && pulse.Beat(); ++k)
      {
        cells->GetCellAtId(k, points);
        visitSeen();
      }
    }
    return refusal;
  }
  while (seen.Id < data->GetNumberOfCells() && refusal.empty() && pulse.Beat())
  {
    data->GetCellPoints(seen.Id, points);
    seen.Type = data->GetCellType(seen.Id);
    visitSeen();
  }
  return refusal;
}

std::string MissingPointText(const char* what, vtkIdType cell, vtkIdType size,
  const vtkIdType* points, vtkIdType numberOfPoints)
{
  const vtkIdType* missing = std::find_if(points, points + size,
    [numberOfPoints](vtkIdType point) { return point < 0 || point >= numberOfPoints; });
  return missing == points + size ? ""
                                  : "Cell " + std::to_string(cell) + " of " + what +
      " refers to point " + std::to_string(*missing) + ", which does not exist.";
}

} // namespace biting
