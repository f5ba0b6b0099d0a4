// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "DensitySamples.h"

#include <algorithm> // for max, min

namespace biting
{

namespace
{

constexpr int LeastDepth = 5;
constexpr int GreatestDepth = 16; // a blow-up of 1/f^2 in one place ends there
constexpr int Looks = 4;          // a row, at squares that the boundary divides

class Sampler
{
public:
  Sampler(const Domain& domain, const DomainLocator& locator, const Spacing& spacing, double most,
    std::size_t mostVisits, Pulse& pulse)
    : Geometry(domain)
    , Locator(locator)
    , F(spacing)
    , Most(most)
    , MostVisits(mostVisits)
    , Beats(pulse)
  {
  }

  std::vector<DensitySample> Sample()
  {
    const Box2& bounds = this->Geometry.Bounds;
    this->Visit(bounds.Center(), 0.5 * std::max(bounds.Width(), bounds.Height()), 0);
    return std::move(this->Samples);
  }

private:
  void Visit(const Point2& center, double half, int depth);
  void Divide(const Point2& center, double half, int depth);
  double ShareInside(const Point2& center, double half, bool isClear) const;
  double DensityOf(const Point2& center, double half) const;

  const Domain& Geometry;
  const DomainLocator& Locator;
  const Spacing& F;
  double Most;
  std::size_t MostVisits;
  std::size_t Visits = 0;
  Pulse& Beats;
  std::vector<DensitySample> Samples;
};

void Sampler::Visit(const Point2& center, double half, int depth)
{
  ++this->Visits;
  const Point2 diagonal{ half, half };
  const bool isClear = this->Locator.IsClear({ center - diagonal, center + diagonal });
  const double share = this->ShareInside(center, half, isClear);
  if ((isClear && share == 0.0) || !this->Beats.Beat(64))
  {
    return;
  }
  const double density = this->DensityOf(center, half);
  const bool mayDivide = depth < GreatestDepth && this->Visits < this->MostVisits;
  if (depth < LeastDepth || (density > this->Most && mayDivide))
  {
    this->Divide(center, half, depth);
  }
  else if (share > 0.0)
  {
    this->Samples.push_back({ center, share * density });
  }
}

void Sampler::Divide(const Point2& center, double half, int depth)
{
  const double quarter = 0.5 * half;
  for (const Point2& offset : { Point2{ -quarter, -quarter }, Point2{ quarter, -quarter },
         Point2{ -quarter, quarter }, Point2{ quarter, quarter } })
  {
    this->Visit(center + offset, quarter, depth + 1);
  }
}

double Sampler::ShareInside(const Point2& center, double half, bool isClear) const
{
  if (isClear)
  {
    return this->Locator.IsInside(center) ? 1.0 : 0.0;
  }
  int inside = 0;
  for (int k = 0; k < Looks * Looks; ++k)
  {
    const Point2 step{ (2 * (k % Looks) + 1.0) / Looks - 1.0,
      (2 * (k / Looks) + 1.0) / Looks - 1.0 };
    inside += this->Locator.IsInside(center + half * step) ? 1 : 0;
  }
  return inside / static_cast<double>(Looks * Looks);
}

// The mean over the centres of the quarters.
double Sampler::DensityOf(const Point2& center, double half) const
{
  const double quarter = 0.5 * half;
  double sum = 0.0;
  for (const Point2& offset : { Point2{ -quarter, -quarter }, Point2{ quarter, -quarter },
         Point2{ -quarter, quarter }, Point2{ quarter, quarter } })
  {
    const double f = this->F(center + offset);
    sum += half * half / (f * f);
  }
  return sum;
}

} // namespace

std::vector<DensitySample> SampleDensity(const Domain& domain, const DomainLocator& locator,
  const Spacing& spacing, double most, std::size_t mostVisits, Pulse& pulse)
{
  return Sampler(domain, locator, spacing, most, mostVisits, pulse).Sample();
}

} // namespace biting
