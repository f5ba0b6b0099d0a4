// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SpacingValues.h"

#include "DoubleArray.h"
#include "MessagesFromProblems.h"

#include "vtkDataSet.h"

#include <cmath>   // for isfinite
#include <sstream> // for the text

namespace biting
{

namespace
{

std::string Describe(vtkDataSet* data, const double* values, vtkIdType point)
{
  double place[3];
  data->GetPoint(point, place);
  std::ostringstream text;
  text << "point " << point << " with " << values[point] << " at "
       << PlaceText({ place[0], place[1], place[2] });
  return text.str();
}

} // namespace

std::string CheckSpacingValues(vtkDataSet* data, vtkDataArray* values,
  const std::vector<vtkIdType>& points, NotANumber notANumber)
{
  const std::string name = values->GetName() ? values->GetName() : "";
  if (values->GetNumberOfComponents() != 1)
  {
    return "The spacing array " + name + " has " + std::to_string(values->GetNumberOfComponents()) +
      " components; it takes one.";
  }
  const auto doubles = AsDoubles(values);
  const double* pointer = doubles->GetPointer(0);
  std::vector<std::string> bad;
  std::int64_t count = 0;
  for (const vtkIdType point : points)
  {
    const double value = pointer[point];
    const bool isSkipped = notANumber == NotANumber::Allowed && std::isnan(value);
    if (!isSkipped && !(value > 0.0 && std::isfinite(value)))
    {
      ++count;
      if (bad.size() < ShownIds)
      {
        bad.push_back(Describe(data, pointer, point));
      }
    }
  }
  if (count == 0)
  {
    return {};
  }
  return "The spacing array " + name + " has values that are zero, negative or not finite (" +
    std::to_string(count) + "): " + ListText(bad, count) + ". Spacing is an edge length.";
}

} // namespace biting
