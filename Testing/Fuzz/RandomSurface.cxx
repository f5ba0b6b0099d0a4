// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "RandomSurface.h"

#include <algorithm>  // for find_if, max, min, sort, swap
#include <array>      // for triangles
#include <cmath>      // for rings
#include <functional> // for shapes
#include <limits>     // for rounding
#include <utility>    // for pairs

namespace biting
{

namespace
{

constexpr double Pi = 3.14159265358979323846;

using Triangle = std::array<Point3, 3>;

/// Triangles that face outwards, each with the value of its body.
struct Shape
{
  std::vector<Triangle> Triangles;
  std::vector<Id> Values;
  double Thinnest = 1.0;  ///< about how thick, where the shape is about 1 long
  double Sharpest = 90.0; ///< smallest angle between faces, in degrees

  void Add(const Point3& a, const Point3& b, const Point3& c)
  {
    this->Triangles.push_back({ a, b, c });
    this->Values.push_back(0);
  }

  /// By the diagonal from its lowest corner: walls are divided alike from both sides.
  void AddQuad(const Point3& a, const Point3& b, const Point3& c, const Point3& d)
  {
    const bool isAlong = std::min(a, c) < std::min(b, d);
    this->Add(a, b, isAlong ? c : d);
    this->Add(isAlong ? a : b, c, d);
  }

  /// `value` is that of all of it.
  void Add(const Shape& other, Id value)
  {
    this->Triangles.insert(this->Triangles.end(), other.Triangles.begin(), other.Triangles.end());
    this->Values.resize(this->Triangles.size(), value);
    this->Thinnest = std::min(this->Thinnest, other.Thinnest);
    this->Sharpest = std::min(this->Sharpest, other.Sharpest);
  }

  template <typename Move>
  void ForPoints(const Move& move)
  {
    for (Triangle& triangle : this->Triangles)
    {
      for (Point3& point : triangle)
      {
        point = move(point);
      }
    }
  }
};

/// A polygon that is seen from its middle, from z = 0 to `height`, its sides divided into `n`.
Shape Prism(const std::vector<Point3>& outline, const Point3& middle, double height, int n)
{
  Shape shape;
  const Point3 up{ 0.0, 0.0, height };
  const std::size_t size = outline.size();
  for (std::size_t k = 0; k < size; ++k)
  {
    const Point3 a = outline[k];
    const Point3 b = outline[(k + 1) % size];
    shape.Add(middle, b, a);
    shape.Add(middle + up, a + up, b + up);
    for (int j = 0; j < n; ++j)
    {
      const Point3 low = (static_cast<double>(j) / n) * up;
      const Point3 high = j + 1 == n ? up : (static_cast<double>(j + 1) / n) * up;
      shape.AddQuad(a + low, b + low, b + high, a + high);
    }
  }
  return shape;
}

Shape Box(double x, double y, double z)
{
  Shape shape = Prism({ { 0.0, 0.0, 0.0 }, { x, 0.0, 0.0 }, { x, y, 0.0 }, { 0.0, y, 0.0 } },
    { x / 2.0, y / 2.0, 0.0 }, z, 1);
  shape.Thinnest = std::min({ x, y, z });
  return shape;
}

/// A grid of places at(i, j), closed in both ways; where `areCapped` the first and last rows are
/// points.
template <typename At>
Shape Wrapped(int rows, int columns, bool areCapped, const At& at)
{
  Shape shape;
  const auto place = [&](int i, int j)
  { return areCapped ? at(i, j % columns) : at(i % rows, j % columns); };
  for (int i = 0; i < rows; ++i)
  {
    for (int j = 0; j < columns; ++j)
    {
      if (!areCapped || i + 1 < rows)
      {
        shape.Add(place(i, j), place(i + 1, j), place(i + 1, j + 1));
      }
      if (!areCapped || i > 0)
      {
        shape.Add(place(i, j), place(i + 1, j + 1), place(i, j + 1));
      }
    }
  }
  return shape;
}

/// About half a unit large, with bumps.
Shape Ball(FuzzNumbers& numbers)
{
  const int rings = numbers.Between(3, 16);
  const double bumps = numbers.OneIn(2) ? 0.0 : 0.3 * numbers.Unit();
  const int waves = numbers.Between(2, 5);
  const double turn = numbers.Unit();
  const Point3 radii{ 0.5, 0.5 * (numbers.OneIn(2) ? 1.0 : 0.2 + 0.8 * numbers.Unit()), 0.5 };
  Shape shape = Wrapped(rings, 2 * rings, true,
    [=](int i, int j)
    {
      const double polar = Pi * i / rings;
      const double around = Pi * j / rings;
      const double sine = i == 0 || i == rings ? 0.0 : std::sin(polar);
      const double radius =
        1.0 + bumps * sine * sine * std::sin(waves * around + turn) * std::sin(waves * polar);
      return Point3{ radii.X * radius * sine * std::cos(around),
        radii.Y * radius * sine * std::sin(around), radii.Z * radius * std::cos(polar) };
    });
  shape.Thinnest = bumps > 0.1 ? 0.1 : radii.Y;
  return shape;
}

Shape Torus(FuzzNumbers& numbers)
{
  const int rows = numbers.Between(3, 12);
  const int columns = numbers.Between(4, 20);
  const double thin = 0.05 + 0.15 * numbers.Unit();
  Shape shape = Wrapped(rows, columns, false,
    [=](int i, int j)
    {
      const double polar = -2.0 * Pi * i / rows;
      const double around = 2.0 * Pi * j / columns;
      const double radius = 0.5 - thin + thin * std::cos(polar);
      return Point3{ radius * std::cos(around), radius * std::sin(around), thin * std::sin(polar) };
    });
  shape.Thinnest = thin;
  return shape;
}

/// With an edge of that angle.
Shape Wedge(FuzzNumbers& numbers)
{
  const double degrees = numbers.OneIn(4) ? numbers.Power(-4, 4) : 10.0 + 100.0 * numbers.Unit();
  const double angle = degrees * Pi / 180.0;
  const Point3 b{ 1.0, 0.0, 0.0 };
  const Point3 c{ std::cos(angle), std::sin(angle), 0.0 };
  Shape shape =
    Prism({ {}, b, c }, (1.0 / 3.0) * (b + c), 0.1 + numbers.Unit(), numbers.Between(1, 3));
  shape.Sharpest = std::min(degrees, 90.0 - degrees / 2.0);
  shape.Thinnest = 0.05;
  return shape;
}

/// Stars, whose odd corners are nearer to the middle, and Ls.
Shape Star(FuzzNumbers& numbers)
{
  const double height = 0.1 + 0.5 * numbers.Unit();
  if (numbers.OneIn(3))
  {
    const double arm = 0.05 + 0.4 * numbers.Unit();
    Shape shape = Prism({ {}, { 1.0, 0.0, 0.0 }, { 1.0, arm, 0.0 }, { arm, arm, 0.0 },
                          { arm, 1.0, 0.0 }, { 0.0, 1.0, 0.0 } },
      { arm / 2.0, arm / 2.0, 0.0 }, height, numbers.Between(1, 2));
    shape.Thinnest = std::min(arm, height);
    return shape;
  }
  std::vector<Point3> outline;
  const int arms = numbers.Between(3, 7);
  const double inner = 0.1 + 0.4 * numbers.Unit();
  for (int k = 0; k < 2 * arms; ++k)
  {
    const double radius = k % 2 == 0 ? 0.5 : inner;
    outline.push_back({ radius * std::cos(Pi * k / arms), radius * std::sin(Pi * k / arms), 0.0 });
  }
  Shape shape = Prism(outline, {}, height, numbers.Between(1, 2));
  shape.Thinnest = 0.05;
  shape.Sharpest = 20.0;
  return shape;
}

Shape Primitive(FuzzNumbers& numbers, std::string& words)
{
  const char* const names[] = { "box", "ball", "torus", "wedge", "star", "plate" };
  const int kind = numbers.Below(6);
  words += std::string(names[kind]) + " ";
  switch (kind)
  {
    case 0:
      return Box(0.2 + numbers.Unit(), 0.2 + numbers.Unit(), 0.2 + numbers.Unit());
    case 1:
      return Ball(numbers);
    case 2:
      return Torus(numbers);
    case 3:
      return Wedge(numbers);
    case 4:
      return Star(numbers);
    default:
      return Box(1.0, 0.3 + numbers.Unit(), numbers.Power(-9, -2));
  }
}

Shape Moved(Shape shape, const Point3& way, double scale)
{
  shape.ForPoints([&](const Point3& point) { return scale * point + way; });
  shape.Thinnest *= scale;
  return shape;
}

/// Several of them: within each other, sharing a wall, near each other, across each other.
Shape Composed(FuzzNumbers& numbers, std::string& words)
{
  Shape shape = Primitive(numbers, words);
  const int kind = numbers.Below(8);
  if (kind == 0)
  {
    words += "nested ";
    const Shape inner = shape;
    double scale = 1.0;
    Point3 middle;
    for (const Triangle& triangle : inner.Triangles)
    {
      middle = middle +
        (1.0 / (3.0 * static_cast<double>(inner.Triangles.size()))) *
          (triangle[0] + triangle[1] + triangle[2]);
    }
    for (int level = numbers.Between(1, 2); level > 0; --level)
    {
      const double shrink = 0.2 + 0.7 * numbers.Unit();
      scale *= shrink;
      shape.Thinnest = std::min(shape.Thinnest, inner.Thinnest * scale * (1.0 - shrink));
      shape.Add(Moved(inner, (1.0 - scale) * middle, scale), numbers.Below(3));
    }
  }
  else if (kind == 1)
  {
    words += "walls ";
    const double x = 0.3 + numbers.Unit();
    const double y = 0.3 + numbers.Unit();
    shape = Box(x, y, 0.5);
    shape.Add(Moved(Box(0.4, y, 0.5), { x, 0.0, 0.0 }, 1.0), numbers.Below(3));
    shape.Add(Moved(Box(x, 0.6, 0.5), { 0.0, y, 0.0 }, 1.0), numbers.Below(3));
  }
  else if (kind == 2)
  {
    words += "two ";
    const double gap = numbers.OneIn(3) ? 0.0 : numbers.Power(-10, 0);
    const double way = numbers.OneIn(2) ? gap : -gap;
    shape.Thinnest = std::min(shape.Thinnest, way > 0.0 ? way : 0.0);
    shape.Add(Moved(Primitive(numbers, words), { 1.2 + way, 0.0, 0.0 }, 1.0), numbers.Below(3));
  }
  return shape;
}

/// What a surface from elsewhere may have; all but splits make it unfair.
bool Spoil(FuzzNumbers& numbers, Shape& shape, std::string& words)
{
  bool isFair = true;
  for (int k = numbers.Between(1, 3); k > 0; --k)
  {
    const auto t =
      static_cast<std::size_t>(numbers.Below(static_cast<int>(shape.Triangles.size())));
    const auto [a, b, c] = shape.Triangles[t];
    const double near = numbers.OneIn(2) ? 0.3 : numbers.Power(-30, -2);
    const int kind = numbers.Below(7);
    isFair = isFair && kind == 0;
    const char* const names[] = { "sliver ", "T ", "hole ", "turned ", "double ", "fin ", "flat " };
    words += names[kind];
    if (kind == 0) // a point inside, near a side
    {
      const Point3 inside = 0.5 * ((1.0 - near) * (a + b)) + near * c;
      shape.Triangles[t] = { a, b, inside };
      shape.Add(b, c, inside);
      shape.Add(c, a, inside);
    }
    else if (kind == 1) // a point on a side, of this triangle alone
    {
      const Point3 on = (1.0 - near) * a + near * b;
      shape.Triangles[t] = { a, on, c };
      shape.Add(on, b, c);
    }
    else if (kind == 2)
    {
      shape.Triangles[t] = shape.Triangles.back();
      shape.Values[t] = shape.Values.back();
      shape.Triangles.pop_back();
      shape.Values.pop_back();
    }
    else if (kind == 3)
    {
      std::swap(shape.Triangles[t][1], shape.Triangles[t][2]);
    }
    else if (kind == 4)
    {
      shape.Add(a, b, c);
    }
    else if (kind == 5)
    {
      shape.Add(a, b, a + near * (Cross(b - a, c - a) + (c - a)));
    }
    else
    {
      shape.Add(a, b, numbers.OneIn(2) ? a : 0.5 * (a + b));
    }
    shape.Values.resize(shape.Triangles.size(), 0);
  }
  return isFair;
}

/// Numbers points that are equal alike.
void Merge(SurfaceMesh& mesh)
{
  std::vector<Id> order(mesh.Points.size());
  for (std::size_t k = 0; k < order.size(); ++k)
  {
    order[k] = static_cast<Id>(k);
  }
  std::sort(order.begin(), order.end(),
    [&mesh](Id a, Id b)
    {
      const Point3& p = mesh.Points[At(a)];
      const Point3& q = mesh.Points[At(b)];
      return p < q || (!(q < p) && a < b);
    });
  std::vector<Id> first(order.size());
  for (std::size_t k = 0; k < order.size(); ++k)
  {
    const bool isEqual = k > 0 && mesh.Points[At(order[k])] == mesh.Points[At(order[k - 1])];
    first[At(order[k])] = isEqual ? first[At(order[k - 1])] : order[k];
  }
  for (Id& corner : mesh.Corners)
  {
    corner = first[At(corner)];
  }
}

SurfaceMesh MeshOf(const Shape& shape)
{
  SurfaceMesh mesh;
  for (const Triangle& triangle : shape.Triangles)
  {
    for (const Point3& point : triangle)
    {
      mesh.Corners.push_back(static_cast<Id>(mesh.Points.size()));
      mesh.PointIds.push_back(mesh.Corners.back());
      mesh.Points.push_back(point);
    }
    mesh.Cells.push_back(static_cast<Id>(mesh.Cells.size()));
  }
  return mesh;
}

/// Turns, scales, moves; equal places stay equal. Returns the scale.
double Place(FuzzNumbers& numbers, Shape& shape, std::string& words)
{
  const double scale = numbers.OneIn(3) ? numbers.Power(-40, 40) : 1.0;
  if (numbers.OneIn(2))
  {
    words += "rotated ";
    const double a = 2.0 * Pi * numbers.Unit();
    const double b = 2.0 * Pi * numbers.Unit();
    shape.ForPoints(
      [=](const Point3& p)
      {
        const Point3 q{ std::cos(a) * p.X - std::sin(a) * p.Y,
          std::sin(a) * p.X + std::cos(a) * p.Y, p.Z };
        return Point3{ q.X, std::cos(b) * q.Y - std::sin(b) * q.Z,
          std::sin(b) * q.Y + std::cos(b) * q.Z };
      });
  }
  const double far = numbers.OneIn(4) ? numbers.Power(0, 24) : 0.0;
  const Point3 way{ far, -0.7 * far, far * numbers.Unit() };
  const bool isFloat = numbers.OneIn(4);
  words += far > 0.0 ? "far " : "";
  words += isFloat ? "float " : "";
  shape.ForPoints(
    [=](const Point3& p)
    {
      const Point3 q = scale * (p + way);
      return isFloat
        ? Point3{ static_cast<float>(q.X), static_cast<float>(q.Y), static_cast<float>(q.Z) }
        : q;
    });
  return scale;
}

/// Two of the six tetrahedra of a cube are neighbors in one part: labels are those of cubes, or of
/// tetrahedra. Points of the lattice are moved by less than what turns a tetrahedron.
class Lattice
{
public:
  explicit Lattice(FuzzNumbers& numbers)
    : Counts{ numbers.Between(1, 3), numbers.Between(1, 3), numbers.Between(1, 3) }
    , Labels(At(6 * this->Counts[0] * this->Counts[1] * this->Counts[2]))
  {
    const double jitter = numbers.OneIn(2) ? 0.15 : 0.0;
    for (std::size_t k = 0; k < 64; ++k)
    {
      const Id id = static_cast<Id>(k);
      const Point3 corner{ id % 4 + 0.0, id / 4 % 4 + 0.0, id / 16 + 0.0 };
      const Point3 shift{ numbers.Unit() - 0.5, numbers.Unit() - 0.5, numbers.Unit() - 0.5 };
      this->Places.push_back(corner + 2.0 * jitter * shift);
    }
    const bool areApart = numbers.OneIn(4);
    const int last = numbers.OneIn(2) ? 1 : 3;
    for (std::size_t k = 0; k < this->Labels.size(); ++k)
    {
      const bool isNew = areApart || k % 6 == 0;
      this->Labels[k] = !isNew ? this->Labels[k - 1]
        : numbers.OneIn(3)     ? 0
                               : numbers.Between(1, last);
    }
    this->Labels[0] = 1;
    this->FindFaces();
  }

  /// Each body has its own wall; or walls between two are there once.
  Shape Boundary(bool areTwice) const
  {
    Shape shape;
    shape.Thinnest = 0.0;
    for (std::size_t k = 0; k < this->Faces.size(); ++k)
    {
      const Face& face = this->Faces[k];
      const bool hasOther = k + 1 < this->Faces.size() && this->Faces[k + 1].Sorted == face.Sorted;
      const bool isSecond = k > 0 && this->Faces[k - 1].Sorted == face.Sorted;
      const Id other = hasOther ? this->Faces[k + 1].Label
        : isSecond              ? this->Faces[k - 1].Label
                                : 0;
      if (face.Label != 0 && face.Label != other && (areTwice || face.Label > other))
      {
        const auto& [a, b, c] = face.Corners;
        shape.Add(this->Places[At(a)], this->Places[At(b)], this->Places[At(c)]);
        shape.Values.back() = face.Label;
      }
    }
    return shape;
  }

  /// Of what has a label.
  double Volume() const
  {
    double volume = 0.0;
    for (const Face& face : this->Faces)
    {
      const auto& [a, b, c] = face.Corners;
      const Point3& p = this->Places[At(a)];
      volume +=
        face.Label == 0 ? 0.0 : Dot(p, Cross(this->Places[At(b)], this->Places[At(c)])) / 6.0;
    }
    return volume;
  }

private:
  struct Face
  {
    std::array<Id, 3> Sorted;
    std::array<Id, 3> Corners; ///< from outside
    Id Label;
  };

  /// Along the three axes in each order from the lowest corner of a cube to the highest.
  void FindFaces()
  {
    constexpr std::array<std::array<Id, 3>, 6> Ways = { { { 1, 4, 16 }, { 4, 16, 1 }, { 16, 1, 4 },
      { 4, 1, 16 }, { 1, 16, 4 }, { 16, 4, 1 } } };
    const std::size_t cubes = this->Labels.size() / 6;
    for (std::size_t k = 0; k < 6 * cubes; ++k)
    {
      const Id cube = static_cast<Id>(k / 6);
      const Id low = cube % this->Counts[0] + 4 * (cube / this->Counts[0] % this->Counts[1]) +
        16 * (cube / this->Counts[0] / this->Counts[1]);
      const std::array<Id, 3>& way = Ways[k % 6];
      std::array<Id, 4> t = { low, low + way[0], low + way[0] + way[1], low + 21 };
      if (k % 6 >= 3)
      {
        std::swap(t[1], t[2]);
      }
      for (const std::array<Id, 3>& corners :
        { std::array<Id, 3>{ t[1], t[2], t[3] }, std::array<Id, 3>{ t[0], t[3], t[2] },
          std::array<Id, 3>{ t[0], t[1], t[3] }, std::array<Id, 3>{ t[0], t[2], t[1] } })
      {
        std::array<Id, 3> sorted = corners;
        std::sort(sorted.begin(), sorted.end());
        this->Faces.push_back({ sorted, corners, this->Labels[k] });
      }
    }
    std::sort(this->Faces.begin(), this->Faces.end(),
      [](const Face& a, const Face& b)
      { return a.Sorted < b.Sorted || (a.Sorted == b.Sorted && a.Label < b.Label); });
  }

  std::array<Id, 3> Counts;
  std::vector<Id> Labels; ///< of tetrahedra
  std::vector<Point3> Places;
  std::vector<Face> Faces;
};

/// Open ones: a terrain, a pipe, a Moebius strip, pages of a book; some without some triangles.
Shape Patch(FuzzNumbers& numbers, std::string& words)
{
  const char* const names[] = { "terrain ", "pipe ", "strip ", "book " };
  const int kind = numbers.Below(4);
  words += names[kind];
  const int rows = numbers.Between(1, 5);
  const int columns = kind == 3 ? numbers.Between(3, 5) : numbers.Between(3, 14);
  const double wave = numbers.OneIn(3) ? 0.0 : 0.3 * numbers.Unit();
  const auto at = [=](int i, int j)
  {
    if (kind == 2 && j == columns) // the other way round
    {
      i = rows - i;
    }
    const double x = static_cast<double>(i) / rows;
    const double around = 2.0 * Pi * (kind == 0 || kind == 3 ? j : j % columns) / columns;
    const double radius = 0.5 + (kind == 2 ? 0.3 * (x - 0.5) * std::cos(around / 2.0) : wave * x);
    return kind == 0 ? Point3{ x, around / 6.0, wave * std::sin(5.0 * x) * std::cos(around) }
      : kind == 3    ? Point3{ x * std::cos(1.1 * j), x * std::sin(1.1 * j), 0.0 }
                     : Point3{ radius * std::cos(around), radius * std::sin(around),
                      kind == 1 ? x : 0.3 * (x - 0.5) * std::sin(around / 2.0) };
  };
  Shape shape;
  const Point3 up{ 0.0, 0.0, 1.0 };
  for (int i = 0; i < rows; ++i)
  {
    for (int j = 0; j < columns; ++j)
    {
      if (kind == 3) // pages meet in one line
      {
        shape.AddQuad(at(i, j), at(i + 1, j), at(i + 1, j) + up, at(i, j) + up);
      }
      else
      {
        shape.Add(at(i, j), at(i + 1, j), at(i + 1, j + 1));
        shape.Add(at(i, j), at(i + 1, j + 1), at(i, j + 1));
      }
    }
  }
  for (int k = numbers.OneIn(3) ? numbers.Between(1, 4) : 0; k > 0; --k)
  {
    shape.Triangles[At(numbers.Below(static_cast<int>(shape.Triangles.size())))] =
      shape.Triangles.back();
    shape.Triangles.pop_back();
    shape.Values.pop_back();
  }
  shape.Thinnest = 0.0;
  return shape;
}

/// Values of triangles by where they are, or by chance.
void Paint(FuzzNumbers& numbers, Shape& shape)
{
  const bool isByChance = numbers.OneIn(5);
  const Point3 way{ numbers.Unit() - 0.5, numbers.Unit() - 0.5, numbers.Unit() - 0.5 };
  const double period = 0.2 + numbers.Unit();
  for (std::size_t t = 0; t < shape.Triangles.size(); ++t)
  {
    const double along = Dot(way, shape.Triangles[t][0] + shape.Triangles[t][1]);
    shape.Values[t] =
      isByChance ? numbers.Below(3) : static_cast<Id>(std::floor(along / period)) & 1;
  }
}

/// What stands for a small surface: few triangles.
Shape SmallShape(FuzzNumbers& numbers, SurfaceSort sort, SurfaceCase& made)
{
  Shape shape;
  if (sort == SurfaceSort::Open && numbers.OneIn(3))
  {
    shape = Patch(numbers, made.Words);
  }
  else if (numbers.OneIn(3))
  {
    made.Words += "lattice ";
    const Lattice lattice(numbers);
    shape = lattice.Boundary(numbers.OneIn(2));
    const bool isOne = std::find_if(shape.Values.begin(), shape.Values.end(),
                         [](Id value) { return value > 1; }) == shape.Values.end();
    made.Volume = isOne ? lattice.Volume() : -1.0;
  }
  else
  {
    shape = Composed(numbers, made.Words);
  }
  if (numbers.OneIn(12))
  {
    made.Words += "twin ";
    const double near = numbers.Power(-24, -2);
    const Shape twin = Moved(
      shape, { near, near, near * numbers.Below(2) }, numbers.OneIn(2) ? 1.0 : 1.0 - 3.0 * near);
    shape.Add(twin, numbers.Below(3));
    shape.Thinnest = 0.0;
    made.Volume = -1.0;
  }
  if (numbers.OneIn(8))
  {
    made.Words += "rough ";
    const double amplitude = numbers.Power(-12, -4);
    const double phase = numbers.Unit();
    shape.ForPoints(
      [=](const Point3& p)
      {
        const double way = 91.7 * p.X + 57.3 * p.Y + 23.1 * p.Z + phase;
        return p + amplitude * Point3{ std::sin(way), std::sin(3.3 * way), std::sin(7.7 * way) };
      });
    shape.Sharpest = 0.0;
    made.Volume = -1.0;
  }
  if (numbers.OneIn(8))
  {
    made.Words += "flat ";
    const double factor = numbers.Power(-8, 0);
    shape.ForPoints([=](const Point3& p) { return Point3{ p.X, p.Y, factor * p.Z }; });
    shape.Sharpest = 0.0;
    made.Volume *= factor;
  }
  return shape;
}

/// f for that many vertices on the surface, without caps: sqrt(2 / sqrt(3) area / vertices).
double SizeFor(double vertices, const Shape& shape)
{
  double area = 0.0;
  for (const Triangle& triangle : shape.Triangles)
  {
    area += 0.5 * Length(Cross(triangle[1] - triangle[0], triangle[2] - triangle[0]));
  }
  return std::sqrt(1.155 * area / vertices);
}

void ChooseOptions(FuzzNumbers& numbers, double size, const Box3& box, SurfaceCase& made)
{
  SurfaceMesherOptions& options = made.Options.Surface;
  made.LargestSize = size;
  if (numbers.OneIn(3)) // graded, or with a step
  {
    made.Words += "graded ";
    const Point3 center =
      box.Low + numbers.Unit() * (box.High - box.Low); // somewhere along the diagonal
    const double least = size * (0.2 + 0.6 * numbers.Unit());
    const double slope = numbers.OneIn(6) ? 1e3 : 0.05 + 0.5 * numbers.Unit();
    options.Spacing = [=](const Point3& place)
    { return std::min(size, least + slope * Distance(place, center)); };
  }
  else
  {
    options.Spacing = [size](const Point3&) { return size; };
  }
  options.LimitByFeatureSize = !numbers.OneIn(4);
  options.FeatureAngle = numbers.OneIn(3) ? 5.0 + 100.0 * numbers.Unit() : 40.0;
  options.BoundaryTolerance = numbers.OneIn(3) ? 0.02 + 0.4 * numbers.Unit() : 0.1;
  options.Relaxation = !numbers.OneIn(4);
  options.MaximumNumberOfVertices = 6000;
  options.KeepBites = numbers.OneIn(4);
  made.Options.Shape = numbers.OneIn(4) ? SpaceBiteShape::Cube : SpaceBiteShape::Sphere;
  made.Options.MaximumNumberOfBites = numbers.OneIn(10) ? numbers.Between(1, 1000) : 0;
  made.Check.FeatureAngle = options.FeatureAngle;
}

} // namespace

SurfaceCase MakeSurfaceCase(FuzzNumbers& numbers, SurfaceSort sort)
{
  SurfaceCase made;
  const bool isLarge = sort == SurfaceSort::Large || numbers.OneIn(50);
  Shape shape = isLarge ? Composed(numbers, made.Words) : SmallShape(numbers, sort, made);
  const double size = isLarge ? 1.0 / (2.0 + (numbers.OneIn(8) ? 10.0 : 4.0) * numbers.Unit())
                              : SizeFor(std::exp2(3.5 + 3.5 * numbers.Unit()), shape);
  made.IsFair = shape.Thinnest >= 3.0 * size && shape.Sharpest >= 60.0;
  if (numbers.OneIn(3))
  {
    made.IsFair = Spoil(numbers, shape, made.Words) && made.IsFair;
    made.Volume = -1.0;
  }
  if (!isLarge && sort == SurfaceSort::Open && numbers.OneIn(2))
  {
    made.Words += "painted ";
    Paint(numbers, shape);
    made.IsFair = false;
  }
  const double scale = Place(numbers, shape, made.Words);
  made.Volume *= scale * scale * scale;
  made.Input = MeshOf(shape);
  const double largest =
    std::max({ 1e-300, std::abs(made.Input.Bounds().Low.X), std::abs(made.Input.Bounds().High.X),
      std::abs(made.Input.Bounds().Low.Y), std::abs(made.Input.Bounds().High.Y),
      std::abs(made.Input.Bounds().Low.Z), std::abs(made.Input.Bounds().High.Z) });
  if (numbers.OneIn(2))
  {
    Merge(made.Input);
  }
  if (numbers.OneIn(5)) // points of their own part where they are not merged
  {
    const double jitter = scale * numbers.Power(-48, -6);
    made.Words += "jittered ";
    made.IsFair = false;
    made.Volume = -1.0;
    for (Point3& point : made.Input.Points)
    {
      const Point3 shift{ numbers.Unit() - 0.5, numbers.Unit() - 0.5, numbers.Unit() - 0.5 };
      point = point + jitter * shift;
    }
  }
  const bool isFloat = made.Words.find("float") != std::string::npos;
  const double rounding = largest * std::ldexp(1.0, isFloat ? -22 : -51);
  made.IsFair = made.IsFair && rounding < 1e-4 * scale * size;
  made.Check.Rounding = { rounding, rounding, rounding };
  made.Check.Noise = 2.0 * rounding;
  made.Volume = rounding < 1e-4 * scale * size ? made.Volume : -1.0;
  ChooseOptions(numbers, scale * size, made.Input.Bounds(), made);
  if (!isLarge)
  {
    made.Options.Surface.MaximumNumberOfVertices = 800;
  }
  made.IsToFill = sort != SurfaceSort::Open;
  made.IsToMesh = !made.IsToFill || isLarge || numbers.OneIn(4); // bodies have a surface, too
  if (numbers.OneIn(2))
  {
    made.Values = shape.Values;
  }
  return made;
}

void WriteLegacyVtk(std::ostream& stream, const SurfaceCase& surface, const std::string& title)
{
  const SurfaceMesh& mesh = surface.Input;
  const std::size_t triangles = mesh.NumberOfTriangles();
  stream.precision(std::numeric_limits<double>::max_digits10);
  stream << "# vtk DataFile Version 3.0\n"
         << title << "\nASCII\nDATASET POLYDATA\nPOINTS " << mesh.Points.size() << " double\n";
  for (const Point3& point : mesh.Points)
  {
    stream << point.X << " " << point.Y << " " << point.Z << "\n";
  }
  stream << "POLYGONS " << triangles << " " << 4 * triangles << "\n";
  for (std::size_t slot = 0; slot < mesh.Corners.size(); slot += 3)
  {
    stream << "3 " << mesh.Corners[slot] << " " << mesh.Corners[slot + 1] << " "
           << mesh.Corners[slot + 2] << "\n";
  }
}

} // namespace biting
