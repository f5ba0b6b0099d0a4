// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkBitingMesher.h"

#include "Bridge/BitesToPolyData.h"
#include "Bridge/BoundaryEdgesToPolyData.h"
#include "Bridge/BoundarySpacing.h"
#include "Bridge/MeshToPolyData.h"
#include "Bridge/MessagesFromProblems.h"
#include "Bridge/MonitorOfFilter.h"
#include "Bridge/PolylinesFromPolyData.h"
#include "Bridge/SourceSpacing.h"
#include "Kernel/BitingMesh.h"

#include "vtkCellArray.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <cmath>  // for isfinite
#include <new>    // for bad_alloc
#include <string> // for refusals

VTK_ABI_NAMESPACE_BEGIN

namespace
{

constexpr const char* DefaultArrayName = "Spacing";

// A point array of a dataset, or why there is none; neither where none is wanted.
struct ChosenArray
{
  vtkDataArray* Array = nullptr;
  bool IsByDefault = false; // nobody chose it
  std::string Refusal;
};

//------------------------------------------------------------------------------
ChosenArray ArrayNamed(const char* name, vtkDataSet* data, const char* role)
{
  ChosenArray chosen;
  chosen.Array = data->GetPointData()->GetArray(name);
  const std::string text = name;
  const bool mayBeMissing = text.empty() || text == "None" || text == DefaultArrayName;
  if (!chosen.Array && data->GetPointData()->GetAbstractArray(name))
  {
    chosen.Refusal = "The spacing array " + text + " of the " + role + " is not numeric.";
  }
  else if (!chosen.Array && !mayBeMissing)
  {
    chosen.Refusal = "The " + std::string(role) + " has no point array named " + text + ".";
  }
  return chosen;
}

//------------------------------------------------------------------------------
// `choice` is what SetInputArrayToProcess left; `role` names the dataset in messages.
ChosenArray ChooseArray(vtkInformation* choice, vtkDataSet* data, const char* role)
{
  const bool isSet = choice->Has(vtkDataObject::FIELD_ASSOCIATION());
  if (isSet &&
    choice->Get(vtkDataObject::FIELD_ASSOCIATION()) != vtkDataObject::FIELD_ASSOCIATION_POINTS)
  {
    ChosenArray chosen;
    chosen.Refusal = "The spacing array of the " + std::string(role) + " must be point data.";
    return chosen;
  }
  if (choice->Has(vtkDataObject::FIELD_NAME()))
  {
    return ArrayNamed(choice->Get(vtkDataObject::FIELD_NAME()), data, role);
  }
  if (choice->Has(vtkDataObject::FIELD_ATTRIBUTE_TYPE()))
  {
    ChosenArray chosen;
    chosen.Array =
      data->GetPointData()->GetAttribute(choice->Get(vtkDataObject::FIELD_ATTRIBUTE_TYPE()));
    chosen.Refusal = chosen.Array
      ? ""
      : "The " + std::string(role) + " has no active point array of the chosen kind.";
    return chosen;
  }
  ChosenArray chosen = ArrayNamed(DefaultArrayName, data, role);
  chosen.IsByDefault = true;
  return chosen;
}

//------------------------------------------------------------------------------
std::string CheckAtLeastZero(const char* name, double value)
{
  if (value >= 0.0 && std::isfinite(value))
  {
    return {};
  }
  return std::string(name) + " is " + std::to_string(value) + "; it must be finite, and 0 or more.";
}

//------------------------------------------------------------------------------
void EmptyOutputs(vtkInformationVector* outputs)
{
  for (int port = 0; port < outputs->GetNumberOfInformationObjects(); ++port)
  {
    vtkPolyData::GetData(outputs, port)->Initialize();
  }
}

} // namespace

//------------------------------------------------------------------------------
// One execution: reads, meshes, writes, and says what is wrong. Methods return false where nothing
// is left to do.
class vtkBitingMesher::Execution
{
public:
  Execution(vtkBitingMesher* filter, vtkPolyData* input, vtkDataSet* source)
    : Filter(filter)
    , Input(input)
    , Source(source)
  {
  }

  bool ReadParameters();
  bool ReadChains();
  bool ReadSpacing();
  bool MakeMesh();
  void Write(vtkInformationVector* outputs) const;

  bool HasFailed() const { return this->IsRefused; }

private:
  bool Accept(const std::string& refusal);
  std::string ParameterRefusal() const;
  std::string AddBoundaryArray();
  std::string AddSourceArray();
  bool ReportErrors();
  void ReportRepairs() const;

  vtkBitingMesher* Filter;
  vtkPolyData* Input;
  vtkDataSet* Source;
  biting::PlanarInput Planar;
  biting::BitingMeshOptions Options;
  biting::ProblemList Problems;
  biting::BitingMesh Mesh;
  bool IsRefused = false;
};

vtkStandardNewMacro(vtkBitingMesher);

//------------------------------------------------------------------------------
vtkBitingMesher::vtkBitingMesher()
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(3);
  // Made here, so that asking for the choice of arrays while executing changes nothing.
  this->GetInputArrayInformation(0);
  this->GetInputArrayInformation(1);
}

//------------------------------------------------------------------------------
void vtkBitingMesher::SetSpacingSourceData(vtkDataSet* source)
{
  this->SetInputData(1, source);
}

//------------------------------------------------------------------------------
void vtkBitingMesher::SetSpacingSourceConnection(vtkAlgorithmOutput* source)
{
  this->SetInputConnection(1, source);
}

//------------------------------------------------------------------------------
int vtkBitingMesher::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 0)
  {
    info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
    return 1;
  }
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

//------------------------------------------------------------------------------
int vtkBitingMesher::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkBitingCompat::ForgetAbort(this);
  Execution execution(
    this, vtkPolyData::GetData(inputVector[0]), vtkDataSet::GetData(inputVector[1]));
  try
  {
    if (execution.ReadParameters() && execution.ReadChains() && execution.ReadSpacing() &&
      execution.MakeMesh())
    {
      execution.Write(outputVector);
    }
  }
  catch (const std::bad_alloc&)
  {
    EmptyOutputs(outputVector);
    vtkErrorMacro("There is not enough memory for this mesh. Choose a larger spacing.");
    return 0;
  }
  return execution.HasFailed() ? 0 : 1;
}

//------------------------------------------------------------------------------
bool vtkBitingMesher::Execution::ReadParameters()
{
  if (!this->Accept(this->ParameterRefusal()))
  {
    return false;
  }
  const vtkBitingMesher& filter = *this->Filter;
  this->Options.Spacing.Uniform = filter.UniformSpacing;
  this->Options.Spacing.Scale = filter.SpacingScale;
  this->Options.Spacing.Minimum = filter.MinimumSpacing;
  this->Options.Spacing.Maximum = filter.MaximumSpacing;
  this->Options.Spacing.Gradation = filter.Gradation;
  this->Options.Domain.Repair = filter.RepairInput;
  this->Options.BitingConstant = filter.BitingConstant;
  this->Options.Placement = biting::Placement::Corners;
  this->Options.Order =
    filter.FrontOrder == LARGEST_Y ? biting::FrontOrder::LargestY : biting::FrontOrder::Layers;
  this->Options.MaximumNumberOfBites = filter.MaximumNumberOfBites;
  this->Options.MaximumNumberOfVertices = filter.MaximumNumberOfVertices;
  this->Options.Phi = filter.Phi;
  this->Options.KeepBites = filter.GenerateBites;
  return true;
}

//------------------------------------------------------------------------------
bool vtkBitingMesher::Execution::Accept(const std::string& refusal)
{
  if (!refusal.empty())
  {
    this->IsRefused = true;
    vtkErrorWithObjectMacro(this->Filter, << refusal);
  }
  return refusal.empty();
}

//------------------------------------------------------------------------------
std::string vtkBitingMesher::Execution::ParameterRefusal() const
{
  const vtkBitingMesher& filter = *this->Filter;
  for (const std::string& refusal : { CheckAtLeastZero("UniformSpacing", filter.UniformSpacing),
         CheckAtLeastZero("SpacingScale", filter.SpacingScale),
         CheckAtLeastZero("MinimumSpacing", filter.MinimumSpacing),
         CheckAtLeastZero("MaximumSpacing", filter.MaximumSpacing),
         CheckAtLeastZero("Gradation", filter.Gradation) })
  {
    if (!refusal.empty())
    {
      return refusal;
    }
  }
  if (filter.SpacingScale == 0.0)
  {
    return "SpacingScale is 0; it must be above 0.";
  }
  if (filter.MaximumSpacing > 0.0 && filter.MinimumSpacing > filter.MaximumSpacing)
  {
    return "MinimumSpacing is above MaximumSpacing.";
  }
  if (filter.BitingConstant != 0.0 &&
    !(filter.BitingConstant >= 0.1 && filter.BitingConstant <= 1.0))
  {
    return "BitingConstant is " + std::to_string(filter.BitingConstant) +
      "; it must be 0 (automatic) or within [0.1, 1].";
  }
  if (!(filter.Phi > 0.0 && filter.Phi <= 1.0))
  {
    return "Phi is " + std::to_string(filter.Phi) + "; it must be above 0 and at most 1.";
  }
  if (filter.MaximumNumberOfBites < -1 || filter.MaximumNumberOfVertices < 1)
  {
    return filter.MaximumNumberOfBites < -1
      ? "MaximumNumberOfBites is below -1; -1 means until the front is empty."
      : "MaximumNumberOfVertices is below 1.";
  }
  return {};
}

//------------------------------------------------------------------------------
bool vtkBitingMesher::Execution::ReadChains()
{
  if (this->Input->GetNumberOfStrips() > 0)
  {
    vtkWarningWithObjectMacro(
      this->Filter, << "The triangle strips of the input are ignored; lines, polygons and "
                       "vertex cells describe a domain.");
  }
  return this->Accept(biting::PolylinesFromPolyData(this->Input, this->Planar, this->Problems)) &&
    !this->ReportErrors() && this->Planar.Chains.NumberOfChains() > 0;
}

//------------------------------------------------------------------------------
bool vtkBitingMesher::Execution::ReadSpacing()
{
  return this->Accept(this->AddBoundaryArray()) && this->Accept(this->AddSourceArray());
}

//------------------------------------------------------------------------------
std::string vtkBitingMesher::Execution::AddBoundaryArray()
{
  const ChosenArray chosen =
    ChooseArray(this->Filter->GetInputArrayInformation(0), this->Input, "input");
  if (!chosen.Refusal.empty() || !chosen.Array)
  {
    return chosen.Refusal;
  }
  return biting::AddBoundarySpacing(this->Input, this->Planar, chosen.Array, this->Options.Spacing);
}

//------------------------------------------------------------------------------
std::string vtkBitingMesher::Execution::AddSourceArray()
{
  if (!this->Source)
  {
    return {};
  }
  const ChosenArray chosen =
    ChooseArray(this->Filter->GetInputArrayInformation(1), this->Source, "spacing source");
  if (chosen.IsByDefault && !chosen.Array && chosen.Refusal.empty())
  {
    vtkWarningWithObjectMacro(
      this->Filter, << "The spacing source is not used: it has no point array named "
                    << DefaultArrayName << ", and no other was chosen.");
  }
  if (!chosen.Refusal.empty() || !chosen.Array)
  {
    return chosen.Refusal;
  }
  return biting::AddSourceSpacing(
    this->Source, chosen.Array, this->Planar.Frame, this->Options.Spacing);
}

//------------------------------------------------------------------------------
bool vtkBitingMesher::Execution::MakeMesh()
{
  constexpr int NumberOfStages = 5;
  biting::MonitorOfFilter monitor(this->Filter, NumberOfStages);
  this->Mesh = biting::MakeBitingMesh(this->Planar.Chains, this->Options, this->Problems, monitor);
  if (this->Problems.Has(biting::ProblemCode::Aborted) || this->ReportErrors())
  {
    return false;
  }
  this->ReportRepairs();
  return true;
}

//------------------------------------------------------------------------------
// One error for each kind. Returns whether there was one.
bool vtkBitingMesher::Execution::ReportErrors()
{
  for (const biting::ProblemGroup& group : this->Problems.Groups())
  {
    if (biting::IsError(group.Code))
    {
      const bool isLeft =
        group.Code == biting::ProblemCode::NotResolved && !this->Filter->RepairInput;
      this->Accept(isLeft ? biting::NotResolvedMessageFrom(this->Problems, this->Planar)
                          : biting::MessageFrom(group, this->Planar));
    }
  }
  return this->IsRefused;
}

//------------------------------------------------------------------------------
void vtkBitingMesher::Execution::ReportRepairs() const
{
  for (const biting::ProblemGroup& group : this->Problems.Groups())
  {
    vtkWarningWithObjectMacro(this->Filter, << biting::MessageFrom(group, this->Planar));
  }
}

//------------------------------------------------------------------------------
void vtkBitingMesher::Execution::Write(vtkInformationVector* outputs) const
{
  const auto points = biting::PointsInSpace(this->Mesh, this->Planar);
  biting::MeshToPolyData(this->Mesh, points, this->Problems, vtkPolyData::GetData(outputs, 0));
  biting::BoundaryEdgesToPolyData(
    this->Mesh, points, this->Input, vtkPolyData::GetData(outputs, 1));
  if (this->Filter->GenerateBites)
  {
    biting::BitesToPolyData(this->Mesh, this->Planar.Frame, vtkPolyData::GetData(outputs, 2));
  }
}

//------------------------------------------------------------------------------
void vtkBitingMesher::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "UniformSpacing: " << this->UniformSpacing << "\n"
     << indent << "SpacingScale: " << this->SpacingScale << "\n"
     << indent << "MinimumSpacing: " << this->MinimumSpacing << "\n"
     << indent << "MaximumSpacing: " << this->MaximumSpacing << "\n"
     << indent << "Gradation: " << this->Gradation << "\n"
     << indent << "RepairInput: " << (this->RepairInput ? "on" : "off") << "\n"
     << indent << "BiteShape: " << this->BiteShape << "\n"
     << indent << "BitingConstant: " << this->BitingConstant << "\n"
     << indent << "Placement: " << this->Placement << "\n"
     << indent << "FrontOrder: " << this->FrontOrder << "\n"
     << indent << "MaximumNumberOfBites: " << this->MaximumNumberOfBites << "\n"
     << indent << "Phi: " << this->Phi << "\n"
     << indent << "MaximumNumberOfVertices: " << this->MaximumNumberOfVertices << "\n"
     << indent << "GenerateBites: " << (this->GenerateBites ? "on" : "off") << "\n";
}

VTK_ABI_NAMESPACE_END
