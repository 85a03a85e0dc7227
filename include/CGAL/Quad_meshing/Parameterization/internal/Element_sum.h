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
    : n(n), far(n, -1)
  {
    for(std::size_t i = 0; i < number.size(); ++i)
      if(number[i] != -1 && coordinates.is_integer[i])
      {
        far[number[i]] = static_cast<int>(far_numbers.size());
        far_numbers.push_back(number[i]);
      }
    dense.setZero(far_numbers.size(), far_numbers.size());
    triplets.reserve(expected);
  }

  void add(int i, int j, double value)
  {
    if(far[i] != -1 && far[j] != -1)
      dense(far[i], far[j]) += value;
    else
      triplets.emplace_back(i, j, value);
  }

  double number_of_dense_rows() const { return static_cast<double>(far_numbers.size()); }

  // `shift` is added to the diagonal.
  Eigen::SparseMatrix<double> matrix(double shift = 0)
  {
    for(std::size_t i = 0; i < far_numbers.size(); ++i)
      for(std::size_t j = 0; j < far_numbers.size(); ++j)
        if(dense(i, j) != 0)
          triplets.emplace_back(far_numbers[i], far_numbers[j], dense(i, j));
    if(shift != 0)
      for(int i = 0; i < n; ++i)
        triplets.emplace_back(i, i, shift);
    Eigen::SparseMatrix<double> A(n, n);
    A.setFromTriplets(triplets.begin(), triplets.end());
    return A;
  }

private:
  const int n;
  std::vector<int> far, far_numbers;
  Eigen::MatrixXd dense;
  std::vector<Eigen::Triplet<double> > triplets;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_PARAMETERIZATION_INTERNAL_ELEMENT_SUM_H
