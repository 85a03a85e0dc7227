// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_FIELDS_INTERNAL_MIXED_INTEGER_FIELD_H
#define CGAL_QUAD_MESHING_FIELDS_INTERNAL_MIXED_INTEGER_FIELD_H

#include <CGAL/Quad_meshing/Fields/Cross_field_result.h>
#include <CGAL/Quad_meshing/Fields/internal/Field_problem.h>
#include <CGAL/Quad_meshing/Fields/internal/solve_field.h>
#include <CGAL/Quad_meshing/Mixed_integer/solve_mixed_integer.h>
#include <CGAL/Quad_meshing/internal/Distance_front.h>
#include <CGAL/Quad_meshing/internal/Stage_progress.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The smoothest cross field as a mixed-integer problem, as [Bom12, 8.2] poses it.
//
// A turn of one cross by a right angle changes its angle and the jumps around it, but not the
// field. So one jump per free face can be fixed: those on a forest of dual trees that grow from the
// faces with given directions, by Dijkstra's algorithm over the distances of centroids. What is left
// is one real variable per free face and one integer per remaining edge.
class Mixed_integer_field
{
public:
  explicit Mixed_integer_field(const Field_problem& problem)
    : m_problem(problem)
    , m_mesh(problem.mesh)
    , m_angle_variable(problem.mesh.number_of_faces(), -1)
    , m_jump_variable(problem.mesh.number_of_edges(), -1)
  {
    grow_forest();
    set_up();
  }

  int number_of_integers() const { return m_system.number_of_integers(); }
  const Mixed_integer_problem& system() const { return m_system; }

  // No field has less energy.
  double lower_bound(int rounds, Stage_progress& progress) const
  {
    // Enumeration proves little here; most of the time belongs to the relaxation.
    const double nodes = 1e5;

    double between_given_faces = 0;
    for(int e = 0; e < m_mesh.number_of_edges(); ++e)
      if(m_problem.is_inner(e) && is_between_given_faces(e))
      {
        const double r = m_problem.kappa(e) + m_problem.given_angle[m_problem.first_face(e)] +
                         quarter_turn * fixed_jump(e) - m_problem.given_angle[m_problem.second_face(e)];
        between_given_faces += r * r;
      }
    if(m_system.number_of_variables() == 0)
      return between_given_faces;
    Step_visitor visitor(progress);
    const double bound = solve_mixed_integer(m_system, parameters::rounding_method(Rounding_method::LATTICE)
                                                         .maximum_number_of_nodes(nodes)
                                                         .number_of_bound_rounds(rounds)
                                                         .visitor(std::ref(visitor)))
                           .lower_bound;
    return between_given_faces + (std::max)(0., bound);
  }

  // Sets the field to the solution found by a method for mixed-integer problems. Returns false if there is none.
  bool solve(Rounding_method method, const Field_options& options, Cross_field& field, Stage_progress& progress) const
  {
    Eigen::VectorXd x;
    if(m_system.number_of_variables() > 0)
    {
      Step_visitor visitor(progress);
      x = solve_mixed_integer(m_system, parameters::rounding_method(method)
                                          .rounding_tolerance(options.rounding_tolerance)
                                          .gauss_seidel_iterations(options.gauss_seidel_iterations)
                                          .conjugate_gradient_iterations(options.conjugate_gradient_iterations)
                                          .allow_refactorization(options.allow_refactorization)
                                          .visitor(std::ref(visitor)))
            .x;
      if(x.size() == 0)
        return false;
    }
    field.angle.resize(m_mesh.number_of_faces());
    field.period_jump.resize(m_mesh.number_of_edges());
    for(int f = 0; f < m_mesh.number_of_faces(); ++f)
      field.angle[f] = m_angle_variable[f] != -1 ? x[m_angle_variable[f]] : m_problem.given_angle[f];
    for(int e = 0; e < m_mesh.number_of_edges(); ++e)
      field.period_jump[e] =
        m_jump_variable[e] != -1 ? static_cast<int>(std::lround(x[m_jump_variable[e]])) : fixed_jump(e);
    return true;
  }

private:
  bool is_between_given_faces(int e) const
  {
    return m_problem.constrained[m_problem.first_face(e)] && m_problem.constrained[m_problem.second_face(e)];
  }

  // The jump between two given faces is the nearest integer, on the forest it is zero.
  int fixed_jump(int e) const
  {
    if(!m_problem.is_inner(e) || m_in_forest[e])
      return 0;
    return m_problem.nearest_jump(e, m_problem.given_angle[m_problem.first_face(e)],
                                  m_problem.given_angle[m_problem.second_face(e)]);
  }

  void grow_forest()
  {
    const int nf = m_mesh.number_of_faces();
    m_in_forest.assign(m_mesh.number_of_edges(), 0);
    std::vector<int> parent_edge(nf, -1);
    Distance_front front(nf);
    for(int f = 0; f < nf; ++f)
      if(m_problem.constrained[f])
        front.reach(f, 0.);
    for(int f : m_problem.anchor)
      if(f != -1)
        front.reach(f, 0.);
    auto centroid = [&](int f)
    {
      const std::array<int, 3>& c = m_mesh.corners[f];
      return CGAL::centroid(m_mesh.points[c[0]], m_mesh.points[c[1]], m_mesh.points[c[2]]);
    };
    int f;
    for(double length; front.pop(f, length);)
      for(int h = 3 * f; h < 3 * f + 3; ++h)
      {
        if(m_mesh.opposite[h] == -1)
          continue;
        const int g = m_mesh.opposite[h] / 3;
        if(front.reach(g, length + std::sqrt((centroid(g) - centroid(f)).squared_length())))
          parent_edge[g] = m_mesh.edge_of[h];
      }
    for(int e : parent_edge)
      if(e != -1)
        m_in_forest[e] = 1;
  }

  void set_up()
  {
    std::vector<char> is_anchor(m_mesh.number_of_faces(), 0);
    for(int f : m_problem.anchor)
      if(f != -1)
        is_anchor[f] = 1;
    for(int f = 0; f < m_mesh.number_of_faces(); ++f)
      if(!m_problem.constrained[f] && !is_anchor[f])
        m_angle_variable[f] = m_system.add_variable();
    for(int e = 0; e < m_mesh.number_of_edges(); ++e)
    {
      if(!m_problem.is_inner(e))
        continue;
      const int f = m_problem.first_face(e), g = m_problem.second_face(e);
      if(is_between_given_faces(e))
        continue;
      if(!m_in_forest[e])
        m_jump_variable[e] = m_system.add_variable(true);

      Mixed_integer_problem::Linear_form form;
      double constant = m_problem.kappa(e);
      if(m_angle_variable[f] != -1)
        form.emplace_back(m_angle_variable[f], 1.);
      else
        constant += m_problem.given_angle[f];
      if(m_angle_variable[g] != -1)
        form.emplace_back(m_angle_variable[g], -1.);
      else
        constant -= m_problem.given_angle[g];
      if(m_jump_variable[e] != -1)
        form.emplace_back(m_jump_variable[e], quarter_turn);
      m_system.add_squared_residual(form, -constant);
    }
  }

  const Field_problem& m_problem;
  const Indexed_triangle_mesh& m_mesh;
  Mixed_integer_problem m_system;
  std::vector<int> m_angle_variable; // per face, -1 if the angle is fixed
  std::vector<int> m_jump_variable;  // per edge, -1 if the jump is fixed
  std::vector<char> m_in_forest;     // per edge
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_FIELDS_INTERNAL_MIXED_INTEGER_FIELD_H
