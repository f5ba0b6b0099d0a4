// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "MeshFile.h"

#include <algorithm> // for count_if, min, max, replace
#include <sstream>   // for boxes

namespace biting
{

namespace
{

using Vertex = MeshFile::Vertex;

constexpr int TriangleInGmsh = 2;
constexpr int EdgeInGmsh = 1;

// Those of `numberOfItems` things that belong to each of `numberOfGroups`.
std::vector<std::vector<std::size_t>> ByGroup(
  const std::vector<std::size_t>& groups, std::size_t numberOfGroups)
{
  std::vector<std::vector<std::size_t>> items(numberOfGroups);
  for (std::size_t k = 0; k < groups.size(); ++k)
  {
    items[groups[k]].push_back(k);
  }
  return items;
}

// A vertex belongs to the first curve that has it, else to the region of its first triangle.
std::vector<std::vector<std::size_t>> VerticesByEntity(const MeshFile& mesh)
{
  const std::size_t none = mesh.Tags.size() + mesh.Regions.size();
  std::vector<std::size_t> entities(mesh.Points.size(), none);
  const auto claim = [&entities, none](Vertex vertex, std::size_t entity)
  {
    std::size_t& owner = entities[static_cast<std::size_t>(vertex)];
    owner = owner == none ? entity : owner;
  };
  for (std::size_t k = 0; k < mesh.Edges.size(); ++k)
  {
    claim(mesh.Edges[k][0], mesh.TagOfEdge[k]);
    claim(mesh.Edges[k][1], mesh.TagOfEdge[k]);
  }
  for (std::size_t k = 0; k < mesh.Triangles.size(); ++k)
  {
    for (const Vertex corner : mesh.Triangles[k])
    {
      claim(corner, mesh.Tags.size() + mesh.RegionOfTriangle[k]);
    }
  }
  std::replace(entities.begin(), entities.end(), none, mesh.Tags.size()); // unused points
  return ByGroup(entities, none);
}

void WritePhysicalNames(const MeshFile& mesh, std::ostream& file)
{
  file << "$PhysicalNames\n" << mesh.Tags.size() + mesh.Regions.size() << "\n";
  for (const MeshGroup& tag : mesh.Tags)
  {
    file << "1 " << tag.Number << " \"" << tag.Name << "\"\n";
  }
  for (const MeshGroup& region : mesh.Regions)
  {
    file << "2 " << region.Number << " \"" << region.Name << "\"\n";
  }
  file << "$EndPhysicalNames\n";
}

// The box that Gmsh wants of each entity: that of the whole mesh.
std::string BoxText(const MeshFile& mesh, std::ostream& like)
{
  std::array<double, 3> low = mesh.Points.front();
  std::array<double, 3> high = low;
  for (const auto& point : mesh.Points)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      low[axis] = std::min(low[axis], point[axis]);
      high[axis] = std::max(high[axis], point[axis]);
    }
  }
  std::ostringstream text;
  text.precision(like.precision());
  text << low[0] << " " << low[1] << " " << low[2] << " " << high[0] << " " << high[1] << " "
       << high[2];
  return text.str();
}

void WriteEntities(const MeshFile& mesh, std::ostream& file)
{
  const std::string box = BoxText(mesh, file);
  file << "$Entities\n0 " << mesh.Tags.size() << " " << mesh.Regions.size() << " 0\n";
  const auto write = [&box, &file](const std::vector<MeshGroup>& groups)
  {
    for (std::size_t k = 0; k < groups.size(); ++k)
    {
      file << k + 1 << " " << box << " 1 " << groups[k].Number << " 0\n";
    }
  };
  write(mesh.Tags);
  write(mesh.Regions);
  file << "$EndEntities\n";
}

// The header of a section in blocks: how many blocks are not empty, and how many things they have.
void WriteHeader(const char* section, const std::vector<std::vector<std::size_t>>& blocks,
  std::size_t count, std::ostream& file)
{
  const auto empty = std::count_if(blocks.begin(), blocks.end(),
    [](const std::vector<std::size_t>& block) { return block.empty(); });
  file << section << "\n"
       << blocks.size() - static_cast<std::size_t>(empty) << " " << count << " 1 " << count << "\n";
}

void WriteNodes(const MeshFile& mesh, std::ostream& file)
{
  const auto blocks = VerticesByEntity(mesh);
  WriteHeader("$Nodes", blocks, mesh.Points.size(), file);
  for (std::size_t entity = 0; entity < blocks.size(); ++entity)
  {
    const bool isCurve = entity < mesh.Tags.size();
    const std::vector<std::size_t>& block = blocks[entity];
    if (!block.empty())
    {
      file << (isCurve ? 1 : 2) << " " << (isCurve ? entity : entity - mesh.Tags.size()) + 1
           << " 0 " << block.size() << "\n";
    }
    for (const std::size_t vertex : block)
    {
      file << vertex + 1 << "\n";
    }
    for (const std::size_t vertex : block)
    {
      const auto& point = mesh.Points[vertex];
      file << point[0] << " " << point[1] << " " << point[2] << "\n";
    }
  }
  file << "$EndNodes\n";
}

// One block: cells of one type in one entity, numbered on from `number`.
template <typename Cells>
void WriteBlock(int dimension, std::size_t entity, int type, const Cells& cells,
  const std::vector<std::size_t>& block, std::size_t& number, std::ostream& file)
{
  if (!block.empty())
  {
    file << dimension << " " << entity + 1 << " " << type << " " << block.size() << "\n";
  }
  for (const std::size_t cell : block)
  {
    file << ++number;
    for (const Vertex vertex : cells[cell])
    {
      file << " " << vertex + 1;
    }
    file << "\n";
  }
}

void WriteElements(const MeshFile& mesh, std::ostream& file)
{
  auto blocks = ByGroup(mesh.TagOfEdge, mesh.Tags.size());
  const auto regions = ByGroup(mesh.RegionOfTriangle, mesh.Regions.size());
  blocks.insert(blocks.end(), regions.begin(), regions.end());
  WriteHeader("$Elements", blocks, mesh.Edges.size() + mesh.Triangles.size(), file);
  std::size_t number = 0;
  for (std::size_t tag = 0; tag < mesh.Tags.size(); ++tag)
  {
    WriteBlock(1, tag, EdgeInGmsh, mesh.Edges, blocks[tag], number, file);
  }
  for (std::size_t region = 0; region < regions.size(); ++region)
  {
    WriteBlock(2, region, TriangleInGmsh, mesh.Triangles, regions[region], number, file);
  }
  file << "$EndElements\n";
}

} // namespace

void WriteGmsh(const MeshFile& mesh, std::ostream& file)
{
  file.precision(DigitsOfDouble);
  file << "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";
  WritePhysicalNames(mesh, file);
  WriteEntities(mesh, file);
  WriteNodes(mesh, file);
  WriteElements(mesh, file);
}

} // namespace biting
