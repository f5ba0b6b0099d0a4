// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingFrontOrder_h
#define BitingFrontOrder_h

#include "../Base/Ids.h"
#include "../Base/Point.h"

#include <array>   // for the rules
#include <cstddef> // for their places
#include <deque>   // for each line
#include <vector>  // for the lines

namespace biting
{

/// Which candidate of the front is bitten next.
enum class FrontOrder
{
  Layers, ///< first in, first out: layer by layer from the boundary; good candidates before others
  LargestY, ///< the paper's sweep (section 5)
  BestFirst ///< by the shape they promise, in 32 classes; first in, first out in each
};

/// A place of the front, as it was when the bite `Birth` made it.
struct Candidate
{
  Point2 Place;
  Id Birth = NoId;

  // Of a bisector point (Bisectors.h).
  Id Parents[2] = { NoId, NoId };
  int Class = 0; ///< 0 the best
};

/// Whether `a` is bitten after `b` in a sweep from the largest y down; equal y by age.
inline bool IsBelow(const Candidate& a, const Candidate& b)
{
  if (a.Place.Y != b.Place.Y)
  {
    return a.Place.Y < b.Place.Y;
  }
  return a.Birth != b.Birth ? a.Birth > b.Birth : a.Place.X > b.Place.X;
}

/// All that depends on the order. A new order is one more value above and one more rule below.
///
/// A candidate whose triangle misses its wanted lengths by m (Bisectors.h) has the class
/// min(m / ClassWidth, NumberOfClasses - 1), rounded down. The lowest class is taken first. Within
/// a class `ComesLater` decides; where there is none the oldest is taken first.
struct FrontRule
{
  FrontOrder Order;
  const char* Name;
  int NumberOfClasses;
  double ClassWidth;
  bool (*ComesLater)(const Candidate& a, const Candidate& b);
  bool MayCut; ///< a front in each block gives the mesh that one front gives, but at the cuts

  // Measured, for a mean edge length f.
  double CornerConstant;  ///< c_b of squares at corners
  double FaultsOfCircles; ///< faults per root of the slope (BiteTriangle.h)
};

/// In the order of the enumeration.
///
/// Classes, measured: 5 to 6 % in two classes gives the best mean shape on average over fields,
/// with squares and with circles; 16 to 64 classes of 1 to 5 % are alike.
inline constexpr std::array<FrontRule, 3> FrontRules{ {
  { FrontOrder::Layers, "layers", 2, 0.06, nullptr, true, 0.77, 0.2 },
  { FrontOrder::LargestY, "largest y", 1, 1.0, IsBelow, false, 0.80, 0.2 },
  { FrontOrder::BestFirst, "best first", 32, 0.02, nullptr, true, 0.77, 0.25 },
} };

constexpr bool AreInOrder()
{
  int next = 0;
  for (const FrontRule& rule : FrontRules)
  {
    if (static_cast<int>(rule.Order) != next++)
    {
      return false;
    }
  }
  return true;
}
static_assert(AreInOrder(), "a rule for each order, at its place");

constexpr const FrontRule& RuleOf(FrontOrder order)
{
  return FrontRules[static_cast<std::size_t>(order)];
}

/// The front as a set of candidates. Candidates that later bites cover stay in the queue until they
/// are taken: nothing is ever searched for or deleted.
/// One line a class, the best class first. A line is first in, first out, O(1) a candidate; where
/// the rule says which one comes later it is a heap, O(log n).
class CandidateQueue
{
public:
  explicit CandidateQueue(FrontOrder order)
    : Rule(RuleOf(order))
    , Lines(static_cast<std::size_t>(this->Rule.NumberOfClasses))
    , Best(this->Lines.size())
  {
  }

  bool IsEmpty() const { return this->Best == this->Lines.size(); }
  void Put(const Candidate& candidate);
  Candidate Take();

  /// The class of a candidate whose triangle misses its wanted lengths by `misfit` (FrontRule).
  int ClassOf(double misfit) const;

private:
  const FrontRule& Rule;
  std::vector<std::deque<Candidate>> Lines;
  std::size_t Best; ///< the first line that is not empty
};

} // namespace biting

#endif
