// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "BlockDomains.h"

#include "../Base/Monitor.h"
#include "../Base/PointOnSegment.h"
#include "../Base/Pulse.h"
#include "../Biting/EdgeDivision.h"
#include "../Delaunay/Triangulation.h"
#include "../Domain/AreaSum.h"
#include "CutRows.h"

#include <algorithm> // for sort, stable_sort, unique, lower_bound, replace
#include <cmath>     // for sqrt
#include <cstdint>   // for flags
#include <limits>    // for areas
#include <map>       // for areas
#include <numeric>   // for iota
#include <utility>   // for move, pair

namespace biting
{

namespace
{

// Pairs of rows at an end that is not open, in which the cut stays on its line.
constexpr std::size_t StraightPairs = 2;

class CutDivider
{
public:
  CutDivider(const Spacing& spacing, const CutDivision& wanted, CutGraph& graph, Pulse& pulse)
    : F(spacing)
    , Wanted(wanted)
    , Graph(graph)
    , Sides(spacing, wanted.BitingConstant, wanted.PartLength, pulse)
    , Pairs(
        spacing, CutRows::Pair * wanted.BitingConstant, CutRows::Pair * wanted.PartLength, pulse)
  {
  }

  bool Divide(Id piece)
  {
    this->Start = this->Graph.Vertices[this->Graph.Pieces[piece].Start];
    this->End = this->Graph.Vertices[this->Graph.Pieces[piece].End];
    const bool isFolded = this->Graph.Pieces[piece].Folded.IsFolded;
    EdgeDivider& divider = isFolded ? this->Pairs : this->Sides;
    if (!divider.Divide(this->Start, this->End, this->Wanted.MostVertices, this->Points))
    {
      return false;
    }
    isFolded ? this->SplitFolded(piece) : this->SplitStraight(piece);
    return true;
  }

private:
  // A vertex on the line of the cut, and f there.
  struct PlaceOnLine
  {
    double Parameter;
    double F;
  };

  void SplitStraight(Id piece)
  {
    for (std::size_t k = 0; k < this->Points.Parameters.size(); ++k)
    {
      const Point2 place = PointOnSegment(
        this->Start, this->End, this->Points.Parameters[k], this->Points.Spacings[k]);
      piece = this->Graph.Split(piece, this->Graph.AddVertex(place, NoId));
    }
  }

  // The points divide it into pairs of rows, of which each is divided once more.
  void SplitFolded(Id piece)
  {
    const CutGraph::Fold fold = this->Graph.Pieces[piece].Folded;
    const std::size_t pairs = this->Points.Parameters.size() + 1;
    PlaceOnLine last{ 0.0, this->F(this->Start) };
    for (std::size_t k = 0; k < pairs; ++k)
    {
      const bool isLast = k + 1 == pairs;
      const PlaceOnLine next{ isLast ? 1.0 : this->Points.Parameters[k],
        isLast ? this->F(this->End) : this->Points.Spacings[k] };
      const bool isFolded = (fold.IsOpenAtStart || k >= StraightPairs) &&
        (fold.IsOpenAtEnd || k + StraightPairs < pairs);
      piece = this->Graph.Split(
        piece, this->Graph.AddVertex(this->FoldBetween(last, next, isFolded), NoId));
      if (!isLast)
      {
        const Point2 place = PointOnSegment(this->Start, this->End, next.Parameter, next.F);
        piece = this->Graph.Split(piece, this->Graph.AddVertex(place, NoId));
      }
      last = next;
    }
  }

  // Halves the integral of 1/f between two places, as it is where f is linear. The root is of a
  // ratio: so it is the same in all units of length.
  Point2 FoldBetween(const PlaceOnLine& first, const PlaceOnLine& next, bool isFolded) const
  {
    const double share = 1.0 / (1.0 + std::sqrt(next.F / first.F));
    const double parameter = first.Parameter + share * (next.Parameter - first.Parameter);
    const Point2 way = this->End - this->Start;
    const Point2 middle = this->Start + parameter * way;
    const double aside = isFolded ? 0.5 * this->Wanted.PartLength * this->F(middle) : 0.0;
    return middle + aside / Length(way) * Perpendicular(way);
  }

  const Spacing& F;
  const CutDivision& Wanted;
  CutGraph& Graph;
  EdgeDivider Sides;
  EdgeDivider Pairs;
  DivisionPoints Points;
  Point2 Start; ///< of the cut at hand
  Point2 End;
};

// The blocks on the two sides of a piece; NoId outside.
struct Sides
{
  Id Left = NoId;
  Id Right = NoId;
};

constexpr double DivisionEnd = 0.3; // of the time

// The area enclosed by the boundary.
void AddArea(Domain& domain)
{
  AreaSum area(domain.Bounds.Center());
  for (Id segment = 0; segment < domain.NumberOfSegments(); ++segment)
  {
    const Point2& start = domain.Vertices[domain.Starts[segment]];
    const Point2& end = domain.Vertices[domain.Ends[segment]];
    if (domain.IsBoundary[segment] != 0)
    {
      domain.LeftInside[segment] != 0 ? area.Add(start, end) : area.Add(end, start);
    }
  }
  domain.Area = area.Area();
}

class BlockMaker
{
public:
  BlockMaker(const Domain& domain, const CutPlan& plan, const CutGraph& graph)
    : Geometry(domain)
    , Plan(plan)
    , Graph(graph)
  {
  }

  std::vector<BlockDomain> Make(Monitor& monitor)
  {
    if (!this->Triangulate(monitor) || !this->HasAllPieces())
    {
      return {};
    }
    this->FindFaces();
    this->ChooseLeaves();
    this->UniteTouching();
    this->NumberBlocks();
    if (this->Leaves.size() < 2)
    {
      return {};
    }
    this->FindSides();
    return this->MakeBlocks();
  }

private:
  bool Triangulate(Monitor& monitor)
  {
    ConstraintEdges constraints;
    for (const CutGraph::Piece& piece : this->Graph.Pieces)
    {
      constraints.Starts.push_back(piece.Start);
      constraints.Ends.push_back(piece.End);
      constraints.IsBoundary.push_back(
        piece.Segment == NoId ? 0 : this->Geometry.IsBoundary[piece.Segment]);
    }
    TriangulationResult result =
      biting::Triangulate(this->Graph.Vertices, constraints, {}, monitor);
    this->Mesh = std::move(result.Mesh);
    return result.Conflicts.empty() && result.Coincidences.empty() && !result.WasAborted;
  }

  // Whether each piece is one edge, with the domain on all sides where it must be.
  bool HasAllPieces() const
  {
    std::vector<int> halves(this->Graph.Pieces.size(), 0);
    for (const Id piece : this->Mesh.Constraints)
    {
      if (piece != NoId)
      {
        ++halves[piece];
      }
    }
    for (Id piece = 0; piece < this->Graph.NumberOfPieces(); ++piece)
    {
      const Id segment = this->Graph.Pieces[piece].Segment;
      const int wanted = segment != NoId && this->Geometry.IsBoundary[segment] != 0 ? 1 : 2;
      if (halves[piece] != wanted)
      {
        return false;
      }
    }
    return true;
  }

  bool IsCut(std::size_t half) const
  {
    const Id piece = this->Mesh.Constraints[half];
    return piece != NoId && this->Graph.IsCut(piece);
  }

  void FindFaces()
  {
    this->Faces.assign(this->Mesh.Regions.size(), NoId);
    Id count = 0;
    for (Id triangle = 0; triangle < this->Mesh.NumberOfTriangles(); ++triangle)
    {
      if (this->Faces[triangle] == NoId)
      {
        this->Fill(triangle, count++);
      }
    }
    this->Blocks.assign(static_cast<std::size_t>(count), NoId);
  }

  void Fill(Id triangle, Id face)
  {
    std::vector<Id> front{ triangle };
    this->Faces[triangle] = face;
    while (!front.empty())
    {
      const std::size_t first = 3 * static_cast<std::size_t>(front.back());
      front.pop_back();
      for (std::size_t half = first; half < first + 3; ++half)
      {
        const Id next = this->Mesh.Neighbors[half];
        if (next != NoId && this->Faces[next] == NoId && !this->IsCut(half))
        {
          this->Faces[next] = face;
          front.push_back(next);
        }
      }
    }
  }

  // A face belongs to the leaf that has most of it.
  void ChooseLeaves()
  {
    std::map<std::pair<Id, Id>, double> areas; // of a face in a leaf
    for (Id triangle = 0; triangle < this->Mesh.NumberOfTriangles(); ++triangle)
    {
      const auto [middle, area] = this->MiddleOf(triangle);
      areas[{ this->Faces[triangle], this->Plan.Tree.NodeAt(middle) }] += area;
    }
    std::vector<double> largest(this->Blocks.size(), -std::numeric_limits<double>::infinity());
    for (const auto& [place, area] : areas)
    {
      if (area > largest[place.first])
      {
        largest[place.first] = area;
        this->Blocks[place.first] = place.second;
      }
    }
  }

  std::pair<Point2, double> MiddleOf(Id triangle) const
  {
    const Id* corners = this->Mesh.Corners.data() + 3 * static_cast<std::size_t>(triangle);
    const Point2& a = this->Graph.Vertices[corners[0]];
    const Point2 ab = this->Graph.Vertices[corners[1]] - a;
    const Point2 ac = this->Graph.Vertices[corners[2]] - a;
    return { a + 1.0 / 3.0 * (ab + ac), Cross(ab, ac) };
  }

  // A leaf that has no face is no block.
  void NumberBlocks()
  {
    std::vector<Id> numbers(this->Plan.Tree.Nodes.size(), NoId);
    for (const Id node : this->Blocks)
    {
      numbers[node] = 0;
    }
    for (Id node = 0; node < static_cast<Id>(numbers.size()); ++node)
    {
      if (numbers[node] != NoId)
      {
        numbers[node] = static_cast<Id>(this->Leaves.size());
        this->Leaves.push_back(node);
      }
    }
    for (Id& block : this->Blocks)
    {
      block = numbers[block];
    }
  }

  void FindSides()
  {
    this->SidesOf.resize(this->Graph.Pieces.size());
    for (std::size_t half = 0; half < this->Mesh.Corners.size(); ++half)
    {
      const Id piece = this->Mesh.Constraints[half];
      if (piece != NoId)
      {
        const Id start = this->Mesh.Corners[half - half % 3 + (half + 1) % 3];
        const Id block = this->Blocks[this->Faces[half / 3]];
        Sides& sides = this->SidesOf[piece];
        (start == this->Graph.Pieces[piece].Start ? sides.Left : sides.Right) = block;
      }
    }
  }

  // Two segments that nearly touch may be of faces in two leaves, though no cut is near, as the
  // land on both sides of a strait: the leaves become one block.
  void UniteTouching()
  {
    for (const CutTree::Node& node : this->Plan.Tree.Nodes)
    {
      this->Expected.push_back(node.Vertices);
    }
    const std::vector<Id> faces = this->FacesOfSegments();
    for (const NearTouches::Pair& pair : this->Plan.Touches.Pairs)
    {
      const Id first = this->Blocks[faces[pair.First]];
      const Id second = this->Blocks[faces[pair.Second]];
      if (first != second)
      {
        std::replace(this->Blocks.begin(), this->Blocks.end(), second, first);
        this->Expected[first] += this->Expected[second];
      }
    }
  }

  // Both sides of an uncut segment are in one face.
  std::vector<Id> FacesOfSegments() const
  {
    std::vector<Id> faces(this->Geometry.Starts.size(), NoId);
    for (std::size_t half = 0; half < this->Mesh.Constraints.size(); ++half)
    {
      const Id piece = this->Mesh.Constraints[half];
      if (piece != NoId && !this->Graph.IsCut(piece))
      {
        faces[this->Graph.Pieces[piece].Segment] = this->Faces[half / 3];
      }
    }
    return faces;
  }

  std::vector<BlockDomain> MakeBlocks() const
  {
    std::vector<BlockDomain> blocks(this->Leaves.size());
    for (std::size_t k = 0; k < blocks.size(); ++k)
    {
      blocks[k].ExpectedVertices = this->Expected[this->Leaves[k]];
      blocks[k].Stretch = this->Plan.Stretches[this->Leaves[k]];
      blocks[k].Leaf = this->Plan.Tree.Nodes[this->Leaves[k]].Leaf;
      blocks[k].Geometry.Resolution = this->Geometry.Resolution;
    }
    this->AddVertices(blocks);
    for (Id piece = 0; piece < this->Graph.NumberOfPieces(); ++piece)
    {
      for (const Id block : this->BlocksAt(piece))
      {
        this->AddPiece(piece, block, blocks[block]);
      }
    }
    for (BlockDomain& block : blocks)
    {
      AddArea(block.Geometry);
      block.ExpectedVertices += static_cast<double>(block.Vertices.size());
    }
    return blocks;
  }

  // A cut with one block on both sides is left out.
  std::vector<Id> BlocksAt(Id piece) const
  {
    const Sides& sides = this->SidesOf[piece];
    if (sides.Left == sides.Right)
    {
      return this->Graph.IsCut(piece) ? std::vector<Id>() : std::vector<Id>{ sides.Left };
    }
    std::vector<Id> blocks;
    for (const Id block : { sides.Left, sides.Right })
    {
      if (block != NoId)
      {
        blocks.push_back(block);
      }
    }
    return blocks;
  }

  // The ends of the pieces at each block, and embedded points, in the order of the graph.
  void AddVertices(std::vector<BlockDomain>& blocks) const
  {
    std::vector<std::pair<Id, Id>> uses; // vertex, block
    for (Id piece = 0; piece < this->Graph.NumberOfPieces(); ++piece)
    {
      for (const Id block : this->BlocksAt(piece))
      {
        uses.emplace_back(this->Graph.Pieces[piece].Start, block);
        uses.emplace_back(this->Graph.Pieces[piece].End, block);
      }
    }
    for (std::size_t half = 0; half < this->Mesh.Corners.size(); ++half)
    {
      const Id vertex = this->Mesh.Corners[half];
      if (this->IsEmbedded(vertex))
      {
        uses.emplace_back(vertex, this->Blocks[this->Faces[half / 3]]);
      }
    }
    std::sort(uses.begin(), uses.end());
    uses.erase(std::unique(uses.begin(), uses.end()), uses.end());
    for (const auto& [vertex, block] : uses)
    {
      this->AddVertex(vertex, blocks[block]);
    }
  }

  void AddVertex(Id vertex, BlockDomain& block) const
  {
    const bool isOld = vertex < this->Geometry.NumberOfVertices();
    Domain& geometry = block.Geometry;
    block.Vertices.push_back(vertex);
    geometry.Vertices.push_back(this->Graph.Vertices[vertex]);
    geometry.VertexPoints.push_back(isOld ? this->Geometry.VertexPoints[vertex] : NoId);
    geometry.IsEmbedded.push_back(this->IsEmbedded(vertex) ? 1 : 0);
    geometry.HasPoint.push_back(isOld && !this->Geometry.HasPoint.empty()
        ? this->Geometry.HasPoint[vertex]
        : std::uint8_t{ 0 });
    geometry.Bounds.Add(geometry.Vertices.back());
  }

  void AddPiece(Id piece, Id number, BlockDomain& block) const
  {
    const auto placeOf = [&block](Id vertex)
    {
      return static_cast<Id>(
        std::lower_bound(block.Vertices.begin(), block.Vertices.end(), vertex) -
        block.Vertices.begin());
    };
    const CutGraph::Piece& ends = this->Graph.Pieces[piece];
    const bool isCut = ends.Segment == NoId;
    Domain& geometry = block.Geometry;
    block.Pieces.push_back(piece);
    geometry.Starts.push_back(placeOf(ends.Start));
    geometry.Ends.push_back(placeOf(ends.End));
    geometry.Cells.push_back(isCut ? NoId : this->Geometry.Cells[ends.Segment]);
    geometry.IsBoundary.push_back(isCut ? 1 : this->Geometry.IsBoundary[ends.Segment]);
    geometry.LeftInside.push_back(this->SidesOf[piece].Left == number ? 1 : 0);
    geometry.RightInside.push_back(this->SidesOf[piece].Right == number ? 1 : 0);
    geometry.IsPreserved.push_back(isCut || this->Geometry.MustPreserve(ends.Segment) ? 1 : 0);
  }

  bool IsEmbedded(Id vertex) const
  {
    return vertex < this->Geometry.NumberOfVertices() && this->Geometry.IsEmbedded[vertex] != 0;
  }

  const Domain& Geometry;
  const CutPlan& Plan;
  const CutGraph& Graph;
  Triangulation Mesh;
  std::vector<Id> Faces;        ///< of the triangles: what cuts enclose
  std::vector<Id> Blocks;       ///< of the faces; nodes of the tree at first
  std::vector<double> Expected; ///< vertices, of the nodes
  std::vector<Id> Leaves;       ///< of the blocks: nodes
  std::vector<Sides> SidesOf;
};

} // namespace

bool DivideCuts(const Spacing& spacing, const CutDivision& wanted, CutGraph& graph, Pulse& pulse)
{
  CutDivider divider(spacing, wanted, graph, pulse);
  const Id undivided = graph.NumberOfPieces();
  for (Id piece = 0; piece < undivided; ++piece)
  {
    if (graph.IsCut(piece) && !divider.Divide(piece))
    {
      return false;
    }
  }
  return true;
}

BlockDomains MakeBlockDomains(const Domain& domain, const Spacing& spacing, const CutPlan& plan,
  const CutDivision& division, Monitor& monitor)
{
  BlockDomains result{ plan.Graph, {}, plan.AreTouching };
  if (plan.Tree.NumberOfLeaves < 2)
  {
    return result;
  }
  PartOfStage dividing(monitor, 0.0, DivisionEnd);
  Pulse pulse(dividing);
  if (DivideCuts(spacing, division, result.Graph, pulse))
  {
    PartOfStage making(monitor, DivisionEnd, 1.0);
    result.Blocks = BlockMaker(domain, plan, result.Graph).Make(making);
  }
  return result;
}

std::vector<std::vector<std::size_t>> ShareBlocks(
  const std::vector<BlockDomain>& blocks, const std::vector<Id>& dealtLeaves, std::size_t members)
{
  std::vector<std::size_t> largestFirst(blocks.size());
  std::iota(largestFirst.begin(), largestFirst.end(), std::size_t{ 0 });
  std::stable_sort(largestFirst.begin(), largestFirst.end(),
    [&blocks](std::size_t a, std::size_t b)
    { return blocks[a].ExpectedVertices > blocks[b].ExpectedVertices; });
  std::vector<std::vector<std::size_t>> shares(members);
  for (const std::size_t block : largestFirst)
  {
    shares[dealtLeaves[blocks[block].Leaf]].push_back(block);
  }
  return shares;
}

} // namespace biting
