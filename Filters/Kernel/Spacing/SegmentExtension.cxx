// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SegmentExtension.h"

namespace biting
{
namespace
{

BoxTree MakeTree(const std::vector<SegmentCone>& cones, Pulse& pulse)
{
  std::vector<BoxTree::Item> items(cones.size());
  for (std::size_t cone = 0; cone < cones.size(); ++cone)
  {
    items[cone].Box.Add(cones[cone].Start);
    items[cone].Box.Add(cones[cone].End());
    items[cone].Value = cones[cone].Value;
  }
  return BoxTree(items, pulse);
}

} // namespace

SegmentExtension::SegmentExtension(
  const std::vector<SegmentCone>& cones, double slope, Pulse& pulse)
  : Slope(slope)
  , Tree(MakeTree(cones, pulse))
{
  this->Cones.reserve(this->Tree.Order().size());
  for (Id cone : this->Tree.Order())
  {
    this->Cones.push_back(cones[static_cast<std::size_t>(cone)]);
  }
}

} // namespace biting
