// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "DomainFeatures.h"

namespace biting
{

std::shared_ptr<const FeatureSource> FeaturesOf(
  const SimplifiedDomain& simplified, double mostVertices)
{
  const Domain& domain = simplified.Drawing;
  auto features = std::make_shared<FeatureSource>();
  features->Points = domain.Vertices;
  features->MostPieces = 2.0 * mostVertices; // two for an edge
  features->Starts = domain.Starts;
  features->Ends = domain.Ends;
  features->LeftInside = domain.LeftInside;
  features->RightInside = domain.RightInside;
  features->PathOffsets = simplified.PathOffsets;
  features->PathLengths = simplified.PathLengths;
  for (Id vertex = 0; vertex < domain.NumberOfVertices(); ++vertex)
  {
    if (domain.IsEmbedded[vertex])
    {
      features->Starts.push_back(vertex);
      features->Ends.push_back(vertex);
      features->LeftInside.push_back(1);
      features->RightInside.push_back(1);
    }
  }
  return features;
}

std::function<bool(const Box2&)> OutsideOf(const DomainLocator& locator)
{
  return [&locator](const Box2& box)
  { return locator.IsClear(box) && !locator.IsInside(box.Center()); };
}

} // namespace biting
