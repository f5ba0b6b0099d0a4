// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingValueGroups_h
#define BitingValueGroups_h

#include "../../IO/MeshFile.h"     // for MeshGroup
#include "../../vtkBitingCompat.h" // for the ABI namespace

#include "vtkType.h" // for ids

#include <cstddef> // for size_t
#include <cstdint> // for numbers of groups
#include <map>     // for numbers of values
#include <string>  // for names
#include <utility> // for pair
#include <vector>  // for lists

VTK_ABI_NAMESPACE_BEGIN
class vtkAbstractArray;
class vtkDataArray;
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
  int DigitsToTellApart() const;
  static std::int64_t NumberOf(const Key& key);
  static std::string NameOf(const Key& key, int digits);

  vtkAbstractArray* Values;
  vtkDataArray* Numbers;
  std::map<Key, std::size_t> Indices;
};

} // namespace biting

#endif
