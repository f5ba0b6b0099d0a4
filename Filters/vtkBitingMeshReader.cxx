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
#include "vtkUnstructuredGrid.h"

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
void MakeMesh(const MeshFile& file, vtkPointSet* mesh)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const std::array<double, 3>& place : file.Points)
  {
    points->InsertNextPoint(place.data());
  }
  mesh->SetPoints(points);
  if (auto* grid = vtkUnstructuredGrid::SafeDownCast(mesh))
  {
    grid->SetCells(VTK_TETRA, CellsOf(file.Tetrahedra));
  }
  if (auto* triangles = vtkPolyData::SafeDownCast(mesh))
  {
    triangles->SetPolys(CellsOf(file.Triangles));
  }
  const bool hasRegions = file.Regions.size() > 1 || file.Regions.front().Number > 0;
  AddGroups(mesh->GetCellData(), "RegionId", "RegionName", hasRegions ? -1 : 0, file.RegionOfCell,
    file.Regions);
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
// Lines or triangles between points of their own, which name those of the mesh.
template <std::size_t Size>
vtkSmartPointer<vtkCellArray> MakeSides(const MeshFile& file,
  std::vector<std::array<MeshFile::Vertex, Size>> sides, vtkPolyData* boundary)
{
  constexpr MeshFile::Vertex none = -1;
  std::vector<MeshFile::Vertex> own(file.Points.size(), none);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName("MeshPointId");
  for (auto& side : sides)
  {
    for (MeshFile::Vertex& end : side)
    {
      if (own[end] == none)
      {
        own[end] = points->InsertNextPoint(file.Points[end].data());
        ids->InsertNextValue(static_cast<vtkIdType>(end));
      }
      end = own[end];
    }
  }
  boundary->SetPoints(points);
  boundary->GetPointData()->AddArray(ids);
  AddGroups(boundary->GetCellData(), "Tag", "TagName", 0, file.TagOfSide, file.Tags);
  return CellsOf(sides);
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
int vtkBitingMeshReader::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == MESH ? "vtkPointSet" : "vtkPolyData");
  return 1;
}

//------------------------------------------------------------------------------
void vtkBitingMeshReader::ReadFile()
{
  this->File = std::make_unique<std::pair<MeshFile, ReadingResult>>();
  auto& [mesh, result] = *this->File;
  result = ::ReadFile(this->FileName ? this->FileName : "", mesh);
  if (!result.Reason.empty())
  {
    mesh = MeshFile();
  }
}

//------------------------------------------------------------------------------
int vtkBitingMeshReader::RequestDataObject(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inputVector), vtkInformationVector* outputVector)
{
  this->ReadFile();
  vtkSmartPointer<vtkPointSet> mesh = vtkSmartPointer<vtkPolyData>::New();
  if (this->File->first.IsSolid())
  {
    mesh = vtkSmartPointer<vtkUnstructuredGrid>::New();
  }
  const vtkNew<vtkPolyData> boundary;
  outputVector->GetInformationObject(MESH)->Set(vtkDataObject::DATA_OBJECT(), mesh);
  outputVector->GetInformationObject(BOUNDARY_EDGES)->Set(vtkDataObject::DATA_OBJECT(), boundary);
  return 1;
}

//------------------------------------------------------------------------------
int vtkBitingMeshReader::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inputVector), vtkInformationVector* outputVector)
{
  if (!this->File) // as where the outputs were released
  {
    this->ReadFile();
  }
  const auto reading = std::move(this->File);
  const auto& [file, result] = *reading;
  vtkPointSet* mesh = vtkPointSet::GetData(outputVector, MESH);
  const bool isAsBefore = file.IsSolid() == (vtkUnstructuredGrid::SafeDownCast(mesh) != nullptr);
  if (!result.Reason.empty() || !isAsBefore)
  {
    vtkErrorMacro("No mesh in " << (this->FileName ? this->FileName : "") << ". "
                                << (isAsBefore ? result.Reason
                                               : "It has other cells than before: open it again."));
    return 1;
  }
  for (const std::string& remark : result.Remarks)
  {
    vtkWarningMacro(<< this->FileName << ": " << remark);
  }
  vtkPolyData* boundary = vtkPolyData::GetData(outputVector, BOUNDARY_EDGES);
  MakeMesh(file, mesh);
  file.IsSolid() ? boundary->SetPolys(MakeSides(file, file.Triangles, boundary))
                 : boundary->SetLines(MakeSides(file, file.Edges, boundary));
  return 1;
}

//------------------------------------------------------------------------------
void vtkBitingMeshReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "") << "\n";
}

VTK_ABI_NAMESPACE_END
