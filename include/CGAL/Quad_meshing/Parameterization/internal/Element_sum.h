// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PARAMETERIZATION_INTERNAL_ELEMENT_SUM_H
#define CGAL_QUAD_MESHING_PARAMETERIZATION_INTERNAL_ELEMENT_SUM_H

#include <CGAL/Quad_meshing/Parameterization/internal/Seamless_coordinates.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The sum of small symmetric matrices, one per triangle.
//
// The triangles along the cuts depend on many integers each, all of which meet in many triangles: their part is summed
// in a dense matrix, which is far smaller than the list of its summands.
class Element_sum
{
public:
  // `number` as in `Orientation_energy`, with the numbers 0 to n - 1.
  Element_sum(const Seamless_coordinates& coordinates, const std::vector<int>& number, int n, std::size_t expected)
    : m_n(n), m_far(n, -1)
  {
    for(std::size_t i = 0; i < number.size(); ++i)
      if(number[i] != -1 && coordinates.is_integer[i])
      {
        m_far[number[i]] = static_cast<int>(m_far_numbers.size());
        m_far_numbers.push_back(number[i]);
      }
    m_dense.setZero(m_far_numbers.size(), m_far_numbers.size());
    m_triplets.reserve(expected);
  }

  void add(int i, int j, double value)
  {
    if(m_far[i] != -1 && m_far[j] != -1)
      m_dense(m_far[i], m_far[j]) += value;
    else
      m_triplets.emplace_back(i, j, value);
  }

  double number_of_dense_rows() const { return static_cast<double>(m_far_numbers.size()); }

  // `shift` is added to the diagonal.
  Eigen::SparseMatrix<double> matrix(double shift = 0)
  {
    for(std::size_t i = 0; i < m_far_numbers.size(); ++i)
      for(std::size_t j = 0; j < m_far_numbers.size(); ++j)
        if(m_dense(i, j) != 0)
          m_triplets.emplace_back(m_far_numbers[i], m_far_numbers[j], m_dense(i, j));
    if(shift != 0)
      for(int i = 0; i < m_n; ++i)
        m_triplets.emplace_back(i, i, shift);
    Eigen::SparseMatrix<double> A(m_n, m_n);
    A.setFromTriplets(m_triplets.begin(), m_triplets.end());
    return A;
  }

private:
  const int m_n;
  std::vector<int> m_far, m_far_numbers;
  Eigen::MatrixXd m_dense;
  std::vector<Eigen::Triplet<double>> m_triplets;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_PARAMETERIZATION_INTERNAL_ELEMENT_SUM_H
