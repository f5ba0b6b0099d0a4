// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkMeshConformity.h"

#include "Bridge/ChosenArray.h"
#include "Bridge/DividedQuads.h"
#include "Bridge/DomainMembership.h"
#include "Bridge/FilterRun.h" // for EmptyOutputs
#include "Bridge/InputTimes.h"
#include "Bridge/MeasuredMesh.h"
#include "Bridge/MeasuredTetrahedra.h"
#include "Bridge/MeshWarnings.h"
#include "Bridge/MessagesFromProblems.h"
#include "Bridge/MonitorOfFilter.h"
#include "Bridge/Ranks.h"
#include "Bridge/SourceCover.h"
#include "Bridge/SourceData.h"
#include "Bridge/SourceSpacing.h"
#include "Bridge/SpacingValues.h"
#include "Bridge/SummaryText.h"
#include "Kernel/Base/Box.h"
#include "Kernel/Base/Pulse.h"
#include "Kernel/Quality/Quality.h"
#include "Kernel/Spacing/Spacing.h"

#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <limits>  // for NaN
#include <new>     // for bad_alloc
#include <string>  // for messages
#include <utility> // for move

VTK_ABI_NAMESPACE_BEGIN

namespace
{

constexpr int NumberOfStages = 4;

} // namespace

//------------------------------------------------------------------------------
// One execution: reads, measures, writes, and says what is wrong. Methods return false where
// nothing is left to do.
class vtkMeshConformity::Execution
{
public:
  explicit Execution(vtkMeshConformity* filter)
    : Filter(filter)
    , Monitor(filter, NumberOfStages)
  {
  }

  /// Fills the outputs of the filter; says what is wrong.
  void Run(const biting::WholeInput& mesh, const biting::WholeInput& source,
    vtkInformationVector* outputs);

private:
  bool Gather(const biting::WholeInput& mesh, const biting::WholeInput& source);
  void MeasureSpace(vtkInformationVector* outputs);
  bool ReadMesh();
  bool ReadSpacing();
  bool Measure();
  void Write(vtkInformationVector* outputs) const;
  bool Accept(const std::string& refusal);
  void Refuse(const std::string& reason);
  void Warn(const std::string& text) const;
  bool ReadSource(const biting::SourceData& source);
  bool ReadOwnSpacing(vtkDataArray* values);
  std::vector<double> Evaluate(
    const biting::Spacing& spacing, const std::vector<biting::Point2>& places);
  bool ReportErrors(const biting::ProblemList& problems);
  biting::SourceData ChooseSource();

  vtkMeshConformity* Filter;
  vtkSmartPointer<vtkDataSet> Input;
  vtkSmartPointer<vtkDataObject> Source;
  biting::MonitorOfFilter Monitor;
  biting::MeasuredMesh Mesh;
  bool IsRefused = false;
};

vtkStandardNewMacro(vtkMeshConformity);

//------------------------------------------------------------------------------
vtkMeshConformity::vtkMeshConformity()
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(2);
  // Made here, so that asking for the choice of arrays while executing changes nothing.
  this->GetInputArrayInformation(0);
  this->GetInputArrayInformation(1);
}

//------------------------------------------------------------------------------
void vtkMeshConformity::SetSpacingSourceData(vtkDataObject* source)
{
  this->SetInputData(1, source);
}

//------------------------------------------------------------------------------
void vtkMeshConformity::SetSpacingSourceConnection(vtkAlgorithmOutput* source)
{
  this->SetInputConnection(1, source);
}

//------------------------------------------------------------------------------
vtkTable* vtkMeshConformity::GetHistograms()
{
  return vtkTable::SafeDownCast(this->GetOutputDataObject(1));
}

//------------------------------------------------------------------------------
int vtkMeshConformity::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 0)
  {
    info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
    return 1;
  }
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

//------------------------------------------------------------------------------
int vtkMeshConformity::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkDataSet" : "vtkTable");
  return 1;
}

//------------------------------------------------------------------------------
int vtkMeshConformity::RequestDataObject(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataSet* given = vtkDataSet::GetData(inputVector[0]);
  vtkNew<vtkPolyData> nothing; // in place of a table among blocks
  vtkDataSet* input = given ? given : nothing;
  vtkDataSet* output = vtkDataSet::GetData(outputVector, 0);
  if (!output || !output->IsA(input->GetClassName()))
  {
    const auto mesh = vtk::TakeSmartPointer(input->NewInstance());
    outputVector->GetInformationObject(0)->Set(vtkDataObject::DATA_OBJECT(), mesh);
  }
  if (!vtkTable::GetData(outputVector, 1))
  {
    outputVector->GetInformationObject(1)->Set(vtkDataObject::DATA_OBJECT(), vtkNew<vtkTable>());
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkMeshConformity::RequestInformation(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  return biting::PassTimes(inputVector, this->GetNumberOfInputPorts(), outputVector);
}

//------------------------------------------------------------------------------
int vtkMeshConformity::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkBitingCompat::ForgetAbort(this);
  this->Superclass::RequestUpdateExtent(request, inputVector, outputVector);
  biting::Ranks(request, outputVector).AskForPieces(inputVector, this->GetNumberOfInputPorts());
  return 1;
}

//------------------------------------------------------------------------------
int vtkMeshConformity::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->ErrorCode = vtkErrorCode::NoError;
  this->Summary.clear();
  const biting::Stopwatch watch;
  const biting::Ranks ranks(request, outputVector);
  const biting::WholeInput mesh(ranks, inputVector[0]);
  const biting::WholeInput source(ranks, inputVector[1]);
  if (ranks.IsFirst())
  {
    Execution(this).Run(mesh, source, outputVector);
  }
  this->ErrorCode = ranks.ShareOutcome(this->ErrorCode, false, this, outputVector);
  this->Summary.insert(0, biting::SummaryOf(vtkDataSet::GetData(outputVector, 0), watch.Seconds()));
  return 1; // also where there was an error: views keep what was before it where this is 0
}

//------------------------------------------------------------------------------
void vtkMeshConformity::Execution::Run(
  const biting::WholeInput& mesh, const biting::WholeInput& source, vtkInformationVector* outputs)
{
  try
  {
    if (!this->Gather(mesh, source))
    {
      return;
    }
    if (biting::MeasuredTetrahedra::AreIn(this->Input))
    {
      this->MeasureSpace(outputs);
    }
    else if (this->ReadMesh() && this->ReadSpacing() && this->Measure())
    {
      this->Write(outputs);
    }
  }
  catch (const std::bad_alloc&)
  {
    biting::EmptyOutputs(outputs);
    this->Refuse("There is not enough memory to measure this mesh.");
  }
}

//------------------------------------------------------------------------------
bool vtkMeshConformity::Execution::Gather(
  const biting::WholeInput& mesh, const biting::WholeInput& source)
{
  if (!mesh.IsComplete() || !source.IsComplete())
  {
    return this->Accept(biting::NotGathered);
  }
  this->Input = vtkDataSet::SafeDownCast(mesh.Make());
  this->Source = source.Make();
  const bool isAsBefore =
    !this->Input || this->Input->IsA(this->Filter->GetOutputDataObject(0)->GetClassName());
  return this->Accept(isAsBefore ? "" : biting::NotOneGrid) && this->Input != nullptr;
}

//------------------------------------------------------------------------------
// Tetrahedra. The sources of spacing are those of a plane: an array of the mesh counts here.
void vtkMeshConformity::Execution::MeasureSpace(vtkInformationVector* outputs)
{
  this->Monitor.BeginStage("Measuring tetrahedra");
  const biting::ChosenArray chosen = biting::ChooseArray(
    this->Filter->GetInputArrayInformation(0), this->Input, { "spacing array", "input" });
  biting::MeasuredTetrahedra mesh;
  if (!this->Accept(chosen.Refusal) ||
    !this->Accept(mesh.Read(this->Input, chosen.Array, this->Monitor)))
  {
    return;
  }
  this->Warn(this->Source ? "The spacing source is not used: of tetrahedra only an array of the "
                            "mesh can be the spacing. Resample With Dataset makes one."
                          : "");
  this->Warn(chosen.Array ? ""
                          : "There is no spacing to compare with: shapes are measured, conformity "
                            "is not. Choose a point array of the mesh.");
  mesh.Quality =
    biting::MeasureTetrahedra({ mesh.Points, mesh.Spacing, mesh.Corners }, this->Monitor);
  if (this->Monitor.Advance(1.0))
  {
    mesh.Write(this->Input, vtkDataSet::GetData(outputs, 0), this->Filter->NumberOfBins,
      vtkTable::GetData(outputs, 1));
    this->Filter->Summary.insert(0, mesh.Summary());
  }
}

//------------------------------------------------------------------------------
bool vtkMeshConformity::Execution::ReadMesh()
{
  this->Monitor.BeginStage("Reading the triangles");
  const biting::DividedQuads divided(this->Input);
  this->Input = divided.Data();
  this->Warn(divided.Remark());
  if (!this->Accept(biting::FacesFromDataSet(
        this->Input, biting::FaceRule::Triangles, this->Mesh.Faces, this->Monitor)) ||
    !this->Monitor.Advance(1.0))
  {
    return false;
  }
  if (this->Mesh.Faces.CellIds.empty())
  {
    return this->Input->GetNumberOfPoints() + this->Input->GetNumberOfCells() > 0 &&
      this->Accept("The input has no triangles to measure.");
  }
  this->Mesh.Links = biting::LinkTriangles(
    this->Mesh.Faces.Corners, static_cast<biting::Id>(this->Mesh.Faces.Points.size()));
  for (const std::string& text : biting::WarningsOfTriangles(this->Mesh.Faces, this->Mesh.Links))
  {
    this->Warn(text);
  }
  this->Warn(biting::WarningOfUnusedPoints(this->Mesh.Faces, this->Input->GetNumberOfPoints()));
  return this->Monitor.Advance(1.0);
}

//------------------------------------------------------------------------------
bool vtkMeshConformity::Execution::Accept(const std::string& refusal)
{
  if (!refusal.empty())
  {
    this->Refuse(refusal);
  }
  return refusal.empty();
}

//------------------------------------------------------------------------------
void vtkMeshConformity::Execution::Refuse(const std::string& reason)
{
  this->IsRefused = true;
  this->Filter->ErrorCode = vtkErrorCode::UserError;
  this->Filter->Summary += "Error: " + reason + "\n";
  vtkErrorWithObjectMacro(this->Filter, << reason);
}

//------------------------------------------------------------------------------
void vtkMeshConformity::Execution::Warn(const std::string& text) const
{
  if (!text.empty())
  {
    this->Filter->Summary += "Warning: " + text + "\n";
    vtkWarningWithObjectMacro(this->Filter, << text);
  }
}

//------------------------------------------------------------------------------
bool vtkMeshConformity::Execution::ReadSpacing()
{
  this->Monitor.BeginStage("Evaluating the spacing");
  const biting::SourceData source = this->ChooseSource();
  if (this->IsRefused || source.Chosen.Array)
  {
    return !this->IsRefused && this->ReadSource(source);
  }
  const biting::ChosenArray chosen = biting::ChooseArray(
    this->Filter->GetInputArrayInformation(0), this->Input, { "spacing array", "input" });
  if (!this->Accept(chosen.Refusal))
  {
    return false;
  }
  if (chosen.Array)
  {
    return this->ReadOwnSpacing(chosen.Array);
  }
  this->Warn("There is no spacing to compare with: shapes are measured, conformity is not. "
             "Choose a point array of the mesh, or connect a dataset that has one.");
  this->Mesh.Spacing.assign(
    this->Mesh.Faces.Points.size(), std::numeric_limits<double>::quiet_NaN());
  return true;
}

//------------------------------------------------------------------------------
// Without an array where the source is not to be used.
biting::SourceData vtkMeshConformity::Execution::ChooseSource()
{
  if (!this->Source)
  {
    return {};
  }
  const biting::SourceData source =
    biting::ChooseSource(this->Filter->GetInputArrayInformation(1), this->Source);
  if (this->Accept(source.Chosen.Refusal) && !source.Chosen.Array)
  {
    this->Warn("The spacing source is not used: no array of it was chosen, and it has none named " +
      std::string(biting::SpacingArrayName) + ".");
  }
  return source;
}

//------------------------------------------------------------------------------
bool vtkMeshConformity::Execution::ReadSource(const biting::SourceData& source)
{
  const biting::Polylines outlines = biting::OutlinesOf(this->Mesh.Faces);
  biting::DomainMembership domain(outlines, this->Monitor);
  const auto isWanted = [&domain](const biting::Point2& place) { return domain.MayHold(place); };
  biting::SpacingOptions options;
  options.Gradation = 0.0;
  biting::ProblemPlaces places;
  if (!this->Accept(biting::AddSourceSpacing(
        source, this->Mesh.Faces.Frame, isWanted, options, places, this->Monitor)))
  {
    return false;
  }
  biting::Box2 box;
  for (const biting::Point2& point : this->Mesh.Faces.Points)
  {
    box.Add(point);
  }
  biting::ProblemList problems;
  const biting::Spacing spacing = biting::MakeSpacing(options, box, problems, this->Monitor);
  if (problems.HasErrors())
  {
    return this->ReportErrors(problems);
  }
  this->Warn(biting::UncoveredWarning(
    this->Mesh.Faces.Points, this->Mesh.Faces.Corners, options, this->Mesh.Faces.Frame));
  this->Mesh.Spacing = this->Evaluate(spacing, this->Mesh.Faces.Points);
  this->Mesh.MiddleSpacing =
    this->Evaluate(spacing, biting::EdgeMiddles(this->Mesh.View(), this->Monitor));
  this->Mesh.GivenLipschitz = spacing.GivenLipschitz();
  this->Mesh.HasSpacing = true;
  return this->Monitor.Advance(1.0);
}

//------------------------------------------------------------------------------
std::vector<double> vtkMeshConformity::Execution::Evaluate(
  const biting::Spacing& spacing, const std::vector<biting::Point2>& places)
{
  std::vector<double> values(places.size());
  biting::Pulse pulse(this->Monitor);
  pulse.ForEach(
    places.size(), [&values, &spacing, &places](std::size_t k) { values[k] = spacing(places[k]); });
  return values;
}

//------------------------------------------------------------------------------
// Always false: nothing is left to do.
bool vtkMeshConformity::Execution::ReportErrors(const biting::ProblemList& problems)
{
  biting::PlanarInput planar;
  planar.Frame = this->Mesh.Faces.Frame;
  for (const biting::ProblemGroup& group : problems.Groups())
  {
    if (group.Code != biting::ProblemCode::Aborted)
    {
      this->Accept(biting::MessageFrom(group, planar));
    }
  }
  return false;
}

//------------------------------------------------------------------------------
bool vtkMeshConformity::Execution::ReadOwnSpacing(vtkDataArray* values)
{
  biting::ProblemPlaces places;
  biting::Pulse pulse(this->Monitor);
  std::vector<double> read;
  if (!this->Accept(biting::ReadOwnValues(
        this->Input, values, this->Mesh.Faces.PointIds, 0.0, read, places, pulse)))
  {
    return false;
  }
  for (const vtkIdType point : this->Mesh.Faces.PointIds)
  {
    this->Mesh.Spacing.push_back(read[static_cast<std::size_t>(point)]);
  }
  this->Mesh.GivenLipschitz = biting::LargestSlope(this->Mesh.View(), this->Monitor);
  this->Mesh.HasSpacing = true;
  return this->Monitor.Advance(1.0);
}

//------------------------------------------------------------------------------
bool vtkMeshConformity::Execution::Measure()
{
  this->Warn(biting::WarningOfRepeatedPoints(this->Mesh.Faces));
  this->Monitor.BeginStage("Measuring");
  const biting::MeshView mesh = this->Mesh.View();
  this->Mesh.Quality = biting::MeasureQuality(mesh, this->Monitor);
  this->Mesh.Angles = biting::AnglesOf(mesh, this->Monitor);
  this->Mesh.RelativeLengths = biting::RelativeLengths(mesh, this->Monitor);
  this->Mesh.UsedLipschitz = biting::LargestSlope(mesh, this->Monitor);
  return this->Monitor.Advance(1.0);
}

//------------------------------------------------------------------------------
void vtkMeshConformity::Execution::Write(vtkInformationVector* outputs) const
{
  biting::WriteMeasures(this->Mesh, this->Input, vtkDataSet::GetData(outputs, 0));
  biting::WriteHistograms(this->Mesh, this->Filter->NumberOfBins, vtkTable::GetData(outputs, 1));
}

//------------------------------------------------------------------------------
void vtkMeshConformity::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfBins: " << this->NumberOfBins << "\n";
}

VTK_ABI_NAMESPACE_END
