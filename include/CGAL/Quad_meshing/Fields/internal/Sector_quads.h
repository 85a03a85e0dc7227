// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_FIELDS_INTERNAL_SECTOR_QUADS_H
#define CGAL_QUAD_MESHING_FIELDS_INTERNAL_SECTOR_QUADS_H

#include <CGAL/Quad_meshing/Fields/internal/Field_problem.h>
#include <CGAL/Quad_meshing/internal/Distance_front.h>
#include <CGAL/Quad_meshing/internal/Stage_progress.h>

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The number of quads of every sector, kept up to date while period jumps change, with the rule that
// a sector between aligned edges must not be empty and with the cost of singularities at places
// where they hinder the parametrization.
class Sector_quads
{
public:
  typedef std::vector<int> State;

  // In units of the energy, `singularity_cost` is, per vertex, what every quad too many or too few costs there, and
  // `doublet_cost` what every quad less than three costs besides, at a vertex without aligned edges.
  Sector_quads(const Field_problem& problem, const Cross_field& field, const std::vector<double>& singularity_cost,
               double doublet_cost)
    : m_problem(&problem)
    , m_singularity_cost(singularity_cost)
    , m_doublet_cost(doublet_cost)
    , m_may_cost(doublet_cost > 0 || !problem.prescribed_quads.empty() ||
                 std::any_of(singularity_cost.begin(), singularity_cost.end(), [](double c) { return c != 0; }))
  {
    set_state(quads_of_sectors(problem.mesh, problem.frames, problem.aligned, problem.sectors,
                               [&](int e) { return problem.turn(e, field); }));
  }

  const State& state() const { return m_quads; }
  void set_state(const State& s)
  {
    m_quads = s;
    m_valence.clear();
    m_costs.resize(s.size());
    for(std::size_t i = 0; i < s.size(); ++i)
      m_costs[i] = cost_of(static_cast<int>(i), s[i]) != 0;
  }

  double cost() const
  {
    double sum = 0;
    for(int s = 0; s < m_problem->sectors.number_of_sectors(); ++s)
      sum += cost_of(s, m_quads[s]);
    return sum;
  }

  // Whether one of the sectors next to edge e costs anything now.
  bool is_costly(int e) const { return m_may_cost && (m_costs[giver(e)] || m_costs[taker(e)]); }

  void change_jump(int e, int by)
  {
    change(giver(e), -by);
    change(taker(e), by);
  }

  // The change of the cost if a jump is changed; infinite if that empties a sector.
  double cost_change(int e, int by)
  {
    const int s[2] = { giver(e), taker(e) };
    return change_of(
      s, 2, [&] { change_jump(e, by); }, [&] { change_jump(e, -by); });
  }

  double cost_change(int e, int by, int e2, int by2)
  {
    const int s[4] = { giver(e), taker(e), giver(e2), taker(e2) };
    return change_of(
      s, 4,
      [&]
      {
        change_jump(e, by);
        change_jump(e2, by2);
      },
      [&]
      {
        change_jump(e, -by);
        change_jump(e2, -by2);
      });
  }

  bool has_closed_sector_with_less_than(int k) const
  {
    for(int s = 0; s < m_problem->sectors.number_of_sectors(); ++s)
      if(m_problem->sectors.closed[s] && m_quads[s] < k)
        return true;
    return false;
  }

  int number_of_empty_sectors() const
  {
    int n = 0;
    for(int s = 0; s < m_problem->sectors.number_of_sectors(); ++s)
      n += is_empty(s, m_quads[s]);
    return n;
  }

  // Gives quads to empty sectors and to inner vertices with less than `least_valence`, by changes of jumps along the
  // cheapest paths to sectors that can spare one. What a path costs is estimated from the residuals alone; a local
  // search that follows finds better places. Sectors of one face that no jump can reach stay as they are. Returns
  // whether anything changed.
  bool fill(Cross_field& field, int least_valence, Stage_progress& progress)
  {
    bool has_changed = false;
    set_valences();
    for(int s = 0; s < m_problem->sectors.number_of_sectors(); ++s)
      while(lacks_quads(s, m_quads[s], least_valence) && progress.go_further() && fetch_quad(s, field, least_valence))
        has_changed = true;
    return has_changed;
  }

  // Gives every sector the quads that are prescribed there, by changes of jumps along the cheapest paths to sectors
  // where any number will do, or where one is missing. Returns whether anything changed.
  bool prescribe(Cross_field& field, Stage_progress& progress)
  {
    bool has_changed = false;
    if(m_problem->prescribed_quads.empty())
      return false;
    for(int s = 0; s < m_problem->sectors.number_of_sectors(); ++s)
      while(lack(s) != 0 && progress.go_further())
      {
        const int gain = lack(s) > 0 ? 1 : -1;
        // Sectors without a prescription are left with a quad.
        auto can_change = [&](int t)
        {
          if(m_problem->quads_of_sector(t) != Field_problem::any_quads)
            return lack(t) * gain < 0;
          return gain < 0 || m_quads[t] > 1;
        };
        if(!move_quad(s, gain, field, can_change))
          break;
        has_changed = true;
      }
    return has_changed;
  }

private:
  // More than any field saves by a singularity in another place.
  static constexpr double prescription_cost = 1000;

  // How many quads a sector has less than prescribed.
  int lack(int s) const
  {
    const int prescribed = m_problem->quads_of_sector(s);
    return prescribed == Field_problem::any_quads ? 0 : prescribed - m_quads[s];
  }

  void set_valences()
  {
    m_valence.assign(m_problem->mesh.number_of_vertices(), 0);
    for(int s = 0; s < m_problem->sectors.number_of_sectors(); ++s)
      m_valence[m_problem->sectors.vertex[s]] += m_quads[s];
    const int any = 1 << 20; // so many quads that none is missed
    for(int h = 0; h < m_problem->mesh.number_of_halfedges(); ++h)
      if(m_problem->mesh.opposite[h] == -1)
        m_valence[m_problem->mesh.source(h)] = m_valence[m_problem->mesh.target(h)] = any;
  }

  bool lacks_quads(int s, int k, int least_valence) const
  {
    return is_empty(s, k) || m_valence[m_problem->sectors.vertex[s]] - m_quads[s] + k < least_valence;
  }

  void change(int s, int by)
  {
    m_quads[s] += by;
    if(!m_valence.empty())
      m_valence[m_problem->sectors.vertex[s]] += by;
    m_costs[s] = cost_of(s, m_quads[s]) != 0;
  }

  bool is_empty(int s, int k) const { return (m_problem->sectors.bounded[s] || m_problem->sectors.closed[s]) && k < 1; }

  double cost_of(int s, int k) const
  {
    if(!m_problem->sectors.closed[s])
      return 0;
    const int prescribed = m_problem->quads_of_sector(s);
    if(prescribed != Field_problem::any_quads)
      return prescription_cost * std::abs(k - prescribed);
    if(k == 4)
      return 0;
    return std::abs(k - 4) * m_singularity_cost[m_problem->sectors.vertex[s]] + (k < 3 ? m_doublet_cost * (3 - k) : 0);
  }

  // A change of the jump of e by one takes a quad here ...
  int giver(int e) const { return m_problem->sectors.of_corner[m_problem->mesh.halfedge_of_edge[e]]; }
  // ... and brings it there.
  int taker(int e) const
  {
    return m_problem->sectors.of_corner[Indexed_triangle_mesh::next(m_problem->mesh.halfedge_of_edge[e])];
  }

  template <typename Do, typename Undo>
  double change_of(const int* s, int n, const Do& change, const Undo& undo)
  {
    double before = 0, after = 0;
    int deficit_before = 0, deficit_after = 0;
    auto sum = [&](double& cost, int& deficit)
    {
      for(int i = 0; i < n; ++i)
        if(std::find(s, s + i, s[i]) == s + i)
        {
          cost += cost_of(s[i], m_quads[s[i]]);
          if(is_empty(s[i], m_quads[s[i]]))
            deficit += 1 - m_quads[s[i]];
        }
    };
    sum(before, deficit_before);
    change();
    sum(after, deficit_after);
    undo();
    return deficit_after > deficit_before ? std::numeric_limits<double>::infinity() : after - before;
  }

  // Brings a quad to a sector from the nearest one that can spare one. If the vertex itself has more quads in another
  // sector, beside an edge that ends nearby, it is one of those unless that is much farther: else the vertex would
  // become singular, and another one close by, and the columns of quads between them need not have a way out.
  bool fetch_quad(int receiver, Cross_field& field, int least_valence)
  {
    const Way nearest =
      find_way(receiver, 1, field, [&](int s) { return !lacks_quads(s, m_quads[s] - 1, least_valence); });
    const Way own = find_way(receiver, 1, field,
                             [&](int s) {
                               return m_problem->sectors.vertex[s] == m_problem->sectors.vertex[receiver] &&
                                      !lacks_quads(s, m_quads[s] - 1, 0);
                             });
    const bool is_own = own.is_found && own.length < nearest.length + self_energy;
    return take(is_own ? own : nearest, field);
  }

  // Brings a quad to a sector (`gain` 1) from the nearest one that may lose it, or takes one away (-1) to the nearest
  // one that may have it.
  template <typename May_change>
  bool move_quad(int receiver, int gain, Cross_field& field, const May_change& may_change)
  {
    return take(find_way(receiver, gain, field, may_change), field);
  }

  // Changes of jumps, which move a quad; an estimate of what they cost.
  struct Way
  {
    bool is_found = false;
    double length = std::numeric_limits<double>::infinity();
    std::vector<std::pair<int, int>> changes; // edge, by how much
  };

  // The self-energy of a jump, see Jump_polish; keeps the lengths of all steps positive.
  static constexpr double self_energy = quarter_turn * quarter_turn / 3;

  bool take(const Way& way, Cross_field& field)
  {
    for(const std::pair<int, int>& c : way.changes)
    {
      field.period_jump[c.first] += c.second;
      change_jump(c.first, c.second);
    }
    return way.is_found;
  }

  template <typename May_change>
  Way find_way(int receiver, int gain, const Cross_field& field, const May_change& may_change) const
  {
    const Indexed_triangle_mesh& m = m_problem->mesh;
    const double shortest_step = 0.01;

    Distance_front front(m_problem->sectors.number_of_sectors());
    std::vector<int> from_halfedge(m_problem->sectors.number_of_sectors(), -1);
    front.reach(receiver, 0.);
    Way way;
    int s;
    for(double length; front.pop(s, length);)
    {
      if(s != receiver && may_change(s))
      {
        for(int t = s; t != receiver; t = m_problem->sectors.of_corner[from_halfedge[t]])
        {
          // The halfedge leaves the sector that receives.
          const int e = m.edge_of[from_halfedge[t]];
          way.changes.push_back({ e, m.halfedge_of_edge[e] == from_halfedge[t] ? -gain : gain });
        }
        way.is_found = true;
        way.length = length;
        return way;
      }
      const int first = m_problem->sectors.first_corner[s];
      for(int h = first; h != -1 && m_problem->sectors.of_corner[h] == s;)
      {
        const int e = m.edge_of[h];
        if(m_problem->is_movable(e))
        {
          const int by = m.halfedge_of_edge[e] == h ? -gain : gain;
          const int t = m_problem->sectors.of_corner[m.next(h)];
          const double step =
            (std::max)(shortest_step, self_energy + 2 * quarter_turn * by * m_problem->residual(e, field));
          if(front.reach(t, length + step))
            from_halfedge[t] = h;
        }
        h = m.next_around_source(h);
        if(h == first)
          break;
      }
    }
    return way;
  }

  const Field_problem* m_problem;
  State m_quads;
  std::vector<int> m_valence; // per vertex, once it is needed: the sum of its sectors
  std::vector<char> m_costs;  // per sector: whether it costs anything now
  std::vector<double> m_singularity_cost;
  double m_doublet_cost;
  bool m_may_cost;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_FIELDS_INTERNAL_SECTOR_QUADS_H
