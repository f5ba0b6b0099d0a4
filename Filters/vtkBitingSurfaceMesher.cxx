// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkBitingSurfaceMesher.h"

#include "Bridge/Drawing/CellTags.h"
#include "Bridge/Drawing/SurfaceFromDrawing.h"
#include "Bridge/Mesh/BitingSurfaceToPolyData.h"
#include "Bridge/Mesh/SurfaceToPolyData.h"
#include "Bridge/Ranks/Ranks.h"
#include "Bridge/Run/FilterRun.h"
#include "Bridge/Run/ProblemReport.h"
#include "Bridge/Source/SpaceSpacing.h"
#include "Kernel/Space/Meshing/SurfaceMesher.h"

#include "vtkCompositeDataSet.h"
#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm> // for max, transform
#include <utility>   // for move

VTK_ABI_NAMESPACE_BEGIN

static_assert(static_cast<int>(biting::ProblemCode::TooThin) == vtkBitingSurfaceMesher::TOO_THIN &&
    static_cast<int>(biting::ProblemCode::TooSharp) == vtkBitingSurfaceMesher::TOO_SHARP &&
    static_cast<int>(biting::ProblemCode::LostFeatures) == vtkBitingSurfaceMesher::LOST_FEATURES,
  "The kinds of problems that users see are those of the kernel.");

//------------------------------------------------------------------------------
// One execution. Methods return false where nothing is left to do.
class vtkBitingSurfaceMesher::Execution : private biting::FilterRun
{
public:
  explicit Execution(vtkBitingSurfaceMesher* filter)
    : FilterRun({ filter, &filter->ErrorCode, &filter->Summary, &filter->IsStopping,
                  filter->NumberOfThreads },
        // Reading, the three of CheckSurface, the three of MakeBitingSurface, writing.
        { 0.05, 0.05, 0.1, 0.05, 0.15, 0.4, 0.15, 0.05 })
    , Filter(filter)
  {
  }

  /// Fills the outputs of the filter; says what is wrong.
  void Run(const biting::WholeInput& surface, const biting::WholeInput& source,
    vtkInformationVector* outputs);

private:
  bool Gather(const biting::WholeInput& surface, const biting::WholeInput& source);
  bool ReadParameters();
  bool ReadSurface();
  bool Check();
  bool ReadRegions();
  bool ReadSpacing();
  bool MakeMesh();
  void Write(vtkInformationVector* outputs);

  vtkBitingSurfaceMesher* Filter;
  vtkSmartPointer<vtkDataObject> Source;
  biting::Drawing Drawing;
  biting::GivenSurface Given;
  biting::CheckedSurface Surface;
  biting::SpacingOptions Spacing;
  biting::SurfaceMesherOptions Options;
  biting::BitingSurface Mesh;
};

vtkStandardNewMacro(vtkBitingSurfaceMesher);

//------------------------------------------------------------------------------
vtkBitingSurfaceMesher::vtkBitingSurfaceMesher()
{
  this->SetNumberOfInputPorts(2);
}

//------------------------------------------------------------------------------
int vtkBitingSurfaceMesher::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), port);
  return 1;
}

//------------------------------------------------------------------------------
int vtkBitingSurfaceMesher::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->ErrorCode = vtkErrorCode::NoError;
  this->Summary.clear();
  const biting::Ranks ranks(request, outputVector);
  const biting::WholeInput surface(ranks, inputVector[0]);
  const biting::WholeInput source(ranks, inputVector[1]);
  if (ranks.IsFirst())
  {
    Execution(this).Run(surface, source, outputVector);
  }
  this->ErrorCode = ranks.ShareOutcome(this->ErrorCode, this->IsStopping, this, outputVector);
  return 1; // also where there was an error: views keep what was before it where this is 0
}

//------------------------------------------------------------------------------
void vtkBitingSurfaceMesher::Execution::Run(const biting::WholeInput& surface,
  const biting::WholeInput& source, vtkInformationVector* outputs)
{
  const auto run = [this, &surface, &source, outputs]()
  {
    if (this->Gather(surface, source) && this->ReadParameters() && this->ReadSurface() &&
      this->Check() && this->ReadRegions() && this->ReadSpacing() && this->MakeMesh())
    {
      this->Write(outputs);
    }
    biting::AddPlacesInSpace(this->Problems, this->Places);
    biting::ProblemsToPolyData(this->Places, vtkPolyData::GetData(outputs, PROBLEMS));
  };
  this->Guard(outputs, run);
}

//------------------------------------------------------------------------------
bool vtkBitingSurfaceMesher::Execution::Gather(
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
bool vtkBitingSurfaceMesher::Execution::ReadParameters()
{
  const vtkBitingSurfaceMesher& filter = *this->Filter;
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
    this->Accept(biting::CheckMergeTolerance(filter.MergeTolerance)) &&
    this->Accept(biting::CheckMostVertices(filter.MaximumNumberOfVertices));
}

//------------------------------------------------------------------------------
bool vtkBitingSurfaceMesher::Execution::ReadSurface()
{
  this->Progress.BeginStage("Reading the surface");
  if (!this->Accept(biting::SurfaceFromDrawing(this->Drawing, this->Given, this->Progress)) ||
    this->WasAborted())
  {
    return false;
  }
  const bool isEmpty = this->Given.Mesh.NumberOfTriangles() == 0;
  return this->Accept(isEmpty && this->Drawing.NumberOfCells > 0
             ? "The input has no surface to mesh: cells of two dimensions."
             : "") &&
    !isEmpty;
}

//------------------------------------------------------------------------------
bool vtkBitingSurfaceMesher::Execution::Check()
{
  biting::SurfaceCheckOptions options;
  const double merged = this->Filter->MergeTolerance * this->Given.Mesh.Bounds().Diagonal();
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    options.Rounding[axis] = std::max(this->Given.Rounding.Axes[axis], merged);
  }
  options.Noise = this->Given.Rounding.Most;
  options.FeatureAngle = this->Filter->FeatureAngle;
  biting::ProblemList found;
  this->Surface = biting::CheckSurface(std::move(this->Given.Mesh), options, found, this->Progress);
  for (const biting::ProblemGroup& group : found.Groups())
  {
    const bool isMeshed = group.Code == biting::ProblemCode::OpenEdges ||
      group.Code == biting::ProblemCode::NonManifoldEdges;
    for (const biting::Problem& problem : group.First)
    {
      if (!isMeshed)
      {
        this->Problems.Add(problem);
      }
    }
  }
  return this->AcceptProblems(nullptr) && !this->WasAborted();
}

//------------------------------------------------------------------------------
bool vtkBitingSurfaceMesher::Execution::ReadRegions()
{
  biting::Pulse pulse(this->Progress);
  std::vector<biting::Id> numbers;
  if (!this->Accept(
        biting::FindRegionNumbers(this->Drawing, this->Filter->RegionArray, numbers, pulse)))
  {
    return false;
  }
  this->Options.Regions = this->Surface.Shells.RegionOf;
  if (!numbers.empty())
  {
    const std::vector<biting::Id>& cells = this->Surface.Mesh.Cells;
    std::transform(cells.begin(), cells.end(), this->Options.Regions.begin(),
      [&numbers](biting::Id cell) { return numbers[static_cast<std::size_t>(cell)]; });
  }
  return !pulse.HasStopped();
}

//------------------------------------------------------------------------------
bool vtkBitingSurfaceMesher::Execution::ReadSpacing()
{
  biting::SourceData source;
  if (this->Source)
  {
    source = this->Choose(this->Filter->GetInputArrayInformation(1), this->Source);
  }
  if (!source.Chosen.Array && this->Spacing.Uniform == 0.0)
  {
    constexpr double DefaultShare = 0.02; // of the diagonal
    this->Spacing.Uniform = DefaultShare * this->Surface.Figures.Diagonal;
  }
  return this->Accept(biting::MakeSpaceSpacing(source, this->Spacing, this->Surface.Mesh.Bounds(),
           this->Options.Spacing, this->Places, this->Progress)) &&
    !this->WasAborted();
}

//------------------------------------------------------------------------------
bool vtkBitingSurfaceMesher::Execution::MakeMesh()
{
  this->Mesh =
    biting::MakeBitingSurface(this->Surface, this->Options, this->Problems, this->Progress);
  const bool isMade = this->AcceptProblems(nullptr) && !this->WasAborted();
  this->WarnOfRepairs(nullptr);
  return isMade;
}

//------------------------------------------------------------------------------
void vtkBitingSurfaceMesher::Execution::Write(vtkInformationVector* outputs)
{
  this->Progress.BeginStage("Writing the mesh");
  biting::Pulse pulse(this->Progress);
  vtkPolyData* mesh = vtkPolyData::GetData(outputs, MESH);
  this->Filter->Summary =
    biting::BitingSurfaceToPolyData(this->Mesh, this->Surface, this->Drawing, mesh, pulse) +
    this->Filter->Summary;
  biting::EdgesToPolyData(this->Mesh.Points, this->Mesh.EdgeEnds, this->Mesh.EdgeKinds, mesh,
    vtkPolyData::GetData(outputs, BOUNDARY_EDGES));
  if (this->Filter->GenerateBites)
  {
    biting::SpheresToPolyData(this->Mesh, vtkPolyData::GetData(outputs, BITES));
  }
}

//------------------------------------------------------------------------------
void vtkBitingSurfaceMesher::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FeatureAngle: " << this->FeatureAngle << "\n"
     << indent << "BoundaryTolerance: " << this->BoundaryTolerance << "\n"
     << indent << "MergeTolerance: " << this->MergeTolerance << "\n"
     << indent << "RegionArray: " << this->RegionArray << "\n";
}

VTK_ABI_NAMESPACE_END
