// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkBitingMeshWriter.h"

#include "Bridge/Drawing/RemeshInputFromDataSet.h"
#include "Bridge/Mesh/MeshFileFromDataSet.h"
#include "Bridge/Ranks/Ranks.h"
#include "IO/MeshFile.h"
#include "IO/MeshFormat.h"

#include "vtkDataSet.h"
#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <filesystem>   // for files in place of others
#include <fstream>      // for files
#include <string>       // for names
#include <system_error> // for files that could not be moved
#include <vector>       // for lists

VTK_ABI_NAMESPACE_BEGIN

namespace
{

std::string Text(const char* text)
{
  return text ? text : "";
}

} // namespace

vtkStandardNewMacro(vtkBitingMeshWriter);

//------------------------------------------------------------------------------
vtkBitingMeshWriter::vtkBitingMeshWriter()
{
  this->SetNumberOfInputPorts(2);
  this->SetDepthArray(biting::DefaultDepths);
}

//------------------------------------------------------------------------------
vtkBitingMeshWriter::~vtkBitingMeshWriter()
{
  this->SetFileName(nullptr);
  this->SetTagArray(nullptr);
  this->SetRegionArray(nullptr);
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
biting::Ranks vtkBitingMeshWriter::WritingRanks() const
{
  return this->GatherPieces ? biting::Ranks::All() : biting::Ranks();
}

//------------------------------------------------------------------------------
vtkTypeBool vtkBitingMeshWriter::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const biting::Ranks ranks = this->WritingRanks();
  const bool areAsked =
    request->Has(vtkStreamingDemandDrivenPipeline::REQUEST_UPDATE_EXTENT()) && ranks.AreSeveral();
  for (int port = 0; areAsked && port < this->GetNumberOfInputPorts(); ++port)
  {
    for (int k = 0; k < inputVector[port]->GetNumberOfInformationObjects(); ++k)
    {
      ranks.AskForOwn(inputVector[port]->GetInformationObject(k));
    }
  }
  return this->Superclass::ProcessRequest(request, inputVector, outputVector);
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
// Returns why the tags could not be read, empty where they could; no edges, no tags.
std::string vtkBitingMeshWriter::ReadTags(
  vtkDataSet* mesh, vtkPolyData* edges, const biting::WrittenParts& parts, biting::MeshFile& file)
{
  if (!edges || !biting::AreEdgesOf(edges, mesh))
  {
    this->WarnOfEdges(edges);
    return {};
  }
  vtkSmartPointer<vtkAbstractArray> tags =
    biting::FindTags(edges->GetCellData(), Text(this->TagArray));
  if (!tags && !Text(this->TagArray).empty())
  {
    return "The boundary has no cell array named " + Text(this->TagArray) + ".";
  }
  if (!tags)
  {
    tags = biting::OneTag(edges->GetNumberOfCells());
  }
  const biting::ValueGroups groups(tags);
  file.Tags = groups.Named(0, "", biting::EndsOfNames);
  biting::ReadSides(edges, parts, groups, file);
  if (biting::CountSidesOfNoCell(file) > 0)
  {
    this->WarnOfEdges(edges);
    file.IsSolid() ? file.Triangles.clear() : file.Edges.clear();
    file.TagOfSide.clear();
    file.Tags.clear();
  }
  else if (biting::FormatOf(Text(this->FileName))->HasPlainNames)
  {
    this->TakeNames(groups.Named(0, "", biting::EndsOfNamesInSU2), file);
  }
  return {};
}

//------------------------------------------------------------------------------
// Tags with blanks and the like are markers of other names, which is said.
void vtkBitingMeshWriter::TakeNames(
  const std::vector<biting::MeshGroup>& names, biting::MeshFile& file)
{
  for (std::size_t tag = 0; tag < names.size(); ++tag)
  {
    if (names[tag].Name != file.Tags[tag].Name)
    {
      vtkWarningMacro("The tag \"" << file.Tags[tag].Name << "\" is the marker " << names[tag].Name
                                   << ": names in SU2 have no blanks, signs "
                                   << "of percent or equality, commas or parentheses.");
    }
  }
  file.Tags = names;
}

//------------------------------------------------------------------------------
void vtkBitingMeshWriter::WarnOfEdges(vtkPolyData* edges)
{
  if (edges)
  {
    vtkWarningMacro(
      "The boundary edges or triangles are not sides of this mesh: it is written without tags.");
  }
}

//------------------------------------------------------------------------------
void vtkBitingMeshWriter::WriteData()
{
  const biting::Ranks ranks = this->WritingRanks();
  vtkPolyData* own = this->FindEdges();
  const vtkNew<vtkPolyData> none;
  const biting::WholeInput mesh(ranks, this->GetInput());
  const biting::WholeInput edges(ranks, own ? own : none.Get());
  this->SetErrorCode(vtkErrorCode::NoError);
  if (ranks.IsFirst() && !(mesh.IsComplete() && edges.IsComplete()))
  {
    this->Refuse(biting::NotGathered);
  }
  else if (ranks.IsFirst())
  {
    const auto whole = mesh.Make();
    const auto wholeEdges = edges.Make();
    const std::string refusal = this->WriteMesh(
      vtkDataSet::SafeDownCast(whole), own ? vtkPolyData::SafeDownCast(wholeEdges) : nullptr);
    if (!refusal.empty())
    {
      this->Refuse(refusal);
    }
  }
  this->SetErrorCode(ranks.ShareCode(this->GetErrorCode()));
}

//------------------------------------------------------------------------------
// Returns why there is no file, empty where there is one.
std::string vtkBitingMeshWriter::WriteMesh(vtkDataSet* mesh, vtkPolyData* edges)
{
  const std::string name = Text(this->FileName);
  const biting::MeshFormat* format = biting::FormatOf(name);
  if (!format)
  {
    return biting::SentenceOfEnds(false) + " It is " + name;
  }
  if (!mesh)
  {
    return "There is no mesh to write.";
  }
  std::string refusal = biting::RefusalOfCells(mesh);
  if (!refusal.empty())
  {
    return refusal;
  }
  biting::MeshFile file;
  file.AreDegrees = this->Coordinates == LONGITUDE_LATITUDE;
  const biting::WrittenParts parts(mesh);
  refusal = biting::ReadCells(
    mesh, parts, format->HasRegions ? Text(this->RegionArray) : std::string(), file);
  if (refusal.empty() && file.IsSolid() && !format->HasTetrahedra)
  {
    return "This format has no tetrahedra in space; .msh and .su2 have.";
  }
  const bool isOriented = file.IsSolid() || format->IsPlanar;
  refusal = refusal.empty() && isOriented ? biting::OrientCells(file) : refusal;
  refusal = refusal.empty() && format->HasDepths
    ? biting::ReadDepths(mesh, parts, Text(this->DepthArray), file)
    : refusal;
  refusal = refusal.empty() ? this->ReadTags(mesh, edges, parts, file) : refusal;
  return refusal.empty() ? this->WriteFile(file) : refusal;
}

//------------------------------------------------------------------------------
// First beside the file that may be there, which stays where this fails.
std::string vtkBitingMeshWriter::WriteFile(const biting::MeshFile& file)
{
  const std::string name = Text(this->FileName);
  const biting::MeshFormat& format = *biting::FormatOf(name);
  std::vector<bool> areOpen;
  const std::string unknown =
    format.HasOpenTags ? biting::FindOpenTags(file, Text(this->OpenTags), areOpen) : "";
  if (!unknown.empty())
  {
    return "No edge of the boundary has the tag " + unknown + ", which Open Tags lists.";
  }
  const std::string part = name + ".part";
  std::ofstream stream(part, std::ios::binary);
  format.Write(file, areOpen, stream);
  stream.close();
  std::error_code failure;
  if (stream)
  {
    std::filesystem::rename(part, name, failure);
  }
  if (stream && !failure)
  {
    return {};
  }
  std::filesystem::remove(part, failure);
  return "The file could not be written: " + name;
}

//------------------------------------------------------------------------------
void vtkBitingMeshWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << Text(this->FileName) << "\n"
     << indent << "TagArray: " << Text(this->TagArray) << "\n"
     << indent << "RegionArray: " << Text(this->RegionArray) << "\n"
     << indent << "OpenTags: " << Text(this->OpenTags) << "\n"
     << indent << "DepthArray: " << Text(this->DepthArray) << "\n"
     << indent << "Coordinates: " << this->Coordinates << "\n"
     << indent << "GatherPieces: " << this->GatherPieces << "\n";
}

VTK_ABI_NAMESPACE_END
