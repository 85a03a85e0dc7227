// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_STRUCTURE_INTERNAL_STRUCTURE_OPTIMIZER_H
#define CGAL_QUAD_MESHING_STRUCTURE_INTERNAL_STRUCTURE_OPTIMIZER_H

#include <CGAL/Quad_meshing/Structure/internal/Gp_operators.h>
#include <CGAL/Quad_meshing/Structure/internal/Gp_path.h>
#include <CGAL/Quad_meshing/Structure/internal/Gp_search.h>
#include <CGAL/Quad_meshing/Structure/internal/Helix_unwinding.h>
#include <CGAL/Quad_meshing/Structure/internal/Structure_state.h>
#include <CGAL/Quad_meshing/internal/Base_complex_arrays.h>
#include <CGAL/Quad_meshing/internal/Dual_lines.h>
#include <CGAL/Quad_meshing/internal/Helix_detection.h>
#include <CGAL/Quad_meshing/internal/Indexed_quad_mesh.h>
#include <CGAL/Quad_meshing/internal/Quad_vertex_rules.h>

#include <algorithm>
#include <cstdlib>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The greedy removal of helices and the collapse of dual curves (Bommes, Lempfer, Kobbelt 2011).
class Structure_optimizer
{
public:
  // Columns of a helix in which its removal is tried, and each in both directions.
  static constexpr int columns_per_helix = 6;

  // The removal of helices does not go below this share of the quads of the input: what is gained
  // beyond is coarseness, not structure.
  static constexpr double least_share_of_quads = 0.4;

  // What the removal of helices makes smaller: their number, in both ways of counting, and then the base complex.
  // Neither number may grow: on a curve that crosses itself less than before, more of its turns count as helices.
  struct Score
  {
    int patches = 0, helices = 0, helices_with_crossings = 0;

    bool is_better_than(const Score& s) const
    {
      return helices <= s.helices && helices_with_crossings <= s.helices_with_crossings &&
             std::make_pair(helices + helices_with_crossings, patches) <
               std::make_pair(s.helices + s.helices_with_crossings, s.patches);
    }
  };

  Structure_state state;
  std::size_t operators = 0;
  // per face before the last removal of a helix: as `has_failed`, if that has failed, too
  std::vector<char> has_failed_if_undone;

  Structure_optimizer(Structure_state input, bool merge_singularities)
    : state(std::move(input))
    , m_merge_singularities(merge_singularities)
    , m_unwind(merge_singularities)
    , m_quads_of_input(state.mesh.number_of_faces())
    , m_score(score_of(state.mesh))
  {
  }

  const Score& score() const { return m_score; }

  static Score score_of(const Indexed_quad_mesh& m)
  {
    Score s;
    s.patches = number_of_base_complex_patches(m);
    const Dual_lines lines(m);
    const std::vector<Side_relation> relation = side_relations(m, lines);
    s.helices = static_cast<int>(minimal_helices(m, lines, relation).size());
    s.helices_with_crossings = static_cast<int>(minimal_helices(m, lines, relation, true).size());
    return s;
  }

  // Goes on from another mesh.
  void set_state(Structure_state s)
  {
    state = std::move(s);
    m_score = score_of(state.mesh);
  }

  // Tries to remove one more helix; false if none of those left can be removed with a gain.
  // `go_further()` is asked between the attempts.
  template <typename GoFurther>
  bool remove_next_helix(const GoFurther& go_further)
  {
    const Dual_lines lines(state.mesh);
    const std::vector<Side_relation> relation = side_relations(state.mesh, lines);
    std::vector<Helix_record> helices = minimal_helices(state.mesh, lines, relation, true);
    std::stable_sort(helices.begin(), helices.end(),
                     [](const Helix_record& a, const Helix_record& b)
                     { return double(a.length) * b.turn_length > double(b.length) * a.turn_length; });
    for(const Helix_record& helix : helices)
    {
      const std::vector<int> bases = Helix_unwinding::bases_of(helix, state.mesh, lines);
      const int first_face = bases.front() / 4;
      if(state.has_failed[first_face])
        continue;
      const int columns = (std::min)(helix.turn_length, static_cast<int>(bases.size()));
      const int tried = (std::min)(columns, columns_per_helix);
      for(int i = 0; i < tried; ++i)
        for(bool upwards : { true, false })
        {
          if(!go_further())
            return false;
          Structure_state result = state;
          std::size_t steps = 0;
          if(!m_unwind(result, bases, i * columns / tried, upwards, std::abs(helix.pitch), steps) ||
             result.mesh.number_of_faces() < least_share_of_quads * m_quads_of_input)
            continue;
          const Score score = score_of(result.mesh);
          if(score.is_better_than(m_score))
          {
            has_failed_if_undone = state.has_failed;
            has_failed_if_undone[first_face] = 1;
            state = std::move(result);
            m_score = score;
            operators += steps;
            return true;
          }
        }
      state.has_failed[first_face] = 1;
    }
    return false;
  }

  // Gives the helices whose removal failed another chance; false if there is none.
  bool forget_failures()
  {
    const bool any = std::find(state.has_failed.begin(), state.has_failed.end(), 1) != state.has_failed.end();
    state.has_failed.assign(state.mesh.number_of_faces(), 0);
    return any;
  }

  // Collapses the shortest dual curve that may be collapsed; false if there is none.
  template <typename GoFurther>
  bool collapse_next_dual_curve(const GoFurther& go_further)
  {
    const Indexed_quad_mesh& m = state.mesh;
    const Dual_lines lines(m);
    const Quad_vertex_rules rules = vertex_rules(state, m_merge_singularities);
    Gp_legality legality(m, rules);
    std::vector<std::pair<int, int>> order;
    for(int l = 0; l < lines.number_of_lines(); ++l)
      if(lines.is_representative(l))
        order.emplace_back(lines.length[l], l);
    std::sort(order.begin(), order.end());
    for(const std::pair<int, int>& o : order)
    {
      const Gp_path path = collapse_path(m, lines.first[o.second]);
      if(!go_further())
        return false;
      if(legality.check(path))
        continue;
      Structure_state result;
      if(execute_operator(state, path, rules, result))
      {
        state = std::move(result);
        ++operators;
        m_score = score_of(state.mesh);
        return true;
      }
    }
    return false;
  }

private:
  bool m_merge_singularities;
  Helix_unwinding m_unwind;
  int m_quads_of_input;
  Score m_score;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_STRUCTURE_INTERNAL_STRUCTURE_OPTIMIZER_H
