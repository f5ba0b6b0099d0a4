// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "ChosenArray.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkInformation.h"
#include "vtkPointData.h"

namespace biting
{

namespace
{

ChosenArray Refused(const std::string& refusal)
{
  ChosenArray chosen;
  chosen.Refusal = refusal;
  return chosen;
}

ChosenArray ActiveArray(int attribute, vtkDataSet* data, const ArrayRole& role)
{
  ChosenArray chosen;
  chosen.Array = data->GetPointData()->GetAttribute(attribute);
  return chosen.Array
    ? chosen
    : Refused("The " + std::string(role.Owner) + " has no active point array of the chosen kind.");
}

} // namespace

ChosenArray ArrayNamed(const char* name, vtkDataSet* data, const ArrayRole& role)
{
  ChosenArray chosen;
  chosen.Array = data->GetPointData()->GetArray(name);
  const std::string text = name;
  const std::string owner = role.Owner;
  const bool mayBeMissing = text.empty() || text == "None" || text == SpacingArrayName;
  if (!chosen.Array && data->GetPointData()->GetAbstractArray(name))
  {
    return Refused(
      "The " + std::string(role.Array) + " " + text + " of the " + owner + " is not numeric.");
  }
  if (!chosen.Array && !mayBeMissing)
  {
    return Refused("The " + owner + " has no point array named " + text + "." +
      (data->GetCellData()->HasArray(name) ? CellDataAdvice : ""));
  }
  chosen.IsMissing = !chosen.Array && text == SpacingArrayName;
  chosen.IsOfCells = chosen.IsMissing && data->GetCellData()->HasArray(name);
  return chosen;
}

ChosenArray ChooseArray(vtkInformation* choice, vtkDataSet* data, const ArrayRole& role)
{
  const bool isSet = choice->Has(vtkDataObject::FIELD_ASSOCIATION());
  if (isSet &&
    choice->Get(vtkDataObject::FIELD_ASSOCIATION()) != vtkDataObject::FIELD_ASSOCIATION_POINTS)
  {
    return Refused("The " + std::string(role.Array) + " of the " + std::string(role.Owner) +
      " must be point data." + CellDataAdvice);
  }
  if (choice->Has(vtkDataObject::FIELD_NAME()))
  {
    return ArrayNamed(choice->Get(vtkDataObject::FIELD_NAME()), data, role);
  }
  if (choice->Has(vtkDataObject::FIELD_ATTRIBUTE_TYPE()))
  {
    return ActiveArray(choice->Get(vtkDataObject::FIELD_ATTRIBUTE_TYPE()), data, role);
  }
  return ArrayNamed(SpacingArrayName, data, role);
}

} // namespace biting
