// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_MIXED_INTEGER_READ_MPS_H
#define CGAL_QUAD_MESHING_MIXED_INTEGER_READ_MPS_H

#include <CGAL/Quad_meshing/Mixed_integer/Mixed_integer_problem.h>

#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <istream>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Reads the sections of an MPS file one after the other.
class Mps_reader
{
  typedef std::vector<std::string> Words;

  // lower <= form <= upper
  struct Row
  {
    char kind; // E, L, G
    double rhs = 0., range = 0.;
    bool has_range = false;
    Mixed_integer_problem::Linear_form form;
  };

  struct Column
  {
    bool is_integer;
    double lower = 0., upper = Mixed_integer_problem::infinity(), cost = 0.;
    bool has_lower = false; // one that was given
  };

public:
  bool read(std::istream& in, Mixed_integer_problem& problem, std::vector<std::string>& names, std::string& message)
  {
    std::string line, section;
    for(int number = 1; std::getline(in, line); ++number)
    {
      std::istringstream stream(line);
      Words words;
      for(std::string word; stream >> word;)
        words.push_back(word);
      if(words.empty() || line[0] == '*')
        continue;
      const bool is_header = line[0] != ' ' && line[0] != '\t';
      if(is_header)
      {
        section = words[0];
        if(section == "ENDATA")
        {
          fill(problem);
          names = m_names;
          return true;
        }
        if(section == "OBJSENSE" && words.size() > 1)
          set_sense(words[1]);
      }
      else if(!read_line(section, words))
        m_complaint = m_complaint.empty() ? "it cannot be understood" : m_complaint;
      if(!m_complaint.empty())
      {
        message = "line " + std::to_string(number) + ": " + m_complaint;
        return false;
      }
    }
    message = "the line ENDATA is missing";
    return false;
  }

private:
  bool read_line(const std::string& section, const Words& words)
  {
    if(section == "ROWS")
      return words.size() == 2 && add_row(words[0], words[1]);
    if(section == "COLUMNS")
      return add_entries(words);
    if(section == "RHS" || section == "RANGES")
      return set_sides(words, section == "RANGES");
    if(section == "BOUNDS")
      return set_bound(words);
    if(section == "QUADOBJ" || section == "QMATRIX")
      return words.size() == 3 && add_product(words, section == "QUADOBJ");
    if(section == "OBJSENSE")
    {
      set_sense(words[0]);
      return true;
    }
    m_complaint = "the section '" + section + "' is not known";
    return false;
  }

  void set_sense(const std::string& word) { m_sign = (word == "MAX" || word == "MAXIMIZE") ? -1. : 1.; }

  bool number(const std::string& word, double& value)
  {
    std::size_t length = 0;
    try
    {
      value = std::stod(word, &length);
    }
    catch(const std::exception&)
    {
      length = 0;
    }
    if(length != word.size() || std::isnan(value))
      m_complaint = "'" + word + "' is not a number";
    return m_complaint.empty();
  }

  bool add_row(const std::string& kind, const std::string& name)
  {
    const int objective = -1, ignored = -2;
    if(kind == "N")
    {
      m_row_of[name] = m_has_objective ? ignored : objective;
      m_has_objective = true;
      return true;
    }
    if(kind != "E" && kind != "L" && kind != "G")
      return false;
    m_row_of[name] = static_cast<int>(m_rows.size());
    m_rows.push_back(Row());
    m_rows.back().kind = kind[0];
    return true;
  }

  bool find_row(const std::string& name, int& row)
  {
    const std::map<std::string, int>::const_iterator it = m_row_of.find(name);
    if(it == m_row_of.end())
      m_complaint = "there is no row '" + name + "'";
    else
      row = it->second;
    return m_complaint.empty();
  }

  bool find_column(const std::string& name, int& column)
  {
    const std::map<std::string, int>::const_iterator it = m_column_of.find(name);
    if(it == m_column_of.end())
      m_complaint = "there is no column '" + name + "'";
    else
      column = it->second;
    return m_complaint.empty();
  }

  bool add_entries(const Words& words)
  {
    if(words.size() >= 3 && words[1] == "'MARKER'")
    {
      m_is_integer = words[2] == "'INTORG'";
      return m_is_integer || words[2] == "'INTEND'";
    }
    if(words.size() != 3 && words.size() != 5)
      return false;
    const std::pair<std::map<std::string, int>::iterator, bool> place =
      m_column_of.insert(std::make_pair(words[0], static_cast<int>(m_columns.size())));
    if(place.second)
    {
      m_columns.push_back(Column());
      m_columns.back().is_integer = m_is_integer;
      m_names.push_back(words[0]);
    }
    const int column = place.first->second;
    for(std::size_t k = 1; k < words.size(); k += 2)
    {
      int row = 0;
      double value = 0.;
      if(!find_row(words[k], row) || !number(words[k + 1], value))
        return false;
      if(row >= 0)
        m_rows[row].form.emplace_back(column, value);
      else if(row == -1)
        m_columns[column].cost += value;
    }
    return true;
  }

  bool set_sides(const Words& words, bool is_range)
  {
    // The name of the set may be missing.
    for(std::size_t k = words.size() % 2; k + 1 < words.size(); k += 2)
    {
      int row = 0;
      double value = 0.;
      if(!find_row(words[k], row) || !number(words[k + 1], value))
        return false;
      if(row == -1)
        m_constant = -value;
      else if(row >= 0 && is_range)
      {
        m_rows[row].range = value;
        m_rows[row].has_range = true;
      }
      else if(row >= 0)
        m_rows[row].rhs = value;
    }
    return words.size() >= 2;
  }

  bool set_bound(const Words& words)
  {
    const std::string& kind = words[0];
    const bool has_value = kind == "UP" || kind == "LO" || kind == "FX" || kind == "UI" || kind == "LI";
    const std::size_t with_set = has_value ? 4 : 3, place = words.size() >= with_set ? 2 : 1;
    int index = 0;
    if(words.size() < with_set - 1 || !find_column(words[place], index))
      return false;
    Column& column = m_columns[index];
    double value = 0.;
    if(has_value && !number(words[place + 1], value))
      return false;
    const double infinite = 1e30; // by custom
    value = value >= infinite    ? Mixed_integer_problem::infinity()
            : value <= -infinite ? -Mixed_integer_problem::infinity()
                                 : value;
    if(kind == "UI" || kind == "LI" || kind == "BV")
      column.is_integer = true;
    if(kind == "UP" || kind == "UI")
    {
      column.upper = value;
      if(value < 0. && !column.has_lower)
        column.lower = -Mixed_integer_problem::infinity();
    }
    else if(kind == "LO" || kind == "LI")
    {
      column.lower = value;
      column.has_lower = true;
    }
    else if(kind == "FX")
      column.lower = column.upper = value;
    else if(kind == "FR" || kind == "MI")
    {
      column.lower = -Mixed_integer_problem::infinity();
      column.upper = kind == "FR" ? Mixed_integer_problem::infinity() : column.upper;
    }
    else if(kind == "BV")
    {
      column.lower = 0.;
      column.upper = 1.;
    }
    else if(kind == "PL")
      column.upper = Mixed_integer_problem::infinity();
    else
      m_complaint = "the bound '" + kind + "' is not known";
    return m_complaint.empty();
  }

  bool add_product(const Words& words, bool is_triangle)
  {
    int i = 0, j = 0;
    double value = 0.;
    if(!find_column(words[0], i) || !find_column(words[1], j) || !number(words[2], value))
      return false;
    m_products.emplace_back(i, j, value);
    if(is_triangle && i != j)
      m_products.emplace_back(j, i, value);
    return true;
  }

  void fill(Mixed_integer_problem& problem) const
  {
    const int n = static_cast<int>(m_columns.size());
    problem = Mixed_integer_problem(n);
    Eigen::VectorXd b(n);
    for(int i = 0; i < n; ++i)
    {
      problem.set_integer(i, m_columns[i].is_integer);
      problem.set_bounds(i, m_columns[i].lower, m_columns[i].upper);
      b[i] = -m_sign * m_columns[i].cost;
    }
    Eigen::SparseMatrix<double> A(n, n);
    A.setFromTriplets(m_products.begin(), m_products.end());
    problem.set_energy(m_sign * A, b, m_sign * m_constant);
    for(const Row& row : m_rows)
    {
      const double width = std::fabs(row.range);
      double lower = row.rhs, upper = row.rhs;
      if(row.kind == 'L')
        lower = row.has_range ? row.rhs - width : -Mixed_integer_problem::infinity();
      else if(row.kind == 'G')
        upper = row.has_range ? row.rhs + width : Mixed_integer_problem::infinity();
      else if(row.has_range)
        (row.range < 0. ? lower : upper) += row.range;
      if(lower == upper)
      {
        problem.add_equality_constraint(row.form, row.rhs);
        continue;
      }
      Mixed_integer_problem::Linear_form opposite = row.form;
      for(std::pair<int, double>& a : opposite)
        a.second = -a.second;
      if(upper < Mixed_integer_problem::infinity())
        problem.add_inequality_constraint(row.form, upper);
      if(lower > -Mixed_integer_problem::infinity())
        problem.add_inequality_constraint(opposite, -lower);
    }
  }

  std::map<std::string, int> m_row_of, m_column_of;
  std::vector<Row> m_rows;
  std::vector<Column> m_columns;
  std::vector<std::string> m_names;
  std::vector<Eigen::Triplet<double>> m_products;
  double m_constant = 0., m_sign = 1.;
  bool m_has_objective = false, m_is_integer = false;
  std::string m_complaint;
};

} // namespace internal

/*!
\ingroup PkgQuadMeshingMixedIntegerRef

\brief reads a linear or convex quadratic mixed-integer problem in the MPS format.

Known are the sections `NAME`, `OBJSENSE`, `ROWS`, `COLUMNS` with its integer markers, `RHS`, `RANGES`, `BOUNDS`, and
for quadratic objectives `QUADOBJ` (one triangle) and `QMATRIX` (the whole matrix). Names must not contain spaces. The
first row of kind N is the objective; a problem that maximizes becomes one that minimizes the opposite. Integer
variables have no upper bound but what is given; a negative upper bound takes the lower bound zero away unless a lower
bound was given before.

\param in the stream to read from
\param problem receives the problem; unchanged if reading fails
\param names receives the names of the variables; unchanged if reading fails
\param message receives one sentence that says what is wrong if reading fails

\return whether a problem was read
*/
inline bool read_mps(std::istream& in, Mixed_integer_problem& problem, std::vector<std::string>& names,
                     std::string& message)
{
  return internal::Mps_reader().read(in, problem, names, message);
}

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_MIXED_INTEGER_READ_MPS_H
