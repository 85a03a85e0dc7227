// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_DENSE_LATTICE_ROUNDING_H
#define CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_DENSE_LATTICE_ROUNDING_H

#include <CGAL/Quad_meshing/Mixed_integer/internal/Lattice_bound.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/Lattice_rounding.h>

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Minimizes E(y) = 1/2 (y - y*)' S (y - y*) over integers of any number that a dense S allows, independent components
// one by one: as a whole, with a proof or a bound, unless a component is very large; and, if there is no proof, in
// overlapping blocks, each decoded with all other integers fixed, until no block gains. The bound of what is not
// proven may then be raised by a relaxation.
class Dense_lattice_rounding
{
public:
  Dense_lattice_rounding(const Eigen::MatrixXd& S, const Eigen::VectorXd& target, double maximum_nodes,
                         int bound_rounds, const std::function<bool()>& go_further)
    : m_S(S), m_target(target), m_maximum_nodes(maximum_nodes), m_bound_rounds(bound_rounds), m_go_further(go_further)
  {
  }

  // `start` is an integer point to beat.
  Lattice_result run(const Eigen::VectorXd& start)
  {
    Lattice_result result;
    result.y = start;
    result.is_optimal = true;
    for(const std::vector<int>& component : components())
    {
      const double share = m_maximum_nodes * component.size() / m_target.size();
      const Lattice_result part = decode(component, start, share);
      for(std::size_t i = 0; i < component.size(); ++i)
        result.y[component[i]] = part.y[i];
      result.cost += part.cost;
      result.cost_bound += part.cost_bound;
      result.nodes += part.nodes;
      result.is_optimal = result.is_optimal && part.is_optimal;
    }
    return result;
  }

private:
  enum
  {
    whole_size = 400, // the largest number of integers decoded as a whole
    block_size = 40
  };

  // Integers are coupled if the energy of one knows of the other by more than round-off.
  std::vector<std::vector<int>> components() const
  {
    const double round_off = 1e-13;
    const int m = static_cast<int>(m_target.size());
    std::vector<std::vector<int>> result;
    std::vector<char> is_seen(m, 0);
    for(int seed = 0; seed < m; ++seed)
    {
      if(is_seen[seed])
        continue;
      std::vector<int> component(1, seed);
      is_seen[seed] = 1;
      for(std::size_t next = 0; next < component.size(); ++next)
        for(int j = 0; j < m; ++j)
          if(!is_seen[j] && coupling(component[next], j) > round_off)
          {
            is_seen[j] = 1;
            component.push_back(j);
          }
      std::sort(component.begin(), component.end());
      result.push_back(component);
    }
    return result;
  }

  double coupling(int i, int j) const { return std::fabs(m_S(i, j)) / std::sqrt(m_S(i, i) * m_S(j, j)); }

  Eigen::MatrixXd block_of(const std::vector<int>& indices) const
  {
    Eigen::MatrixXd block(indices.size(), indices.size());
    for(std::size_t i = 0; i < indices.size(); ++i)
      for(std::size_t j = 0; j < indices.size(); ++j)
        block(i, j) = m_S(indices[i], indices[j]);
    return block;
  }

  Lattice_result decode(const std::vector<int>& component, const Eigen::VectorXd& start, double maximum_nodes) const
  {
    // The rest goes into blocks if there is no proof: half in the given basis, half in the reduced one.
    const double whole_fraction = 0.8;
    const Eigen::MatrixXd S = block_of(component);
    const Eigen::VectorXd target = subvector(m_target, component);
    Lattice_result result;
    result.y = subvector(start, component);
    if(component.size() > whole_size)
    {
      result.nodes = improve_in_blocks(S, target, result.y, maximum_nodes);
      result.cost = cost(S, result.y - target);
      return result;
    }
    const Eigen::MatrixXd R = Eigen::LLT<Eigen::MatrixXd>(S).matrixU();
    Lattice_rounding rounding(R, target, component.size() > block_size ? whole_fraction * maximum_nodes : maximum_nodes,
                              m_go_further);
    result = rounding.run(result.y, true);
    if(result.is_optimal)
      return result;
    const Eigen::MatrixXd& reduced = rounding.reduction().factor();
    const Eigen::VectorXd reduced_target = rounding.reduction().coordinates(target);
    if(component.size() > block_size)
    {
      result.nodes += improve_in_blocks(S, target, result.y, (maximum_nodes - result.nodes) / 2);
      Eigen::VectorXd z = rounding.reduction().coordinates(result.y).array().round();
      result.nodes += improve_in_blocks(reduced.transpose() * reduced, reduced_target, z, maximum_nodes - result.nodes);
      result.y = rounding.reduction().transformation() * z;
      result.cost = cost(S, result.y - target);
    }
    const double bound =
      0.5 * Lattice_bound(reduced, reduced_target, 2 * result.cost).run(m_bound_rounds, m_go_further);
    result.cost_bound = (std::min)(result.cost, (std::max)(result.cost_bound, bound));
    return result;
  }

  static double cost(const Eigen::MatrixXd& S, const Eigen::VectorXd& difference)
  {
    return 0.5 * difference.dot(S * difference);
  }

  // Lowers 1/2 (y - y*)' S (y - y*) block by block, and returns the number of nodes visited.
  double improve_in_blocks(const Eigen::MatrixXd& S, const Eigen::VectorXd& target, Eigen::VectorXd& y,
                           double maximum_nodes) const
  {
    const int m = static_cast<int>(y.size());
    double nodes = 0.;
    // Blocks overlap; so many of them per pass leave no integer out.
    const int step = (std::max)(1, m / 60);
    // Each block may use as many nodes as let the passes end in time.
    const double nodes_per_block = (std::max)(1000., maximum_nodes * step / (expected_passes * m));
    Eigen::VectorXd gradient = S * (y - target);
    bool has_gained = true;
    while(has_gained && nodes < maximum_nodes && m_go_further())
    {
      has_gained = false;
      for(int seed = 0; seed < m && nodes < maximum_nodes && m_go_further(); seed += step)
      {
        const std::vector<int> block = block_around(S, seed);
        Eigen::MatrixXd S_block(block.size(), block.size());
        for(std::size_t i = 0; i < block.size(); ++i)
          for(std::size_t j = 0; j < block.size(); ++j)
            S_block(i, j) = S(block[i], block[j]);
        const Eigen::LLT<Eigen::MatrixXd> cholesky(S_block);
        const Eigen::VectorXd old = subvector(y, block);
        const Eigen::VectorXd shift = cholesky.solve(subvector(gradient, block));
        const Eigen::VectorXd block_target = old - shift;
        const double old_cost = cost(S_block, shift);
        const Eigen::MatrixXd R = cholesky.matrixU();
        Lattice_rounding rounding(R, block_target, nodes_per_block, m_go_further);
        const Lattice_result part = rounding.run(old, false);
        nodes += part.nodes;
        const double relative_gain = 1e-9;
        if(part.cost < old_cost * (1. - relative_gain))
        {
          has_gained = true;
          for(std::size_t i = 0; i < block.size(); ++i)
          {
            const double step = part.y[i] - old[i];
            y[block[i]] = part.y[i];
            if(step != 0.)
              gradient += step * S.col(block[i]);
          }
        }
      }
    }
    return nodes;
  }

  // The integers most strongly coupled to one of them, and this one, in ascending order.
  static std::vector<int> block_around(const Eigen::MatrixXd& S, int seed)
  {
    const int m = static_cast<int>(S.rows());
    std::vector<std::pair<double, int>> order(m);
    for(int j = 0; j < m; ++j)
      order[j] = std::make_pair(-std::fabs(S(seed, j)) / std::sqrt(S(seed, seed) * S(j, j)), j);
    const int count = (std::min)(static_cast<int>(block_size), m);
    std::partial_sort(order.begin(), order.begin() + count, order.end());
    std::vector<int> block(count);
    for(int i = 0; i < count; ++i)
      block[i] = order[i].second;
    std::sort(block.begin(), block.end());
    return block;
  }

  static constexpr double expected_passes = 4.;

  const Eigen::MatrixXd& m_S;
  const Eigen::VectorXd& m_target;
  double m_maximum_nodes;
  int m_bound_rounds;
  const std::function<bool()>& m_go_further;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_DENSE_LATTICE_ROUNDING_H
