// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PARAMETERIZATION_INTERNAL_INTEGER_GRID_SOLVER_H
#define CGAL_QUAD_MESHING_PARAMETERIZATION_INTERNAL_INTEGER_GRID_SOLVER_H

#include <CGAL/Quad_meshing/Mixed_integer/Integer_energy.h>
#include <CGAL/Quad_meshing/Mixed_integer/solve_mixed_integer.h>
#include <CGAL/Quad_meshing/Parameterization/internal/Combed_charts.h>
#include <CGAL/Quad_meshing/Parameterization/internal/Cone_profile.h>
#include <CGAL/Quad_meshing/Parameterization/internal/Face_gradients.h>
#include <CGAL/Quad_meshing/Parameterization/internal/Map_optimization.h>
#include <CGAL/Quad_meshing/Parameterization/internal/Orientation_energy.h>
#include <CGAL/Quad_meshing/Parameterization/internal/Seamless_coordinates.h>
#include <CGAL/Quad_meshing/Parameterization/internal/Separated_rounding.h>
#include <CGAL/Quad_meshing/Parameterization/internal/Separations.h>
#include <CGAL/Quad_meshing/Parameterization/internal/Stiffening.h>
#include <CGAL/Quad_meshing/Parameterization/internal/T_mesh_builder.h>
#include <CGAL/Quad_meshing/Parameterization/internal/Vertex_sectors.h>
#include <CGAL/Quad_meshing/internal/Stage_progress.h>
#include <CGAL/Quad_meshing/internal/binary_unit.h>
#include <CGAL/Quad_meshing/internal/run_aside.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// From a cross field in flat arrays to an exact integer-grid map [Bom12, 8.4].
class Integer_grid_solver
{
public:
  typedef Exact_predicates_inexact_constructions_kernel::Point_2 Point_2;

  // Per vertex: `quarters` is the total angle of its corners in the map, in right angles, or -1 for a border vertex
  // that need not be aligned; `is_node` tells whether it lies on a grid point, singular or not.
  Integer_grid_solver(const Indexed_triangle_mesh& mesh, const std::vector<double>& angle,
                      const std::vector<int>& period_jump, const std::vector<int>& quarters,
                      const std::vector<bool>& is_aligned, const std::vector<double>& sizing,
                      const std::vector<bool>& is_node, unsigned int number_of_threads, Stage_progress& progress)
    : mesh(mesh)
    , is_singular(singular_vertices(mesh, quarters, is_node))
    , charts(mesh, angle, period_jump, is_singular)
    , coordinates(charts, is_singular, is_aligned)
    , faces(charts, sizing)
    , m_sectors(coordinates, quarters, is_aligned)
    , m_is_aligned(is_aligned)
    , m_sizing(sizing)
    , m_reach(m_sectors.list.size(), Cone_profile::first_reach)
    , m_sums(coordinates)
    , m_optimization(coordinates, m_sums, faces, m_sectors, progress)
    , m_progress(progress)
  {
    m_optimization.number_of_threads = number_of_threads;
  }

  int number_of_integers() const
  {
    return static_cast<int>(std::count(coordinates.is_integer.begin(), coordinates.is_integer.end(), true));
  }

  // The map without integer conditions, fold-overs removed as far as possible: where things lie before they are
  // rounded. `weight` per face: of its energy. Returns false if the energy could not be factorized.
  bool solve_seamless(const std::vector<double>& weight, double anisotropy, unsigned int stiffening_iterations)
  {
    if(!minimize_seamless(weight, anisotropy) || !m_progress.go_further())
      return false;
    Eigen::VectorXd folded_map = relaxed;
    if(untangle_seamless(relaxed))
      return true;
    // What pulls at an irregular vertex around which the map is folded is stronger than its profile, or comes from
    // farther away.
    const int most_widenings = 2; // fandisk and couplingdown at 16000 quads need no third one
    const double growth = 2;
    for(int i = 0; i < most_widenings; ++i)
    {
      if(!m_progress.go_further() || !widen_profile(growth))
        break;
      if(!minimize_seamless(weight, anisotropy) || !m_progress.go_further())
        return false;
      folded_map = relaxed;
      if(untangle_seamless(relaxed))
        return true;
    }
    stiffen(folded_map, std::vector<bool>(coordinates.number_of_variables(), false), stiffening_iterations, anisotropy);
    if(!m_progress.go_further())
      return false;
    untangle_seamless(folded_map);
    if(m_optimization.folded_faces(folded_map).size() < m_optimization.folded_faces(relaxed).size())
      relaxed = folded_map;
    folded_before_rounding = m_optimization.folded_faces(relaxed);
    return true;
  }

  // The area of the image of the seamless map: about as many quads come of it.
  double seamless_area() const
  {
    double sum = 0;
    for(int f = 0; f < mesh.number_of_faces(); ++f)
      sum += faces.area[f] * faces.jacobian(f, corner_coordinates(coordinates, f, relaxed)).determinant();
    return sum;
  }

  // The mean of (|J|^2 + |J^-1|^2) / 4 over the surface, for the multiple of the seamless map that has the least: 1 if
  // it keeps all lengths and angles.
  double seamless_distortion() const
  {
    const double largest = 100; // of a triangle; those at irregular vertices have no bound
    double area = 0, image = 0, preimage = 0;
    for(int f = 0; f < mesh.number_of_faces(); ++f)
    {
      const Eigen::Matrix2d J = faces.jacobian(f, corner_coordinates(coordinates, f, relaxed));
      const double determinant = J.determinant(), squares = J.squaredNorm();
      area += faces.area[f];
      image += faces.area[f] * squares;
      preimage += faces.area[f] * (squares < largest * square(determinant) ? squares / square(determinant) : largest);
    }
    return std::sqrt(image * preimage) / (2 * area);
  }

  // Turns the seamless map into that for target edge lengths divided by a factor: a multiple of it.
  void scale(double factor)
  {
    faces.scale(factor);
    m_reduction.scale(factor);
    relaxed *= factor;
    relaxed_energy *= factor * factor;
    m_constant *= factor * factor;
  }

  // Chooses the integers and moves the map to them. The integers are those of the least energy that the method finds,
  // changed where two things were rounded onto each other. Then the seamless map is carried to the integers without
  // ever folding; where that gets stuck, things have come together that seemed to be far enough from each other: the
  // integers are changed there too, and so on. Without repairs the first of these is tried, and nothing if two things
  // were rounded onto each other.
  void round(Rounding_method method, const std::vector<bool>& is_aligned, bool repairs)
  {
    m_is_carried = false;
    number_of_separations = number_of_broken_separations = 0;
    std::vector<int> number(coordinates.number_of_variables(), -1);
    for(std::size_t i = 0; i < m_reduction.integers().size(); ++i)
      number[m_reduction.integers()[i]] = static_cast<int>(i);
    Step_visitor visitor(m_progress);
    // The energy over the integers is a dense matrix, however many there are.
    const int few_for_a_lattice = 1000;
    const int most_dense_integers = method == Rounding_method::LATTICE ? few_for_a_lattice : m_reduction.size();
    Eigen::VectorXd z =
      solve_mixed_integer(
        m_reduction.problem(),
        parameters::rounding_method(method).maximum_dense_integers(most_dense_integers).visitor(std::ref(visitor)))
        .x;
    if(m_progress.is_stopped())
      return;

    x = m_reduction.complete(z);
    rounded_energy = m_reduction.energy(x) + m_constant;
    if(!folded_before_rounding.empty())
      return; // no order of things to be kept, nothing to be carried
    m_optimization.operations_left = most_operations;
    Separations separations(coordinates, grid_points(), is_aligned, relaxed, m_progress);
    if(!repairs)
    {
      number_of_separations = static_cast<int>(separations.list.size());
      number_of_broken_separations =
        static_cast<int>(std::count_if(separations.list.begin(), separations.list.end(),
                                       [this](const Separations::Separation& s) { return !s.holds(x); }));
      if(number_of_broken_separations == 0)
        carry();
      return;
    }
    Separated_rounding separated(m_reduction.matrix(), m_reduction.linear_term(), number);
    const int most_attempts = 8;
    std::size_t known = 0;
    for(int attempt = 0; attempt == 0 || (attempt < most_attempts && separations.list.size() > known); ++attempt)
    {
      if(!m_progress.go_further())
        return;
      known = separations.list.size();
      separated.add(separations.list);
      number_of_broken_separations = separated.improve(z, m_progress);
      x = m_reduction.complete(z);
      if(m_reduction.energy(x) > 0)
        break; // directions and lengths are worse than those of a map of everything to one point
      const Eigen::VectorXd y = carry();
      if(m_is_carried)
        break;
      separations.discover(y, 0.5); // things that came together; others are at least one unit apart
    }
    number_of_separations = static_cast<int>(separations.list.size());
    rounded_energy = m_reduction.energy(m_reduction.complete(z)) + m_constant;
  }

  // With the integers fixed, for a map that could not be carried to them: stiffening and moving vertices.
  void remove_fold_overs(unsigned int stiffening_iterations, double anisotropy)
  {
    if(m_is_carried)
      return;
    m_optimization.operations_left = most_operations;
    const Eigen::VectorXd carried =
      with_integers_of(x, relaxed + x - m_reduction.complete(m_reduction.integers_of(relaxed)));
    if(m_optimization.folded_faces(carried).size() < m_optimization.folded_faces(x).size())
      x = carried;
    stiffen(x, coordinates.is_integer, stiffening_iterations, anisotropy);
    // What did not unfold before the rounding will hardly do so after it.
    const int few_rings = 3, many_rings = 12;
    m_optimization.untangle(x, coordinates.is_integer, folded_before_rounding.empty() ? many_rings : few_rings);
  }

  // The vertices that lie on grid points whatever the real variables are: singular ones, and those where aligned
  // edges of both directions meet.
  std::vector<bool> grid_points() const
  {
    std::vector<bool> result(mesh.number_of_vertices(), false);
    for(int v = 0; v < mesh.number_of_vertices(); ++v)
    {
      if(charts.first_wedge[v] == charts.first_wedge[v + 1])
        continue;
      result[v] = true;
      for(const auto& form : coordinates.coordinates[charts.first_wedge[v]])
        for(const auto& t : form)
          if(!coordinates.is_integer[t.first])
            result[v] = false;
    }
    return result;
  }

  // Rounds the real variables to multiples of a power of two that is so small that no sum of a corner's terms and no
  // difference of corners rounds: from then on all conditions on the map hold exactly in doubles.
  void make_exact() { round_to_unit(x, coordinates.is_integer); }

  // The T-mesh of the seamless map. Its rounded lengths are those of the integers that `round()` chose.
  T_mesh t_mesh(const std::vector<bool>& is_aligned) const
  {
    T_mesh none;
    if(!folded_before_rounding.empty())
    {
      none.message = "The seamless map is folded over.";
      return none;
    }
    Eigen::VectorXd exact = relaxed;
    round_to_unit(exact, std::vector<bool>(coordinates.number_of_variables(), false));
    const auto seamless = std::make_shared<Seamless_charts>();
    seamless->mesh = mesh;
    seamless->corner = corners(exact);
    seamless->is_aligned = is_aligned;
    for(int h = 0; h < mesh.number_of_halfedges(); ++h)
      seamless->turn.push_back(
        static_cast<signed char>(mesh.opposite[h] == -1 ? 0 : Combed_charts::modulo_4(charts.quarters_across(h))));
    for(int f = 0; f < mesh.number_of_faces(); ++f)
      if(orientation(point(seamless->corner[3 * f]), point(seamless->corner[3 * f + 1]),
                     point(seamless->corner[3 * f + 2])) != LEFT_TURN)
      {
        none.message = "The seamless map has triangles without area.";
        return none;
      }
    // Lengths of closed chains depend on no real variable; those of lines that cut annuli may begin anywhere.
    return T_mesh_builder::build(seamless, corners(x.array().round().matrix()), t_mesh_nodes(is_aligned), m_progress);
  }

  Point_2 corner(int f, int k) const { return point(corner_place(3 * f + k, x)); }

  // The faces whose images are not positively oriented, decided exactly, and those around vertices that
  // the images wind around with a wrong angle; on an exact map this angle is a multiple of a right one.
  std::vector<int> folded_faces() const
  {
    std::vector<int> folded = m_optimization.folded_faces(x);
    for(int f = 0; f < mesh.number_of_faces(); ++f)
      if(orientation(corner(f, 0), corner(f, 1), corner(f, 2)) != LEFT_TURN)
        folded.push_back(f);
    std::sort(folded.begin(), folded.end());
    folded.erase(std::unique(folded.begin(), folded.end()), folded.end());
    return folded;
  }

  const Indexed_triangle_mesh& mesh;
  const std::vector<bool> is_singular;
  const Combed_charts charts;
  const Seamless_coordinates coordinates;
  Face_gradients faces;
  Eigen::VectorXd relaxed, x;
  std::vector<int> folded_before_rounding; // faces
  double relaxed_energy = 0, rounded_energy = 0;
  int number_of_separations = 0, number_of_broken_separations = 0;

private:
  const Vertex_sectors m_sectors;
  const std::vector<bool> m_is_aligned;
  const std::vector<double> m_sizing;
  std::vector<double> m_reach; // per sector: of the cone profile, in target edge lengths
  const Shared_sums m_sums;    // the coordinates
  Map_optimization m_optimization;
  Stage_progress& m_progress;
  Integer_energy m_reduction;
  double m_constant = 0;
  bool m_is_carried = false;
  // For each of the two repairs: carrying to the integers, after the rounding. Where creases cut nearly every triangle
  // no amount of work helps.
  static constexpr double most_operations = 1e10;

  // The minimum of the energy without integer conditions. Returns false if it could not be factorized.
  bool minimize_seamless(const std::vector<double>& weight, double anisotropy)
  {
    struct Reduction
    {
      Reduction(const Integer_grid_solver& s, const Cone_profile& profile, const std::vector<double>& weight,
                double anisotropy)
        : energy(s.charts, s.m_sums, Face_gradients(s.charts, profile.sizing), profile.weighted(weight), anisotropy,
                 &s.m_progress)
        , is_integer(s.coordinates.is_integer)
      {
      }

      Orientation_energy energy;
      std::vector<bool> is_integer;
      Integer_energy result;
      bool is_done = false;
    };
    const Cone_profile profile(mesh, m_sectors, m_is_aligned, m_sizing, m_reach);
    const auto data = std::make_shared<Reduction>(*this, profile, weight, anisotropy);
    const Orientation_energy& energy = data->energy;
    if(!m_progress.go_further() ||
       !run_aside(coordinates.number_of_variables(), m_progress, data,
                  [](Reduction& r) { r.is_done = r.result.compute(r.energy.A, r.energy.b, r.is_integer); }) ||
       !data->is_done)
      return false;
    m_reduction = std::move(data->result);
    relaxed = m_reduction.complete(m_reduction.target());
    if(!relaxed.allFinite())
      return false;
    m_constant = energy.constant;
    relaxed_energy = m_reduction.energy(relaxed) + m_constant;
    return true;
  }

  // The profiles of the irregular sectors that are nearest to each part of the map that is folded reach farther by a
  // factor. Returns whether there are any.
  bool widen_profile(double factor)
  {
    const std::vector<int> folded = m_optimization.folded_faces(relaxed);
    std::vector<bool> is_folded(mesh.number_of_faces(), false), is_wider(m_sectors.list.size(), false);
    for(int f : folded)
      is_folded[f] = true;
    std::vector<int> seen_from(mesh.number_of_faces(), -1);
    for(int seed : folded)
    {
      if(seen_from[seed] != -1)
        continue;
      // All of the part, then around it, ring by ring.
      std::vector<int> front(1, seed), ring;
      seen_from[seed] = seed;
      while(!front.empty())
      {
        bool is_found = false;
        for(std::size_t i = 0; i < front.size(); ++i)
          for(int h = 3 * front[i]; h < 3 * front[i] + 3; ++h)
          {
            const int s = m_sectors.sector_of_corner[h], g = mesh.opposite[h] == -1 ? -1 : mesh.opposite[h] / 3;
            if(s != -1 && m_sectors.list[s].is_irregular)
              is_found = is_wider[s] = true;
            if(g == -1 || seen_from[g] == seed)
              continue;
            seen_from[g] = seed;
            (is_folded[g] ? front : ring).push_back(g);
          }
        if(is_found)
          break;
        front.clear();
        front.swap(ring);
      }
    }
    for(std::size_t s = 0; s < is_wider.size(); ++s)
      if(is_wider[s])
        m_reach[s] *= factor;
    return std::find(is_wider.begin(), is_wider.end(), true) != is_wider.end();
  }

  bool untangle_seamless(Eigen::VectorXd& y)
  {
    const double operations_of_a_try = 1e9; // of maps with wider and wider profiles there may be several
    m_optimization.operations_left = operations_of_a_try;
    // Translations move everything along the cuts: such steps are costly.
    const int few_rings = 3, more_rings = 6, few_steps = 40;
    return m_optimization.untangle(y, coordinates.is_integer, few_rings) ||
           m_optimization.untangle(y, std::vector<bool>(coordinates.number_of_variables(), false), more_rings,
                                   few_steps);
  }

  // Takes the seamless map to the integers of x, and returns how far it came; there, it becomes x.
  Eigen::VectorXd carry()
  {
    const Eigen::VectorXd start = m_reduction.complete(m_reduction.integers_of(relaxed));
    Eigen::VectorXd y = relaxed;
    m_is_carried = m_optimization.carry(y, x - start, coordinates.is_integer);
    if(m_is_carried)
      x = with_integers_of(x, y);
    return y;
  }

  Chart_point corner_place(int h, const Eigen::VectorXd& y) const
  {
    const int w = charts.wedge_of_corner[h];
    return { { coordinates.value(w, 0, y), coordinates.value(w, 1, y) } };
  }

  static Point_2 point(const Chart_point& p) { return Point_2(p[0], p[1]); }

  std::vector<Chart_point> corners(const Eigen::VectorXd& y) const
  {
    std::vector<Chart_point> result;
    for(int h = 0; h < mesh.number_of_halfedges(); ++h)
      result.push_back(corner_place(h, y));
    return result;
  }

  // Per vertex: irregular ones, other grid points, and where aligned edges end, branch or turn.
  std::vector<bool> t_mesh_nodes(const std::vector<bool>& is_aligned) const
  {
    std::vector<bool> result = grid_points();
    std::vector<int> aligned_edges(mesh.number_of_vertices(), 0);
    for(int e = 0; e < mesh.number_of_edges(); ++e)
      if(is_aligned[e])
        for(int v : { mesh.source(mesh.halfedge_of_edge[e]), mesh.target(mesh.halfedge_of_edge[e]) })
          ++aligned_edges[v];
    for(const Vertex_sectors::Sector& s : m_sectors.list)
      if(s.is_irregular)
        result[s.vertex] = true;
    for(int v = 0; v < mesh.number_of_vertices(); ++v)
      if(aligned_edges[v] != 0 && aligned_edges[v] != 2)
        result[v] = true;
    return result;
  }

  void round_to_unit(Eigen::VectorXd& y, const std::vector<bool>& is_fixed) const
  {
    double largest = 1;
    for(int w = 0; w < charts.number_of_wedges(); ++w)
      for(int c = 0; c < 2; ++c)
      {
        double sum = 0;
        for(const auto& t : coordinates.coordinates[w][c])
          sum += std::abs(t.second * y[t.first]);
        largest = (std::max)(largest, sum);
      }
    const int significant_bits = 48;
    const double unit = binary_unit(largest, significant_bits);
    for(int i = 0; i < coordinates.number_of_variables(); ++i)
      if(!is_fixed[i])
        y[i] = std::round(y[i] / unit) * unit;
  }

  Eigen::VectorXd with_integers_of(const Eigen::VectorXd& y, Eigen::VectorXd z) const
  {
    for(int i : m_reduction.integers())
      z[i] = y[i];
    return z;
  }

  // Weights the energy anew and minimizes it over the variables that are not fixed, as long as there are fold-overs;
  // `y` becomes the map with the fewest, for more weight can make things worse.
  void stiffen(Eigen::VectorXd& y, const std::vector<bool>& is_fixed, unsigned int iterations, double anisotropy)
  {
    Stiffening stiffening(coordinates, faces);
    Eigen::VectorXd z = y;
    std::size_t fewest = m_optimization.folded_faces(y).size();
    std::vector<int> number(is_fixed.size(), -1), variables;
    for(std::size_t i = 0; i < is_fixed.size(); ++i)
      if(!is_fixed[i])
      {
        number[i] = static_cast<int>(variables.size());
        variables.push_back(static_cast<int>(i));
      }
    struct Factorization
    {
      Eigen::SparseMatrix<double> matrix;
      Sparse_cholesky<double> solver;
      bool is_done = false;
    };
    const auto data = std::make_shared<Factorization>();
    for(unsigned int i = 0; i < iterations && fewest > 0 && m_progress.go_further(); ++i)
    {
      stiffening.update_weights(z);
      if(!m_progress.go_further())
        return;
      Orientation_energy energy(charts, m_sums, faces, stiffening.weight, anisotropy, number,
                                static_cast<int>(variables.size()), y, &m_progress);
      data->matrix.swap(energy.A);
      if(!m_progress.go_further() ||
         !run_aside(static_cast<int>(variables.size()), m_progress, data,
                    [](Factorization& f)
                    { f.is_done = f.solver.factorize(f.matrix); }) || // the pattern is analyzed the first time
         !data->is_done)
        return;
      const Eigen::VectorXd free = data->solver.solve(energy.b);
      if(!m_progress.go_further())
        return;
      for(std::size_t k = 0; k < variables.size(); ++k)
        z[variables[k]] = free[k];
      const std::size_t n = m_optimization.folded_faces(z).size();
      if(n < fewest)
      {
        fewest = n;
        y = z;
      }
    }
  }

  // Nodes count as singular: they lie on grid points as well, and charts are cut at them.
  static std::vector<bool> singular_vertices(const Indexed_triangle_mesh& mesh, const std::vector<int>& quarters,
                                             const std::vector<bool>& is_node)
  {
    std::vector<bool> on_border(mesh.number_of_vertices(), false), result(mesh.number_of_vertices(), false);
    for(int h = 0; h < mesh.number_of_halfedges(); ++h)
      if(mesh.opposite[h] == -1)
        on_border[mesh.source(h)] = on_border[mesh.target(h)] = true;
    for(int v = 0; v < mesh.number_of_vertices(); ++v)
      result[v] = quarters[v] != -1 && (is_node[v] || quarters[v] != (on_border[v] ? 2 : 4));
    return result;
  }
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_PARAMETERIZATION_INTERNAL_INTEGER_GRID_SOLVER_H
