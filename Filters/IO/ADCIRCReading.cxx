// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "MeshFileBuilder.h"

namespace biting
{

namespace
{

constexpr std::int64_t OpenTag = 1;
constexpr std::int64_t FirstLandTag = 2;

// The types of land that are loops, whose first node is not repeated.
bool IsIsland(std::int64_t type)
{
  return type == 1 || type == 11 || type == 21;
}

class ADCIRCReading
{
public:
  ADCIRCReading(MeshFileLines& lines, MeshFile& mesh)
    : In(lines)
    , Out(lines, mesh)
    , Mesh(mesh)
  {
  }

  ReadingResult Read()
  {
    if (this->ReadGrid() && this->ReadStrings(true))
    {
      this->ReadStrings(false);
    }
    return this->Out.Finish([](int dimension, std::int64_t number)
      { return dimension == 1 ? NameOf(number) : std::string(); });
  }

private:
  static std::string NameOf(std::int64_t tag)
  {
    return tag == OpenTag ? "open" : "land, type " + std::to_string(tag - FirstLandTag);
  }

  bool ReadGrid()
  {
    std::size_t elements = 0;
    std::size_t nodes = 0;
    bool isRead = (this->In.PassTitle() && this->In.Read(elements, nodes)) ||
      this->Out.Fail("the numbers of elements and nodes");
    for (std::size_t k = 0; isRead && k < nodes; ++k)
    {
      std::int64_t number = 0;
      std::array<double, 3> place{};
      isRead = (this->In.Read(number, place[0], place[1], place[2]) || this->Out.Fail("a node")) &&
        this->Out.AddVertex(number, { place[0], place[1], 0.0 });
      this->Mesh.Depths.push_back(place[2]);
    }
    for (std::size_t k = 0; isRead && k < elements; ++k)
    {
      std::int64_t number = 0;
      int corners = 0;
      isRead = (this->In.Read(number, corners) || this->Out.Fail("an element")) &&
        this->Out.ReadCell(corners == 3 ? MeshFileCell::Triangle : MeshFileCell::Other, { 0, 0 });
    }
    return isRead;
  }

  // Open boundaries or land: their number, that of all their nodes, then each. None need follow.
  bool ReadStrings(bool areOpen)
  {
    std::size_t count = 0;
    std::size_t total = 0;
    if (!this->In.Read(count))
    {
      return true;
    }
    bool isRead = this->In.Read(total) || this->Out.Fail("the number of nodes of boundaries");
    for (std::size_t k = 0; isRead && k < count; ++k)
    {
      isRead = this->ReadString(areOpen);
    }
    return isRead;
  }

  bool ReadString(bool isOpen)
  {
    std::size_t size = 0;
    std::int64_t type = 0;
    bool isRead = this->In.Read(size) && (isOpen || this->In.More(type));
    std::vector<std::int64_t> nodes;
    std::int64_t node = 0;
    while (isRead && nodes.size() < size)
    {
      isRead = this->In.Read(node);
      nodes.push_back(node);
    }
    if (isRead && !isOpen && IsIsland(type) && nodes.size() > 2 && nodes.front() != nodes.back())
    {
      nodes.push_back(nodes.front());
    }
    for (std::size_t k = 1; k < nodes.size(); ++k)
    {
      this->Out.AddEdge({ nodes[k - 1], nodes[k] }, { isOpen ? OpenTag : FirstLandTag + type, 0 });
    }
    return isRead || this->Out.Fail("a boundary");
  }

  MeshFileLines& In;
  MeshFileBuilder Out;
  MeshFile& Mesh;
};

} // namespace

ReadingResult ReadADCIRC(std::istream& file, MeshFile& mesh)
{
  MeshFileLines lines(file);
  return ADCIRCReading(lines, mesh).Read();
}

} // namespace biting
