// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkBitingMesher.h"

#include "Bridge/Ranks/Ranks.h"
#include "Bridge/Run/SummaryText.h"
#include "Kernel/Base/Problem.h"
#include "vtkBitingMesherExecution.h"

#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <array> // for sums

VTK_ABI_NAMESPACE_BEGIN

static_assert(
  static_cast<int>(biting::ProblemCode::NoClosedLoop) == vtkBitingMesher::NO_CLOSED_LOOP &&
    static_cast<int>(biting::ProblemCode::CheckFailed) == vtkBitingMesher::CHECK_FAILED &&
    static_cast<int>(biting::ProblemCode::FineDrawing) == vtkBitingMesher::FINE_DRAWING &&
    static_cast<int>(biting::ProblemCode::NestedCells) == vtkBitingMesher::NESTED_CELLS,
  "The kinds of problems that users see are those of the kernel.");

namespace
{

// All ranks call it.
biting::SummaryCounts CountOnAll(const biting::Ranks& ranks, vtkDataSet* piece)
{
  biting::SummaryCounts counts = biting::CountForSummary(piece);
  std::array<double, 4> sums{ counts.Triangles, counts.SumOfAngles, counts.Thin,
    counts.ThinAtInput };
  ranks.AddUp(sums.data(), static_cast<vtkIdType>(sums.size()));
  const double largest = ranks.Largest(counts.LargestSpacing);
  return { sums[0], sums[1], sums[2], sums[3], largest };
}

} // namespace

vtkStandardNewMacro(vtkBitingMesher);

//------------------------------------------------------------------------------
vtkBitingMesher::vtkBitingMesher()
{
  this->SetNumberOfInputPorts(2);
}

//------------------------------------------------------------------------------
void vtkBitingMesher::SetBoundarySpacingArray(int vtkNotUsed(index), int vtkNotUsed(port),
  int vtkNotUsed(connection), int association, const char* name)
{
  this->BoundaryArray = vtkSmartPointer<vtkInformation>::New();
  this->BoundaryArray->Set(vtkDataObject::FIELD_ASSOCIATION(), association);
  this->BoundaryArray->Set(vtkDataObject::FIELD_NAME(), name ? name : "");
  this->Modified();
}

//------------------------------------------------------------------------------
vtkInformation* vtkBitingMesher::BoundaryArrayChoice()
{
  return this->BoundaryArray ? this->BoundaryArray.Get() : this->GetInputArrayInformation(0);
}

//------------------------------------------------------------------------------
// The pipeline goes through the blocks of what the port does not take as a whole.
void vtkBitingMesher::SetMeshBlocksSeparately(bool separately)
{
  if (this->MeshBlocksSeparately != separately)
  {
    this->MeshBlocksSeparately = separately;
    this->FillInputPortInformation(0, this->GetInputPortInformation(0));
    this->Modified();
  }
}

//------------------------------------------------------------------------------
int vtkBitingMesher::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 0)
  {
    info->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
    if (!this->MeshBlocksSeparately)
    {
      info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
    }
    return 1;
  }
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

//------------------------------------------------------------------------------
int vtkBitingMesher::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->IsPassingBlocks =
    this->MeshBlocksSeparately && vtkCompositeDataSet::GetData(inputVector[0]) != nullptr;
  return this->Superclass::RequestUpdateExtent(request, inputVector, outputVector);
}

//------------------------------------------------------------------------------
int vtkBitingMesher::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->ErrorCode = vtkErrorCode::NoError;
  this->Summary.clear();
  const biting::Stopwatch watch;
  // Ranks may have different numbers of blocks: each meshes its own.
  const biting::Ranks ranks =
    this->IsPassingBlocks ? biting::Ranks() : biting::Ranks(request, outputVector);
  biting::WholeInput drawing(ranks, inputVector[0]);
  biting::WholeInput source(ranks, inputVector[1]);
  biting::RankCrew crew(ranks, { &drawing, &source });
  bool isSpread = false;
  if (ranks.IsFirst())
  {
    Execution execution(this, crew);
    execution.Run(drawing, source, outputVector);
    isSpread = execution.HasSpread();
  }
  else if (ranks.AreSeveral())
  {
    Execution(this, crew).Help(drawing, source, outputVector);
  }
  this->ErrorCode = ranks.ShareOutcome(this->ErrorCode, isSpread, this, outputVector);
  vtkPolyData* mesh = vtkPolyData::GetData(outputVector, MESH);
  const biting::SummaryCounts counts = CountOnAll(ranks, mesh);
  this->Summary = biting::SummaryOf(mesh, counts, watch.Seconds()) +
    biting::UnreachedLine(counts, this->UniformSpacing * this->SpacingScale) + this->Summary;
  return 1; // also where there was an error: views keep the mesh before it where this is 0
}

//------------------------------------------------------------------------------
void vtkBitingMesher::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "RepairInput: " << (this->RepairInput ? "on" : "off") << "\n"
     << indent << "CellsAcross: " << this->CellsAcross << "\n"
     << indent << "DomainRule: " << this->DomainRule << "\n"
     << indent << "RegionArray: " << this->RegionArray << "\n"
     << indent << "KeepCellEdges: " << (this->KeepCellEdges ? "on" : "off") << "\n"
     << indent << "MeshBlocksSeparately: " << (this->MeshBlocksSeparately ? "on" : "off") << "\n"
     << indent << "MergeTolerance: " << this->MergeTolerance << "\n"
     << indent << "EndTolerance: " << this->EndTolerance << "\n"
     << indent << "PreserveBoundary: " << (this->PreserveBoundary ? "on" : "off") << "\n"
     << indent << "BoundaryTolerance: " << this->BoundaryTolerance << "\n"
     << indent << "CornerAngle: " << this->CornerAngle << "\n"
     << indent << "MinimumLoopSize: " << this->MinimumLoopSize << "\n"
     << indent << "BiteShape: " << this->BiteShape << "\n"
     << indent << "BitingConstant: " << this->BitingConstant << "\n"
     << indent << "Placement: " << this->Placement << "\n"
     << indent << "FrontOrder: " << this->FrontOrder << "\n"
     << indent << "MaximumNumberOfBites: " << this->MaximumNumberOfBites << "\n"
     << indent << "VerticesPerBlock: " << this->VerticesPerBlock << "\n"
     << indent << "TransferSourceArrays: " << (this->TransferSourceArrays ? "on" : "off") << "\n"
     << indent << "Phi: " << this->Phi << "\n";
  os << indent << "SplitInterfaces: " << this->SplitInterfaces << "\n";
  for (const double* vector : { this->PeriodicTranslation, this->PeriodicTranslation2 })
  {
    os << indent
       << (vector == this->PeriodicTranslation ? "PeriodicTranslation: " : "PeriodicTranslation2: ")
       << vector[0] << " " << vector[1] << " " << vector[2] << "\n";
  }
}

VTK_ABI_NAMESPACE_END
