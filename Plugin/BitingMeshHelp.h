// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingMeshHelp_h
#define BitingMeshHelp_h

#include <QActionGroup>

/**
 * Help > Biting Mesh: the help pages of this plugin in a window of their own. ParaView shows such
 * pages itself only where it was built with Qt 5.
 */
class BitingMeshHelp : public QActionGroup
{
public:
  BitingMeshHelp(QObject* parent);
};

#endif
