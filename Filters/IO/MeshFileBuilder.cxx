// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "MeshFileBuilder.h"

#include <algorithm> // for any_of, min
#include <locale>    // for numbers with a point

namespace biting
{

namespace
{

constexpr const char* Blanks = " \t\r";

std::string Trimmed(const std::string& text)
{
  const std::size_t begin = text.find_first_not_of(Blanks);
  return begin == std::string::npos ? std::string()
                                    : text.substr(begin, text.find_last_not_of(Blanks) + 1 - begin);
}

// Makes the groups of one dimension, and gives the cells their indices.
void MakeGroups(const std::map<MeshFileBuilder::Group, std::size_t>& found,
  const std::function<std::string(std::int64_t)>& nameOf, std::vector<std::size_t>& ofCells,
  std::vector<MeshGroup>& groups)
{
  const bool hasNumbers = std::any_of(
    found.begin(), found.end(), [](const auto& entry) { return entry.first.first > 0; });
  std::map<std::int64_t, std::size_t> byNumber;
  std::vector<std::size_t> indices(found.size());
  for (const auto& entry : found)
  {
    const std::int64_t number = hasNumbers ? entry.first.first : entry.first.second;
    const auto added = byNumber.emplace(number, groups.size());
    indices[entry.second] = added.first->second;
    if (added.second)
    {
      groups.push_back({ number, nameOf(number) });
    }
  }
  for (std::size_t& group : ofCells)
  {
    group = indices[group];
  }
}

} // namespace

//------------------------------------------------------------------------------
MeshFileLines::MeshFileLines(std::istream& file, char comment)
  : File(file)
  , Comment(comment)
{
  this->Words.imbue(std::locale::classic());
}

//------------------------------------------------------------------------------
bool MeshFileLines::Next()
{
  while (std::getline(this->File, this->Text))
  {
    ++this->Number;
    this->Text.erase(std::min(this->Text.find(this->Comment), this->Text.size()));
    if (this->Text.find_first_not_of(Blanks) != std::string::npos)
    {
      this->Words.clear();
      this->Words.str(this->Text);
      return true;
    }
  }
  this->IsAtEnd = true;
  return false;
}

//------------------------------------------------------------------------------
bool MeshFileLines::PassTitle()
{
  ++this->Number;
  return static_cast<bool>(std::getline(this->File, this->Text));
}

//------------------------------------------------------------------------------
bool MeshFileLines::Quoted(std::string& text) const
{
  const std::size_t begin = this->Text.find('"');
  const std::size_t end = this->Text.rfind('"');
  const bool isQuoted = begin != std::string::npos && begin < end;
  text = isQuoted ? this->Text.substr(begin + 1, end - begin - 1) : std::string();
  return isQuoted;
}

//------------------------------------------------------------------------------
bool MeshFileLines::Assignment(std::string& key, std::string& value) const
{
  const std::size_t sign = this->Text.find('=');
  key = Trimmed(this->Text.substr(0, sign));
  value = sign == std::string::npos ? std::string() : Trimmed(this->Text.substr(sign + 1));
  return sign != std::string::npos;
}

//------------------------------------------------------------------------------
std::string MeshFileLines::Expected(const std::string& what) const
{
  return this->IsAtEnd
    ? "The file ends where there should be " + what + "."
    : "Line " + std::to_string(this->Number) + " is not what it should be: " + what + ".";
}

//------------------------------------------------------------------------------
MeshFileBuilder::MeshFileBuilder(MeshFileLines& lines, MeshFile& mesh)
  : In(lines)
  , Mesh(mesh)
{
}

//------------------------------------------------------------------------------
bool MeshFileBuilder::Fail(const std::string& what)
{
  this->Result.Reason = this->In.Expected(what);
  return false;
}

//------------------------------------------------------------------------------
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

//------------------------------------------------------------------------------
void MeshFileBuilder::AddEdge(const std::array<std::int64_t, 2>& ends, const Group& group)
{
  this->Mesh.Edges.push_back(ends);
  this->Mesh.TagOfEdge.push_back(this->Tags.emplace(group, this->Tags.size()).first->second);
}

//------------------------------------------------------------------------------
bool MeshFileBuilder::ReadCell(MeshFileCell cell, const Group& group)
{
  if (cell == MeshFileCell::Triangle)
  {
    const auto region = this->Regions.emplace(group, this->Regions.size());
    this->Mesh.RegionOfTriangle.push_back(region.first->second);
    return this->ReadCorners(this->Mesh.Triangles);
  }
  if (cell == MeshFileCell::Edge)
  {
    this->Mesh.TagOfEdge.push_back(this->Tags.emplace(group, this->Tags.size()).first->second);
    return this->ReadCorners(this->Mesh.Edges);
  }
  this->Result.PassedOverCells += cell == MeshFileCell::Other ? 1 : 0;
  return true;
}

//------------------------------------------------------------------------------
template <std::size_t Size>
bool MeshFileBuilder::ReadCorners(std::vector<std::array<std::int64_t, Size>>& cells)
{
  std::array<std::int64_t, Size> corners{};
  for (std::int64_t& corner : corners)
  {
    if (!this->In.More(corner))
    {
      return this->Fail("the vertices of a cell");
    }
  }
  cells.push_back(corners);
  return true;
}

//------------------------------------------------------------------------------
template <std::size_t Size>
bool MeshFileBuilder::FindVertices(std::vector<std::array<std::int64_t, Size>>& cells)
{
  for (auto& corners : cells)
  {
    for (std::int64_t& corner : corners)
    {
      const auto found = this->Vertices.find(corner);
      if (found == this->Vertices.end())
      {
        this->Result.Reason =
          "A cell names vertex " + std::to_string(corner) + ", which the file does not have.";
        return false;
      }
      corner = found->second;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
ReadingResult MeshFileBuilder::Finish(const NameOf& nameOf)
{
  if (this->Result.Reason.empty() && this->FindVertices(this->Mesh.Triangles) &&
    this->FindVertices(this->Mesh.Edges))
  {
    MakeGroups(
      this->Regions, [&nameOf](std::int64_t number) { return nameOf(2, number); },
      this->Mesh.RegionOfTriangle, this->Mesh.Regions);
    MakeGroups(
      this->Tags, [&nameOf](std::int64_t number) { return nameOf(1, number); },
      this->Mesh.TagOfEdge, this->Mesh.Tags);
    if (this->Mesh.Triangles.empty())
    {
      this->Result.Reason = "The file has no triangles.";
    }
  }
  return this->Result;
}

} // namespace biting
