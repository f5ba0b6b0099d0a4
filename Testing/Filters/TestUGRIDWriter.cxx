// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "FilterTesting.h"

#include "vtkBitingMeshWriter.h"

#include "vtkCell.h"
#include "vtkStringArray.h"
#include "vtk_netcdf.h"

#include <gtest/gtest.h>

#include <cstdio>     // for remove
#include <filesystem> // for the folder of files
#include <map>        // for tags of edges

using namespace testing_filters;

namespace
{

/// A file read by the library.
class File
{
public:
  explicit File(const std::string& path) { EXPECT_EQ(nc_open(path.c_str(), 0, &this->Id), 0); }
  File(const File&) = delete;
  File& operator=(const File&) = delete;
  ~File() { nc_close(this->Id); }

  int Format() const
  {
    int format = 0;
    nc_inq_format(this->Id, &format);
    return format;
  }

  std::string Text(const char* variable, const char* attribute) const
  {
    std::size_t size = 0;
    EXPECT_EQ(nc_inq_attlen(this->Id, this->Variable(variable), attribute, &size), 0) << attribute;
    std::string text(size, ' ');
    nc_get_att_text(this->Id, this->Variable(variable), attribute, text.data());
    return text;
  }

  std::vector<int> Numbers(const char* variable, const char* attribute) const
  {
    std::size_t size = 0;
    EXPECT_EQ(nc_inq_attlen(this->Id, this->Variable(variable), attribute, &size), 0) << attribute;
    std::vector<int> numbers(size);
    nc_get_att_int(this->Id, this->Variable(variable), attribute, numbers.data());
    return numbers;
  }

  bool Has(const char* name) const
  {
    int variable = 0;
    return nc_inq_varid(this->Id, name, &variable) == 0;
  }

  std::vector<double> Values(const char* name) const
  {
    int rank = 0;
    int dimensions[2]{};
    EXPECT_EQ(
      nc_inq_var(this->Id, this->Variable(name), nullptr, nullptr, &rank, dimensions, nullptr), 0);
    std::size_t size = 1;
    for (int k = 0; k < rank; ++k)
    {
      std::size_t length = 0;
      nc_inq_dimlen(this->Id, dimensions[k], &length);
      size *= length;
    }
    std::vector<double> values(size);
    EXPECT_EQ(nc_get_var_double(this->Id, this->Variable(name), values.data()), 0);
    return values;
  }

private:
  int Variable(const char* name) const
  {
    int variable = NC_GLOBAL;
    EXPECT_TRUE(!*name || nc_inq_varid(this->Id, name, &variable) == 0) << name;
    return variable;
  }

  int Id = -1;
};

/// The mesh of a square that a line divides; sides and line have tags, one has none.
class UGRIDWriter : public testing::Test
{
protected:
  void SetUp() override
  {
    auto input = EmptyInput();
    AddChain(input, { { 0, 0, 0 }, { 2, 0, 0 } }, false);
    AddChain(input, { { 2, 0, 0 }, { 2, 1, 0 } }, false);
    AddChain(input, { { 2, 1, 0 }, { 0, 1, 0 } }, false);
    AddChain(input, { { 0, 1, 0 }, { 0, 0, 0 } }, false);
    AddChain(input, { { 1, 0, 0 }, { 1, 1, 0 } }, false);
    vtkNew<vtkStringArray> tags;
    tags->SetName("Tag");
    for (const char* tag : { "open sea", "land", "", "land", "weir" })
    {
      tags->InsertNextValue(tag);
    }
    input->GetCellData()->AddArray(tags);
    this->Mesher->SetInputData(input);
    this->Mesher->SetUniformSpacing(0.3);
    this->Mesher->Update();
    this->Mesh->ShallowCopy(this->Mesher->GetOutput());
  }

  void TearDown() override { std::remove(this->Path.c_str()); }

  void Write(int coordinates = vtkBitingMeshWriter::PLANE)
  {
    vtkNew<vtkBitingMeshWriter> writer;
    writer->SetFileName(this->Path.c_str());
    writer->SetCoordinates(coordinates);
    writer->SetInputData(this->Mesh);
    writer->SetBoundaryEdgesConnection(this->Mesher->GetOutputPort(1));
    writer->Write();
  }

  const std::string Path = (std::filesystem::temp_directory_path() /
    ("biting_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()) +
      ".nc"))
                             .string();
  vtkNew<vtkBitingMesher> Mesher;
  vtkNew<vtkPolyData> Mesh;
};

} // namespace

TEST_F(UGRIDWriter, NamesTheTopologyByTheConventions)
{
  this->Write();
  const File file(this->Path);
  EXPECT_EQ(file.Format(), NC_FORMAT_64BIT_OFFSET);
  EXPECT_EQ(file.Text("", "Conventions"), "CF-1.8 UGRID-1.0");
  EXPECT_EQ(file.Text("mesh2d", "cf_role"), "mesh_topology");
  EXPECT_EQ(file.Numbers("mesh2d", "topology_dimension"), std::vector<int>{ 2 });
  EXPECT_EQ(file.Text("mesh2d", "node_coordinates"), "mesh2d_node_x mesh2d_node_y");
  for (const std::string role : { "face", "edge", "boundary" })
  {
    const std::string nodes = file.Text("mesh2d", (role + "_node_connectivity").c_str());
    EXPECT_EQ(file.Text(nodes.c_str(), "cf_role"), role + "_node_connectivity");
    EXPECT_EQ(file.Numbers(nodes.c_str(), "start_index"), std::vector<int>{ 0 });
  }
  EXPECT_EQ(file.Text("mesh2d_face_region", "location"), "face");
  EXPECT_EQ(file.Text("mesh2d_edge_tag", "location"), "edge");
}

TEST_F(UGRIDWriter, HasTheSamePointsTrianglesRegionsAndDepths)
{
  std::vector<double> depths;
  for (vtkIdType point = 0; point < this->Mesh->GetNumberOfPoints(); ++point)
  {
    depths.push_back(1.0 / (3.0 + double(point)));
  }
  AddArray<vtkDoubleArray>(this->Mesh->GetPointData(), "Depth", depths);
  this->Write();
  const File file(this->Path);
  EXPECT_EQ(file.Values("mesh2d_node_depth"), depths);
  EXPECT_EQ(file.Text("mesh2d_node_depth", "location"), "node");
  const auto x = file.Values("mesh2d_node_x");
  const auto y = file.Values("mesh2d_node_y");
  ASSERT_EQ(x.size(), depths.size());
  for (std::size_t point = 0; point < x.size(); ++point)
  {
    const Place place = PointOf(this->Mesh, vtkIdType(point));
    EXPECT_TRUE(x[point] == place[0] && y[point] == place[1]);
  }
  const auto corners = file.Values("mesh2d_face_nodes");
  const auto regions = file.Values("mesh2d_face_region");
  ASSERT_EQ(regions.size(), std::size_t(this->Mesh->GetNumberOfCells()));
  for (vtkIdType cell = 0; cell < this->Mesh->GetNumberOfCells(); ++cell)
  {
    for (int k = 0; k < 3; ++k)
    {
      EXPECT_EQ(corners[std::size_t(3 * cell + k)], this->Mesh->GetCell(cell)->GetPointId(k));
    }
    EXPECT_EQ(regions[std::size_t(cell)],
      this->Mesh->GetCellData()->GetArray("RegionId")->GetComponent(cell, 0) + 1);
  }
  EXPECT_EQ(file.Numbers("mesh2d_face_region", "flag_values"), (std::vector<int>{ 1, 2 }));
}

// By Euler's formula a disk of f triangles and v vertices has v + f - 1 edges, 2 v - f - 2 of them
// on the boundary.
TEST_F(UGRIDWriter, HasAllEdgesWithTheirTagsAndTheBoundaryWithTheDomainOnItsLeft)
{
  this->Write();
  const File file(this->Path);
  const auto x = file.Values("mesh2d_node_x");
  const auto y = file.Values("mesh2d_node_y");
  const auto edges = file.Values("mesh2d_edge_nodes");
  const auto tags = file.Values("mesh2d_edge_tag");
  const std::size_t faces = file.Values("mesh2d_face_region").size();
  EXPECT_EQ(tags.size(), x.size() + faces - 1);
  EXPECT_EQ(file.Text("mesh2d_edge_tag", "flag_meanings"), "land open_sea weir");
  EXPECT_EQ(file.Numbers("mesh2d_edge_tag", "flag_values"), (std::vector<int>{ 1, 2, 3 }));
  std::map<double, double> lengths;
  for (std::size_t edge = 0; edge < tags.size(); ++edge)
  {
    const auto a = std::size_t(edges[2 * edge]);
    const auto b = std::size_t(edges[2 * edge + 1]);
    lengths[tags[edge]] += std::hypot(x[b] - x[a], y[b] - y[a]);
  }
  EXPECT_NEAR(lengths[1.0], 2.0, 1e-12);
  EXPECT_NEAR(lengths[2.0], 2.0, 1e-12);
  EXPECT_NEAR(lengths[3.0], 1.0, 1e-12);
  const auto boundary = file.Values("mesh2d_boundary_nodes");
  EXPECT_EQ(boundary.size() / 2, 2 * x.size() - faces - 2);
  double area = 0.0;
  for (std::size_t k = 0; k < boundary.size(); k += 2)
  {
    const auto a = std::size_t(boundary[k]);
    const auto b = std::size_t(boundary[k + 1]);
    area += 0.5 * (x[a] * y[b] - x[b] * y[a]);
  }
  EXPECT_NEAR(area, 2.0, 1e-12);
}

TEST_F(UGRIDWriter, NamesLongitudeAndLatitudeAndHasNoDepthsWhereThereAreNone)
{
  this->Write();
  EXPECT_EQ(File(this->Path).Text("mesh2d_node_x", "standard_name"), "projection_x_coordinate");
  EXPECT_EQ(File(this->Path).Text("mesh2d_node_y", "units"), "m");
  EXPECT_FALSE(File(this->Path).Has("mesh2d_node_depth"));
  this->Write(vtkBitingMeshWriter::LONGITUDE_LATITUDE);
  EXPECT_EQ(File(this->Path).Text("mesh2d_node_x", "standard_name"), "longitude");
  EXPECT_EQ(File(this->Path).Text("mesh2d_node_y", "standard_name"), "latitude");
  EXPECT_EQ(File(this->Path).Text("mesh2d_node_y", "units"), "degrees_north");
}
