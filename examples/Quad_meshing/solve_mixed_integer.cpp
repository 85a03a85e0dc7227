// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

// Minimizes 1/2 x'Ax - x'b over real and integer variables, with linear constraints, from Matrix Market or MPS files.

#include "command_line.h"

#include <CGAL/Quad_meshing/Mixed_integer/read_matrix_market.h>
#include <CGAL/Quad_meshing/Mixed_integer/read_mps.h>
#include <CGAL/Quad_meshing/Mixed_integer/solve_mixed_integer.h>

#include <Eigen/SparseCore>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <functional>
#include <iostream>
#include <limits>
#include <string>
#include <vector>

namespace QM = CGAL::Quad_meshing;

typedef Eigen::SparseMatrix<double> Matrix;

Matrix read_matrix(const std::string& filename)
{
  std::ifstream in(filename, std::ios::binary);
  if(!in)
    throw command_line::Unusable_input(filename + ": cannot be opened");
  Matrix matrix;
  std::string message;
  if(!QM::read_matrix_market(in, matrix, message))
    throw command_line::Unusable_input(filename + ": " + message);
  return matrix;
}

Eigen::VectorXd read_vector(const std::string& filename, int size)
{
  const Matrix matrix = read_matrix(filename);
  if(matrix.cols() != 1 || matrix.rows() != size)
    throw command_line::Unusable_input(filename + ": has " + std::to_string(matrix.rows()) + " x " +
                                       std::to_string(matrix.cols()) + " entries, expected " + std::to_string(size) +
                                       " x 1");
  return Eigen::VectorXd(Eigen::MatrixXd(matrix).col(0));
}

// Bounds may be infinite, which Matrix Market does not know: numbers, one per line, or inf and -inf.
std::vector<double> read_bounds(const std::string& filename, int size)
{
  std::ifstream in(filename);
  if(!in)
    throw command_line::Unusable_input(filename + ": cannot be opened");
  std::vector<double> bounds;
  std::string word;
  while(in >> word)
  {
    std::size_t length = 0;
    double value = 0.;
    try
    {
      value = std::stod(word, &length);
    }
    catch(const std::exception&)
    {
      length = 0;
    }
    if(length != word.size() || std::isnan(value))
      throw command_line::Unusable_input(filename + ": '" + word + "' is not a number");
    bounds.push_back(value);
  }
  if(static_cast<int>(bounds.size()) != size)
    throw command_line::Unusable_input(filename + ": has " + std::to_string(bounds.size()) + " numbers, expected " +
                                       std::to_string(size));
  return bounds;
}

void read_integers(const std::string& filename, QM::Mixed_integer_problem& problem)
{
  std::ifstream in(filename);
  if(!in)
    throw command_line::Unusable_input(filename + ": cannot be opened");
  std::string word;
  while(in >> word)
  {
    const bool is_number = word.find_first_not_of("0123456789") == std::string::npos && word.size() < 10;
    if(!is_number || std::stoi(word) >= problem.number_of_variables())
      throw command_line::Unusable_input(filename + ": '" + word + "' is not the index of a variable");
    problem.set_integer(std::stoi(word));
  }
}

// The rows of a matrix with their right-hand sides.
std::vector<QM::Mixed_integer_problem::Linear_constraint> read_constraints(const std::string& matrix_file,
                                                                           const std::string& rhs_file, int variables)
{
  const Matrix C = read_matrix(matrix_file);
  if(C.cols() != variables)
    throw command_line::Unusable_input(matrix_file + ": has " + std::to_string(C.cols()) + " columns, expected " +
                                       std::to_string(variables));
  const Eigen::VectorXd d = read_vector(rhs_file, static_cast<int>(C.rows()));
  std::vector<QM::Mixed_integer_problem::Linear_constraint> constraints(C.rows());
  for(int i = 0; i < C.rows(); ++i)
    constraints[i].rhs = d[i];
  for(int j = 0; j < C.cols(); ++j)
    for(Matrix::InnerIterator it(C, j); it; ++it)
      constraints[it.row()].form.emplace_back(j, it.value());
  return constraints;
}

QM::Mixed_integer_problem read_mps_file(const std::string& filename)
{
  std::ifstream in(filename);
  if(!in)
    throw command_line::Unusable_input(filename + ": cannot be opened");
  QM::Mixed_integer_problem problem;
  std::vector<std::string> names;
  std::string message;
  if(!QM::read_mps(in, problem, names, message))
    throw command_line::Unusable_input(filename + ": " + message);
  return problem;
}

QM::Mixed_integer_problem read_problem(const command_line::Arguments& args)
{
  const auto file = [&](const std::string& option) { return args.value<std::string>(option); };
  const auto demand = [&](const std::string& option, const std::string& with)
  {
    if(!args.has(option))
      throw command_line::Unusable_input("the option --" + option + " is missing" + with + " (see --help)");
  };
  if(args.has("mps"))
    return read_mps_file(file("mps"));
  demand("matrix", "");
  demand("rhs", "");
  const Matrix A = read_matrix(file("matrix"));
  const int n = static_cast<int>(A.rows());
  if(A.rows() != A.cols())
    throw command_line::Unusable_input(file("matrix") + ": the matrix is not square");
  const Matrix transposed = A.transpose();
  if(Matrix(A - transposed).norm() > 1e-12 * A.norm())
    throw command_line::Unusable_input(file("matrix") + ": the matrix is not symmetric");

  QM::Mixed_integer_problem problem(n);
  problem.set_energy(A, read_vector(file("rhs"), n));
  if(args.has("integers"))
    read_integers(file("integers"), problem);
  if(args.has("constraints"))
  {
    demand("constraints-rhs", ", with --constraints");
    for(const auto& c : read_constraints(file("constraints"), file("constraints-rhs"), n))
      problem.add_equality_constraint(c.form, c.rhs);
  }
  if(args.has("inequalities"))
  {
    demand("inequalities-rhs", ", with --inequalities");
    for(const auto& c : read_constraints(file("inequalities"), file("inequalities-rhs"), n))
      problem.add_inequality_constraint(c.form, c.rhs);
  }
  std::vector<double> lower(n, -problem.infinity()), upper(n, problem.infinity());
  if(args.has("lower"))
    lower = read_bounds(file("lower"), n);
  if(args.has("upper"))
    upper = read_bounds(file("upper"), n);
  for(int i = 0; i < n; ++i)
    problem.set_bounds(i, lower[i], upper[i]);
  return problem;
}

void write_solution(const std::string& filename, const QM::Mixed_integer_problem& problem, const Eigen::VectorXd& x)
{
  command_line::write_file(filename,
                           [&](std::ostream& out)
                           {
                             for(int i = 0; i < x.size(); ++i)
                             {
                               char text[64];
                               const bool is_whole = problem.is_integer(i) && x[i] == std::floor(x[i]);
                               std::snprintf(text, sizeof(text), is_whole ? "%.0f" : "%.17g", x[i]);
                               out << text << "\n";
                             }
                           });
}

int solve(int argc, char* argv[])
{
  std::vector<std::string> methods;
  for(int m = 0; m <= static_cast<int>(QM::Rounding_method::OUTER_APPROXIMATION); ++m)
    methods.push_back(QM::rounding_method_name(QM::Rounding_method(m)));
  std::string method_list;
  for(const std::string& m : methods)
    method_list += (method_list.empty() ? "" : ", ") + m;

  typedef std::string Text;
  po::options_description options("Options");
  options.add_options()("mps", po::value<Text>(),
                        "a problem in the MPS format, linear or convex quadratic, instead of matrices")(
    "matrix", po::value<Text>(), "symmetric matrix A (Matrix Market)")(
    "rhs", po::value<Text>(), "vector b (Matrix Market)")("integers", po::value<Text>(),
                                                          "indices of the integer variables, from 0")(
    "constraints", po::value<Text>(), "matrix C of equality constraints Cx = d (Matrix Market)")(
    "constraints-rhs", po::value<Text>(), "vector d (Matrix Market)")(
    "inequalities", po::value<Text>(), "matrix G of inequality constraints Gx <= h (Matrix Market)")(
    "inequalities-rhs", po::value<Text>(), "vector h (Matrix Market)")("lower", po::value<Text>(),
                                                                       "lower bounds, a number or -inf per variable")(
    "upper", po::value<Text>(), "upper bounds, a number or inf per variable")(
    "method", po::value<Text>()->default_value("greedy"), method_list.c_str())(
    "time-limit", po::value<double>()->default_value(1e9, "1e9"),
    "seconds after which the best solution so far is taken")(
    "node-limit", po::value<double>()->default_value(1e8, "1e8"), "nodes or subproblems that the search may visit")(
    "constraint-tolerance", po::value<double>()->default_value(1e-6, "1e-6"),
    "what counts as zero when constraints depend on each other")(
    "dense-integers", po::value<long long>()->default_value(1000),
    "up to so many integers greedy rounding works with a dense complement")(
    "bound-rounds", po::value<long long>()->default_value(0), "rounds that raise the lower bound of lattice rounding")(
    "gap", po::value<double>()->default_value(1e-9, "1e-9"), "relative gap at which branch-and-bound may stop")(
    "selection", po::value<Text>()->default_value("best-bound"), "best-bound, depth-first or best-estimate")(
    "branching", po::value<Text>()->default_value("pseudo-costs"),
    "minimum-infeasibility, maximum-infeasibility, pseudo-costs, maximum-then-minimum-infeasibility, "
    "minimum-pseudo-costs or maximum-pseudo-costs")(
    "out", po::value<Text>(), "file for the solution, one value per line")("json", po::value<Text>(),
                                                                           "file for the figures");
  command_line::add_greedy_rounding(options);
  command_line::Arguments args("solve_mixed_integer",
                               "minimizes 1/2 x'Ax - x'b over real and integer variables with linear constraints", {},
                               options);
  if(!args.parse(argc, argv))
    return command_line::done;

  const QM::Rounding_method method = QM::Rounding_method(args.choice("method", methods));
  const QM::Subproblem_selection selection =
    QM::Subproblem_selection(args.choice("selection", { "best-bound", "depth-first", "best-estimate" }));
  const QM::Branching_rule branching = QM::Branching_rule(
    args.choice("branching", { "minimum-infeasibility", "maximum-infeasibility", "pseudo-costs",
                               "maximum-then-minimum-infeasibility", "minimum-pseudo-costs", "maximum-pseudo-costs" }));
  const double time_limit = args.number("time-limit", 0., 1e9), node_limit = args.number("node-limit", 0., 1e18);
  const int bound_rounds = static_cast<int>(args.whole_number("bound-rounds", 0, 1000000));
  const double gap = args.number("gap", 0., 1.);
  const double constraint_tolerance = args.number("constraint-tolerance", 0., 1.);
  const command_line::Greedy_rounding greedy = command_line::greedy_rounding(args);
  const int dense_integers = static_cast<int>(args.whole_number("dense-integers", 0, 100000));
  for(const char* output : { "out", "json" })
    if(args.has(output))
      command_line::check_output(args.value<Text>(output));
  const QM::Mixed_integer_problem problem = read_problem(args);

  command_line::Progress_bar progress;
  const QM::Mixed_integer_solution solution =
    QM::solve_mixed_integer(problem, CGAL::parameters::rounding_method(method)
                                       .maximum_running_time(time_limit)
                                       .maximum_number_of_nodes(node_limit)
                                       .number_of_bound_rounds(bound_rounds)
                                       .relative_gap_tolerance(gap)
                                       .subproblem_selection(selection)
                                       .branching_rule(branching)
                                       .constraint_tolerance(constraint_tolerance)
                                       .rounding_tolerance(greedy.tolerance)
                                       .gauss_seidel_iterations(greedy.gauss_seidel)
                                       .conjugate_gradient_iterations(greedy.conjugate_gradient)
                                       .allow_refactorization(greedy.has_cholesky)
                                       .maximum_dense_integers(dense_integers)
                                       .visitor(std::ref(progress)));

  auto count = [](auto n, const std::string& what)
  { return command_line::count_of(static_cast<std::size_t>(n), what, what + "s"); };
  std::cout.precision(12);
  std::cout << QM::status_name(solution.status) << ": " << solution.message << "\n"
            << "energy " << solution.energy << ", lower bound " << solution.lower_bound << ", relaxed "
            << solution.relaxed_energy << "\n"
            << count(problem.number_of_variables(), "variable") << ", " << count(solution.integers, "integer") << ", "
            << count(solution.constraints, "equality constraint") << " (" << solution.redundant_constraints.size()
            << " redundant, " << solution.conflicting_constraints.size()
            << " conflicting); left after elimination: " << count(solution.free_variables, "variable") << ", "
            << count(solution.free_integers, "integer") << "\n"
            << count(solution.factorizations, "factorization") << ", " << solution.seconds << " s" << std::endl;
  if(args.has("out") && solution.x.size() == problem.number_of_variables())
    write_solution(args.value<Text>("out"), problem, solution.x);
  if(args.has("json"))
  {
    QM::Flat_json json;
    json.set("status", QM::status_name(solution.status));
    json.set("method", QM::rounding_method_name(method));
    json.set("message", solution.message);
    json.set("energy", solution.energy);
    json.set("lower_bound", solution.lower_bound);
    json.set("gap", solution.gap);
    json.set("relaxed_energy", solution.relaxed_energy);
    json.set("integers", solution.integers);
    json.set("constraints", solution.constraints);
    json.set("redundant_constraints", static_cast<int>(solution.redundant_constraints.size()));
    json.set("conflicting_constraints", static_cast<int>(solution.conflicting_constraints.size()));
    json.set("factorizations", solution.factorizations);
    json.set("dense_roundings", solution.dense_roundings);
    json.set("gauss_seidel_roundings", solution.gauss_seidel_roundings);
    json.set("conjugate_gradient_roundings", solution.conjugate_gradient_roundings);
    json.set("factorization_roundings", solution.factorization_roundings);
    json.set("nodes", solution.nodes);
    json.set("cuts", solution.cuts);
    json.set("seconds", solution.seconds);
    command_line::write_json(args.value<Text>("json"), json);
  }
  const bool is_valid = method == QM::Rounding_method::RELAXED
                          ? solution.status <= QM::Mixed_integer_status::FEASIBLE
                          : solution.is_valid() && solution.conflicting_constraints.empty();
  return is_valid ? command_line::done : command_line::not_valid;
}

int main(int argc, char* argv[])
{
  return command_line::run("solve_mixed_integer", [&] { return solve(argc, argv); });
}
