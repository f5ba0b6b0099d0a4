// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingFeatureSize_h
#define BitingFeatureSize_h

#include "../Base/BoxTree.h"
#include "Spacing.h"

#include <functional> // for the spacing as given
#include <vector>     // for positions

namespace biting
{

/// Local feature size along the segments of a domain: the distance to the nearest feature that is
/// not incident, seen through the domain. (The paper, section 2.1, after Ruppert: the radius of the
/// smallest disc that meets two features which are not incident. At a point of a segment one of the
/// two is the segment itself.)
class FeatureSize
{
public:
  /// A segment of the source, or a point.
  struct Feature
  {
    Id SegmentId;
    Id StartId;
    Id EndId;
    Point2 Start;
    Point2 End;
    bool LeftInside;
    bool RightInside;

    Feature(const FeatureSource& source, std::size_t segment);
    bool IsPoint() const { return this->StartId == this->EndId; }
    bool IsIncident(const Feature& other) const;

    // For a BoxTree.
    Box2 Box() const { return Box2::Around(this->Start, this->End); }
    double Least() const { return 0.0; }
  };

  FeatureSize(const FeatureSource& source, Pulse& pulse);

  /// min(known, d), d the distance from x, on the segment, to the nearest feature not incident to
  /// it. Where d is below `enough`: any distance to such a feature up to `enough`. The two ends of
  /// the segment do not count for each other: the cap by its length does (FeatureSource).
  double operator()(Id segment, const Point2& x, double known, double enough = 0.0) const;

  /// The same for features that face the segment only: the walls of a channel. Their line is within
  /// 45 degrees of the segment, the way to them within 45 degrees of its normal, in the domain.
  double Across(Id segment, const Point2& x, double known) const;

private:
  BoxTree<Feature> Tree;
  std::vector<Id> Positions; ///< of each segment: where it is in the order of the tree
};

/// f without the feature size.
struct GivenBounds
{
  std::function<double(const Point2&)> Given;
  double Least;       ///< of Given
  double Most;        ///< of Given
  double LeastCapped; ///< f is capped no lower
  double Gradation;   ///< the Lipschitz constant that f will have in the end
};

/// Adds to `caps` how far f is to be lowered along the segments of `source` for their feature size;
/// see FeatureSource for the rule. False if the monitor asks to stop.
bool AddFeatureSizes(
  const FeatureSource& source, const GivenBounds& given, SegmentSource& caps, Monitor& monitor);

} // namespace biting

#endif
