// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_FIELDS_INTERNAL_FIELD_SOLVER_H
#define CGAL_QUAD_MESHING_FIELDS_INTERNAL_FIELD_SOLVER_H

#include <CGAL/Quad_meshing/Fields/Cross_field_result.h>
#include <CGAL/Quad_meshing/Fields/internal/Dual_laplacian.h>
#include <CGAL/Quad_meshing/Fields/internal/Field_problem.h>
#include <CGAL/Quad_meshing/Fields/internal/Jump_polish.h>
#include <CGAL/Quad_meshing/Fields/internal/Mixed_integer_field.h>
#include <CGAL/Quad_meshing/Fields/internal/Representation_field.h>
#include <CGAL/Quad_meshing/Fields/internal/Sector_quads.h>
#include <CGAL/Quad_meshing/Fields/internal/merge_close_pairs.h>
#include <CGAL/Quad_meshing/Fields/internal/singularity_costs.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <random>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

struct Field_options
{
  Cross_field_method method = Cross_field_method::POLISHED;
  double target_edge_length = 0; // 0: none
};

// Sets all period jumps to the nearest integers for the given angles.
inline void round_jumps(const Field_problem& problem, Cross_field& field)
{
  field.period_jump.resize(problem.mesh.number_of_edges());
  for(int e = 0; e < problem.mesh.number_of_edges(); ++e)
    field.period_jump[e] = problem.is_inner(e)
      ? problem.nearest_jump(e, field.angle[problem.first_face(e)], field.angle[problem.second_face(e)]) : 0;
}

// The index of every vertex in quarters: 4, or 2 on the border, minus the quads of its whole fan.
inline std::vector<int> field_indices(const Field_problem& problem, const Cross_field& field)
{
  const Indexed_triangle_mesh& m = problem.mesh;
  const std::vector<char> undivided(m.number_of_edges(), 0);
  const Field_sectors fans = make_field_sectors(m, undivided);
  const std::vector<int> quads = quads_of_sectors(m, problem.frames, undivided, fans,
                                                  [&](int e) { return problem.residual(e, field); });
  std::vector<int> index(m.number_of_vertices(), 0);
  for(int i = 0; i < fans.number_of_sectors(); ++i)
    index[fans.vertex[i]] += (fans.closed[i] ? 4 : 2) - quads[i];
  return index;
}

inline int count_integers(const Field_problem& problem)
{
  int integers = 0;
  for(int e = 0; e < problem.mesh.number_of_edges(); ++e)
    integers += problem.is_inner(e) &&
                !(problem.constrained[problem.first_face(e)] && problem.constrained[problem.second_face(e)]);
  for(int f = 0; f < problem.mesh.number_of_faces(); ++f)
    integers -= !problem.constrained[f];
  // The tree of a component without constraint starts at a face that has no parent edge.
  for(int a : problem.anchor)
    integers += a != -1;
  return integers;
}

// Computes a smooth cross field (thesis 8.2) from one or several starts and keeps the best.
template <typename Visitor>
class Field_solver
{
public:
  Field_solver(const Field_problem& problem, const Field_options& options, Visitor& visitor)
    : m_problem(problem), m_options(options), m_visitor(visitor)
    , m_laplacian(problem)
    , m_polish(problem, m_laplacian)
    , m_costs(singularity_costs(problem, options.target_edge_length))
  {}

  Cross_field_status operator()(Cross_field& field, Cross_field_result& result)
  {
    m_visitor.on_stage_begin("cross field");
    const Cross_field_status status = solve(field, result);
    m_visitor.on_stage_end("cross field");
    return status;
  }

private:
  Cross_field_status solve(Cross_field& field, Cross_field_result& result)
  {
    // The local search ends in different minima from starts of different smoothness. On small meshes
    // both starts are the same, on large ones a second start costs more than it is worth.
    const int clusters_of_starts[] = { 6000, 400 };
    const int nf = m_problem.mesh.number_of_faces();
    const bool two_starts = nf >= 2 * clusters_of_starts[1] && nf < 50000;

    result.integers = count_integers(m_problem);
    result.conflicting_faces = m_problem.conflicting_faces;
    for(char c : m_problem.constrained)
      result.constrained_faces += c;
    if(!m_laplacian.is_valid())
      return Cross_field_status::NUMERICAL_FAILURE;

    const bool polished = m_options.method == Cross_field_method::POLISHED;
    const int starts = polished && two_starts ? 2 : 1;
    for(int start = 0; start < starts; ++start)
    {
      Cross_field candidate;
      if(polished)
      {
        if(!Representation_field(m_problem, clusters_of_starts[start])(candidate.angle))
          return Cross_field_status::NUMERICAL_FAILURE;
        round_jumps(m_problem, candidate);
      }
      else if(!Mixed_integer_field(m_problem).solve(rounding_method(), candidate))
        return Cross_field_status::NUMERICAL_FAILURE;

      m_laplacian.solve_angles(candidate);
      Sector_quads quads(m_problem, candidate, m_costs);
      if(quads.number_of_empty_sectors() > 0)
      {
        quads.fill_empty_sectors(candidate);
        m_laplacian.solve_angles(candidate);
      }
      if(improve_and_keep(candidate, quads))
        result.initial_energy = m_initial_energy;
      if(!m_visitor.go_further())
        return Cross_field_status::STOPPED;
      m_visitor.progress((start + 1.) / (starts + 1));
    }
    if(!m_best_quads) // no energy is a number
      return Cross_field_status::NUMERICAL_FAILURE;
    if(polished && !shake())
      return Cross_field_status::STOPPED;
    if(m_options.target_edge_length > 0)
      merge_close_pairs(m_problem, m_laplacian, m_options.target_edge_length / 2, *m_best_quads, m_best);
    m_visitor.progress(1.);

    field = m_best;
    result.empty_sectors = m_best_quads->number_of_empty_sectors();
    m_problem.normalize(field);
    result.energy = m_problem.energy(field);
    return result.empty_sectors == 0 ? Cross_field_status::SUCCESS : Cross_field_status::EMPTY_SECTORS;
  }

  // Polishes a field, unless another method was asked for, and keeps it if it is the best so far.
  bool improve_and_keep(Cross_field& candidate, Sector_quads& quads)
  {
    m_initial_energy = m_problem.energy(candidate);
    const double total = m_options.method == Cross_field_method::POLISHED
                       ? m_polish(candidate, quads, [&] { return m_visitor.go_further(); }) : m_initial_energy;
    if(!(total < m_lowest))
      return false;
    m_lowest = total;
    m_best = candidate;
    m_best_quads.reset(new Sector_quads(quads));
    return true;
  }

  // Leaves the local minimum by a few arbitrary moves next to singularities and polishes again, more often
  // on small meshes, where that costs nothing. Returns false if the visitor stopped it.
  bool shake()
  {
    const int nf = m_problem.mesh.number_of_faces();
    const int times = nf == 0 ? 0 : (std::min)(20, 30000 / nf);
    const int moves = 6;
    const double singular_residual = 0.15; // see Jump_polish

    std::mt19937 random; // the same numbers on every platform
    for(int i = 0; i < times; ++i)
    {
      if(!m_visitor.go_further())
        return false;
      std::vector<int> edges;
      for(int e = 0; e < m_problem.mesh.number_of_edges(); ++e)
        if(m_problem.is_movable(e) && std::abs(m_problem.residual(e, m_best)) > singular_residual)
          edges.push_back(e);
      if(edges.empty())
        return true;
      Cross_field candidate = m_best;
      Sector_quads quads = *m_best_quads;
      for(int k = 0; k < moves; ++k)
      {
        const int e = edges[random() % edges.size()];
        const int by = m_problem.residual(e, m_best) < 0 ? 1 : -1;
        if(std::isfinite(quads.cost_change(e, by)))
        {
          candidate.period_jump[e] += by;
          quads.change_jump(e, by);
        }
      }
      m_laplacian.solve_angles(candidate);
      improve_and_keep(candidate, quads);
    }
    return true;
  }

  Rounding_method rounding_method() const
  {
    switch(m_options.method)
    {
      case Cross_field_method::DIRECT: return DIRECT_ROUNDING;
      case Cross_field_method::NAIVE:  return NAIVE_ROUNDING;
      default:                         return GREEDY_ROUNDING;
    }
  }

  const Field_problem& m_problem;
  const Field_options m_options;
  Visitor& m_visitor;
  Dual_laplacian m_laplacian;
  Jump_polish m_polish;
  const std::vector<double> m_costs; // per vertex, of a singularity there

  // The best field so far, its quads, and its energy plus the cost of its sectors.
  Cross_field m_best;
  std::unique_ptr<Sector_quads> m_best_quads;
  double m_lowest = std::numeric_limits<double>::infinity();
  double m_initial_energy = 0; // of the last field before its polish
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_FIELDS_INTERNAL_FIELD_SOLVER_H
