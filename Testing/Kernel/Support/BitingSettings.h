// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingBitingSettings_h
#define BitingBitingSettings_h

#include "BitingMesh.h"

#include <ostream> // for names
#include <string>  // for names
#include <vector>  // for the list

namespace biting
{

/// The orders of the paper.
constexpr FrontOrder PaperOrders[] = { FrontOrder::Layers, FrontOrder::LargestY };

/// What the bites of a mesh look like, and where and when they come.
struct BitingSetting
{
  BiteShape Shape;
  Placement Place;
  FrontOrder Order;

  void SetIn(BitingMeshOptions& options) const
  {
    options.BiteShape = this->Shape;
    options.Placement = this->Place;
    options.Order = this->Order;
  }
};

inline std::string Text(const BitingSetting& setting)
{
  return std::string(setting.Shape == BiteShape::Square ? "squares" : "circles") +
    (setting.Place == Placement::Corners ? " at corners, " : " at bisectors, ") +
    RuleOf(setting.Order).Name;
}

inline std::ostream& operator<<(std::ostream& stream, const BitingSetting& setting)
{
  return stream << Text(setting);
}

/// All of them, but for those that are others by another name.
inline std::vector<BitingSetting> BitingSettings()
{
  std::vector<BitingSetting> settings;
  for (const BiteShape shape : { BiteShape::Square, BiteShape::Circle })
  {
    for (const FrontRule& rule : FrontRules)
    {
      settings.push_back({ shape, Placement::Bisectors, rule.Order });
      if (rule.Order == FrontOrder::Layers || rule.ComesLater)
      {
        settings.push_back({ shape, Placement::Corners, rule.Order });
      }
    }
  }
  return settings;
}

} // namespace biting

#endif
