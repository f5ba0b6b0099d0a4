// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "MeshFile.h"

#include <algorithm> // for adjacent_find, any_of, binary_search, count_if, min, max, rotate, sort
#include <map>       // for edges and their tags
#include <numeric>   // for iota
#include <utility>   // for pair, swap

namespace biting
{

namespace
{

using Vertex = MeshFile::Vertex;
using Edge = std::array<Vertex, 2>;

constexpr int TriangleInSU2 = 5;
constexpr int EdgeInSU2 = 3;
constexpr int Mainland = 0;
constexpr int Island = 1;

Edge Undirected(Vertex a, Vertex b)
{
  return { std::min(a, b), std::max(a, b) };
}

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

// All sides of triangles, sorted.
template <typename MakeEdge>
std::vector<Edge> SortedSides(const MeshFile& mesh, MakeEdge makeEdge)
{
  std::vector<Edge> sides;
  sides.reserve(3 * mesh.Triangles.size());
  for (const std::array<Vertex, 3>& triangle : mesh.Triangles)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      sides.push_back(makeEdge(triangle[k], triangle[(k + 1) % 3]));
    }
  }
  std::sort(sides.begin(), sides.end());
  return sides;
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
template <typename Loop>
double Area(const MeshFile& mesh, const Loop& loop)
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
  std::string untagged = "boundary";
  while (std::any_of(mesh.Tags.begin(), mesh.Tags.end(),
    [&untagged](const MeshGroup& tag) { return tag.Name == untagged; }))
  {
    untagged += '_';
  }
  file << "NMARK= " << markers.size() << "\n";
  for (const auto& marker : markers)
  {
    const bool isTagged = marker.first < mesh.Tags.size();
    file << "MARKER_TAG= " << (isTagged ? mesh.Tags[marker.first].Name : untagged)
         << "\nMARKER_ELEMS= " << marker.second.size() << "\n";
    for (const Edge& edge : marker.second)
    {
      file << EdgeInSU2 << " " << edge[0] << " " << edge[1] << "\n";
    }
  }
}

constexpr std::size_t Open = 1;

bool IsLoop(const BoundaryPath& path)
{
  return path.Vertices.front() == path.Vertices.back();
}

// An island is closed by its type, so that its first vertex is not repeated.
bool IsWholeIsland(const BoundaryPath& path)
{
  return path.IsIsland && path.Label != Open && IsLoop(path);
}

std::size_t SizeOf(const BoundaryPath& path)
{
  return path.Vertices.size() - (IsWholeIsland(path) ? 1 : 0);
}

// Adds an open path; a loop as two, and as more where a vertex is on it several times.
void AddOpen(const BoundaryPath& path, std::vector<BoundaryPath>& opens)
{
  if (!IsLoop(path))
  {
    opens.push_back(path);
    return;
  }
  const auto middle = path.Vertices.begin() + static_cast<std::ptrdiff_t>(path.Vertices.size() / 2);
  AddOpen({ { path.Vertices.begin(), middle + 1 }, Open, path.IsIsland }, opens);
  AddOpen({ { middle, path.Vertices.end() }, Open, path.IsIsland }, opens);
}

// Land with its type.
void WriteBoundaries(
  const std::vector<BoundaryPath>& paths, const std::string& name, bool isLand, std::ostream& file)
{
  std::size_t size = 0;
  for (const BoundaryPath& path : paths)
  {
    size += SizeOf(path);
  }
  file << paths.size() << " = number of " << name << " boundaries\n"
       << size << " = number of their nodes\n";
  for (const BoundaryPath& path : paths)
  {
    file << SizeOf(path);
    if (isLand)
    {
      file << " " << (IsWholeIsland(path) ? Island : Mainland);
    }
    file << "\n";
    for (std::size_t k = 0; k < SizeOf(path); ++k)
    {
      file << path.Vertices[k] + 1 << "\n";
    }
  }
}

} // namespace

bool EndsWith(const std::string& name, const std::string& end)
{
  return name.size() >= end.size() && name.compare(name.size() - end.size(), end.size(), end) == 0;
}

std::size_t CountEdgesOfNoTriangle(const MeshFile& mesh)
{
  const std::vector<Edge> sides = SortedSides(mesh, Undirected);
  return static_cast<std::size_t>(std::count_if(mesh.Edges.begin(), mesh.Edges.end(),
    [&sides](const Edge& edge)
    { return !std::binary_search(sides.begin(), sides.end(), Undirected(edge[0], edge[1])); }));
}

void OrientUpwards(MeshFile& mesh)
{
  for (auto& triangle : mesh.Triangles)
  {
    if (Area(mesh, triangle) < 0.0)
    {
      std::swap(triangle[1], triangle[2]);
    }
  }
}

bool IsBoundaryOfLoops(const MeshFile& mesh)
{
  const std::vector<Edge> sides = SortedSides(mesh,
    [](Vertex a, Vertex b) {
      return Edge{ a, b };
    });
  return std::adjacent_find(sides.begin(), sides.end()) == sides.end();
}

std::string FindOpenTags(const MeshFile& mesh, const std::string& names, std::vector<bool>& areOpen)
{
  constexpr const char* separators = " \t\n\r,";
  areOpen.assign(mesh.Tags.size(), false);
  std::vector<bool> areOfBoundary(mesh.Tags.size() + 1, false);
  std::vector<std::size_t> labels(mesh.Tags.size() + 1);
  std::iota(labels.begin(), labels.end(), 0);
  for (const BoundaryPath& path : BoundaryPaths(mesh, labels))
  {
    areOfBoundary[path.Label] = true;
  }
  std::size_t begin = names.find_first_not_of(separators);
  while (begin < names.size())
  {
    std::size_t longest = 0;
    std::size_t found = mesh.Tags.size();
    for (std::size_t tag = 0; tag < mesh.Tags.size(); ++tag)
    {
      const std::string& name = mesh.Tags[tag].Name;
      const std::size_t end = begin + name.size();
      const bool isHere = areOfBoundary[tag] && names.compare(begin, name.size(), name) == 0 &&
        (end >= names.size() || std::string(separators).find(names[end]) != std::string::npos);
      if (isHere && name.size() > longest)
      {
        longest = name.size();
        found = tag;
      }
    }
    if (found == mesh.Tags.size())
    {
      return names.substr(begin, names.find_first_of(separators, begin) - begin);
    }
    areOpen[found] = true;
    begin = names.find_first_not_of(separators, begin + longest);
  }
  return {};
}

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

void WriteSU2(const MeshFile& mesh, std::ostream& file)
{
  file.precision(DigitsOfDouble);
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

void WriteADCIRC(const MeshFile& mesh, const std::vector<bool>& areOpen, std::ostream& file)
{
  file.precision(DigitsOfDouble);
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
  std::vector<std::size_t> labels(areOpen.begin(), areOpen.end());
  labels.push_back(0);
  for (const BoundaryPath& path : BoundaryPaths(mesh, labels))
  {
    path.Label == Open ? AddOpen(path, opens) : lands.push_back(path);
  }
  WriteBoundaries(opens, "open", false, file);
  WriteBoundaries(lands, "land", true, file);
}

} // namespace biting
