// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PIPELINE_INTERNAL_SIZE_PLAN_H
#define CGAL_QUAD_MESHING_PIPELINE_INTERNAL_SIZE_PLAN_H

#include <CGAL/Quad_meshing/Fields/Length_field.h>
#include <CGAL/Quad_meshing/Guides/Polyline_tracer.h>
#include <CGAL/Quad_meshing/Parameterization/prepare_mesh.h>
#include <CGAL/Quad_meshing/Pipeline/Quadrangulation_options.h>
#include <CGAL/Quad_meshing/Pipeline/Quadrangulation_stages.h>
#include <CGAL/Quad_meshing/Pipeline/internal/Placed_guides.h>
#include <CGAL/Quad_meshing/Pipeline/internal/Triangle_input.h>
#include <CGAL/Quad_meshing/Pipeline/internal/locate_on_input.h>
#include <CGAL/Quad_meshing/internal/Indexed_triangle_mesh.h>

#include <CGAL/Kernel/global_functions_3.h>
#include <CGAL/Polygon_mesh_processing/measure.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The lengths of quad edges on all components, where they are not the same everywhere.
class Size_plan
{
  typedef Quadrangulation_mesh Mesh;
  typedef Quadrangulation_kernel::Point_3 Point_3;

public:
  static bool is_needed(const Triangle_input& input, const Quadrangulation_options& o)
  {
    return o.sizing_method != Sizing_method::CONSTANT || !o.size_discs.empty() || !input.face_lengths.empty() ||
           !input.vertex_lengths.empty();
  }

  // `input` is the one that the user gave; `original` turns the origins of the surfaces into numbers of its triangles.
  // Edges of the surfaces that are much longer than quads are split, so that lengths can change.
  Size_plan(std::vector<std::unique_ptr<Quadrangulation_surface>>& surfaces, const Triangle_input& input,
            const std::function<std::size_t(std::size_t)>& original, const Quadrangulation_options& options,
            double constant_length)
    : m_surfaces(surfaces), m_input(input), m_original(original), m_options(options), m_constant(constant_length)
  {
  }

  // Whether the lengths are what they are, and the number of quads follows from them.
  bool is_absolute() const
  {
    return m_options.sizing_method == Sizing_method::CURVATURE && m_options.sizing_tolerance > 0;
  }

  // Writes the lengths to the surfaces. `requested_quads` is 0 where an edge length was asked for: then given lengths
  // are kept, and others average to it. Returns false if the visitor stops it.
  bool run(double requested_quads, double area, Any_visitor& visitor)
  {
    split();
    std::vector<std::vector<double>> wishes;
    for(std::size_t c = 0; c < m_surfaces.size(); ++c)
      wishes.push_back(wishes_of(c));
    if(!m_options.size_discs.empty())
    {
      const Guide_placer placer(m_surfaces, m_input);
      for(const Size_disc& disc : m_options.size_discs)
        add_disc(disc, placer, wishes);
    }
    bool is_open = false;
    for(std::size_t c = 0; c < m_surfaces.size(); ++c)
    {
      for(double w : wishes[c])
        is_open = is_open || !(w > 0);
      Length_field::Options o;
      o.method = m_options.sizing_method;
      o.constant = m_constant;
      o.tolerance = m_options.sizing_tolerance;
      o.smallest = m_options.smallest_edge_length;
      o.largest = m_options.largest_edge_length;
      o.gradation = m_options.sizing_gradation;
      const Indexed_triangle_mesh mesh = make_indexed_triangle_mesh(m_surfaces[c]->mesh, parameters::default_values());
      std::vector<char> is_feature(mesh.number_of_edges(), 0);
      for_each_edge_of_faces(m_surfaces[c]->mesh,
                             [&](Mesh::Edge_index e, int i) { is_feature[i] = m_surfaces[c]->is_feature[e]; });
      m_fields.emplace_back(mesh, wishes[c], o);
      if(!m_fields.back().measure(is_feature, visitor))
        return false;
    }
    const bool adapts = m_options.sizing_method != Sizing_method::CONSTANT;
    double of_wishes = 1, of_others = 1;
    if(!is_absolute() && (requested_quads > 0 || (adapts && is_open)))
    {
      const double quads = requested_quads > 0 ? requested_quads : area / (m_constant * m_constant);
      auto scaled_others = [&](double s) { return number_of_quads(1, s); };
      auto scaled_all = [&](double s) { return number_of_quads(s, s); };
      if(is_open && solve(scaled_others, quads, of_others))
        of_wishes = 1;
      else if(requested_quads > 0 && solve(scaled_all, quads, of_wishes))
        of_others = of_wishes;
    }
    for(std::size_t c = 0; c < m_surfaces.size(); ++c)
    {
      const std::vector<double> lengths = m_fields[c].lengths(of_wishes, of_others);
      for(Mesh::Face_index f : m_surfaces[c]->mesh.faces())
        m_surfaces[c]->length[f] = lengths[f];
      quads.push_back(m_fields[c].number_of_quads(lengths));
    }
    m_fields.clear();
    return true;
  }

  std::vector<double> quads; // per component: that its lengths stand for

private:
  // Edges longer than this are split, in the shorter of the constant length and the radii of discs; and no more than so
  // many for the surface.
  static constexpr double longest_edge = 1;
  static constexpr double most_triangles = 2e6;

  void split()
  {
    double length = m_constant;
    for(const Size_disc& d : m_options.size_discs)
      length = (std::min)(length, d.radius / 2);
    double area = 0;
    for(const auto& s : m_surfaces)
      area += Polygon_mesh_processing::area(s->mesh);
    length = (std::max)(length, std::sqrt(area / most_triangles));
    for(const auto& s : m_surfaces)
      split_for_alignment(s->mesh, s->mesh.points(), Edge_marks{ s.get() }, false, s->origin, longest_edge * length);
  }

  // Both marks of edges as one map: before features are detected, there are only those of the user.
  struct Edge_marks
  {
    typedef Mesh::Edge_index key_type;
    typedef bool value_type;
    typedef bool reference;
    typedef boost::read_write_property_map_tag category;

    Quadrangulation_surface* surface;

    friend bool get(const Edge_marks& m, Mesh::Edge_index e) { return m.surface->is_feature[e]; }
    friend void put(const Edge_marks& m, Mesh::Edge_index e, bool is_feature)
    {
      m.surface->is_feature[e] = m.surface->is_kept[e] = is_feature;
    }
  };

  Point_3 center(std::size_t c, Mesh::Face_index f) const
  {
    const Mesh& m = m_surfaces[c]->mesh;
    const Mesh::Halfedge_index h = m.halfedge(f);
    return centroid(m.point(m.source(h)), m.point(m.target(h)), m.point(m.target(m.next(h))));
  }

  std::vector<double> wishes_of(std::size_t c) const
  {
    const Quadrangulation_surface& s = *m_surfaces[c];
    std::vector<double> wish(s.mesh.number_of_faces(), 0.);
    for(Mesh::Face_index f : s.mesh.faces())
    {
      const std::size_t i = m_original(s.origin[f]);
      if(!m_input.face_lengths.empty())
        wish[f] = (std::max)(0., m_input.face_lengths[i]);
      if(m_input.vertex_lengths.empty())
        continue;
      const std::array<int, 3>& t = m_input.triangles[i];
      const std::array<double, 3> w =
        triangle_weights(center(c, f), { { m_input.points[t[0]], m_input.points[t[1]], m_input.points[t[2]] } });
      double sum = 0;
      bool is_wished = true;
      for(int k = 0; k < 3; ++k)
      {
        is_wished = is_wished && m_input.vertex_lengths[t[k]] > 0;
        sum += w[k] * m_input.vertex_lengths[t[k]];
      }
      if(is_wished)
        wish[f] = wish[f] > 0 ? (std::min)(wish[f], sum) : sum;
    }
    return wish;
  }

  // The faces that hang together with the one nearest to the center, inside of the ball.
  void add_disc(const Size_disc& disc, const Guide_placer& placer, std::vector<std::vector<double>>& wishes) const
  {
    const auto [c, first] = placer.locate(disc.center);
    const Mesh& m = m_surfaces[c]->mesh;
    std::vector<Mesh::Face_index> queue(1, first);
    std::vector<char> is_reached(m.number_of_faces(), 0);
    is_reached[first] = 1;
    for(std::size_t i = 0; i < queue.size(); ++i)
    {
      double& w = wishes[c][queue[i]];
      w = w > 0 ? (std::min)(w, disc.length) : disc.length;
      for(Mesh::Face_index g : m.faces_around_face(m.halfedge(queue[i])))
        if(g != Mesh::null_face() && !is_reached[g] &&
           squared_distance(center(c, g), disc.center) <= disc.radius * disc.radius)
        {
          is_reached[g] = 1;
          queue.push_back(g);
        }
    }
  }

  double number_of_quads(double of_wishes, double of_others) const
  {
    double sum = 0;
    for(const Length_field& f : m_fields)
      sum += f.number_of_quads(f.lengths(of_wishes, of_others));
    return sum;
  }

  // Finds the factor for a number of quads, which falls with it. Returns false if there is none: bounds of the lengths
  // keep the number away from it.
  static bool solve(const std::function<double(double)>& quads_of, double quads, double& factor)
  {
    const double accuracy = 0.005; // of the number
    const int most_steps = 40;
    double low = 1e-4, high = 1e4;
    double s = 1;
    for(int step = 0; step < most_steps; ++step)
    {
      const double q = quads_of(s);
      factor = s;
      if(std::abs(q - quads) <= accuracy * quads)
        return true;
      (q > quads ? low : high) = s;
      const double guess = s * std::sqrt(q / quads); // right where no bound holds lengths
      s = step % 2 == 0 && guess > low && guess < high ? guess : std::sqrt(low * high);
    }
    return false;
  }

  std::vector<std::unique_ptr<Quadrangulation_surface>>& m_surfaces;
  const Triangle_input& m_input;
  const std::function<std::size_t(std::size_t)> m_original;
  const Quadrangulation_options& m_options;
  const double m_constant;
  std::vector<Length_field> m_fields; // per component
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_PIPELINE_INTERNAL_SIZE_PLAN_H
