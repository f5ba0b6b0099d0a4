// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "TriangleBuckets.h"

#include "../Base/Box.h"

#include <algorithm> // for min, max
#include <cmath>     // for abs, ilogb, sqrt
#include <numeric>   // for iota
#include <utility>   // for pairs

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
    this->Refine(this->Whole.Tree.Root(), all.data(), all.data() + all.size(), MostCopies);
    this->Whole.Tree.Finish();
  }

private:
  using Square = Orthtree<2>::Cube;

  /// The triangles of 4^Levels squares, row by row.
  struct Grid
  {
    int Levels;
    std::size_t Count; ///< of ids in all lists
    IdLists Lists;
  };

  void Refine(const Square& square, const Id* first, const Id* last, double copies)
  {
    const auto count = static_cast<std::size_t>(last - first);
    if (count > EntriesPerLeaf && square.Level < DeepestSquare && !this->Beats.HasStopped())
    {
      const Grid grid = this->Deal(square, first, last);
      const double copiesBelow =
        copies * static_cast<double>(count) / static_cast<double>(grid.Count);
      if (copiesBelow >= 1.0)
      {
        this->Descend(square, grid, grid.Levels, 0, copiesBelow);
        return;
      }
    }
    std::vector<Id>& lists = this->Whole.Lists;
    this->Whole.Tree.SetLeaf(square, count == 0 ? 0 : static_cast<Id>(lists.size()));
    lists.insert(lists.end(), count == 0 ? 0 : 1, static_cast<Id>(count));
    lists.insert(lists.end(), first, last);
  }

  /// Down to the squares of a grid; `place` is the lower left one of those in the square.
  void Descend(const Square& square, const Grid& grid, int levels, std::size_t place, double copies)
  {
    if (levels == 0)
    {
      const IdLists::List list = grid.Lists[static_cast<Id>(place)];
      this->Refine(square, list.begin(), list.end(), copies);
      return;
    }
    this->Whole.Tree.Split(square);
    for (int quarter = 0; quarter < 4; ++quarter)
    {
      const std::size_t row = quarter / 2 == 0 ? 0 : std::size_t(1) << grid.Levels;
      const std::size_t step = (row + static_cast<std::size_t>(quarter % 2)) << (levels - 1);
      this->Descend(
        this->Whole.Tree.Child(square, quarter), grid, levels - 1, place + step, copies);
    }
  }

  /// So many that a square has about EntriesPerLeaf, but no smaller than the triangles in the mean.
  int LevelsOf(const Square& square, const Id* first, const Id* last) const
  {
    double sum = 0.0;
    for (const Id* id = first; id != last; ++id)
    {
      const Box2 box = this->BoxOf(*id);
      sum += std::min(std::max(box.Width(), box.Height()), square.Size);
    }
    const auto count = static_cast<double>(last - first);
    const double squares = std::min(std::sqrt(count / 6.0), square.Size * count / sum);
    return std::min(std::max(std::ilogb(squares), 1), DeepestSquare - square.Level);
  }

  /// To each square of a grid the triangles that may meet it, with room for rounding: a triangle
  /// too many costs nothing but time.
  Grid Deal(const Square& square, const Id* first, const Id* last)
  {
    const int levels = this->LevelsOf(square, first, last);
    const std::size_t side = std::size_t(1) << levels;
    const double size = square.Size / static_cast<double>(side);
    std::vector<std::pair<Id, Id>> dealt;
    dealt.reserve(2 * static_cast<std::size_t>(last - first));
    for (const Id* id = first; id != last && this->Beats.Beat(1); ++id)
    {
      const Point2 corners[3] = { this->CornerOf(*id, 0), this->CornerOf(*id, 1),
        this->CornerOf(*id, 2) };
      const Box2 box = this->BoxOf(*id);
      const auto numberAt = [&square, size, side](const Point2& place, std::size_t d, double room)
      {
        const double number = (place[d] - square.Low[d]) / size + room;
        return static_cast<std::size_t>(
          std::min(std::max(number, 0.0), static_cast<double>(side - 1)));
      };
      for (std::size_t row = numberAt(box.Low, 1, -Room); row <= numberAt(box.High, 1, Room); ++row)
      {
        for (std::size_t column = numberAt(box.Low, 0, -Room);
             column <= numberAt(box.High, 0, Room); ++column)
        {
          const Point2 center = square.Low +
            size * Point2{ static_cast<double>(column) + 0.5, static_cast<double>(row) + 0.5 };
          if (MayMeet(corners, center, (0.5 + Room) * size))
          {
            dealt.emplace_back(static_cast<Id>(row * side + column), *id);
          }
        }
      }
    }
    return { levels, dealt.size(),
      IdLists(side * side,
        [&dealt](const auto& add)
        {
          for (const auto& [place, id] : dealt)
          {
            add(place, id);
          }
        }) };
  }

  Box2 BoxOf(Id triangle) const
  {
    Box2 box = Box2::Around(this->CornerOf(triangle, 0), this->CornerOf(triangle, 1));
    box.Add(this->CornerOf(triangle, 2));
    return box;
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
