// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkBitingSpaceMesher.h"

#include "Bridge/Run/ProblemReport.h"
#include "Bridge/Source/SpaceSpacing.h"
#include "Kernel/Space/Union/ResolveCrossings.h"
#include "vtkBitingSpaceMesherExecution.h"

#include "vtkCompositeDataSet.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkPolyData.h"

#include <algorithm> // for max
#include <utility>   // for move

VTK_ABI_NAMESPACE_BEGIN

static_assert(static_cast<int>(biting::ProblemCode::TooThin) == vtkBitingSpaceMesher::TOO_THIN &&
    static_cast<int>(biting::ProblemCode::UnitedSurfaces) == vtkBitingSpaceMesher::UNITED_SURFACES,
  "The kinds of problems that users see are those of the kernel.");

//------------------------------------------------------------------------------
vtkBitingSpaceMesher::vtkBitingSpaceMesher()
{
  this->SetNumberOfInputPorts(2);
}

//------------------------------------------------------------------------------
int vtkBitingSpaceMesher::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), port);
  return 1;
}

//------------------------------------------------------------------------------
int vtkBitingSpaceMesher::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->Summary.clear();
  return biting::RunOnFirstRank(this, this->ErrorCode, { request, inputVector, outputVector },
    [this, outputVector](const biting::WholeInputs& inputs)
    { this->NewExecution()->Run(inputs[0], inputs[1], outputVector); });
}

//------------------------------------------------------------------------------
vtkBitingSpaceMesher::Execution::Execution(
  vtkBitingSpaceMesher* filter, const std::vector<double>& shares, double defaultSpacing)
  : FilterRun({ filter, &filter->ErrorCode, &filter->Summary, &filter->IsStopping,
                filter->NumberOfThreads },
      shares)
  , Filter(filter)
  , DefaultSpacing(defaultSpacing)
{
}

//------------------------------------------------------------------------------
void vtkBitingSpaceMesher::Execution::Run(const biting::WholeInput& surface,
  const biting::WholeInput& source, vtkInformationVector* outputs)
{
  const auto run = [this, &surface, &source, outputs]()
  {
    if (this->Gather(surface, source) && this->ReadParameters() && this->ReadSurface() &&
      this->ReadRegions() && this->ReadSpacing() && this->Check() && this->Mesh())
    {
      this->Progress.BeginStage("Writing the mesh");
      this->Filter->Summary = this->Write(outputs) + this->Filter->Summary;
    }
    biting::AddPlacesInSpace(this->Problems, this->Places);
    biting::ProblemsToPolyData(this->Places, vtkPolyData::GetData(outputs, PROBLEMS));
  };
  this->Guard(outputs, run);
}

//------------------------------------------------------------------------------
bool vtkBitingSpaceMesher::Execution::Gather(
  const biting::WholeInput& surface, const biting::WholeInput& source)
{
  if (!this->AcceptComplete({ &surface, &source }))
  {
    return false;
  }
  this->Drawing = biting::ReadDrawing(surface.Make());
  this->Source = source.Make();
  return true;
}

//------------------------------------------------------------------------------
bool vtkBitingSpaceMesher::Execution::ReadParameters()
{
  const vtkBitingSpaceMesher& filter = *this->Filter;
  this->Spacing.Uniform = filter.UniformSpacing;
  this->Spacing.Scale = filter.SpacingScale;
  this->Spacing.Minimum = filter.MinimumSpacing;
  this->Spacing.Maximum = filter.MaximumSpacing;
  this->Spacing.Gradation = filter.Gradation;
  this->Options.Gradation = filter.Gradation;
  this->Options.LimitByFeatureSize = filter.LimitByFeatureSize;
  this->Options.FeatureAngle = filter.FeatureAngle;
  this->Options.BoundaryTolerance = filter.BoundaryTolerance;
  this->Options.MaximumNumberOfVertices = filter.MaximumNumberOfVertices;
  this->Options.Relaxation = filter.Relaxation;
  this->Options.KeepBites = filter.GenerateBites;
  return this->Accept(biting::CheckSpacingParameters(this->Spacing)) &&
    this->Accept(biting::CheckAtLeastZero("Boundary Tolerance", filter.BoundaryTolerance)) &&
    this->Accept(biting::CheckAtLeastZero("Feature Angle", filter.FeatureAngle)) &&
    this->Accept(biting::CheckMergeTolerance(filter.MergeTolerance)) &&
    this->Accept(biting::CheckMostVertices(filter.MaximumNumberOfVertices)) &&
    this->ReadOwnParameters();
}

//------------------------------------------------------------------------------
bool vtkBitingSpaceMesher::Execution::ReadSurface()
{
  this->Progress.BeginStage("Reading the surface");
  if (!this->Accept(biting::SurfaceFromDrawing(this->Drawing, this->Given, this->Progress)) ||
    this->WasAborted())
  {
    return false;
  }
  const bool isEmpty = this->Given.Mesh.NumberOfTriangles() == 0;
  const bool isOther = isEmpty && this->Drawing.NumberOfCells > 0;
  const char* reason = "The input has no surface to mesh: cells of two dimensions.";
  return this->Accept(isOther ? reason : "") && !isEmpty;
}

//------------------------------------------------------------------------------
bool vtkBitingSpaceMesher::Execution::ReadRegions()
{
  biting::Pulse pulse(this->Progress);
  const std::string& name = this->Filter->RegionArray;
  if (!this->Accept(biting::FindRegionValues(this->Drawing, name, this->Regions, pulse)))
  {
    return false;
  }
  biting::SurfaceMesh& mesh = this->Given.Mesh;
  for (std::size_t t = 0; t < mesh.Cells.size() && this->Regions.Array; ++t)
  {
    mesh.Regions.push_back(this->Regions.Pairs[mesh.Cells[t]]);
  }
  return !pulse.HasStopped();
}

//------------------------------------------------------------------------------
bool vtkBitingSpaceMesher::Execution::ReadSpacing()
{
  const biting::SourceData source = this->Source
    ? this->Choose(this->Filter->GetInputArrayInformation(1), this->Source)
    : biting::SourceData();
  if (!source.Chosen.Array && this->Spacing.Uniform == 0.0)
  {
    this->Spacing.Uniform = this->DefaultSpacing * this->Given.Mesh.Bounds().Diagonal();
  }
  return this->Accept(biting::MakeSpaceSpacing(source, this->Spacing, this->Given.Mesh.Bounds(),
           this->Options.Spacing, this->Places, this->Progress)) &&
    !this->WasAborted();
}

//------------------------------------------------------------------------------
bool vtkBitingSpaceMesher::Execution::Check()
{
  biting::SurfaceCheckOptions options;
  const double merged = this->Filter->MergeTolerance * this->Given.Mesh.Bounds().Diagonal();
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    options.Rounding[axis] = std::max(this->Given.Rounding.Axes[axis], merged);
  }
  options.Noise = this->Given.Rounding.Most;
  options.FeatureAngle = this->Filter->FeatureAngle;
  options.TellsThickness = false;
  const auto rounding = [&options](const biting::Point3&) { return options.Noise; };
  options.Spacing = this->TakesOpen() ? rounding : this->Options.Spacing; // what is a hole
  biting::ProblemList found;
  this->Surface = biting::CheckSurface(std::move(this->Given.Mesh), options, found, this->Progress);
  options.Spacing = this->Options.Spacing;
  biting::ResolveCrossings(this->Surface, options, found, this->Progress);
  using Code = biting::ProblemCode;
  const Code meshed = this->TakesOpen() ? Code::OpenEdges : Code::PinchedVertices;
  for (const biting::ProblemGroup& group : found.Groups())
  {
    if (group.Code != Code::NonManifoldEdges && group.Code != meshed)
    {
      this->Problems.Add(group);
    }
  }
  if (this->WasAborted())
  {
    return false;
  }
  this->Options.Regions = this->Surface.Shells.RegionOf;
  for (std::size_t t = 0; t < this->Options.Regions.size() && this->Regions.Array; ++t)
  {
    this->Options.Regions[t] = this->Regions.Numbers[this->Surface.Mesh.Cells[t]];
  }
  return this->AcceptProblems(nullptr) &&
    this->Accept(this->Surface.Mesh.NumberOfTriangles() == 0
        ? "All triangles are flat, or no larger than the rounding of their coordinates or Merge "
          "Tolerance."
        : "");
}

//------------------------------------------------------------------------------
bool vtkBitingSpaceMesher::Execution::Mesh()
{
  this->MakeMesh();
  const bool isMade = this->AcceptProblems(nullptr) && !this->WasAborted();
  this->WarnOfRepairs(nullptr);
  return isMade;
}

//------------------------------------------------------------------------------
void vtkBitingSpaceMesher::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FeatureAngle: " << this->FeatureAngle << "\n"
     << indent << "BoundaryTolerance: " << this->BoundaryTolerance << "\n"
     << indent << "MergeTolerance: " << this->MergeTolerance << "\n"
     << indent << "RegionArray: " << this->RegionArray << "\n";
}

VTK_ABI_NAMESPACE_END
