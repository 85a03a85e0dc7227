// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_LAYOUT_INTERNAL_LAYOUT_PARAMETERIZATION_H
#define CGAL_QUAD_MESHING_LAYOUT_INTERNAL_LAYOUT_PARAMETERIZATION_H

#include <CGAL/Quad_meshing/Layout/internal/Embedded_layout.h>
#include <CGAL/Quad_meshing/Layout/internal/Harmonic_weights.h>
#include <CGAL/Quad_meshing/Layout/internal/Layout_charts.h>

#include <CGAL/Timer.h>

#include <Eigen/Core>
#include <Eigen/LU>
#include <Eigen/SparseCore>
#include <Eigen/SparseLU>

#include <array>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The globally smooth parameterization of a layout (thesis, section 7.1).
//
// A vertex has as many places in charts as patches meet there: `copy` names them per corner of a face. Nodes are fixed.
// A vertex inside a patch has two unknowns, its place in the chart. A vertex inside an arc has two as well, (s, n)
// of `Layout_charts::Frame`, which give its places in both charts; on an aligned arc and on the border n is zero.
// Each free vertex is the weighted mean of its neighbours in the frame of the chart or the arc, (7.3).
class Layout_parameterization
{
public:
  // What is asked of the vertices of aligned arcs, which have one unknown, but two equations.
  enum class Alignment
  {
    TANGENTIAL,   // the equation along the arc holds, the one across it is dropped
    LEAST_SQUARES // both hold in the sense of least squares, all other equations exactly, (7.12)
  };

  // A place in a chart of a vertex.
  struct Copy
  {
    int vertex;
    int patch;
    int direction; // of the arc on whose left side it lies; for a node, the direction that begins there; -1 inside
  };

  std::vector<int> copy;               // per corner, a halfedge
  std::vector<Copy> copies;            //
  std::vector<Eigen::Vector2d> place;  // per copy, after a solution
  std::vector<Eigen::Vector2d> on_arc; // per vertex inside an arc: (s, n), after a solution
  std::vector<int> arc_of_vertex;      // the arc that the vertex is inside of, -1 for others
  double factorization_seconds = 0;    // processor time of all solutions so far, in so many factorizations
  int factorizations = 0;

  Layout_parameterization(const Embedded_layout& e, bool mean_value_weights)
    : m_e(e), m_mean_value(mean_value_weights), m_weights(e.mesh(), mean_value_weights)
  {
    make_copies();
  }

  // Computes the places. False if the system cannot be solved.
  bool solve(const Layout_charts& charts, const std::vector<char>& is_aligned, Alignment alignment)
  {
    number_unknowns(is_aligned);
    make_expressions(charts);
    const Indexed_triangle_mesh& m = m_e.mesh();
    Rows exact, fitted;
    for(int v = 0; v < m.number_of_vertices(); ++v)
    {
      if(m_unknown[v] == -1)
        continue;
      const int arc = arc_of_vertex[v];
      const bool has_one = m_number_of_unknowns_of[v] == 1;
      Equation equation;
      equation.rhs.setZero();
      // the frame of an arc scaled by the mean of its lengths in both charts, so that neither is preferred
      double scale = 0;
      int sides = 0;
      double weight = 0;
      for_each_corner_of_vertex(m, v,
                                [&](int h)
                                {
                                  Eigen::Matrix2d to_frame = Eigen::Matrix2d::Identity();
                                  const int d = copies[copy[h]].direction;
                                  if(arc != -1)
                                  {
                                    to_frame = m_frame[d].matrix().inverse();
                                    if(m_e.surface.direction[h] == d)
                                    {
                                      scale += m_frame[d].along.norm();
                                      ++sides;
                                    }
                                  }
                                  double w1 = m_weights.to_target(h), w2 = m_weights.to_previous(h);
                                  if(arc != -1 && m_mean_value && m_e.topology.is_border(arc))
                                  {
                                    w1 = weight_along_border(h);
                                    w2 = weight_along_border(m.prev(h));
                                  }
                                  weight += w1 + w2;
                                  add(equation, copy[m.next(h)], w1 * to_frame);
                                  add(equation, copy[m.prev(h)], w2 * to_frame);
                                  add(equation, copy[h], -(w1 + w2) * to_frame);
                                });
      const double factor = weight != 0 ? 1 / weight : 1;
      const Eigen::Vector2d row_factor(arc != -1 && sides > 0 ? factor * scale / sides : factor, factor);
      const bool is_inner_aligned = has_one && !m_e.topology.is_border(arc);
      if(!has_one)
        for(int k = 0; k < 2; ++k)
          exact.add(equation, k, row_factor[k]);
      else if(alignment == Alignment::TANGENTIAL || !is_inner_aligned)
        exact.add(equation, 0, row_factor[0]);
      else
        for(int k = 0; k < 2; ++k)
          fitted.add(equation, k, row_factor[k]);
    }
    Eigen::VectorXd x;
    if(!(fitted.number == 0 ? solve_exact(exact, x) : solve_mixed(exact, fitted, x)))
      return false;
    for(std::size_t c = 0; c < copies.size(); ++c)
      place[c] = value(m_expression[c], x);
    for(int v = 0; v < m.number_of_vertices(); ++v)
      if(arc_of_vertex[v] != -1)
      {
        const int i = m_unknown[v];
        on_arc[v] = Eigen::Vector2d(x[i], m_number_of_unknowns_of[v] == 2 ? x[i + 1] : 0.);
      }
    return true;
  }

  const Harmonic_weights& weights() const { return m_weights; }

private:
  // A place as a function of the unknowns: constant + column 0 of factor * x[first] + column 1 * x[first + 1].
  struct Expression
  {
    Eigen::Vector2d constant = Eigen::Vector2d::Zero();
    Eigen::Matrix2d factor = Eigen::Matrix2d::Zero();
    int first = -1, number = 0;
  };

  // Two rows of a linear system.
  struct Equation
  {
    std::vector<std::pair<int, Eigen::Vector2d>> terms;
    Eigen::Vector2d rhs;
  };

  struct Rows
  {
    std::vector<Eigen::Triplet<double>> entries;
    std::vector<double> rhs;
    int number = 0;

    void add(const Equation& e, int k, double factor)
    {
      for(const std::pair<int, Eigen::Vector2d>& t : e.terms)
        if(t.second[k] != 0)
          entries.emplace_back(number, t.first, factor * t.second[k]);
      rhs.push_back(factor * e.rhs[k]);
      ++number;
    }

    Eigen::SparseMatrix<double> matrix(int columns) const
    {
      Eigen::SparseMatrix<double> A(number, columns);
      A.setFromTriplets(entries.begin(), entries.end());
      return A;
    }
    Eigen::VectorXd right_side() const { return Eigen::Map<const Eigen::VectorXd>(rhs.data(), number); }
  };

  // Mean value weights need neighbours all around a vertex. On the border it becomes the mean of its two neighbours
  // there, so the map goes along the border by lengths.
  double weight_along_border(int h) const
  {
    const double length = m_e.edge_length(h);
    return m_e.mesh().opposite[h] == -1 && length > 0 ? 1 / length : 0;
  }

  static Eigen::Vector2d value(const Expression& e, const Eigen::VectorXd& x)
  {
    Eigen::Vector2d p = e.constant;
    for(int k = 0; k < e.number; ++k)
      p += e.factor.col(k) * x[e.first + k];
    return p;
  }

  void add(Equation& equation, int copy_index, const Eigen::Matrix2d& factor) const
  {
    const Expression& e = m_expression[copy_index];
    equation.rhs -= factor * e.constant;
    for(int k = 0; k < e.number; ++k)
      equation.terms.emplace_back(e.first + k, factor * e.factor.col(k));
  }

  void make_copies()
  {
    const Indexed_triangle_mesh& m = m_e.mesh();
    std::vector<char> is_node(m.number_of_vertices(), 0);
    for(int v : m_e.vertex_of_node)
      is_node[v] = 1;
    copy.assign(m.number_of_halfedges(), -1);
    arc_of_vertex.assign(m.number_of_vertices(), -1);
    for(int v = 0; v < m.number_of_vertices(); ++v)
    {
      std::vector<int> fan;
      for_each_corner_of_vertex(m, v, [&](int h) { fan.push_back(h); });
      const int n = static_cast<int>(fan.size());
      int start = 0; // a corner that begins on an arc, if there is one
      while(start < n && !m_e.surface.is_on_arc(fan[start]))
        ++start;
      for(int i = 0; i < n; ++i)
      {
        const int h = fan[(start + i) % n];
        const int d = m_e.surface.direction[h];
        if(i == 0 || d != -1)
        {
          copies.push_back(Copy{ v, m_e.patch[h / 3], d });
          if(d != -1 && !is_node[v])
            arc_of_vertex[v] = d / 2;
        }
        copy[h] = static_cast<int>(copies.size()) - 1;
      }
    }
    place.resize(copies.size());
    on_arc.assign(m.number_of_vertices(), Eigen::Vector2d::Zero());
    m_is_node.swap(is_node);
  }

  void number_unknowns(const std::vector<char>& is_aligned)
  {
    const int nv = m_e.mesh().number_of_vertices();
    m_unknown.assign(nv, -1);
    m_number_of_unknowns_of.assign(nv, 0);
    m_unknowns = 0;
    for(int v = 0; v < nv; ++v)
    {
      if(m_is_node[v] || m_e.mesh().halfedge_of_vertex[v] == -1)
        continue;
      const int arc = arc_of_vertex[v];
      m_unknown[v] = m_unknowns;
      m_number_of_unknowns_of[v] = arc != -1 && (is_aligned[arc] || m_e.topology.is_border(arc)) ? 1 : 2;
      m_unknowns += m_number_of_unknowns_of[v];
    }
  }

  void make_expressions(const Layout_charts& charts)
  {
    m_frame.resize(2 * m_e.number_of_arcs());
    for(int d = 0; d < 2 * m_e.number_of_arcs(); ++d)
      if(m_e.topology.patch_of_direction[d] != -1)
        m_frame[d] = charts.frame(d);
    m_expression.assign(copies.size(), Expression());
    for(std::size_t c = 0; c < copies.size(); ++c)
    {
      const int v = copies[c].vertex;
      Expression& e = m_expression[c];
      if(m_is_node[v])
      {
        e.constant = charts.position(copies[c].direction, 0);
        continue;
      }
      e.first = m_unknown[v];
      e.number = m_number_of_unknowns_of[v];
      e.factor.setIdentity();
      if(arc_of_vertex[v] != -1)
      {
        e.constant = m_frame[copies[c].direction].origin;
        e.factor = m_frame[copies[c].direction].matrix();
      }
    }
  }

  bool factor_and_solve(const Eigen::SparseMatrix<double>& A, const Eigen::VectorXd& b, Eigen::VectorXd& x)
  {
    if(A.rows() == 0)
    {
      x.resize(0);
      return true;
    }
    Timer timer;
    timer.start();
    Eigen::SparseLU<Eigen::SparseMatrix<double>> solver;
    solver.compute(A);
    factorization_seconds += timer.time();
    ++factorizations;
    if(solver.info() != Eigen::Success)
      return false;
    x = solver.solve(b);
    return x.allFinite();
  }

  bool solve_exact(const Rows& exact, Eigen::VectorXd& x)
  {
    return factor_and_solve(exact.matrix(m_unknowns), exact.right_side(), x);
  }

  // Minimizes |A x - b|^2 subject to B x = c, (7.12).
  bool solve_mixed(const Rows& exact, const Rows& fitted, Eigen::VectorXd& x)
  {
    const Eigen::SparseMatrix<double> A = fitted.matrix(m_unknowns), AtA = A.transpose() * A;
    const int n = m_unknowns;
    std::vector<Eigen::Triplet<double>> entries;
    for(int j = 0; j < AtA.outerSize(); ++j)
      for(Eigen::SparseMatrix<double>::InnerIterator it(AtA, j); it; ++it)
        entries.emplace_back(static_cast<int>(it.row()), j, it.value());
    for(const Eigen::Triplet<double>& t : exact.entries)
    {
      entries.emplace_back(n + t.row(), t.col(), t.value());
      entries.emplace_back(t.col(), n + t.row(), t.value());
    }
    Eigen::SparseMatrix<double> K(n + exact.number, n + exact.number);
    K.setFromTriplets(entries.begin(), entries.end());
    Eigen::VectorXd rhs(n + exact.number), y;
    rhs.head(n) = A.transpose() * fitted.right_side();
    rhs.tail(exact.number) = exact.right_side();
    if(!factor_and_solve(K, rhs, y))
      return false;
    x = y.head(n);
    return true;
  }

  const Embedded_layout& m_e;
  const bool m_mean_value;
  Harmonic_weights m_weights;
  std::vector<char> m_is_node;              // per vertex
  std::vector<int> m_unknown;               // per vertex: its first one, -1 if it has none
  std::vector<int> m_number_of_unknowns_of; // per vertex
  int m_unknowns = 0;
  std::vector<Layout_charts::Frame> m_frame; // per direction
  std::vector<Expression> m_expression;      // per copy
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_LAYOUT_INTERNAL_LAYOUT_PARAMETERIZATION_H
