// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingBox_h
#define BitingBox_h

#include "Point.h"

#include <algorithm> // for min, max
#include <limits>    // for an empty box
#include <vector>    // for points

namespace biting
{

/// An axis-aligned box of the plane or of space, closed; empty when Low exceeds High.
template <std::size_t D>
struct Box
{
  Point<D> Low = Filled(std::numeric_limits<double>::infinity());
  Point<D> High = Filled(-std::numeric_limits<double>::infinity());

  /// The smallest one with both points.
  static Box Around(const Point<D>& a, const Point<D>& b)
  {
    Box box{ a, a };
    box.Add(b);
    return box;
  }

  /// The smallest one with all of `points`.
  template <typename Points>
  static Box Around(const Points& points)
  {
    Box box;
    for (const Point<D>& point : points)
    {
      box.Add(point);
    }
    return box;
  }

  /// The smallest one with those of `points` that `ids` number.
  template <typename Ids>
  static Box Around(const std::vector<Point<D>>& points, const Ids& ids)
  {
    Box box;
    for (const auto id : ids)
    {
      box.Add(points[id]);
    }
    return box;
  }

  void Add(const Point<D>& p)
  {
    for (std::size_t d = 0; d < D; ++d)
    {
      this->Low[d] = std::min(this->Low[d], p[d]);
      this->High[d] = std::max(this->High[d], p[d]);
    }
  }

  void Grow(double margin)
  {
    this->Low = this->Low - Filled(margin);
    this->High = this->High + Filled(margin);
  }

  bool IsEmpty() const { return !this->Meets(*this); }
  double Size(std::size_t d) const { return this->High[d] - this->Low[d]; }
  double Width() const { return this->Size(0); }
  double Height() const { return this->Size(1); }
  double Diagonal() const { return this->IsEmpty() ? 0.0 : Distance(this->Low, this->High); }
  Point<D> Center() const { return Midpoint(this->Low, this->High); }
  bool Contains(const Point<D>& p) const { return this->Meets({ p, p }); }

  bool Meets(const Box& other) const
  {
    bool meets = true;
    for (std::size_t d = 0; d < D; ++d)
    {
      meets = meets && this->Low[d] <= other.High[d] && other.Low[d] <= this->High[d];
    }
    return meets;
  }

  double DistanceTo(const Point<D>& p) const
  {
    Point<D> apart;
    for (std::size_t d = 0; d < D; ++d)
    {
      apart[d] = p[d] - std::min(this->High[d], std::max(this->Low[d], p[d]));
    }
    return Length(apart);
  }

private:
  static Point<D> Filled(double value)
  {
    Point<D> point;
    for (std::size_t d = 0; d < D; ++d)
    {
      point[d] = value;
    }
    return point;
  }
};

using Box2 = Box<2>;
using Box3 = Box<3>;

} // namespace biting

#endif
