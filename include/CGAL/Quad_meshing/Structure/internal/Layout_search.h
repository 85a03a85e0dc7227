// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_STRUCTURE_INTERNAL_LAYOUT_SEARCH_H
#define CGAL_QUAD_MESHING_STRUCTURE_INTERNAL_LAYOUT_SEARCH_H

#include <CGAL/Quad_meshing/Structure/internal/Base_complex_arrays.h>
#include <CGAL/Quad_meshing/Structure/internal/Feature_bends.h>
#include <CGAL/Quad_meshing/Structure/internal/Indexed_quad_mesh.h>
#include <CGAL/Quad_meshing/Structure/internal/Layout_curves.h>
#include <CGAL/Quad_meshing/Structure/internal/Layout_helices.h>
#include <CGAL/Quad_meshing/Structure/internal/Layout_quantization.h>
#include <CGAL/Quad_meshing/Structure/internal/Layout_realization.h>
#include <CGAL/Quad_meshing/Structure/quad_mesh_structure.h>

#include <CGAL/Random.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// What is to be small in a layout: a sum of terms, those first that take the least time.
class Layout_cost
{
public:
  // Weights against the number of patches, as a part of what there is at first: of the number of helices without and with
  // crossings, as parts of those of the input, of the distortion, of how far features are not followed, and of the part of
  // the quads of the input that is missing when the curves are multiplied.
  static constexpr double helix_weight = 2, crossing_weight = 0.5, distortion_weight = 2, feature_weight = 5, missing_weight = 1.5;
  // Numbers of helices below which one of them does not weigh more.
  static constexpr int few_helices = 5;
  // How much more helices weigh that are not tolerated.
  static constexpr double excess_helix_weight = 6;
  // Part of the patches of the input above which more of them cost so much more.
  static constexpr double most_patches = 0.33, excess_weight = 15;
  // Factor of the weight of the distortion when the shape was not accepted.
  static constexpr double caution = 3;

  static constexpr double forbidden = (std::numeric_limits<double>::max)();

  Layout_cost(const Indexed_quad_mesh& input, const Quad_mesh_structure& structure, const Layout_quantization& quantization,
              const Feature_bends& bends, const std::vector<char>& is_fixed)
    : m(input), m_structure(structure), m_quantization(quantization), m_bends(bends), m_is_fixed(is_fixed)
  {}

  int number_of_patches() const { return number_of_base_complex_patches(realization().mesh); }

  // Measures by a first layout what is many; `largest_patches` must not be exceeded, unless it is 0.
  void start(std::size_t largest_patches)
  {
    m_first_patches = number_of_patches();
    m_largest_patches = largest_patches > 0 ? (std::max)(static_cast<int>(largest_patches), m_first_patches)
                                            : (std::numeric_limits<int>::max)();
    m_largest_quads = 2 * m_quantization.number_of_quads(m_quantization.length);
  }

  // From now on layouts may be distorted less.
  void avoid_distortion() { m_caution *= caution; }

  // The cost of the layout, or some number above `limit` if it is above that.
  double operator()(double limit) const
  {
    if(m_quantization.number_of_quads(m_quantization.length) > m_largest_quads)
      return forbidden;
    const Layout_curves curves(m_quantization, m_quantization.length);
    double cost = m_caution * distortion_weight * curves.distortion;
    if(cost > limit)
      return cost;

    const Layout_realization r = realization();
    const Layout_helices helices(r, curves);
    const std::vector<int> multiplicities = multiplicities_of(curves, helices);
    const double n = helices.number_of_helices(multiplicities);
    cost += (helix_weight * n + excess_helix_weight * (std::max)(0., n - most_helices())) / at_least_few(m_structure.number_of_helices)
          + feature_weight * curves.feature_misfit(m_bends, multiplicities);
    if(cost > limit)
      return cost;

    const double quads = m_quantization.number_of_quads(curves.lengths(multiplicities));
    const int patches = number_of_base_complex_patches(r.mesh);
    if(patches > m_largest_patches)
      return forbidden;
    cost += missing_weight * (std::max)(0., 1 - quads / m.number_of_faces()) + double(patches) / m_first_patches
          + excess_weight * (std::max)(0., patches / (most_patches * m_structure.number_of_patches) - 1);
    return cost > limit ? cost : cost + crossing_weight * helices.number_of_helices_with_crossings(multiplicities)
                                      / at_least_few(m_structure.number_of_helices_with_crossings);
  }

  // Whether no more helices are left than are tolerated.
  bool has_few_helices() const
  {
    const Layout_curves curves(m_quantization, m_quantization.length);
    const Layout_realization r = realization();
    const Layout_helices helices(r, curves);
    return helices.number_of_helices(multiplicities_of(curves, helices)) <= most_helices();
  }

private:
  // So many parallel curves give edges the length of those of the input.
  std::vector<int> multiplicities_of(const Layout_curves& curves, const Layout_helices& helices) const
  {
    std::vector<int> result = helices.largest_multiplicities(m_structure.number_of_helices);
    for(std::size_t c = 0; c < result.size(); ++c)
      result[c] = (std::min)(result[c], (std::max)(1, static_cast<int>(curves.edge_length[c])));
    return result;
  }

  double most_helices() const { return Layout_helices::tolerated_part * m_structure.number_of_helices; }

  static double at_least_few(std::size_t n) { return (std::max)(few_helices, static_cast<int>(n)); }

  Layout_realization realization() const
  {
    return Layout_realization(m, m_quantization, m_quantization.length, m_is_fixed, Layout_realization::TOPOLOGY);
  }

  const Indexed_quad_mesh& m;
  const Quad_mesh_structure& m_structure;     // of this mesh
  const Layout_quantization& m_quantization;
  const Feature_bends& m_bends;
  const std::vector<char>& m_is_fixed;
  double m_caution = 1;
  int m_first_patches = 1, m_largest_patches = 0, m_largest_quads = 0;
};

// Looks for a coarse layout with few patches and few helices.
//
// First all arcs are shortened, at a slowly growing scale. What comes out depends on chance: one unit more
// or less on one path can join all dual curves to a single one or separate them. So the paths are changed at random
// next, and what makes the structure better stays, and at first also some of what makes it worse (simulated
// annealing). The real base complex and the real helices of each layout are counted; it has few quads, however
// many the mesh has.
class Layout_search
{
public:
  // Number of quads for each irregular vertex at which the shortening ends, where these stay apart and where they
  // may become one, and largest part of the quads of the input.
  static constexpr int quads_per_irregular_vertex = 20, quads_when_merging = 3;
  static constexpr double largest_part = 0.25;
  // Factor between two scales, the largest one, and after how many at which nothing has become shorter no more are tried.
  static constexpr double scale_step = 1.05, largest_scale = 100;
  static constexpr int futile_scales = 15;
  // A worse layout is taken with probability exp(-difference / temperature), the temperature falling by the same factor
  // from step to step. Each round begins cooler than the one before.
  static constexpr double first_temperature = 0.7, last_temperature = 0.1;
  // How often the search begins anew, with the best layout so far, as long as more helices are left than are tolerated or the
  // shape is not accepted; less often on large meshes, whose layouts take longer: as often as they have together so many
  // quads.
  static constexpr int largest_number_of_rounds = 6, quads_of_all_rounds = 60000;
  // And how often before the shape is looked at.
  static constexpr int rounds_at_once = 2;
  // How many layouts of each round are kept for the case that the best one does not fit the shape.
  static constexpr int largest_number_of_runners_up = 24;
  // Largest cost of an edge of the input on a path that is changed; it is varied to find different paths.
  static constexpr double largest_edge_cost = 0.2;

  Layout_search(const Indexed_quad_mesh& mesh, const Quad_mesh_structure& structure, Layout_quantization& quantization,
                const Feature_bends& bends, const std::vector<char>& is_fixed)
    : m_quantization(quantization), m_cost(mesh, structure, quantization, bends, is_fixed),
      m_most_rounds((std::max)(1, (std::min)(largest_number_of_rounds, quads_of_all_rounds / mesh.number_of_faces())))
  {}

  int number_of_rounds() const { return m_most_rounds; }

  // Shortens the arcs until there are at most so many patches, or with `patches` 0 so many quads. Calls
  // `record()` after each scale.
  template <typename Record, typename GoFurther>
  void shorten(int quads, std::size_t patches, const Record& record, const GoFurther& go_further)
  {
    auto is_coarse = [&]
    {
      return patches > 0 ? std::size_t(m_cost.number_of_patches()) <= patches
                         : m_quantization.number_of_quads(m_quantization.length) <= quads;
    };
    std::vector<int> before;
    for(int futile = 0; futile < futile_scales && m_scale < largest_scale && !is_coarse() && go_further(); )
    {
      before = m_quantization.length;
      m_scale *= scale_step;
      m_quantization.shorten(m_scale);
      record();
      futile = m_quantization.length == before ? futile + 1 : 0;
    }
  }

  // Tries so many layouts in each round; ends with the best one. `runners_up` gets what was the best one for a while, the
  // best last.
  template <typename GoFurther>
  void anneal(int attempts, std::size_t target_patches, std::vector<std::vector<int> >& runners_up,
              const GoFurther& go_further)
  {
    m_cost.start(target_patches);
    anneal_further(attempts, runners_up, go_further);
  }

  // Goes on, as the shape of those so far was not accepted; false if there have been too many rounds.
  template <typename GoFurther>
  bool anneal_with_caution(int attempts, std::vector<std::vector<int> >& runners_up, const GoFurther& go_further)
  {
    if(m_rounds >= m_most_rounds)
      return false;
    m_cost.avoid_distortion();
    anneal_further(attempts, runners_up, go_further);
    return true;
  }

private:
  template <typename GoFurther>
  void anneal_further(int attempts, std::vector<std::vector<int> >& runners_up, const GoFurther& go_further)
  {
    if(m_quantization.length.empty())
      return;
    bool again = true;
    for(int round = 0; round < rounds_at_once && again && go_further(); ++round)
    {
      anneal_once(attempts, runners_up, go_further);
      again = ++m_rounds < m_most_rounds && !m_cost.has_few_helices();
    }
    if(runners_up.empty() || runners_up.back() != m_quantization.length)
      runners_up.push_back(m_quantization.length);
  }

  template <typename GoFurther>
  void anneal_once(int attempts, std::vector<std::vector<int> >& runners_up, const GoFurther& go_further)
  {
    std::vector<int>& length = m_quantization.length;
    double now = m_cost(Layout_cost::forbidden), best = now;
    std::vector<int> best_length = length, before;
    const double hottest = (std::max)(last_temperature, first_temperature / (1 + m_rounds));
    for(int i = 0; i < attempts && go_further(); ++i)
    {
      before = length;
      const int paths = m_random.get_double() < 0.6 ? 1 : 2;
      bool changed = true;
      for(int k = 0; k < paths && changed; ++k)
      {
        const double r = m_random.get_double();
        const int arc = m_random.get_int(0, static_cast<int>(length.size()));
        changed = m_quantization.change(arc, m_random.get_bool() ? 1 : -1, m_scale, largest_edge_cost * r * r, false);
      }
      const double temperature = hottest * std::pow(last_temperature / hottest, double(i) / attempts);
      const double limit = now - temperature * std::log(1 - m_random.get_double());
      const double c = changed ? m_cost(limit) : Layout_cost::forbidden;
      if(c <= limit)
        now = c;
      else
        length = before;
      if(now < best)
      {
        best = now;
        best_length = length;
      }
      const bool is_time = (i + 1) % (std::max)(1, attempts / largest_number_of_runners_up) == 0;
      if(is_time && (runners_up.empty() || runners_up.back() != best_length))
        runners_up.push_back(best_length);
    }
    length = best_length;
  }

  Layout_quantization& m_quantization;
  Layout_cost m_cost;
  Random m_random{ 0 };
  double m_scale = 1;
  int m_most_rounds, m_rounds = 0;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_STRUCTURE_INTERNAL_LAYOUT_SEARCH_H
