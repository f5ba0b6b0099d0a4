// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "DomainFeatures.h"

namespace biting
{

namespace
{

// With their lengths; none without ends.
std::shared_ptr<const SegmentSource> DrawnSegments(const std::vector<Point2>& ends)
{
  auto segments = std::make_shared<SegmentSource>();
  segments->Points = ends;
  for (std::size_t end = 0; end < ends.size(); ++end)
  {
    segments->Segments.push_back(static_cast<Id>(end));
    segments->Values.push_back(Distance(ends[end], ends[end ^ 1]));
  }
  return ends.empty() ? nullptr : segments;
}

} // namespace

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
  features->Drawn = DrawnSegments(simplified.DrawnEnds);
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

} // namespace biting
