// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_LATTICE_BOUND_H
#define CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_LATTICE_BOUND_H

#include <CGAL/Quad_meshing/Mixed_integer/internal/Dual_lattice.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/Split_relaxation.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// A lower bound of |R (z - t)|^2 over all integer z where enumerations cannot reach: the semidefinite relaxation by
// slabs that hold no lattice point, in rounds. Every round keeps the slabs that the last relaxation rests on and adds
// those that its solution violates most, in terms of distance: so short vectors come first.
//
// A slab across the integer vector a is violated by a distribution where the integer a'z varies less than integers
// can. Short vectors of the dual lattice in the form of the covariance are such, so this lattice is reduced anew in
// each round; sums and differences of the reduced vectors and of those of the slabs at hand are tried.
class Lattice_bound
{
public:
  // R is upper triangular, best from a reduced basis. `squared_distance` is that of a known point, and not zero.
  Lattice_bound(const Eigen::MatrixXd& R, const Eigen::VectorXd& target, double squared_distance)
    : m_R(R / std::sqrt(squared_distance))
    , m_target(target)
    , m_unit(squared_distance)
    , m_size(static_cast<int>(target.size()))
  {
  }

  // Returns the bound, at least zero.
  double run(int rounds, const std::function<bool()>& go_further)
  {
    const double accuracy = 0.01, last_accuracy = 0.001;

    // Before the first relaxation it is as if the points were spread evenly around the target, half as far as the
    // known one.
    Eigen::VectorXd mean = Eigen::VectorXd::Zero(m_size);
    Eigen::MatrixXd precision = 2 * std::sqrt(1. * m_size) * Eigen::MatrixXd::Identity(m_size, m_size);
    double best = 0;
    for(int round = 0; round < rounds && go_further(); ++round)
    {
      if(!add_violated(mean, precision))
        break;
      const Splits splits = make_splits();
      Split_relaxation relaxation(splits);
      const bool is_last = round + 1 == rounds;
      const bool is_complete = relaxation.run(Eigen::VectorXd::Constant(splits.size(), first_weight), 1.,
                                              is_last ? last_accuracy : accuracy, go_further);
      best = (std::max)(best, relaxation.bound());
      if(!is_complete || best > 1 - last_accuracy)
        break;
      mean = relaxation.mean();
      precision = relaxation.precision_factor();
      drop_loose(relaxation);
    }
    return best * m_unit;
  }

private:
  // The integer a'z and the number k of the slab k <= a'z <= k + 1.
  struct Slab
  {
    Eigen::VectorXd normal;
    double floor;
    bool operator<(const Slab& other) const
    {
      if(floor != other.floor)
        return floor < other.floor;
      return std::lexicographical_compare(normal.data(), normal.data() + normal.size(), other.normal.data(),
                                          other.normal.data() + other.normal.size());
    }
  };

  static constexpr double first_weight = 1e-4;

  Splits make_splits() const
  {
    Eigen::MatrixXd normals(m_size, m_slabs.size());
    Splits splits;
    splits.offsets.resize(m_slabs.size());
    for(std::size_t i = 0; i < m_slabs.size(); ++i)
    {
      normals.col(i) = m_slabs[i].normal;
      splits.offsets[i] = m_slabs[i].normal.dot(m_target) - m_slabs[i].floor - 0.5;
    }
    splits.B = m_R.transpose().triangularView<Eigen::Lower>().solve(normals);
    return splits;
  }

  void drop_loose(const Split_relaxation& relaxation)
  {
    const double loose = 0.1; // slabs ask for 1/4
    std::vector<Slab> kept;
    for(std::size_t i = 0; i < m_slabs.size(); ++i)
      if(relaxation.slack(static_cast<int>(i)) < loose)
        kept.push_back(m_slabs[i]);
    m_slabs.swap(kept);
  }

  // The products of dual vectors in the lattice with this factor.
  static Eigen::MatrixXd dual_products(const Eigen::MatrixXd& R, const Eigen::MatrixXd& vectors)
  {
    const Eigen::MatrixXd half = R.transpose().triangularView<Eigen::Lower>().solve(vectors);
    return half.transpose() * half;
  }

  // Adds the slabs that reach farthest beyond the normal distribution of y = R (z - t) with this mean and the factor
  // of the inverse of its covariance: as many as there are integers. Returns false if there is none.
  bool add_violated(const Eigen::VectorXd& mean, const Eigen::MatrixXd& precision)
  {
    const double least_lack = 1e-3; // slabs ask for 1/4
    struct Candidate
    {
      int i, j, sign; // the vector i plus sign times j of the pool
      double depth;   // the squared distance by which the points lack
    };

    const Eigen::MatrixXd R = precision * m_R;
    const Eigen::MatrixXd dual = reduced_dual_basis(R);
    Eigen::MatrixXd pool(m_size, m_size + m_slabs.size());
    pool.leftCols(m_size) = dual;
    for(std::size_t i = 0; i < m_slabs.size(); ++i)
      pool.col(m_size + i) = m_slabs[i].normal;
    const Eigen::MatrixXd covariance = dual_products(R, pool), product = dual_products(m_R, pool);
    const Eigen::VectorXd center = m_target + m_R.triangularView<Eigen::Upper>().solve(mean);
    const Eigen::VectorXd value = pool.transpose() * center;

    std::vector<Candidate> candidates;
    auto consider = [&](int i, int j, int sign)
    {
      auto square = [&](const Eigen::MatrixXd& form)
      { return sign == 0 ? form(i, i) : form(i, i) + form(j, j) + 2 * sign * form(i, j); };
      const double variance = square(covariance), v = sign == 0 ? value[i] : value[i] + sign * value[j];
      if(variance > 0.25)
        return;
      const double u = v - std::floor(v) - 0.5, lack = 0.25 - u * u - variance;
      if(lack > least_lack)
        candidates.push_back({ i, j, sign, lack / square(product) });
    };
    for(int i = 0; i < pool.cols(); ++i)
    {
      consider(i, i, 0);
      for(int j = 0; j < i; ++j)
        for(int sign : { -1, 1 })
          consider(i, j, sign);
    }
    std::sort(candidates.begin(), candidates.end(),
              [](const Candidate& a, const Candidate& b)
              { return std::tie(b.depth, a.i, a.j, a.sign) < std::tie(a.depth, b.i, b.j, b.sign); });

    std::set<Slab> known(m_slabs.begin(), m_slabs.end());
    int added = 0;
    for(const Candidate& c : candidates)
    {
      if(added == m_size)
        break;
      Slab slab{ pool.col(c.i), 0. };
      if(c.sign != 0)
        slab.normal += c.sign * pool.col(c.j);
      choose_sign(slab.normal);
      slab.floor = std::floor(slab.normal.dot(center));
      if(slab.normal.isZero(0.) || !known.insert(slab).second)
        continue;
      m_slabs.push_back(slab);
      ++added;
    }
    return added > 0;
  }

  const Eigen::MatrixXd m_R; // the known point is at the distance 1
  const Eigen::VectorXd& m_target;
  const double m_unit;
  const int m_size;
  std::vector<Slab> m_slabs;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_LATTICE_BOUND_H
