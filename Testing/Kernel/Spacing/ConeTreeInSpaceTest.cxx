// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

// The gradation in space by a tree of cones, against its definition. In the plane: GradationTest.

#include "Spacing/ConeTree.h"

#include "SpacingSources.h"

#include <gtest/gtest.h>

#include <algorithm> // for sort
#include <array>     // for corners
#include <cmath>     // for fields
#include <string>    // for names

namespace
{

using namespace biting;

using Field3 = std::function<double(const Point<3>&)>;

/// Values on n x n x n nodes of the unit cube: trilinear, or linear on six tetrahedra a cell.
class Volume
{
public:
  Volume(int nodes, bool areTetrahedra, const Field3& field)
    : Cells(nodes - 1)
    , AreTetrahedra(areTetrahedra)
  {
    for (int node = 0; node < nodes * nodes * nodes; ++node)
    {
      this->Values.push_back(field(this->PlaceOf(this->AxesOf(node))));
    }
  }

  double operator()(const Point<3>& x) const
  {
    Axes low{};
    Point<3> shares{};
    for (std::size_t d = 0; d < 3; ++d)
    {
      const double unit = std::min(std::max(x[d], 0.0), 1.0) * this->Cells;
      low[d] = std::min(static_cast<int>(unit), this->Cells - 1);
      shares[d] = unit - low[d];
    }
    return this->AreTetrahedra ? this->OnTetrahedra(low, shares) : this->Trilinear(low, shares);
  }

  /// Points of steep cells.
  std::vector<Cone<3>> LowPlaces(double slope) const
  {
    std::vector<Cone<3>> places;
    const int nodes = this->Cells + 1;
    for (int node = 0; node < nodes * nodes * nodes; ++node)
    {
      const Axes low = this->AxesOf(node);
      if (*std::max_element(low.begin(), low.end()) < this->Cells && this->IsSteep(low, slope))
      {
        this->AddPlacesIn(low, places);
      }
    }
    return places;
  }

private:
  using Axes = std::array<int, 3>;

  Axes AxesOf(int node) const
  {
    const int nodes = this->Cells + 1;
    return { node % nodes, node / nodes % nodes, node / nodes / nodes };
  }
  Point<3> PlaceOf(const Axes& axes) const
  {
    const double step = 1.0 / this->Cells;
    return { step * axes[0], step * axes[1], step * axes[2] };
  }
  double ValueAt(Axes low, int corner) const
  {
    const int nodes = this->Cells + 1;
    const int node = low[0] + (corner & 1) +
      nodes * (low[1] + ((corner >> 1) & 1) + nodes * (low[2] + (corner >> 2)));
    return this->Values[static_cast<std::size_t>(node)];
  }
  /// A lattice as fine as .4 of the least value; within tetrahedra, too, as these have faces there.
  void AddPlacesIn(const Axes& low, std::vector<Cone<3>>& places) const
  {
    double least = this->ValueAt(low, 0);
    for (int corner = 1; corner < 8; ++corner)
    {
      least = std::min(least, this->ValueAt(low, corner));
    }
    const int parts = std::max(1, static_cast<int>(std::ceil(1.0 / (0.4 * least * this->Cells))));
    for (int k = 0; k < (parts + 1) * (parts + 1) * (parts + 1); ++k)
    {
      Point<3> place = this->PlaceOf(low);
      int rest = k;
      for (double& coordinate : place)
      {
        coordinate += rest % (parts + 1) / static_cast<double>(parts) / this->Cells;
        rest /= parts + 1;
      }
      const double value = (*this)(place);
      places.emplace_back(place, place, value, value, Gradation);
    }
  }
  double Trilinear(const Axes& low, const Point<3>& shares) const
  {
    double value = 0.0;
    for (int corner = 0; corner < 8; ++corner)
    {
      double weight = 1.0;
      for (int d = 0; d < 3; ++d)
      {
        const double share = shares[static_cast<std::size_t>(d)];
        weight *= ((corner >> d) & 1) != 0 ? share : 1.0 - share;
      }
      value += weight * this->ValueAt(low, corner);
    }
    return value;
  }
  /// The tetrahedron goes from corner 0 to 7 along the axes, the largest share first.
  double OnTetrahedra(const Axes& low, const Point<3>& shares) const
  {
    std::array<std::size_t, 3> order{ 0, 1, 2 };
    std::sort(order.begin(), order.end(),
      [&shares](std::size_t a, std::size_t b) { return shares[a] > shares[b]; });
    int corner = 0;
    double value = (1.0 - shares[order[0]]) * this->ValueAt(low, 0);
    for (std::size_t k = 0; k < 3; ++k)
    {
      corner |= 1 << order[k];
      const double next = k < 2 ? shares[order[k + 1]] : 0.0;
      value += (shares[order[k]] - next) * this->ValueAt(low, corner);
    }
    return value;
  }
  bool IsSteep(const Axes& low, double slope) const
  {
    double square = 0.0;
    for (int d = 0; d < 3; ++d)
    {
      double most = 0.0;
      for (int corner = 0; corner < 8; ++corner)
      {
        most = std::max(
          most, std::abs(this->ValueAt(low, corner) - this->ValueAt(low, corner ^ (1 << d))));
      }
      square += most * most;
    }
    return std::sqrt(square) * this->Cells > slope;
  }

  const int Cells; ///< along each axis
  const bool AreTetrahedra;
  std::vector<double> Values;
};

struct Case3
{
  std::string Name;
  Volume Given;
  int Parts; ///< of each cell along each axis, that are looked at
};

std::vector<Case3> Cases3(int nodes)
{
  Sampler sampler(3);
  const auto noise = [&sampler](const Point<3>&) { return 0.1 * std::exp(2.0 * sampler.Next()); };
  const auto around = [](double slope)
  {
    return [slope](const Point<3>& x) {
      return 0.03 + slope * std::max(Distance<3>(x, { 0.5, 0.5, 0.5 }) - 0.05, 0.0);
    };
  };
  const auto jump = [](const Point<3>& x) { return x[0] + 0.3 * x[1] < 0.5 ? 0.04 : 0.4; };
  const auto low = [](const Point<3>& x) {
    return Distance<3>(x, { 0.5, 0.5, 0.5 }) < 0.1 ? 0.02 : 1.0;
  };
  return { { "gentle", Volume(nodes, false, around(0.9 * Gradation)), 1 },
    { "slope g", Volume(nodes, false, around(Gradation)), 1 },
    { "jump", Volume(nodes, false, jump), 6 }, { "noise", Volume(nodes, false, noise), 4 },
    { "wide cells", Volume(3, false, low), 20 },
    { "tetrahedra", Volume(nodes / 2, true, noise), 8 } };
}

ConeTree<3> TreeOf3(const Volume& given)
{
  return { given.LowPlaces(1.02 * Gradation), Gradation, { { 0.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 } } };
}

/// min over many places y of given(y) + g |x - y|.
double Limit3(const Case3& test, int nodes, const Point<3>& x)
{
  const int steps = (nodes - 1) * test.Parts;
  double least = test.Given(x);
  for (int k = 0; k <= steps; ++k)
  {
    for (int j = 0; j <= steps; ++j)
    {
      for (int i = 0; i <= steps; ++i)
      {
        const Point<3> y{ i / static_cast<double>(steps), j / static_cast<double>(steps),
          k / static_cast<double>(steps) };
        const double growth = Gradation * Distance<3>(x, y);
        least = growth < least ? std::min(least, test.Given(y) + growth) : least;
      }
    }
  }
  return least;
}

} // namespace

TEST(ConeTree, IsTheLargestFunctionBelowVolumesAndTetrahedra)
{
  constexpr int Nodes = 9;
  for (const Case3& test : Cases3(Nodes))
  {
    const ConeTree<3> tree = TreeOf3(test.Given);
    const int nodes = test.Name == "wide cells" ? 3 : test.Name == "tetrahedra" ? Nodes / 2 : Nodes;
    Sampler sampler(5);
    std::vector<double> errors;
    for (int probe = 0; probe < 50; ++probe)
    {
      const Point<3> x{ sampler.Next(), sampler.Next(), sampler.Next() };
      const double f = std::min(test.Given(x), tree(x));
      errors.push_back(std::abs(f / Limit3(test, nodes, x) - 1.0));
    }
    std::sort(errors.begin(), errors.end());
    EXPECT_LT(errors.back(), 0.1) << test.Name;
    EXPECT_LT(errors[48], 0.05) << test.Name;
  }
}

TEST(ConeTree, IsInfiniteWhereThereAreNoCones)
{
  const Volume gentle(17, false, [](const Point<3>& x) { return 0.1 + 0.1 * x[0] + 0.2 * x[2]; });
  EXPECT_TRUE(gentle.LowPlaces(1.02 * Gradation).empty());
  EXPECT_EQ(TreeOf3(gentle)({ 0.3, 0.5, 0.2 }), std::numeric_limits<double>::infinity());
}
