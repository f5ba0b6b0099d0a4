// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "BitingMeshHelp.h"

#include "pqCoreUtilities.h"

#include <QPointer>
#include <QTextBrowser>
#include <QUrl>

namespace
{

constexpr int Width = 900; // the widest picture of a page has 800 pixels
constexpr int Height = 800;

QTextBrowser* NewPages()
{
  auto* pages = new QTextBrowser(pqCoreUtilities::mainWidget());
  pages->setObjectName("BitingMeshHelpPages");
  pages->setWindowFlag(Qt::Window);
  pages->setAttribute(Qt::WA_DeleteOnClose);
  pages->setOpenExternalLinks(true);
  QObject::connect(pages, &QTextBrowser::sourceChanged, pages,
    [pages] { pages->setWindowTitle(pages->documentTitle()); });
  pages->setSource(QUrl("qrc:/BitingMesh/doc/BitingMesh.html"));
  pages->resize(Width, Height);
  return pages;
}

// One window, which comes to the front where it is open already.
void ShowPages()
{
  static QPointer<QTextBrowser> pages;
  if (!pages)
  {
    pages = NewPages();
  }
  pages->show();
  pages->raise();
}

} // namespace

BitingMeshHelp::BitingMeshHelp(QObject* parent)
  : QActionGroup(parent)
{
  auto* action = new QAction("Biting Mesh", this);
  action->setObjectName("actionBitingMeshHelp");
  this->addAction(action);
  connect(action, &QAction::triggered, &ShowPages);
}
