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

constexpr int TypesInGmsh[] = { 15, 1, 2, 4 }; // by dimension, as in SU2

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

// A vertex belongs to the tag of its first side, else to the region of its first cell.
template <typename Sides, typename Cells>
std::vector<std::vector<std::size_t>> VerticesByEntity(
  const MeshFile& mesh, const Sides& sides, const Cells& cells)
{
  const std::size_t none = mesh.Tags.size() + mesh.Regions.size();
  std::vector<std::size_t> entities(mesh.Points.size(), none);
  const auto claim = [&entities, none](
                       const auto& all, const std::vector<std::size_t>& groups, std::size_t first)
  {
    for (std::size_t k = 0; k < all.size(); ++k)
    {
      for (const Vertex vertex : all[k])
      {
        std::size_t& owner = entities[vertex];
        owner = owner == none ? first + groups[k] : owner;
      }
    }
  };
  claim(sides, mesh.TagOfSide, 0);
  claim(cells, mesh.RegionOfCell, mesh.Tags.size());
  std::replace(entities.begin(), entities.end(), none, mesh.Tags.size()); // unused points
  return ByGroup(entities, none);
}

void WritePhysicalNames(const MeshFile& mesh, int dimension, std::ostream& file)
{
  file << "$PhysicalNames\n" << mesh.Tags.size() + mesh.Regions.size() << "\n";
  for (const MeshGroup& tag : mesh.Tags)
  {
    file << dimension - 1 << " " << tag.Number << " \"" << tag.Name << "\"\n";
  }
  for (const MeshGroup& region : mesh.Regions)
  {
    file << dimension << " " << region.Number << " \"" << region.Name << "\"\n";
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

void WriteEntities(const MeshFile& mesh, int dimension, std::ostream& file)
{
  const std::string box = BoxText(mesh, file);
  file << "$Entities\n0 " << (dimension == 2 ? "" : "0 ") << mesh.Tags.size() << " "
       << mesh.Regions.size() << (dimension == 2 ? " 0\n" : "\n");
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

template <typename Sides, typename Cells>
void WriteNodes(const MeshFile& mesh, const Sides& sides, const Cells& cells, std::ostream& file)
{
  const auto blocks = VerticesByEntity(mesh, sides, cells);
  WriteHeader("$Nodes", blocks, mesh.Points.size(), file);
  for (std::size_t entity = 0; entity < blocks.size(); ++entity)
  {
    const bool isTag = entity < mesh.Tags.size();
    const std::vector<std::size_t>& block = blocks[entity];
    if (!block.empty())
    {
      file << DimensionOf(cells) - (isTag ? 1 : 0) << " "
           << (isTag ? entity : entity - mesh.Tags.size()) + 1 << " 0 " << block.size() << "\n";
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
void WriteBlock(std::size_t entity, const Cells& cells, const std::vector<std::size_t>& block,
  std::size_t& number, std::ostream& file)
{
  if (!block.empty())
  {
    const int dimension = DimensionOf(cells);
    file << dimension << " " << entity + 1 << " " << TypesInGmsh[dimension] << " " << block.size()
         << "\n";
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

template <typename Sides, typename Cells>
void WriteElements(const MeshFile& mesh, const Sides& sides, const Cells& cells, std::ostream& file)
{
  auto blocks = ByGroup(mesh.TagOfSide, mesh.Tags.size());
  const auto regions = ByGroup(mesh.RegionOfCell, mesh.Regions.size());
  blocks.insert(blocks.end(), regions.begin(), regions.end());
  WriteHeader("$Elements", blocks, sides.size() + cells.size(), file);
  std::size_t number = 0;
  for (std::size_t tag = 0; tag < mesh.Tags.size(); ++tag)
  {
    WriteBlock(tag, sides, blocks[tag], number, file);
  }
  for (std::size_t region = 0; region < regions.size(); ++region)
  {
    WriteBlock(region, cells, regions[region], number, file);
  }
  file << "$EndElements\n";
}

} // namespace

void WriteGmsh(const MeshFile& mesh, std::ostream& file)
{
  file.precision(DigitsOfDouble);
  file << "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";
  WithCells(mesh,
    [&mesh, &file](const auto& sides, const auto& cells)
    {
      WritePhysicalNames(mesh, DimensionOf(cells), file);
      WriteEntities(mesh, DimensionOf(cells), file);
      WriteNodes(mesh, sides, cells, file);
      WriteElements(mesh, sides, cells, file);
    });
}

} // namespace biting
