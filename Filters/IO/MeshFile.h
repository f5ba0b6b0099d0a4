// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingMeshFile_h
#define BitingMeshFile_h

#include <array>   // for places and ids
#include <cstdint> // for ids
#include <istream> // for files
#include <limits>  // for digits of numbers
#include <ostream> // for files
#include <string>  // for names
#include <vector>  // for lists

/**
 * Meshes of triangles or tetrahedra in the formats of solvers. No VTK, but its NetCDF library for
 * UGRID: plain lists in, files out. Numbers are written so that reading gives them back bit for
 * bit. Ids begin with 0 in lists, in SU2 and in UGRID, with 1 in Gmsh, ADCIRC and SMS.
 */
namespace biting
{

/// As many digits as give a number back when it is read.
constexpr int DigitsOfDouble = std::numeric_limits<double>::max_digits10;

/// What a set of cells or sides is called in a file.
struct MeshGroup
{
  std::int64_t Number = 0; // above 0, different for groups of one dimension
  std::string Name;
};

/// Cells are tetrahedra, and sides triangles; where there are no tetrahedra, cells are triangles,
/// and sides edges.
struct MeshFile
{
  using Vertex = std::int64_t;

  std::vector<std::array<double, 3>> Points;
  std::vector<double> Depths; // one a point, or empty: all 0
  std::vector<std::array<Vertex, 4>> Tetrahedra;
  std::vector<std::array<Vertex, 3>> Triangles;
  std::vector<std::array<Vertex, 2>> Edges;
  std::vector<std::size_t> RegionOfCell; // index into Regions
  std::vector<MeshGroup> Regions;
  std::vector<std::size_t> TagOfSide; // index into Tags; sides are on boundary and interfaces
  std::vector<MeshGroup> Tags;
  bool AreDegrees = false; // x and y: longitude and latitude

  bool IsSolid() const { return !this->Tetrahedra.empty(); }

  std::size_t NumberOfCells() const
  {
    return this->IsSolid() ? this->Tetrahedra.size() : this->Triangles.size();
  }
};

/// Returns use(sides, cells), the lists of `mesh`.
template <typename Use>
auto WithCells(const MeshFile& mesh, Use use)
{
  return mesh.IsSolid() ? use(mesh.Triangles, mesh.Tetrahedra) : use(mesh.Edges, mesh.Triangles);
}

/// 2 of triangles, 3 of tetrahedra.
template <std::size_t Corners>
constexpr int DimensionOf(const std::vector<std::array<MeshFile::Vertex, Corners>>& /*cells*/)
{
  return static_cast<int>(Corners) - 1;
}

/// The number of sides that no cell has, as those of another mesh with the same vertices.
std::size_t CountSidesOfNoCell(const MeshFile& mesh);

/// Turns triangles that are clockwise in x and y, as the formats of the plane want them.
void OrientUpwards(MeshFile& mesh);

/// Turns tetrahedra of negative volume. Returns the first of volume 0, else their number.
std::size_t OrientTetrahedra(MeshFile& mesh);

/// Whether each side has at most one cell on its left: then the boundary is closed.
bool IsBoundaryClosed(const MeshFile& mesh);

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

/// Which of the tags an edge of the boundary has and `names` lists, with blanks or commas between:
/// where several tags begin alike, the longest that is there. A flag a tag.
/// Returns the first word that is no such tag; empty where all are.
std::string FindOpenTags(
  const MeshFile& mesh, const std::string& names, std::vector<bool>& areOpen);

/// Gmsh 4.1, ASCII: regions and tags as physical groups of cells and sides.
void WriteGmsh(const MeshFile& mesh, std::ostream& file);

/// SU2: x, y and, of tetrahedra, z; the tags of the boundary as markers, the cells on their left.
/// Interfaces and regions are left out: the format has no place for them. Expects IsBoundaryClosed.
void WriteSU2(const MeshFile& mesh, std::ostream& file);

/// ADCIRC grid (fort.14): x, y and depth; boundary with one of the tags that are open as open, the
/// rest as land: islands (type 1) around holes of land only, else mainland (type 0). A loop that is
/// all open is two open boundaries, since none may be a loop. Expects IsBoundaryClosed.
void WriteADCIRC(const MeshFile& mesh, const std::vector<bool>& areOpen, std::ostream& file);

/// SMS (2dm): x, y and, as z, the depth with the other sign; regions as materials, tags as node
/// strings with their numbers, along interfaces, too. Names of tags are left out.
void WriteSMS(const MeshFile& mesh, std::ostream& file);

/// UGRID 1.0 (NetCDF with 64-bit offsets): all sides of triangles as edges, with their tags, 0 for
/// none; edges of one triangle as boundary; regions of faces; depths, where there are any. Names
/// are the meanings of flags, with '_' for blanks. The stream fails where there are no triangles.
void WriteUGRID(const MeshFile& mesh, std::ostream& file);

/// What came of reading a file.
///
/// Files made by any program are read. Vertices keep the order that they have there, whatever their
/// numbers. Quads become two triangles each (Quality/QuadDiagonal.h). Of cells of order 2 the
/// corners are read, and vertices that are no corner of another cell are left out. A cell that is
/// listed once for each of its groups is read once, in the first of them. Edges beside tetrahedra
/// are left out.
struct ReadingResult
{
  std::string Reason;               // why there is no mesh, with the line; empty where there is one
  std::vector<std::string> Remarks; // sentences: what of the file the mesh does not have
};

/// Gmsh 2.2 and 4.1, ASCII. Groups are the physical groups; where the file has none, the curves,
/// surfaces and volumes themselves, without names.
ReadingResult ReadGmsh(std::istream& file, MeshFile& mesh);

/// SU2: markers as tags. Markers keep the numbers that they are called by if all
/// are whole numbers from 1 to 2147483647, else they are numbered from 1 on.
ReadingResult ReadSU2(std::istream& file, MeshFile& mesh);

/// ADCIRC grid (fort.14): depths; tag 1 for open boundaries, 2 and the type added for land: 2
/// mainland, 3 island and so on. Both sides of weirs with pairs of nodes have the tag of their
/// type.
ReadingResult ReadADCIRC(std::istream& file, MeshFile& mesh);

/// SMS (2dm): materials as regions, with their names; node strings as tags, by their numbers, else
/// numbered in their order; z with the other sign as depth. Elements of order 2 are no mesh.
ReadingResult ReadSMS(std::istream& file, MeshFile& mesh);

} // namespace biting

#endif
