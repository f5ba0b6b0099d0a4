// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

/**
 * The only file that knows versions of VTK: what newer ones have and 9.1 has not.
 */

#ifndef vtkBitingCompat_h
#define vtkBitingCompat_h

#include "vtkAlgorithm.h"     // for the abort request
#include "vtkVersionMacros.h" // for VTK_VERSION_NUMBER

#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 20220801)
#include "vtkABINamespace.h" // for the namespace macros
#endif

#ifndef VTK_ABI_NAMESPACE_BEGIN
#define VTK_ABI_NAMESPACE_BEGIN
#define VTK_ABI_NAMESPACE_END
#endif

namespace vtkBitingCompat
{

/**
 * Whether somebody asked the algorithm to stop; newer versions also ask the pipeline around it.
 */
inline bool IsAborted(vtkAlgorithm* algorithm)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 20220801)
  return algorithm->CheckAbort();
#else
  return algorithm->GetAbortExecute() != 0;
#endif
}

/**
 * Whether the algorithm was stopped, as the pipeline sees it, which then executes it again when
 * asked.
 */
inline bool WasAborted(vtkAlgorithm* algorithm)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 20220801)
  return algorithm->GetAbortOutput() || algorithm->GetAbortExecute() != 0;
#else
  return algorithm->GetAbortExecute() != 0;
#endif
}

/**
 * Makes the pipeline see the algorithm as one that was stopped.
 */
inline void Abort(vtkAlgorithm* algorithm)
{
  algorithm->SetAbortExecute(1);
  IsAborted(algorithm);
}

/**
 * Forgets a request to stop that an earlier execution has answered. 9.1 does so by itself; newer
 * versions keep it, and the algorithm would never work again.
 */
inline void ForgetAbort(vtkAlgorithm* algorithm)
{
  algorithm->SetAbortExecute(0);
}

/**
 * Makes the pipeline see an execution that was stopped as one that has ended: it is not executed
 * again before something changes.
 */
inline void EndAbort(vtkAlgorithm* algorithm)
{
  ForgetAbort(algorithm);
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 20220801)
  algorithm->SetAbortOutput(false);
#endif
}

} // namespace vtkBitingCompat

#endif
