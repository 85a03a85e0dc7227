// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_STRUCTURE_INTERNAL_STRUCTURE_OPTIMIZER_H
#define CGAL_QUAD_MESHING_STRUCTURE_INTERNAL_STRUCTURE_OPTIMIZER_H

#include <CGAL/Quad_meshing/Structure/internal/Base_complex_arrays.h>
#include <CGAL/Quad_meshing/Structure/internal/Dual_lines.h>
#include <CGAL/Quad_meshing/Structure/internal/Gp_execution.h>
#include <CGAL/Quad_meshing/Structure/internal/Gp_path.h>
#include <CGAL/Quad_meshing/Structure/internal/Gp_search.h>
#include <CGAL/Quad_meshing/Structure/internal/Helix_detection.h>
#include <CGAL/Quad_meshing/Structure/internal/Indexed_quad_mesh.h>

#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The greedy removal of helices (thesis, section 10.3) and the collapse of dual curves (10.4).
class Structure_optimizer
{
public:
  // Columns of a helix in which its removal is tried, and each in both directions.
  static constexpr int columns_per_helix = 6;
  // Helices with at least this winding number may not get a larger pitch.
  static constexpr double protected_winding_number = 2;

  // The removal of helices does not go below this share of the quads of the input: what is gained
  // beyond is coarseness, not structure.
  static constexpr double least_share_of_quads = 0.4;

  // The mesh, with what the operators have to respect and to carry along.
  struct State
  {
    Indexed_quad_mesh mesh;
    std::vector<char> is_fixed;       // per vertex: must not move, nor be merged with a special one
    std::vector<char> has_failed;     // per face: the removal of the helix that begins here failed
    std::vector<int> face_of;         // per face of the mesh before the last operator: its face now, or -1
    std::vector<int> vertex_origin;   // per vertex: its number in the input
    std::vector<int> face_origin;     // per face: its number in the input; corners are numbered as there
  };

  // Size of the base complex first, number of helices second.
  struct Score
  {
    int patches = 0, helices = 0;
    bool operator<(const Score& s) const { return std::make_pair(patches, helices) < std::make_pair(s.patches, s.helices); }
  };

  State state;
  std::size_t operators = 0;

  static State initial_state(Indexed_quad_mesh mesh, std::vector<char> is_fixed)
  {
    State s;
    s.mesh = std::move(mesh);
    s.is_fixed = std::move(is_fixed);
    s.has_failed.assign(s.mesh.number_of_faces(), 0);
    s.vertex_origin.resize(s.mesh.number_of_vertices());
    std::iota(s.vertex_origin.begin(), s.vertex_origin.end(), 0);
    s.face_origin.resize(s.mesh.number_of_faces());
    std::iota(s.face_origin.begin(), s.face_origin.end(), 0);
    return s;
  }

  Structure_optimizer(Indexed_quad_mesh mesh, std::vector<char> is_fixed, bool merge_singularities)
    : state(initial_state(std::move(mesh), std::move(is_fixed))), m_merge_singularities(merge_singularities),
      m_quads_of_input(state.mesh.number_of_faces())
  {
    analyze(state.mesh);
  }

  const Score& score() const { return m_score; }

  // Goes on from another mesh.
  void set_state(State s)
  {
    state = std::move(s);
    analyze(state.mesh);
  }

  // Tries to remove one more helix; false if none of those left can be removed with a gain.
  // `go_further()` is asked between the attempts.
  template <typename GoFurther>
  bool remove_next_helix(const GoFurther& go_further)
  {
    const Dual_lines lines(state.mesh);
    const std::vector<Side_relation> relation = side_relations(state.mesh, lines);
    std::vector<Helix_record> helices = minimal_helices(state.mesh, lines, relation);
    std::stable_sort(helices.begin(), helices.end(), [](const Helix_record& a, const Helix_record& b)
    {
      return double(a.length) * b.turn_length > double(b.length) * a.turn_length;
    });
    for(const Helix_record& helix : helices)
    {
      const std::vector<int> bases = bases_of(helix, state.mesh, lines);
      if(state.has_failed[bases.front() / 4])
        continue;
      const int columns = (std::min)(helix.turn_length, static_cast<int>(bases.size()));
      const int tried = (std::min)(columns, columns_per_helix);
      for(int i = 0; i < tried; ++i)
        for(bool upwards : { true, false })
        {
          if(!go_further())
            return false;
          State result = state;
          std::size_t steps = 0;
          if(!unwind(result, bases, i * columns / tried, upwards, std::abs(helix.pitch), steps))
            continue;
          if(result.mesh.number_of_faces() < least_share_of_quads * m_quads_of_input)
            continue;
          const Score score = score_of(result.mesh);
          if(score < m_score)
          {
            state = std::move(result);
            m_score = score;
            operators += steps;
            return true;
          }
        }
      state.has_failed[bases.front() / 4] = 1;
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
  bool collapse_next_dual_curve()
  {
    const Indexed_quad_mesh& m = state.mesh;
    const Dual_lines lines(m);
    const Gp_vertex_rules rules = vertex_rules(state);
    Gp_legality legality(m, rules);
    std::vector<std::pair<int, int> > order;
    for(int l = 0; l < lines.number_of_lines(); ++l)
      if(lines.is_representative(l))
        order.emplace_back(lines.length[l], l);
    std::sort(order.begin(), order.end());
    for(const std::pair<int, int>& o : order)
    {
      const Gp_path path = collapse_path(m, lines.first[o.second]);
      if(legality.check(path))
        continue;
      State result;
      if(execute(state, path, rules, result))
      {
        state = std::move(result);
        ++operators;
        analyze(state.mesh);
        return true;
      }
    }
    return false;
  }

  // The collapse of the whole dual curve of a dual edge.
  static Gp_path collapse_path(const Indexed_quad_mesh& m, int h)
  {
    return straight_path(m, h, gp_collapse);
  }

  // The same operation on every edge that the dual curve of h crosses; for shifts it must be closed.
  static Gp_path straight_path(const Indexed_quad_mesh& m, int h, Gp_kind kind)
  {
    Gp_path path;
    int first = h;
    for(int b = m.opposite[m.across(first)]; b != -1 && b != h; b = m.opposite[m.across(first)])
      first = b;
    if(m.opposite[m.across(first)] == -1)
      path.push_back(Gp_step{ -1, m.across(first), kind });
    for(int s = first; ; )
    {
      path.push_back(Gp_step{ s, m.opposite[s], kind });
      s = m.forward(s);
      if(s == -1 || s == first)
        return path;
    }
  }

  static Gp_vertex_rules vertex_rules(const State& s, bool merge_singularities)
  {
    Gp_vertex_rules rules = make_gp_vertex_rules(s.mesh, merge_singularities);
    for(std::size_t v = 0; v < s.is_fixed.size(); ++v)
      if(s.is_fixed[v])
        rules.is_special[v] = 1;
    return rules;
  }

  // Executes a legal path; false if the result is not a mesh that can be represented, because edges
  // would share both ends.
  static bool execute(const State& s, const Gp_path& path, const Gp_vertex_rules& rules, State& result)
  {
    const int nv = s.mesh.number_of_vertices();
    std::vector<char> weight(nv);
    for(int v = 0; v < nv; ++v)
      weight[v] = s.is_fixed[v] ? 4 : rules.on_feature[v] || rules.on_border[v] ? 2 + rules.is_special[v]
                                    : rules.is_irregular[v];
    Gp_execution execution(s.mesh, path);
    result.mesh = execution.execute(weight);
    if(result.mesh.number_of_faces() == 0 || !is_valid_quad_mesh(result.mesh))
      return false;
    result.is_fixed.assign(result.mesh.number_of_vertices(), 0);
    for(int v = 0; v < nv; ++v)
      if(s.is_fixed[v])
        result.is_fixed[execution.vertex_of[v]] = 1;
    result.vertex_origin.clear();
    for(int v : execution.vertex_from)
      result.vertex_origin.push_back(s.vertex_origin[v]);
    result.has_failed.clear();
    result.face_origin.clear();
    for(int f = 0; f < s.mesh.number_of_faces(); ++f)
      if(execution.face_of[f] != -1)
      {
        result.has_failed.push_back(s.has_failed[f]);
        result.face_origin.push_back(s.face_origin[f]);
      }
    result.face_of = std::move(execution.face_of);
    return true;
  }

private:
  Gp_vertex_rules vertex_rules(const State& s) const { return vertex_rules(s, m_merge_singularities); }

  Score score_of(const Indexed_quad_mesh& m) const
  {
    Score s;
    s.patches = make_base_complex(m).number_of_patches;
    const Dual_lines lines(m);
    s.helices = static_cast<int>(minimal_helices(m, lines, side_relations(m, lines)).size());
    return s;
  }

  void analyze(const Indexed_quad_mesh& m) { m_score = score_of(m); }

  // The dual edges of a helix that have their equivalent one turn ahead (or behind) sideways, from
  // the lowest to the highest position.
  static std::vector<int> bases_of(const Helix_record& helix, const Indexed_quad_mesh& m, const Dual_lines& lines)
  {
    // the relations of a helix of negative pitch start one turn further on
    const int n = lines.length[helix.line];
    const int from = helix.pitch > 0 ? helix.start : helix.start + helix.turn_length;
    std::vector<int> at(n), bases;
    for(int p = 0, h = lines.first[helix.line]; p < n; ++p, h = m.forward(h))
      at[p] = h;
    for(int i = 0; i < helix.number_of_relations; ++i)
      bases.push_back(at[(from + i) % n]);
    return bases;
  }

  // Reduces the pitch of a helix to zero, one operator per unit. `bases` are dual edges of the helix
  // in the mesh of `s`, `column` is the one to begin with.
  bool unwind(State& s, std::vector<int> bases, int column, bool upwards, int pitch, std::size_t& steps) const
  {
    for(; pitch > 0; --pitch)
    {
      const Dual_lines lines(s.mesh);
      const std::vector<Side_relation> relation = side_relations(s.mesh, lines);
      auto is_winding = [&](int b)
      {
        return b != -1 && relation[b].target != -1 && relation[b].sidesteps == pitch
            && relation[b].sidesteps <= std::abs(relation[b].offset);
      };
      // the column, or else the first one that has survived the operators so far
      int base = column < static_cast<int>(bases.size()) && is_winding(bases[column]) ? bases[column] : -1;
      for(std::size_t i = 0; base == -1 && i < bases.size(); ++i)
        if(is_winding(bases[i]))
          base = bases[i];
      if(base == -1)
        return steps > 0;     // the helix has gone together with another one

      const Gp_vertex_rules rules = vertex_rules(s);
      Gp_search search(s.mesh, rules);
      const std::vector<int> correction = correction_of(s.mesh, relation, bases, base, upwards);
      protect(search, s.mesh, lines, relation, bases, correction);
      const Gp_path path = search.close(correction);
      State result;
      if(path.empty() || !execute(s, path, rules, result))
        return false;
      ++steps;
      for(int& b : bases)
        if(b != -1)
          b = result.face_of[b / 4] == -1 ? -1 : 4 * result.face_of[b / 4] + (b & 3);
      // dual edges of the line whose directions stand for both may be the reversed ones now
      s = std::move(result);
      const Dual_lines after(s.mesh);
      for(int& b : bases)
        if(b != -1 && !after.is_representative(after.line[b]))
          b = s.mesh.across(b);
    }
    return true;
  }

  // The shifts across all edges that lie between the windings of a helix in one column.
  static std::vector<int> correction_of(const Indexed_quad_mesh& m, const std::vector<Side_relation>& relation,
                                        const std::vector<int>& bases, int base, bool upwards)
  {
    const int k = relation[base].sidesteps;
    const bool rising = relation[base].offset > 0;
    auto is_same_helix = [&](int s)
    {
      return std::find(bases.begin(), bases.end(), s) != bases.end()
          && relation[s].target != -1 && relation[s].sidesteps == k && relation[s].offset == relation[base].offset;
    };
    // down to the lowest winding
    int lowest = base;
    for(bool found = true; found; )
    {
      found = false;
      for(int b : bases)
        if(b != -1 && b != base && relation[b].target == lowest && is_same_helix(b))
        {
          lowest = b;
          found = lowest != base;
          break;
        }
    }
    std::vector<int> crossed;
    int s = lowest;
    do
    {
      int q = m.next(s);
      for(int i = 0; i < k; ++i, q = m.forward(q))
        crossed.push_back(q);
      s = relation[s].target;
    }
    while(s != lowest && is_same_helix(s));

    // A line that climbs to the left is lowered by shifts to the left, whichever way they head.
    const int kind = rising ? gp_shift_left : gp_shift_right;
    std::vector<int> states;
    if(upwards)
      for(int q : crossed)
        states.push_back(3 * q + kind);
    else
      for(std::size_t i = crossed.size(); i-- > 0; )
        states.push_back(3 * m.opposite[crossed[i]] + kind);
    return states;
  }

  // Forbids what would undo the correction, destroy closed dual curves, or wind helices further.
  static void protect(Gp_search& search, const Indexed_quad_mesh& m, const Dual_lines& lines,
                      const std::vector<Side_relation>& relation, const std::vector<int>& bases,
                      const std::vector<int>& correction)
  {
    const int nh = m.number_of_halfedges();
    std::vector<char> is_given(3 * nh, 0);
    for(int s : correction)
      is_given[s] = 1;
    auto forbid = [&](int h, int kind)
    {
      for(int side : { h, m.opposite[h] })
        if(side != -1 && !is_given[3 * side + kind])
          search.forbid(3 * side + kind);
    };
    // other shifts between the windings
    for(int b : bases)
      if(b != -1 && relation[b].target != -1)
      {
        int q = m.next(b);
        for(int i = 0; i < relation[b].sidesteps; ++i, q = m.forward(q))
          for(int kind : { gp_shift_left, gp_shift_right })
            forbid(q, kind);
      }

    // shifts across the sides of closed dual curves that do not cross themselves
    std::vector<char> crosses_itself(lines.number_of_lines(), 0);
    for(int f = 0; f < m.number_of_faces(); ++f)
    {
      const int a = lines.line[4 * f], b = lines.line[4 * f + 1];
      if(a == b || a == lines.reverse[b])
        crosses_itself[a] = crosses_itself[lines.reverse[a]] = 1;
    }
    for(int h = 0; h < nh; ++h)
      if(lines.is_closed[lines.line[h]] && !crosses_itself[lines.line[h]])
        for(int kind : { gp_shift_left, gp_shift_right })
        {
          if(!is_given[3 * m.next(h) + kind])
            search.forbid(3 * m.next(h) + kind);
          const int o = m.opposite[m.next(h)];
          if(o != -1 && !is_given[3 * o + kind])
            search.forbid(3 * o + kind);
        }

    // shifts that raise the pitch of helices with several turns
    for(const Helix_record& helix : minimal_helices(m, lines, relation))
      if(helix.length >= protected_winding_number * helix.turn_length)
      {
        const int n = lines.length[helix.line], kind = helix.pitch > 0 ? gp_shift_right : gp_shift_left;
        int h = lines.first[helix.line];
        for(int p = 0; p < helix.start; ++p)
          h = m.forward(h);
        for(int i = 0; i < helix.length && i < n && h != -1; ++i, h = m.forward(h))
        {
          forbid(m.next(h), kind);
          forbid(m.prev(h), kind);
        }
      }
  }

  bool m_merge_singularities;
  int m_quads_of_input;
  Score m_score;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_STRUCTURE_INTERNAL_STRUCTURE_OPTIMIZER_H
