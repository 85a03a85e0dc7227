// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_STRUCTURE_INTERNAL_LAYOUT_OPTIMIZER_H
#define CGAL_QUAD_MESHING_STRUCTURE_INTERNAL_LAYOUT_OPTIMIZER_H

#include <CGAL/Quad_meshing/Layout/Feature_bends.h>
#include <CGAL/Quad_meshing/Layout/Layout_curves.h>
#include <CGAL/Quad_meshing/Layout/Layout_quantization.h>
#include <CGAL/Quad_meshing/Layout/Layout_realization.h>
#include <CGAL/Quad_meshing/Layout/Motorcycle_complex.h>
#include <CGAL/Quad_meshing/Quad_mesh/quad_mesh_structure.h>
#include <CGAL/Quad_meshing/Structure/internal/Gp_execution.h>
#include <CGAL/Quad_meshing/Structure/internal/Layout_goals.h>
#include <CGAL/Quad_meshing/Structure/internal/Layout_helices.h>
#include <CGAL/Quad_meshing/Structure/internal/Layout_search.h>
#include <CGAL/Quad_meshing/Structure/internal/Structure_state.h>
#include <CGAL/Quad_meshing/internal/Any_visitor.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Gives a quad mesh a coarse layout: searches one, multiplies its dual curves, and realizes it as a mesh.
class Layout_optimizer
{
public:
  // The lengths of the edges, in edges of the input, between which one is chosen, and the factor between two trials.
  static constexpr double least_edge_length = 0.5, largest_edge_length = 1000, finer = 0.95;
  // How often the multiplicities of all curves are changed at most.
  static constexpr int largest_number_of_changes = 10;

  // How often curves with helices are limited.
  static constexpr int most_limitations = 4;

  // One of so many scales gives a layout that the mesh gets if the coarser ones do not fit its shape.
  static constexpr int scales_between = 4;

  // `target_quads` is at most the number of quads of the input.
  Layout_optimizer(const Structure_state& input, bool merge_singularities, std::size_t target_quads,
                   std::size_t target_patches, bool is_layout_wanted)
    : m_input(input)
    , m_merge_singularities(merge_singularities)
    , m_target_quads(static_cast<int>(target_quads))
    , m_target_patches(target_patches)
    , m_structure(structure_of_quad_mesh(input.mesh))
    , m_goals(m_structure, quality_of_quad_mesh(input.mesh), m_target_quads, is_layout_wanted)
    , m_complex(input.mesh, input.is_fixed)
    , m_bends(input.mesh, m_complex)
  {
    for(int h = 0; h < input.mesh.number_of_halfedges(); ++h)
      m_border_edges += input.mesh.is_border(h);
  }

  const Layout_goals& goals() const { return m_goals; }

  // Looks for layouts, `attempts` times at random.
  void search(int attempts, Any_visitor& visitor)
  {
    if(!m_complex.is_valid || m_complex.arcs.empty() || m_structure.number_of_irregular_vertices == 0)
      return;
    m_quantization.reset(new Layout_quantization(m_input.mesh, m_complex, m_input.is_fixed, m_merge_singularities));
    m_search.reset(
      new Layout_search(m_input.mesh, m_structure, m_goals, *m_quantization, m_bends, m_input.is_fixed, visitor));
    if(!visitor.go_further())
    {
      m_search.reset(); // its system is not complete
      return;
    }
    // what is compared in the end: not more quads for more helices
    m_goals.neglect_loss();
    const double quads_per_irregular_vertex =
      m_merge_singularities ? Layout_search::quads_when_merging : Layout_search::quads_per_irregular_vertex;
    const int quads = static_cast<int>((std::min)(quads_per_irregular_vertex * m_structure.number_of_irregular_vertices,
                                                  Layout_search::largest_part * m_structure.number_of_quads));
    int scales = 0;
    m_search->shorten(
      quads, m_target_patches,
      [&]
      {
        if(++scales % scales_between == 0)
          m_layouts.push_back(m_quantization->length);
      },
      [&] { return visitor.go_further(); });
    m_layouts.push_back(m_quantization->length);
    m_search->anneal(attempts, m_target_patches, m_layouts, reporting(attempts, visitor));
  }

  // Looks for others, with less distortion if the shape of these was not accepted; false if this has been done too
  // often.
  bool search_again(int attempts, bool with_caution, Any_visitor& visitor)
  {
    return m_search && m_search->anneal_again(attempts, with_caution, m_layouts, reporting(attempts, visitor));
  }

  // Puts the mesh with the next layout into `result`: the best one first, then those that were the best for a while,
  // then coarser ones before finer ones; false if there is none that is better than the input.
  bool next(Structure_state& result, Any_visitor& visitor)
  {
    while(!m_layouts.empty() && visitor.go_further())
    {
      const std::vector<int> layout = m_layouts.back();
      m_layouts.pop_back();
      if(realize(*m_quantization, layout, result, visitor))
        return true;
    }
    return false;
  }

private:
  // A question whether to go further that counts the attempts.
  std::function<bool()> reporting(int attempts, Any_visitor& visitor)
  {
    return [this, attempts, &visitor]
    {
      visitor.progress((std::min)(1., double(++m_attempts) / m_search->number_of_rounds() / attempts));
      return visitor.go_further();
    };
  }

  bool realize(const Layout_quantization& quantization, const std::vector<int>& layout, Structure_state& result,
               Any_visitor& visitor) const
  {
    Layout_curves curves(quantization, layout);
    curves.follow(m_bends);
    const Layout_realization itself(m_input.mesh, quantization, layout, m_input.is_fixed, Layout_realization::TOPOLOGY);
    const Layout_helices helices(itself, curves);
    std::vector<int> multiplicity = improved(
      quantization, curves, helices, m_search->cost().density(curves, helices, m_target_quads).multiplicities, visitor);
    for(int i = 0; i < most_limitations && limit_helices(quantization, multiplicity, curves); ++i)
      multiplicity = improved(quantization, curves, helices, curves.multiplicities_within(m_target_quads), visitor);
    std::vector<int> length = curves.lengths(multiplicity);
    // a very coarse mesh may have edges that share both ends
    double aim = largest_edge_length;
    while(fits(quantization, length))
    {
      const Layout_realization r(m_input.mesh, quantization, length, m_input.is_fixed);
      if(r.is_closed_up && is_valid_quad_mesh(r.mesh))
      {
        if(!is_better(structure_of_quad_mesh(r.mesh)))
          return false;
        set_state(r, result);
        return true;
      }
      const int quads = quantization.number_of_quads(length);
      while(aim > least_edge_length && quantization.number_of_quads(length) <= quads)
      {
        aim *= finer;
        length = curves.lengths(aim);
      }
      if(aim <= least_edge_length)
        return false;
    }
    return false;
  }

  // Parallel curves may wind up with each other where one alone does not. If there are more helices than are tolerated
  // when each curve is replaced by so many, limits the curves that have them, in proportion, and returns true.
  bool limit_helices(const Layout_quantization& quantization, const std::vector<int>& multiplicity,
                     Layout_curves& curves) const
  {
    const std::vector<int> length = curves.lengths(multiplicity);
    const Layout_realization r(m_input.mesh, quantization, length, m_input.is_fixed, Layout_realization::TOPOLOGY);
    const std::vector<int> helices =
      Layout_helices(r, curves.curves_of_edges(multiplicity), curves.number_of_curves()).of_curves();
    const int all = std::accumulate(helices.begin(), helices.end(), 0),
              most = m_goals.tolerated_helices(static_cast<int>(m_structure.number_of_helices));
    if(all <= most)
      return false;
    std::vector<int> largest = curves.largest_multiplicities();
    for(std::size_t c = 0; c < helices.size(); ++c)
      if(helices[c] > 0)
        largest[c] = (std::min)(largest[c], (std::max)(1, multiplicity[c] * most / all));
    curves.limit_multiplicities(std::move(largest));
    return true;
  }

  // Changes the multiplicities one by one as long as the price falls, beginning with coarser ones if these do not fit.
  std::vector<int> improved(const Layout_quantization& quantization, const Layout_curves& curves,
                            const Layout_helices& helices, std::vector<int> multiplicity, Any_visitor& visitor) const
  {
    std::vector<int> length = curves.lengths(multiplicity);
    auto is_possible = [&]
    { return fits(quantization, length) && quantization.number_of_quads(length) <= m_target_quads; };
    auto price = [&]
    {
      return !is_possible()
               ? Layout_cost::forbidden
               : m_goals.price_of_growth(Layout_weights::squared_degrees * m_search->cost().distortion()(length)) +
                   m_goals.price_of_structure(helices.number_of_helices(multiplicity), 0,
                                              quantization.number_of_quads(length));
    };
    for(double aim = 1; !is_possible() && aim < largest_edge_length; aim /= finer)
    {
      multiplicity = curves.multiplicities(aim);
      length = curves.lengths(multiplicity);
    }
    double best = price();
    bool is_better = best < Layout_cost::forbidden;
    for(int round = 0; is_better && round < largest_number_of_changes; ++round)
    {
      is_better = false;
      for(int c = 0; c < curves.number_of_curves() && visitor.go_further(); ++c)
        for(int by : { 1, -1 })
        {
          if(!curves.allows(c, multiplicity[c] + by))
            continue;
          multiplicity[c] += by;
          length = curves.lengths(multiplicity);
          const double p = price();
          if(p < best)
          {
            best = p;
            is_better = true;
          }
          else
            multiplicity[c] -= by;
        }
    }
    return multiplicity;
  }

  // The result has no more quads, edges and vertices than the input: nothing has to be allocated.
  bool fits(const Layout_quantization& quantization, const std::vector<int>& length) const
  {
    long border = 0;
    for(std::size_t a = 0; a < length.size(); ++a)
      border += m_complex.arcs[a].is_border ? length[a] : 0;
    const long quads = quantization.number_of_quads(length), quads_before = m_input.mesh.number_of_faces();
    return quads > 0 && quads <= quads_before && 2 * quads + border <= 2 * quads_before + m_border_edges;
  }

  bool is_better(const Quad_mesh_structure& s) const
  {
    const bool same = s.euler_characteristic == m_structure.euler_characteristic &&
                      s.number_of_components == m_structure.number_of_components &&
                      s.number_of_boundary_loops == m_structure.number_of_boundary_loops &&
                      s.boundary_valences == m_structure.boundary_valences &&
                      (m_merge_singularities || s.inner_valences == m_structure.inner_valences);
    return same && (s.number_of_patches < m_structure.number_of_patches ||
                    (s.number_of_patches == m_structure.number_of_patches &&
                     s.number_of_helices < m_structure.number_of_helices) ||
                    (s.number_of_quads < m_structure.number_of_quads &&
                     std::size_t(m_target_quads) < m_structure.number_of_quads));
  }

  // The vertices that are nodes of the input stay these; all others are any of the input that are left over.
  void set_state(const Layout_realization& r, Structure_state& result) const
  {
    std::vector<char> is_used(m_input.mesh.number_of_vertices(), 0);
    for(int v : r.origin)
      if(v != -1)
        is_used[v] = 1;
    result.mesh = r.mesh;
    result.is_fixed.clear();
    result.vertex_origin.clear();
    std::size_t left_over = 0;
    for(int v : r.origin)
    {
      result.is_fixed.push_back(v != -1 && m_input.is_fixed[v]);
      while(v == -1 && is_used[left_over])
        ++left_over;
      result.vertex_origin.push_back(m_input.vertex_origin[v != -1 ? v : static_cast<int>(left_over++)]);
    }
    result.face_origin.assign(m_input.face_origin.begin(), m_input.face_origin.begin() + result.mesh.number_of_faces());
    result.has_failed.assign(result.mesh.number_of_faces(), 0);
    result.face_of.clear();
  }

  const Structure_state& m_input;
  bool m_merge_singularities;
  int m_target_quads;
  std::size_t m_target_patches;
  Quad_mesh_structure m_structure;
  Layout_goals m_goals;
  Motorcycle_complex m_complex;
  Feature_bends m_bends;
  std::unique_ptr<Layout_quantization> m_quantization;
  std::vector<std::vector<int>> m_layouts;
  std::unique_ptr<Layout_search> m_search;
  long m_border_edges = 0, m_attempts = 0;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_STRUCTURE_INTERNAL_LAYOUT_OPTIMIZER_H
