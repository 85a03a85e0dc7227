// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_STRUCTURE_INTERNAL_LAYOUT_SEARCH_H
#define CGAL_QUAD_MESHING_STRUCTURE_INTERNAL_LAYOUT_SEARCH_H

#include <CGAL/Quad_meshing/Structure/internal/Base_complex_arrays.h>
#include <CGAL/Quad_meshing/Structure/internal/Dual_lines.h>
#include <CGAL/Quad_meshing/Structure/internal/Helix_detection.h>
#include <CGAL/Quad_meshing/Structure/internal/Indexed_quad_mesh.h>
#include <CGAL/Quad_meshing/Structure/internal/Layout_curves.h>
#include <CGAL/Quad_meshing/Structure/internal/Layout_quantization.h>
#include <CGAL/Quad_meshing/Structure/internal/Layout_realization.h>

#include <CGAL/Random.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// What is to be small in a layout.
struct Layout_figures
{
  int patches = 0;
  double helices = 0;           // when the curves are multiplied such that edges have the length of those of the input
  double distortion = 0;
  int quads = 0;                // when the curves are multiplied such that edges are no shorter than those of the input

  Layout_figures(const Indexed_quad_mesh& input, const Layout_quantization& quantization, const std::vector<char>& is_fixed)
  {
    const Layout_realization r(input, quantization, quantization.length, is_fixed);
    const Layout_curves curves(quantization, quantization.length);
    patches = make_base_complex(r.mesh).number_of_patches;
    distortion = curves.distortion;
    std::vector<int> multiplicities;
    for(double l : curves.edge_length)
      multiplicities.push_back((std::max)(1, static_cast<int>(l)));
    quads = quantization.number_of_quads(curves.lengths(multiplicities));

    const Dual_lines lines(r.mesh);
    std::vector<double> multiplicity(lines.number_of_lines(), 1);
    for(std::size_t e = 0; e < curves.of_edge.size(); ++e)
      if(r.side_of_edge[e] != -1)
      {
        const int l = lines.line[r.side_of_edge[e]];
        multiplicity[l] = multiplicity[lines.reverse[l]] = curves.edge_length[curves.of_edge[e]];
      }
    for(const Helix_record& h : minimal_helices(r.mesh, lines, side_relations(r.mesh, lines)))
      helices += multiplicity[h.line];
  }
};

// Looks for a coarse layout with few patches and few helices.
//
// First all arcs are shortened, at a slowly growing scale. What comes out depends on chance: one unit more
// or less on one path can join all dual curves to a single one or separate them. So the paths are changed at random
// next, and what makes the structure better stays, and at first also some of what makes it worse (simulated
// annealing). The real base complex and the real helices of each layout are counted; it has few quads, however
// many the mesh has.
class Layout_search
{
public:
  // Number of quads for each irregular vertex at which the shortening ends, where these stay apart and where they
  // may become one, and largest part of the quads of the input.
  static constexpr int quads_per_irregular_vertex = 20, quads_when_merging = 3;
  static constexpr double largest_part = 0.25;
  // Factor between two scales, and the largest one.
  static constexpr double scale_step = 1.05, largest_scale = 100;
  // A worse layout is taken with probability exp(-difference / temperature), the temperature falling from this to 0.
  static constexpr double first_temperature = 0.03;
  // Weights against the number of patches: of the number of helices, both as parts of what there is at first, of the
  // distortion, and of the part of the quads of the input that is missing when the curves are multiplied.
  static constexpr double helix_weight = 2, distortion_weight = 1, missing_weight = 0.5;
  // Largest cost of an edge of the input on a path that is changed; it is varied to find different paths.
  static constexpr double largest_edge_cost = 0.2;

  Layout_search(const Indexed_quad_mesh& mesh, Layout_quantization& quantization, const std::vector<char>& is_fixed)
    : m(mesh), m_quantization(quantization), m_is_fixed(is_fixed)
  {}

  Layout_figures figures() const { return Layout_figures(m, m_quantization, m_is_fixed); }

  // Shortens the arcs until there are at most so many patches, or with `patches` 0 so many quads. Calls
  // `record()` after each scale.
  template <typename Record, typename GoFurther>
  void shorten(int quads, std::size_t patches, const Record& record, const GoFurther& go_further)
  {
    auto is_coarse = [&]
    {
      return patches > 0 ? std::size_t(figures().patches) <= patches
                         : m_quantization.number_of_quads(m_quantization.length) <= quads;
    };
    while(m_scale < largest_scale && !is_coarse() && go_further())
    {
      m_scale *= scale_step;
      m_quantization.shorten(m_scale);
      record();
    }
  }

  // Tries so many layouts.
  template <typename GoFurther>
  void anneal(int attempts, std::size_t target_patches, const GoFurther& go_further)
  {
    std::vector<int>& length = m_quantization.length;
    const Layout_figures first = figures();
    if(length.empty() || first.patches == 0)
      return;
    const int most_quads = 2 * m_quantization.number_of_quads(length);
    auto cost = [&]
    {
      if(m_quantization.number_of_quads(length) > most_quads)
        return (std::numeric_limits<double>::max)();
      const Layout_figures f = figures();
      if(target_patches > 0 && std::size_t(f.patches) > (std::max)(target_patches, std::size_t(first.patches)))
        return (std::numeric_limits<double>::max)();
      const double missing = (std::max)(0., 1 - double(f.quads) / m.number_of_faces());
      return helix_weight * f.helices / (std::max)(1., first.helices) + double(f.patches) / first.patches
           + distortion_weight * f.distortion + missing_weight * missing;
    };
    Random random(0);
    double now = cost(), best = now;
    std::vector<int> best_length = length, before;
    for(int i = 0; i < attempts && go_further(); ++i)
    {
      before = length;
      const int paths = random.get_double() < 0.6 ? 1 : 2;
      bool changed = true;
      for(int k = 0; k < paths && changed; ++k)
      {
        const double r = random.get_double();
        const int arc = random.get_int(0, static_cast<int>(length.size()));
        changed = m_quantization.change(arc, random.get_bool() ? 1 : -1, m_scale, largest_edge_cost * r * r, false);
      }
      const double c = changed ? cost() : (std::numeric_limits<double>::max)();
      const double temperature = first_temperature * (1 - double(i) / attempts);
      if(c < now || random.get_double() < std::exp((now - c) / temperature))
        now = c;
      else
        length = before;
      if(now < best)
      {
        best = now;
        best_length = length;
      }
    }
    length = best_length;
  }

private:
  const Indexed_quad_mesh& m;
  Layout_quantization& m_quantization;
  const std::vector<char>& m_is_fixed;
  double m_scale = 1;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_STRUCTURE_INTERNAL_LAYOUT_SEARCH_H
