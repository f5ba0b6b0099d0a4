// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Components.h"

#include <algorithm> // for min, max
#include <cstddef>   // for places

namespace biting
{

Id Parts::Begin()
{
  this->Parents.push_back(static_cast<Id>(this->Parents.size()));
  this->NumberOfParts += 1;
  return this->Parents.back();
}

Id Parts::Join(Id part, Id other)
{
  if (part == other)
  {
    return part;
  }
  const Id otherRoot = this->Root(other);
  const Id root = part == NoId ? otherRoot : this->Root(part);
  if (root != otherRoot)
  {
    this->Parents[static_cast<std::size_t>(std::max(root, otherRoot))] = std::min(root, otherRoot);
    this->NumberOfParts -= 1;
  }
  return std::min(root, otherRoot);
}

Id Parts::Root(Id part)
{
  std::size_t member = static_cast<std::size_t>(part);
  while (this->Parents[member] != static_cast<Id>(member))
  {
    const std::size_t parent = static_cast<std::size_t>(this->Parents[member]);
    this->Parents[member] = this->Parents[parent];
    member = static_cast<std::size_t>(this->Parents[member]);
  }
  return static_cast<Id>(member);
}

void Parts::Append(const Parts& other)
{
  const Id begin = this->Size();
  for (const Id parent : other.Parents)
  {
    this->Parents.push_back(begin + parent);
  }
  this->NumberOfParts += other.NumberOfParts;
}

void ComponentSum::Join(const ComponentSum& other)
{
  const Id begin = this->Components.Size();
  this->Begins.push_back(begin);
  this->Components.Append(other.Components);
  for (const Link& link : other.Links)
  {
    this->Links.push_back({ begin + link.Part, link.Across });
  }
}

} // namespace biting
