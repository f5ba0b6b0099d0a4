// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

// The largest Lipschitz function below what is given, against its definition.

#include "SpacingSources.h"

#include <gtest/gtest.h>

namespace
{

using namespace biting;

constexpr double Tolerance = 0.1;       // anywhere
constexpr double UsualTolerance = 0.05; // of 99 % of all places

struct Case
{
  const char* Name;
  SpacingOptions Options;
};

double Jump(const Point2& x)
{
  return Length(x - Point2{ 0.4, 0.45 }) < 0.3 + 0.05 * std::sin(9.0 * x.X) ? 0.002 : 0.1;
}

double Steep(const Point2& x)
{
  return 0.02 + 0.3 * x.X * x.X + 0.15 * x.Y * (1.0 - x.X);
}

SpacingOptions OfGrid(int nodes, const Field& field, double power = 1.0)
{
  return With(MakeGrid(nodes, nodes, field, power));
}

SpacingOptions OfTriangles(int nodes, const Field& field)
{
  return With(MakeTriangulation(nodes, field));
}

/// Four in ten triangles are missing, the others are noise.
TriangulatedSource Gappy(int nodes, double range)
{
  Sampler sampler(6);
  TriangulatedSource source = MakeTriangulation(nodes,
    [&sampler, range](const Point2&)
    { return 0.005 * std::exp(std::log(range) * sampler.Next()); });
  for (Point2& point : source.Points)
  {
    point = point + (0.45 / nodes) * Point2{ sampler.Next(), sampler.Next() };
  }
  std::vector<Id> kept;
  for (std::size_t first = 0; first < source.Triangles.size(); first += 3)
  {
    if (sampler.Next() > 0.4)
    {
      const auto corner = source.Triangles.begin() + static_cast<std::ptrdiff_t>(first);
      kept.insert(kept.end(), corner, corner + 3);
    }
  }
  source.Triangles = kept;
  return source;
}

/// Blocks without values, between steep ones.
SpacingOptions WithBlocks(int nodes, double power)
{
  const auto field = [](const Point2& x)
  {
    const bool isHole = std::fmod(7.0 * x.X, 1.0) < 0.4 && std::fmod(5.0 * x.Y, 1.0) < 0.5;
    return isHole ? NotANumber : 0.01 + 0.1 * std::abs(std::sin(9.0 * x.X) * std::cos(8.0 * x.Y));
  };
  return OfGrid(nodes, field, power);
}

/// A sheet of low values on one of high ones: the smallest value counts.
SpacingOptions OfSheets()
{
  TriangulatedSource source = MakeTriangulation(9, [](const Point2&) { return 0.3; });
  const auto first = static_cast<Id>(source.Points.size());
  source.Points.insert(source.Points.end(), { { 0.2, 0.3 }, { 0.7, 0.4 }, { 0.4, 0.8 } });
  source.Values.insert(source.Values.end(), { 0.01, 0.02, 0.03 });
  source.Triangles.insert(source.Triangles.end(), { first, first + 1, first + 2 });
  source.MayOverlap = true;
  return With(source);
}

/// A sheet of low values that lies on another one, and ends beside it.
SpacingOptions OfSheetsSideBySide()
{
  TriangulatedSource source = MakeTriangulation(9, [](const Point2& x) { return 0.2 + 0.1 * x.X; });
  for (Point2& point : source.Points)
  {
    point.X *= 0.6;
  }
  const auto first = static_cast<Id>(source.Points.size());
  source.Points.insert(source.Points.end(), { { 0.5, 0.1 }, { 0.9, 0.2 }, { 0.45, 0.9 } });
  source.Values.insert(source.Values.end(), { 0.02, 0.04, 0.03 });
  source.Triangles.insert(source.Triangles.end(), { first, first + 1, first + 2 });
  source.MayOverlap = true;
  return With(source);
}

SpacingOptions Bounded(SpacingOptions options)
{
  options.Scale = 1.5;
  options.Minimum = 0.03;
  options.Maximum = 0.12;
  return options;
}

std::vector<Case> Cases()
{
  Sampler sampler(5);
  const auto noise = [&sampler](const Point2&) { return 0.02 * std::exp(2.0 * sampler.Next()); };
  const auto dots = [&sampler](const Point2&) { return sampler.Next() < 0.01 ? 0.002 : 0.1; };
  const auto holed = [](const Point2& x) {
    return Length(x - Point2{ 0.5, 0.5 }) < 0.35 ? NotANumber : x.X < 0.5 ? 0.01 : 0.08;
  };
  SpacingOptions both = OfGrid(17, Jump);
  both.Sources.emplace_back(
    Share(MakeLoop(40, [](double angle) { return 0.03 + 0.02 * std::sin(angle); })));
  both.Uniform = 0.09;
  SpacingOptions scaled = With(MakeScatter(30, 0.1, 8));
  scaled.Scale = 2.5;
  SpacingOptions shrunk = scaled;
  shrunk.Scale = 0.5;
  return { { "smooth grid", OfGrid(40, [](const Point2& x) { return 0.1 + 0.1 * x.X * x.Y; }) },
    { "jump in a coarse grid", OfGrid(30, Jump) }, { "jump in a fine grid", OfGrid(400, Jump) },
    { "jump in a graded grid", OfGrid(40, Jump, 2.0) }, { "steep, few nodes", OfGrid(3, Steep) },
    { "steep, more nodes", OfGrid(20, Steep) }, { "noise", OfGrid(25, noise) },
    { "dots", OfGrid(60, dots) }, { "bounded", Bounded(OfGrid(300, Steep)) },
    { "triangles with a jump", OfTriangles(25, Jump) },
    { "steep triangles", OfTriangles(6, Steep) }, { "noisy triangles", OfTriangles(25, noise) },
    { "bounded triangles", Bounded(OfTriangles(9, Steep)) },
    { "triangles around a hole", OfTriangles(25, holed) },
    { "blocks without values", WithBlocks(120, 1.0) },
    { "blocks without values in a graded grid", WithBlocks(90, 1.7) },
    { "one sheet on another", OfSheets() }, { "several sources", both },
    { "scaled up boundary values", scaled }, { "scaled down boundary values", shrunk } };
}

/// Others, which a sample of nodes does not see well enough: outside of borders no law is promised.
std::vector<Case> LawCases()
{
  Sampler sampler(7);
  const auto noise = [&sampler](const Point2&) { return 0.02 * std::exp(2.0 * sampler.Next()); };
  return { { "a steep grid on a part", With(OnAPart(MakeGrid(40, 40, Steep))) },
    { "noise in a grid on a part", With(OnAPart(MakeGrid(40, 40, noise))) },
    { "triangles as steep as the gradation", OfTriangles(60, AroundTheMiddle(0.3)) },
    { "triangles a little steeper", OfTriangles(60, AroundTheMiddle(0.303)) },
    { "triangles steeper by a tenth", OfTriangles(60, AroundTheMiddle(0.33)) },
    { "a sheet on another and beside it", OfSheetsSideBySide() },
    { "triangles with gaps", With(Gappy(60, 100.0)) },
    { "large triangles with gaps", With(Gappy(9, 100.0)) },
    { "noise on a part", With(OnAPart(Gappy(20, 30.0))) } };
}

std::vector<Case> AllCases()
{
  std::vector<Case> all = Cases();
  for (Case& other : LawCases())
  {
    all.push_back(other);
  }
  return all;
}

bool HasSegments(const SpacingOptions& options)
{
  return std::holds_alternative<std::shared_ptr<const SegmentSource>>(options.Sources.back());
}

/// What is given, without any limit.
Spacing GivenOf(SpacingOptions options)
{
  options.Gradation = 0.0;
  return MakeGoodSpacing(options);
}

/// The coordinates of the nodes, and of as many points between them as make some hundreds.
std::vector<double> Refined(const std::vector<double>& nodes)
{
  const auto parts = static_cast<int>(1 + 240 / nodes.size());
  std::vector<double> refined{ nodes.front() };
  for (std::size_t node = 1; node < nodes.size(); ++node)
  {
    for (int part = 1; part <= parts; ++part)
    {
      refined.push_back(
        nodes[node - 1] + (nodes[node] - nodes[node - 1]) * part / static_cast<double>(parts));
    }
  }
  return refined;
}

std::vector<double> NodesOf(const SpacingOptions& options)
{
  if (const auto* grid = First<GridSource>(options))
  {
    return grid->XNodes;
  }
  const auto count = static_cast<double>(First<TriangulatedSource>(options)->Points.size());
  return UnitNodes(static_cast<int>(std::lround(std::sqrt(count))));
}

/// min over many points y of f(y) + g |x - y|, all nodes of the source among them.
class SampledLimit
{
public:
  explicit SampledLimit(const SpacingOptions& options)
    : Gradation(options.Gradation)
  {
    const Spacing given = GivenOf(options);
    const std::vector<double> nodes = Refined(NodesOf(options));
    for (std::size_t node = 1; node < nodes.size(); ++node)
    {
      this->Step = std::max(this->Step, nodes[node] - nodes[node - 1]);
    }
    for (double y : nodes)
    {
      for (double x : nodes)
      {
        this->Points.push_back({ x, y });
      }
    }
    if (const auto* triangles = First<TriangulatedSource>(options))
    {
      const std::vector<Point2>& corners = triangles->Points;
      this->Points.insert(this->Points.end(), corners.begin(), corners.end());
    }
    for (const Point2& point : this->Points)
    {
      this->Values.push_back(given(point));
    }
  }

  double At(const Point2& x) const
  {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t point = 0; point < this->Points.size(); ++point)
    {
      const Point2 offset = x - this->Points[point];
      const double room = (least - this->Values[point]) / this->Gradation;
      if (room > 0.0 && Dot(offset, offset) < room * room)
      {
        least = this->Values[point] + this->Gradation * Length(offset);
      }
    }
    return least;
  }

  double Uncertainty() const { return 1.5 * this->Gradation * this->Step; }

private:
  double Gradation;
  double Step = 0.0;
  std::vector<Point2> Points;
  std::vector<double> Values;
};

} // namespace

TEST(Gradation, LeavesNothingAboveWhatIsGiven)
{
  for (const Case& test : AllCases())
  {
    if (!HasSegments(test.Options))
    {
      const Spacing given = GivenOf(test.Options);
      const Spacing used = MakeGoodSpacing(test.Options);
      Sampler sampler(31);
      for (int probe = 0; probe < 20000; ++probe)
      {
        const Point2 x = sampler.NextIn({ { -0.1, -0.1 }, { 1.1, 1.1 } });
        ASSERT_LE(used(x), given(x) * (1.0 + 1e-12)) << test.Name;
      }
    }
  }
}

/// Of pairs of places that are at least f/2 apart.
TEST(Gradation, BoundsTheSlopeOverAnyDistance)
{
  for (const Case& test : Cases())
  {
    const Spacing used = MakeGoodSpacing(test.Options);
    Sampler sampler(32);
    for (int probe = 0; probe < 20000; ++probe)
    {
      const Point2 x = sampler.NextIn(UnitBox());
      const double f = used(x);
      const double reach = 0.5 * f * std::exp(5.0 * sampler.Next());
      const double angle = 6.283185307179586 * sampler.Next();
      const Point2 y = x + reach * Point2{ std::cos(angle), std::sin(angle) };
      if (UnitBox().Contains(y))
      {
        ASSERT_LE(std::abs(f - used(y)), 0.3 * reach + Tolerance * std::max(f, used(y)))
          << test.Name << " at " << x.X << ' ' << x.Y << " and " << y.X << ' ' << y.Y;
      }
    }
  }
}

TEST(Gradation, IsTheLargestFunctionBelow)
{
  for (const Case& test : Cases())
  {
    if (HasSegments(test.Options))
    {
      continue;
    }
    const SampledLimit exact(test.Options);
    const Spacing used = MakeGoodSpacing(test.Options);
    Sampler sampler(33);
    int misses = 0;
    constexpr int Probes = 200;
    for (int probe = 0; probe < Probes; ++probe)
    {
      const Point2 x = sampler.NextIn(UnitBox());
      const double limit = exact.At(x);
      const double least = limit - exact.Uncertainty();
      ASSERT_LE(used(x), limit * (1.0 + Tolerance)) << test.Name << " at " << x.X << ' ' << x.Y;
      ASSERT_GE(used(x), least * (1.0 - Tolerance)) << test.Name << " at " << x.X << ' ' << x.Y;
      misses += used(x) > limit * (1.0 + UsualTolerance) ? 1 : 0;
      misses += used(x) < least * (1.0 - UsualTolerance) ? 1 : 0;
    }
    EXPECT_LE(misses, Probes / 100) << test.Name;
  }
}

TEST(Gradation, ChangesNothingWhereNothingIsSteep)
{
  const SpacingOptions options = OfGrid(40, [](const Point2& x) { return 0.1 + 0.1 * x.X * x.Y; });
  const Spacing given = GivenOf(options);
  const Spacing used = MakeGoodSpacing(options);
  Sampler sampler(34);
  for (int probe = 0; probe < 1000; ++probe)
  {
    const Point2 x = sampler.NextIn(UnitBox());
    ASSERT_EQ(used(x), given(x));
  }
}

TEST(Gradation, OfZeroLeavesEverythingAsGiven)
{
  SpacingOptions options = OfGrid(30, Jump);
  options.Gradation = 0.0;
  const Spacing used = MakeGoodSpacing(options);
  EXPECT_EQ(used({ 0.4, 0.45 }), 0.002);
  EXPECT_EQ(used({ 0.0, 0.0 }), 0.1);
}
