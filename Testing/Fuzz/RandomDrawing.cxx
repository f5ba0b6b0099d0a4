// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "RandomDrawing.h"

#include "Mover.h"

#include <algorithm> // for reverse
#include <cmath>     // for nextafter
#include <limits>    // for poison
#include <map>       // for merged points
#include <utility>   // for move

namespace biting
{

namespace
{

enum class KindStyle
{
  Explicit,  ///< loops bound, open chains are interfaces
  Automatic, ///< all but points
  Any        ///< whatever comes
};

class DrawingMaker
{
public:
  explicit DrawingMaker(FuzzNumbers& numbers)
    : Numbers(numbers)
    , Width(numbers.Between(4, 12))
    , Merging(numbers.Below(3))
  {
    const int style = numbers.Below(10);
    this->Style = style < 6 ? KindStyle::Explicit
      : style < 9           ? KindStyle::Automatic
                            : KindStyle::Any;
  }

  Polylines Make();

private:
  void DrawClean();
  void DrawLot(const Point2& corner, bool isFilled);
  void DrawFaces();
  void DrawPatch();
  void DrawTree(const Point2& corner, double size);
  void DrawTags();
  void EmitBox(const Point2& corner, double size);
  void EmitFace(Places places);
  void DrawLoops();
  void DrawExtras();
  Places Loop();
  Places WildLoop();
  Places Box();
  Places Tube(int columns);
  Places Star(int tips, bool mayWind);
  Places Several(int count);
  Point2 Place();
  void EmitLoop(Places places);
  void Emit(const Places& places, ChainKind kind);
  void EmitPairs(const Places& places, ChainKind kind);
  ChainKind KindOf(ChainKind wanted);
  Id PointAt(const Point2& place);

  FuzzNumbers& Numbers;
  int Width;
  int Merging; ///< 0 all points, 1 none, 2 some
  KindStyle Style = KindStyle::Explicit;
  int Regions = 1;
  Polylines Result;
  std::map<Point2, Id> Known;
};

Polylines DrawingMaker::Make()
{
  if (this->Numbers.OneIn(4))
  {
    this->DrawFaces();
  }
  else if (this->Numbers.OneIn(3))
  {
    this->DrawClean();
  }
  else
  {
    this->DrawLoops();
    this->DrawExtras();
  }
  return std::move(this->Result);
}

/// Simple loops side by side, or as holes of a frame: nothing that needs repair.
void DrawingMaker::DrawClean()
{
  const int columns = this->Numbers.Between(1, 3);
  const int rows = this->Numbers.Between(1, 2);
  const bool isFramed = this->Numbers.OneIn(3);
  const double pitch = this->Width + 1;
  if (isFramed)
  {
    const Point2 far{ columns * pitch, rows * pitch };
    this->EmitLoop({ { -1.0, -1.0 }, { far.X, -1.0 }, far, { -1.0, far.Y } });
  }
  for (int lot = 0; lot < columns * rows; ++lot)
  {
    this->DrawLot({ lot % columns * pitch, lot / columns * pitch }, !isFramed);
  }
}

/// A simple loop between `corner` and one Width further. Of a tube, the line below the middle of
/// the grid lies within: `isFilled` may put an interface and points there.
void DrawingMaker::DrawLot(const Point2& corner, bool isFilled)
{
  const auto moved = [&corner](Places places)
  {
    std::transform(places.begin(), places.end(), places.begin(),
      [&corner](const Point2& place) { return corner + place; });
    return places;
  };
  const Point2 half{ 0.5 * this->Width, 0.5 * this->Width };
  switch (this->Numbers.Below(4))
  {
    case 0:
      this->EmitLoop(moved({ {}, { half.X, 0.0 }, half, { 0.0, half.Y } }));
      return;
    case 1:
      this->EmitLoop(moved(this->Star(this->Numbers.Between(2, 10), false)));
      return;
    default:
      break;
  }
  const int columns = this->Numbers.Between(2, this->Width);
  this->EmitLoop(moved(this->Tube(columns)));
  const double level = this->Width / 2 - 0.5;
  if (isFilled && this->Numbers.OneIn(2))
  {
    this->Emit(moved({ { 0.0, level }, { 0.25, level }, { columns - 1.25, level } }),
      this->KindOf(ChainKind::Interface));
  }
  if (isFilled && this->Numbers.OneIn(2))
  {
    this->Emit(moved({ { 0.125, level + 0.125 }, { columns - 1.125, level } }),
      this->KindOf(ChainKind::EmbeddedPoint));
  }
}

/// Surfaces side by side or on top of each other, with lines and points.
void DrawingMaker::DrawFaces()
{
  this->Regions = this->Numbers.Between(1, 3);
  for (int surfaces = this->Numbers.Between(1, 2); surfaces > 0; --surfaces)
  {
    switch (this->Numbers.Below(3))
    {
      case 0:
        this->DrawPatch();
        break;
      case 1:
        this->DrawTree({}, 8.0);
        break;
      default:
        this->EmitFace(this->Loop());
    }
  }
  if (this->Numbers.OneIn(3))
  {
    this->EmitFace(this->Loop());
  }
  this->DrawTags();
  this->DrawExtras();
}

/// A grid of squares, some of them missing, some divided.
void DrawingMaker::DrawPatch()
{
  const Point2 corner = this->Place();
  const double size = this->Numbers.Between(1, 3);
  const int columns = this->Numbers.Between(1, 6);
  for (int square = columns * this->Numbers.Between(1, 5) - 1; square >= 0; --square)
  {
    const Point2 place =
      corner + size * Point2{ double(square % columns), double(square / columns) };
    if (!this->Numbers.OneIn(6))
    {
      this->EmitBox(place, size);
    }
  }
}

void DrawingMaker::DrawTree(const Point2& corner, double size)
{
  if (size == 1.0 || this->Numbers.OneIn(2))
  {
    this->EmitBox(corner, size);
    return;
  }
  const double half = 0.5 * size;
  this->DrawTree(corner, half);
  this->DrawTree(corner + Point2{ half, 0.0 }, half);
  this->DrawTree(corner + Point2{ 0.0, half }, half);
  this->DrawTree(corner + Point2{ half, half }, half);
}

/// Lines along rows and columns of the grid.
void DrawingMaker::DrawTags()
{
  for (int lines = this->Numbers.Below(4) - 1; lines > 0; --lines)
  {
    const Point2 start = this->Place();
    const double length = this->Numbers.Between(1, 4);
    const bool isRow = this->Numbers.OneIn(2);
    const Point2 end = start + (isRow ? Point2{ length, 0.0 } : Point2{ 0.0, length });
    this->Emit({ start, end }, this->KindOf(ChainKind::Automatic));
  }
}

/// A square, or two triangles.
void DrawingMaker::EmitBox(const Point2& corner, double size)
{
  const Point2 right = corner + Point2{ size, 0.0 };
  const Point2 above = corner + Point2{ 0.0, size };
  const Point2 far = corner + Point2{ size, size };
  if (this->Numbers.OneIn(3))
  {
    this->EmitFace({ corner, right, far });
    this->EmitFace({ corner, far, above });
    return;
  }
  this->EmitFace({ corner, right, far, above });
}

/// Closed by its first point, wherever this is moved.
void DrawingMaker::EmitFace(Places places)
{
  if (this->Numbers.OneIn(4))
  {
    std::reverse(places.begin(), places.end());
  }
  places.push_back(places.front());
  this->Emit(places, ChainKind::Face);
  const Id first = this->Result.Offsets[this->Result.Offsets.size() - 2];
  this->Result.Connectivity.back() = this->Result.Connectivity[static_cast<std::size_t>(first)];
}

void DrawingMaker::DrawLoops()
{
  if (this->Numbers.OneIn(4000))
  {
    this->EmitLoop(this->Star(this->Numbers.Between(100, 500), false));
    return;
  }
  if (this->Numbers.OneIn(500))
  {
    this->Width = 60;
    this->EmitLoop(this->Several(this->Numbers.Between(20, 120)));
  }
  const int loops = this->Numbers.OneIn(40) ? 0 : this->Numbers.Between(1, 3);
  for (int k = 0; k < loops; ++k)
  {
    const Places loop = this->Loop();
    this->EmitLoop(loop);
    if (this->Numbers.OneIn(16))
    {
      this->EmitLoop(loop);
    }
  }
}

void DrawingMaker::DrawExtras()
{
  for (int chains = this->Numbers.Below(6) - 2; chains > 0; --chains)
  {
    const Places chain = this->Several(this->Numbers.Between(1, 4));
    this->Emit(chain, this->KindOf(ChainKind::Interface));
  }
  for (int chains = this->Numbers.Below(5) - 2; chains > 0; --chains)
  {
    const Places points = this->Several(this->Numbers.Between(0, 4));
    this->Emit(points, this->KindOf(ChainKind::EmbeddedPoint));
  }
}

Places DrawingMaker::Loop()
{
  switch (this->Numbers.Below(6))
  {
    case 0:
    case 1:
      return this->Box();
    case 2:
      return this->Tube(this->Numbers.Between(2, this->Width));
    case 3:
      return this->Star(this->Numbers.Between(2, 8), true);
    default:
      return this->WildLoop();
  }
}

/// Crosses itself more often than not.
Places DrawingMaker::WildLoop()
{
  return this->Several(this->Numbers.Between(3, 8));
}

Places DrawingMaker::Box()
{
  const Point2 a = this->Place();
  const Point2 b = this->Place();
  return { a, { b.X, a.Y }, b, { a.X, b.Y } };
}

/// A simple loop: its lower side below the middle of the grid, its upper side not.
Places DrawingMaker::Tube(int columns)
{
  const int middle = this->Width / 2;
  Places lower;
  Places upper;
  for (int column = 0; column < columns; ++column)
  {
    const double x = column;
    lower.push_back({ x, static_cast<double>(this->Numbers.Below(middle)) });
    upper.push_back({ x, static_cast<double>(this->Numbers.Between(middle, this->Width - 1)) });
  }
  lower.insert(lower.end(), upper.rbegin(), upper.rend());
  return lower;
}

/// A star that closes nearly, or one that winds many times.
Places DrawingMaker::Star(int tips, bool mayWind)
{
  const bool isWinding = mayWind && this->Numbers.OneIn(4);
  const Turn step = Turn::OfHalfTangent(isWinding ? 0.7 : 1.5707963267948966 / tips);
  const double ratio = 0.2 + 0.8 * this->Numbers.Unit();
  const Point2 center = mayWind ? this->Place() : Point2{ 0.5 * this->Width, 0.5 * this->Width };
  Point2 arm{ 0.5 * this->Width, 0.0 };
  Places places;
  for (int k = 0; k < 2 * tips; ++k)
  {
    places.push_back(center + (k % 2 ? ratio : 1.0) * arm);
    arm = step(arm);
  }
  return places;
}

Places DrawingMaker::Several(int count)
{
  Places places;
  for (int k = 0; k < count; ++k)
  {
    places.push_back(this->Place());
    if (this->Numbers.OneIn(50))
    {
      places.push_back(places.back());
    }
  }
  return places;
}

Point2 DrawingMaker::Place()
{
  const double x = this->Numbers.Below(this->Width);
  return { x, static_cast<double>(this->Numbers.Below(this->Width)) };
}

/// In one chain, in two, or each segment by itself.
void DrawingMaker::EmitLoop(Places places)
{
  if (this->Numbers.OneIn(4))
  {
    std::reverse(places.begin(), places.end());
  }
  const ChainKind kind = this->KindOf(ChainKind::Boundary);
  places.push_back(places.front());
  const int form = this->Numbers.Below(6);
  if (form == 5)
  {
    this->EmitPairs(places, kind);
  }
  else if (form == 4)
  {
    const auto middle = places.begin() + this->Numbers.Below(static_cast<int>(places.size()));
    this->Emit(Places(places.begin(), middle + 1), kind);
    this->Emit(Places(middle, places.end()), kind);
  }
  else
  {
    this->Emit(places, kind);
  }
}

void DrawingMaker::EmitPairs(const Places& places, ChainKind kind)
{
  for (std::size_t k = 1; k < places.size(); ++k)
  {
    this->Emit({ places[k - 1], places[k] }, kind);
  }
}

void DrawingMaker::Emit(const Places& places, ChainKind kind)
{
  for (const Point2& place : places)
  {
    this->Result.Connectivity.push_back(this->PointAt(place));
  }
  this->Result.Cells.push_back(this->Result.NumberOfChains());
  this->Result.Kinds.push_back(kind);
  this->Result.Regions.push_back(this->Regions > 1 ? this->Numbers.Below(this->Regions) : 0);
  this->Result.Offsets.push_back(static_cast<Id>(this->Result.Connectivity.size()));
}

ChainKind DrawingMaker::KindOf(ChainKind wanted)
{
  if (this->Style == KindStyle::Any)
  {
    return static_cast<ChainKind>(this->Numbers.Between(-1, 2));
  }
  const bool isOverruled =
    this->Style == KindStyle::Automatic && wanted != ChainKind::EmbeddedPoint;
  return isOverruled ? ChainKind::Automatic : wanted;
}

Id DrawingMaker::PointAt(const Point2& place)
{
  const Id next = static_cast<Id>(this->Result.Points.size());
  const bool isMerged = this->Merging == 0 || (this->Merging == 2 && this->Numbers.OneIn(2));
  const auto known = this->Known.emplace(place, next);
  if (isMerged && !known.second)
  {
    return known.first->second;
  }
  this->Result.Points.push_back(place);
  return next;
}

} // namespace

Polylines MakeRandomDrawing(FuzzNumbers& numbers)
{
  Polylines drawing = DrawingMaker(numbers).Make();
  Mover(numbers).Move(drawing.Points);
  return drawing;
}

} // namespace biting
