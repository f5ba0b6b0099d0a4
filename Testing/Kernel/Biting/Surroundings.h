// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingSurroundings_h
#define BitingSurroundings_h

#include "../Support/MeshShapes.h"
#include "Biting/BiteOutline.h"

namespace biting
{

/// Whether the others cover the outline of bite 0, by the cover at test.
template <typename Cover>
bool IsFull(const Bites& bites)
{
  Cover cover(bites, 0);
  for (Id other = 1; other < bites.Size(); ++other)
  {
    cover.Cover(other);
  }
  return cover.IsFull();
}

/// The same by its gaps.
inline bool HasGap(const Bites& bites)
{
  BiteOutline outline;
  outline.Begin(bites, 0);
  for (Id other = 1; other < bites.Size(); ++other)
  {
    outline.Cover(bites, other);
  }
  outline.Finish();
  for (int side = 0; side < 4; ++side)
  {
    if (!outline.Gaps(side).empty())
    {
      return true;
    }
  }
  return false;
}

enum class Mix
{
  Squares,
  Circles,
  Both
};

/// A bite among others that often surround it.
inline Bites RandomSurroundings(Mix mix, TestNumbers& numbers)
{
  Bites bites;
  const int count = 5 + numbers.Below(10);
  for (int k = 0; k < count; ++k)
  {
    const double angle = DegreesPerTurn * (k + numbers.Unit()) / (count - 1);
    const bool isCircle = mix == Mix::Circles || (mix == Mix::Both && numbers.Below(2) == 0);
    bites.Centers.push_back(k == 0 ? Point2{} : (0.6 + 0.6 * numbers.Unit()) * UnitVector(angle));
    bites.Axes.push_back(isCircle ? Point2{} : UnitVector(DegreesPerTurn * numbers.Unit()));
    bites.HalfWidths.push_back(0.7 + 0.4 * numbers.Unit());
  }
  return bites;
}

} // namespace biting

#endif
