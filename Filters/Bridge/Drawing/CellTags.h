// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingCellTags_h
#define BitingCellTags_h

#include "../../Kernel/Base/Ids.h"
#include "../../Kernel/Base/Pulse.h"
#include "../../Kernel/Domain/Polylines.h"
#include "Drawing.h"

#include "vtkType.h" // for vtkIdType

#include <array>      // for pairs
#include <functional> // for the comparison
#include <string>     // for the refusal
#include <vector>     // for numbers

VTK_ABI_NAMESPACE_BEGIN
class vtkAbstractArray;
class vtkFieldData;
VTK_ABI_NAMESPACE_END

namespace biting
{

/// Numbers the cells of the drawing: two cells have the same number where all components of the
/// cell array `name` are equal. NaN equals NaN, 0 equals -0. `numbers` is empty where `name` is
/// empty or "None". Returns a refusal where the drawing has no such array, or one that is too
/// short.
std::string FindRegionNumbers(
  const Drawing& drawing, const std::string& name, std::vector<Id>& numbers, Pulse& pulse);

/// Regions of space, and the values that they have in a cell array.
struct RegionValues
{
  vtkAbstractArray* Array = nullptr;    ///< of the drawing; null without regions
  std::vector<Id> Numbers;              ///< of cells, as by FindRegionNumbers
  bool IsPairs = false;                 ///< it has the values of both sides of a cell
  std::vector<std::array<Id, 2>> Pairs; ///< of cells; the second is NoId without IsPairs
  std::vector<vtkIdType> Places;        ///< of numbers: the value, or with IsPairs the component
};

/// Numbers the regions on both sides of cells. An array of two components has the values of both,
/// as surface nets write it; any other that of one, as FindRegionNumbers does. Refusals are those.
std::string FindRegionValues(
  const Drawing& drawing, const std::string& name, RegionValues& values, Pulse& pulse);

/// Adds to `cells` the array of the values of `regions`, by name, unless it is RegionId.
void AddRegionValues(
  const RegionValues& values, const std::vector<Id>& regions, vtkFieldData* cells);

/// Whether two cells have equal values in every cell array, of any type. Arrays of global or
/// pedigree ids, of numbers of original cells and of ghosts do not count, nor do arrays without a
/// value for each cell. Faces, which are cells of a chain of `chains` of that kind, always equal
/// each other: an edge of the mesh may cover parts of several faces.
/// Refers to `drawing`. Empty where all cells are equal.
std::function<bool(Id, Id)> CompareTags(const Drawing& drawing, const Polylines& chains);

/// Sets `opens` to whether the cell array `name` is another number than 0, and not NaN, at a cell;
/// leaves it where `name` is empty or "None". Returns a refusal where the drawing has no such
/// numbers. Refers to `drawing`.
std::string FindCracks(
  const Drawing& drawing, const std::string& name, std::function<bool(Id)>& opens);

} // namespace biting

#endif
