// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingFaceEdge_h
#define BitingFaceEdge_h

#include "../Base/Ids.h"

#include <array>   // for runs
#include <utility> // for pair
#include <vector>  // for more runs

namespace biting
{

/// What faces have to do with an edge of the arrangement. A face that runs along it there and back
/// has no area there, and nothing to do with it.
struct FaceEdge
{
  Id Count = 0; ///< how often outlines of faces run along it

  /// How many of the faces lie on its left, less those on its right. Those that are thinner than
  /// rounding lie on neither.
  Id Turn = 0;

  /// The chains of these faces, those on the right as OtherSide of it; NoId after the last. More
  /// than three only where faces overlap: the ordinary edge allocates nothing.
  std::array<Id, 3> Runs{ NoId, NoId, NoId };
  std::vector<Id> MoreRuns;

  bool Stays = false; ///< as an interface, as all edges of faces are to

  static Id OtherSide(Id run) { return -2 - run; }
  static Id FaceOf(Id run) { return run < NoId ? OtherSide(run) : run; }
  Id First() const { return FaceOf(this->Runs[0]); }
  Id Second() const { return FaceOf(this->Runs[1]); }

  /// The faces that run along it an odd number of times. By parity the others are on both of its
  /// sides, or on none.
  std::vector<Id> OddFaces() const;

  /// The same, if these are two: NoId twice otherwise.
  std::pair<Id, Id> OddPair() const;

  /// Adds a run; one that goes the other way goes with it.
  void AddRun(Id run);

  /// Adds the runs of `other`, which is directed the other way where `isReversed`.
  void Absorb(const FaceEdge& other, bool isReversed);

private:
  Id RunAt(Id k) const;
  Id& RunAt(Id k);
};

} // namespace biting

#endif
