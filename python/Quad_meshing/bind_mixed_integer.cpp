// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#include "bindings.h"
#include "numpy_meshes.h"

#include <CGAL/Quad_meshing/Mixed_integer/solve_mixed_integer.h>

#include <pybind11/eigen.h>

#include <stdexcept>

namespace py = pybind11;
namespace QM = CGAL::Quad_meshing;

namespace {

typedef Eigen::MatrixXd Matrix;
typedef Eigen::VectorXd Vector;

// A row of a matrix without its zeros.
QM::Mixed_integer_problem::Linear_form form_of(const Matrix& m, Eigen::Index row)
{
  QM::Mixed_integer_problem::Linear_form form;
  for(Eigen::Index j = 0; j < m.cols(); ++j)
    if(m(row, j) != 0)
      form.emplace_back(static_cast<int>(j), m(row, j));
  return form;
}

void check_rows(const std::string& names, const std::optional<Matrix>& m, const std::optional<Vector>& v,
                Eigen::Index n)
{
  if(m.has_value() != v.has_value() || (m && (m->cols() != n || m->rows() != v->size())))
    throw std::invalid_argument(names + " must have the shapes (k, n) and (k,)");
}

QM::Mixed_integer_solution solve(const Matrix& A, const Vector& b, const std::vector<int>& integers,
                                 const std::optional<Matrix>& C, const std::optional<Vector>& d,
                                 const std::optional<Matrix>& G, const std::optional<Vector>& h,
                                 const std::optional<Vector>& lower, const std::optional<Vector>& upper,
                                 const std::optional<std::string>& method, const std::optional<double>& time_limit)
{
  const Eigen::Index n = b.size();
  if(A.rows() != n || A.cols() != n)
    throw std::invalid_argument("A and b must have the shapes (n, n) and (n,)");
  if(!A.allFinite() || !b.allFinite() || A != A.transpose())
    throw std::invalid_argument("A must be symmetric, A and b finite");
  check_rows("C and d", C, d, n);
  check_rows("G and h", G, h, n);
  if((lower && lower->size() != n) || (upper && upper->size() != n))
    throw std::invalid_argument("lower and upper must have the shape (n,)");
  QM::Mixed_integer_problem problem(static_cast<int>(n));
  problem.set_energy(Eigen::SparseMatrix<double>(A.sparseView()), b);
  for(int i : integers)
  {
    if(i < 0 || i >= n)
      throw std::invalid_argument("integers: there is no variable " + std::to_string(i));
    problem.set_integer(i);
  }
  for(Eigen::Index i = 0; C && i < C->rows(); ++i)
    problem.add_equality_constraint(form_of(*C, i), (*d)[i]);
  for(Eigen::Index i = 0; G && i < G->rows(); ++i)
    problem.add_inequality_constraint(form_of(*G, i), (*h)[i]);
  const double infinity = std::numeric_limits<double>::infinity();
  for(Eigen::Index i = 0; (lower || upper) && i < n; ++i)
    problem.set_bounds(static_cast<int>(i), lower ? (*lower)[i] : -infinity, upper ? (*upper)[i] : infinity);

  const QM::Rounding_method methods[] = { QM::Rounding_method::DIRECT, QM::Rounding_method::GREEDY,
                                          QM::Rounding_method::LATTICE, QM::Rounding_method::BRANCH_AND_BOUND };
  const std::string word = method ? *method : G || lower || upper ? "branch-and-bound" : "greedy";
  const QM::Rounding_method rounding =
    methods[numpy_meshes::choice("method", word, { "direct", "greedy", "lattice", "branch-and-bound" })];
  if(time_limit)
    numpy_meshes::check_positive("time_limit", *time_limit);
  py::gil_scoped_release unlock;
  return QM::solve_mixed_integer(
    problem, CGAL::parameters::rounding_method(rounding).maximum_running_time(time_limit ? *time_limit : infinity));
}

} // namespace

void bind_mixed_integer(py::module_& module)
{
  typedef QM::Mixed_integer_solution Solution;
  py::class_<Solution>(module, "MixedIntegerSolution", "The answer of solve_mixed_integer().")
    .def_property_readonly("is_valid", &Solution::is_valid, "Whether x meets all conditions that do not contradict.")
    .def_property_readonly(
      "status", [](const Solution& s) { return std::string(QM::status_name(s.status)); },
      "'optimal', 'feasible', 'infeasible', 'unbounded' and so on.")
    .def_readonly("message", &Solution::message, "How it ended, as a sentence.")
    .def_readonly("x", &Solution::x, "The solution, shape (n,); of size 0 if there is none. Integers are exact.")
    .def_readonly("energy", &Solution::energy, "The energy at x.")
    .def_readonly("relaxed_energy", &Solution::relaxed_energy, "The least energy without integer conditions.")
    .def_readonly("lower_bound", &Solution::lower_bound, "A proven lower bound of the energy of all solutions.")
    .def_readonly("gap", &Solution::gap, "The relative gap between energy and lower bound.")
    .def_readonly("redundant_constraints", &Solution::redundant_constraints, "Rows of C that follow from others.")
    .def_readonly("conflicting_constraints", &Solution::conflicting_constraints, "Rows of C that contradict others.")
    .def_readonly("seconds", &Solution::seconds, "The time it took.");

  module.def("solve_mixed_integer", &solve, py::arg("A"), py::arg("b"), py::arg("integers") = std::vector<int>(),
             py::kw_only(), py::arg("C") = py::none(), py::arg("d") = py::none(), py::arg("G") = py::none(),
             py::arg("h") = py::none(), py::arg("lower") = py::none(), py::arg("upper") = py::none(),
             py::arg("method") = py::none(), py::arg("time_limit") = py::none(),
             R"(Minimizes x'Ax/2 - x'b where C x = d, G x <= h, lower <= x <= upper and some variables are integers.

A: (n, n), symmetric and positive semidefinite; b: (n,). integers: numbers of variables. C: (k, n), d: (k,); G and h
likewise. lower, upper: (n,), infinite where there is no bound.
method: 'direct', 'greedy', 'lattice' or 'branch-and-bound'; only the last one takes G, h and bounds. By default greedy,
or branch-and-bound where it is needed. time_limit: in seconds. Returns a MixedIntegerSolution.)");
}
