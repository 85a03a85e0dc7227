// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_LAYOUT_INTERNAL_LAYOUT_DISTORTION_IMPL_H
#define CGAL_QUAD_MESHING_LAYOUT_INTERNAL_LAYOUT_DISTORTION_IMPL_H

#include <CGAL/Quad_meshing/Layout/Layout_distortion.h>
#include <CGAL/Quad_meshing/Layout/Layout_weights.h>
#include <CGAL/Quad_meshing/Layout/Motorcycle_complex.h>
#include <CGAL/Quad_meshing/Linear_algebra/Sparse_cholesky.h>
#include <CGAL/Quad_meshing/internal/Dual_lines.h>
#include <CGAL/Quad_meshing/internal/Indexed_quad_mesh.h>
#include <CGAL/Quad_meshing/internal/Quad_vertex_rules.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The quadratic form of the lengths, and the system that sets it up.
struct Layout_distortion::Form
{
  Form(const Indexed_quad_mesh& mesh, const Motorcycle_complex& complex, const Quad_vertex_rules& rules,
       const std::vector<char>& is_fixed, Any_visitor& visitor)
    : m_mesh(mesh), m_complex(complex)
  {
    number_unknowns(rules, is_fixed);
    const int n = m_number_of_unknowns, arcs = static_cast<int>(complex.arcs.size());
    m_form = Eigen::MatrixXd::Zero(arcs, arcs);
    std::vector<Eigen::Triplet<double>> matrix, coupling;
    for(int i = 0; i < n; ++i)
      matrix.emplace_back(i, i, regularization);
    const Cell_matrix cell = cell_matrix();
    for(const Motorcycle_complex::Patch& p : complex.patches)
      if(visitor.go_further())
        add(p, cell, matrix, coupling);
    Eigen::SparseMatrix<double> A(n, n), B(n, arcs);
    A.setFromTriplets(matrix.begin(), matrix.end());
    B.setFromTriplets(coupling.begin(), coupling.end());
    Sparse_cholesky<double> solver;
    if(visitor.go_further() && solver.compute(A) && visitor.go_further())
    {
      Eigen::MatrixXd product;
      solver.product_with_inverse(B, product);
      m_form -= product;
    }
    m_form /= m_mesh.number_of_faces();

    Eigen::VectorXd lengths(arcs);
    for(int a = 0; a < arcs; ++a)
      lengths[a] = complex.arcs[a].length();
    m_form_of_input = m_form * lengths;
    m_distortion_of_nothing = lengths.dot(m_form_of_input);
    find_sides();
  }

  double distortion(const std::vector<int>& length) const
  {
    Eigen::VectorXd n(length.size());
    for(std::size_t a = 0; a < length.size(); ++a)
      n[a] = length[a];
    const double nn = n.dot(m_form.selfadjointView<Eigen::Lower>() * n), nl = n.dot(m_form_of_input);
    return m_distortion_of_nothing - (nl > 0 ? nl * nl / nn : 0);
  }

  std::vector<double> prices(const std::vector<int>& length) const
  {
    Eigen::VectorXd n(length.size());
    for(std::size_t a = 0; a < length.size(); ++a)
      n[a] = length[a];
    Eigen::VectorXd g = m_form * n;
    g = g * (n.dot(m_form_of_input) / n.dot(g)) - m_form_of_input;
    g -= m_sides.transpose() * m_solver.solve(Eigen::VectorXd(m_sides * g));
    const double mean = g.lpNorm<1>() / g.size();
    if(mean > 0)
      g /= mean;
    return std::vector<double>(g.data(), g.data() + g.size());
  }

private:
  typedef Eigen::Matrix<double, 8, 8> Cell_matrix;

  // The energy of the displacements of the corners of a square, x and y of corner 0, then of corner 1, ..: mean over
  // the corners.
  static Cell_matrix cell_matrix()
  {
    typedef Eigen::Matrix<double, 8, 1> Row;
    Cell_matrix sum = Cell_matrix::Zero();
    for(int k = 0; k < 4; ++k)
    {
      // the edge along x and the one along y at this corner, from their first corners to their second
      const int x0 = k < 2 ? 0 : 3, x1 = k < 2 ? 1 : 2, y0 = k == 0 || k == 3 ? 0 : 1, y1 = k == 0 || k == 3 ? 3 : 2;
      auto difference = [](int from, int to, int coordinate)
      {
        Row r = Row::Zero();
        r[2 * to + coordinate] += 1;
        r[2 * from + coordinate] -= 1;
        return r;
      };
      const Row a = difference(x0, x1, 0), c = difference(x0, x1, 1), b = difference(y0, y1, 0),
                d = difference(y0, y1, 1);
      auto add_square = [&](const Row& r, double weight) { sum += weight / 4 * r * r.transpose(); };
      add_square(b + c, 1);
      add_square(a - d, Layout_weights::stretch);
      add_square(a + d, Layout_weights::size);
      add_square(b - c, Layout_weights::rotation);
    }
    return sum;
  }

  // The equations that opposite sides have the same length.
  void find_sides()
  {
    std::vector<Eigen::Triplet<double>> entries;
    int row = 0;
    for(const Motorcycle_complex::Patch& p : m_complex.patches)
      for(int k = 0; k < 2; ++k, ++row)
      {
        for(const Motorcycle_complex::Piece& s : p.sides[k])
          entries.emplace_back(row, s.arc, 1);
        for(const Motorcycle_complex::Piece& s : p.sides[k + 2])
          entries.emplace_back(row, s.arc, -1);
      }
    m_sides.resize(row, static_cast<int>(m_complex.arcs.size()));
    m_sides.setFromTriplets(entries.begin(), entries.end());
    Eigen::SparseMatrix<double> squared = m_sides * m_sides.transpose();
    for(int i = 0; i < row; ++i)
      squared.coeffRef(i, i) += regularization;
    m_solver.compute(squared);
  }

  // Each vertex has the frame in which its first halfedge points along x.
  void number_unknowns(const Quad_vertex_rules& rules, const std::vector<char>& is_fixed)
  {
    m_direction.assign(m_mesh.number_of_halfedges(), 0);
    m_unknown.assign(m_mesh.number_of_vertices(), { { -1, -1 } });
    m_number_of_unknowns = 0;
    for(int v = 0; v < m_mesh.number_of_vertices(); ++v)
    {
      const int first = m_mesh.halfedge_of_vertex[v];
      if(first == -1)
        continue;
      bool may_move[2] = { true, true };
      int h = first, direction = 0;
      do
      {
        m_direction[h] = direction % 4;
        if(m_mesh.is_feature[h] || m_mesh.is_border(h))
          may_move[1 - direction % 2] = false;
        h = m_mesh.next_around_source(h);
        ++direction;
      }
      while(h != -1 && h != first);
      if(is_fixed[v] || rules.is_special[v] || is_irregular(m_mesh, v))
        may_move[0] = may_move[1] = false;
      for(int i = 0; i < 2; ++i)
        if(may_move[i])
          m_unknown[v][i] = m_number_of_unknowns++;
    }
  }

  // The unknown, and its sign, that is coordinate i at the source of h in a frame in which h points in direction k.
  std::pair<int, int> unknown(int h, int k, int i) const
  {
    // coordinates turn into each other: x = (1, 0), -y, -x, y
    const int turn = (k - m_direction[h] + 4) % 4, j = i ^ (turn & 1);
    const int sign = i == 0 ? (turn == 1 || turn == 2 ? -1 : 1) : (turn == 2 || turn == 3 ? -1 : 1);
    return std::make_pair(m_unknown[m_mesh.source(h)][j], sign);
  }

  // What is done in one rectangle.
  void add(const Motorcycle_complex::Patch& p, const Cell_matrix& cell, std::vector<Eigen::Triplet<double>>& matrix,
           std::vector<Eigen::Triplet<double>>& coupling)
  {
    std::array<int, 5> first = { { 0, 0, 0, 0, 0 } };
    std::vector<int> arcs;
    for(int k = 0; k < 4; ++k)
    {
      for(const Motorcycle_complex::Piece& s : p.sides[k])
        arcs.push_back(s.arc);
      first[k + 1] = static_cast<int>(arcs.size());
    }
    const int n = first[4], w = p.width, h = p.height;
    // per side: how far each point along it moves when its arcs get longer by one
    std::array<Eigen::MatrixXd, 4> moved;
    for(int k = 0; k < 4; ++k)
    {
      moved[k] = Eigen::MatrixXd::Zero((k % 2 == 0 ? w : h) + 1, n);
      int at = 0;
      for(int i = first[k]; i < first[k + 1]; ++i)
      {
        const int length = m_complex.arcs[arcs[i]].length();
        for(int j = 1; j < moved[k].rows() - at; ++j)
          moved[k](at + j, i) = (std::min)(1., double(j) / length);
        at += length;
      }
      // sides 2 and 3 run against the coordinates
      if(k >= 2)
        moved[k] = (moved[k].row(at).replicate(at + 1, 1) - moved[k].colwise().reverse()).eval();
    }
    // x and y of each vertex of the rectangle, as linear forms
    auto displacement = [&](int i, int j)
    {
      Eigen::Matrix<double, 2, Eigen::Dynamic> result(2, n);
      result.row(0) = (1 - double(j) / h) * moved[0].row(i) + double(j) / h * moved[2].row(i);
      result.row(1) = (1 - double(i) / w) * moved[3].row(j) + double(i) / w * moved[1].row(j);
      return result;
    };

    std::vector<Eigen::Matrix<double, 2, Eigen::Dynamic>> below(w + 1), above(w + 1);
    for(int i = 0; i <= w; ++i)
      above[i] = displacement(i, 0);
    Eigen::MatrixXd form = Eigen::MatrixXd::Zero(n, n), corners(8, n), forces(8, n);
    const Motorcycle_complex::Piece& s = p.sides[0][0];
    const std::vector<int>& halfedges = m_complex.arcs[s.arc].halfedges;
    int row = s.forward ? halfedges.front() : m_mesh.opposite[halfedges.back()];
    for(int j = 0; j < h; ++j)
    {
      below.swap(above);
      for(int i = 0; i <= w; ++i)
        above[i] = displacement(i, j + 1);
      int g = row;
      for(int i = 0; i < w; ++i)
      {
        corners << below[i], below[i + 1], above[i + 1], above[i];
        forces.noalias() = cell * corners;
        form.noalias() += corners.transpose() * forces;
        std::array<std::pair<int, int>, 8> u;
        for(int k = 0, q = g; k < 4; ++k, q = m_mesh.next(q))
        {
          u[2 * k] = unknown(q, k, 0);
          u[2 * k + 1] = unknown(q, k, 1);
        }
        for(int r = 0; r < 8; ++r)
          if(u[r].first != -1)
          {
            for(int c = 0; c < 8; ++c)
              if(u[c].first != -1 && u[c].first <= u[r].first)
                matrix.emplace_back(u[r].first, u[c].first, u[r].second * u[c].second * cell(r, c));
            for(int a = 0; a < n; ++a)
              if(forces(r, a) != 0)
                coupling.emplace_back(u[r].first, arcs[a], u[r].second * forces(r, a));
          }
        if(i + 1 < w)
          g = m_mesh.next(m_mesh.opposite[m_mesh.next(g)]);
      }
      if(j + 1 < h)
        row = m_mesh.opposite[m_mesh.across(row)];
    }
    for(int a = 0; a < n; ++a)
      for(int b = 0; b < n; ++b)
        m_form(arcs[a], arcs[b]) += form(a, b);
  }

  const Indexed_quad_mesh& m_mesh;
  const Motorcycle_complex& m_complex;
  std::vector<int> m_direction;              // per halfedge: its direction in the frame of its source
  std::vector<std::array<int, 2>> m_unknown; // per vertex: x and y, -1 where it cannot move
  int m_number_of_unknowns = 0;
  Eigen::MatrixXd m_form;
  Eigen::VectorXd m_form_of_input;     // its product with the lengths of the input
  double m_distortion_of_nothing = 0;  // when all arcs have the length 0
  Eigen::SparseMatrix<double> m_sides; // the differences of the lengths of opposite sides
  Sparse_cholesky<double> m_solver;    // of its square
};

CGAL_QUAD_MESHING_INLINE
Layout_distortion::Layout_distortion(const Indexed_quad_mesh& mesh, const Motorcycle_complex& complex,
                                     const Quad_vertex_rules& rules, const std::vector<char>& is_fixed,
                                     Any_visitor& visitor)
  : m_form(new Form(mesh, complex, rules, is_fixed, visitor))
{
}

CGAL_QUAD_MESHING_INLINE Layout_distortion::Layout_distortion(Layout_distortion&& other) = default;

CGAL_QUAD_MESHING_INLINE Layout_distortion::~Layout_distortion() = default;

CGAL_QUAD_MESHING_INLINE double Layout_distortion::operator()(const std::vector<int>& length) const
{
  return m_form->distortion(length);
}

CGAL_QUAD_MESHING_INLINE std::vector<double> Layout_distortion::prices(const std::vector<int>& length) const
{
  return m_form->prices(length);
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_LAYOUT_INTERNAL_LAYOUT_DISTORTION_IMPL_H
