// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "FlatTriangles.h"

#include "../Base/DisjointSets.h"
#include "../Predicates/Predicates.h"
#include "../Quality/TriangleLinks.h"

#include <algorithm> // for copy, find, max, minmax, remove_if
#include <cmath>     // for abs
#include <numeric>   // for iota

namespace biting
{

namespace
{

// Where flat triangles lie side by side, each round mends those at the rim of what is left: so many
// rounds, and more where they look at few triangles. After so many that leave no fewer none will:
// flat triangles that only divide each other come back as they were.
constexpr std::size_t FewRounds = 32;
constexpr std::size_t FewLooks = 4000000;

class FlatRepair
{
public:
  FlatRepair(const std::vector<Point2>& points, double rounding, std::vector<Id>& corners,
    std::size_t filled)
    : Points(points)
    , Rounding(rounding)
    , Corners(corners)
    , FirstFilled(static_cast<Id>(corners.size() / 3 - filled))
  {
  }

  FlatTriangleRepair Run()
  {
    std::vector<Id> flat = this->FindFlat();
    if (static_cast<Id>(flat.size()) == this->NumberOfTriangles())
    {
      return {};
    }
    const std::size_t looks = std::max(this->Corners.size() / 3, this->Points.size());
    std::size_t rounds = std::max(FewRounds, FewLooks / looks);
    std::size_t fewest = flat.size();
    std::size_t idle = 0;
    while (rounds-- > 0 && idle++ < FewRounds && !flat.empty())
    {
      this->Begin();
      idle = this->MendAll(flat) ? idle : FewRounds;
      this->Pack();
      flat = this->FindFlat();
      if (flat.size() < fewest)
      {
        fewest = flat.size();
        idle = 0;
      }
    }
    return std::move(this->Result);
  }

private:
  const Point2& Place(Id triangle, Id corner) const
  {
    return this->Points[this->Corners[3 * triangle + corner]];
  }
  int SideOf(Id triangle) const
  {
    return Orient2D(this->Place(triangle, 0), this->Place(triangle, 1), this->Place(triangle, 2));
  }
  Id NumberOfTriangles() const { return static_cast<Id>(this->Corners.size() / 3); }
  Id OriginOf(Id triangle) const
  {
    return this->Result.Origins.empty() ? triangle : this->Result.Origins[triangle];
  }
  bool IsFilled(Id triangle) const { return this->OriginOf(triangle) >= this->FirstFilled; }

  // Links are only made where there are thin ones.
  std::vector<Id> FindFlat()
  {
    std::vector<Id> flat;
    for (Id triangle = 0; triangle < this->NumberOfTriangles(); ++triangle)
    {
      if (this->IsThin(triangle))
      {
        flat.push_back(triangle);
      }
    }
    if (!flat.empty())
    {
      this->Links = LinkTriangles(this->Corners, static_cast<Id>(this->Points.size()));
      const auto isFine = [this](Id triangle) {
        return this->SideOf(triangle) != 0 && !this->IsFilled(triangle) &&
          !this->IsTurned(triangle);
      };
      flat.erase(std::remove_if(flat.begin(), flat.end(), isFine), flat.end());
    }
    return flat;
  }

  // Most triangles are clearly not, whatever their longest side is: it is shorter than the root of
  // the sum of the squares of all, and the error of a cross product is below 1e-15 of that sum.
  bool IsThin(Id triangle) const
  {
    const Point2 ab = this->Place(triangle, 1) - this->Place(triangle, 0);
    const Point2 ac = this->Place(triangle, 2) - this->Place(triangle, 0);
    const double squares = Dot(ab, ab) + Dot(ac, ac) + Dot(ac - ab, ac - ab);
    const double area = Cross(ab, ac);
    const double least = 8.0 * this->Rounding * this->Rounding + 1e-28 * squares;
    if (area * area > least * squares)
    {
      return false;
    }
    const Id top = this->TopOf(triangle);
    const Point2& start = this->Place(triangle, (top + 1) % 3);
    const Point2& end = this->Place(triangle, (top + 2) % 3);
    return std::abs(Cross(end - start, this->Place(triangle, top) - start)) <=
      this->Rounding * Distance(start, end) ||
      this->SideOf(triangle) == 0;
  }

  /// Whether another triangle lies on the same side of one of its sides.
  bool IsTurned(Id triangle) const
  {
    for (Id corner = 0; corner < 3; ++corner)
    {
      const Id start = this->Corners[3 * triangle + (corner + 1) % 3];
      const Id end = this->Corners[3 * triangle + (corner + 2) % 3];
      const Id neighbor = this->Links.Neighbors[3 * triangle + corner];
      for (Id other = 0; neighbor != NoId && other < 3; ++other)
      {
        const Id apex = this->Corners[3 * neighbor + other];
        const Point2& a = this->Points[start];
        const Point2& b = this->Points[end];
        if (apex != start && apex != end &&
          Orient2D(a, b, this->Points[apex]) == Orient2D(a, b, this->Place(triangle, corner)))
        {
          return true;
        }
      }
    }
    return false;
  }

  /// The corner across the longest side.
  Id TopOf(Id triangle) const
  {
    Id top = 0;
    double longest = -1.0;
    for (Id corner = 0; corner < 3; ++corner)
    {
      const double length =
        Distance(this->Place(triangle, (corner + 1) % 3), this->Place(triangle, (corner + 2) % 3));
      top = length > longest ? corner : top;
      longest = std::max(longest, length);
    }
    return top;
  }

  void Begin()
  {
    const auto triangles = static_cast<std::size_t>(this->NumberOfTriangles());
    if (this->Result.Origins.empty())
    {
      this->Result.Origins.resize(triangles);
      std::iota(this->Result.Origins.begin(), this->Result.Origins.end(), 0);
      this->Result.IsNew.assign(triangles, 0);
      this->IsTold.assign(triangles, 0);
    }
    this->Places = DisjointSets(this->Points.size());
    this->IsTouched.assign(triangles, 0);
    this->IsGone.assign(triangles, 0);
  }

  /// Whether there was anything to do.
  bool MendAll(const std::vector<Id>& flat)
  {
    for (const Id triangle : flat)
    {
      const Id top = this->TopOf(triangle);
      const Id neighbor = this->Links.Neighbors[3 * triangle + top];
      if (this->IsTouched[triangle] || this->Weld(triangle))
      {
        continue;
      }
      if (neighbor == NoId)
      {
        this->TellDivided(triangle, top);
        this->Remove(triangle);
      }
      else if (!this->IsTouched[neighbor])
      {
        this->Divide(triangle, top, neighbor);
      }
    }
    return std::find(this->IsTouched.begin(), this->IsTouched.end(), 1) != this->IsTouched.end();
  }

  /// Makes two corners at one place one, if there are such.
  bool Weld(Id triangle)
  {
    for (Id corner = 0; corner < 3; ++corner)
    {
      const Id one = this->Corners[3 * triangle + corner];
      const Id other = this->Corners[3 * triangle + (corner + 1) % 3];
      if (this->Points[one] == this->Points[other])
      {
        const auto [stays, goes] =
          std::minmax({ this->Places.SetOf(one), this->Places.SetOf(other) });
        if (stays != goes)
        {
          this->Places.Unite(stays, goes);
          this->Result.Welded.emplace_back(goes, stays);
        }
        this->Remove(triangle);
        return true;
      }
    }
    return false;
  }

  void Remove(Id triangle)
  {
    this->IsTouched[triangle] = 1;
    this->IsGone[triangle] = 1;
    this->Tell(triangle);
    const Id* corners = this->Corners.data() + 3 * static_cast<std::size_t>(triangle);
    this->Result.RimVertices.insert(this->Result.RimVertices.end(), corners, corners + 3);
  }

  // Parts of a flat one that another divided are flat again.
  void Tell(Id triangle)
  {
    std::uint8_t& isTold = this->IsTold[this->Result.Origins[triangle]];
    if (isTold)
    {
      return;
    }
    isTold = 1;
    if (this->IsFilled(triangle))
    {
      return;
    }
    const Point2 sum =
      this->Place(triangle, 0) + this->Place(triangle, 1) + this->Place(triangle, 2);
    this->Result.Flat.push_back({ this->Result.Origins[triangle], (1.0 / 3.0) * sum });
  }

  void TellDivided(Id triangle, Id top)
  {
    const Id* corners = this->Corners.data() + 3 * static_cast<std::size_t>(triangle);
    this->Result.Divided.push_back(
      { corners[(top + 1) % 3], corners[(top + 2) % 3], corners[top] });
  }

  void Divide(Id triangle, Id top, Id neighbor)
  {
    Id* const flat = this->Corners.data() + 3 * static_cast<std::size_t>(triangle);
    Id* const other = this->Corners.data() + 3 * static_cast<std::size_t>(neighbor);
    const Id middle = flat[top];
    const Id start = flat[(top + 1) % 3];
    const Id end = flat[(top + 2) % 3];
    Id* const atStart = std::find(other, other + 3, start);
    Id* const atEnd = std::find(other, other + 3, end);
    if (neighbor == triangle || atStart == other + 3 || atEnd == other + 3)
    {
      return; // more than two triangles at that side
    }
    this->Tell(triangle);
    this->TellDivided(triangle, top);
    std::copy(other, other + 3, flat);
    flat[atEnd - other] = middle;
    *atStart = middle;
    for (const Id changed : { triangle, neighbor })
    {
      this->IsTouched[changed] = 1;
      this->Result.Origins[changed] = this->Result.Origins[neighbor];
      this->Result.IsNew[changed] = 1;
    }
  }

  // Triangles that are left move up.
  void Pack()
  {
    std::size_t left = 0;
    for (Id triangle = 0; triangle < this->NumberOfTriangles(); ++triangle)
    {
      if (this->IsGone[triangle])
      {
        continue;
      }
      std::uint8_t isNew = this->Result.IsNew[triangle];
      for (Id corner = 0; corner < 3; ++corner)
      {
        const Id before = this->Corners[3 * triangle + corner];
        const Id now = this->Places.SetOf(before);
        this->Corners[3 * left + static_cast<std::size_t>(corner)] = now;
        isNew |= now != before ? 1 : 0;
      }
      this->Result.Origins[left] = this->Result.Origins[triangle];
      this->Result.IsNew[left++] = isNew;
    }
    this->Corners.resize(3 * left);
    this->Result.Origins.resize(left);
    this->Result.IsNew.resize(left);
  }

  const std::vector<Point2>& Points;
  double Rounding;
  std::vector<Id>& Corners;
  Id FirstFilled; ///< of the triangles that were there
  TriangleLinks Links;
  DisjointSets Places;                 ///< vertices at one place
  std::vector<std::uint8_t> IsTouched; ///< of each triangle: changed in this round
  std::vector<std::uint8_t> IsGone;    ///< of each triangle
  std::vector<std::uint8_t> IsTold;    ///< of each triangle that was there
  FlatTriangleRepair Result;
};

} // namespace

FlatTriangleRepair RepairFlatTriangles(
  const std::vector<Point2>& points, double rounding, std::vector<Id>& corners, std::size_t filled)
{
  return FlatRepair(points, rounding, corners, filled).Run();
}

} // namespace biting
