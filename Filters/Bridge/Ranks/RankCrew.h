// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingRankCrew_h
#define BitingRankCrew_h

#include "../../Kernel/Base/Crew.h"
#include "Ranks.h"

#include <cstdint> // for flags
#include <vector>  // for inputs

namespace biting
{

/// The ranks as a crew of the kernel. The first gives the gathered inputs to the others when it
/// calls them. All ranks make one, and end it with End, whatever happens between. It needs to look
/// for messages without waiting for them, which only vtkMPIController can: with any other, and
/// without MPI, the first rank works alone.
class RankCrew : public Crew
{
public:
  RankCrew(const Ranks& ranks, std::vector<WholeInput*> inputs);

  int Size() const override;
  int Own() const override { return this->IsFirst ? 0 : this->Rank; }
  void Call() override;
  std::vector<char> Receive(int member, Monitor& monitor) override;
  void Reply(int member, const std::vector<char>& bytes) override;
  void Send(const std::vector<char>& bytes) override;
  std::vector<char> Await() override;

  /// On the first rank: whether each member is at work, so that bytes will come from it.
  std::vector<bool> WhoIsAtWork() const;

  /// On the other ranks: waits for Call of the first rank, which gives them the inputs. False where
  /// the first rank has ended without a call.
  bool AwaitCall();

  /// On the other ranks, at work: whether their bytes are not wanted any more.
  bool IsDismissed() const;

  /// The first rank dismisses members that are at work or wait; a member at work sends no bytes.
  void End();

private:
  void ShareInputs();
  bool HasMessage(int rank, int tag) const;
  void SendBytes(const std::vector<char>& bytes, int rank);
  void ReceiveBytes(std::vector<char>& bytes, int rank);

  enum class State : std::uint8_t
  {
    Away,
    AtWork, ///< owes something to the first
    Waiting ///< for a reply
  };

  vtkMultiProcessController* Controller = nullptr; // null: the first rank works alone
  bool IsFirst;
  int Rank = 0;
  std::vector<WholeInput*> Inputs;
  bool IsCalled = false;        // or ended
  State OwnState = State::Away; // of the others
  std::vector<State> States;    // of the first: the members'
};

} // namespace biting

#endif
