// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "AlikeArrays.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkStringArray.h"
#include "vtkVariant.h"

#include <algorithm> // for all_of, any_of, find, max, min
#include <cmath>     // for floor
#include <cstdint>   // for whole numbers
#include <limits>    // for NaN
#include <sstream>   // for texts

namespace biting
{

namespace
{

using Arrays = std::vector<vtkAbstractArray*>;

// Above it not all whole numbers are a double.
constexpr std::int64_t MostExact = std::int64_t{ 1 } << 53;

bool IsReal(int type)
{
  return type == VTK_FLOAT || type == VTK_DOUBLE;
}

// What whole numbers are among the values of arrays.
struct WholeNumbers
{
  bool AreNegative = false;     ///< some
  bool AreBeyondSigned = false; ///< some, of 64 bits
  bool AreInexact = false;      ///< some, as a double
};

WholeNumbers FindWholeNumbers(const Arrays& arrays)
{
  WholeNumbers found;
  for (vtkAbstractArray* array : arrays)
  {
    const bool isUnsigned = vtkDataArray::GetDataTypeMin(array->GetDataType()) == 0.0;
    const vtkIdType size = IsReal(array->GetDataType()) ? 0 : array->GetNumberOfValues();
    for (vtkIdType k = 0; k < size; ++k)
    {
      const std::int64_t value = array->GetVariantValue(k).ToTypeInt64();
      found.AreNegative |= value < 0 && !isUnsigned;
      found.AreBeyondSigned |= value < 0 && isUnsigned;
      found.AreInexact |= value < -MostExact || value > MostExact || (value < 0 && isUnsigned);
    }
  }
  return found;
}

int TypeOfWholeNumbers(const Arrays& arrays)
{
  std::vector<int> types;
  double least = 0.0;
  double most = 0.0;
  for (vtkAbstractArray* array : arrays)
  {
    types.push_back(array->GetDataType());
    least = std::min(least, vtkDataArray::GetDataTypeMin(types.back()));
    most = std::max(most, vtkDataArray::GetDataTypeMax(types.back()));
  }
  types.insert(types.end(), { VTK_SHORT, VTK_INT, VTK_LONG_LONG });
  const auto holding = std::find_if(types.begin(), types.end(),
    [least, most](int type)
    {
      return vtkDataArray::GetDataTypeMin(type) <= least &&
        vtkDataArray::GetDataTypeMax(type) >= most;
    });
  if (holding != types.end())
  {
    return *holding;
  }
  const WholeNumbers found = FindWholeNumbers(arrays);
  const int unsignedType = found.AreNegative ? VTK_STRING : VTK_UNSIGNED_LONG_LONG;
  return found.AreBeyondSigned ? unsignedType : VTK_LONG_LONG;
}

int TypeForAll(const Arrays& arrays)
{
  const int first = arrays.front()->GetDataType();
  const auto isFirst = [first](vtkAbstractArray* array) { return array->GetDataType() == first; };
  if (std::all_of(arrays.begin(), arrays.end(), isFirst))
  {
    return first;
  }
  const auto isNumeric = [](vtkAbstractArray* array) { return array->IsNumeric() != 0; };
  if (!std::all_of(arrays.begin(), arrays.end(), isNumeric))
  {
    return VTK_STRING;
  }
  const auto isReal = [](vtkAbstractArray* array) { return IsReal(array->GetDataType()); };
  if (std::none_of(arrays.begin(), arrays.end(), isReal))
  {
    return TypeOfWholeNumbers(arrays);
  }
  return FindWholeNumbers(arrays).AreInexact ? VTK_STRING : VTK_DOUBLE;
}

std::string TextOfReal(double value, bool isFloat)
{
  constexpr int MostDigits = std::numeric_limits<double>::max_digits10;
  if (std::isnan(value))
  {
    return "nan";
  }
  const bool isWhole = std::floor(value) == value && std::abs(value) <= MostExact;
  for (int digits = isWhole ? MostDigits : 1;; ++digits)
  {
    std::ostringstream text;
    text.precision(digits);
    text << value;
    double read = 0.0;
    std::istringstream(text.str()) >> read;
    const bool isSame =
      isFloat ? static_cast<float>(read) == static_cast<float>(value) : read == value;
    if (isSame || digits == MostDigits)
    {
      return text.str();
    }
  }
}

std::string TextOf(const vtkVariant& value)
{
  if (!value.IsNumeric())
  {
    return value.ToString();
  }
  if (IsReal(static_cast<int>(value.GetType())))
  {
    return TextOfReal(value.ToDouble(), value.IsFloat());
  }
  const bool isUnsigned = vtkDataArray::GetDataTypeMin(static_cast<int>(value.GetType())) == 0.0;
  return isUnsigned ? std::to_string(value.ToTypeUInt64()) : std::to_string(value.ToTypeInt64());
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

// What all arrays of one name are to be.
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
