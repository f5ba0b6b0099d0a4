// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "JumpSquares.h"

#include <algorithm> // for any_of, min, max
#include <array>     // for samples
#include <cmath>     // for ceil, sqrt
#include <utility>   // for swap
#include <vector>    // for squares

namespace biting
{
namespace
{

/// Squares that are searched first, along the longer side of the bounds: more of them where the
/// border has more edges, as each has at most a few of the lines along which f jumps.
constexpr double LeastFirstSquares = 16.0;
constexpr double MostFirstSquares = 64.0;
constexpr double EdgesPerFirstSquare = 0.0625;

/// From this size on, g / f times its side, a square may have a straight piece of a jump.
constexpr double SquareOfPiece = 0.5;

/// How precisely its ends are found, and how far the jump may be from its middle, times g / f.
constexpr double EndPrecision = 0.01;
constexpr double LargestBend = 0.02;
constexpr int MostHalvings = 32; ///< to the rounding of coordinates, where f is less

/// The last squares, where jumps meet.
constexpr double LastSquare = 0.03;
constexpr int DeepestLevel = 24;

/// Where jumps are so long, in units of f, that more squares are needed, all of them stay larger:
/// then, where a jump is not straight, f is lowered beside it by what it could rise across a
/// square, but to no less than a share of it.
constexpr std::size_t MostSquares = 1 << 16;
constexpr double LeastShare = 0.25;
constexpr double LongestWay = 1.42; ///< in a square, in units of its side

/// Feet farther apart than this many times the points themselves belong to two parts of the border.
constexpr double LargestExpansion = 1.5;

class JumpFinder
{
public:
  JumpFinder(const TriangleInterpolator& field, const Box2& bounds, double gradation,
    ConeCollector& cones, Pulse& pulse)
    : Field(field)
    , Bounds(bounds)
    , Gradation(gradation)
    , SeenGradation(std::min(gradation, LargestSeenGradation))
    , Cones(cones)
    , Beats(pulse)
  {
  }

  void Run()
  {
    const double edges = static_cast<double>(this->Field.BorderEdges().size());
    const double wanted = std::sqrt(edges / EdgesPerFirstSquare);
    const double count = std::min(std::max(wanted, LeastFirstSquares), MostFirstSquares);
    double size = std::max(this->Bounds.Width(), this->Bounds.Height()) / count;
    std::vector<Square> squares = this->FirstSquares(size);
    for (int level = 0; !squares.empty() && !this->Beats.HasStopped(); ++level, size *= 0.5)
    {
      this->Beats.SetFraction(0.5 + 0.5 * level / (DeepestLevel + 1.0));
      this->NumberOfSquares += squares.size();
      const bool isLast = level == DeepestLevel || this->NumberOfSquares > MostSquares;
      squares = this->Search(squares, size, isLast);
    }
  }

private:
  struct Sample
  {
    Point2 Place;
    NearestValue Nearest;
    double Spacing;
  };

  /// Its corners (0, 0), (1, 0), (0, 1), (1, 1), and its center.
  using Square = std::array<Sample, 5>;

  std::vector<Square> FirstSquares(double size)
  {
    std::vector<Square> squares;
    const auto columns = static_cast<int>(std::ceil(this->Bounds.Width() / size));
    const auto rows = static_cast<int>(std::ceil(this->Bounds.Height() / size));
    std::vector<Sample> below;
    for (int row = 0; row <= rows; ++row)
    {
      std::vector<Sample> line;
      for (int column = 0; column <= columns && !this->Beats.HasStopped(); ++column)
      {
        const Point2 place = this->Bounds.Low + Point2{ column * size, row * size };
        line.push_back(this->TakeSample(place, column > 0 ? line.back() : Sample()));
        if (row > 0 && column > 0)
        {
          const auto left = static_cast<std::size_t>(column - 1);
          squares.push_back(
            this->MakeSquare(below[left], below[left + 1], line[left], line[left + 1]));
        }
      }
      below = line;
    }
    return squares;
  }

  /// It is found sooner with one beside it.
  Sample TakeSample(const Point2& place, const Sample& beside)
  {
    this->Beats.Beat(16);
    Sample sample;
    sample.Place = place;
    sample.Nearest = this->Field.Nearest(place, beside.Nearest);
    sample.Spacing = this->Cones.Values()(sample.Nearest.Value);
    return sample;
  }

  Sample Between(const Sample& a, const Sample& b)
  {
    return this->TakeSample(Midpoint(a.Place, b.Place), a);
  }

  Square MakeSquare(const Sample& a, const Sample& b, const Sample& c, const Sample& d)
  {
    return { a, b, c, d, this->Between(a, d) };
  }

  /// The quarters of those that are to be searched more finely.
  std::vector<Square> Search(const std::vector<Square>& squares, double size, bool isLast)
  {
    std::vector<Square> quarters;
    for (std::size_t k = 0; k < squares.size() && !this->Beats.HasStopped(); ++k)
    {
      const Square& square = squares[k];
      if (!this->AnyApart(square))
      {
        continue;
      }
      const double rise = this->SeenGradation * size;
      const double least = LeastOf(square);
      const bool isFine = rise <= LastSquare * least;
      const bool maybePiece = !isFine && (isLast || rise <= SquareOfPiece * least);
      if (maybePiece && this->AddPiece(square, least / this->SeenGradation))
      {
        continue;
      }
      if (isFine || isLast)
      {
        this->AddLowSides(square, isFine ? 0.0 : LongestWay * rise);
      }
      else
      {
        this->AddQuarters(square, quarters);
      }
    }
    return quarters;
  }

  /// Two samples on both sides of a jump.
  struct Crossing
  {
    Sample Low;
    Sample High;
  };

  /// The jump through a square, as one straight segment. False where it is not that simple.
  /// `unit` is f / g.
  bool AddPiece(const Square& square, double unit)
  {
    // Each corner has a part of the border; those of the first corner, and others.
    std::array<bool, 5> isOther{};
    for (std::size_t k = 1; k < square.size(); ++k)
    {
      isOther[k] = AreApart(square[0], square[k]);
    }
    constexpr std::array<std::array<std::size_t, 2>, 4> sides{ { { 0, 1 }, { 1, 3 }, { 3, 2 },
      { 2, 0 } } };
    std::vector<Crossing> crossings;
    for (const auto& [from, to] : sides)
    {
      if (isOther[from] != isOther[to])
      {
        crossings.push_back({ square[from], square[to] });
      }
    }
    return crossings.size() == 2 && AreTwoParts(square, isOther) &&
      this->Close(EndPrecision * unit, crossings[0]) &&
      this->Close(EndPrecision * unit, crossings[1]) &&
      this->AddBetween(crossings[0].Low, crossings[1].Low, LargestBend * unit);
  }

  static bool AreTwoParts(const Square& square, const std::array<bool, 5>& isOther)
  {
    bool areTwo = true;
    for (std::size_t k = 1; k < square.size(); ++k)
    {
      for (std::size_t other = 0; other < k; ++other)
      {
        areTwo = areTwo && (isOther[k] != isOther[other]) == AreApart(square[k], square[other]);
      }
    }
    return areTwo;
  }

  /// Halves the way between two samples until they are `near`. False where there is a third part.
  bool Close(double near, Crossing& crossing)
  {
    auto& [a, b] = crossing;
    for (int halving = 0; Distance(a.Place, b.Place) > near && halving < MostHalvings; ++halving)
    {
      const Sample middle = this->Between(a, b);
      const bool isOther = AreApart(a, middle);
      if (isOther == AreApart(middle, b))
      {
        return false;
      }
      (isOther ? b : a) = middle;
    }
    if (b.Spacing < a.Spacing)
    {
      std::swap(a, b);
    }
    return true;
  }

  /// Whether the low side is the same at both ends and, but for a `bend`, along the segment between
  /// them, and linear.
  bool AddBetween(const Sample& start, const Sample& end, double bend)
  {
    const Point2 along = end.Place - start.Place;
    const double length = Length(along);
    if (AreApart(start, end) || !(length > 0.0))
    {
      return false;
    }
    const Point2 middle = Midpoint(start.Place, end.Place);
    const Point2 aside = (bend / length) * Perpendicular(along);
    const Sample left = this->TakeSample(middle + aside, start);
    const Sample right = this->TakeSample(middle - aside, start);
    const bool isLeftLow = !AreApart(left, start);
    const Sample& low = isLeftLow ? left : right;
    const double mean = 0.5 * (start.Spacing + end.Spacing);
    const bool isPiece =
      isLeftLow == AreApart(right, start) && std::abs(low.Spacing - mean) <= LargestBend * mean;
    if (isPiece)
    {
      this->Cones.AddSegment(start.Place, end.Place, start.Spacing, end.Spacing);
    }
    return isPiece;
  }

  void AddQuarters(const Square& square, std::vector<Square>& quarters)
  {
    const auto& [a, b, c, d, center] = square;
    const Sample low = this->Between(a, b);
    const Sample left = this->Between(a, c);
    const Sample right = this->Between(b, d);
    const Sample high = this->Between(c, d);
    quarters.push_back(this->MakeSquare(a, low, left, center));
    quarters.push_back(this->MakeSquare(low, b, center, right));
    quarters.push_back(this->MakeSquare(left, center, c, high));
    quarters.push_back(this->MakeSquare(center, right, high, d));
  }

  static double LeastOf(const Square& samples)
  {
    double least = samples[0].Spacing;
    for (const Sample& sample : samples)
    {
      least = std::min(least, sample.Spacing);
    }
    return least;
  }

  bool AnyApart(const Square& samples) const
  {
    for (std::size_t k = 1; k < samples.size(); ++k)
    {
      for (std::size_t other = 0; other < k; ++other)
      {
        if (AreApart(samples[k], samples[other]))
        {
          return true;
        }
      }
    }
    return false;
  }

  static bool AreApart(const Sample& a, const Sample& b)
  {
    const double jump = std::abs(a.Spacing - b.Spacing);
    return a.Nearest.Distance + b.Nearest.Distance > 0.0 &&
      jump > LeastJump * std::min(a.Spacing, b.Spacing) &&
      Distance(a.Nearest.Foot, b.Nearest.Foot) > LargestExpansion * Distance(a.Place, b.Place);
  }

  void AddLowSides(const Square& samples, double lowering)
  {
    for (const Sample& sample : samples)
    {
      const bool isLow = std::any_of(samples.begin(), samples.end(),
        [this, &sample](const Sample& other) {
          return other.Spacing >
            sample.Spacing + this->Gradation * Distance(sample.Place, other.Place);
        });
      if (isLow)
      {
        this->Cones.AddPoint(
          sample.Place, std::max(sample.Spacing - lowering, LeastShare * sample.Spacing));
      }
    }
  }

  const TriangleInterpolator& Field;
  const Box2& Bounds;
  const double Gradation;
  const double SeenGradation;
  ConeCollector& Cones;
  Pulse& Beats;
  std::size_t NumberOfSquares = 0;
};

} // namespace

void AddJumpSquares(const TriangleInterpolator& field, const Box2& bounds, double gradation,
  ConeCollector& cones, Pulse& pulse)
{
  JumpFinder(field, bounds, gradation, cones, pulse).Run();
}

} // namespace biting
