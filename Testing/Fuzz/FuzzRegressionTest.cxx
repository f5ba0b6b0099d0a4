// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "FuzzCases.h"
#include "JudgedMesh.h"

#include <gtest/gtest.h>

#include <algorithm> // for reverse
#include <cmath>     // for nextafter
#include <limits>    // for infinity
#include <memory>    // for sources

namespace biting
{

namespace
{

/// Both long sides were divided at the same places, and nothing of the triangle was left.
TEST(FuzzRegression, ATriangleThinnerThanRoundingHasAMesh)
{
  const std::vector<Point2> sliver{ { 1.0, 4.0 }, { 3.0, 4.0 }, { 2.0, std::nextafter(4.0, 5.0) },
    { 1.0, 4.0 } };
  const FuzzCase fuzzCase = BoundaryOf({ sliver }, 0.84);
  ExpectKept(fuzzCase, "sliver");
  EXPECT_NE(RunFuzzCase(fuzzCase).Kind, Verdict::Refusal);
}

/// The parts of two segments became one mesh edge, which was told to bound and did not.
TEST(FuzzRegression, PartsOfSegmentsNearerThanRoundingDoNotCoincide)
{
  const double beyond = std::nextafter(2.0, 3.0);
  ExpectKept(BoundaryOf({ { { 2.0, 0.0 }, { 3.0, 0.0 }, { 3.0, 1.0 }, { 2.0, 1.0 }, { 2.0, 0.0 } },
                          { { beyond, 3.0 }, { 0.0, 0.0 }, { 1.0, 0.0 }, { beyond, 0.0 },
                            { beyond, 3.0 } } },
               0.12),
    "coincident parts");
}

/// Interfaces within rounding of the boundary were cut off from the mesh by the parts of the
/// boundary.
TEST(FuzzRegression, SegmentsWithinRoundingOfTheBoundaryAreCovered)
{
  const Point2 a{ 244359.96647437123, -127637.07442542458 };
  const Point2 b{ 110262.86551667644, -201145.65143654219 };
  const Point2 c{ 67048.550478847406, 36754.288505558812 };
  const Point2 d{ 311408.51695321867, -90882.785919865753 };
  const Point2 e{ 103802.83898440622, -30294.261973288591 };
  const Point2 f{ 237899.93994210099, 43214.315037829037 };
  ExpectKept(BoundaryOf({ { a, b, b, a }, { c, b, d, e, f, c } }, 61119.5), "twice");

  const Point2 g{ 3.1592810987475941, 0.13763335023240686 };
  const Point2 h{ 3.7085573083576686, 2.0607286795274447 };
  const Point2 i{ 1.2361857694525562, 0.68690955984248148 };
  const Point2 j{ 2.1977334341000749, 0.41227145503744422 };
  const Point2 k{ 2.4723715389051124, 1.373819119684963 };
  const Point2 l{ 1.7854619790626307, 2.6100048891375192 };
  const std::vector<Point2> spikes{ j, h, { 0.27463810480503731, 0.96154766464751884 }, j,
    { 0.96154766464751884, -0.27463810480503731 }, g, { 1.5108238742575935, 1.6484572244900004 },
    h };
  FuzzCase fuzzCase = BoundaryOf({ { i, g, h, l, i }, { j, k, k, j }, { j, j, k, k, j }, spikes,
                                   { { 2.8846429939425566, -0.82391431441511198 }, g,
                                     { 3.4339192035526311, 1.0991810148799257 } } },
    0.8);
  fuzzCase.Input.Kinds.back() = ChainKind::Interface;
  ExpectKept(fuzzCase, "cut off");
}

/// Each crossing of edges within rounding of each other made new ones, 40 rounds long.
TEST(FuzzRegression, BundlesOfEdgesNearerThanRoundingAreResolved)
{
  const Point2 a{ 12388834.166693177, -1289154.2822932133 };
  const Point2 b{ 12388925.747086674, -1289107.8850331386 };
  const Point2 c{ 12388880.563953253, -1289245.8626867102 };
  const Point2 d{ 12388857.972386541, -1289314.8515134961 };
  const Point2 e{ 12388788.983559756, -1289292.2599467849 };
  const std::vector<Point2> loop{ e, c, { 12388834.773756504, -1289269.0613167477 },
    { 12388926.961213326, -1289337.4430802073 }, { 12388857.365323214, -1289200.0724899617 },
    { 12388881.171016578, -1289360.6417102446 }, { 12388948.945716711, -1289153.6752298872 }, a,
    e };
  const std::vector<Point2> strokes{ b, { 12388835.380819829, -1289383.8403402818 }, b,
    { 12388835.380819829, -1289383.8403402818 }, c, d, b };
  FuzzCase fuzzCase = BoundaryOf({ loop, strokes, { c, { 12388879.956889926, -1289131.083663176 } },
                                   { c, { 12388811.575126465, -1289223.2711199992 } } },
    6.8);
  fuzzCase.Input.Kinds[2] = ChainKind::Interface;
  fuzzCase.Input.Kinds[3] = ChainKind::Interface;
  ExpectKept(fuzzCase, "bundle");
}

/// All bites overlap all others: each was compared with each, for minutes.
TEST(FuzzRegression, ManyVerticesWithinOneSpacingAreMeshedSoon)
{
  FuzzNumbers numbers(1);
  std::vector<Point2> tangle;
  for (int k = 0; k < 120; ++k)
  {
    const double x = numbers.Below(60);
    tangle.push_back({ x, static_cast<double>(numbers.Below(60)) });
  }
  tangle.push_back(tangle.front());
  ExpectKept(BoundaryOf({ tangle }, 300.0), "tangle");
}

/// A spacing that touches zero made vertices nearer to each other than a distance can tell.
TEST(FuzzRegression, SpacingBelowRoundingIsThatOfRounding)
{
  FuzzCase fuzzCase = BoundaryOf({ UnitSquare }, 0.3);
  auto source = std::make_shared<SegmentSource>();
  source->Points = { { 0.0, 0.0 } };
  source->Values = { 1e-200 };
  source->Segments = { 0, 0 };
  fuzzCase.Options.Spacing.Sources.emplace_back(source);
  fuzzCase.Options.Spacing.Gradation = 8.0;
  ExpectKept(fuzzCase, "tiny spacing");
  EXPECT_EQ(RunFuzzCase(fuzzCase).Kind, Verdict::RepairedMesh);
}

/// The channel was divided into pieces as short as itself, to find how far f is to be lowered
/// there.
TEST(FuzzRegression, TinySpacingIsRefusedSoonWhereAChannelIsNarrow)
{
  const std::vector<Point2> frame{ { -1, -1 }, { 3, -1 }, { 3, 3 }, { -1, 3 }, { -1, -1 } };
  const std::vector<Point2> close{ { 1 + 1e-12, 0 }, { 2, 0 }, { 2, 1 }, { 1 + 1e-12, 1 },
    { 1 + 1e-12, 0 } };
  FuzzCase fuzzCase = BoundaryOf({ frame, UnitSquare, close }, 1e-30);
  fuzzCase.Options.LimitByFeatureSize = true;
  ExpectKept(fuzzCase, "channel");
  EXPECT_EQ(RunFuzzCase(fuzzCase).Kind, Verdict::Refusal);

  auto grid = std::make_shared<GridSource>();
  grid->XNodes = { -1.0, 3.0 };
  grid->YNodes = { -1.0, 3.0 };
  grid->Values = { 1e-11, 1e-11, 1e-11, 2e-11 };
  fuzzCase.Options.Spacing.Sources.emplace_back(grid);
  fuzzCase.Options.Spacing.Uniform = 0.0;
  ExpectKept(fuzzCase, "channel under a grid");
  EXPECT_EQ(RunFuzzCase(fuzzCase).Kind, Verdict::Refusal);
}

/// The jump between two triangles was followed down to squares that are nothing to a mesh.
TEST(FuzzRegression, JumpsOutsideOfATriangulationAreFoundSoonAtAHugeGradation)
{
  auto source = std::make_shared<TriangulatedSource>();
  source->Points = { { 0, 0 }, { 0.1, 0 }, { 0, 0.1 }, { 1, 1 }, { 0.9, 1 }, { 1, 0.9 } };
  source->Values = { 0.1, 0.1, 0.1, 0.3, 0.3, 0.3 };
  source->Triangles = { 0, 1, 2, 3, 4, 5 };
  FuzzCase fuzzCase = BoundaryOf({ UnitSquare }, 0.0);
  fuzzCase.Options.Spacing.Sources.emplace_back(source);
  fuzzCase.Options.Spacing.Gradation = 1e100;
  ExpectKept(fuzzCase, "jump");
  EXPECT_EQ(RunFuzzCase(fuzzCase).Kind, Verdict::Mesh);
}

/// With few bites to make, nobody asked the monitor between the trial of the calibration and the
/// end.
TEST(FuzzRegression, StopIsHeardWhereverItIsSaid)
{
  FuzzCase fuzzCase = BoundaryOf({ UnitSquare }, 0.04);
  fuzzCase.Options.MaximumNumberOfBites = 22;
  for (fuzzCase.StopAtCall = 0; fuzzCase.StopAtCall < 40; ++fuzzCase.StopAtCall)
  {
    ExpectKept(fuzzCase, "stop");
  }
}

/// Relaxation put a vertex on a segment of two ulp, and it slid away along what rounding made its
/// direction.
TEST(FuzzRegression, VerticesDoNotComeOnSegmentsAsShortAsRounding)
{
  FuzzCase fuzzCase = BoundaryOf(
    { { { 5.0895762534802973, -1.7596060809196621 }, { 4.9943264533173792, 0.23812450040729119 },
        { 3.9954611626539056, 0.19049960032583285 }, { 4.0907109628168223, -1.8072309810011202 },
        { 5.0895762534802973, -1.7596060809196621 } },
      { { 3.9954611626539056, 0.19049960032583296 }, { 4.0430860627353598, -0.80836569033764383 },
        { 2.0453554814084103, -0.90361549050056023 }, { 0.99886529066347607, 0.047624900081458234 },
        { 3.9954611626539056, 0.19049960032583285 } },
      { { 0.99886529066347607, 0.047624900081458227 }, { 2.0453554814084103, -0.90361549050056023 },
        { 4.0430860627353598, -0.80836569033764383 } },
      { { 4.0430860627353598, -0.80836569033764383 }, { 3.9954611626539047, 0.19049960032583296 },
        { 0.99886529066347618, 0.04762490008145822 } },
      { { 2.1882301816527843, -3.9002113624909898 }, { 4.0907109628168179, -1.8072309810011202 },
        { 2.140605281571327, -2.901346071827513 }, { 0.14287470024437457, -2.9965958719904293 },
        { 2.1882301816527852, -3.9002113624909902 } },
      { { 4.9943264533173792, 0.23812450040729119 },
        { 2.1882301816527843, -3.9002113624909898 } } },
    0.0);
  fuzzCase.Options.Spacing.Gradation = 20.0;
  fuzzCase.Input.Kinds.assign(6, ChainKind::Automatic);
  for (const FrontOrder order : { FrontOrder::Layers, FrontOrder::LargestY })
  {
    fuzzCase.Options.Order = order;
    fuzzCase.Options.Placement = Placement::Corners;
    ExpectKept(fuzzCase, "short");
  }
}

/// Centres of bites beside a strip as thin as rounding were on the constraint, and called interior.
TEST(FuzzRegression, VerticesThatDivideAConstraintAreOnTheBoundary)
{
  const std::vector<std::vector<Point2>> chains = {
    { { 2.9999999999999987, 4.999999999999992 }, { 5.9999999999999991, 4.9999999999999982 },
      { 6, 5.9999999999999991 }, { 2.9999999999999991, 5.999999999999992 },
      { 2.9999999999999964, 4.9999999999999947 } },
    { { 5.9999999999999991, 5.9999999999999964 }, { 5.9999999999999956, 5.9999999999999938 },
      { 5.999999999999992, 0.0 }, { 5.9999999999999973, -1.9762625833649862e-323 },
      { 5.9999999999999938, 5.9999999999999938 } }
  };
  auto grid = std::make_shared<GridSource>();
  grid->XNodes = { 3.857, 4.821, 5.143, 5.464 };
  grid->YNodes = { 0.911, 2.304, 3.0, 5.089 };
  grid->Values = { 0.889, 0.702, 3.05, 2.767, 14.654, 20.717, 0.398, 0.71, 10.942, 16.803, 9.976,
    0.695, 2.278, 0.842, 5.713, 5.926 };
  FuzzCase fuzzCase = BoundaryOf(chains, 2.23);
  fuzzCase.Options.Spacing.Sources.emplace_back(grid);
  fuzzCase.Options.Spacing.Gradation = 1.0;
  fuzzCase.Options.LimitByFeatureSize = false;
  fuzzCase.Options.Relaxation = false;
  fuzzCase.Options.Placement = Placement::Bisectors;
  fuzzCase.Options.Order = FrontOrder::BestFirst;
  for (double constant = 0.17; constant < 0.2; constant += 0.001)
  {
    fuzzCase.Options.BitingConstant = constant;
    ExpectKept(fuzzCase, "constraint");
  }
}

/// The carrier was refined down to rounding along a bundle of segments, more than a leaf lists.
TEST(FuzzRegression, BoundaryValuesOnABundleOfSegmentsArePreparedSoon)
{
  std::vector<Point2> zigzag;
  for (int k = 0; k <= 40; ++k)
  {
    zigzag.push_back({ 50.0 * (k % 2), 4e-10 * k });
  }
  zigzag.push_back(zigzag.front());
  FuzzCase fuzzCase = BoundaryOf({ zigzag }, 0.0);
  auto source = std::make_shared<SegmentSource>();
  source->Points = fuzzCase.Input.Points;
  source->Values = { 3.0 };
  for (int k = 1; k < 42; ++k)
  {
    source->Values.push_back(3.0 + k * 7 % 5);
    source->Segments.insert(source->Segments.end(), { k - 1, k });
  }
  fuzzCase.Options.Spacing.Sources.emplace_back(source);
  fuzzCase.Options.Spacing.Gradation = 0.0;
  fuzzCase.Options.MaximumNumberOfVertices = 2500;
  ExpectKept(fuzzCase, "bundle");
}

/// Rounding of dot products hid the nearest of three vertices that are an ulp apart.
TEST(FuzzRegression, NearestVerticesAreFoundAmongThoseAnUlpApart)
{
  FuzzCase fuzzCase = BoundaryOf(
    { { { 0, 3.0000000000000004 }, { 1, 2 }, { 5.0000000000000009, 4.9406564584124654e-324 },
        { 4.0000000000000009, 2 }, { 1, 0 }, { 2.0000000000000004, 5 }, { 3, 2.0000000000000004 } },
      { { 4.9406564584124654e-324, 3 }, { 1.0000000000000002, 2.0000000000000004 } },
      { { 1, 2.0000000000000004 }, { 5.0000000000000009, 0 } },
      { { 5.0000000000000009, 1 }, { 3.0218428597591775, 3.8050588307114661 },
        { -0.29705869104995258, 2.9296428088824826 },
        { -0.58666487435727965, -0.49053101328332782 }, { 5.0000000000000009, 1 } },
      { { 3.0000000000000004, 2 }, { 3, 5.0000000000000009 }, { 4.9406564584124654e-324, 1 },
        { 4, 2 } } },
    5.1108705492745949);
  fuzzCase.Options.Spacing.Gradation = 1.0;
  fuzzCase.Options.LimitByFeatureSize = false;
  fuzzCase.Options.Placement = Placement::Corners;
  fuzzCase.Options.Relaxation = false;
  fuzzCase.Options.Order = FrontOrder::LargestY;
  fuzzCase.Input.Kinds.assign(5, ChainKind::Automatic);
  fuzzCase.Input.Kinds.back() = ChainKind::EmbeddedPoint;
  for (const double phi : { 0.6, 0.79706116761080925, 1.0 })
  {
    fuzzCase.Options.Phi = phi;
    ExpectKept(fuzzCase, "nearest");
  }
}

/// A stop that came after biting had refused was a second error. Its estimate did not see the
/// segments where both chains nearly meet, a few ulp long.
TEST(FuzzRegression, StopAfterARefusalIsNoSecondError)
{
  constexpr double gap = 1.4e-9;
  FuzzCase fuzzCase =
    BoundaryOf({ { { 3839849, 323591 }, { 3643425, 474381 }, { 3418646, 578276 },
                   { 3209219, 446139 }, { 3033983, 271175 }, { 3085520, 28969 },
                   { 3189066, -195972 }, { 3434147, -231400 }, { 3681019 + gap, -212055 } },
                 { { 3681019, -212055 }, { 3799037, 5641 }, { 3839849 + gap, 323591 } } },
      1e6);
  fuzzCase.Options.Spacing.Gradation = 20.0;
  fuzzCase.Options.Placement = Placement::Bisectors;
  fuzzCase.Options.PreserveBoundary = true;
  fuzzCase.Options.MaximumNumberOfVertices = 1000;
  for (fuzzCase.StopAtCall = 0; fuzzCase.StopAtCall < 40; ++fuzzCase.StopAtCall)
  {
    ExpectKept(fuzzCase, "stop");
  }
}

/// Cells that run there and back, thinner than rounding, or that end where others are divided;
/// lines as short as rounding: kernel and oracle did not agree.
TEST(FuzzRegression, DegenerateCellsAndLinesAreKeptAsFarAsTheyAreSure)
{
  for (const std::uint64_t seed : { 5000715u, 91000326u, 91010577u, 91012453u, 91017972u, 91025186u,
         92028844u, 92113093u, 92126375u, 92203076u, 92381434u, 93028724u })
  {
    ExpectKept(seed);
  }
}

/// A strip no thicker than some fifty units of rounding: a vertex slid past its neighbour, and
/// rounding hid that the triangles beside it had turned over.
TEST(FuzzRegression, VerticesSlideBetweenTheirNeighboursAlsoWhereTheDomainIsAsThinAsRounding)
{
  ExpectKept(CaseOfSeed(181065968u), "181065968");
}

/// Two triangles in a strip of 150 units of rounding, with diagonals three units apart that are one
/// edge between neighbours: three edges are near, or one, but two for widths between.
TEST(FuzzRegression, NeighboursButForRoundingHaveNoEdgeBetweenThem)
{
  ExpectKept(CaseOfSeed(410001115u), "410001115");
}

/// Boundary values without a gradation that differ at points which are nearly one, along bundles of
/// segments: more than ten seconds each.
TEST(FuzzRegression, BoundaryValuesThatJumpWithoutGradationArePreparedSoon)
{
  for (const std::uint64_t seed :
    { 92121676u, 92127561u, 92147584u, 92229882u, 92319567u, 92610777u, 92670867u })
  {
    ExpectKept(seed);
  }
}

/// Segments of two blocks touched each other but for rounding, and had vertices at one place.
TEST(FuzzRegression, BlocksWhoseSegmentsTouchHaveNoPointTwice)
{
  for (const std::uint64_t seed : { 300140529u, 300095066u })
  {
    ExpectKept(CaseOfSeed(seed), std::to_string(seed));
  }
  FuzzCase cut = CaseOfSeed(720038313u, FuzzBlocks::None);
  cut.Options.VerticesPerBlock = 274;
  cut.Options.MaximumNumberOfVertices = 4000;
  cut.Options.Spacing.Scale = 0.03046640917455079;
  cut.Options.Relaxation = true;
  cut.Options.KeepBites = false;
  cut.Options.MaximumNumberOfBites = -1;
  cut.Options.PreserveBoundary = false;
  ExpectKept(cut, "720038313");
}

TEST(FuzzRegression, SpacingNearTheLargestNumberIsNoMoreThanOneThatCoversTheDrawing)
{
  ExpectKept(95004254u);
  ExpectKept(CaseOfSeed(501130240u), "501130240");
}

/// The ball at the end of a ray from the border of a source was no smaller by rounding, and was
/// made smaller for ever.
TEST(FuzzRegression, RaysFromTheBorderOfASourceEnd)
{
  for (const std::uint64_t seed : { 17011430u, 27025222u })
  {
    ExpectKept(CaseOfSeed(seed), std::to_string(seed));
  }
}

} // namespace

} // namespace biting
