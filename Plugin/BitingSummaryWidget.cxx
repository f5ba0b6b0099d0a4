// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "BitingSummaryWidget.h"

#include <QEvent>
#include <QLabel>
#include <QScrollArea>
#include <QVBoxLayout>

#include <algorithm> // for max

namespace
{

// The panel: a view of fields that may be wider than it is.
QScrollArea* PanelOf(QWidget* field)
{
  QWidget* ancestor = field->parentWidget();
  while (ancestor && !qobject_cast<QScrollArea*>(ancestor))
  {
    ancestor = ancestor->parentWidget();
  }
  return qobject_cast<QScrollArea*>(ancestor);
}

} // namespace

BitingSummaryWidget::BitingSummaryWidget(
  vtkSMProxy* proxy, vtkSMProperty* property, QWidget* parent)
  : pqPropertyWidget(proxy, parent)
{
  auto* text = new QLabel(this);
  text->setObjectName("SummaryText");
  text->setTextFormat(Qt::PlainText);
  text->setTextInteractionFlags(Qt::TextSelectableByMouse);
  text->setWordWrap(true);
  QSizePolicy policy = text->sizePolicy();
  policy.setHorizontalPolicy(QSizePolicy::Ignored); // long words do not widen the panel
  text->setSizePolicy(policy);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(text);
  this->setShowLabel(false);
  // A label has no signal of its text, and needs none: only the property changes it.
  this->addPropertyLink(text, "text", SIGNAL(linkActivated(QString)), property);
}

void BitingSummaryWidget::showEvent(QShowEvent* event)
{
  this->pqPropertyWidget::showEvent(event);
  if (QScrollArea* panel = PanelOf(this))
  {
    panel->viewport()->installEventFilter(this);
    this->EndLinesInSight();
  }
}

void BitingSummaryWidget::resizeEvent(QResizeEvent* event)
{
  this->pqPropertyWidget::resizeEvent(event);
  this->EndLinesInSight();
}

bool BitingSummaryWidget::eventFilter(QObject* view, QEvent* event)
{
  if (event->type() == QEvent::Resize)
  {
    this->EndLinesInSight();
  }
  return this->pqPropertyWidget::eventFilter(view, event);
}

void BitingSummaryWidget::EndLinesInSight()
{
  QScrollArea* panel = PanelOf(this);
  if (panel && panel->widget())
  {
    const int right = this->mapTo(panel->widget(), QPoint()).x() + this->width();
    const int hidden = std::max(0, right - panel->viewport()->width());
    this->layout()->setContentsMargins(0, 0, hidden, 0);
  }
}
