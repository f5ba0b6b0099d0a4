// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

// Tells a test within ParaView's window what the window shows: Python loads it with ctypes.

#include <QApplication>
#include <QComboBox>
#include <QVariant>
#include <QWidget>

/// A property of each widget that is seen and has this name, a line each; of a combo box that is
/// asked for `items`, these. The text is that of the last call.
extern "C" Q_DECL_EXPORT const char* ReadWidgets(const char* name, const char* property)
{
  static QByteArray text;
  QStringList lines;
  for (QWidget* widget : QApplication::allWidgets())
  {
    if (widget->objectName() != name || !widget->isVisible())
    {
      continue;
    }
    auto* box = qobject_cast<QComboBox*>(widget);
    for (int k = 0; box && qstrcmp(property, "items") == 0 && k < box->count(); ++k)
    {
      lines << box->itemText(k);
    }
    lines << widget->property(property).toString();
  }
  text = lines.join('\n').toUtf8();
  return text.constData();
}
