// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "FeatureSize.h"

#include "../Base/DistanceToSegment.h"
#include "../Base/Numbers.h"
#include "../Base/Tasks.h"
#include "SegmentExtension.h"

#include <atomic> // for what tasks count together

namespace biting
{
namespace
{

/// f is at most so many lengths of a segment, whose ends are vertices of the mesh whatever f is:
/// the square root of 2, less a margin. The segment is then no shorter than 1/sqrt(2) spacings, as
/// an edge should be, and there are about three vertices more for each segment.
constexpr double LengthsPerSpacing = 1.4;

/// Slits and thin walls do not lower f below this share of what is given, so that they do not
/// become a multitude of triangles; where the drawing was simplified: below what its segments would
/// do.
constexpr double LeastShareInGaps = 0.25;

/// Short segments lower f as far as floats tell lengths apart. Around one of length d the mesh is
/// as fine as d + g r at the distance r, where g is the gradation: up to f about
/// 2 pi / g^2 ln(f / d) vertices, 1100 for this share and a gradation of .3, half of them where the
/// domain is on one side. More than that would be for what only doubles tell apart. Of an f beyond
/// the drawing it is the share of the drawing's size: that is where f grows to.
constexpr double LeastShareOnShort = 0x1p-23;

/// Pieces of segments along which the feature size is taken for linear, in units of f.
constexpr double PieceLength = 0.5;

constexpr int DeepestPiece = 40;

/// Positions in the tree, to each side.
constexpr Id Beside = 2;

/// Parts of a segment, to learn roughly how many pieces it has: as many as that, but no more than
/// so many in all, as long as there are two for each segment.
constexpr double PartsOfSegment = 64.0;
constexpr double MostParts = 500000.0;

/// Segments, some microseconds each.
constexpr std::size_t SegmentsPerTask = 2048;

using Feature = FeatureSize::Feature;

std::vector<Feature> AllFeatures(const FeatureSource& source)
{
  std::vector<Feature> features;
  features.reserve(source.Starts.size());
  for (std::size_t segment = 0; segment < source.Starts.size(); ++segment)
  {
    features.emplace_back(source, segment);
  }
  return features;
}

/// From x on a feature to another one, as far as that lies on the inner side.
double DistanceInside(const Feature& own, const Point2& x, const Feature& other)
{
  const Point2 direction = own.End - own.Start;
  const double side = own.LeftInside ? 1.0 : -1.0;
  const double startHeight = side * Cross(direction, other.Start - own.Start);
  const double endHeight = side * Cross(direction, other.End - own.Start);
  if (own.IsPoint() || (own.LeftInside && own.RightInside))
  {
    return DistanceToSegment(x, other.Start, other.End);
  }
  if (startHeight <= 0.0 && endHeight <= 0.0)
  {
    return Infinity;
  }
  const double weight = startHeight / (startHeight - endHeight);
  const Point2 cut = other.Start + weight * (other.End - other.Start);
  return DistanceToSegment(
    x, startHeight < 0.0 ? cut : other.Start, endHeight < 0.0 ? cut : other.End);
}

double DiagonalOf(const std::vector<Point2>& points)
{
  Box2 box;
  for (const Point2& point : points)
  {
    box.Add(point);
  }
  return box.Diagonal();
}

/// What all segments have in common.
struct CapRule
{
  const FeatureSource& Source;
  const std::function<double(const Point2&)>& Given;
  double Least; ///< of f as given
  double Most;
  double Gradation;
  double LeastCapped;
  const FeatureSize Size;
  const SegmentExtension Drawn; ///< f by the lengths of what was simplified
  const double Extent;          ///< of the drawing

  /// Samples: two at the ends of each segment, one where a piece is halved; capped f may be a
  /// quarter.
  double MostSamples() const
  {
    return 2.0 * static_cast<double>(this->Source.Starts.size()) + 4.0 * this->Source.MostPieces;
  }
};

/// Lowers f along one segment after the other of a range.
class CappedRange
{
public:
  /// Nothing more is capped after so many samples.
  CappedRange(const CapRule& rule, double mostSamples, Pulse& pulse)
    : Rule(rule)
    , MostSamples(mostSamples)
    , Beats(pulse)
  {
  }

  /// Of a piece of a segment, or a point.
  struct Cap
  {
    Point2 Start;
    Point2 End;
    double StartValue;
    double EndValue;
  };

  /// Segments [begin, end). `samplesOfAll`, if not null, counts those of other ranges, too: false,
  /// and there are caps missing, where they are too many.
  bool Run(std::size_t begin, std::size_t end, std::atomic<std::size_t>* samplesOfAll)
  {
    bool goesOn = true;
    for (std::size_t k = begin; k < end && goesOn && this->Beats.Beat(16); ++k)
    {
      this->Beats.SetFraction(static_cast<double>(k - begin) / static_cast<double>(end - begin));
      const std::size_t before = this->NumberOfSamples;
      this->CapSegment(static_cast<Id>(k));
      const std::size_t own = this->NumberOfSamples - before;
      goesOn = samplesOfAll == nullptr ||
        static_cast<double>(samplesOfAll->fetch_add(own, std::memory_order_relaxed) + own) <=
          this->Rule.MostSamples();
    }
    return goesOn;
  }

  std::size_t Samples() const { return this->NumberOfSamples; }
  std::vector<Cap> TakeCaps() { return std::move(this->Caps); }

private:
  struct Sample
  {
    Point2 Place;
    double Given = 0.0;  ///< f without the cap
    double Size = 0.0;   ///< feature size, as far as it matters
    double Capped = 0.0; ///< f with the cap
  };

  void CapSegment(Id segment)
  {
    this->Segment = segment;
    const Feature feature(this->Rule.Source, static_cast<std::size_t>(segment));
    const double length = Distance(feature.Start, feature.End);
    this->MostByLength = length > 0.0 ? LengthsPerSpacing * length : Infinity;
    const Sample start = this->TakeSample(feature.Start, length);
    if (length > 0.0)
    {
      this->LastEnd = this->TakeSample(feature.End, length);
      this->AddPiece(start, this->LastEnd, length, 0);
    }
    else if (start.Capped < start.Given)
    {
      this->Caps.push_back({ start.Place, start.Place, start.Capped, start.Capped });
    }
  }

  /// Most segments begin where the one before ends.
  double GivenAt(const Point2& place) const
  {
    return place == this->LastEnd.Place ? this->LastEnd.Given : this->Rule.Given(place);
  }

  /// `reach` is how far from here the feature size is to be known.
  Sample TakeSample(const Point2& place, double reach)
  {
    this->Beats.Beat(16);
    ++this->NumberOfSamples;
    Sample sample;
    sample.Place = place;
    sample.Given = this->GivenAt(place);
    const double known =
      this->MostByLength < sample.Given ? this->MostByLength : sample.Given + reach;
    const double floor =
      this->Rule.Source.Floor ? LengthsPerSpacing * this->Rule.Source.Floor(place) : 0.0;
    const double least = std::max(floor, this->LeastInGaps(place, sample.Given));
    sample.Size = this->Rule.Size(this->Segment, place, known, least);
    const double bySize = std::max(sample.Size, least);
    const double byLength = std::max(this->MostByLength, this->LeastOnShort(sample.Given));
    sample.Capped =
      std::min(sample.Given, std::max(std::min(bySize, byLength), this->Rule.LeastCapped));
    return sample;
  }

  double LeastInGaps(const Point2& place, double given) const
  {
    return std::max(this->Rule.Drawn(place, LeastShareInGaps * given), this->LeastOnShort(given));
  }

  double LeastOnShort(double given) const
  {
    return LeastShareOnShort * std::min(given, this->Rule.Extent);
  }

  /// The feature size changes no faster than the place, and f in the end no faster than the
  /// gradation: from their values at the ends follows how small the one, how large the other can be
  /// between.
  void AddPiece(const Sample& start, const Sample& end, double length, int depth)
  {
    const double least = 0.5 * (start.Size + end.Size - length);
    const double most =
      std::min(this->Rule.Most, 0.5 * (start.Given + end.Given + this->Rule.Gradation * length));
    const bool isOver =
      this->Beats.HasStopped() || static_cast<double>(this->NumberOfSamples) > this->MostSamples;
    if (isOver || std::min(least, this->MostByLength) >= most)
    {
      return;
    }
    const bool isShort = length <= PieceLength * std::min(start.Capped, end.Capped);
    if (isShort || depth == DeepestPiece)
    {
      if (start.Capped < start.Given || end.Capped < end.Given)
      {
        this->Caps.push_back({ start.Place, end.Place, start.Capped, end.Capped });
      }
      return;
    }
    const Sample middle = this->TakeSample(Midpoint(start.Place, end.Place), 0.5 * length);
    this->AddPiece(start, middle, 0.5 * length, depth + 1);
    this->AddPiece(middle, end, 0.5 * length, depth + 1);
  }

  const CapRule& Rule;
  const double MostSamples;
  Pulse& Beats;
  std::vector<Cap> Caps;
  Id Segment = 0;
  double MostByLength = 0.0; ///< f on that segment
  Sample LastEnd{ { Infinity, Infinity } };
  std::size_t NumberOfSamples = 0;
};

/// Lowers f along all segments.
class FeatureCap
{
public:
  FeatureCap(const CapRule& rule, ConeCollector& cones, Pulse& pulse)
    : Rule(rule)
    , Beats(pulse)
    , Cones(cones)
    , Ranges((rule.Source.Starts.size() + SegmentsPerTask - 1) / SegmentsPerTask)
  {
  }

  bool Run()
  {
    if (!this->HasTooManyPieces() && !this->Beats.HasStopped())
    {
      this->CapRanges();
      this->CollectCaps();
    }
    return !this->Beats.HasStopped();
  }

private:
  struct Range
  {
    std::vector<CappedRange::Cap> Caps;
    std::size_t Samples = 0;
    bool IsWhole = false;
  };

  /// Of f as given, sampled at the ends of parts of each segment.
  bool HasTooManyPieces()
  {
    const FeatureSource& source = this->Rule.Source;
    const std::size_t count = source.Starts.size();
    double length = 0.0;
    for (std::size_t segment = 0; segment < count; ++segment)
    {
      const Feature feature(source, segment);
      length += Distance(feature.Start, feature.End);
    }
    const double most = source.MostPieces;
    double pieces = length / (PieceLength * this->Rule.Least);
    if (pieces <= most)
    {
      return false;
    }
    const double parts =
      std::max(2.0, std::min(PartsOfSegment, std::floor(MostParts / static_cast<double>(count))));
    pieces = 0.0;
    for (std::size_t segment = 0; segment < count && pieces <= most; ++segment)
    {
      const Feature feature(source, segment);
      const Point2 step = (1.0 / parts) * (feature.End - feature.Start);
      double last = this->Rule.Given(feature.Start);
      for (double part = 1.0; part <= parts && this->Beats.Beat(); part += 1.0)
      {
        const double next = this->Rule.Given(feature.Start + part * step);
        pieces += Length(step) / (PieceLength * std::max(last, next));
        last = next;
      }
    }
    return pieces > most;
  }

  /// Each as if there were no others; once they have too many samples together, some not to the
  /// end.
  void CapRanges()
  {
    std::atomic<std::size_t> samplesOfAll{ 0 };
    DoTasks(this->Beats, this->Ranges.size(),
      [this, &samplesOfAll](std::size_t k, Monitor& monitor)
      {
        Pulse own(monitor);
        this->Ranges[k] = this->CapRange(k, this->Rule.MostSamples(), &samplesOfAll, own);
      });
  }

  Range CapRange(
    std::size_t k, double mostSamples, std::atomic<std::size_t>* samplesOfAll, Pulse& pulse) const
  {
    const std::size_t count = this->Rule.Source.Starts.size();
    CappedRange range(this->Rule, mostSamples, pulse);
    const bool isWhole =
      range.Run(k * SegmentsPerTask, std::min(count, (k + 1) * SegmentsPerTask), samplesOfAll);
    return { range.TakeCaps(), range.Samples(), isWhole };
  }

  /// In their order. From where they have too many samples together it is done again, one range
  /// after the other: what is capped is what it would be on one thread.
  void CollectCaps()
  {
    double left = this->Rule.MostSamples();
    for (std::size_t k = 0; k < this->Ranges.size() && !this->Beats.HasStopped(); ++k)
    {
      Range range = std::move(this->Ranges[k]);
      if (!range.IsWhole || static_cast<double>(range.Samples) > left)
      {
        range = this->CapRange(k, left, nullptr, this->Beats);
      }
      left -= static_cast<double>(range.Samples);
      for (const CappedRange::Cap& cap : range.Caps)
      {
        this->Cones.AddSegment(cap.Start, cap.End, cap.StartValue, cap.EndValue);
      }
    }
  }

  const CapRule& Rule;
  Pulse& Beats;
  ConeCollector& Cones;
  std::vector<Range> Ranges;
};

} // namespace

FeatureSize::Feature::Feature(const FeatureSource& source, std::size_t segment)
  : SegmentId(static_cast<Id>(segment))
  , StartId(source.Starts[segment])
  , EndId(source.Ends[segment])
  , Start(source.Points[static_cast<std::size_t>(this->StartId)])
  , End(source.Points[static_cast<std::size_t>(this->EndId)])
  , LeftInside(source.LeftInside[segment] != 0)
  , RightInside(source.RightInside[segment] != 0)
{
}

bool FeatureSize::Feature::IsIncident(const Feature& other) const
{
  return this->StartId == other.StartId || this->StartId == other.EndId ||
    this->EndId == other.StartId || this->EndId == other.EndId;
}

FeatureSize::FeatureSize(const FeatureSource& source, Pulse& pulse)
  : Tree(AllFeatures(source), pulse)
  , Positions(Tree.Items().size(), 0)
{
  for (std::size_t position = 0; position < this->Positions.size(); ++position)
  {
    const Feature& feature = this->Tree.Items()[position];
    this->Positions[static_cast<std::size_t>(feature.SegmentId)] = static_cast<Id>(position);
  }
}

// In a crowd of long segments all boxes overlap, but those beside this one in the tree are near.
double FeatureSize::operator()(Id segment, const Point2& x, double known, double enough) const
{
  const std::vector<Feature>& features = this->Tree.Items();
  const Id position = this->Positions[static_cast<std::size_t>(segment)];
  const Feature& own = features[static_cast<std::size_t>(position)];
  double least = known;
  const auto look = [&own, &x, &least, enough](const Feature& other, double)
  {
    if (!own.IsIncident(other))
    {
      least = std::min(least, DistanceInside(own, x, other));
    }
    return least > enough ? least : 0.0;
  };
  const Id last = std::min(position + Beside, static_cast<Id>(features.size()) - 1);
  for (Id beside = std::max(position - Beside, Id(0)); beside <= last && least > enough; ++beside)
  {
    look(features[static_cast<std::size_t>(beside)], least);
  }
  if (least > enough)
  {
    this->Tree.Search(x, 1.0, least, look);
  }
  return least;
}

bool AddFeatureSizes(const FeatureSource& source, const std::function<double(const Point2&)>& given,
  double least, double most, double gradation, ConeCollector& cones, Monitor& monitor)
{
  Pulse pulse(monitor);
  const std::vector<SegmentCone> drawn = source.Drawn
    ? MakeCones(*source.Drawn, LengthsPerSpacing, gradation, pulse)
    : std::vector<SegmentCone>();
  const CapRule rule{ source, given, least, most, gradation, cones.Values().Least,
    FeatureSize(source, pulse), SegmentExtension(drawn, gradation, pulse),
    DiagonalOf(source.Points) };
  return !pulse.HasStopped() && FeatureCap(rule, cones, pulse).Run();
}

} // namespace biting
