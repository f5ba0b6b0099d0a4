// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkBitingAlgorithm.h"

#include "Bridge/Ranks/Ranks.h"
#include "Bridge/Run/FilterRun.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"

VTK_ABI_NAMESPACE_BEGIN

//------------------------------------------------------------------------------
vtkBitingAlgorithm::vtkBitingAlgorithm()
{
  this->SetNumberOfOutputPorts(4);
  // Made here, so that asking for the choice of arrays while executing changes nothing.
  this->GetInputArrayInformation(0);
  this->GetInputArrayInformation(1);
}

//------------------------------------------------------------------------------
void vtkBitingAlgorithm::SetSpacingSourceData(vtkDataObject* source)
{
  this->SetInputData(1, source);
}

//------------------------------------------------------------------------------
void vtkBitingAlgorithm::SetSpacingSourceConnection(vtkAlgorithmOutput* source)
{
  this->SetInputConnection(1, source);
}

//------------------------------------------------------------------------------
void vtkBitingAlgorithm::Stop()
{
  this->IsStopping = true;
  this->SetAbortExecute(1);
}

//------------------------------------------------------------------------------
int vtkBitingAlgorithm::RequestInformation(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  return biting::PassTimes(inputVector, this->GetNumberOfInputPorts(), outputVector);
}

//------------------------------------------------------------------------------
int vtkBitingAlgorithm::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  // Before the execution begins: what asks to stop from then on is obeyed.
  vtkBitingCompat::ForgetAbort(this);
  this->IsStopping = false;
  this->Superclass::RequestUpdateExtent(request, inputVector, outputVector);
  biting::Ranks(request, outputVector).AskForPieces(inputVector, this->GetNumberOfInputPorts());
  return 1;
}

//------------------------------------------------------------------------------
void vtkBitingAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "UniformSpacing: " << this->UniformSpacing << "\n"
     << indent << "SpacingScale: " << this->SpacingScale << "\n"
     << indent << "MinimumSpacing: " << this->MinimumSpacing << "\n"
     << indent << "MaximumSpacing: " << this->MaximumSpacing << "\n"
     << indent << "Gradation: " << this->Gradation << "\n"
     << indent << "LimitByFeatureSize: " << (this->LimitByFeatureSize ? "on" : "off") << "\n"
     << indent << "Relaxation: " << (this->Relaxation ? "on" : "off") << "\n"
     << indent << "MaximumNumberOfVertices: " << this->MaximumNumberOfVertices << "\n"
     << indent << "NumberOfThreads: " << this->NumberOfThreads << "\n"
     << indent << "Coordinates: " << this->Coordinates << "\n"
     << indent << "GenerateBites: " << (this->GenerateBites ? "on" : "off") << "\n";
}

VTK_ABI_NAMESPACE_END
