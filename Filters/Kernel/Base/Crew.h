// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingCrew_h
#define BitingCrew_h

#include "Monitor.h"

#include <vector> // for bytes

namespace biting
{

/// Processes that mesh one domain together. The first member has the mesh in the end; the others
/// work for it once it calls them, which it does at most once. They then prepare the same domain
/// and spacing, do their share, and send it. What does not arrive the first member does itself, so
/// that nothing depends on the others but the time it takes.
class Crew
{
public:
  virtual ~Crew() = default;

  virtual int Size() const = 0; ///< of the members, at least 1
  virtual int Own() const = 0;  ///< the number of this one; 0: the first
  virtual std::vector<char> Receive(int member, Monitor& monitor) = 0; ///< empty: nothing came

  /// For the first member. After that the others are at work.
  virtual void Call() = 0;

  /// For the others, once.
  virtual void Send(const std::vector<char>& bytes) = 0;
};

/// A process that works by itself.
class Alone : public Crew
{
public:
  int Size() const override { return 1; }
  int Own() const override { return 0; }
  std::vector<char> Receive(int, Monitor&) override { return {}; }
  void Call() override {}
  void Send(const std::vector<char>&) override {}
};

/// For those who have no other.
inline Crew& NoCrew()
{
  static Alone crew;
  return crew;
}

} // namespace biting

#endif
