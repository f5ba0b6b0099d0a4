// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingCountedMemory_h
#define BitingCountedMemory_h

#include <cstddef> // for sizes

/// A program that links these counts what it allocates, of one thread.

/// The bytes that are allocated now; the peak is sought from here on.
std::size_t BeginPeak();

/// The most that have been allocated since.
std::size_t PeakBytes();

#endif
