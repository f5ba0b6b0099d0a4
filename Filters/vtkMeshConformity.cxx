// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkMeshConformity.h"

#include "Bridge/ArrayFromVector.h"
#include "Bridge/ChosenArray.h"
#include "Bridge/DomainMembership.h"
#include "Bridge/DoubleArray.h"
#include "Bridge/FacesFromDataSet.h"
#include "Bridge/MessagesFromProblems.h"
#include "Bridge/MonitorOfFilter.h"
#include "Bridge/QualityArrays.h"
#include "Bridge/Ranks.h"
#include "Bridge/SourceCover.h"
#include "Bridge/SourceData.h"
#include "Bridge/SourceSpacing.h"
#include "Bridge/SpacingValues.h"
#include "Bridge/SummaryText.h"
#include "Kernel/Base/Box2.h"
#include "Kernel/Base/Pulse.h"
#include "Kernel/Predicates/Predicates.h"
#include "Kernel/Quality/Histogram.h"
#include "Kernel/Quality/NearestNeighbors.h"
#include "Kernel/Quality/Quality.h"
#include "Kernel/Quality/TriangleLinks.h"
#include "Kernel/Spacing/Spacing.h"

#include "vtkCellData.h"
#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkTable.h"

#include <algorithm> // for count, find, min
#include <limits>    // for NaN
#include <new>       // for bad_alloc
#include <string>    // for messages
#include <utility>   // for move

VTK_ABI_NAMESPACE_BEGIN

namespace
{

constexpr int NumberOfStages = 4;
constexpr double HighestAngle = 180.0;
constexpr double HighestConformity = 1.0;
constexpr double HighestRelativeLength = 3.0;

//------------------------------------------------------------------------------
void EmptyOutputs(vtkInformationVector* outputs)
{
  for (int port = 0; port < outputs->GetNumberOfInformationObjects(); ++port)
  {
    vtkDataObject::GetData(outputs, port)->Initialize();
  }
}

//------------------------------------------------------------------------------
// `values` of the things with these ids, as one value for each of `size` things; NaN for the
// others.
std::vector<double> Spread(
  const std::vector<double>& values, const std::vector<vtkIdType>& ids, vtkIdType size)
{
  std::vector<double> all(static_cast<std::size_t>(size), std::numeric_limits<double>::quiet_NaN());
  for (std::size_t k = 0; k < ids.size(); ++k)
  {
    all[static_cast<std::size_t>(ids[k])] = values[k];
  }
  return all;
}

//------------------------------------------------------------------------------
void AddHistogram(const biting::Histogram& histogram, const std::string& name, vtkTable* table)
{
  biting::AddArray<vtkDoubleArray>(table->GetRowData(), name.c_str(), histogram.Centers);
  biting::AddArray<vtkDoubleArray>(
    table->GetRowData(), (name + "Percent").c_str(), histogram.Percents);
}

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
  bool ReadMesh();
  bool ReadSpacing();
  bool Measure();
  void Write(vtkInformationVector* outputs) const;
  bool Accept(const std::string& refusal);
  void Refuse(const std::string& reason);
  void WarnOfTriangles() const;
  void WarnOfUnusedPoints() const;
  void WarnOfRepeatedPoints(const std::vector<double>& distances) const;
  void WarnOfCells(
    const char* what, const std::vector<biting::Id>& triangles, const char* advice) const;
  bool ReadSource(const biting::SourceData& source);
  bool ReadOwnSpacing(vtkDataArray* values);
  std::vector<double> Evaluate(
    const biting::Spacing& spacing, const std::vector<biting::Point2>& places);
  bool ReportErrors(const biting::ProblemList& problems);
  biting::SourceData ChooseSource();
  biting::Polylines OutlinesOfFaces() const;
  void ReportUncovered(const biting::SpacingOptions& options) const;
  biting::MeshView View() const;
  void WriteMesh(vtkDataSet* output) const;
  void WriteHistograms(vtkTable* output) const;

  vtkMeshConformity* Filter;
  vtkSmartPointer<vtkDataSet> Input;
  vtkSmartPointer<vtkDataObject> Source;
  biting::MonitorOfFilter Monitor;
  biting::PlanarFaces Faces;
  biting::TriangleLinks Links;
  std::vector<double> Spacing;       // at each vertex, NaN where none is given
  std::vector<double> MiddleSpacing; // at the middle of each edge; empty without a source
  double GivenLipschitz = 0.0;
  double UsedLipschitz = 0.0;
  biting::MeshQuality Quality;
  std::vector<double> Angles;
  std::vector<double> RelativeLengths;
  bool HasSpacing = false;
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
  vtkDataSet* input = vtkDataSet::GetData(inputVector[0]);
  if (!input)
  {
    return 0;
  }
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
int vtkMeshConformity::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->Superclass::RequestUpdateExtent(request, inputVector, outputVector);
  biting::Ranks(request, outputVector).AskForPieces(inputVector, this->GetNumberOfInputPorts());
  return 1;
}

//------------------------------------------------------------------------------
int vtkMeshConformity::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkBitingCompat::ForgetAbort(this);
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
  this->Summary += biting::SummaryOf(vtkDataSet::GetData(outputVector, 0), watch.Seconds());
  return 1; // also where there was an error: views keep what was before it where this is 0
}

//------------------------------------------------------------------------------
void vtkMeshConformity::Execution::Run(
  const biting::WholeInput& mesh, const biting::WholeInput& source, vtkInformationVector* outputs)
{
  try
  {
    if (this->Gather(mesh, source) && this->ReadMesh() && this->ReadSpacing() && this->Measure())
    {
      this->Write(outputs);
    }
  }
  catch (const std::bad_alloc&)
  {
    EmptyOutputs(outputs);
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
bool vtkMeshConformity::Execution::ReadMesh()
{
  this->Monitor.BeginStage("Reading the triangles");
  if (!this->Accept(biting::FacesFromDataSet(
        this->Input, biting::FaceRule::Triangles, this->Faces, this->Monitor)) ||
    !this->Monitor.Advance(1.0))
  {
    return false;
  }
  const bool isEmpty = this->Faces.CellIds.empty();
  if (isEmpty && this->Input->GetNumberOfCells() > 0)
  {
    return this->Accept("The input has no triangles to measure.");
  }
  if (isEmpty)
  {
    return false;
  }
  this->Links =
    biting::LinkTriangles(this->Faces.Corners, static_cast<biting::Id>(this->Faces.Points.size()));
  this->WarnOfTriangles();
  this->WarnOfUnusedPoints();
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
  this->Filter->Summary += biting::RefusalLines(reason);
  vtkErrorWithObjectMacro(this->Filter, << reason);
}

//------------------------------------------------------------------------------
void vtkMeshConformity::Execution::WarnOfTriangles() const
{
  std::vector<biting::Id> flat;
  std::vector<biting::Id> turned[2]; // clockwise, counterclockwise
  const std::vector<biting::Id>& corners = this->Faces.Corners;
  for (std::size_t slot = 0; slot < corners.size(); slot += 3)
  {
    const auto place = [this, &corners, slot](std::size_t corner) -> const biting::Point2&
    { return this->Faces.Points[static_cast<std::size_t>(corners[slot + corner])]; };
    const int sign = biting::Orient2D(place(0), place(1), place(2));
    (sign == 0 ? flat : turned[sign > 0 ? 1 : 0]).push_back(static_cast<biting::Id>(slot / 3));
  }
  this->WarnOfCells("Triangles without area", flat, "They have the angle 0 and infinite ratios.");
  this->WarnOfCells("Triangles oriented against the majority",
    turned[turned[1].size() < turned[0].size() ? 1 : 0],
    "The mesh may overlap itself there; they are measured as if turned.");
  this->WarnOfCells(
    "Edges of more than two triangles", this->Links.Crowded, "The mesh is not a surface there.");
}

//------------------------------------------------------------------------------
void vtkMeshConformity::Execution::WarnOfCells(
  const char* what, const std::vector<biting::Id>& triangles, const char* advice) const
{
  if (triangles.empty())
  {
    return;
  }
  std::vector<std::string> first;
  for (std::size_t k = 0; k < std::min(triangles.size(), biting::ShownIds); ++k)
  {
    const auto triangle = static_cast<std::size_t>(triangles[k]);
    const auto corner = static_cast<std::size_t>(this->Faces.Corners[3 * triangle]);
    first.push_back("cell " + std::to_string(this->Faces.CellIds[triangle]) + " at " +
      biting::PlaceText(this->Faces.Frame.ToSpace(this->Faces.Points[corner])));
  }
  const auto count = static_cast<std::int64_t>(triangles.size());
  vtkWarningWithObjectMacro(this->Filter,
    << what << " (" << count << "): " << biting::ListText(first, count) << ". " << advice);
}

//------------------------------------------------------------------------------
void vtkMeshConformity::Execution::WarnOfUnusedPoints() const
{
  const vtkIdType unused =
    this->Input->GetNumberOfPoints() - static_cast<vtkIdType>(this->Faces.PointIds.size());
  if (unused > 0)
  {
    vtkWarningWithObjectMacro(
      this->Filter, << "Points that no triangle uses (" << unused << ") are not measured.");
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
  vtkWarningWithObjectMacro(
    this->Filter, << "There is no spacing to compare with: shapes are measured, conformity is not. "
                     "Choose a point array of the mesh, or connect a dataset that has one.");
  this->Spacing.assign(this->Faces.Points.size(), std::numeric_limits<double>::quiet_NaN());
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
    vtkWarningWithObjectMacro(this->Filter,
      << "The spacing source is not used: no array of it was chosen, and it has none named "
      << biting::SpacingArrayName << ".");
  }
  return source;
}

//------------------------------------------------------------------------------
// The outlines of the faces: an odd number of them around a place tells that it is in the mesh.
biting::Polylines vtkMeshConformity::Execution::OutlinesOfFaces() const
{
  biting::Polylines outlines;
  outlines.Points = this->Faces.Points;
  for (std::size_t face = 0; face + 1 < this->Faces.Offsets.size(); ++face)
  {
    const auto first = this->Faces.Corners.begin() + this->Faces.Offsets[face];
    const auto end = this->Faces.Corners.begin() + this->Faces.Offsets[face + 1];
    outlines.Connectivity.insert(outlines.Connectivity.end(), first, end);
    outlines.Connectivity.push_back(*first);
    outlines.Offsets.push_back(static_cast<biting::Id>(outlines.Connectivity.size()));
    outlines.Kinds.push_back(biting::ChainKind::Boundary);
    outlines.Cells.push_back(static_cast<biting::Id>(face));
  }
  return outlines;
}

//------------------------------------------------------------------------------
bool vtkMeshConformity::Execution::ReadSource(const biting::SourceData& source)
{
  const biting::Polylines outlines = this->OutlinesOfFaces();
  biting::DomainMembership domain(outlines, this->Monitor);
  const auto isWanted = [&domain](const biting::Point2& place) { return domain.MayHold(place); };
  biting::SpacingOptions options;
  options.Gradation = 0.0;
  biting::ProblemPlaces places;
  if (!this->Accept(biting::AddSourceSpacing(
        source, this->Faces.Frame, isWanted, options, places, this->Monitor)))
  {
    return false;
  }
  biting::Box2 box;
  for (const biting::Point2& point : this->Faces.Points)
  {
    box.Add(point);
  }
  biting::ProblemList problems;
  const biting::Spacing spacing = biting::MakeSpacing(options, box, problems, this->Monitor);
  if (problems.HasErrors())
  {
    return this->ReportErrors(problems);
  }
  this->ReportUncovered(options);
  this->Spacing = this->Evaluate(spacing, this->Faces.Points);
  this->MiddleSpacing = this->Evaluate(spacing, biting::EdgeMiddles(this->View(), this->Monitor));
  this->GivenLipschitz = spacing.GivenLipschitz();
  this->HasSpacing = true;
  return this->Monitor.Advance(1.0);
}

//------------------------------------------------------------------------------
void vtkMeshConformity::Execution::ReportUncovered(const biting::SpacingOptions& options) const
{
  const biting::UncoveredPart part =
    biting::FindUncovered(this->Faces.Points, this->Faces.Corners, biting::SourceCover(options));
  if (part.Share > 0.0)
  {
    vtkWarningWithObjectMacro(
      this->Filter, << biting::UncoveredText(part.Share, this->Faces.Frame.ToSpace(part.Place)));
  }
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
  planar.Frame = this->Faces.Frame;
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
  if (!this->Accept(biting::CheckSpacingValues(
        this->Input, values, this->Faces.PointIds, biting::SpacingOwner::Input, places, pulse)))
  {
    return false;
  }
  const auto doubles = biting::AsDoubles(values);
  for (const vtkIdType point : this->Faces.PointIds)
  {
    this->Spacing.push_back(doubles->GetValue(point));
  }
  this->GivenLipschitz = biting::LargestSlope(this->View(), this->Monitor);
  this->HasSpacing = true;
  return this->Monitor.Advance(1.0);
}

//------------------------------------------------------------------------------
bool vtkMeshConformity::Execution::Measure()
{
  this->Monitor.BeginStage("Searching the nearest neighbors");
  std::vector<double> distances =
    biting::NearestNeighborDistances(this->Faces.Points, this->Monitor);
  if (distances.empty())
  {
    return false;
  }
  this->WarnOfRepeatedPoints(distances);
  this->Monitor.BeginStage("Measuring");
  const biting::MeshView mesh = this->View();
  this->Quality = biting::MeasureQuality(mesh, std::move(distances), this->Monitor);
  this->Angles = biting::AnglesOf(mesh, this->Monitor);
  this->RelativeLengths = biting::RelativeLengths(mesh, this->Monitor);
  this->UsedLipschitz = biting::LargestSlope(mesh, this->Monitor);
  return this->Monitor.Advance(1.0);
}

//------------------------------------------------------------------------------
void vtkMeshConformity::Execution::WarnOfRepeatedPoints(const std::vector<double>& distances) const
{
  const auto first = std::find(distances.begin(), distances.end(), 0.0);
  if (first == distances.end())
  {
    return;
  }
  const auto vertex = static_cast<std::size_t>(first - distances.begin());
  vtkWarningWithObjectMacro(this->Filter,
    << "Points at one place (" << std::count(distances.begin(), distances.end(), 0.0) << "): point "
    << this->Faces.PointIds[vertex] << " at "
    << biting::PlaceText(this->Faces.Frame.ToSpace(this->Faces.Points[vertex]))
    << ", and others. Their conformity is 0; merge them (Clean) if they are meant to be one.");
}

//------------------------------------------------------------------------------
biting::MeshView vtkMeshConformity::Execution::View() const
{
  return { this->Faces.Points, this->Spacing, this->Faces.Corners, this->Links.Neighbors,
    this->MiddleSpacing.empty() ? nullptr : &this->MiddleSpacing };
}

//------------------------------------------------------------------------------
void vtkMeshConformity::Execution::Write(vtkInformationVector* outputs) const
{
  this->WriteMesh(vtkDataSet::GetData(outputs, 0));
  this->WriteHistograms(vtkTable::GetData(outputs, 1));
}

//------------------------------------------------------------------------------
void vtkMeshConformity::Execution::WriteMesh(vtkDataSet* output) const
{
  output->ShallowCopy(this->Input);
  const vtkIdType numberOfPoints = this->Input->GetNumberOfPoints();
  const vtkIdType numberOfCells = this->Input->GetNumberOfCells();
  biting::MeshQuality all;
  for (const auto member :
    { &biting::MeshQuality::NearestNeighborDistance, &biting::MeshQuality::Conformity })
  {
    all.*member = Spread(this->Quality.*member, this->Faces.PointIds, numberOfPoints);
  }
  for (const auto member : { &biting::MeshQuality::MinimumAngle,
         &biting::MeshQuality::RadiusEdgeRatio, &biting::MeshQuality::AspectRatio })
  {
    all.*member = Spread(this->Quality.*member, this->Faces.CellIds, numberOfCells);
  }
  biting::Pulse pulse(biting::NoMonitor());
  biting::AddShapeArrays(all, output->GetCellData(), pulse);
  output->GetCellData()->SetActiveScalars("MinimumAngle");
  biting::AddShapeSummary(this->Quality, output->GetFieldData());
  if (!this->HasSpacing)
  {
    biting::AddArray<vtkDoubleArray>(
      output->GetPointData(), "NearestNeighborDistance", all.NearestNeighborDistance);
    return;
  }
  biting::AddConformityArrays(all, Spread(this->Spacing, this->Faces.PointIds, numberOfPoints),
    output->GetPointData(), pulse);
  output->GetPointData()->SetActiveScalars("Conformity");
  biting::AddConformitySummary(this->Quality, output->GetFieldData());
  biting::AddFigure(output->GetFieldData(), "GivenLipschitz", this->GivenLipschitz);
  biting::AddFigure(output->GetFieldData(), "UsedLipschitz", biting::LargestSlope(this->View()));
}

//------------------------------------------------------------------------------
void vtkMeshConformity::Execution::WriteHistograms(vtkTable* output) const
{
  const int bins = this->Filter->NumberOfBins;
  AddHistogram(biting::MakeHistogram(this->Angles, 0.0, HighestAngle, bins), "Angle", output);
  if (this->HasSpacing)
  {
    AddHistogram(biting::MakeHistogram(this->Quality.Conformity, 0.0, HighestConformity, bins),
      "Conformity", output);
    AddHistogram(biting::MakeHistogram(this->RelativeLengths, 0.0, HighestRelativeLength, bins),
      "RelativeLength", output);
  }
}

//------------------------------------------------------------------------------
void vtkMeshConformity::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfBins: " << this->NumberOfBins << "\n";
}

VTK_ABI_NAMESPACE_END
