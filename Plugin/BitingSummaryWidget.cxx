// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "BitingSummaryWidget.h"

#include <QLabel>
#include <QVBoxLayout>

namespace
{

constexpr int Characters = 6; // that are out of sight where ParaView opens the panel

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
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, Characters * text->fontMetrics().averageCharWidth(), 0);
  layout->addWidget(text);
  this->setShowLabel(false);
  // A label has no signal of its text, and needs none: only the property changes it.
  this->addPropertyLink(text, "text", SIGNAL(linkActivated(QString)), property);
}
