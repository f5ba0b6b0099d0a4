// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "FeatureSize.h"

#include "../Base/DistanceToSegment.h"
#include "../Base/Numbers.h"
#include "../Base/Tasks.h"
#include "SegmentCone.h"

#include <atomic> // for what tasks count together
#include <cmath>  // for expm1

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

/// How much a wall may be turned against another, and the way to it against the normal: 45 degrees,
/// which leaves out the neighbors of neighbors on an outline that is bent.
constexpr double CosineOfFacing = 0.70710678118654752;

bool IsFacing(const Feature& own, const Point2& x, const Feature& other)
{
  if (own.IsPoint() || other.IsPoint())
  {
    return false;
  }
  const Point2 normal = Perpendicular(own.End - own.Start);
  const Point2 otherNormal = Perpendicular(other.End - other.Start);
  const Point2 way = NearestOnSegment(x, other.Start, other.End) - x;
  const double ahead = Dot(normal, way);
  const double back = -Dot(otherNormal, way);
  const double alike = std::abs(Dot(normal, otherNormal));
  return std::abs(ahead) >= CosineOfFacing * Length(normal) * Length(way) &&
    alike >= CosineOfFacing * Length(normal) * Length(otherNormal) &&
    (ahead > 0.0 ? own.LeftInside : own.RightInside) &&
    (back > 0.0 ? other.LeftInside : other.RightInside);
}

/// What all segments have in common.
struct CapRule
{
  const FeatureSource& Source;
  const GivenBounds& Given;
  const FeatureSize Size;
  const SegmentExtension Drawn; ///< f by the lengths of what was simplified
  const double Extent;          ///< of the drawing

  /// Samples: two at the ends of each segment, one where a piece is halved; capped f may be a
  /// quarter.
  double MostSamples() const
  {
    return 2.0 * static_cast<double>(this->Source.Starts.size()) + 4.0 * this->Source.MostPieces;
  }

  /// How many cells as small as those at the walls a channel is wide that has CellsAcross cells.
  double CellsOfLeastSize() const
  {
    const int count = this->Source.CellsAcross;
    const double growth = 0.5 * this->Given.Gradation;
    return count == 1 ? 1.0 : std::expm1(growth * count) / growth;
  }
};

/// Lowers f along one segment after the other of a range.
class CappedRange
{
public:
  CappedRange(const CapRule& rule, Pulse& pulse)
    : Rule(rule)
    , Beats(pulse)
  {
  }

  /// Segments [begin, end), until there are too many samples; `samplesOfAll` counts those of all
  /// ranges.
  void Run(std::size_t begin, std::size_t end, std::atomic<std::size_t>& samplesOfAll)
  {
    for (std::size_t k = begin; k < end && !this->IsOver() && this->Beats.Beat(16); ++k)
    {
      this->Beats.SetFraction(static_cast<double>(k - begin) / static_cast<double>(end - begin));
      this->SamplesBefore = samplesOfAll.load(std::memory_order_relaxed);
      this->Samples = 0;
      this->CapSegment(static_cast<Id>(k));
      samplesOfAll.fetch_add(this->Samples, std::memory_order_relaxed);
    }
  }

  SegmentSource Caps; ///< of pieces of segments, and points

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
      this->Caps.Add(start.Place, start.Place, start.Capped, start.Capped);
    }
  }

  /// Most segments begin where the one before ends.
  double GivenAt(const Point2& place) const
  {
    return place == this->LastEnd.Place ? this->LastEnd.Given : this->Rule.Given.Given(place);
  }

  /// `reach` is how far from here the feature size is to be known.
  Sample TakeSample(const Point2& place, double reach)
  {
    this->Beats.Beat(16);
    ++this->Samples;
    Sample sample;
    sample.Place = place;
    sample.Given = this->GivenAt(place);
    const double known =
      this->MostByLength < sample.Given ? this->MostByLength : sample.Given + reach;
    const double floor =
      this->Rule.Source.Floor ? LengthsPerSpacing * this->Rule.Source.Floor(place) : 0.0;
    const double least = std::max(floor, this->LeastInGaps(place, sample.Given));
    const double across = this->Rule.CellsOfLeastSize();
    sample.Size = this->Rule.Size(this->Segment, place, across * known, across * least) / across;
    const double size = across > 1.0 && sample.Size < known
      ? this->SizeOfChannel(place, known, least, across)
      : sample.Size;
    const double bySize = std::max(size, least);
    const double byLength = std::max(this->MostByLength, this->LeastOnShort(sample.Given));
    sample.Capped =
      std::min(sample.Given, std::max(std::min(bySize, byLength), this->Rule.Given.LeastCapped));
    return sample;
  }

  /// Only walls that face each other have room for more than one cell between them.
  double SizeOfChannel(const Point2& place, double known, double enough, double across) const
  {
    return std::min(this->Rule.Size(this->Segment, place, known, enough),
      this->Rule.Size.Across(this->Segment, place, across * known) / across);
  }

  double LeastInGaps(const Point2& place, double given) const
  {
    const double least =
      this->Rule.Source.IsDownToMinimum ? 0.0 : this->Rule.Drawn(place, LeastShareInGaps * given);
    return std::max(least, this->LeastOnShort(given));
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
    const double most = std::min(
      this->Rule.Given.Most, 0.5 * (start.Given + end.Given + this->Rule.Given.Gradation * length));
    if (this->IsOver() || this->Beats.HasStopped() || std::min(least, this->MostByLength) >= most)
    {
      return;
    }
    const bool isShort = length <= PieceLength * std::min(start.Capped, end.Capped);
    if (isShort || depth == DeepestPiece)
    {
      if (start.Capped < start.Given || end.Capped < end.Given)
      {
        this->Caps.Add(start.Place, end.Place, start.Capped, end.Capped);
      }
      return;
    }
    const Sample middle = this->TakeSample(Midpoint(start.Place, end.Place), 0.5 * length);
    this->AddPiece(start, middle, 0.5 * length, depth + 1);
    this->AddPiece(middle, end, 0.5 * length, depth + 1);
  }

  bool IsOver() const
  {
    return static_cast<double>(this->SamplesBefore + this->Samples) > this->Rule.MostSamples();
  }

  const CapRule& Rule;
  Pulse& Beats;
  Id Segment = 0;
  double MostByLength = 0.0; ///< f on that segment
  Sample LastEnd{ { Infinity, Infinity } };
  std::size_t SamplesBefore = 0; ///< of all ranges
  std::size_t Samples = 0;       ///< of the segment at work
};

/// Of f as given, sampled at the ends of parts of each segment.
bool HasTooManyPieces(const CapRule& rule, Pulse& pulse)
{
  const FeatureSource& source = rule.Source;
  const std::size_t count = source.Starts.size();
  double length = 0.0;
  for (std::size_t segment = 0; segment < count; ++segment)
  {
    const Feature feature(source, segment);
    length += Distance(feature.Start, feature.End);
  }
  const double most = source.MostPieces;
  double pieces = length / (PieceLength * rule.Given.Least);
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
    double last = rule.Given.Given(feature.Start);
    for (double part = 1.0; part <= parts && pulse.Beat(); part += 1.0)
    {
      const double next = rule.Given.Given(feature.Start + part * step);
      pieces += Length(step) / (PieceLength * std::max(last, next));
      last = next;
    }
  }
  return pieces > most;
}

/// Lowers f along all segments, each range of them by a task. Where there are too many samples in
/// all: up to the segment where there are, as on one thread.
void CapAll(const CapRule& rule, SegmentSource& caps, Pulse& pulse)
{
  const std::size_t count = rule.Source.Starts.size();
  std::vector<SegmentSource> ranges((count + SegmentsPerTask - 1) / SegmentsPerTask);
  std::atomic<std::size_t> samplesOfAll{ 0 };
  DoTasks(pulse, ranges.size(),
    [&rule, count, &ranges, &samplesOfAll](std::size_t k, Monitor& monitor)
    {
      Pulse own(monitor);
      CappedRange range(rule, own);
      range.Run(k * SegmentsPerTask, std::min(count, (k + 1) * SegmentsPerTask), samplesOfAll);
      ranges[k] = std::move(range.Caps);
    });
  if (static_cast<double>(samplesOfAll) > rule.MostSamples())
  {
    samplesOfAll = 0;
    CappedRange range(rule, pulse);
    range.Run(0, count, samplesOfAll);
    ranges = { std::move(range.Caps) };
  }
  for (const SegmentSource& range : ranges)
  {
    caps.Join(range);
  }
}

} // namespace

FeatureSize::Feature::Feature(const FeatureSource& source, std::size_t segment)
  : SegmentId(static_cast<Id>(segment))
  , StartId(source.Starts[segment])
  , EndId(source.Ends[segment])
  , Start(source.Points[this->StartId])
  , End(source.Points[this->EndId])
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
    this->Positions[feature.SegmentId] = static_cast<Id>(position);
  }
}

// In a crowd of long segments all boxes overlap, but those beside this one in the tree are near.
double FeatureSize::operator()(Id segment, const Point2& x, double known, double enough) const
{
  const std::vector<Feature>& features = this->Tree.Items();
  const Id position = this->Positions[segment];
  const Feature& own = features[position];
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
    look(features[beside], least);
  }
  if (least > enough)
  {
    this->Tree.Search(x, 1.0, least, look);
  }
  return least;
}

double FeatureSize::Across(Id segment, const Point2& x, double known) const
{
  const std::vector<Feature>& features = this->Tree.Items();
  const Feature& own = features[this->Positions[static_cast<std::size_t>(segment)]];
  double least = known;
  this->Tree.Search(x, 1.0, least,
    [&own, &x, &least](const Feature& other, double)
    {
      if (!own.IsIncident(other) && IsFacing(own, x, other))
      {
        least = std::min(least, DistanceToSegment(x, other.Start, other.End));
      }
      return least;
    });
  return least;
}

bool AddFeatureSizes(
  const FeatureSource& source, const GivenBounds& given, SegmentSource& caps, Monitor& monitor)
{
  Pulse pulse(monitor);
  const std::vector<SegmentCone> drawn = source.Drawn
    ? MakeCones(*source.Drawn, LengthsPerSpacing, given.Gradation, pulse)
    : std::vector<SegmentCone>();
  const CapRule rule{ source, given, FeatureSize(source, pulse),
    SegmentExtension(drawn, given.Gradation, pulse), Box2::Around(source.Points).Diagonal() };
  if (!pulse.HasStopped() && !HasTooManyPieces(rule, pulse) && !pulse.HasStopped())
  {
    CapAll(rule, caps, pulse);
  }
  return !pulse.HasStopped();
}

} // namespace biting
