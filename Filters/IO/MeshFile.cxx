// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "MeshFile.h"

#include "../Kernel/Predicates/Predicates3.h"

#include <algorithm>   // for adjacent_find, any_of, count_if, min, max, min_element, rotate, sort
#include <map>         // for sides and their tags
#include <numeric>     // for iota
#include <tuple>       // for the corners of cells
#include <type_traits> // for lists of cells
#include <utility>     // for pair, swap

namespace biting
{

namespace
{

using Vertex = MeshFile::Vertex;
using Edge = std::array<Vertex, 2>;

constexpr int TypesInSU2[] = { 1, 3, 5, 10 }; // by dimension: point, edge, triangle, tetrahedron
constexpr int Mainland = 0;
constexpr int Island = 1;

Edge Undirected(Vertex a, Vertex b)
{
  return { std::min(a, b), std::max(a, b) };
}

Edge Undirected(const Edge& edge)
{
  return Undirected(edge[0], edge[1]);
}

using Face = std::array<Vertex, 3>;

Face Undirected(Face face)
{
  std::sort(face.begin(), face.end());
  return face;
}

// A side is one however its corners are turned.
Edge Directed(const Edge& edge)
{
  return edge;
}

Face Directed(Face face)
{
  std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
  return face;
}

// The sides of a cell: edges with it on their left, faces counterclockwise from outside.
std::array<Edge, 3> SidesOf(const std::array<Vertex, 3>& t)
{
  return { { { t[0], t[1] }, { t[1], t[2] }, { t[2], t[0] } } };
}

std::array<Face, 4> SidesOf(const std::array<Vertex, 4>& t)
{
  return { { { t[0], t[1], t[3] }, { t[1], t[2], t[3] }, { t[2], t[0], t[3] },
    { t[0], t[2], t[1] } } };
}

template <typename Cells>
using SideOf = typename decltype(SidesOf(Cells().front()))::value_type;

// What `make` makes of all sides of cells, sorted.
template <typename Cells, typename Make>
auto SortedSides(const Cells& cells, Make make)
{
  std::vector<decltype(make(SideOf<Cells>()))> sides;
  sides.reserve(cells.size() * std::tuple_size<typename Cells::value_type>::value);
  for (const auto& cell : cells)
  {
    for (const SideOf<Cells>& side : SidesOf(cell))
    {
      sides.push_back(make(side));
    }
  }
  std::sort(sides.begin(), sides.end());
  return sides;
}

// The sides of one cell, in the order of their corners.
template <typename Cells>
std::vector<SideOf<Cells>> BoundaryOf(const Cells& cells)
{
  const auto sides = SortedSides(
    cells, [](const SideOf<Cells>& side) { return std::make_pair(Undirected(side), side); });
  std::vector<SideOf<Cells>> boundary;
  for (std::size_t k = 0; k < sides.size(); ++k)
  {
    const bool isFirst = k == 0 || sides[k - 1].first != sides[k].first;
    const bool isLast = k + 1 == sides.size() || sides[k + 1].first != sides[k].first;
    if (isFirst && isLast)
    {
      boundary.push_back(sides[k].second);
    }
  }
  return boundary;
}

template <typename Side>
std::map<Side, std::size_t> LabelsBySide(
  const MeshFile& mesh, const std::vector<Side>& sides, const std::vector<std::size_t>& labels)
{
  std::map<Side, std::size_t> bySide;
  for (std::size_t k = 0; k < sides.size(); ++k)
  {
    bySide[Undirected(sides[k])] = labels[mesh.TagOfSide[k]];
  }
  return bySide;
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
  const auto& origin = mesh.Points[loop.front()];
  double area = 0.0;
  for (std::size_t k = 0; k < loop.size(); ++k)
  {
    const auto& a = mesh.Points[loop[k]];
    const auto& b = mesh.Points[loop[(k + 1) % loop.size()]];
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

// A name for what has no tag.
std::string NameOfUntagged(const MeshFile& mesh)
{
  std::string untagged = "boundary";
  while (std::any_of(mesh.Tags.begin(), mesh.Tags.end(),
    [&untagged](const MeshGroup& tag) { return tag.Name == untagged; }))
  {
    untagged += '_';
  }
  return untagged;
}

template <typename Cell>
void WriteCorners(int type, const Cell& cell, std::ostream& file)
{
  file << type;
  for (const Vertex corner : cell)
  {
    file << " " << corner;
  }
}

template <typename Sides, typename Cells>
void WriteMarkers(const MeshFile& mesh, const Sides& sides, const Cells& cells, std::ostream& file)
{
  std::vector<std::size_t> labels(mesh.Tags.size());
  std::iota(labels.begin(), labels.end(), 0);
  const auto bySide = LabelsBySide(mesh, sides, labels);
  std::map<std::size_t, Sides> markers;
  for (const auto& side : BoundaryOf(cells))
  {
    const auto found = bySide.find(Undirected(side));
    markers[found != bySide.end() ? found->second : mesh.Tags.size()].push_back(side);
  }
  file << "NMARK= " << markers.size() << "\n";
  for (const auto& marker : markers)
  {
    const bool isTagged = marker.first < mesh.Tags.size();
    file << "MARKER_TAG= " << (isTagged ? mesh.Tags[marker.first].Name : NameOfUntagged(mesh))
         << "\nMARKER_ELEMS= " << marker.second.size() << "\n";
    for (const auto& side : marker.second)
    {
      WriteCorners(TypesInSU2[DimensionOf(sides)], side, file);
      file << "\n";
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

std::size_t CountSidesOfNoCell(const MeshFile& mesh)
{
  return WithCells(mesh,
    [](const auto& sides, const auto& cells)
    {
      using Side = typename std::decay_t<decltype(sides)>::value_type;
      const auto all = SortedSides(cells, [](const Side& side) { return Undirected(side); });
      return static_cast<std::size_t>(std::count_if(sides.begin(), sides.end(),
        [&all](const Side& side)
        { return !std::binary_search(all.begin(), all.end(), Undirected(side)); }));
    });
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

std::size_t OrientTetrahedra(MeshFile& mesh)
{
  const auto at = [&mesh](Vertex vertex)
  {
    const auto& place = mesh.Points[vertex];
    return Point3{ place[0], place[1], place[2] };
  };
  int sign = 1;
  std::size_t count = 0;
  while (sign != 0 && count < mesh.Tetrahedra.size())
  {
    auto& corners = mesh.Tetrahedra[count];
    sign = Orient3D(at(corners[0]), at(corners[1]), at(corners[2]), at(corners[3]));
    if (sign < 0)
    {
      std::swap(corners[2], corners[3]);
    }
    count += sign != 0 ? 1 : 0;
  }
  return count;
}

bool IsBoundaryClosed(const MeshFile& mesh)
{
  return WithCells(mesh,
    [](const auto& /*sides*/, const auto& cells)
    {
      const auto all = SortedSides(cells, [](const auto& side) { return Directed(side); });
      return std::adjacent_find(all.begin(), all.end()) == all.end();
    });
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
  const std::map<Edge, std::size_t> byEdge = LabelsBySide(mesh, mesh.Edges, labels);
  std::multimap<Vertex, Vertex> edges; // by their beginning
  for (const Edge& edge : BoundaryOf(mesh.Triangles))
  {
    edges.emplace(edge[0], edge[1]);
  }
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
  WithCells(mesh,
    [&mesh, &file](const auto& sides, const auto& cells)
    {
      const int dimension = DimensionOf(cells);
      file << "NDIME= " << dimension << "\nNELEM= " << cells.size() << "\n";
      std::size_t number = 0;
      for (const auto& cell : cells)
      {
        WriteCorners(TypesInSU2[dimension], cell, file);
        file << " " << number++ << "\n";
      }
      file << "NPOIN= " << mesh.Points.size() << "\n";
      for (std::size_t vertex = 0; vertex < mesh.Points.size(); ++vertex)
      {
        for (int axis = 0; axis < dimension; ++axis)
        {
          file << mesh.Points[vertex][axis] << " ";
        }
        file << vertex << "\n";
      }
      WriteMarkers(mesh, sides, cells, file);
    });
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
