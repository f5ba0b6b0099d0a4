// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingSummaryWidget_h
#define BitingSummaryWidget_h

#include "pqPropertyWidget.h"

/**
 * Shows a text property in the panel: read only, with lines that end where the panel ends, and as
 * high as the text is. ParaView's own widgets for texts cut off what is longer or higher than
 * they are.
 */
class BitingSummaryWidget : public pqPropertyWidget
{
public:
  BitingSummaryWidget(vtkSMProxy* proxy, vtkSMProperty* property, QWidget* parent = nullptr);

  bool eventFilter(QObject* view, QEvent* event) override;

protected:
  void showEvent(QShowEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

private:
  void EndLinesInSight();
};

#endif
