// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "../Support/MeshShapes.h"

#include "Blocks/CutDivision.h"

#include <gtest/gtest.h>

#include <cmath> // for abs

namespace biting
{

namespace
{

constexpr double Row = 0.86602540378443865;

/// A cut from (0, 0) to (0, length), divided with f = 1; its vertices in their order.
std::vector<Point2> Divide(double length, const CutGraph::Fold& fold)
{
  CutGraph graph;
  const Id start = graph.AddVertex({ 0.0, 0.0 }, NoId);
  const Id end = graph.AddVertex({ 0.0, length }, NoId);
  graph.Pieces.push_back({ start, end, NoId, fold });
  Box2 box;
  box.Add({ -length, 0.0 });
  box.Add({ length, length });
  ProblemList problems;
  const Spacing f = MakeSpacing(UniformSpacing(1.0), box, problems, NoMonitor());
  Pulse pulse(NoMonitor());
  EXPECT_TRUE(DivideCuts(f, { 0.824, 1.0, 1000 }, graph, pulse));
  std::vector<Point2> places{ graph.Vertices[start] };
  Id last = start;
  for (const CutGraph::Piece& piece : graph.Pieces)
  {
    EXPECT_EQ(piece.Start, last) << "pieces follow each other";
    last = piece.End;
    places.push_back(graph.Vertices[last]);
  }
  EXPECT_EQ(last, end);
  return places;
}

} // namespace

TEST(CutDivision, StraightCutsAreDividedIntoSides)
{
  const std::vector<Point2> places = Divide(20.0, {});
  ASSERT_EQ(places.size(), 21u);
  for (std::size_t k = 0; k < places.size(); ++k)
  {
    EXPECT_EQ(places[k].X, 0.0);
    EXPECT_NEAR(places[k].Y, static_cast<double>(k), 1e-9);
  }
}

TEST(CutDivision, FoldedCutsHaveTheVerticesOfRows)
{
  const std::vector<Point2> places = Divide(40.0 * Row, { true, true, true });
  ASSERT_EQ(places.size(), 41u);
  for (std::size_t k = 0; k < places.size(); ++k)
  {
    EXPECT_NEAR(std::abs(places[k].X), k % 2 == 0 ? 0.0 : 0.5, 1e-9);
    EXPECT_NEAR(places[k].Y, static_cast<double>(k) * Row, 1e-9);
    EXPECT_EQ(places[k].X > 0.0, k % 2 == 1 && places[1].X > 0.0) << "all on one side";
  }
}

TEST(CutDivision, FoldedCutsStayOnTheirLineNextToAnEndThatIsNotOpen)
{
  const std::vector<Point2> places = Divide(40.0 * Row, { true, false, true });
  ASSERT_EQ(places.size(), 41u);
  for (std::size_t k = 0; k < places.size(); ++k)
  {
    EXPECT_EQ(std::abs(places[k].X) > 0.4, k > 4 && k % 2 == 1) << k;
  }
}

TEST(CutDivision, IsTheSameInAllUnits)
{
  const auto divide = [](double unit)
  {
    CutGraph graph;
    const Id start = graph.AddVertex({ 0.0, 0.1 * unit }, NoId);
    const Id end = graph.AddVertex({ 0.0, 0.9 * unit }, NoId);
    graph.Pieces.push_back({ start, end, NoId, { true, true, true } });
    ProblemList problems;
    const Spacing f = MakeSpacing(RadialSpacing({ 0.2 * unit, 0.3 * unit }, 0.01 * unit, 0.2),
      { { 0.0, 0.0 }, { unit, unit } }, problems, NoMonitor());
    Pulse pulse(NoMonitor());
    EXPECT_TRUE(DivideCuts(f, { 0.824, 1.0, 1000 }, graph, pulse));
    return graph.Vertices;
  };
  const std::vector<Point2> places = divide(1.0);
  const std::vector<Point2> doubled = divide(2.0);
  EXPECT_GT(places.size(), 10u);
  ASSERT_EQ(places.size(), doubled.size());
  for (std::size_t k = 0; k < places.size(); ++k)
  {
    EXPECT_TRUE(2.0 * places[k] == doubled[k]) << k;
  }
}

TEST(CutDivision, WhatIsSplitIsOpenThere)
{
  CutGraph graph;
  const Id start = graph.AddVertex({ 0.0, 0.0 }, NoId);
  const Id end = graph.AddVertex({ 0.0, 1.0 }, NoId);
  graph.Pieces.push_back({ start, end, NoId, { true, false, false } });
  const Id rest = graph.Split(0, graph.AddVertex({ 0.0, 0.5 }, NoId));
  EXPECT_FALSE(graph.Pieces[0].Folded.IsOpenAtStart);
  EXPECT_TRUE(graph.Pieces[0].Folded.IsOpenAtEnd);
  EXPECT_TRUE(graph.Pieces[rest].Folded.IsFolded);
  EXPECT_TRUE(graph.Pieces[rest].Folded.IsOpenAtStart);
  EXPECT_FALSE(graph.Pieces[rest].Folded.IsOpenAtEnd);
}

} // namespace biting
