// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingArrangement_h
#define BitingArrangement_h

#include "../Base/DisjointSets.h"
#include "../Base/Ids.h"
#include "../Base/Point.h"
#include "../Base/Problem.h"
#include "../Base/Pulse.h"
#include "Domain.h"      // for DomainOptions
#include "SegmentTree.h" // for SegmentEnds

#include <array>   // for runs
#include <cstddef> // for size_t
#include <utility> // for pair
#include <vector>  // for the arrays

namespace biting
{

/// What faces have to do with an edge of the arrangement. A face that runs along it there and back
/// has no area there, and nothing to do with it.
struct FaceEdge
{
  Id Count = 0; ///< how often outlines of faces run along it

  /// How many of the faces lie on its left, less those on its right. Those that are thinner than
  /// rounding lie on neither.
  Id Turn = 0;

  /// The chains of these faces, those on the right as OtherSide of it; NoId after the last. More
  /// than three only where faces overlap: the ordinary edge allocates nothing.
  std::array<Id, 3> Runs{ NoId, NoId, NoId };
  std::vector<Id> MoreRuns;

  bool Stays = false; ///< as an interface, as all edges of faces are to

  static Id OtherSide(Id run) { return -2 - run; }
  static Id FaceOf(Id run) { return run < NoId ? OtherSide(run) : run; }
  Id First() const { return FaceOf(this->Runs[0]); }
  Id Second() const { return FaceOf(this->Runs[1]); }

  /// The faces that run along it an odd number of times. By parity the others are on both of its
  /// sides, or on none.
  std::vector<Id> OddFaces() const;

  /// The same, if these are two: NoId twice otherwise.
  std::pair<Id, Id> OddPair() const;

  /// Adds a run; one that goes the other way goes with it.
  void AddRun(Id run);

  /// Adds the runs of `other`, which is directed the other way where `isReversed`.
  void Absorb(const FaceEdge& other, bool isReversed);

private:
  Id RunAt(Id k) const;
  Id& RunAt(Id k);
};

/// An edge of the arrangement, whatever the directions of the chains that run along it.
struct ArrangementEdge
{
  SegmentEnds Ends;
  Id Cell = NoId;           ///< the first of the lines', where there are none of the faces'
  Id BoundaryCount = 0;     ///< how often boundary chains run along it: by kind, or closed ones
  Id OpenCount = 0;         ///< how often open chains of automatic kind do
  bool IsInterface = false; ///< whether an interface chain does
  bool IsNew = true;        ///< not yet tested against the others
  FaceEdge Faces;

  bool HasLine() const { return this->BoundaryCount + this->OpenCount > 0 || this->IsInterface; }
};

/// Makes `kept` stand for `other` too, which has the same ends in any order.
void Absorb(ArrangementEdge& kept, const ArrangementEdge& other);

/// What the input draws: distinct vertices and edges. Neither depends on the order of the input's
/// points and chains, nor on directions.
struct Arrangement
{
  std::vector<Point2> Vertices;
  std::vector<Id> VertexPoints; ///< first input point at each vertex; NoId where a crossing made it
  std::vector<ArrangementEdge> Edges;
  std::vector<Id> EmbeddedVertices; ///< vertices of embedded points, ascending, each once
  double Rounding = 0.0;            ///< of a vertex: 4 ulp of the largest magnitude
  double Resolution = 0.0;          ///< what is not further apart is one; at least Rounding
  Point2 Stretch{ 1.0, 1.0 };       ///< by which differences along x and y count, for Resolution
  bool KeepsSpikes = true;          ///< thinner than Resolution, between edges that share a tip
  double FaceArea = 0.0;            ///< sum over all faces
  DisjointSets Groups;              ///< of chains: faces whose common edges were dropped
  std::vector<Id> Regions;          ///< of chains; empty: all are of one region

  const Point2& At(Id vertex) const { return this->Vertices[vertex]; }
  const ArrangementEdge& Edge(Id id) const { return this->Edges[id]; }
  std::vector<SegmentEnds> EdgeEnds() const;

  /// A place at `offset` from the line along `span` is on it where Cross(span, offset) is no more.
  double ReachAcross(const Point2& span) const
  {
    return this->Resolution * Length(Point2{ this->Stretch.X * span.X, this->Stretch.Y * span.Y }) /
      (this->Stretch.X * this->Stretch.Y);
  }

  /// Whether faces of two regions meet at the edge.
  bool DividesRegions(const ArrangementEdge& edge) const;

  /// Whether it is an edge between faces that is none of the drawing.
  bool IsNothing(const ArrangementEdge& edge) const;
};

/// Splits and merges edges until they meet at common ends only.
///
/// Each round finds all pairs of edges that meet elsewhere, and all vertices on edges or so close
/// that they count as on them (Resolution), then splits the edges there and merges those that have
/// become equal, adding their counts. A vertex that was close bends the edge towards it; vertices
/// never move. A crossing within Resolution of a vertex becomes that vertex. Both replace an edge
/// by a path with the same ends, so the parity of closed chains is kept. The last round tests every
/// pair and finds nothing.
///
/// The sides of a spike are not welded where Resolution is no more than twice Rounding, or its tip
/// would be lost. Where something else ends at the tip it would not be: lines, or faces, that run
/// side by side from there are one but for rounding. But many edges within Resolution of each
/// other, which rounded crossings have cut and bent, may make new ones without end: after some
/// rounds these are welded too.
///
/// Edges between two faces that are none of the drawing are dropped wherever equal edges are
/// merged: of a triangulation only the outline takes part. That faces share edges, or parts of
/// edges, is no news.
///
/// A round tests what is new; where that is half of all or more, it tests all.
///
/// What the first round finds is reported. False where the input is refused, cannot be resolved, or
/// the monitor has asked to stop: `problems` then has the reason.
/// Cost O((n + k) log n) a round, for k pairs whose boxes meet; nearly always 1 to 4 rounds.
bool ResolveArrangement(
  Arrangement& arrangement, const DomainOptions& options, ProblemList& problems, Pulse& pulse);

} // namespace biting

#endif
