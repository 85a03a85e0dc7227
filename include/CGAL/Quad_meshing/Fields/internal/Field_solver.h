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
#include <CGAL/Quad_meshing/Fields/internal/Representation_field.h>
#include <CGAL/Quad_meshing/Fields/internal/Sector_quads.h>
#include <CGAL/Quad_meshing/Fields/internal/singularity_costs.h>

#include <string>
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
  for(int e = 0; e < problem.mesh.number_of_edges(); ++e)
    field.period_jump[e] = problem.is_inner(e)
      ? problem.nearest_jump(e, field.angle[problem.first_face(e)], field.angle[problem.second_face(e)]) : 0;
}

// The index of every vertex in quarters.
inline std::vector<int> field_indices(const Field_problem& problem, const Cross_field& field)
{
  const Indexed_triangle_mesh& m = problem.mesh;
  const Field_sectors& sectors = problem.sectors;
  const std::vector<int> quads = quads_of_sectors(m, problem.frames, problem.aligned, sectors,
                                                  [&](int e) { return problem.residual(e, field); });
  std::vector<int> index(m.number_of_vertices(), 0);
  std::vector<char> has_border(m.number_of_vertices(), 0), has_closed(m.number_of_vertices(), 0);
  for(int h = 0; h < m.number_of_halfedges(); ++h)
    if(m.opposite[h] == -1)
    {
      index[m.source(h)] += 2;
      has_border[m.source(h)] = 1;
    }
  for(int s = 0; s < sectors.number_of_sectors(); ++s)
  {
    index[sectors.vertex[s]] -= quads[s];
    if(sectors.closed[s])
    {
      index[sectors.vertex[s]] += 4;
      has_closed[sectors.vertex[s]] = 1;
    }
  }
  // The fan of an inner vertex that aligned edges divide.
  for(int v = 0; v < m.number_of_vertices(); ++v)
    if(m.halfedge_of_vertex[v] != -1 && !has_border[v] && !has_closed[v])
      index[v] += 4;
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

// Computes the smoothest cross field it can find (thesis 8.2 and what is said in Jump_polish.h).
template <typename Visitor>
Cross_field_status
solve_field(const Field_problem& problem, const Field_options& options, Visitor& visitor, Cross_field& field, Cross_field_result& result)
{
  const Indexed_triangle_mesh& m = problem.mesh;
  result.integers = count_integers(problem);
  result.conflicting_faces = problem.conflicting_faces;
  for(char c : problem.constrained)
    result.constrained_faces += c;

  visitor.on_stage_begin("cross field");
  auto finish = [&](Cross_field_status status)
  {
    visitor.on_stage_end("cross field");
    return status;
  };

  field.period_jump.assign(m.number_of_edges(), 0);
  field.angle.assign(m.number_of_faces(), 0.);

  Dual_laplacian laplacian(problem);
  if(!laplacian.is_valid() || !representation_field(problem, laplacian, field.angle))
    return finish(Cross_field_status::NUMERICAL_FAILURE);
  visitor.progress(0.5);
  if(!visitor.go_further())
    return finish(Cross_field_status::STOPPED);

  round_jumps(problem, field);
  laplacian.solve_angles(field);
  Sector_quads quads(problem, field, singularity_costs(problem, options.target_edge_length));
  if(quads.number_of_empty_sectors() > 0)
  {
    quads.fill_empty_sectors(field);
    laplacian.solve_angles(field);
  }
  result.initial_energy = problem.energy(field);

  Jump_polish polish(problem, laplacian, quads);
  polish(field, [&] { return visitor.go_further(); });
  if(!visitor.go_further())
    return finish(Cross_field_status::STOPPED);
  visitor.progress(1.);

  problem.normalize(field);
  result.energy = problem.energy(field);
  result.empty_sectors = quads.number_of_empty_sectors();
  return finish(result.empty_sectors == 0 ? Cross_field_status::SUCCESS : Cross_field_status::EMPTY_SECTORS);
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_FIELDS_INTERNAL_FIELD_SOLVER_H
