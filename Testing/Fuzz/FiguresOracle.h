// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingFiguresOracle_h
#define BitingFiguresOracle_h

#include "JudgedMesh.h"

namespace biting
{

/// Delaunay, and what the mesh says of itself: figures of quality, bites.
class FiguresOracle
{
public:
  explicit FiguresOracle(JudgedMesh& judged)
    : Judged(judged)
  {
  }

  bool Holds();

private:
  bool IsDelaunay();
  bool HasQuality();
  bool HasQualityOfTriangles();
  bool HasDistances();
  bool HasBites();
  bool HasBiteOrders();
  bool IsCentreOf(std::size_t vertex, Id order) const;

  JudgedMesh& Judged;
};

} // namespace biting

#endif
