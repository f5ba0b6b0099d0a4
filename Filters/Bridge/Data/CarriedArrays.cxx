// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "CarriedArrays.h"

#include "ArrayFromVector.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <algorithm> // for copy, find, max, max_element, min
#include <limits>    // for NaN
#include <string>    // for names

namespace biting
{

namespace
{

// What an array has where nothing is given: NaN, -1, 0 or an empty text.
void FillWithNaNOrMinusOne(vtkAbstractArray* array)
{
  if (auto* data = vtkDataArray::SafeDownCast(array))
  {
    const bool isReal = data->GetDataType() == VTK_DOUBLE || data->GetDataType() == VTK_FLOAT;
    data->Fill(
      isReal ? std::numeric_limits<double>::quiet_NaN() : std::max(data->GetDataTypeMin(), -1.0));
  }
}

// In steps, as tuples of some arrays are slow.
void CopyTuples(vtkAbstractArray* from, vtkIdList* tuples, vtkAbstractArray* to, Pulse& pulse)
{
  constexpr vtkIdType Step = 1024;
  for (vtkIdType first = 0; first < tuples->GetNumberOfIds() && pulse.Ask(); first += Step)
  {
    const vtkIdType size = std::min(Step, tuples->GetNumberOfIds() - first);
    vtkNew<vtkIdList> some;
    vtkNew<vtkIdList> places;
    for (vtkIdType k = first; k < first + size; ++k)
    {
      if (tuples->GetId(k) >= 0)
      {
        some->InsertNextId(tuples->GetId(k));
        places->InsertNextId(k);
      }
    }
    to->InsertTuples(places, some, from);
  }
}

} // namespace

void CarryArrays(
  vtkFieldData* from, vtkIdType size, const std::vector<Id>& ids, vtkFieldData* to, Pulse& pulse)
{
  vtkNew<vtkIdList> tuples;
  tuples->SetNumberOfIds(static_cast<vtkIdType>(ids.size()));
  std::copy(ids.begin(), ids.end(), tuples->GetPointer(0));
  const bool hasUnknown = std::find(ids.begin(), ids.end(), NoId) != ids.end();
  for (int k = 0; k < from->GetNumberOfArrays() && pulse.Ask(); ++k)
  {
    vtkAbstractArray* given = from->GetAbstractArray(k);
    const std::string name = given->GetName() ? given->GetName() : "";
    const bool isShort = given->GetNumberOfTuples() < size;
    if (isShort || name == vtkDataSetAttributes::GhostArrayName() || to->HasArray(name.c_str()))
    {
      continue;
    }
    const auto carried = NewArrayLike(given, tuples->GetNumberOfIds());
    if (hasUnknown)
    {
      FillWithNaNOrMinusOne(carried);
    }
    CopyTuples(given, tuples, carried, pulse);
    to->AddArray(carried);
  }
}

void SetMixed(vtkAbstractArray* to, vtkIdType tuple, const TupleMix& mix, vtkAbstractArray* from)
{
  const int type = from->GetDataType();
  if (type != VTK_DOUBLE && type != VTK_FLOAT)
  {
    const auto* begin = mix.Weights.begin();
    const auto nearest = std::max_element(begin, begin + mix.Size) - begin;
    to->SetTuple(tuple, mix.Tuples[nearest], from);
    return;
  }
  auto* given = static_cast<vtkDataArray*>(from);
  for (int component = 0; component < given->GetNumberOfComponents(); ++component)
  {
    double value = 0.0;
    for (std::size_t k = 0; k < mix.Size; ++k)
    {
      value += mix.Weights[k] * given->GetComponent(mix.Tuples[k], component);
    }
    static_cast<vtkDataArray*>(to)->SetComponent(tuple, component, value);
  }
}

} // namespace biting
