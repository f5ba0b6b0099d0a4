// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingCrewRounds_h
#define BitingCrewRounds_h

#include "../Base/Crew.h"
#include "../Base/PartOfStage.h"

#include <cstddef> // for members
#include <new>     // for bad_alloc
#include <utility> // for move
#include <vector>  // for bytes

namespace biting
{

/// What members of a crew that hold blocks tell each other, by way of the first: all of them
/// gather, then scatter, in turns.
class CrewRounds
{
public:
  using Bytes = std::vector<char>;

  /// `areHolding`, of the first member: those that take part besides it.
  CrewRounds(Crew& crew, std::vector<bool> areHolding)
    : Members(crew)
    , AreHolding(std::move(areHolding))
  {
  }

  bool IsFirst() const { return this->Members.Own() == 0; }

  /// On the first member what all of them have, one after the other, empty for those that take no
  /// part; none where the monitor wants to stop. Throws where one is lost. `own` is not empty.
  std::vector<Bytes> Gather(Bytes own, PartOfStage& part)
  {
    std::vector<Bytes> all;
    if (!this->IsFirst())
    {
      this->Members.Send(own);
      return all;
    }
    all.resize(this->AreHolding.size());
    all[0] = std::move(own);
    for (std::size_t member = 1; member < all.size() && !part.HasStopped(); ++member)
    {
      if (this->AreHolding[member])
      {
        all[member] = this->Members.Receive(static_cast<int>(member), part);
        if (all[member].empty() && !part.HasStopped())
        {
          throw std::bad_alloc();
        }
      }
    }
    return part.HasStopped() ? std::vector<Bytes>() : all;
  }

  /// Gives each member its own of `all`, of the first, and returns it; empty: nothing follows.
  Bytes Scatter(const std::vector<Bytes>& all)
  {
    if (!this->IsFirst())
    {
      return this->Members.Await();
    }
    for (std::size_t member = 1; member < this->AreHolding.size(); ++member)
    {
      if (this->AreHolding[member])
      {
        this->Members.Reply(static_cast<int>(member), all.empty() ? Bytes() : all[member]);
      }
    }
    return all.empty() ? Bytes() : all[0];
  }

  std::vector<Bytes> ForEach(const Bytes& bytes) const
  {
    return std::vector<Bytes>(this->AreHolding.size(), bytes);
  }

private:
  Crew& Members;
  std::vector<bool> AreHolding;
};

} // namespace biting

#endif
