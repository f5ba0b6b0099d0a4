// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingSurfaceGround_h
#define BitingSurfaceGround_h

#include "../../Base/IdLists.h"
#include "../../Base/Pulse.h"
#include "../Surface/SurfaceCheck.h"

#include <array>      // for sides
#include <cstdint>    // for flags
#include <functional> // for f
#include <vector>     // for the arrays

namespace biting
{

/// Of each of `count` owners the places of `owners` that name it; in `step`s, the numbers of these.
IdLists PlacesByOwner(const std::vector<Id>& owners, std::size_t count, std::size_t step = 1);

/// Chains of feature edges between corners, or closed.
struct FeatureChains
{
  std::vector<Id> Vertices; ///< chain after chain; a closed one has its first vertex last, too
  std::vector<Id> Offsets{ 0 };
  std::vector<SurfaceEdgeKind> Kinds;

  Id Size() const { return static_cast<Id>(this->Kinds.size()); }
  Id Begin(Id chain) const { return this->Offsets[static_cast<std::size_t>(chain)]; }
  Id End(Id chain) const { return this->Offsets[static_cast<std::size_t>(chain) + 1]; }
  Id At(Id place) const { return this->Vertices[static_cast<std::size_t>(place)]; }
};

/// What an edge of the ground is: 0 none, else 1 + SurfaceEdgeKind.
using EdgeFlag = std::uint8_t;

/// The place of a vertex of the ground among features.
enum class FeaturePlace : std::uint8_t
{
  None = 0,
  Line = 1,
  Corner = 2
};

/// The labels of space behind a triangle and in front of it, where its normal goes; 0: outside.
using TriangleSides = std::array<Id, 2>;

/// A surface as it is bitten: its triangles divided until no edge is longer than LongestEdge f, so
/// that each bite and each place meets a handful of them; the patches that feature lines bound; f
/// at the vertices, linear between. Vertices lie on the input's triangles, to rounding.
struct SurfaceGround
{
  SurfaceMesh Mesh;                 ///< Cells: the triangle of the input that each is a part of
  std::vector<EdgeFlag> Flags;      ///< of slots
  std::vector<Id> Across;           ///< of slots: the slot in the same patch; NoId at feature edges
  std::vector<double> Given;        ///< f at vertices as given
  std::vector<double> Sizes;        ///< f at vertices as used: no more than that
  std::vector<Point3> Normals;      ///< unit, of the triangles of the input
  std::vector<TriangleSides> Sides; ///< of these; empty where the surface bounds nothing
  std::vector<FeaturePlace> Places;
  std::vector<Id> Pinches; ///< vertices where several fans of triangles meet: corners
  FeatureChains Chains;
  std::vector<Id> Vanished; ///< vertices where fins, or holes, are too small to have chains
  IdLists TrianglesAt;      ///< of vertices

  const Point3& NormalOf(std::size_t triangle) const
  {
    return this->Normals[At(this->Mesh.Cells[triangle])];
  }

  bool IsCorner(Id vertex) const { return this->Places[At(vertex)] == FeaturePlace::Corner; }

  double LengthOf(Id chain) const;
  double LengthOf(const std::vector<Id>& path) const; ///< from vertex to vertex

  /// f at a point of the triangle.
  double SizeAt(Id triangle, const Point3& place) const;
};

/// The longest edges of the ground, in units of f at their ends.
constexpr double LongestEdge = 1.2;

/// Divides all edges longer than LongestEdge f: in halves, round by round, all long ones at once.
/// f at new vertices is as `given`, but where an end is capped no more than the mean of both. False
/// where there would be more triangles than `mostTriangles`.
bool DivideGround(SurfaceGround& ground, const std::function<double(const Point3&)>& given,
  std::size_t mostTriangles, Pulse& pulse);

/// Sets Across and TrianglesAt.
void LinkGround(SurfaceGround& ground, Pulse& pulse);

} // namespace biting

#endif
