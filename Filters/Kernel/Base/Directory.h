// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingDirectory_h
#define BitingDirectory_h

#include "Ids.h"

#include <algorithm> // for lower_bound, minmax, sort
#include <utility>   // for pair
#include <vector>    // for the entries

namespace biting
{

/// The ends of an edge, whatever its direction.
using UndirectedEnds = std::pair<Id, Id>;

inline UndirectedEnds EndsOf(Id start, Id end)
{
  return std::minmax({ start, end });
}

/// Numbers by their keys, sorted: filled first, then asked. Of equal keys the least number counts.
template <typename Key>
class Directory
{
public:
  void Add(const Key& key, Id number) { this->Entries.emplace_back(key, number); }
  void Sort() { std::sort(this->Entries.begin(), this->Entries.end()); }
  bool IsEmpty() const { return this->Entries.empty(); }

  /// NoId where the key is not there.
  Id operator[](const Key& key) const
  {
    const auto found =
      std::lower_bound(this->Entries.begin(), this->Entries.end(), std::make_pair(key, Id(0)));
    return found != this->Entries.end() && found->first == key ? found->second : NoId;
  }

private:
  std::vector<std::pair<Key, Id>> Entries;
};

} // namespace biting

#endif
