// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingTransferredArrays_h
#define BitingTransferredArrays_h

#include "../../Kernel/Base/Point.h"
#include "../../Kernel/Base/Pulse.h"
#include "../../vtkBitingCompat.h" // for the ABI namespace
#include "../Drawing/PlaneFrame.h"

#include <vector> // for places

VTK_ABI_NAMESPACE_BEGIN
class vtkDataObject;
class vtkPointData;
VTK_ABI_NAMESPACE_END

namespace biting
{

/// Adds the point arrays of `source`, a dataset or blocks of such, to `to`, the data of points at
/// `places` in the plane `frame`: real numbers interpolated by the cells that the spacing is
/// interpolated by, linear in triangles and bilinear in grids, of anything else the value of the
/// nearest corner; outside of them the value at the nearest place of their border. Cells with a
/// point whose ValidMaskName is 0 are none. Then the array ValidMaskName says where: 1 in a cell,
/// or within 1e-6 of the source's size of one, else 0. Arrays that `to` has already, ghosts, ids,
/// and all where no cell lies in the plane, are left out. On abort `to` has no meaning.
void TransferArrays(vtkDataObject* source, const PlaneFrame& frame,
  const std::vector<Point2>& places, vtkPointData* to, Pulse& pulse);

} // namespace biting

#endif
