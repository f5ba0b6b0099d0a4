// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "RankCrew.h"

#ifdef BITING_HAS_MPI
#include "vtkMPIController.h"
#else
#include "vtkMultiProcessController.h"
#endif

#include <algorithm> // for fill, min
#include <chrono>    // for pauses
#include <new>       // for bad_alloc
#include <thread>    // for pauses
#include <utility>   // for move

namespace biting
{

namespace
{

// A member sends a length, and the bytes where the answer is not 0. That answer comes once each
// time, and also before the length: then the member is dismissed. A reply is a length, which the
// member answers where it is not 0, and the bytes where it has room for them.
constexpr int LengthTag = 18421;
constexpr int AnswerTag = 18422;
constexpr int BytesTag = 18423;
constexpr int ReplyTag = 18424;
constexpr int ReadyTag = 18425;

constexpr std::chrono::milliseconds Pause(1);

// The processes, where messages can be looked for without waiting; else null.
vtkMultiProcessController* WithoutWaiting(vtkMultiProcessController* processes)
{
#ifdef BITING_HAS_MPI
  return vtkMPIController::SafeDownCast(processes);
#else
  return processes ? nullptr : processes;
#endif
}

// 1, and the bytes have that length, or 0.
int HasRoom(vtkIdType length, std::vector<char>& bytes)
{
  try
  {
    bytes.resize(static_cast<std::size_t>(length));
    return 1;
  }
  catch (const std::bad_alloc&)
  {
    return 0;
  }
}

} // namespace

RankCrew::RankCrew(const Ranks& ranks, std::vector<WholeInput*> inputs)
  : Controller(WithoutWaiting(ranks.Processes()))
  , IsFirst(ranks.IsFirst())
  , Rank(this->Controller ? this->Controller->GetLocalProcessId() : 0)
  , Inputs(std::move(inputs))
{
}

int RankCrew::Size() const
{
  return this->Controller ? this->Controller->GetNumberOfProcesses() : 1;
}

void RankCrew::Call()
{
  if (!this->Controller || this->IsCalled)
  {
    return;
  }
  int isWork = 1;
  this->Controller->Broadcast(&isWork, 1, 0);
  this->ShareInputs();
  this->States.assign(static_cast<std::size_t>(this->Size()), this->OwnState);
  this->States[0] = State::Away;
}

bool RankCrew::AwaitCall()
{
  int isWork = 0;
  if (this->Controller)
  {
    this->Controller->Broadcast(&isWork, 1, 0);
  }
  if (isWork != 0)
  {
    this->ShareInputs();
  }
  return this->OwnState == State::AtWork;
}

// They are not at work where some rank has no memory for them.
void RankCrew::ShareInputs()
{
  this->IsCalled = true;
  bool areShared = true;
  for (WholeInput* input : this->Inputs)
  {
    areShared = input->Share(this->Controller) && areShared;
  }
  this->OwnState = areShared ? State::AtWork : State::Away;
}

bool RankCrew::HasMessage([[maybe_unused]] int rank, [[maybe_unused]] int tag) const
{
  int isThere = 0;
#ifdef BITING_HAS_MPI
  int from = 0;
  static_cast<vtkMPIController*>(this->Controller)->Iprobe(rank, tag, &isThere, &from);
#endif
  return isThere != 0;
}

bool RankCrew::IsDismissed() const
{
  return this->HasMessage(0, AnswerTag);
}

std::vector<bool> RankCrew::WhoIsAtWork() const
{
  std::vector<bool> areAtWork;
  for (const State state : this->States)
  {
    areAtWork.push_back(state == State::AtWork);
  }
  return areAtWork;
}

void RankCrew::SendBytes(const std::vector<char>& bytes, int rank)
{
  for (std::size_t first = 0; first < bytes.size(); first += LargestMessage)
  {
    const std::size_t size = std::min<std::size_t>(bytes.size() - first, LargestMessage);
    this->Controller->Send(bytes.data() + first, static_cast<vtkIdType>(size), rank, BytesTag);
  }
}

void RankCrew::ReceiveBytes(std::vector<char>& bytes, int rank)
{
  for (std::size_t first = 0; first < bytes.size(); first += LargestMessage)
  {
    const std::size_t size = std::min<std::size_t>(bytes.size() - first, LargestMessage);
    this->Controller->Receive(bytes.data() + first, static_cast<vtkIdType>(size), rank, BytesTag);
  }
}

std::vector<char> RankCrew::Receive(int member, Monitor& monitor)
{
  std::vector<char> bytes;
  if (this->States.empty() || this->States[member] != State::AtWork)
  {
    return bytes;
  }
  while (!this->HasMessage(member, LengthTag))
  {
    if (!monitor.Advance(1.0))
    {
      return bytes;
    }
    std::this_thread::sleep_for(Pause);
  }
  vtkIdType length = 0;
  this->Controller->Receive(&length, 1, member, LengthTag);
  int isReady = HasRoom(length, bytes);
  this->States[member] = length > 0 && isReady != 0 ? State::Waiting : State::Away;
  this->Controller->Send(&isReady, 1, member, AnswerTag);
  this->ReceiveBytes(bytes, member);
  return bytes;
}

// A member that has no room for it goes away, and what it holds is lost.
void RankCrew::Reply(int member, const std::vector<char>& bytes)
{
  State& state = this->States[member];
  if (state != State::Waiting)
  {
    return;
  }
  const auto length = static_cast<vtkIdType>(bytes.size());
  this->Controller->Send(&length, 1, member, ReplyTag);
  state = State::Away;
  if (length > 0)
  {
    int isReady = 0;
    this->Controller->Receive(&isReady, 1, member, ReadyTag);
    if (isReady != 0)
    {
      this->SendBytes(bytes, member);
      state = State::AtWork;
    }
  }
}

void RankCrew::Send(const std::vector<char>& bytes)
{
  const auto length = static_cast<vtkIdType>(bytes.size());
  this->Controller->Send(&length, 1, 0, LengthTag);
  while (!this->HasMessage(0, AnswerTag))
  {
    std::this_thread::sleep_for(Pause);
  }
  int isWanted = 0;
  this->Controller->Receive(&isWanted, 1, 0, AnswerTag);
  this->OwnState = length > 0 && isWanted != 0 ? State::Waiting : State::Away;
  if (isWanted != 0)
  {
    this->SendBytes(bytes, 0);
  }
}

std::vector<char> RankCrew::Await()
{
  std::vector<char> bytes;
  if (this->OwnState != State::Waiting)
  {
    return bytes;
  }
  while (!this->HasMessage(0, ReplyTag))
  {
    std::this_thread::sleep_for(Pause);
  }
  this->OwnState = State::Away;
  vtkIdType length = 0;
  this->Controller->Receive(&length, 1, 0, ReplyTag);
  if (length > 0)
  {
    int isReady = HasRoom(length, bytes);
    this->Controller->Send(&isReady, 1, 0, ReadyTag);
    this->ReceiveBytes(bytes, 0);
    this->OwnState = isReady != 0 ? State::AtWork : State::Away;
  }
  return bytes;
}

void RankCrew::End()
{
  this->Await(); // for the others; what comes, if anything, has no use any more
  if (!this->IsFirst && this->OwnState == State::AtWork)
  {
    this->Send({});
  }
  if (!this->Controller || !this->IsFirst)
  {
    return;
  }
  int answer = 0;
  if (!this->IsCalled)
  {
    this->IsCalled = true;
    this->Controller->Broadcast(&answer, 1, 0);
  }
  for (int member = 1; member < static_cast<int>(this->States.size()); ++member)
  {
    this->Reply(member, {});
    if (this->States[member] == State::AtWork)
    {
      this->Controller->Send(&answer, 1, member, AnswerTag);
    }
  }
  for (int member = 1; member < static_cast<int>(this->States.size()); ++member)
  {
    if (this->States[member] == State::AtWork)
    {
      vtkIdType unused = 0;
      this->Controller->Receive(&unused, 1, member, LengthTag);
    }
  }
  this->States.clear();
}

} // namespace biting
