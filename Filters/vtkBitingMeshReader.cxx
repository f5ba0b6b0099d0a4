// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkBitingMeshReader.h"

#include "IO/MeshFile.h"
#include "IO/MeshFormat.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"

#include <algorithm> // for any_of
#include <array>     // for cells
#include <fstream>   // for files
#include <string>    // for names
#include <vector>    // for lists

VTK_ABI_NAMESPACE_BEGIN

namespace
{

using biting::MeshFile;
using biting::MeshGroup;
using biting::ReadingResult;

//------------------------------------------------------------------------------
ReadingResult ReadFile(const std::string& name, MeshFile& file)
{
  std::ifstream stream(name);
  if (!stream)
  {
    return { "The file could not be opened.", {} };
  }
  const biting::MeshFormat* format = biting::FormatOf(name);
  return format && format->Read ? format->Read(stream, file)
                                : ReadingResult{ biting::SentenceOfEnds(true), {} };
}

//------------------------------------------------------------------------------
template <std::size_t Size>
vtkSmartPointer<vtkCellArray> CellsOf(const std::vector<std::array<MeshFile::Vertex, Size>>& all)
{
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  for (const auto& corners : all)
  {
    cells->InsertNextCell(static_cast<int>(Size));
    for (const MeshFile::Vertex corner : corners)
    {
      cells->InsertCellPoint(static_cast<vtkIdType>(corner));
    }
  }
  return cells;
}

//------------------------------------------------------------------------------
// The numbers of the groups of cells plus `shift`; and their names, where there are any.
void AddGroups(vtkCellData* data, const char* number, const char* name, int shift,
  const std::vector<std::size_t>& ofCells, const std::vector<MeshGroup>& groups)
{
  vtkNew<vtkIntArray> numbers;
  numbers->SetName(number);
  vtkNew<vtkStringArray> names;
  names->SetName(name);
  for (const std::size_t group : ofCells)
  {
    numbers->InsertNextValue(static_cast<int>(groups[group].Number) + shift);
    names->InsertNextValue(groups[group].Name);
  }
  data->AddArray(numbers);
  const bool haveNames = std::any_of(
    groups.begin(), groups.end(), [](const MeshGroup& group) { return !group.Name.empty(); });
  if (haveNames)
  {
    data->AddArray(names);
  }
}

//------------------------------------------------------------------------------
void MakeMesh(const MeshFile& file, vtkPolyData* mesh)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const std::array<double, 3>& place : file.Points)
  {
    points->InsertNextPoint(place.data());
  }
  mesh->SetPoints(points);
  mesh->SetPolys(CellsOf(file.Triangles));
  const bool hasRegions = file.Regions.size() > 1 || file.Regions.front().Number > 0;
  AddGroups(mesh->GetCellData(), "RegionId", "RegionName", hasRegions ? -1 : 0,
    file.RegionOfTriangle, file.Regions);
  if (!file.Depths.empty())
  {
    vtkNew<vtkDoubleArray> depths;
    depths->SetName("Depth");
    for (const double depth : file.Depths)
    {
      depths->InsertNextValue(depth);
    }
    mesh->GetPointData()->AddArray(depths);
  }
}

//------------------------------------------------------------------------------
// Lines between points of their own, which name those of the mesh.
void MakeEdges(const MeshFile& file, vtkPolyData* edges)
{
  constexpr MeshFile::Vertex none = -1;
  std::vector<MeshFile::Vertex> own(file.Points.size(), none);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName("MeshPointId");
  std::vector<std::array<MeshFile::Vertex, 2>> lines = file.Edges;
  for (auto& line : lines)
  {
    for (MeshFile::Vertex& end : line)
    {
      const auto vertex = static_cast<std::size_t>(end);
      if (own[vertex] == none)
      {
        own[vertex] = points->InsertNextPoint(file.Points[vertex].data());
        ids->InsertNextValue(static_cast<vtkIdType>(end));
      }
      end = own[vertex];
    }
  }
  edges->SetPoints(points);
  edges->SetLines(CellsOf(lines));
  edges->GetPointData()->AddArray(ids);
  AddGroups(edges->GetCellData(), "Tag", "TagName", 0, file.TagOfEdge, file.Tags);
}

} // namespace

vtkStandardNewMacro(vtkBitingMeshReader);

//------------------------------------------------------------------------------
vtkBitingMeshReader::vtkBitingMeshReader()
{
  this->SetNumberOfInputPorts(0);
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
vtkBitingMeshReader::~vtkBitingMeshReader()
{
  this->SetFileName(nullptr);
}

//------------------------------------------------------------------------------
int vtkBitingMeshReader::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inputVector), vtkInformationVector* outputVector)
{
  const std::string name = this->FileName ? this->FileName : "";
  MeshFile file;
  const ReadingResult result = ReadFile(name, file);
  if (!result.Reason.empty())
  {
    vtkErrorMacro("No mesh in " << name << ". " << result.Reason);
    return 1;
  }
  for (const std::string& remark : result.Remarks)
  {
    vtkWarningMacro(<< name << ": " << remark);
  }
  MakeMesh(file, vtkPolyData::GetData(outputVector, MESH));
  MakeEdges(file, vtkPolyData::GetData(outputVector, BOUNDARY_EDGES));
  return 1;
}

//------------------------------------------------------------------------------
void vtkBitingMeshReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "") << "\n";
}

VTK_ABI_NAMESPACE_END
