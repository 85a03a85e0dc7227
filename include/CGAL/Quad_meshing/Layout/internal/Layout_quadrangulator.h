// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_LAYOUT_INTERNAL_LAYOUT_QUADRANGULATOR_H
#define CGAL_QUAD_MESHING_LAYOUT_INTERNAL_LAYOUT_QUADRANGULATOR_H

#include <CGAL/Quad_meshing/Layout/Layout_quadrangulation_result.h>
#include <CGAL/Quad_meshing/Layout/internal/Arc_quantization.h>
#include <CGAL/Quad_meshing/Layout/internal/Chart_sampling.h>
#include <CGAL/Quad_meshing/Layout/internal/Domain_optimization.h>
#include <CGAL/Quad_meshing/Layout/internal/Embedded_layout.h>
#include <CGAL/Quad_meshing/Layout/internal/Layout_charts.h>
#include <CGAL/Quad_meshing/Layout/internal/Layout_embedding.h>
#include <CGAL/Quad_meshing/Layout/internal/Layout_parameterization.h>
#include <CGAL/Quad_meshing/Layout/internal/Patch_untangling.h>
#include <CGAL/Quad_meshing/Layout/internal/Quad_straightening.h>
#include <CGAL/Quad_meshing/Layout/internal/quadrangulate_indexed_layout.h>
#include <CGAL/Quad_meshing/internal/Any_visitor.h>
#include <CGAL/Quad_meshing/internal/Indexed_reference.h>
#include <CGAL/Quad_meshing/internal/Watched_visitor.h>

#include <CGAL/Kernel/global_functions_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The stages of layout-guided quad meshing (thesis, chapter 7), one after the other.
class Layout_quadrangulator
{
public:
  // An arc, or the border of a patch, lies on features if this part of its length does.
  static constexpr double feature_part_of_arc = 0.9, feature_part_of_patch = 0.5;
  // How often more arcs are aligned because of folds: the last time all of them are.
  static constexpr int most_rounds_of_alignment = 3;

  Layout_quadrangulation_result result;
  Layout_quads quads;

  Layout_quadrangulator(const Indexed_triangle_mesh& input, const std::vector<char>& is_feature,
                        const Surface_layout& layout, const Layout_options& options, Any_visitor& visitor)
    : m_input(input), m_is_feature(is_feature), m_options(options), m_visitor(visitor), m_e(input, is_feature, layout)
  {
  }

  void run()
  {
    typedef Layout_quadrangulation_status Status;
    const double area = surface_area();
    if(!check_input(area))
      return;
    const double length =
      m_options.edge_length > 0 ? m_options.edge_length : std::sqrt(area / m_options.number_of_quads);
    {
      Visited_stage stage(m_visitor, "layout");
      Layout_embedding embedding(m_e);
      const std::string error = embedding.run(m_input, m_visitor);
      if(!error.empty())
        return end(Status::BAD_LAYOUT, error);
      if(is_stopped())
        return;
      // triangles much larger than quads bend the map too little
      embedding.refine(length);
      const std::string lost = find_regions(m_e);
      CGAL_assertion(lost.empty());
      if(!lost.empty())
        return end(Status::FAILED, lost);
    }
    describe_layout();
    find_arcs_on_features();

    Layout_charts charts(m_e);
    Layout_parameterization map(m_e, m_options.mean_value_weights);
    const Layout_parameterization::Alignment alignment = m_options.least_squares_alignment
                                                           ? Layout_parameterization::Alignment::LEAST_SQUARES
                                                           : Layout_parameterization::Alignment::TANGENTIAL;
    {
      Visited_stage stage(m_visitor, "charts");
      const std::vector<Layout_chart> kinds = chart_kinds(charts);
      Domain_optimization::start(m_e, kinds, charts);
      Domain_optimization optimization(m_e, map);
      const bool is_solved = optimization.run(charts, kinds, m_options.iterations, alignment, m_visitor);
      result.energies = optimization.energies;
      if(!is_solved)
        return end(Status::FAILED, "The linear system of the parameterization cannot be solved.");
      if(is_stopped())
        return;
    }

    Visited_stage stage(m_visitor, "quads");
    Arc_quantization numbers(m_e.layout);
    if(!choose_numbers(charts, length, numbers))
      return end(Status::FAILED, numbers.error);
    for(int n : numbers.number)
      result.segments.push_back(static_cast<std::size_t>(n));
    std::vector<char> is_aligned = wanted_alignment();
    const std::vector<char> wanted = is_aligned;
    std::vector<int> arc_of_edge; // per halfedge of the quads
    for(;;)
    {
      if(!unfold(charts, alignment, is_aligned, map))
        return end(Status::FAILED, "The linear system of the parameterization cannot be solved.");
      if(is_stopped())
        return;
      Chart_sampling sampling(m_e, charts, map, is_aligned, numbers);
      // what a map covers whose arcs are all aligned is known
      if(align(sampling.failed_patches, is_aligned))
        continue;
      if(!sampling.failed_patches.empty())
        return end(Status::FAILED, "In patch " + std::to_string(sampling.failed_patches.front()) +
                                     ", the map does not cover the chart.");
      quads.mesh = std::move(sampling.quads);
      quads.patch = std::move(sampling.patch_of_quad);
      arc_of_edge = std::move(sampling.arc_of_edge);
      break;
    }
    for(int a = 0; a < m_e.number_of_arcs(); ++a)
    {
      result.aligned_arcs += wanted[a];
      result.forced_arcs += is_aligned[a] && !wanted[a];
    }
    if(!quads.mesh.connect() || !is_manifold(quads.mesh))
      return end(Status::FAILED,
                 "The quads are so few that two of them would share more than one side: smaller ones are needed.");
    straighten(wanted, arc_of_edge);
    if(is_stopped())
      return;
    result.quads = static_cast<std::size_t>(quads.mesh.number_of_faces());
    result.vertices = static_cast<std::size_t>(quads.mesh.number_of_vertices());
    end(Status::VALID, final_message());
  }

private:
  void end(Layout_quadrangulation_status status, const std::string& message)
  {
    result.status = status;
    result.message = message;
  }

  bool is_stopped()
  {
    if(m_visitor.go_further())
      return false;
    end(Layout_quadrangulation_status::STOPPED, "The visitor asked for an end.");
    return true;
  }

  double surface_area() const
  {
    double sum = 0;
    for(int f = 0; f < m_input.number_of_faces(); ++f)
      sum += 0.5 * std::sqrt(cross_product(m_input.vector(3 * f), m_input.vector(3 * f + 1)).squared_length());
    return sum;
  }

  bool check_input(double area)
  {
    typedef Layout_quadrangulation_status Status;
    if(m_input.non_manifold_vertex != -1)
      end(Status::BAD_MESH, non_manifold_message(m_input));
    else if(!std::all_of(m_input.points.begin(), m_input.points.end(),
                         [](const Indexed_triangle_mesh::Point_3& p) { return is_finite(p); }))
      end(Status::BAD_MESH, "A vertex has a coordinate that is not a finite number.");
    else if(!(area > 0) || std::isinf(area))
      end(Status::BAD_MESH, "The mesh has no faces, or no area.");
    else if(!(m_options.edge_length >= 0) || std::isinf(m_options.edge_length) || !(m_options.number_of_quads > 0) ||
            std::isinf(m_options.number_of_quads))
      end(Status::FAILED, "The target edge length and the target number of quads have to be positive numbers.");
    else
      return true;
    return false;
  }

  void describe_layout()
  {
    result.nodes = m_e.layout.nodes.size();
    result.arcs = m_e.layout.arcs.size();
    result.patches = m_e.layout.patches.size();
    for(const Surface_layout::Patch& p : m_e.layout.patches)
      for(const std::vector<Surface_layout::Side_arc>& side : p.sides)
        result.t_vertices += side.size() - 1;
  }

  void find_arcs_on_features()
  {
    for(int h = 0; h < m_input.number_of_halfedges(); ++h)
      if(m_is_feature[h] && h < m_input.opposite[h])
        result.feature_length += std::sqrt(m_input.vector(h).squared_length());
    m_feature_part.assign(m_e.number_of_arcs(), 0);
    for(int a = 0; a < m_e.number_of_arcs(); ++a)
    {
      double sum = 0, on_features = 0;
      for(int h : m_e.border[m_e.border[2 * a].empty() ? 2 * a + 1 : 2 * a])
      {
        const double l = m_e.edge_length(h);
        sum += l;
        on_features += m_e.surface.is_feature[h] ? l : 0;
      }
      m_feature_part[a] = sum > 0 ? on_features / sum : 0;
      result.feature_length_on_arcs += on_features;
    }
  }

  std::vector<Layout_chart> chart_kinds(const Layout_charts& charts)
  {
    std::vector<Layout_chart> kinds;
    for(const Surface_layout::Patch& p : m_e.layout.patches)
    {
      Layout_chart kind = m_options.chart != Layout_chart::AUTOMATIC ? m_options.chart : p.chart;
      if(kind == Layout_chart::AUTOMATIC)
      {
        double sum = 0, on_features = 0;
        for(const std::vector<Surface_layout::Side_arc>& side : p.sides)
          for(const Surface_layout::Side_arc& s : side)
          {
            const double l = charts.arc_length(static_cast<int>(s.arc));
            sum += l;
            on_features += m_e.topology.is_border(static_cast<int>(s.arc)) ? l : l * m_feature_part[s.arc];
          }
        kind = on_features >= feature_part_of_patch * sum ? Layout_chart::QUADRILATERAL : Layout_chart::RECTANGLE;
      }
      kinds.push_back(kind);
      result.quadrilateral_charts += kind == Layout_chart::QUADRILATERAL;
    }
    return kinds;
  }

  bool choose_numbers(const Layout_charts& charts, double length, Arc_quantization& numbers)
  {
    std::vector<double> wanted;
    for(int a = 0; a < m_e.number_of_arcs(); ++a)
    {
      const double own = m_e.layout.arcs[a].edge_length;
      wanted.push_back(charts.arc_length(a) / (own > 0 ? own : length));
    }
    return m_options.edge_length > 0 ? numbers.solve(wanted, m_options.rounding)
                                     : numbers.solve_for_quads(wanted, m_options.number_of_quads, m_options.rounding);
  }

  std::vector<char> wanted_alignment() const
  {
    std::vector<char> is_aligned(m_e.number_of_arcs());
    for(int a = 0; a < m_e.number_of_arcs(); ++a)
      is_aligned[a] = m_e.topology.is_border(a) || m_options.alignment == Arc_alignment::ALL ||
                      m_e.layout.arcs[a].is_aligned ||
                      (m_options.alignment == Arc_alignment::FEATURES && m_feature_part[a] >= feature_part_of_arc);
    return is_aligned;
  }

  // Aligns the arcs of some patches, and in the end all arcs, as each round takes a parameterization. Returns whether
  // there were some that had not been.
  bool align(const std::vector<int>& patches, std::vector<char>& is_aligned)
  {
    bool is_changed = false;
    for(int p : patches)
      for(int d : directions_around(m_e.layout.patches[p]))
      {
        is_changed = is_changed || !is_aligned[d / 2];
        is_aligned[d / 2] = 1;
      }
    if(is_changed && ++m_rounds_of_alignment == most_rounds_of_alignment)
      is_aligned.assign(is_aligned.size(), 1);
    return is_changed;
  }

  // Computes the final map. Where it is folded, more arcs are aligned, and then the folded patches computed by
  // themselves, until nothing is folded any more.
  bool unfold(const Layout_charts& charts, Layout_parameterization::Alignment alignment, std::vector<char>& is_aligned,
              Layout_parameterization& map)
  {
    Patch_untangling untangling(m_e, map);
    for(;;)
    {
      if(!map.solve(charts, is_aligned, alignment))
        return false;
      if(!m_visitor.go_further())
        return true;
      std::vector<int> folded = untangling.folded_patches();
      if(align(folded, is_aligned))
        continue;
      // an arc in disorder folds both patches at it
      for(int p : folded)
        for(int d : directions_around(m_e.layout.patches[p]))
          untangling.order_arc(d / 2, charts);
      folded = untangling.folded_patches();
      result.untangled_patches = folded.size();
      result.folded_patches = 0;
      for(int p : folded)
        result.folded_patches += !untangling.untangle(p);
      return true;
    }
  }

  // Straightens inverted quads, and marks the edges of the quads on aligned arcs. Nodes and arcs that were to be
  // aligned stay as they are; only along features and the border vertices may slide.
  void straighten(const std::vector<char>& is_aligned, const std::vector<int>& arc_of_edge)
  {
    Indexed_quad_mesh& m = quads.mesh;
    std::vector<char> may_not_move(m.number_of_vertices(), 0);
    for(int h = 0; h < m.number_of_halfedges(); ++h)
    {
      const int a = arc_of_edge[h];
      const bool lies_on_curve = a != -1 && (m_e.topology.is_border(a) || m_feature_part[a] >= feature_part_of_arc);
      m.is_feature[h] = lies_on_curve;
      if(a != -1 && is_aligned[a] && !lies_on_curve)
        may_not_move[m.source(h)] = may_not_move[m.target(h)] = 1;
    }
    std::fill_n(may_not_move.begin(), m_e.vertex_of_node.size(), 1); // the first ones
    Indexed_reference reference{ m_input, {}, {}, {}, {} };
    for(int h = 0; h < m_input.number_of_halfedges(); ++h)
      if(m_input.opposite[h] == -1)
        reference.borders.push_back({ { m_input.source(h), m_input.target(h) } });
      else if(m_is_feature[h] && h < m_input.opposite[h])
        reference.features.push_back({ { m_input.source(h), m_input.target(h) } });
    Silent_visitor silent(m_visitor);
    result.inverted_quads = Quad_straightening(m, may_not_move, reference).run(silent);
    for(int h = 0; h < m.number_of_halfedges(); ++h)
      m.is_feature[h] = arc_of_edge[h] != -1 && is_aligned[arc_of_edge[h]];
  }

  static bool is_manifold(const Indexed_quad_mesh& m)
  {
    std::vector<int> corners(m.number_of_vertices(), 0);
    for(int h = 0; h < m.number_of_halfedges(); ++h)
      ++corners[m.source(h)];
    for(int v = 0; v < m.number_of_vertices(); ++v)
    {
      int h = m.halfedge_of_vertex[v];
      if(h == -1)
        return false;
      do
      {
        --corners[v];
        h = m.next_around_source(h);
      }
      while(h != -1 && h != m.halfedge_of_vertex[v]);
      if(corners[v] != 0)
        return false;
    }
    return true;
  }

  std::string final_message() const
  {
    auto count = [](std::size_t n, const std::string& one, const std::string& many)
    { return std::to_string(n) + " " + (n == 1 ? one : many); };
    std::string text =
      count(result.quads, "quad", "quads") + " in " + count(result.patches, "patch", "patches") + " of the layout.";
    if(result.forced_arcs > 0)
      text += " " + count(result.forced_arcs, "arc was", "arcs were") + " aligned, as the map was folded otherwise.";
    if(result.untangled_patches > 0)
      text += " " + count(result.untangled_patches, "patch was", "patches were") + " folded and mapped by itself.";
    if(result.inverted_quads > 0)
      text += " " + count(result.inverted_quads, "quad is", "quads are") + " inverted.";
    if(result.folded_patches > 0)
      text +=
        " " + count(result.folded_patches, "patch remains", "patches remain") + " folded, by triangles without area.";
    return text;
  }

  const Indexed_triangle_mesh& m_input;
  const std::vector<char>& m_is_feature; // per halfedge of the input
  const Layout_options m_options;
  Any_visitor& m_visitor;
  Embedded_layout m_e;
  std::vector<double> m_feature_part; // per arc: the part of its length on constrained edges
  int m_rounds_of_alignment = 0;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_LAYOUT_INTERNAL_LAYOUT_QUADRANGULATOR_H
