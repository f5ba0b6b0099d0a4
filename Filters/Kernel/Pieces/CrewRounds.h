// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingCrewRounds_h
#define BitingCrewRounds_h

#include "../Base/Crew.h"
#include "../Base/Monitor.h"

#include <cstddef> // for members
#include <new>     // for bad_alloc
#include <utility> // for move
#include <vector>  // for bytes

namespace biting
{

/// Rounds of messages between the members of a crew that hold blocks. All of them take part in each
/// round, and all messages go to the first member and come from it.
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

  /// One round: the first member gets what all of them have, one after the other, empty for those
  /// that take no part, and says by conclude(all) whether all go on, which is returned on each.
  /// False where the monitor wants to stop. Throws where a member is lost. `own` is not empty.
  template <typename Conclude>
  bool GoOn(Bytes own, PartOfStage& part, Conclude&& conclude)
  {
    const auto reply = [&conclude](const std::vector<Bytes>& all)
    { return Bytes(conclude(all) ? 1 : 0, 1); };
    return !this->Share(std::move(own), part, reply).empty();
  }

  /// The same, where conclude(all) makes the bytes that each gets; no bytes: nobody goes on.
  template <typename Conclude>
  Bytes Share(Bytes own, PartOfStage& part, Conclude&& conclude)
  {
    if (this->Members.Own() != 0)
    {
      this->Members.Send(own);
      return this->Members.Await();
    }
    std::vector<Bytes> all(this->AreHolding.size());
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
    if (part.HasStopped())
    {
      return {};
    }
    Bytes reply = conclude(all);
    for (std::size_t member = 1; member < all.size(); ++member)
    {
      if (this->AreHolding[member])
      {
        this->Members.Reply(static_cast<int>(member), reply);
      }
    }
    return reply;
  }

private:
  Crew& Members;
  std::vector<bool> AreHolding;
};

} // namespace biting

#endif
