// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "CutPlan.h"

#include "../Base/Tasks.h"
#include "CutLine.h"
#include "CutRows.h"
#include "DensitySamples.h"

#include <algorithm> // for sort, remove_if, max
#include <cmath>     // for log, abs
#include <limits>    // for the plane
#include <utility>   // for move

namespace biting
{

namespace
{

constexpr double LeastBlocks = 2.0; // in all
constexpr double LeastPart = 1.5;   // of a block, that is divided
constexpr double SamplesPerBlock = 200.0;
constexpr double VerticesPerIntegral = 1.1547; // of 1/f^2: of a lattice

// Thin domains in a large box where f is small outside them would have squares without end.
constexpr double LeastVisits = 50000.0;
constexpr double VisitsPerSample = 16.0;
constexpr int PlacesToEachSide = 12;   // of the middle, for a line
constexpr double LeastShare = 0.25;    // of a part, on each side of a line
constexpr double StepOfPlaces = 0.015; // of the part's vertices

// Of the integral along a line: parts of a stretch at least, and of the whole domain's diagonal.
constexpr int LeastParts = 4;
constexpr double PartsOfLine = 100.0;
constexpr double WayAside = 0.1;     // of the diagonal
constexpr double Beside = 0.02;      // of the diagonal: what counts in a part
constexpr double CostOfChange = 0.3; // of f by a factor of e, in vertices on the cut

// An end that is not open (CutLine.h), in vertices on the cut: it is where angles may be small.
constexpr double CostOfNarrowEnd = 40.0;

// Parallel cuts give both sides of a block nearly the same lattice also where f changes: two such
// cuts of a square cost less than a cross does, three or more do not.
constexpr double CostOfOtherDirection = 2.5; // than that of the first cut

using Samples = std::vector<DensitySample>;

double TotalOf(const Samples& samples)
{
  double sum = 0.0;
  for (const DensitySample& sample : samples)
  {
    sum += sample.Density;
  }
  return sum;
}

// Where the lower side has so many shares of the whole: between samples.
std::vector<double> PlacesOf(Samples& samples, bool isVertical)
{
  std::sort(samples.begin(), samples.end(),
    [isVertical](const DensitySample& a, const DensitySample& b)
    {
      const double first = Coordinate(a.Place, isVertical);
      const double second = Coordinate(b.Place, isVertical);
      return first != second ? first < second : a.Place < b.Place;
    });
  std::vector<double> places(
    2 * PlacesToEachSide + 1, Coordinate(samples.back().Place, isVertical));
  const double total = TotalOf(samples);
  double sum = 0.0;
  std::size_t next = 0;
  for (const DensitySample& sample : samples)
  {
    sum += sample.Density;
    while (next < places.size() &&
      sum >= total * (0.5 + StepOfPlaces * (static_cast<double>(next) - PlacesToEachSide)))
    {
      places[next++] = Coordinate(sample.Place, isVertical);
    }
  }
  return places;
}

// Whether both sides have a fair share: one sample may have nearly all.
bool Divides(const Samples& samples, bool isVertical, double place)
{
  double lower = 0.0;
  for (const DensitySample& sample : samples)
  {
    lower += Coordinate(sample.Place, isVertical) < place ? sample.Density : 0.0;
  }
  const double total = TotalOf(samples);
  return lower >= LeastShare * total && lower <= (1.0 - LeastShare) * total;
}

// The middle first, then by turns.
std::vector<double> FromTheMiddle(const std::vector<double>& places)
{
  std::vector<double> ordered{ places[PlacesToEachSide] };
  for (int k = 1; k <= PlacesToEachSide; ++k)
  {
    ordered.push_back(places[PlacesToEachSide - k]);
    ordered.push_back(places[PlacesToEachSide + k]);
  }
  return ordered;
}

// A node that may be divided.
struct Part
{
  Id Node;
  Box2 Box; ///< in the frame, as the samples
  Samples Inside;
  std::vector<Id> Others; ///< CutScene::Others, of the first `Seen` pieces
  Id Seen = 0;
};

// A good line with what it cuts; the cost is infinite where there is none.
struct Cut
{
  AxisLine Line;
  CutLine Along;
  double Cost = std::numeric_limits<double>::infinity();
};

class Planner
{
public:
  Planner(const Domain& domain, const DomainLocator& locator, const Spacing& spacing,
    const CutOptions& options, Pulse& pulse)
    : Geometry(domain)
    , Locator(locator)
    , F(spacing)
    , Options(options)
    , Beats(pulse)
    , Frame(FrameOf(domain, pulse))
    , Rows(spacing, BoundsIn(Frame, domain), LongestSidesIn(Frame, domain, pulse),
        options.SideLength, Frame)
  {
    this->Plan.Tree.Frame = this->Frame;
    if (this->Frame.IsMostlyVertical)
    {
      this->Rows.AddCut(*this->Frame.IsMostlyVertical);
    }
    this->Plan.Graph = CutGraph(domain);
  }

  CutPlan Run();

private:
  Id AddNode(double share);
  bool Divide(Part& part);
  bool FindTouches();
  void FileDomain();
  Cut FindBestCut(Part& part, const CutScene& scene, CutEffort effort);
  Cut FindCut(Part& part, const CutScene& scene, bool isVertical, CutEffort effort);
  double CostOf(const CutLine& line) const;
  double CostOf(const Point2& place, const Point2& step) const;
  CutScene SceneOf(Part& part) const;
  void Apply(const CutLine& line, bool isFolded);
  Id VertexFor(const CutEnd& end);
  void DivideNode(Part& part, const AxisLine& line);
  void NumberLeaves();

  const Domain& Geometry;
  const DomainLocator& Locator;
  const Spacing& F;
  CutOptions Options;
  Pulse& Beats;
  CutFrame Frame;
  CutRows Rows;
  CutPlan Plan;
  std::vector<Part> Pending;
  BoxTree<CutScene::Filed> Tree;
  double VerticesPerDensity = 0.0;
};

CutPlan Planner::Run()
{
  const double vertices = this->Options.Vertices;
  const double verticesPerBlock = this->Options.VerticesPerBlock;
  this->AddNode(vertices);
  if (vertices >= LeastBlocks * verticesPerBlock && this->FindTouches())
  {
    constexpr double Far = std::numeric_limits<double>::infinity();
    const double most = std::max(1.0, verticesPerBlock / (SamplesPerBlock * VerticesPerIntegral));
    const double mostVisits = LeastVisits + VisitsPerSample * vertices / most;
    Samples samples = SampleDensity(this->Geometry, this->Locator, this->F, most,
      static_cast<std::size_t>(mostVisits), this->Beats);
    for (DensitySample& sample : samples)
    {
      sample.Place = this->Frame.To(sample.Place);
    }
    const double total = TotalOf(samples);
    if (!(total > 0.0) || this->Beats.HasStopped())
    {
      this->NumberLeaves();
      return std::move(this->Plan);
    }
    this->VerticesPerDensity = vertices / total;
    this->FileDomain();
    this->Pending.push_back({ 0, { { -Far, -Far }, { Far, Far } }, std::move(samples), {},
      this->Plan.Graph.NumberOfPieces() });
  }
  while (!this->Pending.empty() && this->Beats.Ask())
  {
    Part part = std::move(this->Pending.back());
    this->Pending.pop_back();
    const bool isLarge = this->Plan.Tree.Nodes[part.Node].Vertices >= LeastPart * verticesPerBlock;
    if (!isLarge || !this->Divide(part))
    {
      this->Plan.Stretches[part.Node] = this->Rows.StretchOf(part.Box);
    }
  }
  this->NumberLeaves();
  return std::move(this->Plan);
}

Id Planner::AddNode(double vertices)
{
  this->Plan.Tree.Nodes.emplace_back();
  this->Plan.Tree.Nodes.back().Vertices = vertices;
  this->Plan.Stretches.push_back(1.0);
  return static_cast<Id>(this->Plan.Tree.Nodes.size()) - 1;
}

// Where lattices of both sides have to fit along the least of the mesh. False: it stays whole.
bool Planner::Divide(Part& part)
{
  const CutScene scene = this->SceneOf(part);
  Cut best = this->FindBestCut(part, scene, CutEffort::AsItIs);
  if (!best.Along.IsGood)
  {
    best = this->FindBestCut(part, scene, CutEffort::MoveEnds);
  }
  if (!best.Along.IsGood || this->Beats.HasStopped())
  {
    return false;
  }
  this->Rows.AddCut(best.Line.IsVertical);
  this->Apply(best.Along, !this->Rows.IsStraight(best.Line.IsVertical));
  this->DivideNode(part, best.Line);
  return true;
}

// Blocks have a segment that touches another one as a whole, or not at all. False where there are
// too many to be kept apart from cuts.
bool Planner::FindTouches()
{
  NearTouches& touches = this->Plan.Touches;
  touches = FindNearTouches(this->Geometry, this->F, this->Beats);
  if (touches.AreEverywhere)
  {
    return false;
  }
  this->Plan.AreTouching.assign(this->Geometry.Starts.size(), 0);
  for (const NearTouches::Pair& pair : touches.Pairs)
  {
    this->Plan.AreTouching[pair.First] = 1;
    this->Plan.AreTouching[pair.Second] = 1;
  }
  return true;
}

void Planner::FileDomain()
{
  const std::vector<Point2>& vertices = this->Geometry.Vertices;
  const auto boxOf = [this, &vertices](Id a, Id b)
  { return Box2::Around(this->Frame.To(vertices[a]), this->Frame.To(vertices[b])); };
  std::vector<CutScene::Filed> all;
  all.reserve(this->Geometry.Starts.size());
  for (Id piece = 0; piece < this->Plan.Graph.NumberOfPieces(); ++piece)
  {
    const CutGraph::Piece& ends = this->Plan.Graph.Pieces[piece];
    all.push_back({ piece, ends.End, boxOf(ends.Start, ends.End) });
  }
  for (Id vertex = 0; vertex < this->Geometry.NumberOfVertices(); ++vertex)
  {
    if (this->Geometry.IsEmbedded[vertex] != 0)
    {
      all.push_back({ NoId, vertex, boxOf(vertex, vertex) });
    }
  }
  this->Tree = BoxTree<CutScene::Filed>(all, this->Beats);
}

Cut Planner::FindBestCut(Part& part, const CutScene& scene, CutEffort effort)
{
  Cut vertical = this->FindCut(part, scene, true, effort);
  Cut level = this->FindCut(part, scene, false, effort);
  return (this->Rows.IsStraight(true) ? 1.0 : CostOfOtherDirection) * vertical.Cost <=
      (this->Rows.IsStraight(false) ? 1.0 : CostOfOtherDirection) * level.Cost
    ? std::move(vertical)
    : std::move(level);
}

// Lines as tasks.
Cut Planner::FindCut(Part& part, const CutScene& scene, bool isVertical, CutEffort effort)
{
  const std::vector<double> places = FromTheMiddle(PlacesOf(part.Inside, isVertical));
  std::vector<Cut> cuts(places.size());
  DoTasks(this->Beats, places.size(),
    [this, &part, &scene, isVertical, effort, &places, &cuts](std::size_t k, Monitor&)
    {
      const double place = this->Rows.FittingPlace(places[k], part.Box, isVertical);
      if (Divides(part.Inside, isVertical, place))
      {
        cuts[k].Line = { isVertical, place };
        cuts[k].Along = MakeCutLine(scene, cuts[k].Line, effort);
        cuts[k].Cost = cuts[k].Along.IsGood ? this->CostOf(cuts[k].Along) : cuts[k].Cost;
      }
    });
  Cut best;
  best.Along.IsGood = false;
  for (Cut& cut : cuts)
  {
    if (cut.Cost < best.Cost)
    {
      best = std::move(cut);
    }
  }
  return best;
}

double Planner::CostOf(const CutLine& line) const
{
  double cost = 0.0;
  for (const CutStretch& stretch : line.Stretches)
  {
    const int narrowEnds = (stretch.From.IsOpen ? 0 : 1) + (stretch.To.IsOpen ? 0 : 1);
    cost += CostOfNarrowEnd * narrowEnds;
    const Point2 way = stretch.To.Place - stretch.From.Place;
    const int parts =
      LeastParts + static_cast<int>(PartsOfLine * Length(way) / this->Geometry.Bounds.Diagonal());
    const Point2 step = (1.0 / parts) * way;
    for (int k = 0; k < parts; ++k)
    {
      cost += this->CostOf(stretch.From.Place + (k + 0.5) * step, step);
    }
  }
  return cost;
}

// The vertices on the step, and more the more f changes from there to both sides: lattices that
// grow from a line into what is coarser lose rows all the way, along it they need not.
double Planner::CostOf(const Point2& place, const Point2& step) const
{
  const double length = Length(step);
  const double aside = WayAside * this->Geometry.Bounds.Diagonal() / length;
  const Point2 across{ -aside * step.Y, aside * step.X };
  const double f = this->F(place);
  const double change = std::abs(std::log(this->F(place + across) / f)) +
    std::abs(std::log(this->F(place - across) / f));
  return length / f * (1.0 + CostOfChange * change);
}

// Of the parts that this one is of, and what was added since then.
CutScene Planner::SceneOf(Part& part) const
{
  const CutGraph& graph = this->Plan.Graph;
  CutScene scene{ graph, this->Locator, this->F, this->Frame, this->Plan.AreTouching,
    this->Geometry.IsPreserved, this->Tree, part.Box, part.Box, {} };
  scene.Around.Grow(Beside * this->Geometry.Bounds.Diagonal());
  for (; part.Seen < graph.NumberOfPieces(); ++part.Seen)
  {
    part.Others.push_back(part.Seen);
  }
  part.Others.erase(std::remove_if(part.Others.begin(), part.Others.end(),
                      [&scene](Id piece) { return !scene.BoundsOf(piece).Meets(scene.Around); }),
    part.Others.end());
  scene.Others = part.Others;
  return scene;
}

void Planner::Apply(const CutLine& line, bool isFolded)
{
  for (const CutStretch& stretch : line.Stretches)
  {
    const Id from = this->VertexFor(stretch.From);
    const Id to = this->VertexFor(stretch.To);
    this->Plan.Graph.Pieces.push_back(
      { from, to, NoId, { isFolded, stretch.From.IsOpen, stretch.To.IsOpen } });
  }
}

// A place on a piece is the end of one stretch and the beginning of the next.
Id Planner::VertexFor(const CutEnd& end)
{
  CutGraph& graph = this->Plan.Graph;
  if (end.Vertex != NoId)
  {
    return end.Vertex;
  }
  if (graph.Vertices.size() > this->Geometry.Vertices.size() && graph.Vertices.back() == end.Place)
  {
    return static_cast<Id>(graph.Vertices.size()) - 1;
  }
  const Id vertex = graph.AddVertex(end.Place, graph.Pieces[end.Piece].Segment);
  graph.Split(end.Piece, vertex);
  return vertex;
}

void Planner::DivideNode(Part& part, const AxisLine& line)
{
  Part low{ NoId, part.Box, {}, part.Others, part.Seen };
  Part high{ NoId, part.Box, {}, std::move(part.Others), part.Seen };
  (line.IsVertical ? low.Box.High.X : low.Box.High.Y) = line.At;
  (line.IsVertical ? high.Box.Low.X : high.Box.Low.Y) = line.At;
  for (const DensitySample& sample : part.Inside)
  {
    (Coordinate(sample.Place, line.IsVertical) < line.At ? low : high).Inside.push_back(sample);
  }
  low.Node = this->AddNode(this->VerticesPerDensity * TotalOf(low.Inside));
  high.Node = this->AddNode(this->VerticesPerDensity * TotalOf(high.Inside));
  CutTree::Node& node = this->Plan.Tree.Nodes[part.Node];
  node.IsVertical = line.IsVertical;
  node.At = line.At;
  node.Children = low.Node;
  this->Pending.push_back(std::move(high));
  this->Pending.push_back(std::move(low));
}

void Planner::NumberLeaves()
{
  for (CutTree::Node& node : this->Plan.Tree.Nodes)
  {
    node.Leaf = node.Children == NoId ? this->Plan.Tree.NumberOfLeaves++ : NoId;
  }
}

} // namespace

CutPlan PlanCuts(const Domain& domain, const DomainLocator& locator, const Spacing& spacing,
  const CutOptions& options, Pulse& pulse)
{
  return Planner(domain, locator, spacing, options, pulse).Run();
}

} // namespace biting
