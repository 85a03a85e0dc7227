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
#include <CGAL/Quad_meshing/Fields/internal/Jump_annealing.h>
#include <CGAL/Quad_meshing/Fields/internal/Jump_polish.h>
#include <CGAL/Quad_meshing/Fields/internal/Mixed_integer_field.h>
#include <CGAL/Quad_meshing/Fields/internal/Representation_field.h>
#include <CGAL/Quad_meshing/Fields/internal/Sector_quads.h>
#include <CGAL/Quad_meshing/Fields/internal/merge_close_pairs.h>
#include <CGAL/Quad_meshing/Fields/internal/singularity_costs.h>
#include <CGAL/Quad_meshing/Fields/internal/solve_field.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Sets all period jumps to the nearest integers for the given angles.
inline void round_jumps(const Field_problem& problem, Cross_field& field)
{
  field.period_jump.resize(problem.mesh.number_of_edges());
  for(int e = 0; e < problem.mesh.number_of_edges(); ++e)
    field.period_jump[e] = problem.is_inner(e) ? problem.nearest_jump(e, field.angle[problem.first_face(e)],
                                                                      field.angle[problem.second_face(e)])
                                               : 0;
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

// Computes a smooth cross field [Bom12, 8.2].
class Field_solver
{
public:
  Field_solver(const Field_problem& problem, const Field_options& options, Stage_progress& progress)
    : m_problem(problem)
    , m_options(options)
    , m_progress(progress)
    , m_laplacian(problem, progress)
    , m_polish(problem, m_laplacian, progress)
    , m_costs(singularity_costs(problem, options.target_edge_length, options.singularity_cost))
  {
  }

  Cross_field_status operator()(Cross_field& field, Cross_field_result& result)
  {
    const Cross_field_status status = solve(field, result);
    return m_progress.is_stopped() ? Cross_field_status::STOPPED : status;
  }

private:
  // How far the progress has come at the end of each part.
  static constexpr double start_end = 0.2, search_end = 0.9, bound_begin = 0.95;

  // After a stop by the visitor, whatever is computed is not used.
  Cross_field_status solve(Cross_field& field, Cross_field_result& result)
  {
    result.integers = count_integers(m_problem);
    result.conflicting_faces = m_problem.conflicting_faces;
    for(char c : m_problem.constrained)
      result.constrained_faces += c;
    if(!m_laplacian.is_valid())
      return Cross_field_status::NUMERICAL_FAILURE;

    const bool polished = m_options.method == Cross_field_method::POLISHED,
               is_for_quads = m_options.target_edge_length > 0;
    m_progress.begin_part(start_end);
    std::unique_ptr<Jump_annealing> anneal;
    if(polished && !is_for_quads && m_problem.soft_weight.empty() && m_problem.prescribed_quads.empty() &&
       m_options.singularity_cost == 0)
    {
      anneal.reset(new Jump_annealing(m_problem, m_laplacian));
      if(!anneal->is_affordable())
        anneal.reset();
    }

    if(polished || m_options.method == Cross_field_method::REPRESENTATION)
    {
      if(!Representation_field(m_problem, number_of_clusters(anneal != nullptr), m_progress)(field.angle))
        return Cross_field_status::NUMERICAL_FAILURE;
      round_jumps(m_problem, field);
    }
    else if(!Mixed_integer_field(m_problem).solve(rounding_method(), m_options, field, m_progress))
      return Cross_field_status::NUMERICAL_FAILURE;
    if(!m_progress.go_further(start_end))
      return Cross_field_status::STOPPED;

    m_progress.begin_part(search_end);
    m_laplacian.solve_angles(field);
    Sector_quads quads(m_problem, field, m_costs, doublet_cost);
    // The search of the polished field finds better ways around vertices with less than three quads.
    const int least_valence = is_for_quads && !polished ? 3 : 0;
    const bool is_filled = quads.fill(field, least_valence, m_progress);
    if(quads.prescribe(field, m_progress) || is_filled)
      m_laplacian.solve_angles(field);
    result.initial_energy = m_problem.energy(field);
    if(!std::isfinite(result.initial_energy))
      return Cross_field_status::NUMERICAL_FAILURE;
    if(anneal)
    {
      if(!(*anneal)(field, quads, m_progress))
        return Cross_field_status::NUMERICAL_FAILURE;
    }
    else if(polished)
    {
      // Singularities of high index are kept from each other first, even if smoothness alone is asked for, or single
      // changes could hardly part them.
      if(is_for_quads || quads.has_closed_sector_with_less_than(2))
        m_polish(field, quads);
      if(!is_for_quads)
      {
        quads = Sector_quads(m_problem, field, m_costs, 0.);
        m_polish(field, quads);
      }
      m_polish.annihilate(field, quads, number_of_trials());
    }
    else if(m_options.method == Cross_field_method::GREEDY_AND_SEARCH)
    {
      if(!is_for_quads)
        quads = Sector_quads(m_problem, field, m_costs, 0.);
      m_polish(field, quads);
    }
    if(!m_progress.go_further(search_end))
      return Cross_field_status::STOPPED;
    m_progress.begin_part(m_options.number_of_bound_rounds > 0 ? bound_begin : 1.);
    if(is_for_quads)
    {
      merge_close_pairs(m_problem, m_laplacian, m_options.target_edge_length, quads, field, m_progress);
      // What the search leaves in parts with few triangles, such as the conical end of a drilled hole: no mesh has it.
      if(quads.has_closed_sector_with_less_than(3) && quads.fill(field, 3, m_progress))
      {
        quads.prescribe(field, m_progress);
        m_laplacian.solve_angles(field);
      }
    }

    result.empty_sectors = quads.number_of_empty_sectors();
    m_problem.normalize(field);
    result.energy = m_problem.energy(field);
    if(m_options.number_of_bound_rounds > 0)
    {
      m_progress.begin_part(1.);
      result.lower_bound = Mixed_integer_field(m_problem).lower_bound(m_options.number_of_bound_rounds, m_progress);
    }
    m_progress.go_further(1.);
    return result.empty_sectors == 0 ? Cross_field_status::SUCCESS : Cross_field_status::EMPTY_SECTORS;
  }

  // More make the start smoother, but take longer, and the search ends no lower. On the smallest meshes the start would
  // take longer than the annealing.
  int number_of_clusters(bool is_annealed) const
  {
    const int most = 6000, few_faces = 500;
    const int faces = m_problem.mesh.number_of_faces();
    return is_annealed && faces < few_faces ? faces / 4 + 1 : most;
  }

  // How many pairs of singularities the local search may annihilate for a trial: so many that on small meshes they take
  // about as long as all the rest, and enough for those of large ones.
  int number_of_trials() const { return (std::min)(100, m_problem.mesh.number_of_faces() / 20); }

  // A vertex with two quads folds them onto each other: more than any singularity is worth, in a mesh of quads.
  static constexpr double doublet_cost = 2.;

  Rounding_method rounding_method() const
  {
    switch(m_options.method)
    {
      case Cross_field_method::DIRECT: return Rounding_method::DIRECT;
      case Cross_field_method::NAIVE: return Rounding_method::NAIVE;
      default: return Rounding_method::GREEDY;
    }
  }

  const Field_problem& m_problem;
  const Field_options m_options;
  Stage_progress& m_progress;
  Dual_laplacian m_laplacian;
  Jump_polish m_polish;
  const std::vector<double> m_costs; // per vertex, of a singularity there
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_FIELDS_INTERNAL_FIELD_SOLVER_H
