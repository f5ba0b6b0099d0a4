// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SpacingValues.h"

#include "../Data/DoubleArray.h"
#include "../Run/MessagesFromProblems.h"

#include "vtkDataSet.h"

#include <algorithm> // for all_of, min, replace_if
#include <cmath>     // for isfinite
#include <sstream>   // for the text

namespace biting
{

namespace
{

bool IsSpacing(double value, SpacingOwner owner)
{
  const bool isHole = owner == SpacingOwner::Source && std::isnan(value);
  return isHole || (value > 0.0 && std::isfinite(value));
}

std::string SubjectOf(vtkDataArray* array)
{
  return std::string("The spacing array ") + (array->GetName() ? array->GetName() : "");
}

std::string Describe(vtkIdType point, double value, const Point3& place)
{
  std::ostringstream text;
  text << "point " << point << " with " << value << " at " << PlaceText(place);
  return text.str();
}

void AddPlace(
  vtkIdType point, const Point3& place, const std::string& message, ProblemPlaces& places)
{
  ProblemPlace bad;
  bad.Kind = ProblemCode::BadSpacing;
  bad.FirstId = point;
  bad.Place = place;
  bad.Message = message;
  const bool isFinite = std::all_of(
    place.begin(), place.end(), [](double coordinate) { return std::isfinite(coordinate); });
  if (isFinite && places.Places.size() < ProblemList::KeptPerKind)
  {
    places.Places.push_back(bad);
  }
}

} // namespace

double LeastValue(const SpacingOptions& options)
{
  return options.Minimum / options.Scale;
}

std::string CheckShape(vtkDataSet* data, vtkDataArray* array)
{
  if (array->GetNumberOfComponents() != 1)
  {
    return SubjectOf(array) + " has " + std::to_string(array->GetNumberOfComponents()) +
      " components; it takes one.";
  }
  if (array->GetNumberOfTuples() < data->GetNumberOfPoints())
  {
    return SubjectOf(array) + " has " + std::to_string(array->GetNumberOfTuples()) +
      " values for " + std::to_string(data->GetNumberOfPoints()) + " points.";
  }
  return {};
}

std::string ReadOwnValues(vtkDataSet* data, vtkDataArray* array,
  const std::vector<vtkIdType>& points, double least, std::vector<double>& values,
  ProblemPlaces& places, Pulse& pulse)
{
  const std::string refusal = CheckShape(data, array);
  if (!refusal.empty())
  {
    return refusal;
  }
  values = ReadDoubles(array, data->GetNumberOfPoints());
  if (least > 0.0)
  {
    std::replace_if(
      values.begin(), values.end(), [](double value) { return value <= 0.0; }, least);
  }
  return CheckReadValues(data, array, values, &points, SpacingOwner::Input, places, pulse);
}

std::string CheckReadValues(vtkDataSet* data, vtkDataArray* array,
  const std::vector<double>& values, const std::vector<vtkIdType>* points, SpacingOwner owner,
  ProblemPlaces& places, Pulse& pulse)
{
  const std::string subject =
    SubjectOf(array) + (owner == SpacingOwner::Input ? " of the input: " : " of the source: ");
  std::vector<std::string> bad;
  std::int64_t count = 0;
  const std::size_t last = points ? points->size() : values.size();
  for (std::size_t k = 0; k < last; ++k)
  {
    if (!pulse.Beat(1))
    {
      return {};
    }
    const vtkIdType point = points ? (*points)[k] : static_cast<vtkIdType>(k);
    const double value = values[static_cast<std::size_t>(point)];
    if (!IsSpacing(value, owner) && static_cast<std::size_t>(++count) <= ProblemList::KeptPerKind)
    {
      Point3 place;
      data->GetPoint(point, place.data());
      bad.push_back(Describe(point, value, place));
      AddPlace(point, place, subject + bad.back(), places);
    }
  }
  if (count == 0)
  {
    return {};
  }
  places.Counts[static_cast<std::size_t>(ProblemCode::BadSpacing)] += count;
  bad.resize(std::min(bad.size(), ShownIds));
  return SubjectOf(array) + " has values that are zero, negative or not finite (" +
    std::to_string(count) + "): " + ListText(bad, count) + ". Spacing is an edge length.";
}

} // namespace biting
