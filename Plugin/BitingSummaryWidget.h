// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingSummaryWidget_h
#define BitingSummaryWidget_h

#include "pqPropertyWidget.h"

/**
 * Shows a text property in the panel: read only, with lines that fit into the panel, and as high
 * as the text is. ParaView's own widgets for texts cut off what is longer or higher than they are.
 */
class BitingSummaryWidget : public pqPropertyWidget
{
public:
  BitingSummaryWidget(vtkSMProxy* proxy, vtkSMProperty* property, QWidget* parent = nullptr);
};

#endif
