// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingBox2_h
#define BitingBox2_h

#include "Point2.h"

#include <algorithm> // for min, max
#include <limits>    // for an empty box

namespace biting
{

/// An axis-aligned box, closed; empty when Low exceeds High.
struct Box2
{
  Point2 Low{ std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity() };
  Point2 High{ -std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity() };

  /// The smallest one with both points.
  static Box2 Around(const Point2& a, const Point2& b)
  {
    return { { std::min(a.X, b.X), std::min(a.Y, b.Y) },
      { std::max(a.X, b.X), std::max(a.Y, b.Y) } };
  }

  void Add(const Point2& p)
  {
    this->Low = { std::min(this->Low.X, p.X), std::min(this->Low.Y, p.Y) };
    this->High = { std::max(this->High.X, p.X), std::max(this->High.Y, p.Y) };
  }

  void Grow(double margin)
  {
    this->Low = { this->Low.X - margin, this->Low.Y - margin };
    this->High = { this->High.X + margin, this->High.Y + margin };
  }

  bool IsEmpty() const { return this->Low.X > this->High.X || this->Low.Y > this->High.Y; }
  double Width() const { return this->High.X - this->Low.X; }
  double Height() const { return this->High.Y - this->Low.Y; }
  double Diagonal() const { return this->IsEmpty() ? 0.0 : Distance(this->Low, this->High); }
  Point2 Center() const { return Midpoint(this->Low, this->High); }

  bool Contains(const Point2& p) const
  {
    return p.X >= this->Low.X && p.X <= this->High.X && p.Y >= this->Low.Y && p.Y <= this->High.Y;
  }

  bool Meets(const Box2& other) const
  {
    return this->Low.X <= other.High.X && other.Low.X <= this->High.X &&
      this->Low.Y <= other.High.Y && other.Low.Y <= this->High.Y;
  }
};

} // namespace biting

#endif
