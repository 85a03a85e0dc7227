// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_GENERAL_METHODS_H
#define CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_GENERAL_METHODS_H

#include <CGAL/Quad_meshing/Mixed_integer/Integer_energy.h>
#include <CGAL/Quad_meshing/Mixed_integer/Mixed_integer_problem.h>
#include <CGAL/Quad_meshing/Mixed_integer/Mixed_integer_solution.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/Bounded_problem.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/Branch_and_bound.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/Branch_and_cut.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/Convex_quadratic.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/Dense_greedy_rounding.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/Integer_energy_impl.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/Reduced_problem.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/Search_limits.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/Solver_options.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/Unbounded_ray.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The general methods for convex problems [Bom12, Ch. 4]: branch-and-bound, branch-and-cut, cutting planes, outer
// approximation.
//
// A problem without a ray along which its energy falls for ever has a minimum; with one it is unbounded if there is a
// feasible point.
class General_methods
{
  typedef CGAL::Exact_rational Rational;

public:
  // What became of the problem; without a solution, the status and the message say why.
  struct Outcome
  {
    bool is_found = false, is_proven = false;
    Eigen::VectorXd z; // the free variables
    Mixed_integer_status status = Mixed_integer_status::NUMERICAL_FAILURE;
    std::string message;
  };

  General_methods(const Mixed_integer_problem& problem, const Eliminated_constraints& constraints,
                  const Reduced_problem& reduced, const Solver_options& options,
                  const Sparse_cholesky<double>& linear_solver, Search_limits& limits, Mixed_integer_solution& solution)
    : m_problem(problem)
    , m_reduced(reduced)
    , m_options(options)
    , m_limits(limits)
    , m_solution(solution)
    , m_go_further([&limits] { return limits.go_further(); })
    , m_bounded(Bounded_problem_builder(problem, constraints).run())
    , m_schur(linear_solver)
  {
  }

  Outcome run()
  {
    if(m_bounded.is_infeasible)
      return failure(Mixed_integer_status::INFEASIBLE, "A bound contradicts the other constraints.");
    double largest = 0.;
    for(int j = 0; j < m_reduced.A.cols(); ++j)
      for(Eigen::SparseMatrix<double>::InnerIterator it(m_reduced.A, j); it; ++it)
        largest = (std::max)(largest, std::fabs(it.value()));
    return largest == 0. ? minimize_linear() : minimize_quadratic();
  }

private:
  // Bounds that stand in for missing ones: beyond the numbers of the problem by these powers of two, one after the
  // other as long as the result depends on them. Small boxes have short numbers, and few corners far away.
  static const std::vector<int>& box_exponents()
  {
    static const std::vector<int> exponents = { 4, 12, 40, 80, 160 };
    return exponents;
  }

  // A search that may leave a larger gap reports the bound it has proven, not the energy.
  static constexpr double proof_tolerance = 1e-6;
  static constexpr int cut_rounds = 5;

  static Outcome failure(Mixed_integer_status status, const std::string& message)
  {
    Outcome outcome;
    outcome.status = status;
    outcome.message = message;
    return outcome;
  }

  Rational box(int exponent) const
  {
    double largest = 1.;
    for(int i = 0; i < m_bounded.size(); ++i)
    {
      if(m_bounded.has_lower(i))
        largest = (std::max)(largest, std::fabs(m_bounded.lower[i]));
      if(m_bounded.has_upper(i))
        largest = (std::max)(largest, std::fabs(m_bounded.upper[i]));
    }
    for(int r = 0; r < m_bounded.h.size(); ++r)
      largest = (std::max)(largest, std::fabs(m_bounded.h[r]));
    return Rational(std::exp2(std::ceil(std::log2(largest)))) * Rational(std::exp2(exponent));
  }

  // Runs a search with larger and larger boxes until its result does not depend on them.
  template <typename Search>
  Search_result run_in_boxes(const Search& search)
  {
    Search_result result;
    for(int exponent : box_exponents())
    {
      result = search(box(exponent));
      if(!result.rests_on_box || !m_go_further())
        break;
    }
    if(result.rests_on_box)
    {
      result.is_complete = false;
      result.lower_bound = -std::numeric_limits<double>::infinity();
    }
    return result;
  }

  Outcome minimize_linear()
  {
    const Eigen::VectorXd c = -subvector(m_reduced.b, m_bounded.kept);
    bool is_unbounded = false;
    std::vector<char> is_kept(m_reduced.size(), 0);
    for(int v : m_bounded.kept)
      is_kept[v] = 1;
    for(int v = 0; v < m_reduced.size(); ++v)
      is_unbounded = is_unbounded || (!is_kept[v] && m_reduced.b[v] != 0.);
    const int size = m_bounded.size();
    const Flat_directions directions(Eigen::MatrixXd::Zero(size, size), Eigen::VectorXd::Ones(size));
    if(is_unbounded || has_unbounded_ray(m_bounded, -c, directions))
      return look_for_any_point();
    remove_idle_integers(c, directions);
    const Eigen::VectorXd active_c = subvector(c, m_active);

    const Search_result result = run_in_boxes(
      [&](const Rational& box)
      {
        const Linear_master master(m_bounded, active_c, m_reduced.constant, box);
        Exact_dual_simplex relaxation = master.make_program();
        if(relaxation.solve(m_go_further) && !relaxation.rests_on_artificial_bounds())
          m_solution.relaxed_energy = m_reduced.constant + CGAL::to_double(relaxation.objective());
        if(m_options.method == Rounding_method::CUTTING_PLANES)
          return cutting_planes(master, m_options, m_go_further);
        const int rounds = m_options.method == Rounding_method::BRANCH_AND_BOUND ? 0 : cut_rounds;
        return Branch_and_cut(master, m_options, rounds, m_go_further).run(Eigen::VectorXd(), 0.);
      });
    Outcome outcome = outcome_of(result);
    if(outcome.is_found)
    {
      outcome.z = Eigen::VectorXd::Zero(m_reduced.size());
      for(int i = 0; i < m_bounded.size(); ++i)
        outcome.z[m_bounded.kept[i]] = result.y[i];
    }
    return outcome;
  }

  // The energy falls for ever along a ray, from any feasible point.
  Outcome look_for_any_point()
  {
    const Eigen::VectorXd nothing = Eigen::VectorXd::Zero(m_bounded.size());
    const Search_result result = run_in_boxes(
      [&](const Rational& box)
      {
        const Linear_master master(m_bounded, nothing, 0., box);
        Search_result found = Branch_and_cut(master, m_options, cut_rounds, m_go_further).run(Eigen::VectorXd(), 0.);
        found.rests_on_box = found.rests_on_box && !found.is_found;
        return found;
      });
    if(result.is_found)
      return failure(Mixed_integer_status::UNBOUNDED, "The energy is unbounded below.");
    return outcome_of(result);
  }

  Outcome minimize_quadratic()
  {
    if(m_options.method == Rounding_method::CUTTING_PLANES)
      return failure(Mixed_integer_status::UNSUPPORTED_PROBLEM,
                     "Cutting planes alone need a linear objective; outer approximation takes convex ones.");
    // The other variables follow from those that matter to the search.
    std::vector<bool> is_kept(m_reduced.size(), false);
    for(int v : m_bounded.kept)
      is_kept[v] = true;
    const bool is_reduced = m_schur.reduce(m_reduced.A, m_reduced.b, is_kept);
    m_solution.factorizations += m_schur.number_of_factorizations();
    const Eigen::VectorXd reference = subvector(m_reduced.A.diagonal(), m_bounded.kept);
    if(!is_reduced)
      return failure(Mixed_integer_status::NUMERICAL_FAILURE,
                     "A factorization failed: the energy is not convex where the constraints hold.");
    Convex_quadratic quadratic(m_schur.matrix(), m_schur.linear_term(), m_reduced.constant + m_schur.constant(),
                               reference);
    if(!quadratic.is_convex())
      return failure(Mixed_integer_status::NUMERICAL_FAILURE,
                     "A factorization failed: the energy is not convex where the constraints hold.");
    const Flat_directions directions =
      quadratic.is_definite()
        ? Flat_directions(Eigen::MatrixXd(), Eigen::VectorXd())
        : Flat_directions(quadratic.matrix(), Convex_quadratic::scale_of(quadratic.matrix(), reference));
    if(has_slope_in_reals() ||
       (quadratic.has_slope() && has_unbounded_ray(m_bounded, quadratic.linear_term(), directions)))
      return look_for_any_point();
    const int size = m_bounded.size();
    remove_idle_integers(quadratic.linear_term(), directions);

    Outcome outcome;
    if(m_bounded.size() == 0)
    {
      outcome.is_found = true;
      outcome.z = m_schur.complete(Eigen::VectorXd::Zero(size));
      m_solution.relaxed_energy = m_solution.lower_bound = m_reduced.energy(outcome.z);
      return outcome;
    }
    Search_result result;
    if(m_bounded.size() == size)
      result = search(quadratic);
    else
    {
      Eigen::MatrixXd S(m_active.size(), m_active.size());
      for(std::size_t i = 0; i < m_active.size(); ++i)
        for(std::size_t j = 0; j < m_active.size(); ++j)
          S(i, j) = quadratic.matrix()(m_active[i], m_active[j]);
      Convex_quadratic active(S, subvector(quadratic.linear_term(), m_active), quadratic.constant(),
                              subvector(reference, m_active));
      result = search(active);
    }
    outcome = outcome_of(result);
    if(outcome.is_found)
    {
      Eigen::VectorXd y = Eigen::VectorXd::Zero(size);
      for(std::size_t i = 0; i < m_active.size(); ++i)
        y[m_active[i]] = result.y[i];
      outcome.z = m_schur.complete(y);
    }
    return outcome;
  }

  // Sets the integers that need not move to zero; the others are `m_active`.
  void remove_idle_integers(const Eigen::VectorXd& c, const Flat_directions& directions)
  {
    const std::vector<char> is_idle = idle_integers(m_bounded, c, directions);
    m_active.clear();
    for(int i = 0; i < m_bounded.size(); ++i)
      if(!is_idle[i])
        m_active.push_back(i);
    if(static_cast<int>(m_active.size()) < m_bounded.size())
      m_bounded = m_bounded.restricted(m_active);
  }

  // Whether the energy falls along a flat direction of the variables that do not matter to the search: the shift that
  // made their singular matrix invertible then leaves a residual.
  bool has_slope_in_reals() const
  {
    const double relative_residual = 1e-6;
    if(m_schur.reals().empty())
      return false;
    const Eigen::VectorXd z = m_schur.complete(Eigen::VectorXd::Zero(m_bounded.size()));
    const Eigen::VectorXd residual = m_reduced.A * z - m_reduced.b;
    double largest = 0.;
    for(int v : m_schur.reals())
      largest = (std::max)(largest, std::fabs(residual[v]));
    return largest > relative_residual * m_reduced.b.cwiseAbs().maxCoeff();
  }

  Search_result search(Convex_quadratic& quadratic)
  {
    Eigen::VectorXd incumbent;
    double radius = std::numeric_limits<double>::infinity(), incumbent_energy = radius;
    if(!m_problem.has_inequalities() && quadratic.is_definite())
    {
      Eigen::MatrixXd factor;
      factorize_dense(quadratic.matrix(), factor);
      incumbent = dense_greedy_rounding(factor, quadratic.target(), m_limits);
      incumbent_energy = quadratic.energy(incumbent);
      radius = incumbent_energy - quadratic.energy(quadratic.target());
    }
    Branch_and_bound branch_and_bound(m_bounded, quadratic, m_options, m_go_further);
    const double relaxed = branch_and_bound.relaxed_energy();
    if(relaxed == std::numeric_limits<double>::infinity())
    {
      Search_result infeasible;
      infeasible.is_complete = true;
      return infeasible;
    }
    if(std::isfinite(relaxed))
      m_solution.relaxed_energy = relaxed;
    if(m_options.method == Rounding_method::BRANCH_AND_BOUND)
      return branch_and_bound.run(incumbent, incumbent_energy);
    return run_in_boxes(
      [&](const Rational& box)
      {
        const Linear_master master(m_bounded, quadratic, radius, relaxed, box);
        if(m_options.method == Rounding_method::OUTER_APPROXIMATION)
          return outer_approximation(master, m_options, incumbent, incumbent_energy, m_go_further);
        return Branch_and_cut(master, m_options, cut_rounds, m_go_further).run(incumbent, incumbent_energy);
      });
  }

  Outcome outcome_of(const Search_result& result)
  {
    m_solution.nodes = result.nodes;
    m_solution.cuts = result.cuts;
    if(!result.is_found && result.is_complete)
      return failure(Mixed_integer_status::INFEASIBLE,
                     "No point meets all constraints, bounds and integer conditions.");
    m_solution.lower_bound = result.lower_bound;
    if(!result.is_found)
      return failure(Mixed_integer_status::LIMIT_REACHED,
                     m_limits.is_out_of_time() ? "The time limit was met before a feasible solution was found."
                                               : "A limit was met before a feasible solution was found.");
    Outcome outcome;
    outcome.is_found = true;
    outcome.is_proven = result.is_complete && m_options.relative_gap_tolerance <= proof_tolerance;
    return outcome;
  }

  const Mixed_integer_problem& m_problem;
  const Reduced_problem& m_reduced;
  const Solver_options& m_options;
  Search_limits& m_limits;
  Mixed_integer_solution& m_solution;
  const std::function<bool()> m_go_further;
  Bounded_problem m_bounded;
  std::vector<int> m_active; // of the variables that the bounded problem had first, those that it still has
  Integer_energy m_schur;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_GENERAL_METHODS_H
