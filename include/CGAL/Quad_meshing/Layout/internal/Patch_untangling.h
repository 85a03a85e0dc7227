// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_LAYOUT_INTERNAL_PATCH_UNTANGLING_H
#define CGAL_QUAD_MESHING_LAYOUT_INTERNAL_PATCH_UNTANGLING_H

#include <CGAL/Quad_meshing/Layout/internal/Embedded_layout.h>
#include <CGAL/Quad_meshing/Layout/internal/Harmonic_weights.h>
#include <CGAL/Quad_meshing/Layout/internal/Layout_charts.h>
#include <CGAL/Quad_meshing/Layout/internal/Layout_parameterization.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <Eigen/SparseLU>

#include <cmath>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Makes the map of patches free of folds whose arcs are all aligned.
//
// The border of such a patch is mapped to that of a convex chart. If its order is right, the map in which every inner
// vertex is a mean of its neighbours with positive weights has no fold (Tutte: How to draw a graph, 1963; Floater:
// One-to-one piecewise linear mappings over triangulations, 2003): no edge of the patch joins two vertices of its
// border. Mean value weights come first, equal ones where rounding spoils their result.
class Patch_untangling
{
public:
  Patch_untangling(const Embedded_layout& e, Layout_parameterization& parameterization)
    : m_e(e), m_parameterization(parameterization), m_faces(e.number_of_patches())
  {
    for(int f = 0; f < e.mesh().number_of_faces(); ++f)
      m_faces[e.patch[f]].push_back(f);
  }

  // Whether the image of a triangle is not oriented as it should be: an exact answer about the coordinates as they are.
  bool has_fold(int patch) const
  {
    typedef Exact_predicates_inexact_constructions_kernel::Point_2 Point_2;
    auto corner = [&](int h)
    {
      const Eigen::Vector2d& p = m_parameterization.place[m_parameterization.copy[h]];
      return Point_2(p.x(), p.y());
    };
    for(int f : m_faces[patch])
      if(orientation(corner(3 * f), corner(3 * f + 1), corner(3 * f + 2)) != LEFT_TURN)
        return true;
    return false;
  }

  std::vector<int> folded_patches() const
  {
    std::vector<int> patches;
    for(int p = 0; p < m_e.number_of_patches(); ++p)
      if(has_fold(p))
        patches.push_back(p);
    return patches;
  }

  // Puts the vertices of an arc in the order of their distances from its source, if they are in another one. Returns
  // whether they were.
  bool order_arc(int arc, const Layout_charts& charts)
  {
    const std::vector<int>& chain = m_e.chain[arc];
    bool is_ordered = true;
    double before = 0;
    for(std::size_t i = 1; i < chain.size(); ++i)
    {
      const double s = i + 1 == chain.size() ? 1 : m_parameterization.on_arc[chain[i]].x();
      is_ordered = is_ordered && s > before;
      before = s;
    }
    if(is_ordered)
      return false;
    double at = 0;
    for(std::size_t i = 1; i + 1 < chain.size(); ++i)
    {
      at += std::sqrt((m_e.mesh().points[chain[i]] - m_e.mesh().points[chain[i - 1]]).squared_length());
      m_parameterization.on_arc[chain[i]] = Eigen::Vector2d(at / charts.arc_length(arc), 0);
    }
    for(std::size_t c = 0; c < m_parameterization.copies.size(); ++c)
    {
      const Layout_parameterization::Copy& copy = m_parameterization.copies[c];
      if(m_parameterization.arc_of_vertex[copy.vertex] == arc)
        m_parameterization.place[c] = charts.frame(copy.direction).point(m_parameterization.on_arc[copy.vertex]);
    }
    return true;
  }

  // Computes the inside of a patch anew. Returns whether it has no fold then.
  bool untangle(int patch)
  {
    for(bool mean_value : { true, false })
      if(embed(patch, mean_value) && !has_fold(patch))
        return true;
    return false;
  }

private:
  bool embed(int patch, bool mean_value)
  {
    const Indexed_triangle_mesh& m = m_e.mesh();
    if(mean_value && m_weights.empty())
      m_weights.emplace_back(m, true);
    std::vector<int>& number = m_number;
    number.resize(m_parameterization.copies.size(), -1);
    std::vector<int> inner;
    for(int f : m_faces[patch])
      for(int h = 3 * f; h < 3 * f + 3; ++h)
      {
        const int c = m_parameterization.copy[h];
        if(m_parameterization.copies[c].direction == -1 && number[c] == -1)
        {
          number[c] = static_cast<int>(inner.size());
          inner.push_back(c);
        }
      }
    const int n = static_cast<int>(inner.size());
    std::vector<Eigen::Triplet<double>> entries;
    Eigen::MatrixXd rhs = Eigen::MatrixXd::Zero(n, 2);
    for(int f : m_faces[patch])
      for(int h = 3 * f; h < 3 * f + 3; ++h)
      {
        const int i = number[m_parameterization.copy[h]];
        if(i == -1)
          continue;
        auto add = [&](int corner, double w)
        {
          const int c = m_parameterization.copy[corner];
          entries.emplace_back(i, i, w);
          if(number[c] != -1)
            entries.emplace_back(i, number[c], -w);
          else
            rhs.row(i) += w * m_parameterization.place[c].transpose();
        };
        add(m.next(h), mean_value ? m_weights[0].to_target(h) : 1);
        add(m.prev(h), mean_value ? m_weights[0].to_previous(h) : 1);
      }
    Eigen::MatrixXd x;
    bool is_solved = true;
    if(n > 0)
    {
      Eigen::SparseMatrix<double> A(n, n);
      A.setFromTriplets(entries.begin(), entries.end());
      Eigen::SparseLU<Eigen::SparseMatrix<double>> solver;
      solver.compute(A);
      is_solved = solver.info() == Eigen::Success;
      if(is_solved)
        x = solver.solve(rhs);
      is_solved = is_solved && x.allFinite();
    }
    for(int i = 0; i < n; ++i)
    {
      number[inner[i]] = -1;
      if(is_solved)
        m_parameterization.place[inner[i]] = x.row(i).transpose();
    }
    return is_solved;
  }

  const Embedded_layout& m_e;
  Layout_parameterization& m_parameterization;
  std::vector<std::vector<int>> m_faces;   // per patch
  std::vector<Harmonic_weights> m_weights; // the mean value weights, once they are needed
  std::vector<int> m_number;               // per copy: its number in the system that is being solved
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_LAYOUT_INTERNAL_PATCH_UNTANGLING_H
