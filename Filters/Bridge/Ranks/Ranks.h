// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingRanks_h
#define BitingRanks_h

#include "../../vtkBitingCompat.h" // for the ABI namespace

#include "vtkSmartPointer.h" // for data objects

#include <functional> // for pieces
#include <vector>     // for buffers

VTK_ABI_NAMESPACE_BEGIN
class vtkAlgorithm;
class vtkDataObject;
class vtkInformation;
class vtkInformationVector;
class vtkMultiProcessController;
class vtkPolyData;
VTK_ABI_NAMESPACE_END

namespace biting
{

/// The pieces of all ranks, one after the other, as bytes. Only the first rank has them.
struct GatheredBytes
{
  bool IsComplete = true; ///< false: on some rank memory did not suffice, or it cannot be sent
  std::vector<char> Bytes;
  std::vector<vtkIdType> Offsets; ///< of each rank's piece, and the end
};

/// One message holds at most as many bytes as an int can count.
constexpr vtkIdType LargestMessage = vtkIdType{ 1 } << 30;

/// The processes that execute one filter together, each with a piece of the input: the first one
/// works on the whole. It has the output, and the others empty pieces with the same arrays; or each
/// has its own piece of the first output (RankCrew.h).
///
/// They are those of vtkMultiProcessController::GetGlobalController(), where as many pieces are
/// asked for as it has. A process that asks for one piece of one works alone, whatever the others
/// do. Where a process alone asks for a piece of several, the first piece is the whole. Every rank
/// calls the same methods in the same order, whatever happened on it: nothing waits for a rank that
/// went another way.
class Ranks
{
public:
  Ranks() = default; ///< this process alone
  Ranks(vtkInformation* request, vtkInformationVector* outputs);

  /// All processes, whatever is asked for, as for a writer, which has no output.
  static Ranks All();

  bool AreSeveral() const { return this->Controller != nullptr; }
  bool IsFirst() const { return this->Piece == 0; }
  int Count() const; ///< of the ranks; 1 where the process is alone

  /// Null where the process is alone.
  vtkMultiProcessController* Processes() const { return this->Controller; }

  /// In REQUEST_UPDATE_EXTENT: asks for the pieces that Gather takes, without ghosts.
  void AskForPieces(vtkInformationVector** inputs, int numberOfPorts) const;

  /// Asks an input for the piece of this rank, without ghosts.
  void AskForOwn(vtkInformation* input) const;

  /// The pieces of an input, where ranks are several.
  GatheredBytes Gather(vtkDataObject* piece) const;

  /// Broadcasts the outcome of the first rank, whose error code is returned. The outputs of other
  /// ranks become empty, with the arrays of the first rank's outputs; output 0 stays where each
  /// rank has a piece of it (`areSpread`, of the first rank). Where `filter` was stopped on the
  /// first rank it is stopped on all: the pipeline executes it again, and must do so on all ranks.
  unsigned long ShareOutcome(unsigned long errorCode, bool areSpread, vtkAlgorithm* filter,
    vtkInformationVector* outputs) const;

  /// The error code of the first rank; all ranks call this.
  unsigned long ShareCode(unsigned long errorCode) const;

  /// Sums, and the maximum, over all ranks; all of them call this.
  void AddUp(double* values, vtkIdType count) const;
  double Largest(double value) const;

private:
  bool CanReceive(bool isPacked, vtkIdType length, GatheredBytes& gathered) const;

  vtkMultiProcessController* Controller = nullptr; // null: this process is alone
  int Piece = 0;
};

/// The refusal where WholeInput is not complete.
constexpr const char* NotGathered =
  "The pieces of the input cannot be gathered on the first rank: they "
  "are too large for its memory, or of a kind that cannot be sent.";

/// The refusal where the whole must have the type of its pieces, and has not.
constexpr const char* NotOneGrid =
  "The pieces of the input are no single grid: they leave gaps, or lie on different axes.";

/// The whole of what is connected to an input port, which may be nothing.
class WholeInput
{
public:
  /// Gathers the pieces where ranks are several; all of them call this.
  WholeInput(const Ranks& ranks, vtkInformationVector* input);
  WholeInput(const Ranks& ranks, vtkDataObject* piece);

  /// False where the pieces did not come together: memory did not suffice, or there is no way to
  /// send data of this kind.
  bool IsComplete() const { return this->Gathered.IsComplete; }

  /// Broadcasts the gathered pieces from the first rank; all ranks call this. False where a rank
  /// has too little memory for them; then the other ranks have none.
  bool Share(vtkMultiProcessController* controller);

  /// On ranks that have the pieces; null where nothing is connected. Pieces that are equal byte by
  /// byte count once.
  vtkSmartPointer<vtkDataObject> Make() const;

private:
  vtkSmartPointer<vtkDataObject> Own; ///< where the process is alone
  GatheredBytes Gathered;
};

} // namespace biting

#endif
