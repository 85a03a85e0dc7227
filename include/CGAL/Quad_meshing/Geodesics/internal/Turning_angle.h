// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_GEODESICS_INTERNAL_TURNING_ANGLE_H
#define CGAL_QUAD_MESHING_GEODESICS_INTERNAL_TURNING_ANGLE_H

#include <CGAL/Exact_rational.h>

#include <cmath>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// A sum of angles of vectors, each from 0 to pi, that is compared with multiples of pi. The vectors are multiplied as
// complex numbers, and half turns are counted, so that no angle is computed.
class Turning_angle
{
public:
  struct Vector
  {
    double x, y;
  };

  void add(double x, double y)
  {
    // any positive number will do as scale
    const double scale = 1 / (std::fabs(x) + y), a = x * scale, b = y * scale;
    const double next_x = m_x * a - m_y * b, next_y = m_x * b + m_y * a;
    const bool is_turned = next_y < 0 || (next_y == 0 && next_x < 0);
    m_half_turns += is_turned;
    m_x = is_turned ? -next_x : next_x;
    m_y = is_turned ? -next_y : next_y;
    ++m_terms;
  }

  // Whether the sum is more than n pi and the angle of (1, slack). If rounding leaves a doubt, `otherwise()` says it.
  // No vector may be zero.
  //
  // A term adds at most 5 u to the error of the angle: the square root of 5 for the product, 2 for the scaled vector.
  // Where rounding gets the number of half turns wrong, the angle of what is left is wrong by pi, and the sum is right.
  template <typename Otherwise>
  bool exceeds(int n, double slack, const Otherwise& otherwise) const
  {
    if(m_half_turns != n && m_half_turns != n - 1)
      return m_half_turns > n;
    // the sum is n pi plus the angle of (x, y), which is between -pi and pi
    const double x = m_half_turns == n ? m_x : -m_x, y = m_half_turns == n ? m_y : -m_y;
    if(!(x > 0))
      return m_half_turns == n;
    const double difference = y - slack * x, error = 5 * (m_terms + 1) * unit() * (x + std::fabs(y));
    return std::fabs(difference) > error ? difference > 0 : otherwise();
  }

  // The same, exactly for the vectors as they are.
  template <typename Vectors>
  static bool exceeds_exactly(const Vectors& vectors, int n, double slack)
  {
    typedef Exact_rational Q;
    Q x(1), y(0);
    int half_turns = 0;
    for(const auto& v : vectors)
    {
      const Q a(v.x), b(v.y), next_x = x * a - y * b, next_y = x * b + y * a;
      const bool is_turned = next_y < 0 || (next_y == 0 && next_x < 0);
      half_turns += is_turned;
      x = is_turned ? Q(-next_x) : next_x;
      y = is_turned ? Q(-next_y) : next_y;
    }
    if(half_turns == n - 1 && x < 0)
      return -y > -Q(slack) * x; // a negative slack
    return half_turns > n || (half_turns == n && (!(x > 0) || y > Q(slack) * x));
  }

private:
  static constexpr double unit() { return 1.1102230246251565e-16; }

  double m_x = 1, m_y = 0;
  int m_half_turns = 0, m_terms = 0;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_GEODESICS_INTERNAL_TURNING_ANGLE_H
