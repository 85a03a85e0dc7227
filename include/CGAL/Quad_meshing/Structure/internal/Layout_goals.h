// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_STRUCTURE_INTERNAL_LAYOUT_GOALS_H
#define CGAL_QUAD_MESHING_STRUCTURE_INTERNAL_LAYOUT_GOALS_H

#include <CGAL/Quad_meshing/Quad_mesh/quad_mesh_quality.h>
#include <CGAL/Quad_meshing/Quad_mesh/quad_mesh_structure.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// What a layout should reach, and the price of what it does reach: helices, patches, lost quads and the shape of the
// quads in units of what is tolerated of each. What exceeds that costs much more.
class Layout_goals
{
public:
  // What is tolerated: parts of the helices and of the patches of the input, and a part of the quads that is lost.
  static constexpr double tolerated_helices = 0.2, tolerated_patches = 0.33, tolerated_loss = 0.3;
  // A number of helices in the input below which this is the one that counts.
  static constexpr int few_helices = 5;
  // By which factor the mean deviation of the corners from right angles may grow; the square of a smaller one than so
  // many degrees may grow by as much as that of this one.
  static constexpr double tolerated_growth = 1.35, least_deviation = 5;
  // Part of the quads of the input below which a target is no goal.
  static constexpr double least_counted = 0.25;
  // How many times too many quads there may be in a layout that is looked at, and the price of each part that is too
  // many.
  static constexpr double looked_at = 1.15, surplus_weight = 30;
  // Weight of each part, and how much more weighs what is above one: helices and patches come first.
  static constexpr double weight = 0.5, excess_weight = 6, loss_excess_weight = 6, neglected_loss_excess_weight = 2,
                          shape_excess_weight = 3;

  Layout_goals(const Quad_mesh_structure& input, const Quad_mesh_quality& quality, int most_quads)
    : m_most_helices(tolerated_helices * (std::max)(few_helices, static_cast<int>(input.number_of_helices)))
    , m_most_patches(tolerated_patches * input.number_of_patches)
    , m_most_quads(most_quads)
    , m_counts_quads(most_quads >= least_counted * input.number_of_quads)
  {
    const double d = (std::max)(least_deviation, quality.mean_angle_deviation);
    m_squared_deviation = quality.mean_angle_deviation * quality.mean_angle_deviation;
    m_most_squared_growth = (tolerated_growth * tolerated_growth - 1) * d * d;
  }

  // The price of what can be counted.
  double price_of_structure(double helices, double patches, double quads) const
  {
    return price(helices / m_most_helices, excess_weight) + price(patches / m_most_patches, excess_weight) +
           price_of_quads(quads);
  }

  // With a target far below the input, how many quads there are does not matter.
  double price_of_quads(double quads) const
  {
    if(!m_counts_quads)
      return 0;
    const double loss = 1 - quads / m_most_quads;
    return loss < 0 ? -loss * surplus_weight : price(loss / tolerated_loss, m_loss_excess_weight);
  }

  // The price of the shape, by what is added to the square of the mean deviation, in squared degrees.
  double price_of_growth(double squared) const
  {
    return price((std::max)(0., squared) / m_most_squared_growth, shape_excess_weight);
  }

  bool are_reached(double helices, double patches, double quads, double squared_growth) const
  {
    return helices <= m_most_helices && patches <= m_most_patches && price_of_quads(quads) <= weight &&
           squared_growth <= m_most_squared_growth;
  }

  // What a mesh comes to, by its helices, its patches and the shape of its quads.
  struct Reached
  {
    double price;
    bool all;
  };

  Reached reached(double helices, double patches, const Quad_mesh_quality& q) const
  {
    const double quads = static_cast<double>(q.number_of_quads);
    const double growth = q.mean_angle_deviation * q.mean_angle_deviation - m_squared_deviation;
    return Reached{ price_of_structure(helices, patches, quads) + price_of_growth(growth),
                    are_reached(helices, patches, quads, growth) };
  }

  // From now on lost quads cost less.
  void neglect_loss() { m_loss_excess_weight = neglected_loss_excess_weight; }

  int most_quads() const { return m_most_quads; }

private:
  static double price(double part, double weight_of_excess)
  {
    return weight * part + weight_of_excess * (std::max)(0., part - 1);
  }

  double m_most_helices, m_most_patches;
  int m_most_quads;
  bool m_counts_quads;
  double m_loss_excess_weight = loss_excess_weight;
  double m_squared_deviation, m_most_squared_growth; // of the input, and what may be added
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_STRUCTURE_INTERNAL_LAYOUT_GOALS_H
