// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkBitingSurfaceCheck.h"

#include "Bridge/Drawing/SurfaceFromDrawing.h"
#include "Bridge/Mesh/SurfaceToPolyData.h"
#include "Bridge/Ranks/Ranks.h"
#include "Bridge/Run/FilterRun.h"
#include "Bridge/Run/ProblemReport.h"

#include "vtkCompositeDataSet.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <utility> // for move

VTK_ABI_NAMESPACE_BEGIN

static_assert(
  static_cast<int>(biting::ProblemCode::FlatTriangles) == vtkBitingSurfaceCheck::FLAT_TRIANGLES &&
    static_cast<int>(biting::ProblemCode::OpenEdges) == vtkBitingSurfaceCheck::OPEN_EDGES &&
    static_cast<int>(biting::ProblemCode::SurfaceTouches) == vtkBitingSurfaceCheck::SURFACE_TOUCHES,
  "The kinds of problems that users see are those of the kernel.");

//------------------------------------------------------------------------------
class vtkBitingSurfaceCheck::Execution : public biting::FilterRun
{
public:
  explicit Execution(vtkBitingSurfaceCheck* filter)
    : FilterRun({ filter, &filter->ErrorCode, &filter->Summary, nullptr, filter->NumberOfThreads },
        { 0.1, 0.2, 0.5, 0.1, 0.1 }) // reading, the three of CheckSurface, writing
    , Filter(filter)
  {
  }

  /// Fills the outputs of the filter; says what is wrong.
  void Run(const biting::WholeInput& input, vtkInformationVector* outputs)
  {
    this->Guard(outputs, [this, &input, outputs]() { this->Check(input, outputs); });
  }

private:
  void Check(const biting::WholeInput& input, vtkInformationVector* outputs);
  void Write(const biting::CheckedSurface& surface, const biting::Drawing& drawing,
    vtkInformationVector* outputs);

  vtkBitingSurfaceCheck* Filter;
};

vtkStandardNewMacro(vtkBitingSurfaceCheck);

//------------------------------------------------------------------------------
vtkBitingSurfaceCheck::vtkBitingSurfaceCheck()
{
  this->SetNumberOfOutputPorts(3);
}

//------------------------------------------------------------------------------
int vtkBitingSurfaceCheck::FillInputPortInformation(int vtkNotUsed(port), vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

//------------------------------------------------------------------------------
int vtkBitingSurfaceCheck::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkBitingCompat::ForgetAbort(this);
  this->Superclass::RequestUpdateExtent(request, inputVector, outputVector);
  biting::Ranks(request, outputVector).AskForPieces(inputVector, this->GetNumberOfInputPorts());
  return 1;
}

//------------------------------------------------------------------------------
int vtkBitingSurfaceCheck::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->Summary.clear();
  return biting::RunOnFirstRank(this, this->ErrorCode, { request, inputVector, outputVector },
    [this, outputVector](const biting::WholeInputs& inputs)
    { Execution(this).Run(inputs[0], outputVector); });
}

//------------------------------------------------------------------------------
void vtkBitingSurfaceCheck::Execution::Check(
  const biting::WholeInput& input, vtkInformationVector* outputs)
{
  if (!this->AcceptComplete({ &input }))
  {
    return;
  }
  this->Progress.BeginStage("Reading the surface");
  const biting::Drawing drawing = biting::ReadDrawing(input.Make());
  biting::GivenSurface given;
  if (!this->Accept(biting::SurfaceFromDrawing(drawing, given, this->Progress)) ||
    this->WasAborted())
  {
    return;
  }
  if (given.Mesh.NumberOfTriangles() == 0)
  {
    this->Accept(drawing.NumberOfCells > 0 ? "The input has no surface to check." : "");
    return;
  }
  biting::SurfaceCheckOptions options;
  const std::array<double, 3>& axes = given.Rounding.Axes;
  options.Rounding = { axes[0], axes[1], axes[2] };
  options.Noise = given.Rounding.Most;
  options.FeatureAngle = this->Filter->FeatureAngle;
  const biting::CheckedSurface surface =
    biting::CheckSurface(std::move(given.Mesh), options, this->Problems, this->Progress);
  if (!this->WasAborted() &&
    this->Accept(surface.Mesh.NumberOfTriangles() == 0
        ? "All triangles are flat, or no larger than the rounding of their coordinates."
        : ""))
  {
    this->Progress.BeginStage("Writing the surface");
    this->Write(surface, drawing, outputs);
  }
}

//------------------------------------------------------------------------------
void vtkBitingSurfaceCheck::Execution::Write(const biting::CheckedSurface& surface,
  const biting::Drawing& drawing, vtkInformationVector* outputs)
{
  biting::Pulse pulse(this->Progress);
  vtkPolyData* mesh = vtkPolyData::GetData(outputs, 0);
  biting::SurfaceToPolyData(surface, this->Problems, drawing, mesh, pulse);
  biting::EdgesToPolyData(surface.Mesh.Points, surface.EdgeEnds, surface.EdgeKinds, mesh,
    vtkPolyData::GetData(outputs, 1));
  biting::AddPlacesInSpace(this->Problems, this->Places);
  biting::ProblemsToPolyData(this->Places, vtkPolyData::GetData(outputs, 2));
  this->Filter->Summary = biting::SummaryOf(surface, this->Problems);
}

//------------------------------------------------------------------------------
void vtkBitingSurfaceCheck::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FeatureAngle: " << this->FeatureAngle << "\n"
     << indent << "NumberOfThreads: " << this->NumberOfThreads << "\n";
}

VTK_ABI_NAMESPACE_END
