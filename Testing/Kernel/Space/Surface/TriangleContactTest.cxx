// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Space/Surface/TriangleContact.h"
#include "Space/Surface/SurfaceCrossings.h"
#include "SurfaceShapes.h"

#include <gtest/gtest.h>

#include <algorithm> // for max, min
#include <set>       // for pairs

namespace biting
{

namespace
{

using Whole = std::int64_t;
using Vector = std::array<Whole, 3>;
using Body = std::vector<Vector>; ///< the hull of two or three points

Vector Between(const Vector& a, const Vector& b)
{
  return { b[0] - a[0], b[1] - a[1], b[2] - a[2] };
}

Vector CrossOf(const Vector& a, const Vector& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

Vector NormalOf(const Body& body)
{
  return CrossOf(Between(body[0], body[1]), Between(body[0], body[2]));
}

bool IsNull(const Vector& v)
{
  return v == Vector{ 0, 0, 0 };
}

// Separating axes, in whole numbers: an oracle that shares nothing with the kernel.
bool AreSeparated(const Body& a, const Body& b, const Vector& axis)
{
  const auto range = [&axis](const Body& body)
  {
    std::pair<Whole, Whole> ends{ 1 << 30, -(1 << 30) };
    for (const Vector& p : body)
    {
      const Whole height = axis[0] * p[0] + axis[1] * p[1] + axis[2] * p[2];
      ends = { std::min(ends.first, height), std::max(ends.second, height) };
    }
    return ends;
  };
  return range(a).second < range(b).first || range(b).second < range(a).first;
}

bool Touch(const Body& a, const Body& b)
{
  std::vector<Vector> axes;
  for (const Body* body : { &a, &b })
  {
    if (body->size() == 3)
    {
      const Vector normal = NormalOf(*body);
      axes.push_back(normal);
      for (const Body* other : { &a, &b })
      {
        for (std::size_t k = 0; k < other->size(); ++k)
        {
          axes.push_back(CrossOf(normal, Between((*other)[k], (*other)[(k + 1) % other->size()])));
        }
      }
    }
  }
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    for (std::size_t j = 0; j < b.size(); ++j)
    {
      axes.push_back(
        CrossOf(Between(a[i], a[(i + 1) % a.size()]), Between(b[j], b[(j + 1) % b.size()])));
    }
  }
  return std::none_of(axes.begin(), axes.end(),
    [&a, &b](const Vector& axis) { return !IsNull(axis) && AreSeparated(a, b, axis); });
}

// As FindContacts: beside what they share.
bool HaveContact(const Body& a, const Body& b)
{
  std::vector<std::pair<std::size_t, std::size_t>> shared;
  for (std::size_t i = 0; i < 3; ++i)
  {
    for (std::size_t j = 0; j < 3; ++j)
    {
      if (a[i] == b[j])
      {
        shared.emplace_back(i, j);
      }
    }
  }
  if (shared.empty())
  {
    return Touch(a, b);
  }
  const auto opposite = [](const Body& body, std::size_t k) {
    return Body{ body[(k + 1) % 3], body[(k + 2) % 3] };
  };
  return shared.size() == 1 &&
    (Touch(opposite(a, shared[0].first), b) || Touch(opposite(b, shared[0].second), a));
}

Body BodyOf(const std::array<Point3, 3>& triangle)
{
  Body body;
  for (const Point3& p : triangle)
  {
    body.push_back({ static_cast<Whole>(p.X), static_cast<Whole>(p.Y), static_cast<Whole>(p.Z) });
  }
  return body;
}

} // namespace

TEST(TriangleContact, IsFoundAsBySeparatingAxesInWholeNumbers)
{
  Dice dice(11);
  std::int64_t found = 0;
  for (int round = 0; round < 400; ++round)
  {
    const int size = 3 + round % 5; // coarse: many shared corners, planes and touches
    Soup soup;
    while (soup.Mesh.NumberOfTriangles() < 24)
    {
      std::array<Point3, 3> triangle;
      for (Point3& p : triangle)
      {
        p = { 1.0 * dice.Below(size), 1.0 * dice.Below(size), 1.0 * dice.Below(size) };
      }
      if (!IsNull(NormalOf(BodyOf(triangle))))
      {
        soup.Add(triangle[0], triangle[1], triangle[2]);
      }
    }
    const Verdict verdict = Judge(soup, 0.0);
    const SurfaceMesh& mesh = verdict.Surface.Mesh;
    Pulse pulse(NoMonitor());
    std::set<std::pair<Id, Id>> pairs;
    for (const SurfaceContact& contact : FindContacts(mesh, MakeSurfaceTree(mesh, pulse), pulse))
    {
      pairs.emplace(contact.First, contact.Second);
    }
    const Id count = static_cast<Id>(mesh.NumberOfTriangles());
    for (Id a = 0; a < count; ++a)
    {
      for (Id b = a + 1; b < count; ++b)
      {
        const bool isMet = HaveContact(BodyOf(mesh.Triangle(static_cast<std::size_t>(a))),
          BodyOf(mesh.Triangle(static_cast<std::size_t>(b))));
        ASSERT_EQ(pairs.count({ a, b }) > 0, isMet) << round << ' ' << a << ' ' << b;
        found += isMet ? 1 : 0;
      }
    }
  }
  EXPECT_GT(found, 10000);
}

TEST(TriangleContact, IsAsDeepAsOneHasToBeMoved)
{
  const Triangle3 a{ { { 0.0, 0.0, 0.0 }, { 4.0, 0.0, 0.0 }, { 0.0, 4.0, 0.0 } } };
  const Triangle3 b{ { { 1.0, 1.0, -0.25 }, { 1.0, 1.0, 3.0 }, { 1.5, 1.0, 3.0 } } };
  Point3 place;
  ASSERT_TRUE(Meet(a, b, 0, place));
  EXPECT_NEAR(place.Z, 0.0, 1e-15);
  EXPECT_NEAR(DepthOfMeeting(a, b), 0.25, 1e-12);
  const Triangle3 c{ { { 1.0, 1.0, 0.0 }, { 1.0, 1.0, 3.0 }, { 1.5, 1.0, 3.0 } } };
  ASSERT_TRUE(Meet(a, c, 0, place));
  EXPECT_EQ(DepthOfMeeting(a, c), 0.0);
}

} // namespace biting
