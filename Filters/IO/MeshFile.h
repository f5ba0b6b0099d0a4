// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingMeshFile_h
#define BitingMeshFile_h

#include <array>   // for places and ids
#include <cstdint> // for ids
#include <limits>  // for digits of numbers
#include <ostream> // for files
#include <string>  // for names
#include <vector>  // for lists

/**
 * Meshes of triangles in the text formats of solvers. No VTK: plain lists in, text out. Numbers are
 * written so that reading gives them back bit for bit. Ids begin with 0 in lists and in SU2, with 1
 * in Gmsh and ADCIRC.
 */
namespace biting
{

/// As many digits as give a number back when it is read.
constexpr int DigitsOfDouble = std::numeric_limits<double>::max_digits10;

/// Whether a file has a name with this end, by which the format is chosen.
bool EndsWith(const std::string& name, const std::string& end);

/// What a set of edges or triangles is called in a file.
struct MeshGroup
{
  std::int64_t Number = 0; // above 0, different for groups of one dimension
  std::string Name;
};

struct MeshFile
{
  using Vertex = std::int64_t;

  std::vector<std::array<double, 3>> Points;
  std::vector<double> Depths; // one a point, or empty: all 0
  std::vector<std::array<Vertex, 3>> Triangles;
  std::vector<std::size_t> RegionOfTriangle; // index into Regions
  std::vector<MeshGroup> Regions;
  std::vector<std::array<Vertex, 2>> Edges; // on boundary and interfaces
  std::vector<std::size_t> TagOfEdge;       // index into Tags
  std::vector<MeshGroup> Tags;
};

/// Whether each edge is one of the triangles, and not of another mesh with the same vertices.
bool AreEdgesOfTriangles(const MeshFile& mesh);

/// A path along the boundary with one label, the domain on its left; closed where its ends agree.
struct BoundaryPath
{
  std::vector<MeshFile::Vertex> Vertices;
  std::size_t Label = 0;
  bool IsIsland = false; // of a loop around a hole
};

/// The boundary (edges of one triangle) as paths: each goes as far as its label and its loop.
/// `labels` are those of the tags, the last one that of edges without a tag.
std::vector<BoundaryPath> BoundaryPaths(
  const MeshFile& mesh, const std::vector<std::size_t>& labels);

/// Gmsh 4.1, ASCII: regions and tags as physical groups of triangles and edges.
void WriteGmsh(const MeshFile& mesh, std::ostream& file);

/// SU2: x and y; the tags of the boundary as markers. Interfaces and regions are left out: the
/// format has no place for them.
void WriteSU2(const MeshFile& mesh, std::ostream& file);

/// ADCIRC grid (fort.14): x, y and depth; boundary with one of the tags `open` as open, the rest as
/// mainland (type 0) and islands (type 1).
void WriteADCIRC(const MeshFile& mesh, const std::vector<std::string>& open, std::ostream& file);

} // namespace biting

#endif
