// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingMeshFileBuilder_h
#define BitingMeshFileBuilder_h

#include "MeshFileReading.h"

#include <array>      // for corners
#include <cstddef>    // for counts
#include <cstdint>    // for numbers
#include <functional> // for names of groups
#include <istream>    // for files
#include <map>        // for numbers of vertices and groups
#include <sstream>    // for words
#include <string>     // for lines
#include <utility>    // for pair
#include <vector>     // for lists

/** What the readers of mesh files have in common: lines of words, and a mesh by numbers. */
namespace biting
{

/// The lines of a file that are not empty, each as words, up to the sign of a comment.
class MeshFileLines
{
public:
  explicit MeshFileLines(std::istream& file, char comment = '\n');

  /// Goes to the next line; false at the end of the file.
  bool Next();

  /// Passes over a line, empty or not; false at the end of the file.
  bool PassTitle();

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
    return static_cast<bool>((this->Words >> ... >> values));
  }

  /// What stands between the first and the last quotation mark of this line.
  bool Quoted(std::string& text) const;

  /// The words before and after the first equals sign; false where there is none.
  bool Assignment(std::string& key, std::string& value) const;

  /// That something else than this line was expected.
  std::string Expected(const std::string& what) const;

private:
  std::istream& File;
  char Comment;
  std::string Text;
  std::istringstream Words;
  std::size_t Number = 0;
  bool IsAtEnd = false;
};

/// What a cell of a file is for us.
enum class MeshFileCell
{
  Triangle,
  Edge,
  Point,
  Other
};

/// Makes a mesh of vertices that have numbers, and of cells that name these, in any order.
class MeshFileBuilder
{
public:
  /// What a cell says of its group: a number, 0 where it has none; and the curve or surface that
  /// it is part of.
  using Group = std::pair<std::int64_t, std::int64_t>;

  /// The name of a group of edges (dimension 1) or triangles (2).
  using NameOf = std::function<std::string(int dimension, std::int64_t number)>;

  MeshFileBuilder(MeshFileLines& lines, MeshFile& mesh);

  ReadingResult Result;

  /// Says that this line is not what it should be; returns false.
  bool Fail(const std::string& what);

  bool AddVertex(std::int64_t number, const std::array<double, 3>& place);
  void AddEdge(const std::array<std::int64_t, 2>& ends, const Group& group);

  /// Reads the corners that follow in this line; a cell that is no triangle or edge is passed over.
  bool ReadCell(MeshFileCell cell, const Group& group);

  /// Puts vertices in the place of numbers, and joins groups of one number. Where no cell has a
  /// number, curves and surfaces are the groups.
  ReadingResult Finish(const NameOf& nameOf);

private:
  using Groups = std::map<Group, std::size_t>;

  template <std::size_t Size>
  bool ReadCorners(std::vector<std::array<std::int64_t, Size>>& cells);
  template <std::size_t Size>
  bool FindVertices(std::vector<std::array<std::int64_t, Size>>& cells);

  MeshFileLines& In;
  MeshFile& Mesh;
  std::map<std::int64_t, MeshFile::Vertex> Vertices;
  Groups Regions;
  Groups Tags;
};

} // namespace biting

#endif
