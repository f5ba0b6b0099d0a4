// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "TriangleBuckets.h"

#include "../Base/Box.h"

#include <algorithm> // for max
#include <array>     // for quarters
#include <cmath>     // for abs
#include <numeric>   // for iota

namespace biting
{
namespace
{

/// A square with so few triangles is a leaf.
constexpr std::size_t EntriesPerLeaf = 20;

/// How often a triangle may be in lists, about. The levels above a leaf share that, or long
/// triangles and those around one vertex, which no squares tell apart, would multiply.
constexpr double MostCopies = 16.0;

constexpr int DeepestSquare = 24;

} // namespace

class TriangleBuckets::Builder
{
public:
  Builder(TriangleBuckets& whole, const std::vector<Point2>& points, const std::vector<Id>& corners,
    Pulse& pulse)
    : Whole(whole)
    , Points(points)
    , Corners(corners)
    , Beats(pulse)
  {
  }

  void Build()
  {
    Box2 box;
    for (const Id point : this->Corners)
    {
      box.Add(this->Points[static_cast<std::size_t>(point)]);
    }
    this->Whole.Tree = Orthtree<2>::Around(box.Low, box.High);
    std::vector<Id> all(this->Corners.size() / 3);
    std::iota(all.begin(), all.end(), 0);
    this->Refine(this->Whole.Tree.Root(), all, MostCopies);
    this->Whole.Tree.Finish();
  }

private:
  using Quarters = std::array<std::vector<Id>, 4>;

  void Refine(const Orthtree<2>::Cube& square, const std::vector<Id>& ids, double copies)
  {
    const bool isSmall = ids.size() <= EntriesPerLeaf || square.Level == DeepestSquare;
    const Quarters quarters = isSmall ? Quarters() : this->Deal(square, ids);
    double sum = 0.0;
    for (const std::vector<Id>& quarter : quarters)
    {
      sum += static_cast<double>(quarter.size());
    }
    const double copiesBelow = copies * static_cast<double>(ids.size()) / sum;
    if (isSmall || copiesBelow < 1.0 || this->Beats.HasStopped())
    {
      std::vector<Id>& lists = this->Whole.Lists;
      this->Whole.Tree.SetLeaf(square, ids.empty() ? 0 : static_cast<Id>(lists.size()));
      lists.insert(lists.end(), ids.empty() ? 0 : 1, static_cast<Id>(ids.size()));
      lists.insert(lists.end(), ids.begin(), ids.end());
      return;
    }
    this->Whole.Tree.Split(square);
    for (int quarter = 0; quarter < 4; ++quarter)
    {
      this->Refine(this->Whole.Tree.Child(square, quarter),
        quarters[static_cast<std::size_t>(quarter)], copiesBelow);
    }
  }

  /// To each quarter the triangles that may meet it, with room for rounding: a triangle too many
  /// costs nothing but time.
  Quarters Deal(const Orthtree<2>::Cube& square, const std::vector<Id>& ids)
  {
    const double half = 0.25000025 * square.Size;
    Quarters quarters;
    for (std::vector<Id>& quarter : quarters)
    {
      quarter.reserve(ids.size() / 2);
    }
    for (const Id id : ids)
    {
      this->Beats.Beat(1);
      const Point2 corners[3] = { this->CornerOf(id, 0), this->CornerOf(id, 1),
        this->CornerOf(id, 2) };
      Box2 box = Box2::Around(corners[0], corners[1]);
      box.Add(corners[2]);
      box.Grow(half);
      for (std::size_t quarter = 0; quarter < 4; ++quarter)
      {
        const Point2 center =
          square.At({ (quarter & 1) != 0 ? 0.75 : 0.25, (quarter & 2) != 0 ? 0.75 : 0.25 });
        if (box.Contains(center) && MayMeet(corners, center, half))
        {
          quarters[quarter].push_back(id);
        }
      }
    }
    return quarters;
  }

  /// Whether no side has all of the square on its outside.
  static bool MayMeet(const Point2* corners, const Point2& center, double half)
  {
    const double turn = Cross(corners[1] - corners[0], corners[2] - corners[0]);
    bool mayMeet = true;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Point2 side = corners[k == 2 ? 0 : k + 1] - corners[k];
      const double height = Cross(side, center - corners[k]);
      mayMeet &= (turn < 0.0 ? -height : height) >= -half * (std::abs(side.X) + std::abs(side.Y));
    }
    return mayMeet;
  }

  const Point2& CornerOf(Id triangle, std::size_t corner) const
  {
    const Id id = this->Corners[3 * static_cast<std::size_t>(triangle) + corner];
    return this->Points[static_cast<std::size_t>(id)];
  }

  TriangleBuckets& Whole;
  const std::vector<Point2>& Points;
  const std::vector<Id>& Corners;
  Pulse& Beats;
};

TriangleBuckets::TriangleBuckets(
  const std::vector<Point2>& points, const std::vector<Id>& corners, Pulse& pulse)
{
  Builder(*this, points, corners, pulse).Build();
}

} // namespace biting
