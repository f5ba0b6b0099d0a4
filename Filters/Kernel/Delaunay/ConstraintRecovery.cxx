// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "ConstrainedMesh.h"

#include "../Predicates/Predicates.h"
#include "Cavity.h"
#include "Flips.h"

#include <algorithm> // for reverse, min, max
#include <utility>   // for swap

namespace biting
{

namespace
{

constexpr std::size_t MaximumNumberOfPairs = 10000;
constexpr double PreparationEnd = 0.5; // of the time, where constraints are few

/// Whether b, collinear with the two others, lies on the same side of `center` as a.
bool IsForward(const Point2& center, const Point2& a, const Point2& b)
{
  return (center < a) == (center < b);
}

/// Goes around a vertex in search of the way to another one, a triangle a step.
class StarSearch
{
public:
  StarSearch(const HalfEdgeMesh& mesh, Id center, Id target)
    : Mesh(mesh)
    , Center(center)
    , Target(target)
    , Edge(mesh.VertexEdges[center])
  {
  }

  /// Looks at one triangle; true where the way leads along its first edge, or through it.
  bool Step()
  {
    const Id edge = this->Edge;
    const Id right = this->Mesh.Origin(edge);
    const Id left = this->Mesh.Target(edge);
    if (right != NoId && this->IsAlong(right))
    {
      this->AlongEdge = HalfEdgeMesh::Previous(edge);
      return true;
    }
    if ((right | left) >= 0 && this->Side(right) < 0 && this->Side(left) > 0)
    {
      this->CrossedEdge = edge;
      return true;
    }
    this->Edge = HalfEdgeMesh::Next(this->Mesh.Twins[HalfEdgeMesh::Next(edge)]);
    return false;
  }

  /// Half-edge from the centre along the way, NoId where the way crosses CrossedEdge.
  Id AlongEdge = NoId;
  /// Half-edge opposite the centre that the way crosses.
  Id CrossedEdge = NoId;

private:
  bool IsAlong(Id vertex) const
  {
    if (vertex == this->Target)
    {
      return true;
    }
    return this->Side(vertex) == 0 &&
      IsForward(this->Mesh.PointAt(this->Center), this->Mesh.PointAt(this->Target),
        this->Mesh.PointAt(vertex));
  }

  int Side(Id vertex) const
  {
    return Orient2D(this->Mesh.PointAt(this->Center), this->Mesh.PointAt(this->Target),
      this->Mesh.PointAt(vertex));
  }

  const HalfEdgeMesh& Mesh;
  Id Center;
  Id Target;
  Id Edge; ///< half-edge opposite the centre in the next triangle
};

/// 0 .. count - 1 in the order of their reversed digits to the base 2: each falls into one of the
/// largest gaps between those before, as numbers of neighbors in a drawing are near each other.
class ScatteredNumbers
{
public:
  explicit ScatteredNumbers(Id count)
    : Count(count)
  {
    while (this->HighestDigit < count - count / 2)
    {
      this->HighestDigit *= 2;
    }
  }

  /// The first is 0, and so is the one that follows the last.
  Id Next()
  {
    const Id number = this->Number;
    do
    {
      this->Advance();
    } while (this->Number >= this->Count);
    return number;
  }

private:
  /// Adds one at the highest digit and carries to the lower ones.
  void Advance()
  {
    Id digit = this->HighestDigit;
    while ((this->Number & digit) != 0)
    {
      this->Number ^= digit;
      digit /= 2;
    }
    this->Number |= digit;
  }

  Id Count;
  Id HighestDigit = 1;
  Id Number = 0;
};

class Recovery
{
public:
  Recovery(HalfEdgeMesh& mesh, double phi, Pulse& pulse)
    : Mesh(mesh)
    , Phi(phi)
    , Beats(pulse)
  {
    this->PrepareMesh();
  }

  void Run(const ConstraintEdges& constraints);

  RecoveryResult Result;

private:
  void PrepareMesh();
  void CompareUnmade(const ConstraintEdges& constraints);
  void Recover(const ConstraintEdges& constraints, Id constraint);
  StarSearch FindWay();
  Id Cross(Id crossedEdge);
  Id CollectCavity(Id crossedEdge);
  void NoteConflict(Id edge);
  bool HasRoom() const { return this->Result.Conflicts.size() < MaximumNumberOfPairs; }
  void MarkEdge(Id edge);
  ConstraintConflict PairWith(Id mark) const;

  HalfEdgeMesh& Mesh;
  double Phi;
  Pulse& Beats;
  std::vector<Id> Stack;
  Cavity Crossed;
  std::vector<Id> Unmade; ///< constraints that others are in the way of

  // The constraint at work; what is left of it leads from From to To.
  Id Constraint = NoId;
  bool IsBoundary = false;
  Id From = NoId;
  Id To = NoId;
};

void Recovery::PrepareMesh()
{
  const PulsePart part(this->Beats, 0.0, PreparationEnd);
  this->Mesh.VertexEdges.reserve(this->Mesh.Points.capacity());
  this->Mesh.VertexEdges.resize(this->Mesh.Points.size(), NoId);
  this->Beats.ForEach(HalfEdgeMesh::FirstEdge(this->Mesh.NumberOfTriangles),
    [this](std::size_t edge)
    {
      const bool isCorner = (edge & 3) != 3 && this->Mesh.Corners[edge] != NoId;
      if (isCorner)
      {
        this->Mesh.VertexEdges[this->Mesh.Corners[edge]] = static_cast<Id>(edge);
      }
    });
}

/// In scattered order.
void Recovery::Run(const ConstraintEdges& constraints)
{
  const PulsePart part(this->Beats, PreparationEnd, 1.0);
  const Id count = static_cast<Id>(constraints.Starts.size());
  ScatteredNumbers numbers(count);
  for (Id done = 0; done < count && this->HasRoom() && this->Beats.Beat(); ++done)
  {
    this->Beats.SetFraction(static_cast<double>(done) / count);
    const std::size_t conflictsBefore = this->Result.Conflicts.size();
    const Id constraint = numbers.Next();
    this->Recover(constraints, constraint);
    if (this->Result.Conflicts.size() > conflictsBefore)
    {
      this->Unmade.push_back(constraint);
    }
  }
  if (!this->Unmade.empty() && this->HasRoom())
  {
    this->CompareUnmade(constraints);
  }
  this->Result.Conflicts.resize(std::min(this->Result.Conflicts.size(), MaximumNumberOfPairs));
}

/// Once more, with all that are made: some of these came later.
void Recovery::CompareUnmade(const ConstraintEdges& constraints)
{
  this->Result.Conflicts.clear();
  for (const Id constraint : this->Unmade)
  {
    if (this->HasRoom() && this->Beats.Beat())
    {
      this->Recover(constraints, constraint);
    }
  }
}

void Recovery::Recover(const ConstraintEdges& constraints, Id constraint)
{
  this->Constraint = constraint;
  this->IsBoundary = constraints.IsBoundary[constraint] != 0;
  this->From = constraints.Starts[constraint];
  this->To = constraints.Ends[constraint];
  while (this->From != this->To && !this->Beats.HasStopped())
  {
    const StarSearch way = this->FindWay();
    if (way.AlongEdge == NoId && way.CrossedEdge == NoId)
    {
      return;
    }
    if (way.AlongEdge != NoId)
    {
      this->MarkEdge(way.AlongEdge);
      this->From = this->Mesh.Target(way.AlongEdge);
    }
    else
    {
      this->From = this->Cross(way.CrossedEdge);
    }
  }
}

/// Searches around both ends by turns; From becomes the end where the way was found first. On abort
/// there is no way.
StarSearch Recovery::FindWay()
{
  StarSearch forward(this->Mesh, this->From, this->To);
  StarSearch backward(this->Mesh, this->To, this->From);
  while (true)
  {
    if (forward.Step() || !this->Beats.Beat())
    {
      return forward;
    }
    if (backward.Step())
    {
      std::swap(this->From, this->To);
      return backward;
    }
  }
}

/// Makes an edge up to the first vertex on the way, and returns that vertex.
Id Recovery::Cross(Id crossedEdge)
{
  const std::size_t conflictsBefore = this->Result.Conflicts.size();
  const Id vertex = this->CollectCavity(crossedEdge);
  if (this->Result.Conflicts.size() == conflictsBefore && !this->Beats.HasStopped())
  {
    this->MarkEdge(FillCavity(this->Mesh, this->Crossed, this->Stack));
    RestoreDelaunay(this->Mesh, this->Phi, this->Stack, this->Beats);
  }
  return vertex;
}

/// Walks along the way from the triangle left of `edge`, which it crosses, to the next vertex on
/// it.
Id Recovery::CollectCavity(Id edge)
{
  const HalfEdgeMesh& mesh = this->Mesh;
  Cavity& cavity = this->Crossed;
  cavity.Clear();
  cavity.Triangles.push_back(HalfEdgeMesh::TriangleOf(edge));
  cavity.Left.Vertices.push_back(this->From);
  cavity.Left.Add(mesh.Target(edge), HalfEdgeMesh::Next(edge));
  cavity.Right.Vertices.push_back(this->From);
  cavity.Right.Add(mesh.Origin(edge), HalfEdgeMesh::Previous(edge));
  Id vertex = NoId;
  int side = 1;
  while (side != 0 && this->Beats.Beat())
  {
    this->NoteConflict(edge);
    const Id twin = mesh.Twins[edge];
    vertex = mesh.Corners[twin];
    side = Orient2D(mesh.PointAt(this->From), mesh.PointAt(this->To), mesh.PointAt(vertex));
    cavity.Triangles.push_back(HalfEdgeMesh::TriangleOf(twin));
    if (side >= 0)
    {
      cavity.Left.Add(vertex, HalfEdgeMesh::Previous(twin));
    }
    if (side <= 0)
    {
      cavity.Right.Add(vertex, HalfEdgeMesh::Next(twin));
    }
    edge = side > 0 ? HalfEdgeMesh::Next(twin) : HalfEdgeMesh::Previous(twin);
  }
  std::reverse(cavity.Right.Vertices.begin(), cavity.Right.Vertices.end());
  std::reverse(cavity.Right.Edges.begin(), cavity.Right.Edges.end());
  return vertex;
}

void Recovery::NoteConflict(Id edge)
{
  if (this->Mesh.Mark(edge) != NoId)
  {
    this->Result.Conflicts.push_back(this->PairWith(this->Mesh.Mark(edge)));
  }
}

void Recovery::MarkEdge(Id edge)
{
  const Id oddity = this->IsBoundary ? 1 : 0;
  const Id old = this->Mesh.Mark(edge);
  Id mark = 2 * this->Constraint + oddity;
  if (old != NoId)
  {
    const ConstraintConflict pair = this->PairWith(old);
    if (pair.First != pair.Second && this->Result.Coincidences.size() < MaximumNumberOfPairs)
    {
      this->Result.Coincidences.push_back(pair);
    }
    mark = 2 * pair.First + ((old ^ oddity) & 1);
  }
  this->Mesh.SetMark(edge, mark);
  this->Mesh.SetMark(this->Mesh.Twins[edge], mark);
}

ConstraintConflict Recovery::PairWith(Id mark) const
{
  const Id other = mark / 2;
  return { std::min(other, this->Constraint), std::max(other, this->Constraint) };
}

} // namespace

RecoveryResult RecoverConstraints(
  HalfEdgeMesh& mesh, const ConstraintEdges& constraints, double phi, Pulse& pulse)
{
  Recovery recovery(mesh, phi, pulse);
  recovery.Run(constraints);
  return std::move(recovery.Result);
}

} // namespace biting
