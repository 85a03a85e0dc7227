// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_WORKING_MESH_INTERNAL_WORKING_MESH_BUILDER_H
#define CGAL_QUAD_MESHING_WORKING_MESH_INTERNAL_WORKING_MESH_BUILDER_H

#include <CGAL/Quad_meshing/Working_mesh/Working_mesh_result.h>
#include <CGAL/Quad_meshing/Working_mesh/internal/Triangle_patch.h>
#include <CGAL/Quad_meshing/internal/Reference_surface.h>
#include <CGAL/Quad_meshing/internal/Stage_progress.h>

#include <CGAL/number_type_config.h>
#include <CGAL/squared_distance_3.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Turns a copy of the input into triangles of the size that a quad mesh needs.
//
// Edges are collapsed onto vertices of the input where they are too short, split where they are too long, and flipped
// where that makes better triangles; vertices move along the input. No edit removes or bends away what is larger than
// the limits of `Triangle_patch`, joins what is apart, or takes a curve off its place. So no vertex jumps to another
// part of the surface: every place of the working mesh has come from its place on the input by small steps.
class Working_mesh_builder
{
public:
  typedef Editable_triangles::Point_3 Point_3;
  typedef Editable_triangles::Vector_3 Vector_3;

  // `face_length` has the target edge length of every face of the input, or is empty where it is the same everywhere.
  Working_mesh_builder(Reference_surface& input, const std::vector<char>& edge_is_feature, double target_edge_length,
                       const std::vector<double>& face_length, Any_visitor& visitor)
    : triangles(input.mesh(), edge_is_feature)
    , m_input(input)
    , m_shortest(shortest_edge * target_edge_length)
    , m_longest(longest_edge * target_edge_length)
    , m_largest_curve_error(largest_curve_error * target_edge_length)
    , m_progress(visitor)
    , m_mark(triangles.number_of_vertices(), 0)
  {
    m_limits.error = largest_error * target_edge_length;
    m_limits.quality = least_quality;
    for(double l : face_length)
    {
      m_relative_length.push_back(l / target_edge_length);
      m_largest_relative_length = (std::max)(m_largest_relative_length, m_relative_length.back());
    }
    for(int v = 0; v < triangles.number_of_vertices(); ++v)
      input_face.push_back(triangles.out[v] == -1 ? -1 : triangles.out[v] / 3);
    for(int f = 0; f < triangles.number_of_faces(); ++f)
      m_face_input.push_back({ triangles.area_vector(f), 0 });
  }

  Editable_triangles triangles;
  std::vector<int> input_face; // per vertex: a face of the input at or near it
  Working_mesh_result figures;

  // Returns false if the visitor stopped it.
  bool run()
  {
    m_progress.begin_part(0.6);
    if(!coarsen())
      return false;
    m_progress.begin_part(0.8);
    if(!refine())
      return false;
    m_progress.begin_part(1);
    for(int round = 0; round < rounds_of_improvement; ++round)
      if(!collapse_below(m_shortest) || !flip() || !move())
        return false;
    if(!refine()) // what flips and moves have made too long
      return false;
    for(int f = 0; f < triangles.number_of_faces(); ++f)
      if(!triangles.is_removed(f))
        figures.largest_error = (std::max)(figures.largest_error, m_face_input[f].error);
    return true;
  }

private:
  // In target edge lengths. A quad has about 12 triangles where the input has more: edges are between the shortest one
  // and about twice that.
  static constexpr double shortest_edge = 0.33, longest_edge = 1.5;
  // In target edge lengths: half of what is promised, as the interior of triangles is not looked at.
  static constexpr double largest_error = 0.05;
  // The same for curves, whose vertices are all looked at.
  static constexpr double largest_curve_error = 0.1;
  // See Triangle_patch::quality().
  static constexpr double least_quality = 0.35;
  // How much edges may grow from one pass over the mesh to the next. A small factor makes better triangles, a large one
  // takes fewer passes.
  static constexpr double growth = 1.4;
  // By which factor a collapse may make the longest edge around a vertex longer where that is long already, as with the
  // sides of needles.
  static constexpr double tolerated_growth = 1.1;
  // A curve may not turn by more at a vertex, in radians, where it did not before: 25 degrees.
  static constexpr double largest_turn = 25 * CGAL_PI / 180;
  // Chosen, not fitted: with 3 needles of CAD parts still leave bad triangles.
  static constexpr int rounds_of_improvement = 6;
  // Triangles better than this are left in place by move().
  static constexpr double good_quality = 0.7;
  // Sums of two cotangents that are nearer to zero than this are those of a rectangle.
  static constexpr double least_gain = 1e-6;
  // Passes over all edges: a bound on the work where flips go on and on.
  static constexpr int most_passes_of_flips = 10;
  // Vertices and edges that are looked at between two reports to the visitor: a few milliseconds.
  static constexpr int elements_per_report = 4096;

  // The length of quads at a vertex, in target edge lengths.
  double relative_length(int v) const { return m_relative_length.empty() ? 1. : m_relative_length[input_face[v]]; }

  Triangle_patch::Limits limits_at(int v) const
  {
    Triangle_patch::Limits limits = m_limits;
    limits.error *= relative_length(v);
    return limits;
  }

  bool is_reported(int i) { return i % elements_per_report != 0 || m_progress.go_further(); }

  // Passes with growing lengths: triangles stay alike, and all have the same say in which vertices remain.
  bool coarsen()
  {
    double sum = 0;
    for(int h = 0; h < triangles.number_of_halfedges(); ++h)
      sum += triangles.length(h);
    const double mean = sum / triangles.number_of_halfedges();
    for(double shortest = mean / m_largest_relative_length; shortest < m_shortest; shortest *= growth)
      if(!collapse_below(shortest) || !flip())
        return false;
    return collapse_below(m_shortest) && flip();
  }

  // Collapses edges shorter than a length where quads have the target edge length, and accordingly elsewhere.
  bool collapse_below(double shortest_of_target)
  {
    std::vector<std::pair<double, int>> edges; // squared length, halfedge
    std::vector<int> leaving;
    for(int v = 0; v < triangles.number_of_vertices(); ++v)
    {
      if(!is_reported(v))
        return false;
      if(triangles.out[v] == -1)
        continue;
      const double shortest = shortest_of_target * relative_length(v);
      triangles.leaving(v, leaving);
      edges.clear();
      for(int h : leaving)
        edges.push_back({ triangles.vector(h).squared_length(), h });
      if(const int last = leaving.back(); triangles.opposite[triangles.prev(last)] == -1)
        edges.push_back({ triangles.vector(triangles.prev(last)).squared_length(), triangles.prev(last) });
      std::sort(edges.begin(), edges.end());
      for(const auto& e : edges)
        if(!(e.first < shortest * shortest) || collapse(e.second, v, shortest))
          break;
    }
    return true;
  }

  // Moves v into the other end of an edge, if that is allowed.
  bool collapse(int h, int v, double shortest)
  {
    const int w = triangles.source(h) == v ? triangles.target(h) : triangles.source(h);
    double curve_error = -1;
    int other = -1; // the neighbor of v on its curve, if it is on one
    if(!stays_a_surface(h, v, w) || !stays_a_curve(h, v, w, other, curve_error))
      return false;
    double longest = 2 * shortest;
    for(int g : m_leaving)
      longest = (std::max)(longest, tolerated_growth * triangles.length(g));
    for(int g : m_leaving)
      if(squared_distance(triangles.points[triangles.target(g)], triangles.points[w]) > longest * longest)
        return false;
    if(!replace(v, triangles.points[w], w))
      return false;
    triangles.collapse(h, v);
    take_inputs();
    if(other != -1)
      set_curve_error(w, other, curve_error);
    ++figures.collapsed_edges;
    return true;
  }

  // The link condition [Dey et al. 1999], and no corner between two faces only. Leaves the halfedges around v in
  // m_leaving.
  bool stays_a_surface(int h, int v, int w)
  {
    triangles.leaving(w, m_leaving);
    for(int x : neighbors())
      m_mark[x] = w + 1;
    triangles.leaving(v, m_leaving);
    int common = 0;
    bool result = true;
    for(int x : neighbors())
      if(m_mark[x] == w + 1)
      {
        ++common;
        result = result && can_lose_a_face(x);
      }
    const int o = triangles.opposite[h];
    triangles.leaving(w, m_leaving);
    for(int x : neighbors())
      m_mark[x] = 0;
    triangles.leaving(v, m_leaving);
    return result && common == (o == -1 ? 1 : 2) && triangles.apex(h) != (o == -1 ? -1 : triangles.apex(o));
  }

  // The vertices next to the one that m_leaving was found for.
  const std::vector<int>& neighbors()
  {
    m_neighbors.clear();
    for(int h : m_leaving)
      m_neighbors.push_back(triangles.target(h));
    if(const int last = triangles.prev(m_leaving.back()); triangles.opposite[last] == -1)
      m_neighbors.push_back(triangles.source(last));
    return m_neighbors;
  }

  // Whether a vertex is left with a face on the border, and with three inside.
  bool can_lose_a_face(int v)
  {
    triangles.leaving(v, m_other_leaving);
    const bool is_on_border = triangles.opposite[m_other_leaving.front()] == -1;
    return m_other_leaving.size() > (is_on_border ? 1 : 3);
  }

  // A vertex of a curve goes along the curve only; ends and crossings of curves stay.
  bool stays_a_curve(int h, int v, int w, int& other, double& error)
  {
    triangles.curves_at(v, m_curves);
    if(m_curves.empty())
      return true;
    if(m_curves.size() != 2 || !triangles.is_on_curve(h))
      return false;
    double old_error = 0;
    for(int g : m_curves)
    {
      old_error = (std::max)(old_error, triangles.curve_error[g]);
      if(triangles.other_end(g, v) != w)
        other = triangles.other_end(g, v);
    }
    const int o = triangles.opposite[h];
    if(other == -1 || other == triangles.apex(h) || (o != -1 && other == triangles.apex(o)))
      return false;
    const Point_3 &p = triangles.points[v], &q = triangles.points[w], &r = triangles.points[other];
    error = old_error + std::sqrt(squared_distance(p, Simple_cartesian<double>::Segment_3(q, r)));
    return error <= m_largest_curve_error * relative_length(v) && turns_enough(other, v, w) &&
           turns_enough(w, v, other);
  }

  // Whether the curve through a does not turn more there if it goes on to c instead of b.
  bool turns_enough(int a, int b, int c)
  {
    triangles.curves_at(a, m_curves);
    if(m_curves.size() != 2)
      return true;
    const int before = triangles.other_end(m_curves[0], a) == b ? triangles.other_end(m_curves[1], a)
                                                                : triangles.other_end(m_curves[0], a);
    const Point_3& p = triangles.points[a];
    const Vector_3 in = p - triangles.points[before];
    return turn(in, triangles.points[c] - p) <= (std::max)(largest_turn, turn(in, triangles.points[b] - p));
  }

  static double turn(const Vector_3& a, const Vector_3& b)
  {
    return std::atan2(std::sqrt(cross_product(a, b).squared_length()), a * b);
  }

  void set_curve_error(int v, int w, double error)
  {
    triangles.leaving(v, m_leaving);
    for(int g : m_leaving)
      for(int k : { g, triangles.prev(g) })
        if(triangles.other_end(k, v) == w)
        {
          triangles.curve_error[k] = error;
          if(triangles.opposite[k] != -1)
            triangles.curve_error[triangles.opposite[k]] = error;
        }
  }

  // Judges the faces around v if v were at p; those that have w as a corner go, if it is one. Faces on different sides
  // of a curve stand for different parts of the input. m_leaving holds the halfedges that leave v.
  bool replace(int v, const Point_3& p, int w)
  {
    m_changed.clear();
    const Triangle_patch::Limits limits = limits_at(v);
    std::size_t first = 0;
    const std::size_t n = m_leaving.size();
    while(first < n && !triangles.is_on_curve(m_leaving[first]))
      ++first;
    first = first == n ? 0 : first;
    for(std::size_t i = 0; i < n;)
    {
      m_patch.clear();
      const std::size_t begin = m_changed.size();
      do
      {
        const int g = m_leaving[(first + i) % n], f = g / 3;
        Triangle_patch::Triangle t = triangle(f);
        m_patch.remove(t, m_face_input[f]);
        if(triangles.target(g) != w && triangles.apex(g) != w)
        {
          t[g % 3] = p;
          m_patch.add(t);
          m_changed.push_back({ f, Input_of_face() });
        }
        ++i;
      }
      while(i < n && !triangles.is_on_curve(m_leaving[(first + i) % n]));
      if(!m_patch.is_acceptable(triangles.points[v], limits))
        return false;
      for(std::size_t j = begin; j < m_changed.size(); ++j)
        m_changed[j].second = m_patch.inputs()[j - begin];
    }
    return true;
  }

  Triangle_patch::Triangle triangle(int f) const
  {
    const std::array<int, 3>& c = triangles.corners[f];
    return { { triangles.points[c[0]], triangles.points[c[1]], triangles.points[c[2]] } };
  }

  void take_inputs()
  {
    for(const auto& c : m_changed)
      m_face_input[c.first] = c.second;
  }

  // Splits the longest edges first, at their midpoints.
  bool refine()
  {
    typedef std::tuple<double, int, int> Entry; // length, and the vertices that it was measured between
    std::priority_queue<Entry> queue;
    auto push = [&](int h)
    {
      const double longest =
        m_longest * (std::min)(relative_length(triangles.source(h)), relative_length(triangles.target(h)));
      if(triangles.vector(h).squared_length() > longest * longest)
        queue.push(Entry(triangles.length(h), triangles.source(h), triangles.target(h)));
    };
    for(int h = 0; h < triangles.number_of_halfedges(); ++h)
      if(!triangles.is_removed(h / 3) && h > triangles.opposite[h])
        push(h);
    for(int i = 0; !queue.empty(); ++i)
    {
      if(!is_reported(i))
        return false;
      const auto [length, a, b] = queue.top();
      queue.pop();
      triangles.leaving(a, m_leaving);
      for(int h : m_leaving)
        if(triangles.target(h) == b)
        {
          const int m = split(h);
          triangles.leaving(m, m_leaving);
          for(int g : m_leaving)
            push(g);
          if(const int last = triangles.prev(m_leaving.back()); triangles.opposite[last] == -1)
            push(last);
          break;
        }
    }
    return true;
  }

  int split(int h)
  {
    const int o = triangles.opposite[h], first_new = triangles.number_of_faces();
    const Point_3 p = midpoint(triangles.points[triangles.source(h)], triangles.points[triangles.target(h)]);
    const int start = input_face[triangles.source(h)];
    const int m = triangles.split(h, p);
    input_face.push_back(m_input.follow(p, start, m_largest_curve_error).face);
    m_mark.push_back(0);
    int halved = first_new;
    for(int s : { h, o })
      if(s != -1)
      {
        Input_of_face& input = m_face_input[s / 3];
        input.area_vector = input.area_vector / 2;
        m_face_input.resize(halved + 1);
        m_face_input[halved++] = m_face_input[s / 3];
      }
    ++figures.split_edges;
    return m;
  }

  // Flips edges until no two neighbors are better with the other diagonal, or as often as is worthwhile.
  bool flip()
  {
    for(int pass = 0; pass < most_passes_of_flips; ++pass)
    {
      const std::size_t before = figures.flipped_edges;
      for(int h = 0; h < triangles.number_of_halfedges(); ++h)
      {
        if(!is_reported(h))
          return false;
        if(!triangles.is_removed(h / 3) && triangles.opposite[h] > h && !triangles.is_on_curve(h))
          flip(h);
      }
      if(figures.flipped_edges == before)
        break;
    }
    return true;
  }

  // Flips an edge that is not locally Delaunay: the angles opposite to it sum up to more than two right ones. On a
  // plane such flips end in the triangulation with the largest angles.
  void flip(int h)
  {
    const int o = triangles.opposite[h], f = h / 3, g = o / 3;
    const int a = triangles.source(h), b = triangles.target(h), c = triangles.apex(h), d = triangles.apex(o);
    const std::vector<Point_3>& p = triangles.points;
    if(!(cotangent(p[a], p[c], p[b]) + cotangent(p[a], p[d], p[b]) < -least_gain))
      return;
    m_patch.clear();
    m_patch.remove(triangle(f), m_face_input[f]);
    m_patch.remove(triangle(g), m_face_input[g]);
    m_patch.add({ { p[a], p[d], p[c] } });
    m_patch.add({ { p[d], p[b], p[c] } });
    Triangle_patch::Limits limits = limits_at(a);
    limits.quality = 0;
    if(!m_patch.is_acceptable(midpoint(p[a], p[b]), limits) || c == d || is_next_to(c, d) || !can_lose_a_face(a) ||
       !can_lose_a_face(b))
      return;
    triangles.flip(h);
    m_face_input[f] = m_patch.inputs()[0];
    m_face_input[g] = m_patch.inputs()[1];
    ++figures.flipped_edges;
  }

  // Of the angle at q; very large where there is none.
  static double cotangent(const Point_3& p, const Point_3& q, const Point_3& r)
  {
    const Vector_3 a = p - q, b = r - q;
    const double sine = std::sqrt(cross_product(a, b).squared_length()), cosine = a * b, large = 1e12;
    return std::abs(cosine) < large * sine ? cosine / sine : cosine < 0 ? -large : large;
  }

  bool is_next_to(int v, int w)
  {
    triangles.leaving(v, m_leaving);
    const std::vector<int>& next = neighbors();
    return std::find(next.begin(), next.end(), w) != next.end();
  }

  // Moves vertices that are on no curve to the middle of their faces, along the input, where that makes the worst face
  // better.
  bool move()
  {
    for(int v = 0; v < triangles.number_of_vertices(); ++v)
    {
      if(!is_reported(v))
        return false;
      if(triangles.out[v] == -1)
        continue;
      triangles.leaving(v, m_leaving);
      double worst = 1;
      bool is_inside = true;
      for(int h : m_leaving)
      {
        worst = (std::min)(worst, Triangle_patch::quality(triangle(h / 3)));
        is_inside = is_inside && !triangles.is_on_curve(h) && triangles.opposite[triangles.prev(h)] != -1;
      }
      if(!is_inside || worst > good_quality)
        continue;
      const Reference_surface::Location place = m_input.walk(middle_of_faces(), input_face[v]);
      if(!replace(v, place.point, -1) || !(m_patch.new_quality() > m_patch.old_quality()))
        continue;
      triangles.points[v] = place.point;
      input_face[v] = place.face;
      take_inputs();
      ++figures.moved_vertices;
    }
    return true;
  }

  // The centroid of the faces in m_leaving.
  Point_3 middle_of_faces() const
  {
    Vector_3 sum(0, 0, 0);
    double total = 0;
    for(int h : m_leaving)
    {
      const Triangle_patch::Triangle t = triangle(h / 3);
      const double area = std::sqrt(triangles.area_vector(h / 3).squared_length());
      sum = sum + area * (centroid(t[0], t[1], t[2]) - ORIGIN);
      total += area;
    }
    return total > 0 ? ORIGIN + sum / total : triangles.points[triangles.source(m_leaving.front())];
  }

  Reference_surface& m_input;
  const double m_shortest, m_longest, m_largest_curve_error;
  std::vector<double> m_relative_length; // per face of the input: in target edge lengths; empty: one everywhere
  double m_largest_relative_length = 1;
  Triangle_patch::Limits m_limits;
  Stage_progress m_progress;
  std::vector<Input_of_face> m_face_input; // per face
  std::vector<int> m_mark;                 // per vertex
  Triangle_patch m_patch;
  std::vector<std::pair<int, Input_of_face>> m_changed; // faces of an edit, and what they stand for after it
  std::vector<int> m_leaving, m_other_leaving, m_neighbors, m_curves;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_WORKING_MESH_INTERNAL_WORKING_MESH_BUILDER_H
