// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_BENCHMARK_MIXED_INTEGER_PROBLEMS_H
#define CGAL_QUAD_MESHING_BENCHMARK_MIXED_INTEGER_PROBLEMS_H

#include "mixed_integer_grids.h"

#include <CGAL/Quad_meshing/Fields/cross_field.h>
#include <CGAL/Quad_meshing/Fields/feature_edges.h>
#include <CGAL/Quad_meshing/Fields/internal/Mixed_integer_field.h>
#include <CGAL/Quad_meshing/Mixed_integer/Mixed_integer_problem.h>
#include <CGAL/Quad_meshing/Mixed_integer/read_matrix_market.h>
#include <CGAL/Quad_meshing/Parameterization/internal/Combed_charts.h>
#include <CGAL/Quad_meshing/Parameterization/internal/Face_gradients.h>
#include <CGAL/Quad_meshing/Parameterization/internal/Orientation_energy.h>
#include <CGAL/Quad_meshing/Parameterization/internal/Seamless_coordinates.h>
#include <CGAL/Quad_meshing/Parameterization/prepare_mesh.h>
#include <CGAL/Quad_meshing/internal/Indexed_triangle_mesh.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Random.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Count_stop_predicate.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>
#include <CGAL/subdivision_method_3.h>

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <string>
#include <vector>

// Mixed-integer problems to measure with: made on grids, read from files, and those of fields and maps on meshes.
namespace mixed_integer_problems {

namespace QM = CGAL::Quad_meshing;
typedef QM::Mixed_integer_problem Problem;
typedef CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3> Mesh;

// A grid of reals; differences across random edges contain integers, one for each of some vertical cuts.
inline Problem make_map(int width, int integers)
{
  CGAL::Random random(1);
  Problem problem(width * width);
  for(int k = 0; k < integers; ++k)
    problem.add_variable(true);
  for_each_grid_edge(width,
                     [&](int i, int j, bool is_down, Problem::Linear_form form)
                     {
                       // Cut k crosses the edges of a row segment.
                       const int cut = (i * integers) / width;
                       if(is_down && i % ((std::max)(1, width / integers)) == 0 && j < width / 2)
                         form.emplace_back(width * width + cut, 1.);
                       problem.add_squared_residual(form, random.get_double(-0.6, 0.7));
                     });
  problem.add_equality_constraint({ { 0, 1. } }, 0.);
  return problem;
}

// A map of a grid cut into square tiles, each with coordinates of its own for all of its nodes: transitions across
// the cuts are equality constraints with an integer translation per cut, and a few long ones say that paths across
// all tiles have integer lengths.
inline Problem make_constrained_map(int width)
{
  const int tile = 10, tiles = width / tile, nodes = tile + 1;
  CGAL::Random random(3);
  Problem problem(tiles * tiles * nodes * nodes);
  const auto variable = [&](int a, int b, int i, int j) { return ((a * tiles + b) * nodes + i) * nodes + j; };
  for(int a = 0; a < tiles; ++a)
  {
    const int length = problem.add_variable(true);
    Problem::Linear_form path(1, std::make_pair(length, -1.));
    for(int b = 0; b < tiles; ++b)
    {
      path.emplace_back(variable(a, b, 0, tile), 1.);
      path.emplace_back(variable(a, b, 0, 0), -1.);
    }
    problem.add_equality_constraint(path, 0.);
  }
  for(int a = 0; a < tiles; ++a)
    for(int b = 0; b < tiles; ++b)
    {
      for(int i = 0; i < nodes; ++i)
        for(int j = 0; j < nodes; ++j)
        {
          if(i + 1 < nodes)
            problem.add_squared_residual({ { variable(a, b, i + 1, j), 1. }, { variable(a, b, i, j), -1. } },
                                         random.get_double(-0.6, 0.7));
          if(j + 1 < nodes)
            problem.add_squared_residual({ { variable(a, b, i, j + 1), 1. }, { variable(a, b, i, j), -1. } },
                                         random.get_double(-0.6, 0.7));
        }
      for(int side = 0; side < 2; ++side)
        if((side == 0 ? a : b) + 1 < tiles)
        {
          const int translation = problem.add_variable(true);
          for(int k = 0; k < nodes; ++k)
            problem.add_equality_constraint({ { side == 0 ? variable(a, b, tile, k) : variable(a, b, k, tile), 1. },
                                              { side == 0 ? variable(a + 1, b, 0, k) : variable(a, b + 1, k, 0), -1. },
                                              { translation, -1. } },
                                            0.);
        }
    }
  problem.add_equality_constraint({ { 0, 1. } }, 0.);
  return problem;
}

// Angles at the nodes of a grid, period jumps on the edges that are not in a spanning tree.
inline Problem make_field(int width)
{
  CGAL::Random random(2);
  const double quarter = 1.57079632679489661923;
  Problem problem(width * width);
  for_each_grid_edge(width,
                     [&](int, int j, bool is_down, Problem::Linear_form form)
                     {
                       const bool is_tree_edge = !is_down || j == 0;
                       if(!is_tree_edge)
                         form.emplace_back(problem.add_variable(true), quarter);
                       problem.add_squared_residual(form, random.get_double(-0.25, 0.25));
                     });
  problem.add_equality_constraint({ { 0, 1. } }, 0.);
  return problem;
}

// From NAME.A.mtx, NAME.b.mtx (Matrix Market) and NAME.I.txt (indices of integers, from 0).
inline bool read_problem(const std::string& name, Problem& problem)
{
  std::ifstream a(name + ".A.mtx"), b(name + ".b.mtx"), integers(name + ".I.txt");
  Eigen::SparseMatrix<double> A, rhs;
  std::string message;
  if(!a || !b || !integers || !QM::read_matrix_market(a, A, message) || !QM::read_matrix_market(b, rhs, message))
    return false;
  problem = Problem(static_cast<int>(A.rows()));
  problem.set_energy(A, Eigen::VectorXd(Eigen::MatrixXd(rhs).col(0)));
  for(int i; integers >> i;)
    problem.set_integer(i);
  return true;
}

// The mesh with about the given number of triangles: subdivided, then decimated.
inline Mesh resized(Mesh tm, std::size_t triangles)
{
  namespace SMS = CGAL::Surface_mesh_simplification;
  while(tm.number_of_faces() < triangles)
    CGAL::Subdivision_method_3::Loop_subdivision(tm, CGAL::parameters::number_of_iterations(1));
  // An inner edge collapse removes three edges and two faces.
  if(tm.number_of_faces() > triangles)
    SMS::edge_collapse(tm, SMS::Count_stop_predicate<Mesh>(triangles * 3 / 2));
  tm.collect_garbage();
  return tm;
}

inline QM::internal::Indexed_triangle_mesh indexed(const Mesh& tm)
{
  return QM::internal::make_indexed_triangle_mesh(tm, tm.points(), get(boost::vertex_index, tm),
                                                  get(boost::face_index, tm));
}

// The angles and period jumps of a smooth cross field without constraints.
inline Problem field_problem(const Mesh& tm)
{
  const QM::internal::Indexed_triangle_mesh mesh = indexed(tm);
  QM::internal::Field_problem field(mesh);
  field.find_components();
  return QM::internal::Mixed_integer_field(field).system();
}

// The map of a surface cut open, with everything that ties it together as equality constraints: the transitions across
// cuts, with integer translations, and the coordinates that are constant along aligned edges. The variables are the
// coordinates of the wedges and the translations.
inline Problem constrained_map_problem(const QM::internal::Combed_charts& charts,
                                       const QM::internal::Face_gradients& faces, const std::vector<bool>& is_singular,
                                       const std::vector<bool>& is_aligned)
{
  const QM::internal::Indexed_triangle_mesh& mesh = charts.mesh;
  const int wedges = charts.number_of_wedges();
  Problem problem(2 * wedges + 2 * static_cast<int>(charts.paths.size()));
  for(int i = 2 * wedges; i < problem.number_of_variables(); ++i)
    problem.set_integer(i);
  const auto variable = [&](int corner, int c) { return 2 * charts.wedge_of_corner[corner] + c; };
  const auto next = [](int h) { return h % 3 == 2 ? h - 2 : h + 1; };
  for(int f = 0; f < mesh.number_of_faces(); ++f)
    for(int c = 0; c < 2; ++c)
      for(int d = 0; d < 2; ++d)
      {
        Problem::Linear_form form;
        for(int k = 0; k < 3; ++k)
          form.emplace_back(variable(3 * f + k, c), faces.gradient[f](k, d));
        problem.add_squared_residual(form, c == d ? 1. : 0., faces.area[f]);
      }
  for(std::size_t p = 0; p < charts.paths.size(); ++p)
    for(int h : charts.paths[p].halfedges)
    {
      const int o = mesh.opposite[h];
      const int ends[2][2] = { { h, next(o) }, { next(h), o } }; // corners on the left and on the right
      for(const auto& end : ends)
        for(int c = 0; c < 2; ++c)
        {
          // R90: (u, v) -> (-v, u)
          const int r = charts.paths[p].rotation, from = r % 2 == 0 ? c : 1 - c;
          const double sign = r == 0 || (r == 1 && c == 1) || (r == 3 && c == 0) ? 1. : -1.;
          problem.add_equality_constraint({ { variable(end[0], from), sign },
                                            { 2 * wedges + 2 * static_cast<int>(p) + c, 1. },
                                            { variable(end[1], c), -1. } },
                                          0.);
        }
    }
  for(int h = 0; h < 3 * mesh.number_of_faces(); ++h)
  {
    if(is_singular[mesh.source(h)])
      for(int c = 0; c < 2; ++c)
        problem.set_integer(variable(h, c));
    if(!is_aligned[mesh.edge_of[h]])
      continue;
    // Where both coordinates were the identity the edge would run along one of them.
    double along[2] = { 0., 0. };
    const int f = h / 3, k = h % 3;
    const Eigen::Matrix<double, 3, 2>& g = faces.gradient[f];
    const Eigen::Matrix2d jacobian =
      (Eigen::Matrix2d() << g((k + 1) % 3, 0), g((k + 1) % 3, 1), g((k + 2) % 3, 0), g((k + 2) % 3, 1)).finished();
    const Eigen::Vector2d edge = jacobian.inverse().col(0); // rises by one from its source to its target alone
    along[0] = std::fabs(edge[0]);
    along[1] = std::fabs(edge[1]);
    const int c = along[0] > along[1] ? 1 : 0;
    problem.add_equality_constraint({ { variable(h, c), 1. }, { variable(next(h), c), -1. } }, 0.);
    problem.set_integer(variable(h, c));
    problem.set_integer(variable(next(h), c));
  }
  // One corner at the origin: else all may be moved by integers.
  problem.add_equality_constraint({ { variable(0, 0), 1. } }, 0.);
  problem.add_equality_constraint({ { variable(0, 1), 1. } }, 0.);
  return problem;
}

// The seamless map of about `quads` quads that follows the smooth cross field, features and border aligned; its
// integers are the coordinates of singularities and features and the translations across cuts. What ties the charts
// together is eliminated beforehand, or left to the solver.
inline Problem map_problem(Mesh tm, double quads, bool is_constrained = false)
{
  using namespace QM::internal;
  const double sharp_angle = 40., longest_edge = 1.5; // degrees, in quad edges
  const double length = std::sqrt(CGAL::Polygon_mesh_processing::area(tm) / quads);
  auto is_feature = tm.add_property_map<Mesh::Edge_index, bool>("e:feature", false).first;
  auto origin = tm.add_property_map<Mesh::Face_index, int>("f:origin", 0).first;
  auto angle = tm.add_property_map<Mesh::Face_index, double>("f:angle", 0.).first;
  auto jump = tm.add_property_map<Mesh::Edge_index, int>("e:period_jump", 0).first;
  auto index = tm.add_property_map<Mesh::Vertex_index, int>("v:index", 0).first;
  QM::detect_feature_edges(tm, sharp_angle, length, is_feature);
  QM::split_for_alignment(tm, tm.points(), is_feature, true, origin, longest_edge * length);
  QM::smooth_cross_field(tm, angle, jump, index,
                         CGAL::parameters::target_edge_length(length).edge_is_constrained_map(is_feature));

  const Indexed_triangle_mesh mesh = indexed(tm);
  std::vector<double> angles;
  std::vector<int> jumps;
  std::vector<bool> is_aligned, is_singular;
  for(auto f : tm.faces())
    angles.push_back(angle[f]);
  for(auto e : tm.edges())
  {
    jumps.push_back(jump[e]);
    is_aligned.push_back(is_feature[e] || tm.is_border(e));
  }
  for(auto v : tm.vertices())
    is_singular.push_back(index[v] != 0);
  const Combed_charts charts(mesh, angles, jumps, is_singular);
  const Face_gradients faces(charts, std::vector<double>(mesh.number_of_faces(), length));
  if(is_constrained)
    return constrained_map_problem(charts, faces, is_singular, is_aligned);
  const Seamless_coordinates coordinates(charts, is_singular, is_aligned);
  const Orientation_energy energy(coordinates, faces, std::vector<double>(mesh.number_of_faces(), 1.), 1.);
  Problem problem(coordinates.number_of_variables());
  problem.set_energy(energy.A, energy.b, energy.constant);
  for(int i = 0; i < coordinates.number_of_variables(); ++i)
    problem.set_integer(i, coordinates.is_integer[i]);
  return problem;
}

} // namespace mixed_integer_problems

#endif // CGAL_QUAD_MESHING_BENCHMARK_MIXED_INTEGER_PROBLEMS_H
