// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "RegionFill.h"

#include "../Base/SortInSteps.h"

#include <algorithm> // for max, min
#include <cstdint>   // for flags
#include <utility>   // for move

namespace biting
{

namespace
{

// Where steps end, as shares of the time for a million points: of all, and of numbering triangles.
constexpr double FindingEnd = 0.15;
constexpr double BorderEnd = 0.17;
constexpr double FloodEnd = 0.6;
constexpr double RegionsEnd = 0.62;
constexpr double NumbersEnd = 0.72;
constexpr double ListEnd = 0.78;
constexpr double ConstraintsEnd = 0.84;
constexpr double NeighborsEnd = 0.93;
constexpr double CountingEnd = 0.7;

/// A half-edge with a mark, and what decides when one comes to it along the constraints.
struct BorderEdge
{
  Id Edge = NoId;
  Id Constraint = NoId;
  Point2 Place;           ///< the end that is nearer to the constraint's start
  bool IsReverse = false; ///< the constraint leads from greater points to less ones
  bool IsRight = false;   ///< the triangle is on the right of the constraint
};

/// Ends are compared along the constraint by the order of points: exact, as they are collinear.
bool ComesBefore(const BorderEdge& a, const BorderEdge& b)
{
  if (a.Constraint != b.Constraint)
  {
    return a.Constraint < b.Constraint;
  }
  if (a.Place != b.Place)
  {
    return (a.Place < b.Place) != a.IsReverse;
  }
  return !a.IsRight && b.IsRight;
}

BorderEdge MakeBorderEdge(const HalfEdgeMesh& mesh, const ConstraintEdges& constraints, Id edge)
{
  const Id constraint = mesh.Marks[edge] / 2;
  const Point2& origin = mesh.PointAt(mesh.Origin(edge));
  const Point2& target = mesh.PointAt(mesh.Target(edge));
  const bool isReverse =
    mesh.PointAt(constraints.Ends[constraint]) < mesh.PointAt(constraints.Starts[constraint]);
  const bool isRight = (target < origin) != isReverse;
  return { edge, constraint, isRight ? target : origin, isReverse, isRight };
}

std::vector<BorderEdge> FindBorder(
  const HalfEdgeMesh& mesh, const ConstraintEdges& constraints, Pulse& pulse)
{
  const PulsePart part(pulse, 0.0, FindingEnd);
  std::vector<BorderEdge> border;
  pulse.ForEach(HalfEdgeMesh::FirstEdge(mesh.NumberOfTriangles),
    [&mesh, &constraints, &border](std::size_t edge)
    {
      if (mesh.Marks[edge] != NoId)
      {
        border.push_back(MakeBorderEdge(mesh, constraints, static_cast<Id>(edge)));
      }
    });
  return border;
}

/// All half-edges with a mark, along the constraints.
std::vector<BorderEdge> CollectBorder(
  const HalfEdgeMesh& mesh, const ConstraintEdges& constraints, Pulse& pulse)
{
  std::vector<BorderEdge> border = FindBorder(mesh, constraints, pulse);
  const PulsePart part(pulse, FindingEnd, BorderEnd);
  SortInSteps(border, ComesBefore, pulse);
  return border;
}

/// All triangles, breadth first from all borders at once: layer by layer. Waves that meet within a
/// face become one; a wave stands for the others of its face.
class Flood
{
public:
  Flood(const HalfEdgeMesh& mesh, const std::vector<BorderEdge>& border, Pulse& pulse);

  Id Size() const { return static_cast<Id>(this->Triangles.size()); }
  Id NumberOfWaves() const { return static_cast<Id>(this->Parents.size()); }
  Id TriangleAt(Id place) const { return this->Triangles[place]; }
  Id PlaceOf(Id triangle) const { return this->Places[triangle]; }

  /// The face of the triangle at a place: the number of one of its waves.
  Id FaceAt(Id place) { return this->FaceOfWave(this->Waves[place]); }
  Id FaceOf(Id triangle) { return this->FaceAt(this->Places[triangle]); }

  /// The face beyond the convex hull.
  Id OuterFace() { return this->FaceOf(this->Ghost); }

  /// Gives back what tells faces apart.
  void ReleaseWaves(Pulse& pulse) { ReleaseInSteps(pulse, this->Waves, this->Parents); }

  std::vector<Id> TakeTriangles() { return std::move(this->Triangles); }
  std::vector<Id> TakePlaces() { return std::move(this->Places); }

private:
  void Start(Id triangle);
  void Spread(Id place);
  void Add(Id triangle, Id wave);
  void Unite(Id wave, Id other);
  Id FaceOfWave(Id wave);

  const HalfEdgeMesh& Mesh;
  Id Ghost = 0;
  std::vector<Id> Triangles; ///< place -> triangle
  std::vector<Id> Places;    ///< triangle -> place
  std::vector<Id> Waves;     ///< place -> wave
  std::vector<Id> Parents;   ///< wave -> a wave of the same face, not greater
};

Flood::Flood(const HalfEdgeMesh& mesh, const std::vector<BorderEdge>& border, Pulse& pulse)
  : Mesh(mesh)
  , Places(mesh.NumberOfTriangles, NoId)
{
  const PulsePart part(pulse, BorderEnd, FloodEnd);
  this->Triangles.reserve(mesh.NumberOfTriangles);
  this->Waves.reserve(mesh.NumberOfTriangles);
  for (std::size_t k = 0; k < border.size() && pulse.Beat(); ++k)
  {
    this->Start(HalfEdgeMesh::TriangleOf(border[k].Edge));
  }
  while (!mesh.IsGhost(this->Ghost) && pulse.Beat())
  {
    ++this->Ghost;
  }
  this->Start(this->Ghost);
  for (Id place = 0; place < this->Size() && pulse.Beat(); ++place)
  {
    pulse.SetFraction(static_cast<double>(place) / mesh.NumberOfTriangles);
    this->Spread(place);
  }
}

void Flood::Start(Id triangle)
{
  if (this->Places[triangle] == NoId)
  {
    this->Parents.push_back(this->NumberOfWaves());
    this->Add(triangle, this->NumberOfWaves() - 1);
  }
}

void Flood::Spread(Id place)
{
  const Id wave = this->Waves[place];
  const Id first = HalfEdgeMesh::FirstEdge(this->Triangles[place]);
  for (Id edge = first; edge < first + 3; ++edge)
  {
    if (this->Mesh.Marks[edge] != NoId)
    {
      continue;
    }
    const Id neighbor = HalfEdgeMesh::TriangleOf(this->Mesh.Twins[edge]);
    if (this->Places[neighbor] == NoId)
    {
      this->Add(neighbor, wave);
    }
    else if (this->Waves[this->Places[neighbor]] != wave)
    {
      this->Unite(wave, this->Waves[this->Places[neighbor]]);
    }
  }
}

void Flood::Add(Id triangle, Id wave)
{
  this->Places[triangle] = this->Size();
  this->Triangles.push_back(triangle);
  this->Waves.push_back(wave);
}

void Flood::Unite(Id wave, Id other)
{
  const Id face = this->FaceOfWave(wave);
  const Id otherFace = this->FaceOfWave(other);
  this->Parents[std::max(face, otherFace)] = std::min(face, otherFace);
}

Id Flood::FaceOfWave(Id wave)
{
  while (this->Parents[wave] != wave)
  {
    this->Parents[wave] = this->Parents[this->Parents[wave]];
    wave = this->Parents[wave];
  }
  return wave;
}

/// A step from face to face, across a half-edge with a mark.
struct Step
{
  Id From = NoId;
  Id To = NoId;
  std::uint8_t IsOdd = 0;
};

/// The steps of all borders by the face they start from; those from face f are
/// Steps[Begins[f]] .. Steps[Begins[f + 1] - 1].
struct FaceGraph
{
  std::vector<Step> Steps;
  std::vector<Id> Begins;
};

FaceGraph MakeFaceGraph(
  const HalfEdgeMesh& mesh, const std::vector<BorderEdge>& border, Flood& flood, Pulse& pulse)
{
  FaceGraph graph;
  graph.Begins.assign(flood.NumberOfWaves() + 1, 0);
  std::vector<Step> steps(border.size());
  pulse.ForEach(border.size(),
    [&mesh, &border, &flood, &graph, &steps](std::size_t k)
    {
      const Id edge = border[k].Edge;
      const Id from = flood.FaceOf(HalfEdgeMesh::TriangleOf(edge));
      const Id to = flood.FaceOf(HalfEdgeMesh::TriangleOf(mesh.Twins[edge]));
      steps[k] = { from, to, static_cast<std::uint8_t>(mesh.Marks[edge] & 1) };
      ++graph.Begins[from + 1];
    });
  for (Id face = 0; face < flood.NumberOfWaves() && pulse.Beat(); ++face)
  {
    graph.Begins[face + 1] += graph.Begins[face];
  }
  graph.Steps.resize(steps.size());
  std::vector<Id> next = graph.Begins;
  pulse.ForEach(steps.size(),
    [&graph, &steps, &next](std::size_t k) { graph.Steps[next[steps[k].From]++] = steps[k]; });
  return graph;
}

/// Face -> 1 where it is an odd number of boundaries away from the outer face.
std::vector<std::uint8_t> FindInside(const FaceGraph& graph, Id outerFace, Pulse& pulse)
{
  constexpr std::uint8_t unknown = 2;
  std::vector<std::uint8_t> isInside(graph.Begins.size() - 1, unknown);
  std::vector<Id> queue{ outerFace };
  isInside[outerFace] = 0;
  for (std::size_t next = 0; next < queue.size(); ++next)
  {
    const Id face = queue[next];
    for (Id i = graph.Begins[face]; i < graph.Begins[face + 1] && pulse.Beat(); ++i)
    {
      const Step& step = graph.Steps[i];
      if (isInside[step.To] == unknown)
      {
        isInside[step.To] = isInside[face] ^ step.IsOdd;
        queue.push_back(step.To);
      }
    }
  }
  return isInside;
}

/// The regions: the faces inside.
struct Regions
{
  std::vector<Id> OfFace; ///< face -> region, NoId outside
  Id Size = 0;
};

Regions NumberRegions(
  const HalfEdgeMesh& mesh, const std::vector<BorderEdge>& border, Flood& flood, Pulse& pulse)
{
  const PulsePart part(pulse, FloodEnd, RegionsEnd);
  const std::vector<std::uint8_t> isInside =
    FindInside(MakeFaceGraph(mesh, border, flood, pulse), flood.OuterFace(), pulse);
  Regions regions;
  regions.OfFace.assign(flood.NumberOfWaves(), NoId);
  for (std::size_t k = 0; k < border.size() && pulse.Beat(); ++k)
  {
    const Id face = flood.FaceOf(HalfEdgeMesh::TriangleOf(border[k].Edge));
    if (isInside[face] == 1 && regions.OfFace[face] == NoId)
    {
      regions.OfFace[face] = regions.Size++;
    }
  }
  return regions;
}

/// Copies triangles out: renumbered, without gaps and ghosts.
class Writer
{
public:
  Writer(HalfEdgeMesh& mesh, const std::vector<Id>& order, Flood& flood, Pulse& pulse)
    : Mesh(mesh)
    , Order(order)
    , Source(flood)
    , Beats(pulse)
  {
  }

  /// Empty on abort.
  Triangulation Write(const Regions& regions);

private:
  void NumberTriangles(const Regions& regions);
  std::vector<Id> CountTriangles(const Regions& regions);
  void ListInside();
  template <typename ValueOf>
  void WriteHalves(std::vector<Id>& array, double begin, double end, ValueOf&& valueOf);

  HalfEdgeMesh& Mesh;
  const std::vector<Id>& Order;
  Flood& Source;
  Pulse& Beats;
  std::vector<Id> Numbers; ///< place -> triangle of the result, NoId outside
  std::vector<Id> Inside;  ///< triangle of the result -> of the mesh
  Triangulation Result;
};

Triangulation Writer::Write(const Regions& regions)
{
  this->NumberTriangles(regions);
  this->ListInside();
  this->WriteHalves(this->Result.Constraints, ListEnd, ConstraintsEnd,
    [this](Id edge)
    {
      const Id mark = this->Mesh.Marks[edge];
      return mark == NoId ? NoId : mark / 2;
    });
  ReleaseInSteps(this->Beats, this->Mesh.Marks);
  this->WriteHalves(this->Result.Neighbors, ConstraintsEnd, NeighborsEnd,
    [this](Id edge) { return this->Numbers[HalfEdgeMesh::TriangleOf(this->Mesh.Twins[edge])]; });
  ReleaseInSteps(this->Beats, this->Mesh.Twins, this->Numbers);
  this->WriteHalves(this->Result.Corners, NeighborsEnd, 1.0,
    [this](Id edge) { return this->Order[this->Mesh.Corners[edge]]; });
  ReleaseInSteps(this->Beats, this->Mesh.Corners);
  return this->Beats.HasStopped() ? Triangulation() : std::move(this->Result);
}

/// Region by region, in the order of the flood within; fills Regions of the result.
void Writer::NumberTriangles(const Regions& regions)
{
  const PulsePart part(this->Beats, RegionsEnd, NumbersEnd);
  std::vector<Id> begins = this->CountTriangles(regions);
  for (Id region = 0; region < regions.Size && !this->Beats.HasStopped(); ++region)
  {
    this->Result.Regions.resize(this->Result.Regions.size() + begins[region + 1], region);
    begins[region + 1] += begins[region];
  }
  const PulsePart rest(this->Beats, CountingEnd, 1.0);
  this->Beats.ForEach(this->Numbers.size(),
    [this, &begins](std::size_t place)
    {
      Id& number = this->Numbers[place];
      number = number == NoId ? NoId : begins[number]++;
    });
}

/// Numbers become those of the regions; returns the size of region r as entry r + 1.
std::vector<Id> Writer::CountTriangles(const Regions& regions)
{
  const PulsePart part(this->Beats, 0.0, CountingEnd);
  std::vector<Id> sizes(regions.Size + 1, 0);
  this->Numbers.resize(this->Source.Size());
  this->Beats.ForEach(this->Numbers.size(),
    [this, &regions, &sizes](std::size_t place)
    {
      const Id region = regions.OfFace[this->Source.FaceAt(static_cast<Id>(place))];
      this->Numbers[place] = region;
      if (region != NoId)
      {
        ++sizes[region + 1];
      }
    });
  return sizes;
}

/// From places on to triangles of the mesh: Numbers are theirs afterwards.
void Writer::ListInside()
{
  const PulsePart part(this->Beats, NumbersEnd, ListEnd);
  this->Source.ReleaseWaves(this->Beats);
  std::vector<Id> triangles = this->Source.TakeTriangles();
  GrowInSteps(this->Inside, this->Result.Regions.size(), NoId, this->Beats);
  this->Beats.ForEach(this->Numbers.size(),
    [this, &triangles](std::size_t place)
    {
      if (this->Numbers[place] != NoId)
      {
        this->Inside[this->Numbers[place]] = triangles[place];
      }
    });
  ReleaseInSteps(this->Beats, triangles);
  std::vector<Id> places = this->Source.TakePlaces();
  this->Beats.ForEach(
    places.size(), [this, &places](std::size_t t) { places[t] = this->Numbers[places[t]]; });
  this->Numbers.swap(places);
}

template <typename ValueOf>
void Writer::WriteHalves(std::vector<Id>& array, double begin, double end, ValueOf&& valueOf)
{
  const PulsePart part(this->Beats, begin, end);
  array.reserve(3 * this->Inside.size());
  this->Beats.ForEach(this->Inside.size(),
    [this, &array, &valueOf](std::size_t number)
    {
      const Id first = HalfEdgeMesh::FirstEdge(this->Inside[number]);
      for (Id k = 0; k < 3; ++k)
      {
        array.push_back(valueOf(first + k));
      }
    });
}

} // namespace

Triangulation TakeInside(HalfEdgeMesh& mesh, const ConstraintEdges& constraints,
  const std::vector<Id>& order, Pulse& pulse)
{
  const std::vector<BorderEdge> border = CollectBorder(mesh, constraints, pulse);
  ReleaseInSteps(pulse, mesh.Points, mesh.VertexEdges);
  Flood flood(mesh, border, pulse);
  const Regions regions = NumberRegions(mesh, border, flood, pulse);
  return Writer(mesh, order, flood, pulse).Write(regions);
}

} // namespace biting
