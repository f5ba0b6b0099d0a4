// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingCrew_h
#define BitingCrew_h

#include "Monitor.h"

#include <vector> // for bytes

namespace biting
{

/// Processes that mesh one domain together. The others work for the first member once it calls
/// them, which it does at most once. They then prepare the same domain and spacing, do their share,
/// and send what the first one needs of it. From then on they hold what they made: the first
/// replies, and each of the others sends again, and so on; an empty reply is the last one. What
/// does not arrive the first time the first member does itself.
class Crew
{
public:
  virtual ~Crew() = default;

  virtual int Size() const = 0; ///< of the members, at least 1
  virtual int Own() const = 0;  ///< the number of this one; 0: the first
  virtual std::vector<char> Receive(int member, Monitor& monitor) = 0; ///< empty: nothing came

  /// For the first member. After that the others are at work.
  virtual void Call() = 0;

  /// For the first member, to one of which something has come: that one is at work again, or done
  /// where there are no bytes.
  virtual void Reply(int member, const std::vector<char>& bytes) = 0;

  /// For the others, in turns; not empty.
  virtual void Send(const std::vector<char>& bytes) = 0;
  virtual std::vector<char> Await() = 0; ///< the reply; empty: nothing more is wanted
};

/// A process that works by itself.
class Alone : public Crew
{
public:
  int Size() const override { return 1; }
  int Own() const override { return 0; }
  std::vector<char> Receive(int, Monitor&) override { return {}; }
  void Call() override {}
  void Reply(int, const std::vector<char>&) override {}
  void Send(const std::vector<char>&) override {}
  std::vector<char> Await() override { return {}; }
};

/// For those who have no other.
inline Crew& NoCrew()
{
  static Alone crew;
  return crew;
}

} // namespace biting

#endif
