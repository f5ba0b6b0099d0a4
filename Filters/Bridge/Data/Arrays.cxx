// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Arrays.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkFloatArray.h"
#include "vtkPointSet.h"
#include "vtkRectilinearGrid.h"
#include "vtkStringArray.h"
#include "vtkVariant.h"

#include <algorithm> // for all_of
#include <cmath>     // for isfinite
#include <limits>    // for NaN

namespace biting
{

namespace
{

using Arrays = std::vector<vtkAbstractArray*>;

bool IsReal(int type)
{
  return type == VTK_FLOAT || type == VTK_DOUBLE;
}

int TypeForAll(const Arrays& arrays)
{
  const int first = arrays.front()->GetDataType();
  const auto isFirst = [first](vtkAbstractArray* array) { return array->GetDataType() == first; };
  const auto isNumeric = [](vtkAbstractArray* array) { return array->IsNumeric() != 0; };
  const auto isReal = [](vtkAbstractArray* array) { return IsReal(array->GetDataType()); };
  if (std::all_of(arrays.begin(), arrays.end(), isFirst))
  {
    return first;
  }
  if (!std::all_of(arrays.begin(), arrays.end(), isNumeric))
  {
    return VTK_STRING;
  }
  return std::any_of(arrays.begin(), arrays.end(), isReal) ? VTK_DOUBLE : VTK_LONG_LONG;
}

std::string TextOf(const vtkVariant& value)
{
  if (value.IsFloat() || value.IsDouble())
  {
    return value.IsFloat() ? ShortText(value.ToFloat()) : ShortText(value.ToDouble());
  }
  return value.IsNumeric() ? std::to_string(value.ToTypeInt64()) : value.ToString();
}

void FillWithNaNOrZero(vtkAbstractArray* array)
{
  if (auto* values = vtkDataArray::SafeDownCast(array))
  {
    values->Fill(IsReal(array->GetDataType()) ? std::numeric_limits<double>::quiet_NaN() : 0.0);
  }
}

void CopyValues(vtkAbstractArray* from, vtkIdType tuples, vtkAbstractArray* to)
{
  auto* texts = vtkStringArray::SafeDownCast(to);
  const int components = from->GetNumberOfComponents();
  for (vtkIdType k = 0; k < tuples * components; ++k)
  {
    const vtkIdType place = k / components * to->GetNumberOfComponents() + k % components;
    const vtkVariant value = from->GetVariantValue(k);
    texts ? texts->SetValue(place, TextOf(value)) : to->SetVariantValue(place, value);
  }
}

// The type and the components of all arrays of one name.
class ArrayKind
{
public:
  explicit ArrayKind(const Arrays& arrays)
    : Type(TypeForAll(arrays))
    , Widest(*std::max_element(arrays.begin(), arrays.end(),
        [](vtkAbstractArray* a, vtkAbstractArray* b)
        { return a->GetNumberOfComponents() < b->GetNumberOfComponents(); }))
  {
  }

  bool Fits(vtkAbstractArray* array) const
  {
    return array->GetDataType() == this->Type &&
      array->GetNumberOfComponents() == this->Widest->GetNumberOfComponents();
  }

  // The array, which may be null, as one of this kind.
  vtkSmartPointer<vtkAbstractArray> Make(vtkAbstractArray* array, vtkIdType tuples) const
  {
    auto made = vtk::TakeSmartPointer(vtkAbstractArray::CreateArray(this->Type));
    made->SetName(this->Widest->GetName());
    made->SetNumberOfComponents(this->Widest->GetNumberOfComponents());
    made->CopyComponentNames(this->Widest);
    made->SetNumberOfTuples(tuples);
    FillWithNaNOrZero(made);
    if (array)
    {
      CopyValues(array, tuples, made);
    }
    return made;
  }

private:
  int Type;
  vtkSmartPointer<vtkAbstractArray> Widest;
};

// The array of a piece, null where it is lacked.
vtkAbstractArray* ArrayOf(const PieceArrays& piece, const std::string& name)
{
  vtkAbstractArray* array = piece.Arrays->GetAbstractArray(name.c_str());
  const bool isOfGhosts = name == vtkDataSetAttributes::GhostArrayName();
  const bool isUsable = array && array->GetNumberOfTuples() >= piece.Size &&
    (!isOfGhosts || array->GetDataType() == VTK_UNSIGNED_CHAR);
  return isUsable ? array : nullptr;
}

bool AreIds(vtkFieldData* arrays, const std::string& name)
{
  auto* attributes = vtkDataSetAttributes::SafeDownCast(arrays);
  int index = -1;
  return attributes && attributes->GetAbstractArray(name.c_str(), index) &&
    (attributes->IsArrayAnAttribute(index) == vtkDataSetAttributes::GLOBALIDS ||
      attributes->IsArrayAnAttribute(index) == vtkDataSetAttributes::PEDIGREEIDS);
}

void MakeAlike(const std::string& name, std::vector<PieceArrays>& pieces)
{
  Arrays given;
  Arrays empty;
  bool areIds = false;
  for (const PieceArrays& piece : pieces)
  {
    if (vtkAbstractArray* array = ArrayOf(piece, name))
    {
      (piece.Size > 0 ? given : empty).push_back(array);
      areIds = areIds || AreIds(piece.Arrays, name);
    }
  }
  const ArrayKind kind(given.empty() ? empty : given);
  for (const PieceArrays& piece : pieces)
  {
    vtkAbstractArray* array = ArrayOf(piece, name);
    if (array ? !kind.Fits(array) : !areIds)
    {
      piece.Arrays->AddArray(kind.Make(array, piece.Size));
    }
  }
}

std::vector<std::string> NamesIn(const std::vector<PieceArrays>& pieces)
{
  std::vector<std::string> names;
  for (const PieceArrays& piece : pieces)
  {
    for (int k = 0; k < piece.Arrays->GetNumberOfArrays(); ++k)
    {
      const char* name = piece.Arrays->GetAbstractArray(k)->GetName();
      if (name && ArrayOf(piece, name) &&
        std::find(names.begin(), names.end(), name) == names.end())
      {
        names.emplace_back(name);
      }
    }
  }
  return names;
}

} // namespace

vtkSmartPointer<vtkDoubleArray> AsDoubles(vtkDataArray* array)
{
  vtkSmartPointer<vtkDoubleArray> doubles = vtkDoubleArray::FastDownCast(array);
  if (!doubles)
  {
    doubles = vtkSmartPointer<vtkDoubleArray>::New();
    doubles->DeepCopy(array);
  }
  return doubles;
}

std::vector<double> ReadDoubles(vtkDataArray* array, vtkIdType count)
{
  if (auto* floats = vtkFloatArray::FastDownCast(array))
  {
    return { floats->GetPointer(0), floats->GetPointer(0) + count };
  }
  const auto doubles = AsDoubles(array);
  return { doubles->GetPointer(0), doubles->GetPointer(0) + count };
}

vtkSmartPointer<vtkDoubleArray> CoordinatesOf(vtkDataSet* data)
{
  auto* pointSet = vtkPointSet::SafeDownCast(data);
  if (pointSet && pointSet->GetPoints())
  {
    return AsDoubles(pointSet->GetPoints()->GetData());
  }
  auto coordinates = vtkSmartPointer<vtkDoubleArray>::New();
  coordinates->SetNumberOfComponents(3);
  coordinates->SetNumberOfTuples(data->GetNumberOfPoints());
  for (vtkIdType point = 0; point < data->GetNumberOfPoints(); ++point)
  {
    data->GetPoint(point, coordinates->GetPointer(3 * point));
  }
  return coordinates;
}

int TypeOfCoordinates(vtkDataSet* data)
{
  if (auto* pointSet = vtkPointSet::SafeDownCast(data))
  {
    return pointSet->GetPoints() ? pointSet->GetPoints()->GetDataType() : VTK_DOUBLE;
  }
  auto* grid = vtkRectilinearGrid::SafeDownCast(data);
  const bool isFloat = grid && grid->GetXCoordinates()->GetDataType() == VTK_FLOAT;
  return isFloat ? VTK_FLOAT : VTK_DOUBLE;
}

bool AreFinite(const double* place)
{
  return std::all_of(place, place + 3, [](double value) { return std::isfinite(value); });
}

std::vector<std::string> MakeArraysAlike(std::vector<PieceArrays>& pieces)
{
  std::vector<std::string> names = NamesIn(pieces);
  for (const std::string& name : names)
  {
    MakeAlike(name, pieces);
  }
  return names;
}

void MakeArraysAlike(const std::vector<vtkSmartPointer<vtkDataSet>>& pieces)
{
  for (const int association : { vtkDataObject::POINT, vtkDataObject::CELL })
  {
    std::vector<PieceArrays> arrays;
    arrays.reserve(pieces.size());
    for (const auto& piece : pieces)
    {
      arrays.push_back(
        { piece->GetAttributes(association), piece->GetNumberOfElements(association) });
    }
    MakeArraysAlike(arrays);
  }
}

} // namespace biting
