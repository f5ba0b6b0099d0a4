// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingFaceEdge_h
#define BitingFaceEdge_h

#include "../Base/Ids.h"

#include <array> // for runs

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

  /// The chains of the first of these faces, those on the right as OtherSide of it; NoId after the
  /// last. Where more meet they overlap.
  std::array<Id, 3> Runs{ NoId, NoId, NoId };

  bool Stays = false; ///< as an interface, as all edges of faces are to

  static Id OtherSide(Id run) { return -2 - run; }
  static Id FaceOf(Id run) { return run < NoId ? OtherSide(run) : run; }
  Id First() const { return FaceOf(this->Runs[0]); }
  Id Second() const { return FaceOf(this->Runs[1]); }

  /// Adds the runs of `other`, which is directed the other way where `isReversed`.
  void Absorb(const FaceEdge& other, bool isReversed);
};

} // namespace biting

#endif
