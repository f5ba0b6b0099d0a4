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

/// The root is larger by that, so that its squares do not touch all triangles of a lattice beside.
constexpr double OddShare = 1.0 / 300.0;

/// For rounding, in sizes of a square.
constexpr double Room = 5e-7;

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
    Box2 box = Box2::Around(this->Points, this->Corners);
    box.Grow(OddShare * std::max(box.Width(), box.Height()));
    this->Whole.Tree = Orthtree<2>::Around(box.Low, box.High);
    std::vector<Id> all(this->Corners.size() / 3);
    std::iota(all.begin(), all.end(), 0);
    this->Refine(this->Whole.Tree.Root(), std::move(all), MostCopies);
    this->Whole.Tree.Finish();
  }

private:
  using Square = Orthtree<2>::Cube;
  using Quarters = std::array<std::vector<Id>, 4>;

  void Refine(const Square& square, std::vector<Id> triangles, double copies)
  {
    if (triangles.size() > EntriesPerLeaf && square.Level < DeepestSquare &&
      !this->Beats.HasStopped())
    {
      Quarters quarters = this->Deal(square, triangles);
      std::size_t dealt = 0;
      for (const std::vector<Id>& quarter : quarters)
      {
        dealt += quarter.size();
      }
      const double copiesBelow =
        copies * static_cast<double>(triangles.size()) / static_cast<double>(dealt);
      if (copiesBelow >= 1.0)
      {
        std::vector<Id>().swap(triangles);
        this->Whole.Tree.Split(square);
        for (int quarter = 0; quarter < 4; ++quarter)
        {
          this->Refine(
            this->Whole.Tree.Child(square, quarter), std::move(quarters[quarter]), copiesBelow);
        }
        return;
      }
    }
    std::vector<Id>& lists = this->Whole.Lists;
    const bool isEmpty = triangles.empty();
    this->Whole.Tree.SetLeaf(square, isEmpty ? 0 : static_cast<Id>(lists.size()));
    lists.insert(lists.end(), isEmpty ? 0 : 1, static_cast<Id>(triangles.size()));
    lists.insert(lists.end(), triangles.begin(), triangles.end());
  }

  /// To each quarter of a square the triangles that may meet it, with room for rounding: a triangle
  /// too many costs nothing but time.
  Quarters Deal(const Square& square, const std::vector<Id>& triangles)
  {
    Quarters quarters;
    const double half = 0.5 * square.Size;
    const double reach = (0.5 + Room) * half;
    for (std::size_t k = 0; k < triangles.size() && this->Beats.Beat(1); ++k)
    {
      const Id id = triangles[k];
      const Point2 corners[3] = { this->CornerOf(id, 0), this->CornerOf(id, 1),
        this->CornerOf(id, 2) };
      Box2 box = Box2::Around(corners[0], corners[1]);
      box.Add(corners[2]);
      for (std::size_t quarter = 0; quarter < 4; ++quarter)
      {
        const Point2 center =
          square.At({ quarter % 2 == 0 ? 0.25 : 0.75, quarter < 2 ? 0.25 : 0.75 });
        Box2 around = Box2::Around(center, center);
        around.Grow(reach);
        if (around.Meets(box) && MayMeet(corners, center, reach))
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
    return this->Points[id];
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
