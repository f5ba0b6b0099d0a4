// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingMeshCases_h
#define BitingMeshCases_h

#include "BitingMesh.h"

#include <string> // for names
#include <vector> // for the list

/// A drawing and what is wanted of its mesh.
struct MeshCase
{
  std::string Name;
  biting::Polylines Drawing; ///< without points: its file is not there
  biting::BitingMeshOptions Options;
};

/// The unit square and one spacing: about as many vertices as asked for.
MeshCase UniformSquare(double vertices);

/// Section 6 of the paper.
MeshCase SectionSix(double vertices);

/// The unit square with seven by seven holes, the spacing an image of 513 x 513 pixels.
MeshCase SquareWithHoles();

/// A drawing of the folder Data, or of the folder that BITING_SHARED_INPUTS names. Its point array
/// is the spacing at its points, where it has one; lengths are otherwise `share` of what is usual.
MeshCase OfFile(const std::string& name, double gradation, double share = 1.0);

/// Those of which the cost is known over the years.
std::vector<MeshCase> CostCases(double mostVertices);

/// Those over which the quality is a mean.
std::vector<MeshCase> QualityCases();

/// One a kind of source, and of field.
std::vector<MeshCase> FieldCases();

#endif
