// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingThreadCrew_h
#define BitingThreadCrew_h

#include "Base/Crew.h"
#include "BitingMesh.h"

#include <gtest/gtest.h>

#include <condition_variable> // for letters
#include <deque>              // for letters
#include <functional>         // for work
#include <memory>             // for helpers
#include <mutex>              // for letters
#include <thread>             // for helpers
#include <utility>            // for move
#include <vector>             // for bytes

// A crew whose members are threads.

namespace biting
{

using Bytes = std::vector<char>;

/// What waits for someone.
class Mailbox
{
public:
  void Put(Bytes bytes)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Letters.push_back(std::move(bytes));
    this->Arrival.notify_all();
  }

  Bytes Take()
  {
    std::unique_lock<std::mutex> lock(this->Mutex);
    this->Arrival.wait(lock, [this]() { return !this->Letters.empty(); });
    Bytes bytes = std::move(this->Letters.front());
    this->Letters.pop_front();
    return bytes;
  }

private:
  std::mutex Mutex;
  std::condition_variable Arrival;
  std::deque<Bytes> Letters;
};

/// One of those that are not the first, on a thread of its own.
class Helper : public Crew
{
public:
  Helper(int own, int size)
    : Number(own)
    , Count(size)
  {
  }

  int Size() const override { return this->Count; }
  int Own() const override { return this->Number; }
  Bytes Receive(int, Monitor&) override { return {}; }
  void Call() override { ADD_FAILURE() << "only the first calls"; }
  void Reply(int, const Bytes&) override { ADD_FAILURE() << "only the first replies"; }
  void Send(const Bytes& bytes) override
  {
    EXPECT_FALSE(bytes.empty());
    this->IsAtWork = false;
    this->ToFirst.Put(bytes);
  }
  Bytes Await() override
  {
    Bytes bytes = this->FromFirst.Take();
    this->IsAtWork = !bytes.empty();
    return bytes;
  }

  void Start(std::function<BitingMesh(Crew&)> work)
  {
    this->Thread = std::thread(
      [this, work]()
      {
        this->Piece = work(*this);
        if (this->IsAtWork)
        {
          this->ToFirst.Put({});
        }
      });
  }

  Mailbox ToFirst;
  Mailbox FromFirst;
  BitingMesh Piece;
  std::thread Thread;

private:
  int Number;
  int Count;
  bool IsAtWork = true; ///< owes something to the first
};

/// The first one.
class First : public Crew
{
public:
  First(int size, std::function<BitingMesh(Crew&)> work, std::function<void(int, Bytes&)> spoil)
    : AreWaiting(static_cast<std::size_t>(size), false)
    , Work(std::move(work))
    , Spoil(std::move(spoil))
  {
    for (int member = 1; member < size; ++member)
    {
      this->Helpers.push_back(std::make_unique<Helper>(member, size));
    }
  }

  int Size() const override { return static_cast<int>(this->Helpers.size()) + 1; }
  int Own() const override { return 0; }
  void Send(const Bytes&) override { ADD_FAILURE() << "the first sends nothing"; }
  Bytes Await() override { return {}; }

  void Call() override
  {
    ++this->NumberOfCalls;
    for (const auto& helper : this->Helpers)
    {
      helper->Start(this->Work);
    }
  }

  Bytes Receive(int member, Monitor&) override
  {
    Bytes bytes = this->Of(member).ToFirst.Take();
    this->NumberOfBytes += bytes.size();
    this->AreWaiting[static_cast<std::size_t>(member)] = !bytes.empty();
    this->Spoil(member, bytes);
    return bytes;
  }

  void Reply(int member, const Bytes& bytes) override
  {
    EXPECT_TRUE(this->AreWaiting[static_cast<std::size_t>(member)]);
    this->AreWaiting[static_cast<std::size_t>(member)] = false;
    this->Of(member).FromFirst.Put(bytes);
  }

  /// All have their pieces then; who still waits, or will, gets nothing more.
  void End()
  {
    for (const auto& helper : this->Helpers)
    {
      helper->FromFirst.Put({});
      if (helper->Thread.joinable())
      {
        helper->Thread.join();
      }
    }
  }

  Helper& Of(int member) { return *this->Helpers[static_cast<std::size_t>(member) - 1]; }

  int NumberOfCalls = 0;
  std::size_t NumberOfBytes = 0; ///< that the others sent

private:
  std::vector<bool> AreWaiting; ///< for a reply
  std::vector<std::unique_ptr<Helper>> Helpers;
  std::function<BitingMesh(Crew&)> Work;
  std::function<void(int, Bytes&)> Spoil;
};

} // namespace biting

#endif
