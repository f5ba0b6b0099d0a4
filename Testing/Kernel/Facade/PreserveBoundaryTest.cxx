// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "../Support/LegacyPolyData.h"
#include "../Support/MeshRun.h"
#include "../Support/MeshShapes.h"
#include "Biting/BiteOutline.h"

#include <gtest/gtest.h>

#include <algorithm> // for count
#include <cmath>     // for atan2
#include <cstring>   // for memcmp
#include <ostream>   // for the name of a case
#include <set>       // for edges
#include <utility>   // for pair

namespace biting
{

namespace
{

struct PreserveCase
{
  std::string Name;
  Polylines Input;
  double Uniform;          ///< 0: none
  double LeastAngle = 0.0; ///< that the input allows
  double Gradation = 0.3;
  double BitingConstant = 0.0;
};

std::ostream& operator<<(std::ostream& stream, const PreserveCase& preserveCase)
{
  return stream << preserveCase.Name;
}

std::vector<Point2> DividedSquare(const std::vector<int>& parts)
{
  return DividedLoop({ { 0.0, 0.0 }, { 1.0, 0.0 }, { 1.0, 1.0 }, { 0.0, 1.0 } }, parts);
}

Polylines Square(const std::vector<int>& parts)
{
  return PolylineBuilder().Loop(DividedSquare(parts)).Lines();
}

/// Segments of 0.1 and of `share` times 0.1 in turn.
Polylines AlternatingSquare(double share)
{
  std::vector<Point2> places;
  const std::vector<Point2> even = DividedSquare({ 10, 10, 10, 10 });
  for (std::size_t k = 0; k < even.size(); ++k)
  {
    places.push_back(even[k]);
    places.push_back(even[k] + share * (even[(k + 1) % even.size()] - even[k]));
  }
  return PolylineBuilder().Loop(places).Lines();
}

/// Two round holes that almost touch.
Polylines NearHoles()
{
  return PolylineBuilder()
    .Box(0.0, 0.0, 1.0, 1.0)
    .Loop(RegularPolygon({ 0.3, 0.5 }, 0.19999, 40))
    .Loop(RegularPolygon({ 0.7, 0.5 }, 0.19999, 40, 4.5))
    .Lines();
}

/// A flat hole of many segments close to a side of one.
Polylines FineBesideLong()
{
  return PolylineBuilder()
    .Box(0.0, 0.0, 1.0, 1.0)
    .Loop(DividedLoop(
      { { 0.2, 0.01 }, { 0.8, 0.01 }, { 0.8, 0.02 }, { 0.2, 0.02 } }, { 120, 2, 120, 2 }))
    .Lines();
}

/// A long interface between short sides, a point on each side of it, and a dangling one.
Polylines LongInterface()
{
  return PolylineBuilder()
    .Loop(DividedLoop(
      { { 0.0, 0.0 }, { 1.0, 0.0 }, { 1.0, 0.5 }, { 1.0, 1.0 }, { 0.0, 1.0 }, { 0.0, 0.5 } },
      { 10, 5, 5, 10, 5, 5 }))
    .Chain({ { 0.0, 0.5 }, { 1.0, 0.5 } })
    .Chain({ { 0.2, 0.7 }, { 0.8, 0.9 } })
    .Chain({ { 0.5, 0.501 } }, ChainKind::EmbeddedPoint)
    .Chain({ { 0.3, 0.3 } }, ChainKind::EmbeddedPoint)
    .Lines();
}

/// Where a steep spacing is no wider than the rounding of coordinates.
Polylines FarFromTheOrigin()
{
  return Move(LongInterface(),
    [](const Point2& p) {
      return Point2{ 8.0 * p.X + 12.85, 0.0065 * p.Y - 771060.325 };
    });
}

/// The coast of Data.
Polylines Coast()
{
  const LegacyPolyData data =
    LegacyReader(std::string(BITING_SOURCE_DIR) + "/Data/coast.vtk").Read();
  Polylines input;
  for (const std::array<double, 3>& point : data.Points)
  {
    input.Points.push_back({ point[0], point[1] });
  }
  for (const std::vector<int>& line : data.Lines)
  {
    input.Connectivity.insert(input.Connectivity.end(), line.begin(), line.end());
    input.Offsets.push_back(static_cast<Id>(input.Connectivity.size()));
    input.Cells.push_back(input.NumberOfChains());
    input.Kinds.push_back(ChainKind::Automatic);
  }
  return input;
}

std::vector<PreserveCase> Cases()
{
  const Polylines ring = PolylineBuilder()
                           .Loop(RegularPolygon({ 0.0, 0.0 }, 1.0, 64))
                           .Loop(RegularPolygon({ 0.0, 0.0 }, 0.3, 64))
                           .Lines();
  const Polylines disc = PolylineBuilder().Loop(RegularPolygon({ 0.0, 0.0 }, 1.0, 40)).Lines();
  const Polylines wedge =
    PolylineBuilder().Loop({ { 0.0, 0.0 }, { 1.0, 0.0 }, { 1.0, 0.02 } }).Lines();
  const Polylines fineWedge =
    PolylineBuilder()
      .Loop(DividedLoop({ { 0.0, 0.0 }, { 1.0, 0.0 }, { 1.0, 0.2 } }, { 1, 20, 1 }))
      .Lines();
  const Polylines strip = PolylineBuilder().Box(0.0, 0.0, 1000.0, 1.0).Lines();
  const Polylines hole =
    PolylineBuilder().Box(0.0, 0.0, 1.0, 1.0).Loop(RegularPolygon({ 0.5, 0.5 }, 0.25, 60)).Lines();
  const Polylines evenSquare = Square({ 10, 10, 10, 10 });
  return {
    { "square of 4 segments, nothing given", Square({ 1, 1, 1, 1 }), 0.0, 40.0 },
    { "square of 4 segments, a tenth of these", Square({ 1, 1, 1, 1 }), 0.1, 10.0 },
    { "square of 4 segments, steep", Square({ 1, 1, 1, 1 }), 0.02, 0.5, 4.0 },
    { "square of 4 segments, small bites", Square({ 1, 1, 1, 1 }), 0.1, 2.0, 0.3, 0.2 },
    { "evenly divided square, nothing given", evenSquare, 0.0, 20.0 },
    { "evenly divided square, finer", evenSquare, 0.03, 20.0 },
    { "evenly divided square, coarser", evenSquare, 100.0, 20.0 },
    { "evenly divided square, level", evenSquare, 0.1, 20.0, 0.0 },
    { "finely divided square", Square({ 100, 100, 100, 100 }), 0.05, 20.0 },
    { "sides of 10 to 40 segments", Square({ 10, 20, 40, 20 }), 0.0, 20.0 },
    { "sides of 5 to 25 segments", Square({ 5, 5, 25, 5 }), 0.0, 10.0 },
    { "sides of 1 and 1000 segments", Square({ 1, 1, 1000, 1 }), 0.0 },
    { "sides of 200 and 1 segments, fine", Square({ 1, 200, 1, 1 }), 5e-3 },
    { "lengths 1 : 5 in turn", AlternatingSquare(0.2), 0.0, 10.0 },
    { "lengths 1 : 1000 in turn", AlternatingSquare(1e-3), 0.0 },
    { "round hole in a square of 4 segments", hole, 0.05 },
    { "near holes", NearHoles(), 0.1 },
    { "fine beside long", FineBesideLong(), 0.0 },
    { "wedge of one degree", wedge, 0.01, 1.0 },
    { "wedge with a fine end", fineWedge, 0.01 },
    { "strip 1 : 1000", strip, 0.5 },
    { "ring", ring, 0.0, 20.0 },
    { "disc, finer", disc, 0.02, 20.0 },
    { "comb", PolylineBuilder().Loop(Comb(20, 0.005)).Lines(), 0.002 },
    { "long interface", LongInterface(), 0.1 },
    { "far from the origin, steep", FarFromTheOrigin(), 1.0, 0.0, 20.0 },
  };
}

BitingMeshOptions OptionsOf(const PreserveCase& preserveCase, FrontOrder order)
{
  BitingMeshOptions options;
  options.PreserveBoundary = true;
  options.Domain.EndTolerance = 0.0; // as the domain that it is compared with
  options.Spacing.Uniform = preserveCase.Uniform;
  options.Spacing.Gradation = preserveCase.Gradation;
  options.BitingConstant = preserveCase.BitingConstant;
  options.Order = order;
  options.KeepBites = true;
  return options;
}

using Ends = std::pair<Point2, Point2>;

Ends Sorted(const Point2& a, const Point2& b)
{
  return b < a ? Ends{ b, a } : Ends{ a, b };
}

std::multiset<Ends> SegmentsOf(const Domain& domain)
{
  std::multiset<Ends> segments;
  for (Id segment = 0; segment < domain.NumberOfSegments(); ++segment)
  {
    segments.insert(
      Sorted(domain.Vertices[domain.Starts[segment]], domain.Vertices[domain.Ends[segment]]));
  }
  return segments;
}

std::multiset<Ends> CoveringEdgesOf(const BitingMesh& mesh)
{
  std::multiset<Ends> edges;
  for (std::size_t edge = 0; edge < mesh.EdgeStarts.size(); ++edge)
  {
    edges.insert(Sorted(mesh.Points[mesh.EdgeStarts[edge]], mesh.Points[mesh.EdgeEnds[edge]]));
  }
  return edges;
}

void ExpectPreserved(const Polylines& input, const MeshRun& run)
{
  ASSERT_EQ(run.Error(), "");
  const Domain domain = Make(input).Domain;
  EXPECT_EQ(CoveringEdgesOf(run.Mesh), SegmentsOf(domain));
  const auto& kinds = run.Mesh.Kinds;
  EXPECT_EQ(std::count(kinds.begin(), kinds.end(), VertexKind::Boundary), 0);
  EXPECT_EQ(std::count(kinds.begin(), kinds.end(), VertexKind::Interior),
    run.NumberOfVertices() - domain.NumberOfVertices());
  EXPECT_NEAR(Area(run.Mesh), domain.Area, 1e-9 * domain.Area);
}

class PreserveBoundary : public testing::TestWithParam<PreserveCase>
{
protected:
  MeshRun Mesh(FrontOrder order) const
  {
    return RunMesh(this->GetParam().Input, OptionsOf(this->GetParam(), order));
  }

  /// As the paper has it.
  MeshRun RawMeshAtCorners(FrontOrder order) const
  {
    BitingMeshOptions options = OptionsOf(this->GetParam(), order);
    options.Placement = Placement::Corners;
    options.Relaxation = false;
    return RunMesh(this->GetParam().Input, options);
  }
};

TEST_P(PreserveBoundary, MakesEachSegmentOneEdgeOfAValidMesh)
{
  for (const FrontOrder order : { FrontOrder::Layers, FrontOrder::LargestY })
  {
    for (const MeshRun& run : { this->Mesh(order), this->RawMeshAtCorners(order) })
    {
      ExpectPreserved(this->GetParam().Input, run);
      EXPECT_GE(run.Mesh.Quality.SmallestAngle, this->GetParam().LeastAngle);
    }
  }
}

// Those of input vertices are where the input has them.
TEST_P(PreserveBoundary, PutsNoNewCentreInsideABiteOrShield)
{
  const MeshRun run = this->RawMeshAtCorners(FrontOrder::Layers);
  const Bites& bites = run.Mesh.Bites;
  const BiteBuckets buckets(bites);
  for (Id bite = 0; bite < bites.Size(); ++bite)
  {
    double deepest = -1.0;
    buckets.VisitNear(bites.Centers[bite],
      [&bites, &deepest, bite](Id other)
      {
        const double depth = Depth(bites, other, bites.Centers[bite]) / bites.HalfWidths[other];
        deepest = other < bite ? std::max(deepest, depth) : deepest;
      });
    ASSERT_GT(bites.HalfWidths[bite], 0.0) << Text(bites.Centers[bite]);
    if (bites.Phases[bite] == BitePhase::Interior)
    {
      ASSERT_LE(deepest, 1e-9) << Text(bites.Centers[bite]);
    }
  }
}

TEST_P(PreserveBoundary, CoversEachSegmentWithBitesAndShields)
{
  const MadeDomain made = Make(this->GetParam().Input);
  for (const MeshRun& run :
    { this->Mesh(FrontOrder::Layers), this->RawMeshAtCorners(FrontOrder::Layers) })
  {
    const Bites& bites = run.Mesh.Bites;
    const BiteBuckets buckets(bites);
    for (const auto& [start, end] : SegmentsOf(made.Domain))
    {
      for (int k = 0; k <= 32; ++k)
      {
        const Point2 place = start + k / 32.0 * (end - start);
        double deepest = -1.0;
        buckets.VisitNear(place,
          [&bites, &place, &deepest](Id bite)
          { deepest = std::max(deepest, Depth(bites, bite, place) / bites.HalfWidths[bite]); });
        ASSERT_GT(deepest, 0.0) << Text(place);
      }
    }
  }
}

TEST_P(PreserveBoundary, GivesTheSameBytesAgain)
{
  const BitingMesh first = this->Mesh(FrontOrder::Layers).Mesh;
  const BitingMesh second = this->Mesh(FrontOrder::Layers).Mesh;
  ASSERT_EQ(first.Points.size(), second.Points.size());
  EXPECT_EQ(
    std::memcmp(first.Points.data(), second.Points.data(), first.Points.size() * sizeof(Point2)),
    0);
  EXPECT_EQ(first.Corners, second.Corners);
  EXPECT_EQ(first.Bites.Orders, second.Bites.Orders);
}

INSTANTIATE_TEST_SUITE_P(Facade, PreserveBoundary, testing::ValuesIn(Cases()));

TEST(PreserveBoundaryOption, KeepsARealCoast)
{
  const Polylines coast = Coast();
  const MeshRun run = RunMesh(coast, OptionsOf({ "", coast, 0.0 }, FrontOrder::Layers));
  ExpectPreserved(coast, run);
  EXPECT_GT(run.Mesh.Quality.SmallestAngle, 3.0);
}

TEST(PreserveBoundaryOption, CountsShieldsAsBites)
{
  const Polylines input = Square({ 1, 10, 1, 10 });
  BitingMeshOptions options = OptionsOf({ "", input, 0.0 }, FrontOrder::Layers);
  options.Relaxation = false;
  const BitingMesh whole = RunMesh(input, options).Mesh;
  const auto& phases = whole.Bites.Phases;
  const auto shields = std::count(phases.begin(), phases.end(), BitePhase::EdgeProtection);
  const Id all = whole.Bites.Orders.back() + 1;
  ASSERT_GT(shields, 0);
  EXPECT_EQ(all, static_cast<Id>(whole.Points.size() + static_cast<std::size_t>(shields)));
  for (const Id most : { 0, 22, 24, all - 1 })
  {
    options.MaximumNumberOfBites = most;
    const MeshRun run = RunMesh(input, options);
    ASSERT_EQ(run.Error(), "");
    EXPECT_EQ(run.Mesh.Bites.Orders.empty() ? 0 : run.Mesh.Bites.Orders.back() + 1, most);
    EXPECT_EQ(run.Mesh.EdgeStarts.size(), 22u);
    EXPECT_FALSE(run.Mesh.Front.empty());
  }
}

TEST(PreserveBoundaryOption, NeedsNoShieldsWhereLengthsAreEven)
{
  const Polylines input = Square({ 10, 10, 10, 10 });
  const BitingMesh mesh = RunMesh(input, OptionsOf({ "", input, 0.03 }, FrontOrder::Layers)).Mesh;
  const auto& phases = mesh.Bites.Phases;
  EXPECT_EQ(std::count(phases.begin(), phases.end(), BitePhase::EdgeProtection), 0);
}

TEST(PreserveBoundaryOption, ReachesTheWantedSpacingAwayFromTheBoundary)
{
  const Polylines input = Square({ 10, 10, 10, 10 });
  const BitingMesh mesh = RunMesh(input, OptionsOf({ "", input, 0.02 }, FrontOrder::Layers)).Mesh;
  for (std::size_t vertex = 0; vertex < mesh.Points.size(); ++vertex)
  {
    const Point2& p = mesh.Points[vertex];
    const double depth = std::min({ p.X, p.Y, 1.0 - p.X, 1.0 - p.Y });
    EXPECT_NEAR(mesh.Spacing[vertex], std::max(0.1 - 0.3 * depth, 0.02), 0.016);
  }
}

TEST(PreserveBoundaryOption, EstimatesNoVerticesOnSegments)
{
  const Polylines input = Square({ 1, 1, 1, 1 });
  BitingMeshOptions options = OptionsOf({ "", input, 1e-9 }, FrontOrder::Layers);
  options.MaximumNumberOfVertices = 100;
  EXPECT_EQ(RunMesh(input, options).Error(), "");
  options.PreserveBoundary = false;
  EXPECT_TRUE(RunMesh(input, options).Problems.Has(ProblemCode::TooManyVertices));
}

TEST(PreserveBoundaryOption, RefusesTooManyVerticesThatTheLengthsAskFor)
{
  const Polylines input = Square({ 1, 1000, 1, 1 });
  BitingMeshOptions options = OptionsOf({ "", input, 0.0 }, FrontOrder::Layers);
  options.MaximumNumberOfVertices = 1200;
  EXPECT_TRUE(RunMesh(input, options).Problems.Has(ProblemCode::TooManyVertices));
}

// Repairs end segments where they meet; no vertex is on these by the spacing.
TEST(PreserveBoundaryOption, KeepsTheSegmentsThatRepairMakes)
{
  const Polylines input = PolylineBuilder()
                            .Box(0.0, 0.0, 1.0, 1.0)
                            .Chain({ { 0.25, 0.5 }, { 0.75, 0.5 } })
                            .Chain({ { 0.5, 0.25 }, { 0.5, 0.75 } })
                            .Lines();
  const MeshRun run = RunMesh(input, OptionsOf({ "", input, 0.05 }, FrontOrder::Layers));
  ASSERT_EQ(run.Error(), "");
  EXPECT_TRUE(run.Problems.Has(ProblemCode::Crossings));
  EXPECT_EQ(run.Mesh.EdgeStarts.size(), 8u);
  const auto& kinds = run.Mesh.Kinds;
  EXPECT_EQ(std::count(kinds.begin(), kinds.end(), VertexKind::Boundary), 1);
}

} // namespace

} // namespace biting
