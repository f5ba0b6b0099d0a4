// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Space/Finishing/BodyRelaxation.h"

#include "Space/Delaunay/SpaceTriangulation.h"
#include "Space/Features/FeatureLines.h"
#include "Space/Features/GroundPatches.h"
#include "Space/Finishing/EdgeRemoval.h"
#include "Space/Finishing/VertexMoves.h"
#include "Space/Quality/TetQuality.h"
#include "Space/Surface/NearestOnTriangle.h"
#include "Space/Surface/SurfaceShapes.h"
#include "Support/Dice.h"

#include <gtest/gtest.h>

#include <algorithm> // for sort, min_element
#include <array>     // for corners
#include <cmath>     // for abs
#include <map>       // for facets
#include <utility>   // for pairs

namespace biting
{

namespace
{

using Facet = std::array<Id, 3>;

Facet Sorted(Id a, Id b, Id c)
{
  Facet facet{ a, b, c };
  std::sort(facet.begin(), facet.end());
  return facet;
}

/// The unit cube, halved at x = 1 / 2 into two regions if that is wanted; about n points an edge.
class Cube
{
public:
  Cube(int n, int regions, double unevenness, double onLines = 0.0)
    : Random(5)
    , Step(1.0 / n)
    , IsHalved(regions == 2)
    , Unevenness(unevenness)
    , OnLines(onLines)
  {
    this->MakeGround();
    for (int places = 3; places >= 0; --places)
    {
      this->AddPoints(n, places);
    }
    this->Body.Sizes.assign(this->Body.Points.size(), this->Step);
    this->AddCells();
    this->AddFacets();
    this->AddPieces();
    if (onLines > 0.0)
    {
      this->AddChains();
    }
  }

  void Relax(Monitor& monitor = NoMonitor())
  {
    Pulse pulse(monitor);
    RelaxBody(
      this->Ground, [this](const Point3&) { return this->Step; }, this->Body, pulse);
  }

  RelaxedBody Body;
  SurfaceGround Ground;

private:
  void MakeGround()
  {
    Soup soup;
    soup.AddBox({ 0.0, 0.0, 0.0 }, { this->IsHalved ? 0.5 : 1.0, 1.0, 1.0 });
    for (std::size_t side = this->IsHalved ? 1 : 6; side < 6; ++side)
    {
      soup.AddSide({ 0.5, 0.0, 0.0 }, { 1.0, 1.0, 1.0 }, side / 2, side % 2 == 1, 1);
    }
    this->Ground.Mesh = Judge(soup).Surface.Mesh;
    Pulse pulse(NoMonitor());
    for (std::size_t t = 0; t < this->Ground.Mesh.NumberOfTriangles(); ++t)
    {
      const Point3 normal = this->Ground.Mesh.Normal(t);
      this->Ground.Mesh.Cells[t] = static_cast<Id>(t);
      this->Ground.Normals.push_back((1.0 / Length(normal)) * normal);
    }
    this->Ground.Sizes.assign(this->Ground.Mesh.Points.size(), this->Step);
    FlagFeatures(this->Ground, {}, 40.0, pulse);
    LinkGround(this->Ground, pulse);
  }

  /// How many of the planes of the surface a point of the lattice is on.
  int NumberOfPlanes(const std::array<int, 3>& at, int n) const
  {
    int planes = this->IsHalved && 2 * at[0] == n ? 1 : 0;
    for (const int i : at)
    {
      planes += i == 0 || i == n ? 1 : 0;
    }
    return planes;
  }

  /// Those of the lattice on so many planes; all but corners and points of lines are moved on them.
  /// Inside, some are left away, and those next to planes are not moved far.
  void AddPoints(int n, int planes)
  {
    for (int k = 0; k < (n + 1) * (n + 1) * (n + 1); ++k)
    {
      const std::array<int, 3> at{ k % (n + 1), k / (n + 1) % (n + 1), k / (n + 1) / (n + 1) };
      if (this->NumberOfPlanes(at, n) != planes || (planes == 0 && this->Random.Below(9) == 0))
      {
        continue;
      }
      Point3 point;
      for (std::size_t d = 0; d < 3; ++d)
      {
        const bool isOnPlane =
          at[d] == 0 || at[d] == n || (d == 0 && this->IsHalved && 2 * at[d] == n);
        const double most = isOnPlane || planes > 2 ? 0.0
          : planes == 2                             ? this->OnLines
          : planes == 1                             ? 0.2
                                                    : this->Unevenness;
        point[d] = this->Step * (at[d] + most * this->Random.Between(-1.0, 1.0));
      }
      this->Body.Points.push_back(point);
      this->Body.NumberOnLines += planes > 1 ? 1 : 0;
      this->Body.NumberOnBoundary += planes > 0 ? 1 : 0;
      if (planes > 0)
      {
        this->Body.BoundaryPlaces.push_back(this->TriangleAt(point));
      }
    }
  }

  Id TriangleAt(const Point3& point) const
  {
    Id nearest = 0;
    double least = 1.0;
    for (std::size_t t = 0; t < this->Ground.Mesh.NumberOfTriangles(); ++t)
    {
      const double distance = Distance(NearestPoint(this->Ground.Mesh.Triangle(t), point), point);
      nearest = distance < least ? static_cast<Id>(t) : nearest;
      least = std::min(least, distance);
    }
    return nearest;
  }

  void AddCells()
  {
    const SpaceTriangulation all = TriangulateSpace(this->Body.Points, {}, NoMonitor());
    for (Id cell = 0; cell < all.Mesh.NumberOfSlots(); ++cell)
    {
      double x = 0.0;
      for (Id slot = 4 * cell; slot < 4 * cell + 4 && all.Mesh.IsTetrahedron(cell); ++slot)
      {
        const Id vertex = all.Order[At(all.Mesh.Corners[At(slot)])];
        this->Body.Corners.push_back(vertex);
        x += 0.25 * this->Body.Points[At(vertex)].X;
      }
      if (all.Mesh.IsTetrahedron(cell))
      {
        this->Body.Regions.push_back(this->IsHalved && x > 0.5 ? 1 : 0);
      }
    }
  }

  void AddFacets()
  {
    const GroundPatches patches(this->Ground);
    std::map<Facet, Id> open; // with one cell up to now: its slot
    this->Body.Twins.assign(this->Body.Corners.size(), NoId);
    for (Id slot = 0; slot < static_cast<Id>(this->Body.Corners.size()); ++slot)
    {
      const Facet corners = this->FacetAt(slot);
      const auto [place, isNew] = open.insert({ Sorted(corners[0], corners[1], corners[2]), slot });
      if (!isNew)
      {
        const Id other = place->second;
        open.erase(place);
        const Id regions[2] = { this->Body.Regions[At(slot / 4)],
          this->Body.Regions[At(other / 4)] };
        this->Body.Twins[At(slot)] = other;
        this->Body.Twins[At(other)] = slot;
        if (regions[0] != regions[1])
        {
          this->AddFacet(patches, regions[0] < regions[1] ? slot : other);
        }
      }
    }
    for (const auto& [corners, slot] : open)
    {
      this->AddFacet(patches, slot);
    }
  }

  Facet FacetAt(Id slot) const
  {
    const int* order = TetMesh::FacetCorners[slot % 4];
    const auto corner = [this, slot, order](int k)
    { return this->Body.Corners[At(slot - slot % 4 + order[k])]; };
    return { corner(0), corner(1), corner(2) };
  }

  void AddFacet(const GroundPatches& patches, Id slot)
  {
    const Facet facet = this->FacetAt(slot);
    const Id code = RelaxedBody::CodeOf(static_cast<Id>(this->Body.FacetPlaces.size()));
    if (this->Body.Twins[At(slot)] != NoId)
    {
      this->Body.Twins[At(this->Body.Twins[At(slot)])] = code;
    }
    this->Body.Twins[At(slot)] = code;
    Point3 middle{};
    for (const Id corner : facet)
    {
      middle = middle + (1.0 / 3.0) * this->Body.Points[At(corner)];
    }
    this->Body.Facets.insert(this->Body.Facets.end(), facet.begin(), facet.end());
    this->Body.FacetPlaces.push_back(patches.PatchOf(this->TriangleAt(middle)));
  }

  /// Edges where patches meet.
  void AddPieces()
  {
    std::map<std::pair<Id, Id>, std::vector<Id>> tags;
    for (std::size_t k = 0; k < this->Body.Facets.size(); ++k)
    {
      const Id a = this->Body.Facets[k];
      const Id b = this->Body.Facets[NextSlotOf(k)];
      tags[std::minmax(a, b)].push_back(this->Body.FacetPlaces[k / 3]);
    }
    for (const auto& [ends, tagsThere] : tags)
    {
      if (tagsThere.size() != 2 || tagsThere[0] != tagsThere[1])
      {
        this->Body.PieceEnds.insert(this->Body.PieceEnds.end(), { ends.first, ends.second });
      }
    }
  }

  /// Lets vertices slide on the lines.
  void AddChains()
  {
    FindChains(this->Ground);
    this->Body.NumberOfCorners = 8;
    const FeatureChains& chains = this->Ground.Chains;
    for (std::size_t k = 0; k < this->Body.PieceEnds.size(); k += 2)
    {
      const Point3 middle = Midpoint(this->Body.Points[At(this->Body.PieceEnds[k])],
        this->Body.Points[At(this->Body.PieceEnds[k + 1])]);
      Id chain = 0;
      const auto isOff = [this, &chains, &middle](Id c)
      {
        const Point3& a = this->Ground.Mesh.Points[At(chains.At(chains.Begin(c)))];
        const Point3& b = this->Ground.Mesh.Points[At(chains.At(chains.End(c) - 1))];
        return Distance(a, middle) + Distance(middle, b) > 1.0 + 1e-9;
      };
      while (isOff(chain))
      {
        ++chain;
      }
      this->Body.PieceChains.push_back(chain);
    }
  }

  Dice Random;
  double Step;
  bool IsHalved;
  double Unevenness;
  double OnLines; ///< how far vertices are off their places along lines, in steps
};

double SmallestAngle(const RelaxedBody& body)
{
  return MeasureTetrahedra({ body.Points, body.Sizes, body.Corners }).SmallestDihedralAngle;
}

double VolumeOf(const RelaxedBody& body, Id region)
{
  double volume = 0.0;
  for (std::size_t t = 0; t < body.Regions.size(); ++t)
  {
    const auto at = [&body, t](std::size_t k) { return body.Points[At(body.Corners[4 * t + k])]; };
    const double six = Dot(at(1) - at(0), Cross(at(2) - at(0), at(3) - at(0)));
    volume += body.Regions[t] == region ? six / 6.0 : 0.0;
  }
  return volume;
}

/// What RelaxedBody says, exactly.
void ExpectBody(const RelaxedBody& body)
{
  std::map<Facet, std::vector<std::pair<Id, Facet>>> cells; // regions, corners from there
  for (std::size_t t = 0; t < body.Regions.size(); ++t)
  {
    const Id* c = &body.Corners[4 * t];
    EXPECT_GT(Orient3D(body.Points[At(c[0])], body.Points[At(c[1])], body.Points[At(c[2])],
                body.Points[At(c[3])]),
      0);
    for (const auto& order : TetMesh::FacetCorners)
    {
      const Facet facet{ c[order[0]], c[order[1]], c[order[2]] };
      cells[Sorted(facet[0], facet[1], facet[2])].push_back({ body.Regions[t], facet });
    }
  }
  std::map<Facet, int> facets;
  for (std::size_t k = 0; k < body.Facets.size(); k += 3)
  {
    const Facet facet{ body.Facets[k], body.Facets[k + 1], body.Facets[k + 2] };
    ++facets[Sorted(facet[0], facet[1], facet[2])];
    const auto& sides = cells[Sorted(facet[0], facet[1], facet[2])];
    ASSERT_FALSE(sides.empty());
    const auto& lower = *std::min_element(sides.begin(), sides.end());
    const auto turn = static_cast<std::size_t>(
      std::find(facet.begin(), facet.end(), lower.second[0]) - facet.begin());
    EXPECT_EQ(facet[(turn + 1) % 3], lower.second[1]);
  }
  for (const auto& [facet, sides] : cells)
  {
    const bool isFacet = sides.size() == 1 || sides[0].first != sides[1].first;
    EXPECT_LE(sides.size(), 2u);
    EXPECT_EQ(facets.count(facet) == 1 ? facets[facet] : 0, isFacet ? 1 : 0);
  }
}

/// Edges that patches, or nothing, bound are those they were; facets lie in the planes of patches.
void ExpectPatches(const Cube& cube)
{
  const RelaxedBody& body = cube.Body;
  std::map<std::pair<Id, Id>, int> edges;
  for (std::size_t k = 0; k < body.Facets.size(); ++k)
  {
    ++edges[std::minmax(body.Facets[k], body.Facets[NextSlotOf(k)])];
    const Point3 off =
      body.Points[At(body.Facets[k])] - cube.Ground.Mesh.At(3 * At(body.FacetPlaces[k / 3]));
    EXPECT_EQ(Dot(off, cube.Ground.NormalOf(At(body.FacetPlaces[k / 3]))), 0.0);
  }
  for (std::size_t k = 0; k < body.PieceEnds.size(); k += 2)
  {
    EXPECT_GE(edges[std::minmax(body.PieceEnds[k], body.PieceEnds[k + 1])], 2);
  }
}

} // namespace

TEST(BodyRelaxation, MakesAllAnglesOfACubeAtLeastThirtyDegrees)
{
  Cube cube(12, 1, 0.45);
  ExpectBody(cube.Body);
  EXPECT_LT(SmallestAngle(cube.Body), 10.0);
  cube.Relax();
  EXPECT_GE(SmallestAngle(cube.Body), 30.0);
  ExpectBody(cube.Body);
  ExpectPatches(cube);
  EXPECT_NEAR(VolumeOf(cube.Body, 0), 1.0, 1e-12);
}

TEST(BodyRelaxation, KeepsRegionsAndTheirInterface)
{
  Cube cube(12, 2, 0.2);
  ExpectBody(cube.Body);
  const std::vector<Point3> before(
    cube.Body.Points.begin(), cube.Body.Points.begin() + cube.Body.NumberOnLines);
  cube.Relax();
  EXPECT_GE(SmallestAngle(cube.Body), 30.0);
  ExpectBody(cube.Body);
  ExpectPatches(cube);
  EXPECT_NEAR(VolumeOf(cube.Body, 0), 0.5, 1e-12);
  EXPECT_NEAR(VolumeOf(cube.Body, 1), 0.5, 1e-12);
  EXPECT_TRUE(std::equal(before.begin(), before.end(), cube.Body.Points.begin()));
}

TEST(BodyRelaxation, SlidesAndMergesVerticesOfLinesWhichStayCovered)
{
  Cube cube(8, 1, 0.3, 0.45);
  const Id onLines = cube.Body.NumberOnLines;
  cube.Relax();
  EXPECT_GE(SmallestAngle(cube.Body), 30.0);
  ExpectBody(cube.Body);
  ExpectPatches(cube);
  EXPECT_NEAR(VolumeOf(cube.Body, 0), 1.0, 1e-12);
  EXPECT_LE(cube.Body.NumberOnLines, onLines);
  EXPECT_EQ(cube.Body.PieceChains.size(), cube.Body.PieceEnds.size() / 2);
  double length = 0.0;
  for (std::size_t k = 0; k < cube.Body.PieceEnds.size(); k += 2)
  {
    length += Distance(cube.Body.Points[At(cube.Body.PieceEnds[k])],
      cube.Body.Points[At(cube.Body.PieceEnds[k + 1])]);
  }
  EXPECT_NEAR(length, 12.0, 1e-12);
}

TEST(BodyRelaxation, NeverMakesTheWorstAngleWorseAndGivesTheSameAgain)
{
  for (const double unevenness : { 0.0, 0.1, 0.6 })
  {
    Cube cube(6, 1, unevenness);
    Cube again(6, 1, unevenness);
    const double before = SmallestAngle(cube.Body);
    cube.Relax();
    again.Relax();
    EXPECT_GE(SmallestAngle(cube.Body), before);
    EXPECT_EQ(cube.Body.Points, again.Body.Points);
    EXPECT_EQ(cube.Body.Corners, again.Body.Corners);
  }
}

TEST(BodyRelaxation, TakesBackThatTheOnlyCellAtAnEdgeWent)
{
  RelaxedBody body; // three tetrahedra around the edge of the points 3 and 4
  body.Points = { { 1, 0, 0 }, { -0.5, 0.9, 0 }, { -0.5, -0.9, 0 }, { 0, 0, -1 }, { 0, 0, 1 } };
  body.Sizes.assign(5, 1.0);
  body.NumberOnBoundary = 5;
  body.BoundaryPlaces.assign(5, 0);
  body.Corners = { 0, 1, 3, 4, 1, 2, 3, 4, 2, 0, 3, 4 };
  body.Regions.assign(3, 0);
  body.Twins.resize(12);
  std::map<Facet, Id> open;
  for (Id slot = 0; slot < 12; ++slot)
  {
    const auto& order = TetMesh::FacetCorners[At(slot % 4)];
    const auto corner = [&body, &order, slot](std::size_t k)
    { return body.Corners[At(slot - slot % 4) + At(order[k])]; };
    const Facet facet = Sorted(corner(0), corner(1), corner(2));
    const bool isInner = facet[1] == 3 && facet[2] == 4;
    if (!isInner)
    {
      body.Twins[At(slot)] = RelaxedBody::CodeOf(static_cast<Id>(body.FacetPlaces.size()));
      body.FacetPlaces.push_back(0);
      body.Facets.insert(body.Facets.end(), { corner(0), corner(1), corner(2) });
    }
    else if (open.count(facet) == 1)
    {
      body.Twins[At(slot)] = open[facet];
      body.Twins[At(open[facet])] = slot;
    }
    open[facet] = slot;
  }
  ExpectBody(body);
  const std::vector<Id> twins = body.Twins;
  Pulse pulse(NoMonitor());
  BodyTets tets(body, pulse);
  std::vector<CellChange> log;
  tets.Log = &log;
  CellChange change;
  change.Cells = { 0 };
  for (Id slot = 0; slot < 4; ++slot)
  {
    const Id record = tets.RecordOf(slot);
    const Id end = tets.VertexAt(slot); // the facet has the other one of the points 0 and 1
    if (record >= 0)
    {
      change.Facets.push_back({ record, { end == 3 ? 0 : 1, 3, 4 } });
    }
  }
  change.Apply(tets);
  ASSERT_EQ(log.size(), 1u);
  tets.Log = nullptr;
  CellChange(log.back()).Apply(tets);
  EXPECT_TRUE(std::equal(twins.begin(), twins.end(), tets.Mesh.Twins.begin()));
  tets.GiveBack();
  ExpectBody(body);
}

TEST(BodyRelaxation, TakesTrialsBackExactly)
{
  Cube cube(6, 2, 0.3);
  cube.Body.PieceChains.clear();
  const std::vector<Id> corners = cube.Body.Corners;
  const std::vector<Point3> points = cube.Body.Points;
  const std::vector<double> sizes = cube.Body.Sizes;
  const std::vector<Id> places = cube.Body.BoundaryPlaces;
  const std::vector<Id> regions = cube.Body.Regions;
  Pulse pulse(NoMonitor());
  const std::function<double(const Point3&)> f = [](const Point3&) { return 0.1; };
  BodyTets tets(cube.Body, pulse);
  GroundNormals normals(cube.Ground, tets);
  VertexMoves moves(tets, normals, f);
  EdgeRemoval edges(tets, normals);
  std::array<int, 4> done{};
  for (Id cell = 0; cell < static_cast<Id>(corners.size()) / 4; ++cell)
  {
    std::vector<CellChange> log;
    tets.Log = &log;
    tets.IsTrial = true;
    for (std::size_t k = 0; k < 4 && !tets.Mesh.IsFree(cell); ++k)
    {
      const std::size_t step = (At(cell) + k) % 4;
      const bool isDone = step == 0 ? moves.Improve(tets.VertexAt(4 * cell + cell % 4), 0.0)
        : step == 1                 ? edges.Split(cell, At(cell) % 6)
        : step == 2                 ? edges.Remove(cell, At(cell) % 5)
                    : moves.Merge(tets.VertexAt(4 * cell + 3), tets.VertexAt(4 * cell));
      done[step] += isDone ? 1 : 0;
    }
    moves.TakeBack();
    tets.IsTrial = false;
    ASSERT_TRUE(std::equal(corners.begin(), corners.end(), tets.Mesh.Corners.begin()));
    ASSERT_TRUE(std::equal(points.begin(), points.end(), tets.Mesh.Points.begin()));
  }
  EXPECT_GT(*std::min_element(done.begin(), done.end()), 50);
  tets.GiveBack();
  EXPECT_EQ(cube.Body.Corners, corners);
  EXPECT_EQ(cube.Body.Points, points);
  EXPECT_EQ(cube.Body.Sizes, sizes);
  EXPECT_EQ(cube.Body.BoundaryPlaces, places);
  EXPECT_EQ(cube.Body.Regions, regions);
  ExpectBody(cube.Body);
}

TEST(BodyRelaxation, TakesMergesOfVerticesOnLinesBackExactly)
{
  Cube cube(6, 1, 0.3, 0.45);
  const RelaxedBody before = cube.Body;
  Pulse pulse(NoMonitor());
  const std::function<double(const Point3&)> f = [](const Point3&) { return 0.1; };
  BodyTets tets(cube.Body, pulse);
  GroundNormals normals(cube.Ground, tets);
  VertexMoves moves(tets, normals, f);
  tets.IsTrial = true;
  int merged = 0;
  for (std::size_t k = 0; k < before.PieceEnds.size(); ++k)
  {
    const Id vertex = before.PieceEnds[k];
    const Id other = before.PieceEnds[k % 2 == 0 ? k + 1 : k - 1];
    std::vector<CellChange> log;
    tets.Log = &log;
    if (moves.Merge(vertex, other))
    {
      ++merged;
      EXPECT_EQ(tets.Lines.Between(other, vertex), NoId);
      // Another one goes to where this one went.
      for (std::size_t end = 0; end < before.PieceEnds.size(); ++end)
      {
        const Id last = before.PieceEnds[end];
        merged +=
          last != vertex && tets.Lines.Between(last, other) != NoId && moves.Merge(last, other) ? 1
                                                                                                : 0;
      }
    }
    moves.TakeBack();
    ASSERT_EQ(cube.Body.PieceEnds, before.PieceEnds);
    EXPECT_NE(tets.Lines.Between(other, vertex), NoId);
  }
  EXPECT_GT(merged, 20);
  tets.GiveBack();
  EXPECT_EQ(cube.Body.PieceChains, before.PieceChains);
  EXPECT_EQ(cube.Body.Corners, before.Corners);
  EXPECT_EQ(cube.Body.Points, before.Points);
  EXPECT_EQ(cube.Body.Facets.size(), before.Facets.size());
  ExpectBody(cube.Body);
}

/// Wants to stop when it is asked for that time.
class StopAfter : public SilentMonitor
{
public:
  explicit StopAfter(int times)
    : Left(times)
  {
  }
  bool Advance(double) override { return --this->Left > 0; }

  int Left;
};

TEST(BodyRelaxation, LeavesABodyWhenItIsStopped)
{
  constexpr int Most = 1000000;
  StopAfter never(Most);
  Cube(8, 2, 0.2).Relax(never);
  const int asked = Most - never.Left;
  EXPECT_GT(asked, 20);
  for (int times = 1; times < asked; times += 1 + asked / 12)
  {
    Cube cube(8, 2, 0.2);
    StopAfter stop(times);
    cube.Relax(stop);
    EXPECT_EQ(stop.Left, 0);
    ExpectBody(cube.Body);
  }
}

} // namespace biting
