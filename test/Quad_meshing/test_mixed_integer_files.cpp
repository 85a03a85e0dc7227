// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

// Problems from MPS files, and the same optima as GLPK and Cbc find, where these are installed.

#include "mixed_integer_checks.h"
#include "test_cases.h"

#include <CGAL/Quad_meshing/Mixed_integer/read_mps.h>

#include <CGAL/Random.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <limits>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

bool read(const std::string& text, Problem& problem, std::vector<std::string>& names)
{
  std::istringstream in(text);
  std::string message;
  const bool ok = QM::read_mps(in, problem, names, message);
  assert(ok == message.empty());
  return ok;
}

void mps()
{
  const std::string text = "* a comment\n"
                           "NAME small\n"
                           "ROWS\n N cost\n L few\n G many\n E same\n N unused\n"
                           "COLUMNS\n"
                           " M1 'MARKER' 'INTORG'\n"
                           " x cost 1 few 1\n x many 1 unused 7\n"
                           " M2 'MARKER' 'INTEND'\n"
                           " y cost 2 few 1\n y same -1\n"
                           " z cost -1 same 1\n"
                           "RHS\n side few 4 many 1\n side same 0.5 cost -3\n"
                           "RANGES\n range few 2.5\n"
                           "BOUNDS\n UP limit x 4\n LO limit y -1\n UP limit y 1\n FR limit z\n"
                           "QUADOBJ\n y y 2\n"
                           "ENDATA\n";
  Problem problem;
  std::vector<std::string> names;
  assert(read(text, problem, names));
  assert(names == std::vector<std::string>({ "x", "y", "z" }));
  assert(problem.is_integer(0) && !problem.is_integer(1) && problem.number_of_integers() == 1);
  assert(problem.upper_bound(0) == 4. && problem.lower_bound(1) == -1. &&
         problem.lower_bound(2) == -problem.infinity());
  assert(problem.equality_constraints().size() == 1 && problem.inequality_constraints().size() == 3);
  // x + 2 y - z + y^2 + 3 with z = y + 0.5, 1.5 <= x + y <= 4, x >= 1: y^2 + y + x + 2.5, x = 2, y = -0.5.
  for(Method method : { Method::BRANCH_AND_BOUND, Method::BRANCH_AND_CUT })
  {
    const Solution s = QM::solve_mixed_integer(problem, params::rounding_method(method));
    assert(s.status == Status::OPTIMAL && s.x[0] == 2. && std::fabs(s.x[1] + 0.5) < 1e-6 &&
           std::fabs(s.energy - 4.25) < 1e-9);
  }
  assert(read("OBJSENSE\n MAX\nROWS\n N c\nCOLUMNS\n x c 3\nBOUNDS\n UP b x 5\nENDATA\n", problem, names));
  assert(QM::solve_mixed_integer(problem).energy == -15.);

  for(const char* wrong :
      { "", "NAME x\n", "ROWS\n N c\nCOLUMNS\n x d 1\nENDATA\n", "ROWS\n N c\nCOLUMNS\n x c one\nENDATA\n",
        "ROWS\n X c\nENDATA\n", "ROWS\n N c\nBOUNDS\n UP b y 1\nENDATA\n", "SOS\n x\nENDATA\n" })
  {
    assert(!read(wrong, problem, names));
    assert(names.size() == 1); // as it was
  }
}

// Integers with bounds, some reals, a few rows.
Problem random_program(CGAL::Random& random)
{
  const int n = random.get_int(2, 9);
  Problem problem(n);
  Eigen::VectorXd b(n);
  for(int i = 0; i < n; ++i)
  {
    problem.set_integer(i, random.get_int(0, 4) > 0);
    const double low = random.get_int(-3, 2);
    problem.set_bounds(i, low, low + random.get_int(1, 8));
    b[i] = random.get_int(-20, 21);
  }
  problem.set_energy(Eigen::SparseMatrix<double>(n, n), b);
  for(int c = random.get_int(1, 5); c > 0; --c)
  {
    Problem::Linear_form form;
    for(int i = 0; i < n; ++i)
      form.emplace_back(i, random.get_int(-9, 20));
    problem.add_inequality_constraint(form, random.get_int(-10, 60));
  }
  return problem;
}

void write_mps(const Problem& problem, const std::string& filename)
{
  std::ofstream out(filename);
  out.precision(17);
  const std::size_t rows = problem.inequality_constraints().size();
  out << "NAME random FREE\nROWS\n N cost\n";
  for(std::size_t r = 0; r < rows; ++r)
    out << " L r" << r << "\n";
  out << "COLUMNS\n";
  for(int i = 0; i < problem.number_of_variables(); ++i)
  {
    if(problem.is_integer(i))
      out << " M" << i << " 'MARKER' 'INTORG'\n";
    out << " x" << i << " cost " << -problem.linear_term()[i] << "\n";
    for(std::size_t r = 0; r < rows; ++r)
      for(const std::pair<int, double>& a : problem.inequality_constraints()[r].form)
        if(a.first == i)
          out << " x" << i << " r" << r << " " << a.second << "\n";
    if(problem.is_integer(i))
      out << " N" << i << " 'MARKER' 'INTEND'\n";
  }
  out << "RHS\n";
  for(std::size_t r = 0; r < rows; ++r)
    out << " side r" << r << " " << problem.inequality_constraints()[r].rhs << "\n";
  out << "BOUNDS\n";
  for(int i = 0; i < problem.number_of_variables(); ++i)
    out << " LO limit x" << i << " " << problem.lower_bound(i) << "\n UP limit x" << i << " " << problem.upper_bound(i)
        << "\n";
  out << "ENDATA\n";
}

// Another solver, which says what it found in a file: the optimum, infinity if there is no feasible point.
struct Other_solver
{
  std::string name, version, command;
  std::string optimum;                 // what precedes it
  std::vector<std::string> infeasible; // what says that there is none
};

bool is_installed(const Other_solver& solver)
{
  return std::system((solver.version + " > other_version.txt 2>&1").c_str()) == 0;
}

double optimum_of(const Other_solver& solver)
{
  assert(std::system((solver.command + " > other_log.txt 2>&1").c_str()) == 0);
  std::ifstream in("other_solution.txt");
  std::stringstream text;
  text << in.rdbuf();
  for(const std::string& words : solver.infeasible)
    if(text.str().find(words) != std::string::npos)
      return std::numeric_limits<double>::infinity();
  const std::size_t place = text.str().find(solver.optimum);
  assert(place != std::string::npos);
  return std::stod(text.str().substr(place + solver.optimum.size()));
}

void other_solvers()
{
  const Other_solver solvers[] = { { "GLPK",
                                     "glpsol --version",
                                     "glpsol --freemps random.mps -o other_solution.txt",
                                     "cost = ",
                                     { "INTEGER EMPTY", "INTEGER UNDEFINED" } },
                                   { "Cbc",
                                     "cbc -quit",
                                     "cbc random.mps solve solution other_solution.txt",
                                     "objective value",
                                     { "Infeasible", "infeasible" } } };
  for(const Other_solver& solver : solvers)
  {
    if(!is_installed(solver))
    {
      std::cout << "  " << solver.name << " is not installed" << std::endl;
      continue;
    }
    CGAL::Random random(4);
    int feasible = 0;
    const int problems = 50;
    for(int p = 0; p < problems; ++p)
    {
      const Problem problem = random_program(random);
      write_mps(problem, "random.mps");
      std::ifstream in("random.mps");
      Problem again;
      std::vector<std::string> names;
      std::string message;
      assert(QM::read_mps(in, again, names, message));
      const double best = optimum_of(solver);
      const bool is_feasible = std::isfinite(best);
      feasible += is_feasible;
      for(Method method : { Method::BRANCH_AND_BOUND, Method::BRANCH_AND_CUT, Method::CUTTING_PLANES })
      {
        const Solution s = QM::solve_mixed_integer(
          again, params::rounding_method(method).maximum_running_time(20.).maximum_number_of_nodes(
                   method == Method::CUTTING_PLANES ? 200 : 20000));
        if(s.status == Status::LIMIT_REACHED || s.status == Status::FEASIBLE)
        {
          assert(method == Method::CUTTING_PLANES); // which need not end with real variables
          continue;
        }
        assert(s.status == (is_feasible ? Status::OPTIMAL : Status::INFEASIBLE));
        assert(!is_feasible || std::fabs(s.energy - best) < 1e-4 * (1. + std::fabs(best)));
      }
    }
    std::cout << "  " << solver.name << ": " << problems << " problems, " << feasible << " of them feasible"
              << std::endl;
    assert(feasible > problems / 2);
  }
}

// Small instances of kinds that public collections hold, with their optima, which a dynamic program or all
// assignments give.
Problem read(const std::string& text)
{
  Problem problem;
  std::vector<std::string> names;
  const bool is_read = read(text, problem, names);
  assert(is_read);
  return problem;
}

const Method exact_methods[] = { Method::BRANCH_AND_BOUND, Method::BRANCH_AND_CUT };

// A knapsack of 20 binary variables.
void knapsack()
{
  CGAL::Random random(2);
  const int n = 20, capacity = 300;
  std::vector<int> weight(n), value(n);
  std::vector<int> best(capacity + 1, 0);
  std::ostringstream mps;
  mps << "NAME knapsack\nROWS\n N value\n L weight\nCOLUMNS\n M1 'MARKER' 'INTORG'\n";
  for(int i = 0; i < n; ++i)
  {
    weight[i] = random.get_int(10, 90);
    value[i] = weight[i] + random.get_int(-5, 25);
    mps << " x" << i << " value " << -value[i] << " weight " << weight[i] << "\n";
    for(int w = capacity; w >= weight[i]; --w)
      best[w] = (std::max)(best[w], best[w - weight[i]] + value[i]);
  }
  mps << " M2 'MARKER' 'INTEND'\nRHS\n r weight " << capacity << "\nBOUNDS\n";
  for(int i = 0; i < n; ++i)
    mps << " BV b x" << i << "\n";
  mps << "ENDATA\n";
  const Problem problem = read(mps.str());
  for(Method method : exact_methods)
  {
    const Solution s = QM::solve_mixed_integer(problem, params::rounding_method(method));
    assert(s.status == Status::OPTIMAL && s.energy == -best[capacity]);
  }
}

// An assignment of six workers to six tasks, with equality rows.
void assignment()
{
  CGAL::Random random(3);
  const int n = 6;
  std::vector<std::vector<int>> cost(n, std::vector<int>(n));
  std::ostringstream mps;
  mps << "NAME assignment\nROWS\n N cost\n";
  for(int i = 0; i < n; ++i)
    mps << " E w" << i << "\n E t" << i << "\n";
  mps << "COLUMNS\n M1 'MARKER' 'INTORG'\n";
  for(int i = 0; i < n; ++i)
    for(int j = 0; j < n; ++j)
    {
      cost[i][j] = random.get_int(1, 50);
      mps << " x" << i << j << " cost " << cost[i][j] << " w" << i << " 1\n x" << i << j << " t" << j << " 1\n";
    }
  mps << " M2 'MARKER' 'INTEND'\nRHS\n";
  for(int i = 0; i < n; ++i)
    mps << " r w" << i << " 1 t" << i << " 1\n";
  mps << "BOUNDS\n";
  for(int i = 0; i < n; ++i)
    for(int j = 0; j < n; ++j)
      mps << " BV b x" << i << j << "\n";
  mps << "ENDATA\n";
  std::vector<int> permutation(n);
  for(int i = 0; i < n; ++i)
    permutation[i] = i;
  int best = 1000000;
  do
  {
    int sum = 0;
    for(int i = 0; i < n; ++i)
      sum += cost[i][permutation[i]];
    best = (std::min)(best, sum);
  }
  while(std::next_permutation(permutation.begin(), permutation.end()));
  const Problem problem = read(mps.str());
  for(Method method : exact_methods)
  {
    const Solution s = QM::solve_mixed_integer(problem, params::rounding_method(method));
    assert(s.status == Status::OPTIMAL && s.energy == best);
  }
}

// Facilities that may be opened, for customers that each send one real unit: all sets of facilities are tried.
void facilities()
{
  CGAL::Random random(6);
  const int facilities = 6, customers = 8;
  std::vector<int> fixed(facilities);
  std::vector<std::vector<int>> way(facilities, std::vector<int>(customers));
  std::ostringstream mps;
  mps << "NAME facilities\nROWS\n N cost\n";
  for(int c = 0; c < customers; ++c)
    mps << " E c" << c << "\n";
  for(int f = 0; f < facilities; ++f)
    for(int c = 0; c < customers; ++c)
      mps << " L o" << f << c << "\n";
  mps << "COLUMNS\n";
  for(int f = 0; f < facilities; ++f)
  {
    fixed[f] = random.get_int(20, 60);
    mps << " M" << f << " 'MARKER' 'INTORG'\n y" << f << " cost " << fixed[f] << "\n";
    for(int c = 0; c < customers; ++c)
      mps << " y" << f << " o" << f << c << " -1\n";
    mps << " N" << f << " 'MARKER' 'INTEND'\n";
    for(int c = 0; c < customers; ++c)
    {
      way[f][c] = random.get_int(1, 40);
      mps << " x" << f << c << " cost " << way[f][c] << " c" << c << " 1\n x" << f << c << " o" << f << c << " 1\n";
    }
  }
  mps << "RHS\n";
  for(int c = 0; c < customers; ++c)
    mps << " r c" << c << " 1\n";
  mps << "BOUNDS\n";
  for(int f = 0; f < facilities; ++f)
    mps << " BV b y" << f << "\n";
  mps << "ENDATA\n";
  int best = 1000000;
  for(int set = 1; set < (1 << facilities); ++set)
  {
    int sum = 0;
    for(int f = 0; f < facilities; ++f)
      sum += (set >> f & 1) * fixed[f];
    for(int c = 0; c < customers; ++c)
    {
      int nearest = 1000;
      for(int f = 0; f < facilities; ++f)
        if(set >> f & 1)
          nearest = (std::min)(nearest, way[f][c]);
      sum += nearest;
    }
    best = (std::min)(best, sum);
  }
  const Problem problem = read(mps.str());
  for(Method method : exact_methods)
  {
    const Solution s = QM::solve_mixed_integer(problem, params::rounding_method(method));
    assert(s.status == Status::OPTIMAL && std::fabs(s.energy - best) < 1e-9 * best);
  }
}

int main(int argc, char** argv)
{
  return run_cases(argc, argv,
                   {
                     { "mps", mps },
                     { "knapsack", knapsack },
                     { "assignment", assignment },
                     { "facilities", facilities },
                     { "other_solvers", other_solvers },
                   });
}
