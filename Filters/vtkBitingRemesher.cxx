// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkBitingRemesher.h"

#include "Bridge/Drawing/Globe.h"
#include "Bridge/Drawing/RemeshInputFromDataSet.h"
#include "Bridge/Mesh/BitesToPolyData.h"
#include "Bridge/Mesh/DividedQuads.h"
#include "Bridge/Mesh/MeshToPolyData.h"
#include "Bridge/Mesh/RemeshedData.h"
#include "Bridge/Ranks/Ranks.h"
#include "Bridge/Run/FilterRun.h"
#include "Bridge/Run/ProblemReport.h"
#include "Bridge/Run/SummaryText.h"
#include "Bridge/Source/SourceData.h"
#include "Bridge/Source/SpacingValues.h"
#include "Kernel/Base/Monitor.h"
#include "Kernel/BitingRemesh.h"

#include "vtkCellArray.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <string> // for refusals

VTK_ABI_NAMESPACE_BEGIN

namespace
{

// The stages around those of the kernel, with their shares of the time of a run.
constexpr biting::Stage ReadingStage{ "Reading the input", 0.1 };
constexpr biting::Stage WritingStage{ "Writing the mesh", 0.1 };

} // namespace

//------------------------------------------------------------------------------
// One execution: reads, remeshes, writes, and says what is wrong. Methods return false where
// nothing is left to do.
class vtkBitingRemesher::Execution : private biting::FilterRun
{
public:
  explicit Execution(vtkBitingRemesher* filter)
    : FilterRun({ filter, &filter->ErrorCode, &filter->Summary, &filter->IsStopping,
                  filter->NumberOfThreads },
        biting::SharesOfStages(ReadingStage, biting::RemeshingStages::InOrder, WritingStage))
    , Filter(filter)
  {
  }

  /// Fills the outputs of the filter; says what is wrong.
  void Run(const biting::WholeInput& mesh, const biting::WholeInput& source,
    const biting::WholeInput& lines, vtkInformationVector* outputs);

private:
  bool Gather(const biting::WholeInput& mesh, const biting::WholeInput& source,
    const biting::WholeInput& lines);
  bool ReadParameters();
  bool ReadMesh();
  bool ReadSpacing();
  bool Remesh();
  void Write(vtkInformationVector* outputs);
  void WriteUnchanged(vtkInformationVector* outputs, biting::Pulse& pulse);
  std::string ParameterRefusal() const;
  std::string AddValues();
  void NumberPoints();

  vtkBitingRemesher* Filter;
  vtkSmartPointer<vtkDataSet> Input;
  biting::DividedQuads Divided;
  vtkSmartPointer<vtkDataObject> Source;
  vtkSmartPointer<vtkDataSet> Lines;
  biting::PlanarMesh Mesh;
  biting::RemeshOptions Options;
  biting::RemeshResult Result;
};

vtkStandardNewMacro(vtkBitingRemesher);

//------------------------------------------------------------------------------
vtkBitingRemesher::vtkBitingRemesher()
{
  this->SetNumberOfInputPorts(3);
}

//------------------------------------------------------------------------------
void vtkBitingRemesher::SetTaggedLinesData(vtkDataObject* lines)
{
  this->SetInputData(2, lines);
}

//------------------------------------------------------------------------------
void vtkBitingRemesher::SetTaggedLinesConnection(vtkAlgorithmOutput* lines)
{
  this->SetInputConnection(2, lines);
}

//------------------------------------------------------------------------------
int vtkBitingRemesher::FillInputPortInformation(int port, vtkInformation* info)
{
  const bool isSource = port == 1;
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), isSource ? "vtkDataSet" : "vtkPolyData");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(),
    isSource ? "vtkCompositeDataSet" : "vtkUnstructuredGrid");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), port == 0 ? 0 : 1);
  return 1;
}

//------------------------------------------------------------------------------
int vtkBitingRemesher::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->Summary.clear();
  const biting::Stopwatch watch;
  biting::RunOnFirstRank(this, this->ErrorCode, { request, inputVector, outputVector },
    [this, outputVector](const biting::WholeInputs& inputs)
    { Execution(this).Run(inputs[0], inputs[1], inputs[2], outputVector); });
  vtkPolyData* output = vtkPolyData::GetData(outputVector, MESH);
  const std::string counts = biting::CountsOf(output);
  const bool isNew = output->GetFieldData()->HasArray("UsedLipschitz");
  this->Summary = counts +
    (!counts.empty() && isNew ? biting::SummaryOf(output, watch.Seconds()) : std::string()) +
    this->Summary;
  return 1; // also where there was an error: views keep the mesh before it where this is 0
}

//------------------------------------------------------------------------------
void vtkBitingRemesher::Execution::Run(const biting::WholeInput& mesh,
  const biting::WholeInput& source, const biting::WholeInput& lines, vtkInformationVector* outputs)
{
  const auto run = [this, &mesh, &source, &lines, outputs]()
  {
    if (this->Gather(mesh, source, lines) && this->ReadParameters() && this->ReadMesh() &&
      this->ReadSpacing() && this->Remesh())
    {
      this->Write(outputs);
      this->Divided.RestoreIds(vtkPolyData::GetData(outputs, MESH));
      this->Divided.RestoreIds(
        this->Lines ? nullptr : vtkPolyData::GetData(outputs, BOUNDARY_EDGES));
    }
    this->WriteProblems(
      this->Mesh.Planar, biting::RepairPolicy::Repaired, vtkPolyData::GetData(outputs, PROBLEMS));
  };
  this->Guard(outputs, run);
}

//------------------------------------------------------------------------------
bool vtkBitingRemesher::Execution::Gather(
  const biting::WholeInput& mesh, const biting::WholeInput& source, const biting::WholeInput& lines)
{
  if (!this->AcceptComplete({ &mesh, &source, &lines }))
  {
    return false;
  }
  this->Input = vtkDataSet::SafeDownCast(mesh.Make());
  this->Source = source.Make();
  this->Lines = vtkDataSet::SafeDownCast(lines.Make());
  if (!this->Lines)
  {
    this->Lines = biting::FindTaggedEdges(this->Filter, this->Input);
  }
  return this->Input != nullptr;
}

//------------------------------------------------------------------------------
bool vtkBitingRemesher::Execution::ReadParameters()
{
  const vtkBitingRemesher& filter = *this->Filter;
  this->Options.Spacing.Uniform = filter.UniformSpacing;
  this->Options.Spacing.Scale = filter.SpacingScale;
  this->Options.Spacing.Minimum = filter.MinimumSpacing;
  this->Options.Spacing.Maximum = filter.MaximumSpacing;
  this->Options.Spacing.Gradation = filter.Gradation;
  this->Options.LimitByFeatureSize = filter.LimitByFeatureSize;
  constexpr biting::EdgePolicy Policies[] = { biting::EdgePolicy::Free,
    biting::EdgePolicy::SplitOnly, biting::EdgePolicy::Frozen };
  this->Options.Edges = Policies[filter.EdgePolicy];
  this->Options.BoundaryTolerance = filter.BoundaryTolerance;
  this->Options.FeatureAngle = filter.FeatureAngle;
  constexpr biting::RemeshPreference Preferences[] = { biting::RemeshPreference::Keeping,
    biting::RemeshPreference::Balanced, biting::RemeshPreference::Shape };
  this->Options.Preference = Preferences[filter.Preference];
  this->Options.Relaxation = filter.Relaxation;
  this->Options.Rings = filter.Rings;
  this->Options.RelaxAll = filter.RelaxAll;
  this->Options.MaximumNumberOfVertices = filter.MaximumNumberOfVertices;
  this->Options.KeepBites = filter.GenerateBites;
  return this->Accept(this->ParameterRefusal());
}

//------------------------------------------------------------------------------
std::string vtkBitingRemesher::Execution::ParameterRefusal() const
{
  return biting::FirstRefusal({ biting::CheckSpacingParameters(this->Options.Spacing),
    biting::CheckAtLeastZero("Boundary Tolerance", this->Options.BoundaryTolerance),
    biting::CheckAtLeastZero("Feature Angle", this->Options.FeatureAngle),
    biting::CheckMostVertices(this->Options.MaximumNumberOfVertices) });
}

//------------------------------------------------------------------------------
bool vtkBitingRemesher::Execution::ReadMesh()
{
  this->Progress.BeginStage(ReadingStage.Text);
  this->Divided = biting::DividedQuads(this->Input);
  this->Input = this->Divided.Data();
  this->Warn(this->Divided.Remark());
  biting::PartOfStage part(this->Progress, 0.0, 0.5);
  this->Mesh.Planar.IsOnGlobe = this->Filter->Coordinates == LONGITUDE_LATITUDE;
  const biting::RemeshArrays arrays{ this->Filter->RegionArray, this->Filter->FrozenArray };
  if (!this->Accept(
        biting::RemeshInputFromDataSet(this->Input, this->Lines, arrays, this->Mesh, part)) ||
    this->WasAborted())
  {
    return false;
  }
  const bool isEmpty = this->Mesh.CellIds.empty();
  if (isEmpty && this->Input->GetNumberOfPoints() + this->Input->GetNumberOfCells() > 0)
  {
    return this->Accept("The input has no triangles; it is a mesh that is changed.");
  }
  return !isEmpty;
}

//------------------------------------------------------------------------------
bool vtkBitingRemesher::Execution::ReadSpacing()
{
  biting::SpacingOptions& spacing = this->Options.Spacing;
  spacing.Curvature = this->Mesh.Planar.Frame.Curvature();
  biting::PartOfStage part(this->Progress, 0.5, 0.9);
  if (this->Source &&
    !this->Accept(this->AddSource(
      this->Filter->GetInputArrayInformation(1), this->Source, this->Mesh.Planar.Frame,
      [](const biting::Point2&) { return true; }, spacing, part)))
  {
    return false;
  }
  const bool hasOther = !spacing.Sources.empty() || spacing.Uniform > 0.0;
  return (hasOther || this->Accept(this->AddValues())) && !this->WasAborted();
}

//------------------------------------------------------------------------------
std::string vtkBitingRemesher::Execution::AddValues()
{
  const biting::ChosenArray chosen = biting::ChooseArray(
    this->Filter->GetInputArrayInformation(0), this->Input, { "spacing array", "input" });
  if (!chosen.Refusal.empty())
  {
    return chosen.Refusal;
  }
  if (!chosen.Array)
  {
    return "There is no spacing to remesh to. Choose a point array of the mesh, connect a dataset "
           "that has one, or set Uniform Spacing.";
  }
  biting::Pulse pulse(this->Progress);
  std::vector<double> values;
  const std::string refusal = biting::ReadOwnValues(this->Input, chosen.Array, this->Mesh.PointIds,
    biting::LeastValue(this->Options.Spacing), values, this->Places, pulse);
  for (std::size_t k = 0; refusal.empty() && k < this->Mesh.PointIds.size(); ++k)
  {
    this->Options.Values.push_back(values[this->Mesh.PointIds[k]]);
  }
  return refusal;
}

//------------------------------------------------------------------------------
bool vtkBitingRemesher::Execution::Remesh()
{
  this->Result = biting::Remesh(this->Mesh.Input, this->Options, this->Problems, this->Progress);
  if (this->WasAborted())
  {
    return false;
  }
  const bool isMade = this->AcceptProblems(&this->Mesh.Planar);
  this->WarnOfRepairs(&this->Mesh.Planar);
  if (isMade)
  {
    this->NumberPoints();
  }
  return isMade;
}

//------------------------------------------------------------------------------
// Vertices of the kernel become points of the input, lines and triangles their cells.
void vtkBitingRemesher::Execution::NumberPoints()
{
  if (!this->Result.Old.Origins.empty() && !this->Result.IsUnchanged)
  {
    const std::vector<vtkIdType> before = std::move(this->Mesh.CellIds);
    this->Mesh.CellIds.clear();
    for (const biting::Id origin : this->Result.Old.Origins)
    {
      this->Mesh.CellIds.push_back(before[origin]);
    }
  }
  for (biting::Id& original : this->Result.Mesh.OriginalPoints)
  {
    original =
      original == biting::NoId ? original : static_cast<biting::Id>(this->Mesh.PointIds[original]);
  }
  for (biting::Id& line : this->Result.Mesh.EdgeCells)
  {
    line = line == biting::NoId ? line : this->Mesh.Input.LineCells[line];
  }
}

//------------------------------------------------------------------------------
void vtkBitingRemesher::Execution::Write(vtkInformationVector* outputs)
{
  this->Progress.BeginStage(WritingStage.Text);
  biting::Pulse pulse(this->Progress);
  if (this->Result.IsUnchanged)
  {
    this->WriteUnchanged(outputs, pulse);
    return;
  }
  vtkPolyData* output = vtkPolyData::GetData(outputs, MESH);
  const auto points = biting::PointsInSpace(this->Result.Mesh, this->Mesh.Planar, pulse);
  biting::ToMetres(this->Mesh.Planar.Frame, this->Result.Mesh.Points, this->Result.Mesh.Spacing,
    this->Result.Mesh.Quality);
  biting::MeshToPolyData(this->Result.Mesh, points, this->Problems, output, pulse);
  if (this->Filter->TransferData)
  {
    biting::TransferData(
      this->Result, this->Mesh, this->Input, this->Filter->RegionArray, output, pulse);
  }
  biting::AddOriginals(this->Result, this->Mesh, output);
  biting::BoundaryEdgesToPolyData(this->Result.Mesh, points, this->Mesh.Lines,
    vtkPolyData::GetData(outputs, BOUNDARY_EDGES), pulse);
  if (this->Filter->GenerateBites)
  {
    biting::BitesToPolyData(
      this->Result.Mesh, this->Mesh.Planar.Frame, vtkPolyData::GetData(outputs, BITES), pulse);
  }
}

//------------------------------------------------------------------------------
// The edges have the points of the input.
void vtkBitingRemesher::Execution::WriteUnchanged(
  vtkInformationVector* outputs, biting::Pulse& pulse)
{
  biting::PassThrough(this->Mesh, this->Input, vtkPolyData::GetData(outputs, MESH));
  biting::BitingMesh& edges = this->Result.Mesh;
  edges.Points.resize(static_cast<std::size_t>(this->Input->GetNumberOfPoints()));
  for (std::vector<biting::Id>* ends : { &edges.EdgeStarts, &edges.EdgeEnds })
  {
    for (biting::Id& end : *ends)
    {
      end = static_cast<biting::Id>(this->Mesh.PointIds[end]);
    }
  }
  vtkNew<vtkPoints> points;
  points->SetData(this->Mesh.Planar.Coordinates);
  biting::BoundaryEdgesToPolyData(
    edges, points, this->Mesh.Lines, vtkPolyData::GetData(outputs, BOUNDARY_EDGES), pulse);
}

//------------------------------------------------------------------------------
void vtkBitingRemesher::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "EdgePolicy: " << this->EdgePolicy << "\n"
     << indent << "BoundaryTolerance: " << this->BoundaryTolerance << "\n"
     << indent << "FeatureAngle: " << this->FeatureAngle << "\n"
     << indent << "Preference: " << this->Preference << "\n"
     << indent << "RegionArray: " << this->RegionArray << "\n"
     << indent << "FrozenArray: " << this->FrozenArray << "\n"
     << indent << "TransferData: " << (this->TransferData ? "on" : "off") << "\n"
     << indent << "Rings: " << this->Rings << "\n"
     << indent << "RelaxAll: " << (this->RelaxAll ? "on" : "off") << "\n";
}

VTK_ABI_NAMESPACE_END
