// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_STRUCTURE_INTERNAL_LAYOUT_GOALS_H
#define CGAL_QUAD_MESHING_STRUCTURE_INTERNAL_LAYOUT_GOALS_H

#include <CGAL/Quad_meshing/Layout/Layout_weights.h>
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
  typedef Layout_weights Weights;

  // How many times too many quads there may be in a layout that is looked at.
  static constexpr double looked_at = 1.15;

  // Where only the layout is wanted, more helices are tolerated.
  Layout_goals(const Quad_mesh_structure& input, const Quad_mesh_quality& quality, int most_quads,
               bool is_layout_wanted = false)
    : m_most_helices(
        (std::max)(Weights::helices * input.number_of_helices,
                   double(is_layout_wanted ? Weights::few_helices_where_a_layout_is_wanted : Weights::few_helices)))
    , m_most_patches((std::min)(Weights::patches * input.number_of_patches,
                                Weights::patches_per_irregular_vertex * input.number_of_irregular_vertices))
    , m_most_quads(most_quads)
    , m_counts_quads(most_quads >= Weights::least_target * input.number_of_quads)
  {
    const double d = (std::max)(Weights::least_deviation, quality.mean_angle_deviation);
    m_squared_deviation = quality.mean_angle_deviation * quality.mean_angle_deviation;
    m_most_squared_growth = (Weights::growth * Weights::growth - 1) * d * d;
  }

  // The price of what can be counted.
  double price_of_structure(double helices, double patches, double quads) const
  {
    const double above = Weights::helices_and_patches_above_goal;
    return price(helices / m_most_helices, above) + price(patches / m_most_patches, above) + price_of_quads(quads);
  }

  // With a target far below the input, how many quads there are does not matter.
  double price_of_quads(double quads) const
  {
    if(!m_counts_quads)
      return 0;
    const double loss = 1 - quads / m_most_quads;
    return loss < 0 ? -loss * Weights::surplus : price(loss / Weights::loss, m_loss_above_goal);
  }

  // The price of the shape, by what is added to the square of the mean deviation, in squared degrees.
  double price_of_growth(double squared) const
  {
    return price((std::max)(0., squared) / m_most_squared_growth, Weights::growth_above_goal);
  }

  bool are_reached(double helices, double patches, double quads, double squared_growth) const
  {
    return helices <= m_most_helices && patches <= m_most_patches && price_of_quads(quads) <= Weights::below_goal &&
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

  double most_helices() const { return m_most_helices; }

  // So many helices are no worse than what the input has.
  int tolerated_helices(int of_input) const { return (std::max)(of_input, static_cast<int>(m_most_helices)); }

  // From now on lost quads cost less.
  void neglect_loss() { m_loss_above_goal = Weights::loss_above_goal_when_neglected; }

  int most_quads() const { return m_most_quads; }

private:
  static double price(double part, double above_goal)
  {
    return Weights::below_goal * part + above_goal * (std::max)(0., part - 1);
  }

  double m_most_helices, m_most_patches;
  int m_most_quads;
  bool m_counts_quads;
  double m_loss_above_goal = Weights::loss_above_goal;
  double m_squared_deviation, m_most_squared_growth; // of the input, and what may be added
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_STRUCTURE_INTERNAL_LAYOUT_GOALS_H
