// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "BitingMeshLook.h"

#include "vtkSMSettings.h"

namespace
{

// Colours stay with their values whatever the data, so that red is bad in every mesh.
constexpr const char* ColorsOfArrays = R"({ "array_lookup_tables" : {
  "MinimumAngle" : { "PVLookupTable" : { "ColorSpace" : 0, "AutomaticRescaleRangeMode" : -1,
    "ScalarRangeInitialized" : 1, "RGBPoints" : [ 0, 0.5, 0, 0.15, 15, 0.85, 0.1, 0.1,
      30, 0.98, 0.75, 0.35, 45, 0.95, 0.97, 0.88, 60, 0.6, 0.82, 0.92 ] } },
  "MinimumDihedralAngle" : { "PVLookupTable" : { "ColorSpace" : 0, "AutomaticRescaleRangeMode" : -1,
    "ScalarRangeInitialized" : 1, "RGBPoints" : [ 0, 0.5, 0, 0.15, 15, 0.85, 0.1, 0.1,
      30, 0.98, 0.75, 0.35, 50, 0.95, 0.97, 0.88, 70, 0.6, 0.82, 0.92 ] } },
  "Conformity" : { "PVLookupTable" : { "ColorSpace" : 0, "AutomaticRescaleRangeMode" : -1,
    "ScalarRangeInitialized" : 1, "RGBPoints" : [ 0, 0.5, 0, 0.15, 0.4, 0.85, 0.1, 0.1,
      0.7, 0.98, 0.75, 0.35, 0.85, 0.95, 0.97, 0.88, 1, 0.6, 0.82, 0.92 ] } },
  "RadiusEdgeRatio" : { "PVLookupTable" : { "ColorSpace" : 0, "AutomaticRescaleRangeMode" : -1,
    "ScalarRangeInitialized" : 1, "RGBPoints" : [ 0.577, 0.6, 0.82, 0.92, 0.7, 0.95, 0.97, 0.88,
      1, 0.98, 0.75, 0.35, 2, 0.85, 0.1, 0.1, 4, 0.5, 0, 0.15 ] } },
  "AspectRatio" : { "PVLookupTable" : { "ColorSpace" : 0, "AutomaticRescaleRangeMode" : -1,
    "ScalarRangeInitialized" : 1, "RGBPoints" : [ 2, 0.6, 0.82, 0.92, 2.5, 0.95, 0.97, 0.88,
      4, 0.98, 0.75, 0.35, 8, 0.85, 0.1, 0.1, 16, 0.5, 0, 0.15 ] } },
  "Phase" : { "PVLookupTable" : { "IndexedLookup" : 1,
    "Annotations" : [ "0", "Vertices", "1", "Edges",
      "2", "Interior", "3", "Front" ], "IndexedColors" : [ 0.83, 0.42, 0.25, 0.95, 0.7, 0.2,
      0.3, 0.55, 0.85, 0.9, 0, 0 ] } },
  "EdgeKind" : { "PVLookupTable" : { "IndexedLookup" : 1,
    "Annotations" : [ "0", "Feature", "1", "Border", "2", "More than two triangles" ],
    "IndexedColors" : [ 0.1, 0.1, 0.1, 1, 0.1, 0.1, 0.8, 0, 0.8 ] } },
  "ProblemKind" : { "PVLookupTable" : { "IndexedLookup" : 1, "AutomaticRescaleRangeMode" : 3,
    "ShowIndexedColorActiveValues" : 1, "Annotations" : [
      "0", "Duplicate points", "1", "Zero length", "2", "Overlapping segments", "3", "Crossing",
      "4", "Touch", "5", "Point outside", "6", "Interface outside", "7", "Open end",
      "8", "Not finite", "9", "Out of range", "10", "Off the plane", "11", "Bad spacing",
      "12", "Too many vertices", "13", "Not resolved", "14", "Check failed",
      "15", "Overlapping cells", "16", "Near points", "17", "Narrow angle",
      "18", "Raised spacing", "19", "Small loop", "20", "Fine drawing", "21", "Bad triangle",
      "22", "Flat triangle", "23", "Joined end", "24", "Open outline", "25", "Near miss",
      "26", "Changed area", "27", "Cell in a cell",
      "28", "Open edges", "29", "Non-manifold edge",
      "30", "Pinched vertex", "31", "Fold", "32", "Self-crossing", "33", "One side only",
      "34", "Duplicate triangle", "35", "Turned triangles", "36", "Touch within rounding",
      "37", "Side without partner", "38", "Too thin", "39", "Too sharp",
      "40", "Lost feature line", "41", "Closed hole", "42", "Small crossing",
      "43", "United surfaces" ],
    "IndexedColors" : [ 0.6, 0.6, 0.6, 0.4, 0.4, 0.4, 0.95, 0.6, 0.1, 1, 0.85, 0.1,
      0.55, 0.35, 0.85, 0.2, 0.6, 0.9, 0.1, 0.75, 0.75, 1, 0.1, 0.1, 0.75, 0, 0.4, 0.55, 0, 0.25,
      0.95, 0.3, 0.6, 0.5, 0.3, 0.1, 0.2, 0.2, 0.2, 0.9, 0.4, 0, 0, 0, 0,
      0.6, 0.4, 0.1, 0.75, 0.75, 0.75, 0.8, 0.7, 0.3, 0.5, 0.5, 0.7, 0.4, 0.65, 0.4,
      0.7, 0.55, 0.7, 0.8, 0.1, 0.3, 0.45, 0.75, 0.6, 0.95, 0.75, 0.5, 0.7, 0, 0,
      0.95, 0.45, 0.75, 0.35, 0.35, 0.6, 0.3, 0.7, 0.3, 1, 0.4, 0, 0.8, 0, 0.8,
      0.5, 0, 0.5, 0.9, 0.8, 0,
      1, 0, 0, 0.3, 0, 0, 0.4, 0.7, 0.9, 0.3, 0.8, 0.3, 0.7, 0.7, 0.7,
      0.9, 0.5, 0, 1, 0.2, 0.5, 0.8, 0, 0.3, 0.4, 0.4, 0.8,
      0.2, 0.75, 0.55, 0.9, 0.65, 0.65, 0.25, 0.45, 0.85 ] } } } })";

constexpr const char* Representations = R"({ "representations" : {
  "BitingMeshRepresentation" : { "EdgeColor" : [ 0.85, 0.88, 0.9 ] },
  "BitingEdgesRepresentation" : { "LineWidth" : 2.5,
    "AmbientColor" : [ 0, 0, 0 ], "DiffuseColor" : [ 0, 0, 0 ] },
  "BitingBitesRepresentation" : { "Opacity" : 0.8 },
  "BitingProblemsRepresentation" : { "PointSize" : 14,
    "RenderPointsAsSpheres" : 1, "AmbientColor" : [ 1, 0.1, 0.1 ],
    "DiffuseColor" : [ 1, 0.1, 0.1 ] },
  "BitingHistogramsRepresentation" : { "SeriesVisibility" : [ "Angle", "0", "AnglePercent", "1",
    "DihedralAngle", "0",
    "Conformity", "0", "ConformityPercent", "0", "RelativeLength", "0",
    "RelativeLengthPercent", "0" ] } } })";

// Below all that users choose.
constexpr double LowestPriority = 0.0;

} // namespace

void AddBitingMeshLook()
{
  vtkSMSettings* settings = vtkSMSettings::GetInstance();
  settings->AddCollectionFromString(ColorsOfArrays, LowestPriority);
  settings->AddCollectionFromString(Representations, LowestPriority);
}
