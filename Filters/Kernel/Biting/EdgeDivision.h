// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingEdgeDivision_h
#define BitingEdgeDivision_h

#include "../Base/Ids.h"
#include "../Base/Point.h"
#include "../Base/Pulse.h"
#include "../Spacing/Spacing.h"
#include "EdgeSamples.h"

#include <vector> // for the arrays

namespace biting
{

/// The vertices that divide an edge, ascending from its start: their parameters in (0, 1) and the
/// spacing at each.
struct DivisionPoints
{
  std::vector<double> Parameters;
  std::vector<double> Spacings;
};

/// Places at which an edge is to be divided in any case: distances from its start, and from its
/// end, ascending, less than the length of the edge.
struct EndShells
{
  std::vector<double> Start;
  std::vector<double> End;
};

/// Divides edges by equal integrals of 1/f.
///
/// With I the integral of 1/f along the edge and n parts, neighbours are I/n spacings apart. n is
/// the whole number for which I/n is nearest to TargetLength, as a ratio, of those with c_b <= I/n
/// < 2 c_b: then the bites cover the edge, and no odd gap is left at its end, as it is when an edge
/// is walked from one end (paper, section 4.3, figure 11 c). I/n is at least 1.0824 c_b where that
/// can be had, which keeps centres out of the bites of the edge's ends and of neighbours with a
/// larger f; for I from 2 to 2.165 c_b it cannot, and the one centre may lie up to 8 % deep in
/// them. Where f varies so fast that equal parts leave a gap between two bites, n grows until they
/// meet. Where an edge has shells at its ends, what lies between these is divided like that; the
/// innermost shells are left out until that is at least LeastRest wanted parts long.
class EdgeDivider
{
public:
  /// Of c_b: 1 / cos(22.5 degrees), how far the square of an input vertex with an angle of 45..315
  /// degrees reaches along its edges (figure 7). For circles it is a margin where f varies.
  static constexpr double LeastPart = 1.0824;

  /// Of the wanted length: 1/sqrt(2). Where parts may be that short, those of an edge that is not
  /// shorter itself are all within 1/sqrt(2) and sqrt(2) of it.
  static constexpr double BalancedPart = 0.70710678118654752;

  /// Parts of what is left between shells are at least 3/4 of the wanted length, then.
  static constexpr double LeastRest = 1.5;

  /// `bitingConstant` is c_b; `targetLength` the wanted length of a part in units of f; `leastPart`
  /// the least one, in units of c_b f, that is not passed as long as the bites cover the edge.
  EdgeDivider(const Spacing& spacing, double bitingConstant, double targetLength, Pulse& pulse,
    double leastPart = LeastPart);

  /// Tells f at the ends of the edge that is divided next, so that it is not asked for.
  void TellEnds(const Point2& a, double atA, const Point2& b, double atB)
  {
    this->AtEnds = { a, b, atA, atB };
  }

  /// The points that divide the edge ab. At most `limit` points; where more are needed, and on
  /// abort, returns false. Law: the edge ba has the same points, its parameters mirrored.
  bool Divide(const Point2& a, const Point2& b, Id limit, DivisionPoints& points);
  bool Divide(
    const Point2& a, const Point2& b, const EndShells& shells, Id limit, DivisionPoints& points);

private:
  // A stretch of the edge, with 1/f at its ends and middle, and the integral up to its start.
  struct Panel
  {
    double Start, End;
    double First, Middle, Last;
    double Before;
  };

  // The edge at hand, with f at its ends.
  struct Ends
  {
    Point2 Start, End;
    double StartSpacing = 0.0;
    double EndSpacing = 0.0;
  };

  void AskAtEnds(const Point2& a, const Point2& b);
  bool DivideForward(const Point2& a, const Point2& b, const std::vector<double>& startShells,
    const std::vector<double>& endShells, Id limit, DivisionPoints& points);
  void FitShells(
    double length, const std::vector<double>& startShells, const std::vector<double>& endShells);
  bool Integrate(const Point2& a, const Point2& b, Id limit);
  bool AddStretches(
    double length, const EdgeSamples::Sample& from, const EdgeSamples::Sample& to, Id limit);
  bool AddPanels(
    double length, const EdgeSamples::Sample& from, const EdgeSamples::Sample& to, Id limit);
  bool Covers(const Point2& a, const Point2& b, const DivisionPoints& points) const;
  Id NumberOfParts() const;
  double ParameterAt(double integral) const;
  double IntegralAt(double parameter) const;
  void PlaceAt(double parameter, const Point2& a, const Point2& b, DivisionPoints& points) const;
  void Place(const Point2& a, const Point2& b, Id parts, DivisionPoints& points) const;

  const Spacing& F;
  EdgeSamples Samples;
  double BitingConstant;
  double TargetLength;
  double LeastLength;
  Pulse& Beats;
  Ends AtEnds;
  std::vector<Panel> Panels; ///< of the edge at hand
  double Total = 0.0;        ///< integral of 1/f along the edge at hand

  // Of the edge at hand: the parameters of its shells, and the integral of 1/f up to where what
  // lies between them begins and ends.
  std::vector<double> Before; ///< ascending
  std::vector<double> Behind; ///< descending
  double From = 0.0;
  double To = 0.0;
};

} // namespace biting

#endif
