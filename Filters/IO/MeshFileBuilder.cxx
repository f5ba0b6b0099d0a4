// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "MeshFileBuilder.h"

#include "../Kernel/Quality/QuadDiagonal.h"

#include <algorithm> // for min, replace_if
#include <charconv>  // for whole numbers
#include <cstdint>   // for whole numbers
#include <locale>    // for numbers with a point

namespace biting
{

namespace
{

constexpr const char* Blanks = " \t\r";
constexpr const char* BlanksAndComma = " \t\r,";

std::string Trimmed(const std::string& text)
{
  const std::size_t begin = text.find_first_not_of(Blanks);
  return begin == std::string::npos ? std::string()
                                    : text.substr(begin, text.find_last_not_of(Blanks) + 1 - begin);
}

constexpr std::size_t MostGroupsShown = 5;
constexpr const char* CellNames[] = { "points", "edges", "triangles",
  "tetrahedra" }; // by dimension

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

template <typename Whole>
bool ReadWhole(const std::string& word, Whole& value)
{
  const bool hasPlus = word.size() > 1 && word[0] == '+' && word[1] != '-';
  const char* const end = word.data() + word.size();
  const std::from_chars_result result =
    std::from_chars(word.data() + (hasPlus ? 1 : 0), end, value);
  return result.ec == std::errc() && result.ptr == end;
}
template bool ReadWhole(const std::string& word, int& value);
template bool ReadWhole(const std::string& word, std::int64_t& value);
template bool ReadWhole(const std::string& word, std::size_t& value);

MeshFileLines::MeshFileLines(std::istream& file, MeshFileDialect dialect)
  : File(file)
  , Dialect(dialect)
{
  this->Real.imbue(std::locale::classic());
}

bool MeshFileLines::Next()
{
  while (this->PassTitle())
  {
    if (this->Dialect == MeshFileDialect::SU2)
    {
      this->Text.erase(std::min(this->Text.find('%'), this->Text.size()));
    }
    if (this->Text.find_first_not_of(Blanks) != std::string::npos)
    {
      return true;
    }
  }
  return false;
}

bool MeshFileLines::PassTitle()
{
  this->Position = 0;
  this->IsAtEnd = !std::getline(this->File, this->Text);
  this->IsWhole = this->IsAtEnd ? this->IsWhole : !this->File.eof();
  this->Number += this->IsAtEnd ? 0 : 1;
  return !this->IsAtEnd;
}

bool MeshFileLines::IsRead() const
{
  return this->Text.find_first_not_of(Blanks, this->Position) == std::string::npos;
}

bool MeshFileLines::PassNumber()
{
  double number = 0.0;
  return this->Take(number);
}

// An empty word, as between two commas, is none.
bool MeshFileLines::Take(std::string& word)
{
  const bool isFortran = this->Dialect == MeshFileDialect::Fortran;
  const std::size_t size = this->Text.size();
  const std::size_t begin = std::min(this->Text.find_first_not_of(Blanks, this->Position), size);
  this->Position =
    std::min(this->Text.find_first_of(isFortran ? BlanksAndComma : Blanks, begin), size);
  word.assign(this->Text, begin, this->Position - begin);
  const std::size_t next = this->Text.find_first_not_of(Blanks, this->Position);
  if (isFortran && next < size && this->Text[next] == ',')
  {
    this->Position = next + 1;
  }
  return !word.empty();
}

bool MeshFileLines::Take(double& value)
{
  if (!this->Take(this->Word))
  {
    return false;
  }
  if (this->Dialect == MeshFileDialect::Fortran)
  {
    std::replace_if(
      this->Word.begin(), this->Word.end(), [](char c) { return c == 'd' || c == 'D'; }, 'e');
  }
  this->Real.clear();
  this->Real.str(this->Word);
  return (this->Real >> value) && this->Real.peek() == std::istringstream::traits_type::eof();
}

bool MeshFileLines::Quoted(std::string& text) const
{
  const std::size_t begin = this->Text.find('"');
  const std::size_t end = this->Text.rfind('"');
  const bool isQuoted = begin != std::string::npos && begin < end;
  text = isQuoted ? this->Text.substr(begin + 1, end - begin - 1) : std::string();
  return isQuoted;
}

bool MeshFileLines::Assignment(std::string& key, std::string& value) const
{
  const std::size_t sign = this->Text.find('=');
  key = Trimmed(this->Text.substr(0, sign));
  value = sign == std::string::npos ? std::string() : Trimmed(this->Text.substr(sign + 1));
  return sign != std::string::npos;
}

std::string MeshFileLines::Expected(const std::string& what) const
{
  return this->IsAtEnd
    ? "The file ends where there should be " + what + "."
    : "Line " + std::to_string(this->Number) + " is not what it should be: " + what + ".";
}

MeshFileCell CellOfType(const std::vector<std::array<int, 4>>& types, int type)
{
  for (const auto& [number, corners, vertices, dimension] : types)
  {
    if (number == type)
    {
      return { static_cast<std::size_t>(corners), static_cast<std::size_t>(vertices), dimension };
    }
  }
  return {};
}

MeshFileBuilder::MeshFileBuilder(std::istream& file, MeshFileDialect dialect, MeshFile& mesh)
  : In(file, dialect)
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
  return this->AddCell({ ends[0], ends[1], -1, -1 }, 2, group);
}

bool MeshFileBuilder::AddCell(
  const std::array<std::int64_t, 4>& corners, std::size_t size, const Group& group)
{
  Cell cell;
  cell.Corners = corners;
  cell.Size = size;
  cell.Dimension = size == 2 ? 1 : 2;
  return this->Add(cell, group);
}

bool MeshFileBuilder::ReadCell(const MeshFileCell& kind, const Group& group)
{
  this->PassedOver += kind.Corners == 0 ? 1 : 0;
  Cell cell;
  cell.Size = kind.Corners;
  cell.Dimension = kind.Dimension;
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
  for (std::size_t k = 0; k < 4 && cell.Size == 4 && cell.Dimension == 2; ++k)
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
  Groups& groups = this->GroupsOf(cell.Dimension);
  cell.Group = groups.emplace(group, groups.size()).first->second;
  cell.GroupNumber = group.first;
  cell.Line = this->In.LineNumber();
  this->Cells.push_back(cell);
  this->Dimension = std::max(this->Dimension, cell.Dimension);
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
      this->MakeGroups(this->Dimension, nameOf, this->Mesh.RegionOfCell, this->Mesh.Regions);
      this->MakeGroups(this->Dimension - 1, nameOf, this->Mesh.TagOfSide, this->Mesh.Tags);
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

// Of cells with the same vertices the first that has a group stays, else the first.
void MeshFileBuilder::PassRepeatedCells()
{
  using Corners = std::array<std::int64_t, 4>;
  std::map<std::pair<int, Corners>, std::size_t> kept; // by dimension and sorted corners
  std::vector<bool> isPassed(this->Cells.size(), false);
  for (std::size_t k = 0; k < this->Cells.size(); ++k)
  {
    const Cell& cell = this->Cells[k];
    Corners corners = cell.Corners;
    std::sort(corners.begin(), corners.end());
    const auto [entry, isNew] = kept.emplace(std::make_pair(cell.Dimension, corners), k);
    if (isNew)
    {
      continue;
    }
    const std::int64_t keptGroup = this->Cells[entry->second].GroupNumber;
    const bool isBetter = keptGroup == 0 && cell.GroupNumber != 0;
    isPassed[isBetter ? entry->second : k] = true;
    if (isBetter || cell.GroupNumber == 0 || cell.GroupNumber == keptGroup)
    {
      entry->second = isBetter ? k : entry->second;
      ++this->Repeated;
    }
    else
    {
      this->LeaveOut(cell.Dimension, cell.GroupNumber, 1);
    }
  }
  std::size_t count = 0;
  for (std::size_t k = 0; k < this->Cells.size(); ++k)
  {
    this->Cells[count] = this->Cells[k];
    count += isPassed[k] ? 0 : 1;
  }
  this->Cells.resize(count);
}

bool MeshFileBuilder::AddCells()
{
  bool areAdded = true;
  for (auto cell = this->Cells.begin(); areAdded && cell != this->Cells.end(); ++cell)
  {
    areAdded = this->AddCell(*cell);
  }
  if (areAdded && this->Mesh.NumberOfCells() == 0)
  {
    this->Result.Reason = "The file has no triangles or tetrahedra.";
  }
  return this->Result.Reason.empty();
}

// A quad has two triangles, and each its group.
bool MeshFileBuilder::AddCell(const Cell& cell)
{
  const auto& corners = cell.Corners;
  const bool isQuad = cell.Size == 4 && cell.Dimension == 2;
  this->OfOrderTwo += cell.IsOfOrderTwo ? 1 : 0;
  if (cell.Dimension + 1 < this->Dimension)
  {
    ++this->EdgesBeside;
    return true;
  }
  auto& groups = cell.Dimension == this->Dimension ? this->Mesh.RegionOfCell : this->Mesh.TagOfSide;
  groups.insert(groups.end(), isQuad ? 2 : 1, cell.Group);
  if (cell.Dimension == 1)
  {
    this->Mesh.Edges.push_back({ corners[0], corners[1] });
  }
  else if (cell.Dimension == 3)
  {
    this->Mesh.Tetrahedra.push_back(corners);
  }
  else if (!isQuad)
  {
    this->Mesh.Triangles.push_back({ corners[0], corners[1], corners[2] });
  }
  return !isQuad || this->AddQuad(cell);
}

bool MeshFileBuilder::AddQuad(const Cell& cell)
{
  std::array<std::array<double, 3>, 4> places{};
  for (std::size_t k = 0; k < 4; ++k)
  {
    places[k] = this->Mesh.Points[cell.Corners[k]];
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
    isMiddle[middle.first] = true;
  }
  for (const Cell& cell : this->Cells)
  {
    for (std::size_t k = 0; k < cell.Size; ++k)
    {
      isMiddle[cell.Corners[k]] = false;
    }
  }
  std::vector<MeshFile::Vertex> numbers;
  MeshFile::Vertex kept = 0;
  for (std::size_t vertex = 0; vertex < isMiddle.size(); ++vertex)
  {
    numbers.push_back(kept);
    this->Mesh.Points[kept] = this->Mesh.Points[vertex];
    kept += isMiddle[vertex] ? 0 : 1;
  }
  this->Mesh.Points.resize(static_cast<std::size_t>(kept));
  const auto renumber = [&numbers](auto& cells)
  {
    for (auto& cell : cells)
    {
      for (MeshFile::Vertex& corner : cell)
      {
        corner = numbers[corner];
      }
    }
  };
  renumber(this->Mesh.Tetrahedra);
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
  say(
    this->PassedOver, "cell", "neither tetrahedron nor triangle nor quad nor edge, and left out.");
  say(this->EdgesBeside, "edge", "left out beside tetrahedra.");
  say(this->Quads, "quad", "divided into two triangles each.");
  say(this->OfOrderTwo, "cell", "of order 2: only the corners are read.");
  say(this->Repeated, "cell", "listed once more, and read once.");
  const bool isSolid = this->Mesh.IsSolid();
  say(CountSidesOfNoCell(this->Mesh), isSolid ? "triangle" : "edge",
    isSolid ? "no side of a tetrahedron." : "no side of a triangle.");
  std::string text;
  std::size_t shown = 0;
  for (const auto& other : this->OtherGroups)
  {
    const auto [dimension, number] = other.first;
    const std::string name = nameOf(dimension, number);
    if (++shown <= MostGroupsShown)
    {
      text += (text.empty() ? "" : ", ") + std::string(CellNames[dimension]) + " in " +
        (name.empty() ? std::to_string(number) : name) + " (" + std::to_string(other.second) + ")";
    }
  }
  if (shown > 0)
  {
    this->Remark("Cells are in more than one group: the first is kept. Left out: " + text +
      (shown > MostGroupsShown ? " and other groups." : "."));
  }
}

} // namespace biting
