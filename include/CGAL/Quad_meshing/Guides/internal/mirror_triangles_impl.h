// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_GUIDES_INTERNAL_MIRROR_TRIANGLES_IMPL_H
#define CGAL_QUAD_MESHING_GUIDES_INTERNAL_MIRROR_TRIANGLES_IMPL_H

#include <CGAL/Quad_meshing/Guides/mirror_triangles.h>
#include <CGAL/Quad_meshing/internal/compatibility.h>

#include <CGAL/AABB_tree.h>
#include <CGAL/Bbox_3.h>
#include <CGAL/Random.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The surface as something that points are near to or far from.
class Mirrored_surface
{
  typedef Exact_predicates_inexact_constructions_kernel Kernel;
  typedef Kernel::Triangle_3 Triangle_3;
  typedef Aabb_triangle_primitive<Kernel, std::vector<Triangle_3>::const_iterator> Primitive;

public:
  typedef Mirror::Point_3 Point_3;
  typedef Mirror::Vector_3 Vector_3;

  explicit Mirrored_surface(const Guided_triangles& s)
  {
    for(const std::array<int, 3>& t : s.triangles)
    {
      const Triangle_3 triangle(s.points[t[0]], s.points[t[1]], s.points[t[2]]);
      if(!triangle.is_degenerate())
        m_triangles.push_back(triangle);
      box += triangle.bbox();
    }
    m_tree.insert(m_triangles.cbegin(), m_triangles.cend());
  }

  Bbox_3 box;

  Point_3 box_center() const
  {
    return Point_3((box.xmin() + box.xmax()) / 2, (box.ymin() + box.ymax()) / 2, (box.zmin() + box.zmax()) / 2);
  }

  Point_3 closest(const Point_3& p) const { return m_tree.closest_point(p); }

  // The center of the surface, and the matrix of its second moments about it, over its area: the integrals over the
  // triangles.
  Vector_3 moments(Eigen::Matrix3d& second) const
  {
    double area = 0;
    Eigen::Vector3d first = Eigen::Vector3d::Zero();
    second.setZero();
    for(const Triangle_3& t : m_triangles)
    {
      const double a = std::sqrt(t.squared_area());
      Eigen::Vector3d sum = Eigen::Vector3d::Zero();
      for(int k = 0; k < 3; ++k)
      {
        const Eigen::Vector3d p(t[k].x(), t[k].y(), t[k].z());
        sum += p;
        second += a / 12 * p * p.transpose();
      }
      second += a / 12 * sum * sum.transpose();
      first += a / 3 * sum;
      area += a;
    }
    first /= area;
    second = second / area - first * first.transpose();
    return Vector_3(first.x(), first.y(), first.z());
  }

  // Points that lie evenly on the surface, the same at each call.
  std::vector<Point_3> samples(int n) const
  {
    std::vector<double> sums;
    double area = 0;
    for(const Triangle_3& t : m_triangles)
      sums.push_back(area += std::sqrt(t.squared_area()));
    Random random(0);
    std::vector<Point_3> result;
    for(int i = 0; i < n; ++i)
    {
      const std::size_t k =
        static_cast<std::size_t>(std::lower_bound(sums.begin(), sums.end(), random.get_double(0, area)) - sums.begin());
      const Triangle_3& t = m_triangles[(std::min)(k, m_triangles.size() - 1)];
      double u = random.get_double(0, 1), v = random.get_double(0, 1);
      if(u + v > 1)
      {
        u = 1 - u;
        v = 1 - v;
      }
      result.push_back(t[0] + u * (t[1] - t[0]) + v * (t[2] - t[0]));
    }
    return result;
  }

private:
  std::vector<Triangle_3> m_triangles;
  AABB_tree<Aabb_traits<Kernel, Primitive>> m_tree;
};

// Looks for the plane in which samples of a surface come nearest to it. The planes that are tried are orthogonal to the
// axes of the coordinates and of inertia, and halfway between samples; each is brought to its best place, as in
// registration: samples are mirrored, the nearest points found, and the plane that mirrors the ones to the others best.
class Mirror_search
{
  typedef Mirror::Point_3 Point_3;
  typedef Mirror::Vector_3 Vector_3;

public:
  explicit Mirror_search(const Guided_triangles& s) : m_surface(s), m_samples(m_surface.samples(number_of_samples)) {}

  Mirror run()
  {
    for(int c = 0; c < 3; ++c)
      try_plane(m_surface.box_center(), Vector_3(c == 0, c == 1, c == 2), false);
    Eigen::Matrix3d inertia;
    const Vector_3 center = m_surface.moments(inertia);
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(inertia);
    for(int c = 0; c < 3; ++c)
      try_plane(ORIGIN + center, vector(axes.eigenvectors().col(c)), true);
    // A plane of symmetry contains the center, and the two points are as far from it.
    const double tolerance = 0.01; // of the diagonal
    const double diagonal = std::sqrt(std::pow(m_surface.box.x_span(), 2) + std::pow(m_surface.box.y_span(), 2) +
                                      std::pow(m_surface.box.z_span(), 2));
    Random random(0);
    for(int i = 0, tried = 0; i < most_pairs && tried < most_planes; ++i)
    {
      const Point_3 &p = m_samples[random.get_int(0, number_of_samples)],
                    &q = m_samples[random.get_int(0, number_of_samples)];
      const Vector_3 d = q - p;
      const double length = std::sqrt(d.squared_length());
      if(!(length > tolerance * diagonal) ||
         std::abs((midpoint(p, q) - (ORIGIN + center)) * d) > tolerance * diagonal * length)
        continue;
      ++tried;
      try_plane(midpoint(p, q), d / length, true);
    }
    try_plane(m_best_point, m_best_normal, true, last_rounds);
    return Mirror(m_best_point, m_best_normal);
  }

private:
  static constexpr int number_of_samples = 1000, first_samples = 40, most_pairs = 200000, most_planes = 400,
                       few_rounds = 8,
                       last_rounds = 40; // of the best plane

  static Eigen::Vector3d column(const Vector_3& v) { return Eigen::Vector3d(v.x(), v.y(), v.z()); }
  static Vector_3 vector(const Eigen::Vector3d& v) { return Vector_3(v.x(), v.y(), v.z()); }

  // The mean distance of the first samples after mirroring.
  double deviation(const Mirror& mirror, int n) const
  {
    double sum = 0;
    for(int i = 0; i < n; ++i)
    {
      const Point_3 p = mirror.image(m_samples[i]);
      sum += std::sqrt(squared_distance(p, m_surface.closest(p)));
    }
    return sum / n;
  }

  void try_plane(Point_3 point, Vector_3 normal, bool may_move, int rounds = few_rounds)
  {
    // Planes that a few samples are far off with are not worth more.
    const double hopeless = 3;
    if(deviation(Mirror(point, normal), first_samples) > hopeless * m_best)
      return;
    for(int round = 0; round < (may_move ? rounds : 1); ++round)
    {
      const Mirror mirror(point, normal);
      const double d = deviation(mirror, number_of_samples);
      if(d < m_best)
      {
        m_best = d;
        m_best_point = point;
        m_best_normal = normal;
      }
      if(!may_move)
        return;
      // Of all reflections, the one that brings the samples nearest to the others: its normal n minimizes n^t M n.
      Vector_3 center(0, 0, 0), other_center(0, 0, 0);
      std::vector<Point_3> others;
      for(const Point_3& p : m_samples)
      {
        others.push_back(m_surface.closest(mirror.image(p)));
        center = center + (p - ORIGIN) / number_of_samples;
        other_center = other_center + (others.back() - ORIGIN) / number_of_samples;
      }
      Eigen::Matrix3d m = Eigen::Matrix3d::Zero();
      for(int i = 0; i < number_of_samples; ++i)
      {
        const Eigen::Vector3d a = column(m_samples[i] - (ORIGIN + center)),
                              b = column(others[i] - (ORIGIN + other_center));
        m += a * b.transpose() + b * a.transpose();
      }
      const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(m);
      normal = vector(axes.eigenvectors().col(0));
      point = ORIGIN + (center + other_center) / 2;
    }
  }

  const Mirrored_surface m_surface;
  const std::vector<Point_3> m_samples;
  double m_best = std::numeric_limits<double>::infinity();
  Point_3 m_best_point;
  Vector_3 m_best_normal;
};

CGAL_QUAD_MESHING_INLINE Mirror make_mirror(const Guided_triangles& surface, const Symmetry_plane& plane)
{
  if(plane.kind == Symmetry_plane::Kind::FOUND)
    return Mirror_search(surface).run();
  const double length = std::sqrt(plane.normal.squared_length());
  // Along an axis, no rounding.
  Mirror::Vector_3 normal = plane.normal / length;
  for(int c = 0; c < 3; ++c)
    if(plane.normal[(c + 1) % 3] == 0 && plane.normal[(c + 2) % 3] == 0)
      normal = (plane.normal[c] > 0 ? 1. : -1.) * Mirror::Vector_3(c == 0, c == 1, c == 2);
  if(plane.kind == Symmetry_plane::Kind::PLANE)
    return Mirror(ORIGIN - (plane.offset / length) * normal, normal);
  return Mirror(Mirrored_surface(surface).box_center(), normal);
}

CGAL_QUAD_MESHING_INLINE double mirror_deviation(const Guided_triangles& surface, const Mirror& mirror)
{
  const Mirrored_surface s(surface);
  double largest = 0;
  for(const Mirror::Point_3& p : surface.points)
  {
    const Mirror::Point_3 q = mirror.image(p);
    largest = (std::max)(largest, squared_distance(q, s.closest(q)));
  }
  return std::sqrt(largest);
}

// Cuts triangles at a mirror.
class Half_cutter
{
public:
  Half_cutter(const Guided_triangles& surface, const Mirror& mirror, double snap)
    : m_surface(surface), m_mirror(mirror), m_number(surface.points.size(), -1)
  {
    for(const Mirror::Point_3& p : surface.points)
    {
      const double d = mirror.distance(p);
      m_distance.push_back(std::abs(d) <= snap ? 0 : d);
    }
  }

  Mirror_half run()
  {
    for(std::size_t f = 0; f < m_surface.triangles.size(); ++f)
      cut(static_cast<int>(f));
    if(half.triangles.empty())
      half.error = "There is nothing on one side of the plane of symmetry.";
    // A side in the mirror belongs to one triangle, else the surface does not cross the mirror there.
    std::map<std::pair<int, int>, int> in_mirror;
    for(std::size_t i = 0; i < half.triangles.size(); ++i)
      for(int k = 0; k < 3; ++k)
        if(half.is_cut[i][k])
        {
          const int a = half.triangles[i][k], b = half.triangles[i][(k + 1) % 3];
          if(++in_mirror[std::make_pair((std::min)(a, b), (std::max)(a, b))] > 1)
            half.error = "The surface touches the plane of symmetry without crossing it.";
        }
    return half;
  }

  Mirror_half half;

private:
  // A corner of what is left of a triangle, and the side of the triangle that starts there.
  struct Corner
  {
    int point;
    char side;
    bool is_in_mirror;
  };

  void cut(int f)
  {
    const std::array<int, 3>& t = m_surface.triangles[f];
    double highest = 0;
    for(int v : t)
      highest = (std::max)(highest, m_distance[v]);
    if(!(highest > 0))
      return;
    std::vector<Corner> corners;
    for(int k = 0; k < 3; ++k)
    {
      const int a = t[k], b = t[(k + 1) % 3];
      if(m_distance[a] >= 0)
        corners.push_back({ vertex(a), static_cast<char>(k), m_distance[a] == 0 });
      if(m_distance[a] * m_distance[b] < 0)
        corners.push_back({ crossing(a, b), static_cast<char>(k), true });
    }
    // The side that leaves the last corner on the positive side lies in the mirror.
    const std::size_t n = corners.size();
    if(n < 3)
      return;
    auto is_in_mirror = [&](std::size_t i) { return corners[i].is_in_mirror && corners[(i + 1) % n].is_in_mirror; };
    if(n == 3)
      return add(f, corners, { { 0, 1, 2 } }, is_in_mirror);
    const bool first = squared_distance(half.points[corners[0].point], half.points[corners[2].point]) <=
                       squared_distance(half.points[corners[1].point], half.points[corners[3].point]);
    const std::size_t s = first ? 0 : 1;
    add(f, corners, { { s, s + 1, s + 2 } }, is_in_mirror);
    add(f, corners, { { s, s + 2, (s + 3) % 4 } }, is_in_mirror);
  }

  template <typename In_mirror>
  void add(int f, const std::vector<Corner>& corners, const std::array<std::size_t, 3>& which,
           const In_mirror& is_in_mirror)
  {
    std::array<int, 3> t;
    std::array<char, 3> side, is_cut;
    for(int k = 0; k < 3; ++k)
    {
      const std::size_t i = which[k], j = which[(k + 1) % 3];
      t[k] = corners[i].point;
      const bool is_side = j == (i + 1) % corners.size();
      is_cut[k] = is_side && is_in_mirror(i);
      side[k] = is_side && !(is_cut[k] && is_crossed(f)) ? corners[i].side : Cut_triangles::inside;
    }
    half.triangles.push_back(t);
    half.origin.push_back(static_cast<std::size_t>(f));
    half.side.push_back(side);
    half.is_cut.push_back(is_cut);
  }

  // Whether the triangle has corners on both sides of the mirror, so that what lies in the mirror is none of its sides.
  bool is_crossed(int f) const
  {
    const std::array<int, 3>& t = m_surface.triangles[f];
    return std::min({ m_distance[t[0]], m_distance[t[1]], m_distance[t[2]] }) < 0;
  }

  int vertex(int v)
  {
    if(m_number[v] == -1)
    {
      m_number[v] = static_cast<int>(half.points.size());
      half.points.push_back(m_distance[v] == 0 ? m_mirror.projection(m_surface.points[v]) : m_surface.points[v]);
      half.ends.push_back({ { v, v } });
      half.weight.push_back(0);
    }
    return m_number[v];
  }

  int crossing(int a, int b)
  {
    if(a > b)
      std::swap(a, b); // the same point from both sides
    const auto found = m_crossing.emplace(std::make_pair(a, b), static_cast<int>(half.points.size()));
    if(found.second)
    {
      const double t = m_distance[a] / (m_distance[a] - m_distance[b]);
      half.points.push_back(m_mirror.projection(m_surface.points[a] + t * (m_surface.points[b] - m_surface.points[a])));
      half.ends.push_back({ { a, b } });
      half.weight.push_back(t);
    }
    return found.first->second;
  }

  const Guided_triangles& m_surface;
  const Mirror& m_mirror;
  std::vector<double> m_distance; // per point, signed; 0 in the mirror
  std::vector<int> m_number;      // per point: in the half, -1 if not there
  std::map<std::pair<int, int>, int> m_crossing;
};

CGAL_QUAD_MESHING_INLINE Mirror_half cut_half(const Guided_triangles& surface, const Mirror& mirror, double snap)
{
  return Half_cutter(surface, mirror, snap).run();
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_GUIDES_INTERNAL_MIRROR_TRIANGLES_IMPL_H
