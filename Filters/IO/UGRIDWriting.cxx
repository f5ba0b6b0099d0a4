// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "MeshFile.h"

#include "vtk_netcdf.h"
#if VTK_MODULE_USE_EXTERNAL_vtknetcdf
#include <netcdf_mem.h>
#else
#include <vtknetcdf/include/netcdf_mem.h>
#endif

#include <algorithm> // for sort, lower_bound
#include <cctype>    // for blanks
#include <cstdlib>   // for free
#include <iterator>  // for back_inserter
#include <utility>   // for pair

namespace biting
{

namespace
{

using Pair = std::array<int, 2>;
using Attributes = std::vector<std::pair<const char*, std::string>>;

constexpr const char* MeshName = "mesh2d";

/// A NetCDF file of the classic model with 64-bit offsets, made in memory. After an error nothing
/// more is done.
class NetCDFFile
{
public:
  NetCDFFile()
    : Status(nc_create_mem(MeshName, NC_64BIT_OFFSET, 0, &this->File))
  {
  }

  NetCDFFile(const NetCDFFile&) = delete;
  NetCDFFile& operator=(const NetCDFFile&) = delete;

  ~NetCDFFile()
  {
    if (this->File >= 0)
    {
      nc_abort(this->File);
    }
  }

  /// Calls a function of the library, whose first argument is the file.
  template <typename Function, typename... Arguments>
  void Do(Function function, Arguments... arguments)
  {
    if (this->Status == NC_NOERR)
    {
      this->Status = function(this->File, arguments...);
    }
  }

  int AddDimension(const char* name, std::size_t size)
  {
    int dimension = -1;
    this->Do(nc_def_dim, name, size, &dimension);
    return dimension;
  }

  int AddVariable(const char* name, nc_type type, const std::vector<int>& dimensions,
    const Attributes& attributes)
  {
    int variable = -1;
    this->Do(
      nc_def_var, name, type, static_cast<int>(dimensions.size()), dimensions.data(), &variable);
    this->AddTexts(variable, attributes);
    return variable;
  }

  void AddTexts(int variable, const Attributes& attributes)
  {
    for (const auto& [name, text] : attributes)
    {
      this->Do(nc_put_att_text, variable, name, text.size(), text.c_str());
    }
  }

  void AddNumbers(int variable, const char* name, const std::vector<int>& numbers)
  {
    this->Do(nc_put_att_int, variable, name, NC_INT, numbers.size(), numbers.data());
  }

  /// The stream fails where anything has failed.
  void Write(std::ostream& file)
  {
    NC_memio memory{};
    this->Do(nc_close_memio, &memory);
    if (this->Status != NC_NOERR)
    {
      file.setstate(std::ios::failbit);
      return;
    }
    this->File = -1;
    file.write(static_cast<const char*>(memory.memory), static_cast<std::streamsize>(memory.size));
    std::free(memory.memory);
  }

private:
  int File = -1;
  int Status;
};

/// All sides of triangles, each once.
struct Sides
{
  std::vector<Pair> Edges;    // the smaller vertex first, in order
  std::vector<int> Tags;      // their numbers; 0: none
  std::vector<Pair> Boundary; // the edges of one triangle, with it on their left
};

Sides SidesOf(const MeshFile& mesh)
{
  std::vector<std::pair<Pair, Pair>> all; // sorted, as in the triangle
  all.reserve(3 * mesh.Triangles.size());
  for (const auto& triangle : mesh.Triangles)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Pair side{ static_cast<int>(triangle[k]), static_cast<int>(triangle[(k + 1) % 3]) };
      all.push_back({ { std::min(side[0], side[1]), std::max(side[0], side[1]) }, side });
    }
  }
  std::sort(all.begin(), all.end());
  Sides sides;
  for (std::size_t k = 0; k < all.size(); ++k)
  {
    const bool isFirst = k == 0 || all[k - 1].first != all[k].first;
    const bool isLast = k + 1 == all.size() || all[k + 1].first != all[k].first;
    if (isFirst)
    {
      sides.Edges.push_back(all[k].first);
    }
    if (isFirst && isLast)
    {
      sides.Boundary.push_back(all[k].second);
    }
  }
  sides.Tags.assign(sides.Edges.size(), 0);
  for (std::size_t k = 0; k < mesh.Edges.size(); ++k)
  {
    const auto [low, high] = std::minmax(mesh.Edges[k][0], mesh.Edges[k][1]);
    const Pair edge{ static_cast<int>(low), static_cast<int>(high) };
    const auto found = std::lower_bound(sides.Edges.begin(), sides.Edges.end(), edge);
    sides.Tags[found - sides.Edges.begin()] = static_cast<int>(mesh.Tags[mesh.TagOfSide[k]].Number);
  }
  return sides;
}

/// The values and their names, in which blanks are '_': they part the names.
void AddGroups(NetCDFFile& out, int variable, const std::vector<MeshGroup>& groups)
{
  std::vector<int> values;
  std::string meanings;
  for (const MeshGroup& group : groups)
  {
    values.push_back(static_cast<int>(group.Number));
    const std::string name = group.Name.empty() ? std::to_string(group.Number) : group.Name;
    meanings += meanings.empty() ? "" : " ";
    std::transform(name.begin(), name.end(), std::back_inserter(meanings),
      [](unsigned char sign) { return std::isspace(sign) ? '_' : static_cast<char>(sign); });
  }
  if (!groups.empty())
  {
    out.AddNumbers(variable, "flag_values", values);
    out.AddTexts(variable, { { "flag_meanings", meanings } });
  }
}

Attributes DataOf(const std::string& location, const std::string& longName)
{
  return { { "long_name", longName }, { "mesh", MeshName }, { "location", location } };
}

/// Two coordinates of the vertices, and their depths, where there are any.
std::vector<int> AddNodes(NetCDFFile& out, const MeshFile& mesh, int nodes)
{
  const auto addCoordinate = [&out, nodes](
                               const char* name, const char* standardName, const char* units)
  {
    return out.AddVariable(name, NC_DOUBLE, { nodes },
      { { "standard_name", standardName }, { "long_name", standardName }, { "units", units } });
  };
  std::vector<int> variables = mesh.AreDegrees
    ? std::vector<int>{ addCoordinate("mesh2d_node_x", "longitude", "degrees_east"),
        addCoordinate("mesh2d_node_y", "latitude", "degrees_north") }
    : std::vector<int>{ addCoordinate("mesh2d_node_x", "projection_x_coordinate", "m"),
        addCoordinate("mesh2d_node_y", "projection_y_coordinate", "m") };
  if (!mesh.Depths.empty())
  {
    Attributes attributes = DataOf("node", "depth of nodes, positive downwards");
    attributes.insert(attributes.end(), { { "units", "m" }, { "positive", "down" } });
    variables.push_back(out.AddVariable("mesh2d_node_depth", NC_DOUBLE, { nodes }, attributes));
  }
  return variables;
}

int AddConnectivity(
  NetCDFFile& out, const std::string& role, const char* name, const std::vector<int>& dimensions)
{
  const int variable = out.AddVariable(name, NC_INT, dimensions,
    { { "cf_role", role + "_node_connectivity" }, { "long_name", "nodes of each " + role } });
  out.AddNumbers(variable, "start_index", { 0 });
  return variable;
}

void PutNodes(NetCDFFile& out, const MeshFile& mesh, const std::vector<int>& variables)
{
  std::vector<double> values(mesh.Points.size());
  for (const std::size_t k : { 0, 1 })
  {
    std::transform(mesh.Points.begin(), mesh.Points.end(), values.begin(),
      [k](const std::array<double, 3>& point) { return point[k]; });
    out.Do(nc_put_var_double, variables[k], values.data());
  }
  if (!mesh.Depths.empty())
  {
    out.Do(nc_put_var_double, variables[2], mesh.Depths.data());
  }
}

void PutFaces(NetCDFFile& out, const MeshFile& mesh, int faceNodes, int regions)
{
  std::vector<int> corners;
  std::vector<int> numbers;
  corners.reserve(3 * mesh.Triangles.size());
  numbers.reserve(mesh.Triangles.size());
  for (std::size_t k = 0; k < mesh.Triangles.size(); ++k)
  {
    corners.insert(corners.end(), mesh.Triangles[k].begin(), mesh.Triangles[k].end());
    numbers.push_back(static_cast<int>(mesh.Regions[mesh.RegionOfCell[k]].Number));
  }
  out.Do(nc_put_var_int, faceNodes, corners.data());
  out.Do(nc_put_var_int, regions, numbers.data());
}

} // namespace

void WriteUGRID(const MeshFile& mesh, std::ostream& file)
{
  if (mesh.Triangles.empty() || mesh.Points.size() > std::numeric_limits<int>::max())
  {
    file.setstate(std::ios::failbit);
    return;
  }
  const Sides sides = SidesOf(mesh);
  NetCDFFile out;
  out.AddTexts(NC_GLOBAL, { { "Conventions", "CF-1.8 UGRID-1.0" } });
  const int nodes = out.AddDimension("mesh2d_nNodes", mesh.Points.size());
  const int faces = out.AddDimension("mesh2d_nFaces", mesh.Triangles.size());
  const int edges = out.AddDimension("mesh2d_nEdges", sides.Edges.size());
  const int boundary = out.AddDimension("mesh2d_nBoundaries", sides.Boundary.size());
  const int two = out.AddDimension("Two", 2);
  const int three = out.AddDimension("Three", 3);
  const int topology = out.AddVariable(MeshName, NC_INT, {},
    { { "cf_role", "mesh_topology" }, { "long_name", "triangles of the mesh" },
      { "node_coordinates", "mesh2d_node_x mesh2d_node_y" },
      { "face_node_connectivity", "mesh2d_face_nodes" }, { "face_dimension", "mesh2d_nFaces" },
      { "edge_node_connectivity", "mesh2d_edge_nodes" }, { "edge_dimension", "mesh2d_nEdges" },
      { "boundary_node_connectivity", "mesh2d_boundary_nodes" } });
  out.AddNumbers(topology, "topology_dimension", { 2 });
  const std::vector<int> ofNodes = AddNodes(out, mesh, nodes);
  const int faceNodes = AddConnectivity(out, "face", "mesh2d_face_nodes", { faces, three });
  const int edgeNodes = AddConnectivity(out, "edge", "mesh2d_edge_nodes", { edges, two });
  const int boundaryNodes =
    AddConnectivity(out, "boundary", "mesh2d_boundary_nodes", { boundary, two });
  const int regions =
    out.AddVariable("mesh2d_face_region", NC_INT, { faces }, DataOf("face", "region of faces"));
  AddGroups(out, regions, mesh.Regions);
  const int tags = out.AddVariable(
    "mesh2d_edge_tag", NC_INT, { edges }, DataOf("edge", "tag of edges, 0 where there is none"));
  AddGroups(out, tags, mesh.Tags);
  out.Do(nc_enddef);
  PutNodes(out, mesh, ofNodes);
  PutFaces(out, mesh, faceNodes, regions);
  out.Do(nc_put_var_int, edgeNodes, sides.Edges.front().data());
  out.Do(nc_put_var_int, boundaryNodes, sides.Boundary.front().data());
  out.Do(nc_put_var_int, tags, sides.Tags.data());
  out.Write(file);
}

} // namespace biting
