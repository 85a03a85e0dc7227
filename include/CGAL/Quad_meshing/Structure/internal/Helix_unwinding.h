// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_STRUCTURE_INTERNAL_HELIX_UNWINDING_H
#define CGAL_QUAD_MESHING_STRUCTURE_INTERNAL_HELIX_UNWINDING_H

#include <CGAL/Quad_meshing/Structure/internal/Gp_operators.h>
#include <CGAL/Quad_meshing/Structure/internal/Gp_path.h>
#include <CGAL/Quad_meshing/Structure/internal/Gp_search.h>
#include <CGAL/Quad_meshing/Structure/internal/Structure_state.h>
#include <CGAL/Quad_meshing/internal/Dual_lines.h>
#include <CGAL/Quad_meshing/internal/Helix_detection.h>
#include <CGAL/Quad_meshing/internal/Indexed_quad_mesh.h>
#include <CGAL/Quad_meshing/internal/Quad_vertex_rules.h>

#include <algorithm>
#include <cstdlib>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The removal of one helix (thesis, section 10.2): the shifts across all edges between its windings in one column are
// extended to an operator, one for each unit of its pitch.
class Helix_unwinding
{
public:
  // Helices with at least this winding number may not get a larger pitch.
  static constexpr double protected_winding_number = 2;

  explicit Helix_unwinding(bool merge_singularities) : m_merge_singularities(merge_singularities) {}

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
  bool operator()(Structure_state& s, std::vector<int> bases, int column, bool upwards, int pitch,
                  std::size_t& steps) const
  {
    for(; pitch > 0; --pitch)
    {
      const Dual_lines lines(s.mesh);
      const std::vector<Side_relation> relation = side_relations(s.mesh, lines);
      auto is_winding = [&](int b)
      {
        return b != -1 && relation[b].target != -1 && relation[b].sidesteps == pitch &&
               relation[b].sidesteps <= std::abs(relation[b].offset);
      };
      // the column, or else the first one that has survived the operators so far
      int base = column < static_cast<int>(bases.size()) && is_winding(bases[column]) ? bases[column] : -1;
      for(std::size_t i = 0; base == -1 && i < bases.size(); ++i)
        if(is_winding(bases[i]))
          base = bases[i];
      if(base == -1)
        return steps > 0; // the helix has gone together with another one

      const Quad_vertex_rules rules = vertex_rules(s, m_merge_singularities);
      Gp_search search(s.mesh, rules);
      const std::vector<int> correction = correction_of(s.mesh, relation, bases, base, upwards);
      protect(search, s.mesh, lines, relation, bases, correction);
      const Gp_path path = search.close(correction);
      Structure_state result;
      if(path.empty() || !execute_operator(s, path, rules, result))
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

private:
  // The shifts across all edges that lie between the windings of a helix in one column.
  static std::vector<int> correction_of(const Indexed_quad_mesh& m, const std::vector<Side_relation>& relation,
                                        const std::vector<int>& bases, int base, bool upwards)
  {
    const int k = relation[base].sidesteps;
    const bool rising = relation[base].offset > 0;
    auto is_same_helix = [&](int s)
    {
      return std::find(bases.begin(), bases.end(), s) != bases.end() && relation[s].target != -1 &&
             relation[s].sidesteps == k && relation[s].offset == relation[base].offset;
    };
    // down to the lowest winding
    int lowest = base;
    for(bool found = true; found;)
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
      for(std::size_t i = crossed.size(); i-- > 0;)
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
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_STRUCTURE_INTERNAL_HELIX_UNWINDING_H
