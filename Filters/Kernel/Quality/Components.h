// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingComponents_h
#define BitingComponents_h

#include "../Base/Ids.h"
#include "CheckSums.h"

#include <cstdint> // for counts
#include <vector>  // for the arrays

namespace biting
{

/// Parts of a whole that turn out to be connected (disjoint sets with path halving).
class Parts
{
public:
  /// A part of its own.
  Id Begin();
  /// The root of both; `part` may be none.
  Id Join(Id part, Id other);
  /// Adds all parts of the other, behind these.
  void Append(const Parts& other);
  Id Size() const { return static_cast<Id>(this->Parents.size()); } ///< parts that were begun
  std::int64_t Count() const { return this->NumberOfParts; }        ///< that are not joined

private:
  Id Root(Id part);

  std::vector<Id> Parents; ///< of a root: itself
  std::int64_t NumberOfParts = 0;
};

/// The parts that tasks find, and what connects those of different tasks, for SumAtOnce.
struct ComponentSum
{
  struct Link
  {
    Id Part;
    Id Across; ///< a triangle of an earlier task
  };

  void Join(const ComponentSum& other);

  Parts Components;
  std::vector<Link> Links;
  std::vector<Id> Begins; ///< of the parts of each task that was joined
};

/// Of vertices.
struct UseSum
{
  std::int64_t Inner = 0;
  FirstDefect Unused;

  void Join(const UseSum& other)
  {
    this->Inner += other.Inner;
    this->Unused.Join(other.Unused);
  }
};

} // namespace biting

#endif
