// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "../Support/BitingSettings.h"
#include "../Support/MeshRun.h"
#include "../Support/MeshShapes.h"
#include "Biting/BiteOutline.h"
#include "Domain/DomainLocator.h"

#include <gtest/gtest.h>

#include <algorithm> // for sort, max_element
#include <cmath>     // for hypot

namespace biting
{

namespace
{

Polylines DividedPlate()
{
  return PolylineBuilder()
    .Loop({ { 0.0, 0.0 }, { 1.0, 0.0 }, { 1.0, 0.25 }, { 1.0, 1.0 }, { 0.0, 1.0 }, { 0.0, 0.25 } })
    .Loop(RegularPolygon({ 0.5, 0.6 }, 0.2, 15))
    .Chain({ { 0.0, 0.25 }, { 1.0, 0.25 } })
    .Lines();
}

Polylines TurnedSquare()
{
  return PolylineBuilder().Loop(RegularPolygon({ 0.5, 0.5 }, 0.7, 4, 20.0)).Lines();
}

std::vector<BitingMeshOptions> Fields(const BitingSetting& setting)
{
  std::vector<BitingMeshOptions> fields(3);
  fields[0].Spacing = UniformSpacing(0.05);
  fields[0].BitingConstant = 0.5; // many sides that coincide
  fields[1].Spacing = UniformSpacing(0.07);
  fields[2].Spacing = RadialSpacing({ 0.4, 0.3 }, 0.02, 0.15);
  for (BitingMeshOptions& field : fields)
  {
    setting.SetIn(field);
    field.KeepBites = true;
  }
  return fields;
}

struct PieceEnd
{
  Point2 Place;
  Point2 Direction; ///< of the piece, a unit vector
};

std::vector<PieceEnd> SortedEnds(const std::vector<Point2>& front)
{
  std::vector<PieceEnd> ends;
  for (std::size_t k = 0; k + 1 < front.size(); k += 2)
  {
    const Point2 span = front[k + 1] - front[k];
    const Point2 direction = 1.0 / Length(span) * span;
    ends.push_back({ front[k], direction });
    ends.push_back({ front[k + 1], direction });
  }
  std::sort(ends.begin(), ends.end(),
    [](const PieceEnd& a, const PieceEnd& b) { return a.Place < b.Place; });
  return ends;
}

/// How far apart the ends of two pieces that meet may be.
class EndTolerance
{
public:
  explicit EndTolerance(const Bites& bites, Placement placement)
  {
    const auto& halfWidths = bites.HalfWidths;
    this->IsBalanced = placement == Placement::Bisectors;
    this->HalfWidth =
      halfWidths.empty() ? 0.0 : *std::max_element(halfWidths.begin(), halfWidths.end());
  }

  double Greatest() const { return this->ForSine(LeastSine); }

  double Of(const PieceEnd& a, const PieceEnd& b) const
  {
    return this->ForSine(std::abs(Cross(a.Direction, b.Direction)));
  }

private:
  // Each of the sides that meet is traced where it is 2e-9 of its half-width further in or out than
  // where it ends the other one, which moves their meeting by the sum of both per sine.
  static constexpr double Growth = 4e-9;
  static constexpr double LeastSine = 1e-4; // below it sides count as in line
  static constexpr double Short = 1e-7;     // pieces of 1e-8 half-widths are left out

  double ForSine(double sine) const
  {
    const bool isTurned = this->IsBalanced && sine >= LeastSine;
    return isTurned ? std::max(Short, Growth * this->HalfWidth / sine) : Short;
  }

  bool IsBalanced;
  double HalfWidth;
};

/// The ends of pieces that are the end of an odd number of them.
std::vector<Point2> OddEnds(const std::vector<PieceEnd>& ends, const EndTolerance& tolerance)
{
  std::vector<bool> isPaired(ends.size(), false);
  std::vector<Point2> odd;
  for (std::size_t k = 0; k < ends.size(); ++k)
  {
    for (std::size_t m = k + 1; !isPaired[k] && m < ends.size(); ++m)
    {
      const Point2 apart = ends[m].Place - ends[k].Place;
      if (apart.X > tolerance.Greatest())
      {
        break;
      }
      isPaired[k] =
        !isPaired[m] && std::max(apart.X, std::abs(apart.Y)) <= tolerance.Of(ends[k], ends[m]);
      isPaired[m] = isPaired[m] || isPaired[k];
    }
    if (!isPaired[k])
    {
      odd.push_back(ends[k].Place);
    }
  }
  return odd;
}

/// Whether the domain near p is neither all bitten nor all left.
bool SeparatesBitten(const Point2& p, const Point2& normal, const DomainLocator& locator,
  const BiteBuckets& buckets, const Bites& bites)
{
  const auto isLeft = [&](const Point2& q)
  {
    bool isBitten = false;
    buckets.VisitNear(q, [&](Id bite) { isBitten = isBitten || Depth(bites, bite, q) > 0.0; });
    return !isBitten && locator.IsInside(q);
  };
  return isLeft(p + normal) != isLeft(p - normal);
}

/// Circles are drawn as chords: beside them is what their circle has bitten, and they meet the
/// boundary beside it.
bool HasCircles(const BitingMesh& mesh)
{
  return mesh.Bites.Size() > 0 && mesh.Bites.IsCircle(0);
}

void CheckFront(const Polylines& input, const BitingMesh& mesh, Placement placement)
{
  constexpr double Step = 1e-7;
  if (HasCircles(mesh))
  {
    return;
  }
  const std::vector<Point2> odd =
    OddEnds(SortedEnds(mesh.Front), EndTolerance(mesh.Bites, placement));
  EXPECT_TRUE(odd.empty()) << odd.size() << " open ends, the first at " << Text(odd.front());
  const MadeDomain made = Make(input);
  Pulse unheard(NoMonitor());
  const DomainLocator locator(made.Domain, unheard);
  const BiteBuckets buckets(mesh.Bites);
  for (std::size_t k = 0; k + 1 < mesh.Front.size(); k += 2)
  {
    const Point2 span = mesh.Front[k + 1] - mesh.Front[k];
    if (Length(span) > 10.0 * Step)
    {
      const Point2 normal = (Step / Length(span)) * Perpendicular(span);
      const Point2 middle = Midpoint(mesh.Front[k], mesh.Front[k + 1]);
      ASSERT_TRUE(SeparatesBitten(middle, normal, locator, buckets, mesh.Bites)) << Text(middle);
    }
  }
}

TEST(FrontTrace, PiecesCloseAndSeparateBittenFromLeft)
{
  for (const Polylines& input : { DividedPlate(), TurnedSquare() })
  {
    for (const BitingSetting& setting : BitingSettings())
    {
      for (BitingMeshOptions options : Fields(setting))
      {
        const Id all = RunMesh(input, options).Mesh.Bites.Orders.back() + 1;
        for (Id bites : { 0, 1, 3, 10, 40, all / 3, all / 2, all - 10, all - 1 })
        {
          options.MaximumNumberOfBites = bites;
          SCOPED_TRACE(
            Text(setting) + ": " + std::to_string(bites) + " bites of " + std::to_string(all));
          const BitingMesh mesh = RunMesh(input, options).Mesh;
          EXPECT_TRUE(bites > all / 2 || !mesh.Front.empty());
          CheckFront(input, mesh, setting.Place);
        }
      }
    }
  }
}

TEST(FrontTrace, NothingIsLeftAfterTheLastBite)
{
  for (const Polylines& input : { DividedPlate(), TurnedSquare() })
  {
    for (const BitingSetting& setting : BitingSettings())
    {
      for (BitingMeshOptions options : Fields(setting))
      {
        options.MaximumNumberOfBites = RunMesh(input, options).Mesh.Bites.Orders.back() + 1;
        EXPECT_TRUE(RunMesh(input, options).Mesh.Front.empty());
      }
    }
  }
}

TEST(FrontTrace, PiecesOfCirclesLieOnTheirOutlines)
{
  constexpr double Sagitta = 0.01; // of a radius
  for (const BitingSetting& setting : BitingSettings())
  {
    BitingMeshOptions options = Fields(setting)[2];
    options.MaximumNumberOfBites = 100;
    const BitingMesh mesh = RunMesh(DividedPlate(), options).Mesh;
    const BiteBuckets buckets(mesh.Bites);
    ASSERT_FALSE(mesh.Front.empty());
    for (std::size_t k = 0; HasCircles(mesh) && k < mesh.Front.size(); ++k)
    {
      double depth = -1.0;
      buckets.VisitNear(mesh.Front[k],
        [&](Id bite) {
          depth =
            std::max(depth, Depth(mesh.Bites, bite, mesh.Front[k]) / mesh.Bites.HalfWidths[bite]);
        });
      EXPECT_NEAR(depth, 0.0, Sagitta) << Text(setting) << Text(mesh.Front[k]);
    }
  }
}

} // namespace

} // namespace biting
