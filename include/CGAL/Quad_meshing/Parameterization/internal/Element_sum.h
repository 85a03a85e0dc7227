// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PARAMETERIZATION_INTERNAL_ELEMENT_SUM_H
#define CGAL_QUAD_MESHING_PARAMETERIZATION_INTERNAL_ELEMENT_SUM_H

#include <CGAL/Quad_meshing/Parameterization/internal/Shared_sums.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The sum of small symmetric matrices and of gradients, one per triangle, over some of the variables of a map.
//
// They are added in slots: the variables, and the shared sums of integers. A slot of a sum is replaced by its integers
// in the end, once for a cut and not for each of its triangles.
class Element_sum
{
public:
  // `number` gives the numbers of the variables, from 0 to n - 1, and -1 for those that are fixed.
  Element_sum(const Shared_sums& sums, const std::vector<int>& number, int n, std::size_t expected)
    : m_sums(sums), m_number(number), m_n(n)
  {
    std::vector<Eigen::Triplet<double>> terms;
    for(const Shared_sums::Sum& s : sums.sums())
    {
      const std::size_t before = terms.size();
      for(const Shared_sums::Term& t : s)
        if(number[t.first] != -1)
          terms.emplace_back(m_number_of_sums, number[t.first], t.second);
      m_slot_of_sum.push_back(terms.size() == before ? -1 : n + m_number_of_sums++);
    }
    m_terms.resize(m_number_of_sums, n);
    m_terms.setFromTriplets(terms.begin(), terms.end());
    m_triplets.reserve(expected);
  }

  int number_of_slots() const { return m_n + m_number_of_sums; }

  // The slot of a term of a coordinate; -1 if all of it is fixed.
  int slot(int term) const
  {
    const int n = m_sums.number_of_variables();
    return term < n ? m_number[term] : m_slot_of_sum[term - n];
  }

  void add(int i, int j, double value)
  {
    if(i < m_n && j < m_n)
      m_triplets.emplace_back(i, j, value);
    else if(i < m_n)
      m_mixed.emplace_back(i, j - m_n, value); // the other half is its transpose
    else if(j >= m_n)
      m_of_sums.emplace_back(i - m_n, j - m_n, value);
  }

  // `shift` is added to the diagonal.
  Eigen::SparseMatrix<double> matrix(double shift = 0)
  {
    if(shift != 0)
      for(int i = 0; i < m_n; ++i)
        m_triplets.emplace_back(i, i, shift);
    Eigen::SparseMatrix<double> A(m_n, m_n);
    A.setFromTriplets(m_triplets.begin(), m_triplets.end());
    if(m_number_of_sums == 0)
      return A;
    // Half of what the sums bring, for both halves of a symmetric matrix.
    Eigen::SparseMatrix<double> P(m_number_of_sums, m_number_of_sums), Q(m_n, m_number_of_sums);
    P.setFromTriplets(m_of_sums.begin(), m_of_sums.end());
    Q.setFromTriplets(m_mixed.begin(), m_mixed.end());
    Eigen::SparseMatrix<double> B = Q;
    B += 0.5 * (m_terms.transpose() * P);
    const Eigen::SparseMatrix<double> half = B * m_terms;
    const Eigen::SparseMatrix<double> other_half = half.transpose();
    return Eigen::SparseMatrix<double>(A + half + other_half);
  }

  // The gradient over the variables, from one over the slots.
  Eigen::VectorXd vector(const Eigen::VectorXd& of_slots) const
  {
    Eigen::VectorXd result = of_slots.head(m_n);
    if(m_number_of_sums != 0)
      result += m_terms.transpose() * of_slots.tail(m_number_of_sums);
    return result;
  }

private:
  const Shared_sums& m_sums;
  const std::vector<int>& m_number;
  const int m_n;
  int m_number_of_sums = 0;            // that have variables
  std::vector<int> m_slot_of_sum;      // per sum
  Eigen::SparseMatrix<double> m_terms; // sums x variables
  std::vector<Eigen::Triplet<double>> m_triplets, m_mixed, m_of_sums;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_PARAMETERIZATION_INTERNAL_ELEMENT_SUM_H
