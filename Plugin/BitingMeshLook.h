// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingMeshLook_h
#define BitingMeshLook_h

/// Tells ParaView how outputs of the plugin look at first: colours of its arrays, and its
/// representations. They are defaults: what a user has saved as default, or sets, counts more.
void AddBitingMeshLook();

#endif
