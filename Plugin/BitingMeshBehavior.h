// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingMeshBehavior_h
#define BitingMeshBehavior_h

#include <QObject>

class vtkObject;

/**
 * What ParaView's window does for the filters of this plugin beyond what their XML can say:
 * outputs that may be empty (bites, problems) are hidden while they are, and shown, coloured and
 * with a legend, when they have something; a new filter does not choose an array which its input
 * has not, nor an array of the mesher as solution, and of a new spacing source it chooses the one
 * that can be meant. The summary is that of the mesh that is shown. What users hide stays hidden.
 */
class BitingMeshBehavior : public QObject
{
public:
  void startup();
  void shutdown();

  /// The arrays of a spacing source are others now.
  void FollowSource(vtkObject* arrays, unsigned long, void*);
};

#endif
