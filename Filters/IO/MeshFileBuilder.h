// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingMeshFileBuilder_h
#define BitingMeshFileBuilder_h

#include "MeshFile.h"

#include <array>         // for corners
#include <cstddef>       // for counts
#include <cstdint>       // for numbers
#include <functional>    // for names of groups
#include <istream>       // for files
#include <map>           // for numbers of groups
#include <sstream>       // for numbers
#include <string>        // for words
#include <unordered_map> // for numbers of vertices
#include <utility>       // for pair
#include <vector>        // for lists

namespace biting
{

/// What ends a word of a file, and a line.
enum class MeshFileDialect
{
  Gmsh,   ///< blanks
  SU2,    ///< blanks; the sign of percent begins a comment
  Fortran ///< blanks or one comma; exponents may have a D
};

/// Reads the whole of `word` as a whole number that the type holds; false where it is none.
template <typename Whole>
bool ReadWhole(const std::string& word, Whole& value);

/// Reads `count` things, until one cannot be read; returns whether all were.
template <typename Read>
bool Repeat(std::size_t count, Read read)
{
  bool isRead = true;
  for (std::size_t k = 0; isRead && k < count; ++k)
  {
    isRead = read();
  }
  return isRead;
}

/// The lines of a file that are not empty, each as words. A number is the whole of a word.
class MeshFileLines
{
public:
  MeshFileLines(std::istream& file, MeshFileDialect dialect);

  /// Goes to the next line; false at the end of the file.
  bool Next();

  /// Passes over a line, empty or not; false at the end of the file.
  bool PassTitle();

  /// Whether the last line that was read is a whole one; where not, the file may be cut.
  bool IsWholeLine() const { return this->IsWhole; }

  /// Goes to the next line and reads values from its beginning.
  template <typename... Values>
  bool Read(Values&... values)
  {
    return this->Next() && this->More(values...);
  }

  /// Reads further values of this line.
  template <typename... Values>
  bool More(Values&... values)
  {
    return (this->Take(values) && ...);
  }

  /// Whether this line has no further word.
  bool IsRead() const;

  /// Whether the next word of this line is a number; takes it.
  bool PassNumber();

  /// What stands between the first and the last quotation mark of this line.
  bool Quoted(std::string& text) const;

  /// The words before and after the first equals sign; false where there is none.
  bool Assignment(std::string& key, std::string& value) const;

  std::size_t LineNumber() const { return this->Number; }

  /// That something else than this line was expected.
  std::string Expected(const std::string& what) const;

private:
  bool Take(std::string& word);
  bool Take(double& value);

  template <typename Whole>
  bool Take(Whole& value)
  {
    return this->Take(this->Word) && ReadWhole(this->Word, value);
  }

  std::istream& File;
  MeshFileDialect Dialect;
  std::string Text;
  std::string Word;
  std::size_t Position = 0; // in the text, of the next word
  std::istringstream Real;
  std::size_t Number = 0;
  bool IsAtEnd = false;
  bool IsWhole = true;
};

/// A kind of cell of a file: 2 corners of an edge, 3 of a triangle, 4 of a quad or of a
/// tetrahedron, first among the vertices that are listed. One corner: a point; none: a cell that is
/// passed over.
struct MeshFileCell
{
  std::size_t Corners = 0;
  std::size_t Vertices = 0;
  int Dimension = 0;
};

/// The cell whose type is among `types`: its number, corners, vertices and dimension.
MeshFileCell CellOfType(const std::vector<std::array<int, 4>>& types, int type);

/// Makes a mesh of vertices that have numbers, and of cells that name these, in any order.
class MeshFileBuilder
{
public:
  /// What a cell says of its group: a number, 0 where it has none; and the curve, surface or volume
  /// that it is part of.
  using Group = std::pair<std::int64_t, std::int64_t>;

  /// The name of a group of edges (dimension 1), triangles (2) or tetrahedra (3).
  using NameOf = std::function<std::string(int dimension, std::int64_t number)>;

  MeshFileBuilder(std::istream& file, MeshFileDialect dialect, MeshFile& mesh);

  MeshFileLines In;

  /// Says that this line is not what it should be; returns false.
  bool Fail(const std::string& what);

  /// Says something of the file that the mesh does not have.
  void Remark(const std::string& sentence);

  bool AddVertex(std::int64_t number, const std::array<double, 3>& place);
  bool AddEdge(const std::array<std::int64_t, 2>& ends, const Group& group);

  /// An edge, a triangle or a quad, by its `size` corners.
  bool AddCell(const std::array<std::int64_t, 4>& corners, std::size_t size, const Group& group);

  /// Reads the vertices that follow in this line.
  bool ReadCell(const MeshFileCell& kind, const Group& group);

  /// Notes that cells of a dimension are also in a group that is left out.
  void LeaveOut(int dimension, std::int64_t group, std::size_t cells);

  /// Puts vertices in the place of numbers, reads repeated cells once, divides quads, and joins
  /// groups of one number. Where no cell of a dimension has a number, curves, surfaces or volumes
  /// are the groups.
  ReadingResult Finish(const NameOf& nameOf);

private:
  struct Cell
  {
    std::array<std::int64_t, 4> Corners{ -1, -1, -1, -1 };
    std::size_t Size = 0;
    int Dimension = 0;
    std::size_t Group = 0; // index into those of the dimension
    std::int64_t GroupNumber = 0;
    std::size_t Line = 0;
    bool IsOfOrderTwo = false;
  };
  using Groups = std::map<Group, std::size_t>;

  Groups& GroupsOf(int dimension) { return this->AllGroups[dimension]; }
  bool Add(Cell& cell, const Group& group);
  bool FindVertices();
  bool FindVertex(std::size_t line, std::int64_t& number);
  void PassRepeatedCells();
  bool AddCells();
  bool AddCell(const Cell& cell);
  bool AddQuad(const Cell& cell);
  void RemoveMiddles();
  void MakeGroups(int dimension, const NameOf& nameOf, std::vector<std::size_t>& ofCells,
    std::vector<MeshGroup>& groups);
  void AddRemarks(const NameOf& nameOf);

  MeshFile& Mesh;
  ReadingResult Result;
  std::unordered_map<std::int64_t, MeshFile::Vertex> Vertices; // by number, never in its order
  std::vector<Cell> Cells;
  std::vector<std::pair<std::int64_t, std::size_t>> Middles; // of cells of order 2, with lines
  std::array<Groups, 4> AllGroups;                           // by dimension
  std::map<std::pair<int, std::int64_t>, std::size_t> OtherGroups; // how many cells, by number
  int Dimension = 2;                                               // of the mesh
  std::size_t PassedOver = 0;
  std::size_t EdgesBeside = 0; // tetrahedra
  std::size_t Repeated = 0;
  std::size_t Quads = 0;
  std::size_t OfOrderTwo = 0;
};

} // namespace biting

#endif
