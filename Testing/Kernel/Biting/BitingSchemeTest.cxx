// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Biting/BitingScheme.h"
#include "../Support/BitingSettings.h"
#include "../Support/MeshRun.h"
#include "../Support/MeshShapes.h"
#include "Biting/BiteOutline.h"
#include "Biting/BiteTriangle.h"
#include "Biting/EdgeDivision.h"
#include "Domain/DomainLocator.h"

#include <gtest/gtest.h>

#include <cmath>   // for sqrt
#include <ostream> // for the name of a case

namespace biting
{

namespace
{

/// A domain and a spacing within the theory: alpha c_b < 1 / (4 + sqrt 2), and f nowhere above the
/// local feature size.
struct LawCase
{
  std::string Name;
  Polylines Input;
  SpacingOptions Spacing;
  double Alpha;          ///< the Lipschitz constant of the spacing
  double BitingConstant; ///< 0: automatic

  /// Whether segments are long against f. Where one part joins two reflex corners, their bites lean
  /// apart: lemma 4.11 does not know this case.
  bool HasLongSegments = true;
};

struct LawRun
{
  LawCase Case;
  BitingSetting Setting;
};

std::ostream& operator<<(std::ostream& stream, const LawRun& run)
{
  return stream << run.Case.Name << ", " << run.Setting;
}

Polylines Loops(const std::vector<std::vector<Point2>>& loops)
{
  PolylineBuilder builder;
  for (const std::vector<Point2>& loop : loops)
  {
    builder.Loop(loop);
  }
  return builder.Lines();
}

Polylines NestedIslands()
{
  return PolylineBuilder()
    .Box(0.0, 0.0, 1.0, 1.0)
    .Box(0.2, 0.2, 0.8, 0.8)
    .Box(0.35, 0.35, 0.65, 0.65)
    .Lines();
}

Polylines SquareWithInterface()
{
  return PolylineBuilder()
    .Loop({ { 0.0, 0.0 }, { 1.0, 0.0 }, { 1.0, 0.4 }, { 1.0, 1.0 }, { 0.0, 1.0 }, { 0.0, 0.4 } })
    .Chain({ { 0.0, 0.4 }, { 1.0, 0.4 } })
    .Chain({ { 0.3, 0.7 } }, ChainKind::EmbeddedPoint)
    .Chain({ { 0.6, 0.75 } }, ChainKind::EmbeddedPoint)
    .Chain({ { 0.55, 0.2 } }, ChainKind::EmbeddedPoint)
    .Lines();
}

Polylines SeveralSquares()
{
  return PolylineBuilder()
    .Box(0.0, 0.0, 1.0, 1.0)
    .Box(1.25, 0.0, 1.75, 0.5)
    .Box(1.25, 0.75, 2.0, 1.5)
    .Lines();
}

std::vector<LawCase> Cases()
{
  const std::vector<Point2> square{ { 0.0, 0.0 }, { 1.0, 0.0 }, { 1.0, 1.0 }, { 0.0, 1.0 } };
  const std::vector<Point2> turned = RegularPolygon({ 0.0, 0.0 }, 1.0, 4, 30.0);
  const std::vector<Point2> triangle = RegularPolygon({ 0.0, 0.0 }, 1.0, 3, 90.0);
  const std::vector<Point2> ell = EllShape(1.0);
  const Polylines plate = Loops({ square, RegularPolygon({ 0.5, 0.5 }, 0.25, 24) });
  const Polylines ring =
    Loops({ RegularPolygon({ 0.0, 0.0 }, 1.0, 32), RegularPolygon({ 0.0, 0.0 }, 0.5, 20) });
  const Polylines dodecagon = Loops({ RegularPolygon({ 0.0, 0.0 }, 1.0, 12) });
  const Polylines disc = Loops({ RegularPolygon({ 0.0, 0.0 }, 1.0, 24) });
  return {
    { "square, uniform", Loops({ square }), UniformSpacing(0.07), 0.0, 0.25 },
    { "square, gradient", Loops({ square }), LinearSpacing(0.02, 0.3, 1.0), 0.3, 0.5 },
    { "square, radial", Loops({ square }), RadialSpacing({ 0.4, 0.55 }, 0.01, 0.3), 0.3, 0.33 },
    { "square, radial at a side", Loops({ square }), RadialSpacing({ 0.37, 0.0 }, 0.01, 0.2), 0.2,
      0.0 },
    { "ell, uniform", Loops({ ell }), UniformSpacing(0.04), 0.0, 0.5 },
    { "ell, radial", Loops({ ell }), RadialSpacing({ 0.5, 0.5 }, 0.015, 0.2), 0.2, 0.0 },
    { "disc, uniform", disc, UniformSpacing(0.2), 0.0, 0.33, false },
    { "disc, gradient", disc, LinearSpacing(0.08, 0.1, 1.0), 0.1, 0.25, false },
    { "plate, radial", plate, RadialSpacing({ 0.5, 0.5 }, 0.02, 0.12), 0.12, 0.5, false },
    { "plate, uniform", plate, UniformSpacing(0.05), 0.0, 0.0, false },
    { "nested islands, uniform", NestedIslands(), UniformSpacing(0.04), 0.0, 0.0 },
    { "nested islands, gradient", NestedIslands(), LinearSpacing(0.02, 0.05, 1.0), 0.05, 0.33 },
    { "turned square, uniform", Loops({ turned }), UniformSpacing(0.06), 0.0, 0.5 },
    { "turned square, gradient", Loops({ turned }), LinearSpacing(0.08, 0.15, 0.9), 0.15, 0.5 },
    { "triangle, gradient", Loops({ triangle }), LinearSpacing(0.05, 0.2, 1.0), 0.2, 0.5 },
    { "triangle, uniform", Loops({ triangle }), UniformSpacing(0.05), 0.0, 0.33 },
    { "dodecagon, parts of a little over one bite", dodecagon, UniformSpacing(0.47), 0.0, 0.5,
      false },
    { "dodecagon, gradient", dodecagon, LinearSpacing(0.3, 0.15, 1.0), 0.15, 0.5, false },
    { "ring, uniform", ring, UniformSpacing(0.1), 0.0, 0.0, false },
    { "ring, radial", ring, RadialSpacing({ 0.0, 0.0 }, 0.03, 0.1), 0.1, 0.5, false },
    { "interface, gradient", SquareWithInterface(), LinearSpacing(0.04, 0.1, 1.0), 0.1, 0.5 },
    { "interface, uniform", SquareWithInterface(), UniformSpacing(0.05), 0.0, 0.33 },
    { "several squares, uniform", SeveralSquares(), UniformSpacing(0.06), 0.0, 0.5 },
    { "several squares, radial", SeveralSquares(), RadialSpacing({ 1.3, 0.2 }, 0.02, 0.1), 0.1,
      0.0 },
  };
}

std::vector<LawRun> Runs()
{
  std::vector<LawRun> runs;
  for (const LawCase& lawCase : Cases())
  {
    for (const BitingSetting& setting : BitingSettings())
    {
      runs.push_back({ lawCase, setting });
    }
  }
  return runs;
}

/// Remembers where something was worst.
struct Worst
{
  double Excess = -1e300;
  std::string What;

  void See(double excess, const Point2& place, const std::string& figures)
  {
    if (excess > this->Excess)
    {
      this->Excess = excess;
      this->What = Text(place) + " " + figures;
    }
  }
};

/// Meshes with all laws of the paper to check. Made once for each run.
class BitingLaws : public testing::TestWithParam<LawRun>
{
protected:
  static constexpr double Rounding = 1e-9;       ///< relative
  static constexpr double GreatestProduct = 0.2; ///< of alpha c_b: as far as the cases go

  void SetUp() override
  {
    const LawRun& run = this->GetParam();
    BitingMeshOptions options;
    options.Spacing = run.Case.Spacing;
    options.BitingConstant = run.Case.BitingConstant;
    options.Relaxation = false;
    run.Setting.SetIn(options);
    if (run.Setting.Shape == BiteShape::Circle && run.Setting.Place == Placement::Corners &&
      run.Case.BitingConstant == 0.0)
    {
      options.BitingConstant = 0.75; // the automatic one would be beyond the theory
    }
    options.KeepBites = true;
    this->Run = RunMesh(run.Case.Input, options);
    ASSERT_EQ(this->Run.Error(), "");
    ASSERT_GT(this->Run.NumberOfVertices(), 20);
    const BitingMesh& mesh = this->Run.Mesh;
    this->BitingConstant = mesh.Bites.HalfWidths[0] / mesh.Spacing[0];
    const bool isCircle = run.Setting.Shape == BiteShape::Circle;
    this->LeastConstant = this->BitingConstant;
    this->GreatestConstant = this->BitingConstant;
    if (run.Setting.Place == Placement::Bisectors && options.BitingConstant == 0.0)
    {
      this->LeastConstant *= LeastReachFactor(run.Case.Alpha);
      this->GreatestConstant *= GreatestReachFactor(run.Case.Alpha);
    }
    this->Product = run.Case.Alpha * this->BitingConstant;
    this->CornerDistance = isCircle ? 1.0 : std::sqrt(2.0);
    this->Tolerance = run.Setting.Place == Placement::Corners ? 1.0 : (isCircle ? 0.8 : 0.9);
    this->LeastLength = this->Tolerance * this->LeastConstant;
    this->EdgeTolerance = this->Tolerance;
    if (run.Setting.Place == Placement::Bisectors)
    {
      const BitingOptions automatic(run.Setting.Shape, run.Setting.Place);
      const double part = EdgeDivider::BalancedPart / automatic.BitingConstant;
      this->LeastLength = std::min(this->LeastLength, part * this->BitingConstant);
      this->EdgeTolerance = std::min(this->Tolerance, part / (isCircle ? 1.0 : 1.0824));
    }
    ASSERT_LT(this->Product, GreatestProduct);
    ASSERT_LE(mesh.UsedLipschitz, run.Case.Alpha * (1.0 + Rounding) + Rounding);
  }

  void CheckCenters() const;
  void CheckCoverage() const;
  void CheckPacking() const;
  void CheckBand() const;
  void CheckShapes() const;

  MeshRun Run;
  double BitingConstant = 0.0;   ///< c_b
  double LeastConstant = 0.0;    ///< of any bite; the same but where reaches follow the slope of f
  double GreatestConstant = 0.0; ///< of any bite
  double Product = 0.0;          ///< alpha c_b
  double CornerDistance = 0.0;   ///< how far a bite reaches, in half-widths
  double Tolerance = 0.0;        ///< of a bite, that covers others' centres
  double EdgeTolerance = 0.0;    ///< the same where both are on segments
  double LeastLength = 0.0;      ///< of edges, in units of f
};

// Section 3.1.
void BitingLaws::CheckCenters() const
{
  const Bites& bites = this->Run.Mesh.Bites;
  const BiteBuckets buckets(bites);
  Worst worst;
  for (Id bite = 0; bite < bites.Size(); ++bite)
  {
    buckets.VisitNear(bites.Centers[bite],
      [&](Id other)
      {
        if (bites.Orders[other] < bites.Orders[bite])
        {
          // An inner centre lies outside of all of a bite on the boundary; two on a segment are as
          // near as its parts are short.
          const bool isInner = bites.Phases[bite] == BitePhase::Interior;
          const double onBoundary = isInner ? 1.0 : this->EdgeTolerance;
          const bool isOtherInner = bites.Phases[other] == BitePhase::Interior;
          const double gauge = Gauge(bites, other, bites.Centers[bite]) / bites.HalfWidths[other];
          worst.See((isOtherInner ? this->Tolerance : onBoundary) - gauge, bites.Centers[bite],
            "bite " + std::to_string(bites.Orders[bite]) + " in " +
              std::to_string(bites.Orders[other]));
        }
      });
  }
  EXPECT_LE(worst.Excess, Rounding) << "centre in an earlier bite: " << worst.What;
}

// Section 4.3.
void BitingLaws::CheckCoverage() const
{
  constexpr int Samples = 20000;
  const MadeDomain made = Make(this->GetParam().Case.Input);
  Pulse unheard(NoMonitor());
  const DomainLocator locator(made.Domain, unheard);
  const Bites& bites = this->Run.Mesh.Bites;
  const BiteBuckets buckets(bites);
  const Box2& box = made.Domain.Bounds;
  TestNumbers numbers(7);
  Worst worst;
  for (int sample = 0; sample < Samples;)
  {
    const Point2 p{ box.Low.X + numbers.Unit() * box.Width(),
      box.Low.Y + numbers.Unit() * box.Height() };
    if (!locator.IsInside(p))
    {
      continue;
    }
    ++sample;
    double depth = -1.0;
    buckets.VisitNear(
      p, [&](Id bite) { depth = std::max(depth, Depth(bites, bite, p) / bites.HalfWidths[bite]); });
    worst.See(-depth, p, "");
  }
  EXPECT_LE(worst.Excess, Rounding) << "in no bite: " << worst.What;
}

// Lemma 4.2 with the least length in place of c_b, by way of nearest neighbours along edges: in a
// Delaunay triangulation the discs that overlap most are joined by an edge.
void BitingLaws::CheckPacking() const
{
  const BitingMesh& mesh = this->Run.Mesh;
  const double core = this->LeastLength;
  const double packing = core / (2.0 + core * this->GetParam().Case.Alpha);
  Worst worst;
  for (std::size_t half = 0; half < mesh.Corners.size(); ++half)
  {
    const Id u = mesh.Corners[half];
    const Id v = mesh.Corners[half % 3 == 2 ? half - 2 : half + 1];
    const double reach = packing * (mesh.Spacing[u] + mesh.Spacing[v]);
    const double distance = Distance(mesh.Points[u], mesh.Points[v]);
    worst.See(reach / distance - 1.0, mesh.Points[u],
      "radii " + std::to_string(reach) + ", distance " + std::to_string(distance));
  }
  EXPECT_LE(worst.Excess, Rounding) << "discs overlap: " << worst.What;
}

// Theorem 4.6. Of two neighbours the later one lies outside of the earlier one's core, or next to
// it on a segment: N >= least length f (1 - alpha N); and a place on a bite's outline lies in
// another bite.
void BitingLaws::CheckBand() const
{
  const BitingMesh& mesh = this->Run.Mesh;
  const double alpha = this->GetParam().Case.Alpha;
  const double core = this->LeastLength;
  const double least = core / (1.0 + core * alpha);
  const double reach = this->CornerDistance * this->GreatestConstant;
  const double greatest = 2.0 * reach / (1.0 - reach * alpha);
  Worst low;
  Worst high;
  for (Id vertex = 0; vertex < this->Run.NumberOfVertices(); ++vertex)
  {
    const double nearest = mesh.Quality.NearestNeighborDistance[vertex] / mesh.Spacing[vertex];
    low.See(least / nearest - 1.0, mesh.Points[vertex], "N / f = " + std::to_string(nearest));
    high.See(nearest / greatest - 1.0, mesh.Points[vertex], "N / f = " + std::to_string(nearest));
  }
  EXPECT_LE(low.Excess, Rounding) << "N too small: " << low.What << " < " << least;
  EXPECT_LE(high.Excess, Rounding) << "N too large: " << high.What << " > " << greatest;
}

Point2 Circumcenter(const Point2& a, const Point2& b, const Point2& c)
{
  const Point2 u = b - a;
  const Point2 v = c - a;
  const Point2 turned = Perpendicular(Dot(u, u) * v - Dot(v, v) * u);
  return a + (-0.5 / Cross(u, v)) * turned;
}

// Lemma 4.10, with a circumradius of at most that of the bite in which its centre lies, and sides
// of at least a core; and for the paper's bites lemma 4.11.
void BitingLaws::CheckShapes() const
{
  const BitingMesh& mesh = this->Run.Mesh;
  const MadeDomain made = Make(this->GetParam().Case.Input);
  Pulse unheard(NoMonitor());
  const DomainLocator locator(made.Domain, unheard);
  const double t = this->Product;
  const double reach = this->CornerDistance * this->GreatestConstant;
  const double innerBound =
    reach / (this->LeastLength * (1.0 - 2.0 * reach * this->GetParam().Case.Alpha));
  const double outerBound = (t * t - 2.0 * t + 2.0) / (6.0 * t * t - 8.0 * t + 2.0);
  Worst inner;
  Worst outer;
  for (Id triangle = 0; triangle < this->Run.NumberOfTriangles(); ++triangle)
  {
    const Point2 center = Circumcenter(mesh.Points[mesh.Corners[3 * triangle]],
      mesh.Points[mesh.Corners[3 * triangle + 1]], mesh.Points[mesh.Corners[3 * triangle + 2]]);
    const double ratio = mesh.Quality.RadiusEdgeRatio[triangle];
    const bool isInside = locator.IsInside(center);
    (isInside ? inner : outer)
      .See(ratio / (isInside ? innerBound : outerBound) - 1.0, center,
        "R/l = " + std::to_string(ratio));
  }
  EXPECT_LE(inner.Excess, Rounding) << "too thin: " << inner.What << " > " << innerBound;
  const BitingSetting& setting = this->GetParam().Setting;
  const bool isPaper = setting.Shape == BiteShape::Square && setting.Place == Placement::Corners;
  const bool isBounded = isPaper && this->GetParam().Case.HasLongSegments;
  EXPECT_TRUE(!isBounded || outer.Excess <= Rounding)
    << "too thin: " << outer.What << " > " << outerBound;
}

// One test: the laws are of one mesh.
TEST_P(BitingLaws, Hold)
{
  this->CheckCenters();
  this->CheckCoverage();
  this->CheckPacking();
  this->CheckBand();
  this->CheckShapes();
}

INSTANTIATE_TEST_SUITE_P(BitingScheme, BitingLaws, testing::ValuesIn(Runs()));

} // namespace

} // namespace biting
