// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingExtendedGrid_h
#define BitingExtendedGrid_h

#include "Spacing.h"

namespace biting
{

/// A grid of the same spacing, without holes as the source is, with
/// - at least two rows and columns;
/// - nodes out to the border of `bounds` where these are larger, in steps that grow;
/// - some thousands of cells: coarse ones of the source are divided, as long as there are not more
///   than some ten thousand nodes then, nor many more than without.
/// The source itself where it is that already.
std::shared_ptr<const GridSource> ExtendedGrid(
  const std::shared_ptr<const GridSource>& source, const Box2& bounds);

} // namespace biting

#endif
