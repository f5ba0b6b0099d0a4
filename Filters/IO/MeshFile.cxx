// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "MeshFile.h"

#include <algorithm> // for find, minmax, rotate
#include <limits>    // for digits of numbers
#include <map>       // for edges and their tags
#include <numeric>   // for iota
#include <sstream>   // for boxes
#include <utility>   // for pair

namespace biting
{

namespace
{

using Vertex = MeshFile::Vertex;
using Edge = std::array<Vertex, 2>;

constexpr int TriangleInGmsh = 2;
constexpr int EdgeInGmsh = 1;
constexpr int TriangleInSU2 = 5;
constexpr int EdgeInSU2 = 3;
constexpr int Mainland = 0;
constexpr int Island = 1;

// As many digits as give a number back.
void UseAllDigits(std::ostream& file)
{
  file.precision(std::numeric_limits<double>::max_digits10);
}

Edge Undirected(Vertex a, Vertex b)
{
  return { std::min(a, b), std::max(a, b) };
}

//------------------------------------------------------------------------------
// Boundary

std::map<Edge, std::size_t> LabelsByEdge(
  const MeshFile& mesh, const std::vector<std::size_t>& labels)
{
  std::map<Edge, std::size_t> byEdge;
  for (std::size_t k = 0; k < mesh.Edges.size(); ++k)
  {
    byEdge[Undirected(mesh.Edges[k][0], mesh.Edges[k][1])] = labels[mesh.TagOfEdge[k]];
  }
  return byEdge;
}

// The edges of one triangle, by their beginning, the triangle on the left.
std::multimap<Vertex, Vertex> BoundaryEdges(const MeshFile& mesh)
{
  std::map<Edge, std::pair<int, Edge>> uses;
  for (const std::array<Vertex, 3>& triangle : mesh.Triangles)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Edge directed{ triangle[k], triangle[(k + 1) % 3] };
      auto& use = uses[Undirected(directed[0], directed[1])];
      ++use.first;
      use.second = directed;
    }
  }
  std::multimap<Vertex, Vertex> edges;
  for (const auto& use : uses)
  {
    if (use.second.first == 1)
    {
      edges.emplace(use.second.second[0], use.second.second[1]);
    }
  }
  return edges;
}

// Takes a closed loop out of `edges`; its first vertex is not repeated.
std::vector<Vertex> TakeLoop(std::multimap<Vertex, Vertex>& edges)
{
  std::vector<Vertex> loop;
  auto edge = edges.begin();
  while (edge != edges.end())
  {
    loop.push_back(edge->first);
    const Vertex next = edge->second;
    edges.erase(edge);
    edge = next == loop.front() ? edges.end() : edges.find(next);
  }
  return loop;
}

// Twice the area that the loop surrounds, in x and y.
double Area(const MeshFile& mesh, const std::vector<Vertex>& loop)
{
  const auto& origin = mesh.Points[static_cast<std::size_t>(loop.front())];
  double area = 0.0;
  for (std::size_t k = 0; k < loop.size(); ++k)
  {
    const auto& a = mesh.Points[static_cast<std::size_t>(loop[k])];
    const auto& b = mesh.Points[static_cast<std::size_t>(loop[(k + 1) % loop.size()])];
    area += (a[0] - origin[0]) * (b[1] - origin[1]) - (b[0] - origin[0]) * (a[1] - origin[1]);
  }
  return area;
}

// Cuts a loop where its label changes, given the label of the edge after each vertex.
void AddPaths(std::vector<Vertex> loop, std::vector<std::size_t> labels, bool isIsland,
  std::vector<BoundaryPath>& paths)
{
  const std::size_t size = loop.size();
  std::size_t first = 0;
  while (first < size && labels[first] == labels[(first + size - 1) % size])
  {
    ++first;
  }
  const auto shift = static_cast<std::ptrdiff_t>(first % size);
  std::rotate(loop.begin(), loop.begin() + shift, loop.end());
  std::rotate(labels.begin(), labels.begin() + shift, labels.end());
  for (std::size_t k = 0; k < size; ++k)
  {
    if (k == 0 || labels[k] != labels[k - 1])
    {
      paths.push_back({ { loop[k] }, labels[k], isIsland });
    }
    paths.back().Vertices.push_back(loop[(k + 1) % size]);
  }
}

//------------------------------------------------------------------------------
// Gmsh

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

//------------------------------------------------------------------------------
// SU2

void WriteMarkers(const MeshFile& mesh, std::ostream& file)
{
  std::vector<std::size_t> labels(mesh.Tags.size() + 1);
  std::iota(labels.begin(), labels.end(), 0);
  std::map<std::size_t, std::vector<Edge>> markers;
  for (const BoundaryPath& path : BoundaryPaths(mesh, labels))
  {
    for (std::size_t k = 1; k < path.Vertices.size(); ++k)
    {
      markers[path.Label].push_back({ path.Vertices[k - 1], path.Vertices[k] });
    }
  }
  file << "NMARK= " << markers.size() << "\n";
  for (const auto& marker : markers)
  {
    const bool isTagged = marker.first < mesh.Tags.size();
    file << "MARKER_TAG= " << (isTagged ? mesh.Tags[marker.first].Name : "boundary")
         << "\nMARKER_ELEMS= " << marker.second.size() << "\n";
    for (const Edge& edge : marker.second)
    {
      file << EdgeInSU2 << " " << edge[0] << " " << edge[1] << "\n";
    }
  }
}

//------------------------------------------------------------------------------
// ADCIRC

constexpr std::size_t Open = 1;

// The label of each tag, and of no tag: open, or not.
std::vector<std::size_t> OpenLabels(const MeshFile& mesh, const std::vector<std::string>& open)
{
  std::vector<std::size_t> labels(mesh.Tags.size() + 1, 0);
  for (std::size_t tag = 0; tag < mesh.Tags.size(); ++tag)
  {
    const bool isOpen = std::find(open.begin(), open.end(), mesh.Tags[tag].Name) != open.end();
    labels[tag] = isOpen ? Open : 0;
  }
  return labels;
}

// An island is closed by its type, so that its first vertex is not repeated.
std::size_t SizeOf(const BoundaryPath& path)
{
  const bool isLoop = path.Vertices.front() == path.Vertices.back();
  return path.Vertices.size() - (path.IsIsland && isLoop ? 1 : 0);
}

void WritePath(const BoundaryPath& path, std::ostream& file)
{
  for (std::size_t k = 0; k < SizeOf(path); ++k)
  {
    file << path.Vertices[k] + 1 << "\n";
  }
}

std::size_t TotalSize(const std::vector<BoundaryPath>& paths)
{
  std::size_t size = 0;
  for (const BoundaryPath& path : paths)
  {
    size += SizeOf(path);
  }
  return size;
}

void WriteOpen(const std::vector<BoundaryPath>& paths, std::ostream& file)
{
  file << paths.size() << " = number of open boundaries\n"
       << TotalSize(paths) << " = number of their nodes\n";
  for (const BoundaryPath& path : paths)
  {
    file << SizeOf(path) << "\n";
    WritePath(path, file);
  }
}

void WriteLand(const std::vector<BoundaryPath>& paths, std::ostream& file)
{
  file << paths.size() << " = number of land boundaries\n"
       << TotalSize(paths) << " = number of their nodes\n";
  for (const BoundaryPath& path : paths)
  {
    file << SizeOf(path) << " " << (path.IsIsland ? Island : Mainland) << "\n";
    WritePath(path, file);
  }
}

} // namespace

std::vector<BoundaryPath> BoundaryPaths(
  const MeshFile& mesh, const std::vector<std::size_t>& labels)
{
  const std::map<Edge, std::size_t> byEdge = LabelsByEdge(mesh, labels);
  std::multimap<Vertex, Vertex> edges = BoundaryEdges(mesh);
  std::vector<BoundaryPath> paths;
  while (!edges.empty())
  {
    const std::vector<Vertex> loop = TakeLoop(edges);
    std::vector<std::size_t> labelsOfLoop;
    for (std::size_t k = 0; k < loop.size(); ++k)
    {
      const auto found = byEdge.find(Undirected(loop[k], loop[(k + 1) % loop.size()]));
      labelsOfLoop.push_back(found != byEdge.end() ? found->second : labels.back());
    }
    AddPaths(loop, labelsOfLoop, Area(mesh, loop) < 0.0, paths);
  }
  return paths;
}

void WriteGmsh(const MeshFile& mesh, std::ostream& file)
{
  UseAllDigits(file);
  file << "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";
  WritePhysicalNames(mesh, file);
  WriteEntities(mesh, file);
  WriteNodes(mesh, file);
  WriteElements(mesh, file);
}

void WriteSU2(const MeshFile& mesh, std::ostream& file)
{
  UseAllDigits(file);
  file << "NDIME= 2\nNELEM= " << mesh.Triangles.size() << "\n";
  std::size_t number = 0;
  for (const std::array<Vertex, 3>& corners : mesh.Triangles)
  {
    file << TriangleInSU2 << " " << corners[0] << " " << corners[1] << " " << corners[2] << " "
         << number++ << "\n";
  }
  file << "NPOIN= " << mesh.Points.size() << "\n";
  for (std::size_t vertex = 0; vertex < mesh.Points.size(); ++vertex)
  {
    file << mesh.Points[vertex][0] << " " << mesh.Points[vertex][1] << " " << vertex << "\n";
  }
  WriteMarkers(mesh, file);
}

void WriteADCIRC(const MeshFile& mesh, const std::vector<std::string>& open, std::ostream& file)
{
  UseAllDigits(file);
  file << "grid\n" << mesh.Triangles.size() << " " << mesh.Points.size() << "\n";
  for (std::size_t vertex = 0; vertex < mesh.Points.size(); ++vertex)
  {
    file << vertex + 1 << " " << mesh.Points[vertex][0] << " " << mesh.Points[vertex][1] << " "
         << (mesh.Depths.empty() ? 0.0 : mesh.Depths[vertex]) << "\n";
  }
  std::size_t number = 0;
  for (const std::array<Vertex, 3>& corners : mesh.Triangles)
  {
    file << ++number << " 3 " << corners[0] + 1 << " " << corners[1] + 1 << " " << corners[2] + 1
         << "\n";
  }
  std::vector<BoundaryPath> opens;
  std::vector<BoundaryPath> lands;
  for (const BoundaryPath& path : BoundaryPaths(mesh, OpenLabels(mesh, open)))
  {
    (path.Label == Open ? opens : lands).push_back(path);
  }
  WriteOpen(opens, file);
  WriteLand(lands, file);
}

} // namespace biting
