// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "JudgedMesh.h"

#include <algorithm> // for lower_bound

namespace biting
{

bool JudgedMesh::Refuse(const std::string& violation)
{
  this->Violation = violation;
  return false;
}

const HalfEdge* JudgedMesh::FindHalf(Id start, Id end) const
{
  const HalfEdge wanted{ start, end, 0 };
  const auto found = std::lower_bound(this->Halves.begin(), this->Halves.end(), wanted);
  return found != this->Halves.end() && found->Ends() == wanted.Ends() ? &*found : nullptr;
}

bool JudgedMesh::IsCovering(const HalfEdge& half) const
{
  const std::pair<Id, Id> ends = std::minmax(half.Start, half.End);
  return std::binary_search(this->Covering.begin(), this->Covering.end(), ends);
}

std::string JudgedMesh::EdgeText(Id start, Id end) const
{
  return "edge " + PlaceText(this->Place(start)) + " - " + PlaceText(this->Place(end));
}

std::string FindMeshViolation(
  const BitingMesh& mesh, const Polylines& input, const BitingMeshOptions& options)
{
  JudgedMesh judged(mesh, input, options);
  (void)(HoldsTopology(judged) && HoldsDrawing(judged) && HoldsFigures(judged));
  return judged.Violation;
}

} // namespace biting
