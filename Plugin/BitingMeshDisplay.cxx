// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "BitingMeshDisplay.h"

#include "pqDataRepresentation.h"
#include "pqOutputPort.h"
#include "pqScalarBarRepresentation.h"
#include "pqView.h"
#include "vtkBoundingBox.h"
#include "vtkDataObject.h"
#include "vtkPVDataInformation.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMTransferFunctionProxy.h"
#include "vtkSMViewProxy.h"

#include <algorithm> // for any_of
#include <string>    // for titles

namespace
{

struct Title
{
  const char* Array;
  const char* Text;
};

constexpr Title LegendTitles[] = { { "MinimumAngle", "Smallest angle (degrees)" },
  { "MinimumDihedralAngle", "Smallest dihedral angle (degrees)" },
  { "Conformity", "Conformity (best: 1)" }, { "RadiusEdgeRatio", "Radius-edge ratio" },
  { "AspectRatio", "Aspect ratio" } };

constexpr Title AxisTitles[] = { { "Angle", "Angle of triangles (degrees)" },
  { "DihedralAngle", "Dihedral angle of tetrahedra (degrees)" },
  { "Conformity", "Conformity of vertices (best: 1)" },
  { "RelativeLength", "Length of edges / spacing" } };

std::string Text(vtkSMProxy* proxy, const char* property)
{
  return vtkSMPropertyHelper(proxy, property).GetAsString();
}

// Whether what is seen is higher than wide.
bool IsHigh(pqView* view)
{
  vtkBoundingBox box;
  for (pqRepresentation* shown : view->getRepresentations())
  {
    auto* data = qobject_cast<pqDataRepresentation*>(shown);
    if (data && data->isVisible())
    {
      box.AddBounds(data->getOutputPortFromInput()->getDataInformation()->GetBounds());
    }
  }
  return box.IsValid() && box.GetLength(1) > box.GetLength(0);
}

constexpr const char* PlaceOfLegend = "Lower Center";

bool IsTaken(const char* place, pqView* view)
{
  const QList<pqRepresentation*> shown = view->getRepresentations();
  return std::any_of(shown.begin(), shown.end(),
    [place](pqRepresentation* legend)
    {
      return qobject_cast<pqScalarBarRepresentation*>(legend) &&
        Text(legend->getProxy(), "WindowLocation") == place;
    });
}

// Of tetrahedra there is no column Angle. A chart that has a title is one of a state.
void ChooseBins(pqDataRepresentation* histograms)
{
  constexpr const char* Bins = "DihedralAngle";
  vtkPVDataInformation* table = histograms->getOutputPortFromInput()->getDataInformation();
  vtkSMProxy* proxy = histograms->getProxy();
  if (Text(histograms->getView()->getProxy(), "BottomAxisTitle").empty() &&
    table->GetArrayInformation(Bins, vtkDataObject::ROW))
  {
    vtkSMPropertyHelper(proxy, "XArrayName").Set(Bins);
    proxy->UpdateVTKObjects();
  }
}

// Titles that are not ours are the user's.
void NameAxesOf(vtkSMProxy* histograms, vtkSMProxy* chart)
{
  const std::string old = Text(chart, "BottomAxisTitle");
  const std::string array = Text(histograms, "XArrayName");
  bool isOurs = old.empty();
  const char* text = nullptr;
  for (const Title& title : AxisTitles)
  {
    isOurs = isOurs || old == title.Text;
    text = array == title.Array ? title.Text : text;
  }
  if (isOurs && text && old != text)
  {
    vtkSMPropertyHelper(chart, "BottomAxisTitle").Set(text);
    vtkSMPropertyHelper(chart, "LeftAxisTitle").Set("Share (percent)");
    chart->UpdateVTKObjects();
  }
}

} // namespace

void SetUpLegend(pqRepresentation* legend)
{
  vtkSMProxy* proxy = legend->getProxy();
  const std::string array = Text(proxy, "Title");
  for (const Title& title : LegendTitles)
  {
    if (array == title.Array)
    {
      vtkSMPropertyHelper(proxy, "Title").Set(title.Text);
      vtkSMPropertyHelper(proxy, "RangeLabelFormat").Set("%g");
      if (!IsHigh(legend->getView()) && !IsTaken(PlaceOfLegend, legend->getView()))
      {
        vtkSMPropertyHelper(proxy, "Orientation").Set("Horizontal");
        vtkSMPropertyHelper(proxy, "WindowLocation").Set(PlaceOfLegend);
      }
      proxy->UpdateVTKObjects();
      legend->renderViewEventually();
    }
  }
}

void NameAxes(pqDataRepresentation* histograms)
{
  ChooseBins(histograms);
  pqView* chart = histograms->getView();
  QObject::connect(chart, &pqView::beginRender, histograms,
    [histograms, chart] { NameAxesOf(histograms->getProxy(), chart->getProxy()); });
  histograms->renderViewEventually();
}

void HideManyEdges(pqDataRepresentation* mesh)
{
  constexpr vtkIdType ManyTriangles = 50000; // a few pixels each
  vtkSMProxy* proxy = mesh->getProxy();
  vtkPVDataInformation* data = mesh->getOutputPortFromInput()->getDataInformation();
  if (data->GetNumberOfCells() > ManyTriangles &&
    Text(proxy, "Representation") == "Surface With Edges")
  {
    vtkSMPropertyHelper(proxy, "Representation").Set("Surface");
    proxy->UpdateVTKObjects();
    mesh->renderViewEventually();
  }
}

void ListKinds(pqDataRepresentation* problems)
{
  vtkSMProxy* colors = vtkSMPropertyHelper(problems->getProxy(), "LookupTable").GetAsProxy();
  vtkSMTransferFunctionProxy::ComputeAvailableAnnotations(colors);
  problems->renderViewEventually();
}
