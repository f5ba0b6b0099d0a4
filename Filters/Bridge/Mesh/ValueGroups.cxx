// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "ValueGroups.h"

#include "vtkAbstractArray.h"
#include "vtkDataArray.h"
#include "vtkVariant.h"

#include <algorithm> // for max, replace_if
#include <cmath>     // for abs, floor, isnan
#include <iomanip>   // for setprecision
#include <set>       // for names that were changed
#include <sstream>   // for names

namespace biting
{

namespace
{

// From here on there are whole numbers that are no double: 2^53.
constexpr double LeastInexact = 9007199254740992.0;

// Of numbers in names: those that a stream writes by itself, and those that tell all doubles apart.
constexpr int FewestDigits = 6;
constexpr int MostDigits = 17;

std::string WithoutForbidden(std::string name, const std::string& forbidden)
{
  std::replace_if(
    name.begin(), name.end(),
    [&forbidden](char c) { return forbidden.find(c) != std::string::npos; }, '_');
  return name;
}

} // namespace

ValueGroups::ValueGroups(vtkAbstractArray* values)
  : Values(values)
  , Numbers(vtkDataArray::SafeDownCast(values))
{
  for (vtkIdType k = 0; k < values->GetNumberOfTuples(); ++k)
  {
    if (this->Has(k))
    {
      this->Indices.emplace(this->KeyOf(k), 0);
    }
  }
  std::size_t index = 0;
  for (auto& entry : this->Indices)
  {
    entry.second = index++;
  }
}

std::vector<MeshGroup> ValueGroups::Named(
  std::int64_t shift, const std::string& prefix, const std::string& forbidden) const
{
  std::int64_t highest = 0;
  for (const auto& entry : this->Indices)
  {
    highest = std::max(highest, NumberOf(entry.first) + shift);
  }
  const int digits = this->DigitsToTellApart();
  std::set<std::string> changed;
  std::vector<MeshGroup> groups;
  for (const auto& entry : this->Indices)
  {
    const std::int64_t own = NumberOf(entry.first) + shift;
    const std::string given = NameOf(entry.first, digits);
    std::string name = WithoutForbidden(given, forbidden);
    while (name != given && (this->Indices.count({ 0.0, name }) || !changed.insert(name).second))
    {
      name += '_';
    }
    groups.push_back({ own > 0 ? own : ++highest, prefix + name });
  }
  return groups;
}

ValueGroups::Key ValueGroups::KeyOf(vtkIdType item) const
{
  const double number = this->Numbers ? this->Numbers->GetComponent(item, 0) : std::nan("");
  const int type = this->Values->GetDataType();
  const bool isReal = type == VTK_FLOAT || type == VTK_DOUBLE;
  if (!std::isnan(number) && (isReal || std::abs(number) < LeastInexact))
  {
    return { number, std::string() };
  }
  const vtkIdType first = item * this->Values->GetNumberOfComponents();
  return { std::isnan(number) ? 0.0 : number, this->Values->GetVariantValue(first).ToString() };
}

int ValueGroups::DigitsToTellApart() const
{
  int digits = FewestDigits;
  for (auto next = this->Indices.begin(); next != this->Indices.end();)
  {
    const auto entry = next++;
    while (digits < MostDigits && next != this->Indices.end() &&
      NameOf(entry->first, digits) == NameOf(next->first, digits))
    {
      ++digits;
    }
  }
  return digits;
}

// Far below 0 where it is no whole number.
std::int64_t ValueGroups::NumberOf(const Key& key)
{
  const bool isWhole = key.second.empty() && std::floor(key.first) == key.first;
  return isWhole && std::abs(key.first) < 1e9 ? static_cast<std::int64_t>(key.first) : -2000000000;
}

// Whole numbers have all of their digits.
std::string ValueGroups::NameOf(const Key& key, int digits)
{
  const bool isWhole = std::floor(key.first) == key.first && std::abs(key.first) < LeastInexact;
  std::ostringstream text;
  text << std::setprecision(isWhole ? MostDigits : digits) << key.first;
  return key.second.empty() ? text.str() : key.second;
}

} // namespace biting
