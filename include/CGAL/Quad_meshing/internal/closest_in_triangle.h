// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_INTERNAL_CLOSEST_IN_TRIANGLE_H
#define CGAL_QUAD_MESHING_INTERNAL_CLOSEST_IN_TRIANGLE_H

#include <CGAL/Kernel/global_functions_3.h>
#include <CGAL/Simple_cartesian.h>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Where in its triangle a closest point lies: side k, which starts at corner k, is k; corner k is first_corner + k.
struct Place_in_triangle
{
  enum
  {
    first_corner = 3,
    inside = 6
  };
};

// The closest point in a triangle, by the regions of its sides and corners (Ericson 2005, Real-Time Collision
// Detection, section 5.1.5). Returns where it lies.
inline int closest_in_triangle(const Simple_cartesian<double>::Point_3& p, const Simple_cartesian<double>::Point_3& a,
                               const Simple_cartesian<double>::Point_3& b, const Simple_cartesian<double>::Point_3& d,
                               Simple_cartesian<double>::Point_3& closest)
{
  typedef Simple_cartesian<double>::Vector_3 Vector_3;
  const auto ratio = [](double numerator, double denominator) { return denominator > 0 ? numerator / denominator : 0; };
  const Vector_3 ab = b - a, ad = d - a, ap = p - a;
  const double d1 = ab * ap, d2 = ad * ap;
  if(d1 <= 0 && d2 <= 0)
  {
    closest = a;
    return Place_in_triangle::first_corner;
  }
  const Vector_3 bp = p - b;
  const double d3 = ab * bp, d4 = ad * bp;
  if(d3 >= 0 && d4 <= d3)
  {
    closest = b;
    return Place_in_triangle::first_corner + 1;
  }
  const double vc = d1 * d4 - d3 * d2;
  if(vc <= 0 && d1 >= 0 && d3 <= 0)
  {
    closest = a + ratio(d1, d1 - d3) * ab;
    return 0;
  }
  const Vector_3 dp = p - d;
  const double d5 = ab * dp, d6 = ad * dp;
  if(d6 >= 0 && d5 <= d6)
  {
    closest = d;
    return Place_in_triangle::first_corner + 2;
  }
  const double vb = d5 * d2 - d1 * d6;
  if(vb <= 0 && d2 >= 0 && d6 <= 0)
  {
    closest = a + ratio(d2, d2 - d6) * ad;
    return 2;
  }
  const double va = d3 * d6 - d5 * d4;
  if(va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0)
  {
    closest = b + ratio(d4 - d3, (d4 - d3) + (d5 - d6)) * (d - b);
    return 1;
  }
  const double sum = va + vb + vc;
  if(!(sum > 0))
  {
    closest = a;
    return Place_in_triangle::first_corner;
  }
  closest = a + (vb / sum) * ab + (vc / sum) * ad;
  return Place_in_triangle::inside;
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_INTERNAL_CLOSEST_IN_TRIANGLE_H
