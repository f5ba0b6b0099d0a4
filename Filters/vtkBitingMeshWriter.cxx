// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkBitingMeshWriter.h"

#include "Bridge/CellShapes.h"
#include "Bridge/GhostArrays.h"
#include "Bridge/ProducedEdges.h"
#include "Bridge/ValueGroups.h"
#include "Bridge/WrittenParts.h"
#include "IO/MeshFile.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkCellTypes.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkErrorCode.h"
#include "vtkIdList.h"
#include "vtkInformation.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm> // for all_of, any_of, replace
#include <array>     // for places
#include <fstream>   // for files
#include <sstream>   // for words
#include <string>    // for names
#include <vector>    // for lists

VTK_ABI_NAMESPACE_BEGIN

namespace
{

// What the mesher itself adds to its boundary edges.
constexpr const char* OwnArrays[] = { "OriginalCellId", "Kind" };

std::string Text(const char* text)
{
  return text ? text : "";
}

//------------------------------------------------------------------------------
void ReadPoints(vtkDataSet* mesh, const biting::WrittenParts& parts, const std::string& depthArray,
  biting::MeshFile& file)
{
  vtkDataArray* depths = mesh->GetPointData()->GetArray(depthArray.c_str());
  for (const vtkIdType point : parts.Points())
  {
    std::array<double, 3> place;
    mesh->GetPoint(point, place.data());
    file.Points.push_back(place);
    if (depths)
    {
      file.Depths.push_back(depths->GetComponent(point, 0));
    }
  }
}

//------------------------------------------------------------------------------
void ReadTriangles(vtkDataSet* mesh, const biting::WrittenParts& parts, biting::MeshFile& file)
{
  vtkSmartPointer<vtkDataArray> regions = mesh->GetCellData()->GetArray("RegionId");
  if (!regions)
  {
    regions = vtkSmartPointer<vtkIntArray>::New();
    regions->SetNumberOfTuples(mesh->GetNumberOfCells());
    regions->Fill(0.0);
  }
  const biting::ValueGroups groups(regions);
  file.Regions = groups.Named(1, "Region ");
  vtkNew<vtkIdList> corners;
  for (const vtkIdType cell : parts.Cells())
  {
    if (mesh->GetCellType(cell) == VTK_TRIANGLE)
    {
      mesh->GetCellPoints(cell, corners);
      file.Triangles.push_back({ parts.NumberOf(corners->GetId(0)),
        parts.NumberOf(corners->GetId(1)), parts.NumberOf(corners->GetId(2)) });
      file.RegionOfTriangle.push_back(groups.IndexOf(cell));
    }
  }
}

//------------------------------------------------------------------------------
// What is said of the first cell that has no place in a file; empty where there is none.
std::string RefusalOfCells(vtkDataSet* mesh)
{
  using Shape = biting::CellShape;
  const biting::GhostArrays ghosts(mesh);
  vtkNew<vtkIdList> points;
  std::string refusal;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells() && refusal.empty(); ++cell)
  {
    mesh->GetCellPoints(cell, points);
    const vtkIdType size = points->GetNumberOfIds();
    const int type = mesh->GetCellType(cell);
    const Shape shape = biting::ShapeOf(type);
    refusal = biting::MissingPointText(
      "the mesh", cell, size, points->GetPointer(0), mesh->GetNumberOfPoints());
    if (refusal.empty() && type != VTK_TRIANGLE && shape != Shape::Nothing &&
      shape != Shape::Points && shape != Shape::Line &&
      !ghosts.LeaveOut(cell, size, points->GetPointer(0)))
    {
      refusal = "Cell " + std::to_string(cell) + " is a " +
        vtkCellTypes::GetClassNameFromTypeId(type) +
        "; only triangles are written (apply Extract Surface and Triangulate).";
    }
  }
  return refusal;
}

//------------------------------------------------------------------------------
vtkAbstractArray* FindTags(vtkCellData* data, const std::string& chosen)
{
  if (!chosen.empty())
  {
    return data->GetAbstractArray(chosen.c_str());
  }
  if (vtkAbstractArray* tags = data->GetAbstractArray("Tag"))
  {
    return tags;
  }
  for (int k = 0; k < data->GetNumberOfArrays(); ++k)
  {
    vtkAbstractArray* array = data->GetAbstractArray(k);
    const std::string name = Text(array->GetName());
    const bool isOwn = std::any_of(
      std::begin(OwnArrays), std::end(OwnArrays), [&name](const char* own) { return name == own; });
    if (!isOwn && array->GetNumberOfComponents() == 1)
    {
      return array;
    }
  }
  return data->GetAbstractArray("Kind");
}

//------------------------------------------------------------------------------
void ReadEdges(vtkPolyData* edges, const biting::WrittenParts& parts, vtkAbstractArray* tags,
  biting::MeshFile& file)
{
  vtkDataArray* ids = edges->GetPointData()->GetArray("MeshPointId");
  const biting::ValueGroups groups(tags);
  file.Tags = groups.Named(0, "");
  vtkNew<vtkIdList> ends;
  for (vtkIdType cell = 0; cell < edges->GetNumberOfCells(); ++cell)
  {
    edges->GetCellPoints(cell, ends);
    if (ends->GetNumberOfIds() == 2 && groups.Has(cell))
    {
      file.Edges.push_back({ parts.NumberOf(static_cast<vtkIdType>(ids->GetTuple1(ends->GetId(0)))),
        parts.NumberOf(static_cast<vtkIdType>(ids->GetTuple1(ends->GetId(1)))) });
      file.TagOfEdge.push_back(groups.IndexOf(cell));
    }
  }
}

//------------------------------------------------------------------------------
bool IsFlat(const biting::MeshFile& file)
{
  return std::all_of(file.Points.begin(), file.Points.end(),
    [&file](const std::array<double, 3>& point) { return point[2] == file.Points.front()[2]; });
}

//------------------------------------------------------------------------------
std::vector<std::string> Words(std::string text)
{
  std::replace(text.begin(), text.end(), ',', ' ');
  std::istringstream stream(text);
  std::vector<std::string> words;
  for (std::string word; stream >> word;)
  {
    words.push_back(word);
  }
  return words;
}

} // namespace

vtkStandardNewMacro(vtkBitingMeshWriter);

//------------------------------------------------------------------------------
vtkBitingMeshWriter::vtkBitingMeshWriter()
{
  this->SetNumberOfInputPorts(2);
  this->SetDepthArray("Depth");
}

//------------------------------------------------------------------------------
vtkBitingMeshWriter::~vtkBitingMeshWriter()
{
  this->SetFileName(nullptr);
  this->SetTagArray(nullptr);
  this->SetOpenTags(nullptr);
  this->SetDepthArray(nullptr);
}

//------------------------------------------------------------------------------
void vtkBitingMeshWriter::SetBoundaryEdgesConnection(vtkAlgorithmOutput* edges)
{
  this->SetInputConnection(1, edges);
}

//------------------------------------------------------------------------------
int vtkBitingMeshWriter::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkDataSet" : "vtkPolyData");
  if (port == 1)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

//------------------------------------------------------------------------------
// Those of port 1, else those of the filter from which the mesh comes; null where there is none.
vtkPolyData* vtkBitingMeshWriter::FindEdges()
{
  if (this->GetNumberOfInputConnections(1) > 0)
  {
    return vtkPolyData::SafeDownCast(this->GetInputDataObject(1, 0));
  }
  return biting::FindProducedEdges(this);
}

//------------------------------------------------------------------------------
void vtkBitingMeshWriter::Refuse(const std::string& reason)
{
  this->SetErrorCode(vtkErrorCode::UnknownError);
  vtkErrorMacro(<< reason);
}

//------------------------------------------------------------------------------
// Returns whether the tags could be read; no edges, no tags.
bool vtkBitingMeshWriter::ReadTags(
  vtkDataSet* mesh, const biting::WrittenParts& parts, biting::MeshFile& file)
{
  vtkPolyData* edges = this->FindEdges();
  if (!edges || !biting::AreEdgesOf(edges, mesh))
  {
    this->WarnOfEdges(edges);
    return true;
  }
  vtkAbstractArray* tags = FindTags(edges->GetCellData(), Text(this->TagArray));
  if (!tags)
  {
    this->Refuse("The boundary edges have no cell array named " + Text(this->TagArray) + ".");
    return false;
  }
  ReadEdges(edges, parts, tags, file);
  if (!biting::AreEdgesOfTriangles(file))
  {
    this->WarnOfEdges(edges);
    file.Edges.clear();
    file.TagOfEdge.clear();
    file.Tags.clear();
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkBitingMeshWriter::WarnOfEdges(vtkPolyData* edges)
{
  if (edges)
  {
    vtkWarningMacro("The boundary edges are not those of this mesh: it is written without tags.");
  }
}

//------------------------------------------------------------------------------
void vtkBitingMeshWriter::WriteData()
{
  vtkDataSet* mesh = vtkDataSet::SafeDownCast(this->GetInput());
  const std::string name = Text(this->FileName);
  const bool isGmsh = biting::EndsWith(name, ".msh");
  this->SetErrorCode(vtkErrorCode::NoError);
  if (!isGmsh && !biting::EndsWith(name, ".su2") && !biting::EndsWith(name, ".14"))
  {
    this->Refuse("The name of the file must end with .msh, .su2 or .14: " + name);
    return;
  }
  biting::MeshFile file;
  const std::string refusal = RefusalOfCells(mesh);
  if (!refusal.empty())
  {
    this->Refuse(refusal);
    return;
  }
  const biting::WrittenParts parts(mesh);
  ReadPoints(mesh, parts, Text(this->DepthArray), file);
  ReadTriangles(mesh, parts, file);
  if (file.Triangles.empty() || (!isGmsh && !IsFlat(file)))
  {
    this->Refuse(file.Triangles.empty()
        ? "There are no triangles to write."
        : "This format has two coordinates, and the mesh is not in a plane of constant z.");
  }
  else if (this->ReadTags(mesh, parts, file))
  {
    this->WriteFile(file);
  }
}

//------------------------------------------------------------------------------
void vtkBitingMeshWriter::WriteFile(const biting::MeshFile& file)
{
  const std::string name = Text(this->FileName);
  std::ofstream stream(name);
  if (biting::EndsWith(name, ".msh"))
  {
    biting::WriteGmsh(file, stream);
  }
  else if (biting::EndsWith(name, ".su2"))
  {
    biting::WriteSU2(file, stream);
  }
  else
  {
    biting::WriteADCIRC(file, Words(Text(this->OpenTags)), stream);
  }
  stream.close();
  if (!stream)
  {
    this->Refuse("The file could not be written: " + name);
  }
}

//------------------------------------------------------------------------------
void vtkBitingMeshWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << Text(this->FileName) << "\n"
     << indent << "TagArray: " << Text(this->TagArray) << "\n"
     << indent << "OpenTags: " << Text(this->OpenTags) << "\n"
     << indent << "DepthArray: " << Text(this->DepthArray) << "\n";
}

VTK_ABI_NAMESPACE_END
