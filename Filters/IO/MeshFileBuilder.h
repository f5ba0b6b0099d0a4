// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingMeshFileBuilder_h
#define BitingMeshFileBuilder_h

#include "MeshFileLines.h"
#include "MeshFileReading.h"

#include <array>         // for corners
#include <cstddef>       // for counts
#include <cstdint>       // for numbers
#include <functional>    // for names of groups
#include <map>           // for numbers of groups
#include <string>        // for sentences
#include <unordered_map> // for numbers of vertices
#include <utility>       // for pair
#include <vector>        // for lists

namespace biting
{

/// A kind of cell of a file: 2 corners of an edge, 3 of a triangle, 4 of a quad, first among the
/// vertices that are listed. One corner: a point; none: a cell that is passed over.
struct MeshFileCell
{
  std::size_t Corners = 0;
  std::size_t Vertices = 0;
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

  /// Says that this line is not what it should be; returns false.
  bool Fail(const std::string& what);

  /// Says something of the file that the mesh does not have.
  void Remark(const std::string& sentence);

  bool AddVertex(std::int64_t number, const std::array<double, 3>& place);
  bool AddEdge(const std::array<std::int64_t, 2>& ends, const Group& group);

  /// Reads the vertices that follow in this line.
  bool ReadCell(const MeshFileCell& kind, const Group& group);

  /// Notes that cells of a dimension are also in a group that is left out.
  void LeaveOut(int dimension, std::int64_t group, std::size_t cells);

  /// Puts vertices in the place of numbers, reads repeated cells once, divides quads, and joins
  /// groups of one number. Where no cell of a dimension has a number, curves or surfaces are the
  /// groups.
  ReadingResult Finish(const NameOf& nameOf);

private:
  struct Cell
  {
    std::array<std::int64_t, 4> Corners{ -1, -1, -1, -1 };
    std::size_t Size = 0;
    std::size_t Group = 0; // index into those of the dimension
    std::int64_t GroupNumber = 0;
    std::size_t Line = 0;
    bool IsOfOrderTwo = false;

    int Dimension() const { return this->Size == 2 ? 1 : 2; }
  };
  using Groups = std::map<Group, std::size_t>;

  Groups& GroupsOf(int dimension) { return this->AllGroups[dimension == 1 ? 0 : 1]; }
  bool Add(Cell& cell, const Group& group);
  bool FindVertices();
  bool FindVertex(std::size_t line, std::int64_t& number);
  void PassRepeatedCells();
  void Choose(const std::vector<std::size_t>& repeated, std::vector<bool>& isPassed);
  bool AddCells();
  bool AddQuad(const Cell& cell);
  void RemoveMiddles();
  void MakeGroups(int dimension, const NameOf& nameOf, std::vector<std::size_t>& ofCells,
    std::vector<MeshGroup>& groups);
  void AddRemarks(const NameOf& nameOf);

  MeshFileLines& In;
  MeshFile& Mesh;
  ReadingResult Result;
  std::unordered_map<std::int64_t, MeshFile::Vertex> Vertices; // by number, never in its order
  std::vector<Cell> Cells;
  std::vector<std::pair<std::int64_t, std::size_t>> Middles; // of cells of order 2, with lines
  std::array<Groups, 2> AllGroups;                           // of edges, of triangles
  std::map<std::pair<int, std::int64_t>, std::size_t> OtherGroups; // how many cells, by number
  std::size_t PassedOver = 0;
  std::size_t Repeated = 0;
  std::size_t Quads = 0;
  std::size_t OfOrderTwo = 0;
};

} // namespace biting

#endif
