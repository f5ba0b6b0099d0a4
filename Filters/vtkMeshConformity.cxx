// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkMeshConformity.h"

#include "Bridge/Drawing/Globe.h"
#include "Bridge/Mesh/DividedQuads.h"
#include "Bridge/Mesh/MeasuredMesh.h"
#include "Bridge/Mesh/MeasuredTetrahedra.h"
#include "Bridge/Ranks/Ranks.h"
#include "Bridge/Run/FilterRun.h"
#include "Bridge/Run/ProblemReport.h"
#include "Bridge/Run/SummaryText.h"
#include "Bridge/Source/DomainMembership.h"
#include "Bridge/Source/SourceCover.h"
#include "Bridge/Source/SourceData.h"
#include "Bridge/Source/SpacingValues.h"
#include "Kernel/Base/Box.h"
#include "Kernel/Base/Pulse.h"
#include "Kernel/Quality/Quality.h"
#include "Kernel/Spacing/Spacing.h"

#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <limits> // for NaN
#include <string> // for messages

VTK_ABI_NAMESPACE_BEGIN

//------------------------------------------------------------------------------
// One execution: reads, measures, writes, and says what is wrong. Methods return false where
// nothing is left to do.
class vtkMeshConformity::Execution : private biting::FilterRun
{
public:
  explicit Execution(vtkMeshConformity* filter)
    : FilterRun(
        { filter, &filter->ErrorCode, &filter->Summary, nullptr, 1 }, { 0.25, 0.25, 0.25, 0.25 })
    , Filter(filter)
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
  bool ReadSource(biting::SpacingOptions& options);
  bool Compare(biting::SpacingOptions options);
  bool ReadOwnSpacing(vtkDataArray* values);
  std::vector<double> Evaluate(
    const biting::Spacing& spacing, const std::vector<biting::Point2>& places);

  vtkMeshConformity* Filter;
  vtkSmartPointer<vtkDataSet> Input;
  vtkSmartPointer<vtkDataObject> Source;
  biting::MeasuredMesh Mesh;
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
  this->Summary.clear();
  const biting::Stopwatch watch;
  biting::RunOnFirstRank(this, this->ErrorCode, { request, inputVector, outputVector },
    [this, outputVector](const biting::WholeInputs& inputs)
    { Execution(this).Run(inputs[0], inputs[1], outputVector); });
  this->Summary.insert(0, biting::SummaryOf(vtkDataSet::GetData(outputVector, 0), watch.Seconds()));
  return 1; // also where there was an error: views keep what was before it where this is 0
}

//------------------------------------------------------------------------------
void vtkMeshConformity::Execution::Run(
  const biting::WholeInput& mesh, const biting::WholeInput& source, vtkInformationVector* outputs)
{
  const auto run = [this, &mesh, &source, outputs]()
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
  };
  this->Guard(outputs, run, "There is not enough memory to measure this mesh.");
}

//------------------------------------------------------------------------------
bool vtkMeshConformity::Execution::Gather(
  const biting::WholeInput& mesh, const biting::WholeInput& source)
{
  if (!this->AcceptComplete({ &mesh, &source }))
  {
    return false;
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
  this->Progress.BeginStage("Measuring tetrahedra");
  const biting::ChosenArray chosen = biting::ChooseArray(
    this->Filter->GetInputArrayInformation(0), this->Input, { "spacing array", "input" });
  biting::MeasuredTetrahedra mesh;
  if (!this->Accept(chosen.Refusal) ||
    !this->Accept(mesh.Read(this->Input, chosen.Array, this->Progress)))
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
    biting::MeasureTetrahedra({ mesh.Points, mesh.Spacing, mesh.Corners, true }, this->Progress);
  if (this->Progress.Advance(1.0))
  {
    vtkDataSet* output = vtkDataSet::GetData(outputs, 0);
    output->ShallowCopy(this->Input);
    mesh.Write(output);
    mesh.WriteHistograms(this->Filter->NumberOfBins, vtkTable::GetData(outputs, 1));
    this->Filter->Summary.insert(0, mesh.Summary());
  }
}

//------------------------------------------------------------------------------
bool vtkMeshConformity::Execution::ReadMesh()
{
  this->Progress.BeginStage("Reading the triangles");
  const biting::DividedQuads divided(this->Input);
  this->Input = divided.Data();
  this->Warn(divided.Remark());
  this->Mesh.Faces.IsOnGlobe = this->Filter->Coordinates == LONGITUDE_LATITUDE;
  if (!this->Accept(biting::FacesFromDataSet(
        this->Input, biting::FaceRule::Triangles, this->Mesh.Faces, this->Progress)) ||
    !this->Progress.Advance(1.0))
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
  return this->Progress.Advance(1.0);
}

//------------------------------------------------------------------------------
bool vtkMeshConformity::Execution::ReadSpacing()
{
  this->Progress.BeginStage("Evaluating the spacing");
  biting::SpacingOptions options;
  options.Gradation = 0.0;
  if (!this->ReadSource(options))
  {
    return false;
  }
  if (!options.Sources.empty())
  {
    return this->Compare(options);
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
bool vtkMeshConformity::Execution::ReadSource(biting::SpacingOptions& options)
{
  if (!this->Source)
  {
    return true;
  }
  const biting::Polylines outlines = biting::OutlinesOf(this->Mesh.Faces);
  biting::DomainMembership domain(outlines, this->Progress);
  const auto isWanted = [&domain](const biting::Point2& place) { return domain.MayHold(place); };
  return this->Accept(this->AddSource(this->Filter->GetInputArrayInformation(1), this->Source,
    this->Mesh.Faces.Frame, isWanted, options, this->Progress));
}

//------------------------------------------------------------------------------
bool vtkMeshConformity::Execution::Compare(biting::SpacingOptions options)
{
  options.Curvature = this->Mesh.Faces.Frame.Curvature();
  const biting::Box2 box = biting::Box2::Around(this->Mesh.Faces.Points);
  const biting::Spacing spacing = biting::MakeSpacing(options, box, this->Problems, this->Progress);
  biting::PlanarInput planar;
  planar.Frame = this->Mesh.Faces.Frame;
  if (!this->AcceptProblems(&planar) || this->WasAborted())
  {
    return false;
  }
  this->Warn(biting::UncoveredWarning(
    this->Mesh.Faces.Points, this->Mesh.Faces.Corners, options, this->Mesh.Faces.Frame));
  this->Mesh.Spacing = this->Evaluate(spacing, this->Mesh.Faces.Points);
  this->Mesh.MiddleSpacing =
    this->Evaluate(spacing, biting::EdgeMiddles(this->Mesh.View(), this->Progress));
  this->Mesh.GivenLipschitz = spacing.GivenLipschitz();
  this->Mesh.HasSpacing = true;
  return this->Progress.Advance(1.0);
}

//------------------------------------------------------------------------------
std::vector<double> vtkMeshConformity::Execution::Evaluate(
  const biting::Spacing& spacing, const std::vector<biting::Point2>& places)
{
  std::vector<double> values(places.size());
  biting::Pulse pulse(this->Progress);
  pulse.ForEach(
    places.size(), [&values, &spacing, &places](std::size_t k) { values[k] = spacing(places[k]); });
  return values;
}

//------------------------------------------------------------------------------
bool vtkMeshConformity::Execution::ReadOwnSpacing(vtkDataArray* values)
{
  biting::Pulse pulse(this->Progress);
  std::vector<double> read;
  if (!this->Accept(biting::ReadOwnValues(
        this->Input, values, this->Mesh.Faces.PointIds, 0.0, read, this->Places, pulse)))
  {
    return false;
  }
  const biting::PlanarFaces& faces = this->Mesh.Faces;
  for (std::size_t vertex = 0; vertex < faces.Points.size(); ++vertex)
  {
    this->Mesh.Spacing.push_back(
      faces.Frame.StretchAt(faces.Points[vertex]) * read[faces.PointIds[vertex]]);
  }
  this->Mesh.GivenLipschitz = biting::LargestSlope(this->Mesh.View(), this->Progress);
  this->Mesh.HasSpacing = true;
  return this->Progress.Advance(1.0);
}

//------------------------------------------------------------------------------
bool vtkMeshConformity::Execution::Measure()
{
  this->Warn(biting::WarningOfRepeatedPoints(this->Mesh.Faces));
  this->Progress.BeginStage("Measuring");
  const biting::MeshView mesh = this->Mesh.View();
  this->Mesh.Quality = biting::MeasureQuality(mesh, this->Progress);
  this->Mesh.Angles = biting::AnglesOf(mesh, this->Progress);
  this->Mesh.RelativeLengths = biting::RelativeLengths(mesh, this->Progress);
  this->Mesh.UsedLipschitz = biting::LargestSlope(mesh, this->Progress);
  biting::ToMetres(
    this->Mesh.Faces.Frame, this->Mesh.Faces.Points, this->Mesh.Spacing, this->Mesh.Quality);
  return this->Progress.Advance(1.0);
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
  os << indent << "NumberOfBins: " << this->NumberOfBins << "\n"
     << indent << "Coordinates: " << this->Coordinates << "\n";
}

VTK_ABI_NAMESPACE_END
