// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingCarriedArrays_h
#define BitingCarriedArrays_h

#include "../../Kernel/Base/Ids.h"
#include "../../Kernel/Base/Pulse.h"
#include "../../vtkBitingCompat.h" // for the ABI namespace

#include "vtkType.h" // for vtkIdType

#include <array>   // for weights
#include <cstddef> // for sizes
#include <vector>  // for ids

VTK_ABI_NAMESPACE_BEGIN
class vtkAbstractArray;
class vtkFieldData;
VTK_ABI_NAMESPACE_END

namespace biting
{

/// Adds to `to` the tuples `ids` of all arrays of `from`, any kind of array, numbers or not; where
/// an id is NoId, NaN, -1, 0 or an empty text. Never as the active attribute that an array may be
/// in the input, since an id that is unique there is not unique here. Ghost arrays, arrays with
/// less than `size` tuples, and those whose names `to` has already are left out.
void CarryArrays(
  vtkFieldData* from, vtkIdType size, const std::vector<Id>& ids, vtkFieldData* to, Pulse& pulse);

/// What lies between some tuples of an array: their sum, each times its weight.
struct TupleMix
{
  static constexpr std::size_t Most = 6;

  std::array<vtkIdType, Most> Tuples{};
  std::array<double, Most> Weights{}; ///< above 0
  std::size_t Size = 0;

  /// Nothing where the weight is 0: that tuple has no say, were it NaN.
  void Add(vtkIdType tuple, double weight)
  {
    if (weight > 0.0)
    {
      this->Tuples[this->Size] = tuple;
      this->Weights[this->Size++] = weight;
    }
  }
};

/// Sets a tuple of `to`, an array like `from`. Real numbers are mixed, anything else is that of the
/// largest weight.
void SetMixed(vtkAbstractArray* to, vtkIdType tuple, const TupleMix& mix, vtkAbstractArray* from);

} // namespace biting

#endif
