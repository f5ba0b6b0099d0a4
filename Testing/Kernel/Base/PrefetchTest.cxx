// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Base/Prefetch.h"

#include <gtest/gtest.h>

#include <vector>

namespace biting
{

TEST(Prefetch, MayBeAskedForAnyAddress)
{
  const std::vector<int> values{ 1, 2, 3 };
  Prefetch(values.data());
  Prefetch(values.data() + values.size());
  Prefetch(nullptr);
  EXPECT_EQ(values, (std::vector<int>{ 1, 2, 3 }));
}

} // namespace biting
