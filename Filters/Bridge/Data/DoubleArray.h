// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingDoubleArray_h
#define BitingDoubleArray_h

#include "../../vtkBitingCompat.h" // for the ABI namespace

#include "vtkDoubleArray.h"  // for the return value
#include "vtkSmartPointer.h" // for the return value

#include <vector> // for values

VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;
class vtkDataSet;
VTK_ABI_NAMESPACE_END

namespace biting
{

/// `array` itself where it holds doubles, otherwise a copy of it that does. Values are not rounded.
vtkSmartPointer<vtkDoubleArray> AsDoubles(vtkDataArray* array);

/// The first `count` values of an array of one component.
std::vector<double> ReadDoubles(vtkDataArray* array, vtkIdType count);

/// The places of all points of `data`, those of a point set without a copy where they are doubles.
vtkSmartPointer<vtkDoubleArray> CoordinatesOf(vtkDataSet* data);

/// The type that they have in VTK.
int TypeOfCoordinates(vtkDataSet* data);

/// Whether all three coordinates at `place` are finite.
bool AreFinite(const double* place);

} // namespace biting

#endif
