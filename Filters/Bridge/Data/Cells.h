// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingCells_h
#define BitingCells_h

#include "../../Kernel/Base/Pulse.h"
#include "../../vtkBitingCompat.h" // for the ABI namespace

#include "vtkDataSetAttributes.h" // for flags
#include "vtkType.h"              // for vtkIdType

#include <functional> // for what is done with cells
#include <string>     // for what is said
#include <vector>     // for outlines

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

/// The ghost arrays of a dataset.
class GhostArrays
{
public:
  /// `notHere`: flags of cells to leave out.
  explicit GhostArrays(vtkDataSet* data, int notHere = CellsNotHere);

  bool IsHidden(vtkIdType point) const;

  /// Whether a cell is not here, or has a hidden point.
  bool LeaveOut(vtkIdType cell, vtkIdType size, const vtkIdType* points) const;

private:
  vtkUnsignedCharArray* OfCells;
  vtkUnsignedCharArray* OfPoints;
  int NotHere;
};

/// Whether the ghost array of points or cells, if there is one, has one of `flags`.
bool HasGhosts(vtkDataSet* data, int association, int flags);

/// Of pieces that are one now duplicates are gone; ghost arrays stay where they say more than that.
void ForgetDuplicates(vtkDataSet* whole);

/// The part that a cell of VTK plays in a drawing.
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

/// Orders the `size` points of a cell: of a line from end to end, of a face around it. Quadratic
/// and cubic cells become straight segments; points within a face are left out.
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
