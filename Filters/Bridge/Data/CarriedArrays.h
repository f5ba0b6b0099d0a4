// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingCarriedArrays_h
#define BitingCarriedArrays_h

#include "../../Kernel/Base/Ids.h"
#include "../../Kernel/Base/Pulse.h"
#include "../../vtkBitingCompat.h" // for the ABI namespace

#include "vtkType.h" // for vtkIdType

#include <vector> // for ids

VTK_ABI_NAMESPACE_BEGIN
class vtkFieldData;
VTK_ABI_NAMESPACE_END

namespace biting
{

/// Adds to `to` the tuples `ids` of all arrays of `from`, any kind of array, numbers or not; where
/// an id is NoId, NaN, -1, 0 or an empty text. Never as the active attribute that an array may be
/// in the input, since an id that is unique there is not unique here. Ghost arrays, arrays with less
/// than `size` tuples, and those whose names `to` has already are left out.
void CarryArrays(
  vtkFieldData* from, vtkIdType size, const std::vector<Id>& ids, vtkFieldData* to, Pulse& pulse);

} // namespace biting

#endif
