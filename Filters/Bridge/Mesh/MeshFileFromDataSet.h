// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingMeshFileFromDataSet_h
#define BitingMeshFileFromDataSet_h

#include "../../IO/MeshFile.h"     // for MeshGroup
#include "../../vtkBitingCompat.h" // for the ABI namespace

#include "vtkSmartPointer.h" // for tags
#include "vtkType.h"         // for ids

#include <cstddef> // for size_t
#include <cstdint> // for numbers of groups
#include <map>     // for numbers of values
#include <string>  // for names
#include <utility> // for pair
#include <vector>  // for lists

VTK_ABI_NAMESPACE_BEGIN
class vtkAbstractArray;
class vtkCellData;
class vtkDataArray;
class vtkDataSet;
class vtkPolyData;
VTK_ABI_NAMESPACE_END

namespace biting
{

/// Groups the values of an array, in their order: numbers by size, strings by alphabet. NaN is a
/// group of its own, an empty string none. Numbers that differ have names that differ.
class ValueGroups
{
public:
  explicit ValueGroups(vtkAbstractArray* values);

  bool Has(vtkIdType item) const { return this->Numbers || !this->KeyOf(item).second.empty(); }

  std::size_t IndexOf(vtkIdType item) const { return this->Indices.at(this->KeyOf(item)); }

  /// Whole numbers plus `shift` keep their values where these are above 0. In names each of the
  /// `forbidden` characters is '_', and more of these follow where that would be the name of
  /// another group.
  std::vector<MeshGroup> Named(
    std::int64_t shift, const std::string& prefix, const std::string& forbidden) const;

private:
  /// The text is empty where the number alone says all.
  using Key = std::pair<double, std::string>;

  Key KeyOf(vtkIdType item) const;
  static std::int64_t NumberOf(const Key& key);
  std::string NameOf(const Key& key) const;

  vtkAbstractArray* Values;
  vtkDataArray* Numbers;
  std::map<Key, std::size_t> Indices;
};

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
  vtkIdType NumberOf(vtkIdType point) const { return this->Numbers[point]; }

private:
  void ListCells(vtkDataSet* mesh);
  void ListPointsOfCells(vtkDataSet* mesh);

  std::vector<vtkIdType> PointIds;
  std::vector<vtkIdType> CellIds;
  std::vector<vtkIdType> Numbers;
};

/// The array of depths that need not be there.
constexpr const char* DefaultDepths = "Depth";

/// What would end the name of a group in a file: of any format, and of SU2 and its configuration.
constexpr const char* EndsOfNames = "\"\n\r";
constexpr const char* EndsOfNamesInSU2 = "\"\n\r \t%=,()";

/// What is said of the first cell that has no place in a file; empty where there is none.
std::string RefusalOfCells(vtkDataSet* mesh);

/// Reads points, and cells with their regions: the values of the cell array `regions`, by name;
/// where it is empty, `RegionId` plus 1. Returns why that is no mesh, empty where it is.
std::string ReadCells(
  vtkDataSet* mesh, const WrittenParts& parts, const std::string& regions, MeshFile& file);

/// Turns tetrahedra to be positive; triangles, in a plane of constant z, counterclockwise. Returns
/// why that is no mesh, empty where it is.
std::string OrientCells(MeshFile& file);

/// Reads a point array; returns what is wrong with it, empty where nothing is.
std::string ReadDepths(
  vtkDataSet* mesh, const WrittenParts& parts, const std::string& name, MeshFile& file);

/// The tags of sides: the chosen array, else `Tag`, else the first that the mesher has not made,
/// else `Kind`; null where there is none, or the chosen one does not exist.
vtkAbstractArray* FindTags(vtkCellData* data, const std::string& chosen);

/// The tag "boundary" of all sides.
vtkSmartPointer<vtkAbstractArray> OneTag(vtkIdType numberOfSides);

/// Reads the sides that have a tag: triangles where cells are tetrahedra, else lines.
void ReadSides(
  vtkPolyData* sides, const WrittenParts& parts, const ValueGroups& groups, MeshFile& file);

} // namespace biting

#endif
