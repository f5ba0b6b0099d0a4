// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingChainReduction_h
#define BitingChainReduction_h

#include "../Base/Ids.h"
#include "../Base/Pulse.h"
#include "../Domain/Domain.h"
#include "DomainChains.h"
#include "VertexTree.h"

#include <cstddef> // for size_t
#include <cstdint> // for flags
#include <queue>   // for candidates
#include <set>     // for chords
#include <utility> // for pair
#include <vector>  // for the arrays

namespace biting
{

/// Keeps chains from ending in points where the drawing is blunt: a triangle in a sharp corner of
/// the domain is as sharp, whatever the spacing.
///
/// A vertex stays while its removal would decrease an inner angle of the domain at a neighbour to
/// below 36 degrees. This holds at ends far narrower than f, too: two vertices there make a
/// triangle as narrow as the end, which is less sharp than the corner along the whole sides.
class CornerGuard
{
public:
  /// Refers to its arguments.
  CornerGuard(const Domain& domain, const DomainChains& chains);

  /// The vertices on the other sides of the angles that would be too small. Where there is none the
  /// slot may go; else it is to be asked again when one of them has gone.
  std::vector<Id> FindOtherSides(Id slot) const;

private:
  void FindOtherSidesAt(Id near, Id slot, Id far, std::vector<Id>& found) const;
  bool IsSharpened(Id near, Id slot, Id far, Id other) const;
  bool IsInside(Id slot, Id next, bool isLeft) const;
  const Point2& At(Id slot) const { return this->Drawing.Vertices[this->Chains.Vertices[slot]]; }

  const Domain& Drawing;
  const DomainChains& Chains;
  std::vector<std::pair<Id, Id>> Ends; ///< vertex and slot of each open end, sorted
};

/// Takes vertices out of chains, those first that change the drawing least, as long as each segment
/// that is left lies within the tolerance of the vertices that it stands for.
///
/// The error of a vertex is that of the segment that would be left: the largest distance from it to
/// the vertices that it would stand for, each over its own tolerance. As the path between them runs
/// from end to end, every place of the segment has one of the path as near.
///
/// A vertex goes only where the closed triangle with its neighbours holds no other vertex that is
/// left: then no segment reaches into it either, as it could not leave, and what lies left and
/// right of the chain stays there. It also waits for the vertices in a triangle on the other side,
/// which is as high as the error: so the clearance that remains there is at least the distance
/// moved. A vertex that waits for another is asked again when that one goes.
class ChainReduction
{
public:
  /// Refers to its arguments. Tolerances: of each vertex of the domain, above zero.
  ChainReduction(const Domain& domain, const std::vector<double>& tolerances, DomainChains& chains,
    Pulse& pulse);

  /// Slots that stay from now on.
  void Keep(Id slot) { this->IsKept[slot] = 1; }

  /// Removes vertices with an error of at most `share` of the tolerance, until none is left.
  void ReduceTo(double share, Pulse& pulse);

  Id NumberOfRemoved() const { return this->Removed; }

  /// Whether the slot comes before another of equal error: by its place only, so that the numbering
  /// of vertices and the direction of chains play no part.
  bool IsFirst(Id slot, Id other) const;

private:
  /// A slot that may go, and the length of what would be left.
  struct Candidate
  {
    float Length;
    float Offset; ///< of the slot
    Id Slot;
    Id Version;
  };

  struct IsLater
  {
    const ChainReduction* Owner;
    bool operator()(const Candidate& a, const Candidate& b) const
    {
      return a.Length != b.Length ? a.Length > b.Length
        : a.Offset != b.Offset    ? a.Offset > b.Offset
                                  : this->Owner->At(b.Slot) < this->Owner->At(a.Slot);
    }
  };

  using Queue = std::priority_queue<Candidate, std::vector<Candidate>, IsLater>;

  struct Waiting
  {
    Id Slot;
    Id Version;
    Id Next; ///< that waits for the same vertex
  };

  void Measure(Id slot);
  double ErrorOf(Id slot) const;
  void File(Id slot, double error);
  Candidate TakeFirst();
  bool WouldCoincide(Id slot) const;
  std::vector<Id> FindObstacles(Id slot) const;
  Id FindObstacle(Id slot) const;
  Id FindObstacleBeyond(Id slot) const;
  void Wait(Id slot, Id obstacle);
  void Remove(Id slot);
  void Wake(Id vertex);
  bool IsChord(Id slot) const;
  std::pair<Id, Id> ChordOf(Id slot) const;
  const Point2& At(Id slot) const { return this->Drawing.Vertices[this->Chains.Vertices[slot]]; }

  const Domain& Drawing;
  const std::vector<double>& Tolerances;
  DomainChains& Chains;
  VertexTree Left;
  CornerGuard Corners;
  Point2 Middle; ///< mean of the vertices
  double Size;   ///< diagonal of the box around them
  double Limit = 0.0;
  Id Removed = 0;
  std::vector<std::uint8_t> IsKept; ///< of each slot
  std::vector<double> Errors;       ///< of each slot
  std::vector<Id> Versions;         ///< of each slot: how often it was measured
  std::vector<float> Offsets;       ///< of each slot, from the middle
  std::vector<Waiting> Waiters;
  std::vector<Id> FirstWaiters;       ///< of each vertex
  std::set<std::pair<Id, Id>> Chords; ///< vertices joined by a chain of one segment
  std::vector<Queue> Queues;          ///< one a class of errors
  std::size_t FirstQueue;             ///< all before it are empty
};

} // namespace biting

#endif
