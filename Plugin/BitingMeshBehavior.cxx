// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "BitingMeshBehavior.h"
#include "BitingMeshDisplay.h"

#include "pqApplicationCore.h"
#include "pqDataRepresentation.h"
#include "pqOutputPort.h"
#include "pqPipelineFilter.h"
#include "pqPipelineSource.h"
#include "pqProgressManager.h"
#include "pqScalarBarRepresentation.h"
#include "pqServerManagerModel.h"
#include "pqUndoStack.h"
#include "pqView.h"
#include "vtkBitingAlgorithm.h"
#include "vtkCommand.h"
#include "vtkDataObject.h"
#include "vtkNew.h"
#include "vtkPVDataInformation.h"
#include "vtkSMArrayListDomain.h"
#include "vtkSMPVRepresentationProxy.h"
#include "vtkSMParaViewPipelineControllerWithRendering.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMViewProxy.h"
#include "vtkSmartPointer.h"

#include <QGuiApplication>
#include <QTimer>
#include <QVariant>

#include <algorithm> // for any_of, find_if
#include <cstring>   // for strcmp
#include <string>    // for names

namespace
{

constexpr int MeshPort = 0;
constexpr int ProblemsPort = 3;

// An output of a mesher that may be empty, and the array that colours it; of tetrahedra another.
struct Output
{
  int Port;
  const char* Array;
  int Association;
};
constexpr const char* ArrayOfTetrahedra = "MinimumDihedralAngle";
constexpr Output MayBeEmpty[] = { { MeshPort, "MinimumAngle", vtkDataObject::CELL },
  { 2, "Phase", vtkDataObject::CELL }, { ProblemsPort, "ProblemKind", vtkDataObject::POINT } };

// What our filters add to points: nobody's solution.
constexpr const char* OwnArrays[] = { "BiteOrder", "Conformity", "HessianNorm",
  "NearestNeighborDistance", "OriginalPointId", "Spacing", "VertexKind" };

// A choice of an array has five elements: the name is the last.
constexpr unsigned int NameElement = 4;

// The property of a representation that tells that we, and no user, have hidden it.
constexpr const char* IsHiddenByUs = "BitingIsHidden";

// The property of a representation of a drawing that tells that we, and no user, have shown it.
constexpr const char* IsShownByUs = "BitingIsShown";

// The properties of a filter that the stop keys were held down for it, and that it was stopped.
constexpr const char* IsStopAsked = "BitingIsStopAsked";
constexpr const char* IsStopped = "BitingIsStopped";

bool IsA(pqPipelineSource* source, const char* name)
{
  return std::strcmp(source->getProxy()->GetXMLName(), name) == 0;
}

bool HasProblems(pqPipelineSource* source)
{
  return IsA(source, "BitingMesher") || IsA(source, "BitingRemesher") ||
    IsA(source, "BitingSurfaceMesher") || IsA(source, "BitingTetrahedralizer");
}

bool IsEmpty(pqPipelineSource* source, int port)
{
  return source->getOutputPort(port)->getDataInformation()->GetNumberOfPoints() == 0;
}

const Output* OutputOf(pqOutputPort* port)
{
  if (!port || !HasProblems(port->getSource()))
  {
    return nullptr;
  }
  const auto* found = std::find_if(std::begin(MayBeEmpty), std::end(MayBeEmpty),
    [port](const Output& output) { return output.Port == port->getPortNumber(); });
  return found != std::end(MayBeEmpty) ? found : nullptr;
}

// With a legend.
void Color(
  vtkSMPVRepresentationProxy* proxy, pqOutputPort* port, vtkSMViewProxy* view, const Output& output)
{
  const bool isOfTetrahedra =
    output.Port == MeshPort && IsA(port->getSource(), "BitingTetrahedralizer");
  const char* array = isOfTetrahedra ? ArrayOfTetrahedra : output.Array;
  // Bites in space have no phases.
  const bool isThere =
    port->getDataInformation()->GetArrayInformation(array, output.Association) != nullptr;
  if (isThere && !proxy->GetUsingScalarColoring())
  {
    // The colours of all these arrays belong to their values: nothing is to be rescaled.
    proxy->SetScalarColoring(array, output.Association);
  }
  if (proxy->GetUsingScalarColoring())
  {
    proxy->SetScalarBarVisibility(view, true);
  }
}

void Show(pqDataRepresentation* representation, const Output& output)
{
  vtkSMViewProxy* view = representation->getView()->getViewProxy();
  vtkNew<vtkSMParaViewPipelineControllerWithRendering> controller;
  controller->Show(
    representation->getOutputPortFromInput()->getSource()->getSourceProxy(), output.Port, view);
  if (auto* proxy = vtkSMPVRepresentationProxy::SafeDownCast(representation->getProxy()))
  {
    Color(proxy, representation->getOutputPortFromInput(), view, output);
  }
  representation->renderViewEventually();
}

void Hide(pqDataRepresentation* representation)
{
  vtkNew<vtkSMParaViewPipelineControllerWithRendering> controller;
  controller->Hide(representation->getProxy(), representation->getView()->getViewProxy());
  representation->renderViewEventually();
}

// Hides what is empty, and shows it again when it is not.
void Follow(pqDataRepresentation* representation)
{
  pqOutputPort* port = representation->getOutputPortFromInput();
  const Output* output = OutputOf(port);
  if (!output || !representation->getView())
  {
    return;
  }
  const bool isEmpty = IsEmpty(port->getSource(), output->Port);
  const bool isHiddenByUs = representation->property(IsHiddenByUs).toBool();
  SCOPED_UNDO_EXCLUDE();
  if (isEmpty && representation->isVisible())
  {
    representation->setProperty(IsHiddenByUs, true);
    Hide(representation);
  }
  else if (!isEmpty && isHiddenByUs)
  {
    representation->setProperty(IsHiddenByUs, false);
    Show(representation, *output);
  }
  if (!isEmpty && output->Port == ProblemsPort)
  {
    ListKinds(representation);
  }
}

// What is shown for the first time.
void SetUp(pqRepresentation* added)
{
  auto* representation = qobject_cast<pqDataRepresentation*>(added);
  pqOutputPort* port = representation ? representation->getOutputPortFromInput() : nullptr;
  if (qobject_cast<pqScalarBarRepresentation*>(added))
  {
    SetUpLegend(added);
  }
  if (!port || !added->getView())
  {
    return;
  }
  const char* look = added->getProxy()->GetXMLName();
  SCOPED_UNDO_EXCLUDE();
  if (std::strcmp(look, "BitingMeshRepresentation") == 0)
  {
    HideManyEdges(representation);
  }
  else if (std::strcmp(look, "BitingHistogramsRepresentation") == 0)
  {
    NameAxes(representation);
  }
  if (OutputOf(port) && representation->isVisible())
  {
    port->getSource()->updatePipeline(); // states are loaded before they are executed
  }
  Follow(representation);
}

// Shows the drawing again where there is no mesh in its place, under the spheres of its problems.
void FollowDrawing(pqPipelineFilter* mesher, pqView* view)
{
  pqOutputPort* drawing = mesher ? mesher->getAnyInput() : nullptr;
  pqDataRepresentation* representation = drawing ? drawing->getRepresentation(view) : nullptr;
  if (!representation || !mesher->getRepresentation(MeshPort, view))
  {
    return;
  }
  const bool isMissing = IsEmpty(mesher, MeshPort);
  const bool isShownByUs = representation->property(IsShownByUs).toBool();
  SCOPED_UNDO_EXCLUDE();
  if (isMissing && !representation->isVisible())
  {
    representation->setProperty(IsShownByUs, true);
    vtkNew<vtkSMParaViewPipelineControllerWithRendering> controller;
    controller->Show(
      drawing->getSource()->getSourceProxy(), drawing->getPortNumber(), view->getViewProxy());
    representation->renderViewEventually();
  }
  else if (!isMissing && isShownByUs)
  {
    representation->setProperty(IsShownByUs, false);
    Hide(representation);
  }
}

// A filter that was stopped is executed again where the same is applied again.
void FollowStop(pqPipelineSource* source)
{
  if (source->property(IsStopAsked).toBool() && IsEmpty(source, MeshPort))
  {
    source->setProperty(IsStopped, true);
    source->setModifiedState(pqProxy::MODIFIED);
  }
  source->setProperty(IsStopAsked, false);
}

void ExecuteWhereStopped(pqPipelineSource* source)
{
  if (source->property(IsStopped).toBool())
  {
    source->setProperty(IsStopped, false);
    vtkObject::SafeDownCast(source->getProxy()->GetClientSideObject())->Modified();
    source->getProxy()->MarkModified(source->getProxy());
  }
}

// Apply executes only what is shown, and a mesh that was empty is hidden.
void ExecuteWhereHidden(pqPipelineSource* source)
{
  const QList<pqView*> views = source->getViews();
  const auto isHidden = [source](pqView* view)
  {
    pqDataRepresentation* mesh = source->getRepresentation(MeshPort, view);
    return mesh && mesh->property(IsHiddenByUs).toBool();
  };
  if (std::any_of(views.begin(), views.end(), isHidden))
  {
    source->updatePipeline();
  }
}

void FollowApply(pqServerManagerModelItem* item)
{
  auto* source = qobject_cast<pqPipelineSource*>(item);
  if (source && HasProblems(source) && source->modifiedState() == pqProxy::UNMODIFIED)
  {
    ExecuteWhereStopped(source);
    QTimer::singleShot(0, source, [source] { ExecuteWhereHidden(source); });
  }
}

void FollowAll(pqPipelineSource* source)
{
  if (HasProblems(source) || IsA(source, "MeshConformity") || IsA(source, "BitingSurfaceCheck"))
  {
    // The summary is information that no one else asks for when there is new data.
    source->getSourceProxy()->UpdatePipelineInformation();
  }
  if (!HasProblems(source))
  {
    return;
  }
  FollowStop(source);
  for (pqView* view : source->getViews())
  {
    FollowDrawing(qobject_cast<pqPipelineFilter*>(source), view);
  }
  for (const Output& output : MayBeEmpty)
  {
    for (pqView* view : source->getViews())
    {
      if (pqDataRepresentation* representation = source->getRepresentation(output.Port, view))
      {
        Follow(representation);
      }
    }
  }
}

bool IsOwn(const std::string& name)
{
  return std::any_of(
    std::begin(OwnArrays), std::end(OwnArrays), [&name](const char* own) { return name == own; });
}

std::string ChosenName(vtkSMProperty* choice)
{
  return vtkSMPropertyHelper(choice).GetAsString(NameElement);
}

// No array, where the one that would be the default does not exist.
void ChooseExisting(vtkSMProperty* choice)
{
  auto* arrays = choice ? choice->FindDomain<vtkSMArrayListDomain>() : nullptr;
  unsigned int index = 0;
  if (arrays && arrays->GetNoneString() && !arrays->IsInDomain(ChosenName(choice).c_str(), index))
  {
    vtkSMPropertyHelper(choice).Set(NameElement, arrays->GetNoneString());
  }
}

// The first array that is not of our filters, where the default is one of those; and no bite
// orders.
void ChooseForeign(vtkSMProperty* choice)
{
  auto* arrays = choice->FindDomain<vtkSMArrayListDomain>();
  if (!arrays || !IsOwn(ChosenName(choice)))
  {
    return;
  }
  std::string chosen = "Spacing";
  for (unsigned int k = arrays->GetNumberOfStrings(); k-- > 0;)
  {
    chosen = IsOwn(arrays->GetString(k)) ? chosen : arrays->GetString(k);
  }
  unsigned int index = 0;
  if (arrays->IsInDomain(chosen.c_str(), index))
  {
    vtkSMPropertyHelper(choice).Set(NameElement, chosen.c_str());
  }
}

// The array Spacing of a source that is chosen now, or its only one.
void ChooseOfSource(vtkSMProperty* choice)
{
  auto* arrays = choice->FindDomain<vtkSMArrayListDomain>();
  unsigned int index = 0;
  if (arrays->GetNumberOfStrings() == 0 || arrays->IsInDomain(ChosenName(choice).c_str(), index))
  {
    return;
  }
  const bool isNamed = arrays->IsInDomain("Spacing", index);
  if (isNamed || arrays->GetNumberOfStrings() == 1)
  {
    SCOPED_UNDO_EXCLUDE();
    vtkSMPropertyHelper(choice).Set(NameElement, isNamed ? "Spacing" : arrays->GetString(0));
  }
}

void ChooseArrays(pqPipelineSource* source, BitingMeshBehavior* behavior)
{
  vtkSMProxy* proxy = source->getProxy();
  if (HasProblems(source) || IsA(source, "MeshConformity"))
  {
    proxy->GetProperty("SourceSpacingArray")
      ->FindDomain<vtkSMArrayListDomain>()
      ->AddObserver(vtkCommand::DomainModifiedEvent, behavior, &BitingMeshBehavior::FollowSource);
  }
  if (IsA(source, "BitingMesher") || IsA(source, "MeshConformity"))
  {
    ChooseExisting(proxy->GetProperty("BoundarySpacingArray"));
    ChooseExisting(proxy->GetProperty("SpacingArray"));
  }
  else if (IsA(source, "HessianSpacing"))
  {
    ChooseForeign(proxy->GetProperty("ScalarArray"));
  }
}

// ParaView handles no events while a filter of its own process runs, so that no button can stop it.
// But the keys that are held down can be asked for.
bool AreStopKeysHeld()
{
  const Qt::KeyboardModifiers all = Qt::ControlModifier | Qt::ShiftModifier | Qt::AltModifier;
  return (QGuiApplication::queryKeyboardModifiers() & all) == all;
}

template <typename Filter>
Filter* FilterOf(pqPipelineSource* source)
{
  return Filter::SafeDownCast(vtkObject::SafeDownCast(source->getProxy()->GetClientSideObject()));
}

// A filter that does not run forgets this when it begins to.
void Stop(pqPipelineSource* source)
{
  source->setProperty(IsStopAsked, true);
  if (auto* mesher = FilterOf<vtkBitingAlgorithm>(source))
  {
    mesher->Stop();
  }
}

// Obeys the keys, and tells of them in the text of the progress that follows.
void FollowProgress(const QString& text)
{
  const QString hint = " - Ctrl+Shift+Alt stops";
  const bool areKeysHeld = AreStopKeysHeld();
  auto* model = pqApplicationCore::instance()->getServerManagerModel();
  for (pqPipelineSource* source : model->findItems<pqPipelineSource*>())
  {
    auto* filter = HasProblems(source) ? FilterOf<vtkAlgorithm>(source) : nullptr;
    if (filter && text == filter->GetProgressText() && !text.endsWith(hint))
    {
      filter->SetProgressText((text + hint).toUtf8().constData());
    }
    if (filter && areKeysHeld)
    {
      Stop(source);
    }
  }
}

} // namespace

void BitingMeshBehavior::startup()
{
  // Later, because signals come before all is complete, or within an update.
  auto* model = pqApplicationCore::instance()->getServerManagerModel();
  connect(model, &pqServerManagerModel::representationAdded, this,
    [](pqRepresentation* added) { QTimer::singleShot(0, added, [added] { SetUp(added); }); });
  connect(model, &pqServerManagerModel::dataUpdated, this,
    [](pqPipelineSource* source)
    { QTimer::singleShot(0, source, [source] { FollowAll(source); }); });
  connect(model, &pqServerManagerModel::sourceAdded, this,
    [this](pqPipelineSource* source) { ChooseArrays(source, this); });
  connect(pqApplicationCore::instance()->getProgressManager(), &pqProgressManager::progress, this,
    &FollowProgress);
  connect(model, &pqServerManagerModel::modifiedStateChanged, this, &FollowApply);
}

void BitingMeshBehavior::FollowSource(vtkObject* arrays, unsigned long, void*)
{
  // The list of the panel comes first.
  vtkSmartPointer<vtkSMProperty> choice = vtkSMDomain::SafeDownCast(arrays)->GetProperty();
  QTimer::singleShot(0, this, [choice] { ChooseOfSource(choice); });
}

void BitingMeshBehavior::shutdown()
{
  this->disconnect();
}
