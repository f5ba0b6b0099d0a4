// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingMeshDisplay_h
#define BitingMeshDisplay_h

class pqDataRepresentation;
class pqRepresentation;

/// Gives the legend of an array of ours a title with its unit, plain numbers, and a place below the
/// mesh, or at the right of one that is higher than wide. A title that a user has set stays, and so
/// does its legend.
void SetUpLegend(pqRepresentation* legend);

/// Names the axes of the chart of our histograms, whichever of them it shows.
void NameAxes(pqDataRepresentation* histograms);

/// Shows a mesh without its edges where these would hide its colours.
void HideManyEdges(pqDataRepresentation* mesh);

/// Leaves those kinds in the legend of problems that there are.
void ListKinds(pqDataRepresentation* problems);

#endif
