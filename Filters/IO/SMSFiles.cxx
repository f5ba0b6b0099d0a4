// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "MeshFileBuilder.h"

#include <algorithm> // for find, min
#include <cctype>    // for digits
#include <cstdlib>   // for abs
#include <iterator>  // for begin, end
#include <limits>    // for numbers of nodes
#include <map>       // for edges by their ends, names

namespace biting
{

namespace
{

using Vertex = MeshFile::Vertex;

constexpr std::size_t NodesPerLine = 10;

// Cards that say nothing of the mesh.
constexpr const char* PassedCards[] = { "MESHNAME", "NUM_MATERIALS_PER_ELEM", "BEG2DMBC",
  "END2DMBC" };

class SMSReading
{
public:
  SMSReading(std::istream& file, MeshFile& mesh)
    : Out(file, MeshFileDialect::Gmsh, mesh)
    , Mesh(mesh)
  {
  }

  ReadingResult Read()
  {
    std::string card;
    bool isRead = (this->In.Read(card) && card == "MESH2D") || this->Out.Fail("MESH2D");
    while (isRead && this->In.Read(card))
    {
      isRead = this->ReadCard(card);
    }
    if (isRead && !this->Nodes.empty())
    {
      this->Out.Fail("the end of a node string");
    }
    if (this->OtherCards > 0)
    {
      this->Out.Remark(
        "Cards that are no elements, nodes, node strings or materials are left out: " +
        std::to_string(this->OtherCards) + ".");
    }
    return this->Out.Finish(
      [this](int dimension, std::int64_t number)
      {
        const auto name = this->Materials.find(number);
        return dimension == 2 && name != this->Materials.end() ? name->second : std::string();
      });
  }

private:
  bool ReadCard(const std::string& card)
  {
    if (card == "E3T" || card == "E4Q")
    {
      return this->ReadElement(card == "E3T" ? 3 : 4);
    }
    if (card == "ND")
    {
      return this->ReadNode();
    }
    if (card == "NS")
    {
      return this->ReadString();
    }
    if (card == "MAT")
    {
      std::int64_t number = 0;
      const bool isRead = this->In.More(number) || this->Out.Fail("the number of a material");
      this->In.Quoted(this->Materials[number]);
      return isRead;
    }
    if (card.size() > 1 && card[0] == 'E' && std::isdigit(static_cast<unsigned char>(card[1])) != 0)
    {
      return this->Out.Fail("E3T or E4Q: other elements are not read");
    }
    const bool isPassed =
      std::find(std::begin(PassedCards), std::end(PassedCards), card) != std::end(PassedCards);
    this->OtherCards += isPassed ? 0 : 1;
    return true;
  }

  // The first material, if there is any, is the region.
  bool ReadElement(std::size_t size)
  {
    std::int64_t number = 0;
    std::array<std::int64_t, 4> corners{ -1, -1, -1, -1 };
    bool isRead = this->In.More(number);
    for (std::size_t k = 0; k < size; ++k)
    {
      isRead = isRead && this->In.More(corners[k]);
    }
    std::int64_t material = 0;
    isRead = isRead && (this->In.IsRead() || this->In.More(material));
    return (isRead || this->Out.Fail("an element with its nodes and its material")) &&
      this->Out.AddCell(corners, size, { material, 0 });
  }

  bool ReadNode()
  {
    std::int64_t number = 0;
    std::array<double, 3> place{};
    const bool isRead = this->In.More(number, place[0], place[1], place[2]);
    this->Mesh.Depths.push_back(0.0 - place[2]);
    return (isRead || this->Out.Fail("a node")) &&
      this->Out.AddVertex(number, { place[0], place[1], 0.0 });
  }

  // It goes on in the next card until a number is negative; its own number may follow.
  bool ReadString()
  {
    while (!this->In.IsRead())
    {
      std::int64_t node = 0;
      if (!this->In.More(node) || node == 0 || node == std::numeric_limits<std::int64_t>::min())
      {
        return this->Out.Fail("a node of a node string");
      }
      this->Nodes.push_back(std::abs(node));
      if (node < 0)
      {
        return this->EndString();
      }
    }
    return true;
  }

  bool EndString()
  {
    std::int64_t number = ++this->NumberOfStrings;
    bool isRead = this->In.IsRead() || (this->In.More(number) && number > 0) ||
      this->Out.Fail("the number of a node string");
    for (std::size_t k = 1; isRead && k < this->Nodes.size(); ++k)
    {
      isRead = this->Out.AddEdge({ this->Nodes[k - 1], this->Nodes[k] }, { number, 0 });
    }
    this->Nodes.clear();
    return isRead;
  }

  MeshFileBuilder Out;
  MeshFileLines& In = this->Out.In;
  MeshFile& Mesh;
  std::map<std::int64_t, std::string> Materials;
  std::vector<std::int64_t> Nodes; // of the node string that has not ended
  std::int64_t NumberOfStrings = 0;
  std::size_t OtherCards = 0;
};

// The edges of a tag, joined end to end as far as they go.
std::vector<std::vector<Vertex>> StringsOf(const MeshFile& mesh, std::size_t tag)
{
  std::multimap<Vertex, std::size_t> edgesAt;
  for (std::size_t edge = 0; edge < mesh.Edges.size(); ++edge)
  {
    if (mesh.TagOfSide[edge] == tag)
    {
      edgesAt.emplace(mesh.Edges[edge][0], edge);
      edgesAt.emplace(mesh.Edges[edge][1], edge);
    }
  }
  const auto takeFrom = [&mesh, &edgesAt](Vertex vertex)
  {
    const std::size_t edge = edgesAt.find(vertex)->second;
    for (const Vertex end : mesh.Edges[edge])
    {
      const auto [first, last] = edgesAt.equal_range(end);
      edgesAt.erase(
        std::find_if(first, last, [edge](const auto& at) { return at.second == edge; }));
    }
    return mesh.Edges[edge][0] == vertex ? mesh.Edges[edge][1] : mesh.Edges[edge][0];
  };
  std::vector<std::vector<Vertex>> strings;
  while (!edgesAt.empty())
  {
    auto start = edgesAt.begin();
    while (start != edgesAt.end() && edgesAt.count(start->first) == 2)
    {
      start = edgesAt.upper_bound(start->first);
    }
    strings.push_back({ (start == edgesAt.end() ? edgesAt.begin() : start)->first });
    while (edgesAt.count(strings.back().back()) > 0)
    {
      strings.back().push_back(takeFrom(strings.back().back()));
    }
  }
  return strings;
}

// The last node is negative, and the number of the string behind it.
void WriteString(const std::vector<Vertex>& nodes, std::int64_t number, std::ostream& file)
{
  for (std::size_t k = 0; k < nodes.size(); ++k)
  {
    const bool isLast = k + 1 == nodes.size();
    file << (k % NodesPerLine == 0 ? "NS" : "") << (isLast ? " -" : " ") << nodes[k] + 1;
    file << (isLast ? " " + std::to_string(number) : "");
    file << (isLast || (k + 1) % NodesPerLine == 0 ? "\n" : "");
  }
}

} // namespace

ReadingResult ReadSMS(std::istream& file, MeshFile& mesh)
{
  return SMSReading(file, mesh).Read();
}

void WriteSMS(const MeshFile& mesh, std::ostream& file)
{
  file.precision(DigitsOfDouble);
  file << "MESH2D\nMESHNAME \"mesh\"\nNUM_MATERIALS_PER_ELEM 1\n";
  for (std::size_t k = 0; k < mesh.Triangles.size(); ++k)
  {
    file << "E3T " << k + 1;
    for (const Vertex corner : mesh.Triangles[k])
    {
      file << " " << corner + 1;
    }
    file << " " << mesh.Regions[mesh.RegionOfCell[k]].Number << "\n";
  }
  for (std::size_t vertex = 0; vertex < mesh.Points.size(); ++vertex)
  {
    file << "ND " << vertex + 1 << " " << mesh.Points[vertex][0] << " " << mesh.Points[vertex][1]
         << " " << (mesh.Depths.empty() ? 0.0 : 0.0 - mesh.Depths[vertex]) << "\n";
  }
  for (std::size_t tag = 0; tag < mesh.Tags.size(); ++tag)
  {
    for (const std::vector<Vertex>& nodes : StringsOf(mesh, tag))
    {
      WriteString(nodes, mesh.Tags[tag].Number, file);
    }
  }
  file << "BEG2DMBC\n";
  for (const MeshGroup& region : mesh.Regions)
  {
    file << "MAT " << region.Number << " \"" << region.Name << "\"\n";
  }
  file << "END2DMBC\n";
}

} // namespace biting
