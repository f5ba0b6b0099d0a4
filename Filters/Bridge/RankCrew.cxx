// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "RankCrew.h"

#ifdef BITING_HAS_MPI
#include "vtkMPIController.h"
#endif

#include <algorithm> // for fill, min
#include <chrono>    // for pauses
#include <new>       // for bad_alloc
#include <thread>    // for pauses
#include <utility>   // for move

namespace biting
{

#ifdef BITING_HAS_MPI

namespace
{

// A member sends a length, and the bytes where the answer is not 0. That answer comes once, and
// also before the length: then the member is dismissed.
constexpr int LengthTag = 18421;
constexpr int AnswerTag = 18422;
constexpr int BytesTag = 18423;

constexpr std::chrono::milliseconds Pause(1);

} // namespace

RankCrew::RankCrew(const Ranks& ranks, std::vector<WholeInput*> inputs)
  : Controller(vtkMPIController::SafeDownCast(ranks.Processes()))
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
  this->AreAtWork.assign(static_cast<std::size_t>(this->Size()), this->IsAtWork ? 1 : 0);
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
  return this->IsAtWork;
}

// They are not at work where some rank has no memory for them.
void RankCrew::ShareInputs()
{
  this->IsCalled = true;
  this->IsAtWork = true;
  for (WholeInput* input : this->Inputs)
  {
    this->IsAtWork = input->Share(this->Controller) && this->IsAtWork;
  }
}

bool RankCrew::HasMessage(int rank, int tag) const
{
  int isThere = 0;
  int from = 0;
  this->Controller->Iprobe(rank, tag, &isThere, &from);
  return isThere != 0;
}

bool RankCrew::IsDismissed() const
{
  return this->HasMessage(0, AnswerTag);
}

std::vector<char> RankCrew::Receive(int member, Monitor& monitor)
{
  std::vector<char> bytes;
  if (this->AreAtWork.empty() || this->AreAtWork[static_cast<std::size_t>(member)] == 0)
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
  this->AreAtWork[static_cast<std::size_t>(member)] = 0;
  vtkIdType length = 0;
  this->Controller->Receive(&length, 1, member, LengthTag);
  int isReady = 1;
  try
  {
    bytes.resize(static_cast<std::size_t>(length));
  }
  catch (const std::bad_alloc&)
  {
    isReady = 0;
  }
  this->Controller->Send(&isReady, 1, member, AnswerTag);
  for (std::size_t first = 0; first < bytes.size(); first += LargestMessage)
  {
    const std::size_t size = std::min<std::size_t>(bytes.size() - first, LargestMessage);
    this->Controller->Receive(bytes.data() + first, static_cast<vtkIdType>(size), member, BytesTag);
  }
  return bytes;
}

void RankCrew::Send(const std::vector<char>& bytes)
{
  this->IsAtWork = false;
  const auto length = static_cast<vtkIdType>(bytes.size());
  this->Controller->Send(&length, 1, 0, LengthTag);
  while (!this->HasMessage(0, AnswerTag))
  {
    std::this_thread::sleep_for(Pause);
  }
  int isWanted = 0;
  this->Controller->Receive(&isWanted, 1, 0, AnswerTag);
  for (std::size_t first = 0; first < bytes.size() && isWanted != 0; first += LargestMessage)
  {
    const std::size_t size = std::min<std::size_t>(bytes.size() - first, LargestMessage);
    this->Controller->Send(bytes.data() + first, static_cast<vtkIdType>(size), 0, BytesTag);
  }
}

void RankCrew::End()
{
  if (!this->IsFirst && this->IsAtWork)
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
  for (int member = 1; member < static_cast<int>(this->AreAtWork.size()); ++member)
  {
    if (this->AreAtWork[static_cast<std::size_t>(member)] != 0)
    {
      this->Controller->Send(&answer, 1, member, AnswerTag);
    }
  }
  for (int member = 1; member < static_cast<int>(this->AreAtWork.size()); ++member)
  {
    if (this->AreAtWork[static_cast<std::size_t>(member)] != 0)
    {
      vtkIdType unused = 0;
      this->Controller->Receive(&unused, 1, member, LengthTag);
    }
  }
  this->AreAtWork.clear();
}

#else

RankCrew::RankCrew(const Ranks& ranks, std::vector<WholeInput*>)
  : IsFirst(ranks.IsFirst())
{
}

int RankCrew::Size() const
{
  return 1;
}

void RankCrew::Call() {}

std::vector<char> RankCrew::Receive(int, Monitor&)
{
  return {};
}

void RankCrew::Send(const std::vector<char>&) {}

bool RankCrew::AwaitCall()
{
  return false;
}

bool RankCrew::IsDismissed() const
{
  return false;
}

void RankCrew::End() {}

#endif

} // namespace biting
