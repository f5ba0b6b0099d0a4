// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "MeshFileBuilder.h"

#include "../Kernel/Quality/QuadDiagonal.h"

#include <algorithm> // for any_of, copy, count, find_if, sort

namespace biting
{

namespace
{

constexpr std::size_t MostGroupsShown = 5;

std::string InLine(std::size_t line)
{
  return "Line " + std::to_string(line) + ": ";
}

// "3 cells are", "1 cell is", and the like.
std::string Count(std::size_t count, const std::string& what)
{
  return std::to_string(count) + " " + what + (count == 1 ? " is " : "s are ");
}

} // namespace

MeshFileBuilder::MeshFileBuilder(MeshFileLines& lines, MeshFile& mesh)
  : In(lines)
  , Mesh(mesh)
{
}

bool MeshFileBuilder::Fail(const std::string& what)
{
  this->Result.Reason = this->In.Expected(what);
  return false;
}

void MeshFileBuilder::Remark(const std::string& sentence)
{
  this->Result.Remarks.push_back(sentence);
}

bool MeshFileBuilder::AddVertex(std::int64_t number, const std::array<double, 3>& place)
{
  const auto vertex = static_cast<MeshFile::Vertex>(this->Mesh.Points.size());
  if (!this->Vertices.emplace(number, vertex).second)
  {
    return this->Fail("a vertex with a number of its own");
  }
  this->Mesh.Points.push_back(place);
  return true;
}

bool MeshFileBuilder::AddEdge(const std::array<std::int64_t, 2>& ends, const Group& group)
{
  Cell edge;
  edge.Corners = { ends[0], ends[1], -1, -1 };
  edge.Size = 2;
  return this->Add(edge, group);
}

bool MeshFileBuilder::ReadCell(const MeshFileCell& kind, const Group& group)
{
  this->PassedOver += kind.Corners == 0 ? 1 : 0;
  Cell cell;
  cell.Size = kind.Corners;
  cell.IsOfOrderTwo = kind.Vertices > kind.Corners;
  for (std::size_t k = 0; k < kind.Vertices; ++k)
  {
    std::int64_t vertex = 0;
    if (!this->In.More(vertex))
    {
      return this->Fail("the vertices of a cell");
    }
    if (k < kind.Corners)
    {
      cell.Corners[k] = vertex;
    }
    else
    {
      this->Middles.emplace_back(vertex, this->In.LineNumber());
    }
  }
  return kind.Corners < 2 || this->Add(cell, group);
}

// A quad with one corner at both ends of a side is a triangle.
bool MeshFileBuilder::Add(Cell& cell, const Group& group)
{
  auto& corners = cell.Corners;
  for (std::size_t k = 0; k < 4 && cell.Size == 4; ++k)
  {
    if (corners[k] == corners[(k + 1) % 4])
    {
      std::copy(&corners[k] + 1, corners.data() + 4, &corners[k]);
      corners[3] = -1;
      cell.Size = 3;
    }
  }
  for (std::size_t k = 1; k < cell.Size; ++k)
  {
    if (std::count(corners.data(), &corners[k], corners[k]) > 0)
    {
      return this->Fail("a cell with corners that differ");
    }
  }
  Groups& groups = this->GroupsOf(cell.Dimension());
  cell.Group = groups.emplace(group, groups.size()).first->second;
  cell.GroupNumber = group.first;
  cell.Line = this->In.LineNumber();
  this->Cells.push_back(cell);
  return true;
}

void MeshFileBuilder::LeaveOut(int dimension, std::int64_t group, std::size_t cells)
{
  this->OtherGroups[{ dimension, group }] += cells;
}

ReadingResult MeshFileBuilder::Finish(const NameOf& nameOf)
{
  if (this->Result.Reason.empty() && this->FindVertices())
  {
    this->PassRepeatedCells();
    if (this->AddCells())
    {
      this->RemoveMiddles();
      this->AddRemarks(nameOf);
      this->MakeGroups(2, nameOf, this->Mesh.RegionOfTriangle, this->Mesh.Regions);
      this->MakeGroups(1, nameOf, this->Mesh.TagOfEdge, this->Mesh.Tags);
    }
  }
  return this->Result;
}

bool MeshFileBuilder::FindVertices()
{
  bool areFound = true;
  for (auto cell = this->Cells.begin(); areFound && cell != this->Cells.end(); ++cell)
  {
    for (std::size_t k = 0; areFound && k < cell->Size; ++k)
    {
      areFound = this->FindVertex(cell->Line, cell->Corners[k]);
    }
  }
  for (auto middle = this->Middles.begin(); areFound && middle != this->Middles.end(); ++middle)
  {
    areFound = this->FindVertex(middle->second, middle->first);
  }
  return areFound;
}

bool MeshFileBuilder::FindVertex(std::size_t line, std::int64_t& number)
{
  const auto found = this->Vertices.find(number);
  if (found == this->Vertices.end())
  {
    this->Result.Reason = InLine(line) + "a cell names vertex " + std::to_string(number) +
      ", which the file does not have.";
    return false;
  }
  number = found->second;
  return true;
}

// Of cells with the same vertices one stays.
void MeshFileBuilder::PassRepeatedCells()
{
  std::vector<std::pair<std::array<std::int64_t, 4>, std::size_t>> keys;
  keys.reserve(this->Cells.size());
  for (const Cell& cell : this->Cells)
  {
    keys.emplace_back(cell.Corners, keys.size());
    std::sort(keys.back().first.begin(), keys.back().first.end());
  }
  std::sort(keys.begin(), keys.end());
  std::vector<bool> isPassed(keys.size(), false);
  std::vector<std::size_t> repeated;
  for (std::size_t k = 0; k < keys.size();)
  {
    repeated.clear();
    const auto& corners = keys[k].first;
    for (; k < keys.size() && keys[k].first == corners; ++k)
    {
      repeated.push_back(keys[k].second);
    }
    this->Choose(repeated, isPassed);
  }
  std::size_t kept = 0;
  for (std::size_t k = 0; k < this->Cells.size(); ++k)
  {
    this->Cells[kept] = this->Cells[k];
    kept += isPassed[k] ? 0 : 1;
  }
  this->Cells.resize(kept);
}

// The first of the cells that have a group stays, else the first.
void MeshFileBuilder::Choose(const std::vector<std::size_t>& repeated, std::vector<bool>& isPassed)
{
  if (repeated.size() == 1)
  {
    return;
  }
  const int dimension = this->Cells[repeated.front()].Dimension();
  const auto chosen = std::find_if(repeated.begin(), repeated.end(),
    [this](std::size_t cell) { return this->Cells[cell].GroupNumber != 0; });
  const std::size_t kept = chosen == repeated.end() ? repeated.front() : *chosen;
  for (const std::size_t cell : repeated)
  {
    const std::int64_t number = this->Cells[cell].GroupNumber;
    isPassed[cell] = cell != kept;
    if (cell != kept && number != 0 && number != this->Cells[kept].GroupNumber)
    {
      this->LeaveOut(dimension, number, 1);
    }
    else if (cell != kept)
    {
      ++this->Repeated;
    }
  }
}

bool MeshFileBuilder::AddCells()
{
  bool areAdded = true;
  for (const Cell& cell : this->Cells)
  {
    const auto& corners = cell.Corners;
    this->OfOrderTwo += cell.IsOfOrderTwo ? 1 : 0;
    if (cell.Size == 2)
    {
      this->Mesh.Edges.push_back({ corners[0], corners[1] });
      this->Mesh.TagOfEdge.push_back(cell.Group);
    }
    else if (cell.Size == 3)
    {
      this->Mesh.Triangles.push_back({ corners[0], corners[1], corners[2] });
      this->Mesh.RegionOfTriangle.push_back(cell.Group);
    }
    else
    {
      areAdded = areAdded && this->AddQuad(cell);
    }
  }
  if (areAdded && this->Mesh.Triangles.empty())
  {
    this->Result.Reason = "The file has no triangles.";
  }
  return this->Result.Reason.empty();
}

bool MeshFileBuilder::AddQuad(const Cell& cell)
{
  std::array<std::array<double, 3>, 4> places{};
  for (std::size_t k = 0; k < 4; ++k)
  {
    places[k] = this->Mesh.Points[static_cast<std::size_t>(cell.Corners[k])];
  }
  const QuadDiagonal diagonal = FindQuadDiagonal(places);
  if (diagonal == QuadDiagonal::None)
  {
    this->Result.Reason =
      InLine(cell.Line) + "the sides of a quad cross each other, or it has no area.";
    return false;
  }
  for (const auto& triangle : TrianglesOfQuad(diagonal))
  {
    this->Mesh.Triangles.push_back(
      { cell.Corners[triangle[0]], cell.Corners[triangle[1]], cell.Corners[triangle[2]] });
    this->Mesh.RegionOfTriangle.push_back(cell.Group);
  }
  ++this->Quads;
  return true;
}

// Removes the vertices of cells of order 2 that are no corner of any cell.
void MeshFileBuilder::RemoveMiddles()
{
  if (this->Middles.empty())
  {
    return;
  }
  std::vector<bool> isMiddle(this->Mesh.Points.size(), false);
  for (const auto& middle : this->Middles)
  {
    isMiddle[static_cast<std::size_t>(middle.first)] = true;
  }
  for (const Cell& cell : this->Cells)
  {
    for (std::size_t k = 0; k < cell.Size; ++k)
    {
      isMiddle[static_cast<std::size_t>(cell.Corners[k])] = false;
    }
  }
  std::vector<MeshFile::Vertex> numbers;
  MeshFile::Vertex kept = 0;
  for (std::size_t vertex = 0; vertex < isMiddle.size(); ++vertex)
  {
    numbers.push_back(kept);
    this->Mesh.Points[static_cast<std::size_t>(kept)] = this->Mesh.Points[vertex];
    kept += isMiddle[vertex] ? 0 : 1;
  }
  this->Mesh.Points.resize(static_cast<std::size_t>(kept));
  const auto renumber = [&numbers](auto& cells)
  {
    for (auto& cell : cells)
    {
      for (MeshFile::Vertex& corner : cell)
      {
        corner = numbers[static_cast<std::size_t>(corner)];
      }
    }
  };
  renumber(this->Mesh.Triangles);
  renumber(this->Mesh.Edges);
}

// Gives the cells of a dimension the indices of groups that differ in number.
void MeshFileBuilder::MakeGroups(int dimension, const NameOf& nameOf,
  std::vector<std::size_t>& ofCells, std::vector<MeshGroup>& groups)
{
  const Groups& found = this->GroupsOf(dimension);
  const bool haveNumbers = std::any_of(
    found.begin(), found.end(), [](const auto& entry) { return entry.first.first > 0; });
  std::map<std::int64_t, std::size_t> byNumber;
  std::vector<std::size_t> indices(found.size());
  for (const auto& entry : found)
  {
    const std::int64_t number = haveNumbers ? entry.first.first : entry.first.second;
    const auto added = byNumber.emplace(number, groups.size());
    indices[entry.second] = added.first->second;
    if (added.second)
    {
      groups.push_back({ number, haveNumbers ? nameOf(dimension, number) : std::string() });
    }
  }
  for (std::size_t& group : ofCells)
  {
    group = indices[group];
  }
}

void MeshFileBuilder::AddRemarks(const NameOf& nameOf)
{
  const auto say = [this](std::size_t count, const std::string& what, const std::string& how)
  {
    if (count > 0)
    {
      this->Remark(Count(count, what) + how);
    }
  };
  say(this->PassedOver, "cell", "neither triangle nor quad nor edge, and left out.");
  say(this->Quads, "quad", "divided into two triangles each.");
  say(this->OfOrderTwo, "cell", "of order 2: only the corners are read.");
  say(this->Repeated, "cell", "listed once more, and read once.");
  say(CountEdgesOfNoTriangle(this->Mesh), "edge", "no side of a triangle.");
  std::string text;
  std::size_t shown = 0;
  for (const auto& other : this->OtherGroups)
  {
    const auto [dimension, number] = other.first;
    const std::string name = nameOf(dimension, number);
    if (++shown <= MostGroupsShown)
    {
      text += (text.empty() ? "" : ", ") + std::string(dimension == 1 ? "edges" : "triangles") +
        " in " + (name.empty() ? std::to_string(number) : name) + " (" +
        std::to_string(other.second) + ")";
    }
  }
  if (shown > 0)
  {
    this->Remark("Cells are in more than one group: the first is kept. Left out: " + text +
      (shown > MostGroupsShown ? " and other groups." : "."));
  }
}

} // namespace biting
