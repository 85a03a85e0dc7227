// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_STRUCTURE_INTERNAL_LAYOUT_SEARCH_H
#define CGAL_QUAD_MESHING_STRUCTURE_INTERNAL_LAYOUT_SEARCH_H

#include <CGAL/Quad_meshing/Layout/Feature_bends.h>
#include <CGAL/Quad_meshing/Layout/Layout_curves.h>
#include <CGAL/Quad_meshing/Layout/Layout_distortion.h>
#include <CGAL/Quad_meshing/Layout/Layout_quantization.h>
#include <CGAL/Quad_meshing/Layout/Layout_realization.h>
#include <CGAL/Quad_meshing/Quad_mesh/quad_mesh_structure.h>
#include <CGAL/Quad_meshing/Structure/internal/Layout_goals.h>
#include <CGAL/Quad_meshing/Structure/internal/Layout_helices.h>
#include <CGAL/Quad_meshing/internal/Any_visitor.h>
#include <CGAL/Quad_meshing/internal/Base_complex_arrays.h>
#include <CGAL/Quad_meshing/internal/Indexed_quad_mesh.h>

#include <CGAL/Random.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// What is to be small in a layout: a sum of terms, those first that take the least time.
class Layout_cost
{
public:
  // Largest number of quads of a layout, as a multiple of that of the first one: the smaller number or more, so many
  // that there are about as many as in the input when each curve is replaced by two, but not more than the larger
  // number; and the factor when none has reached the goals.
  static constexpr double least_growth = 1.3, largest_growth = 2, twice_as_fine = Layout_goals::looked_at / 4,
                          more_quads = 1.25;

  static constexpr double forbidden = (std::numeric_limits<double>::max)();

  Layout_cost(const Indexed_quad_mesh& input, const Quad_mesh_structure& structure, const Layout_goals& goals,
              const Layout_quantization& quantization, const Feature_bends& bends, const std::vector<char>& is_fixed,
              Any_visitor& visitor)
    : m_mesh(input)
    , m_structure(structure)
    , m_goals(goals)
    , m_quantization(quantization)
    , m_bends(bends)
    , m_is_fixed(is_fixed)
    , m_distortion(input, quantization.complex(), quantization.rules(), is_fixed, visitor)
  {
  }

  int number_of_patches() const { return number_of_base_complex_patches(realization().mesh); }
  const Layout_distortion& distortion() const { return m_distortion; }

  // Measures by a first layout what is many; `largest_patches` must not be exceeded, unless it is 0.
  void start(std::size_t largest_patches)
  {
    m_largest_patches = largest_patches > 0 ? (std::max)(static_cast<int>(largest_patches), number_of_patches())
                                            : (std::numeric_limits<int>::max)();
    const double first = m_quantization.number_of_quads(m_quantization.length);
    m_largest_quads =
      (std::max)(least_growth * first, (std::min)(largest_growth * first, twice_as_fine * m_mesh.number_of_faces()));
  }

  // From now on layouts may have more quads, and lost quads count less.
  void allow_more_quads()
  {
    m_largest_quads *= more_quads;
    m_goals.neglect_loss();
  }

  // From now on layouts may be distorted less.
  void avoid_distortion() { m_caution *= Layout_weights::caution; }

  // The cost of the layout, or some number above `limit` if it is above that.
  double operator()(double limit) const
  {
    if(m_quantization.number_of_quads(m_quantization.length) > m_largest_quads)
      return forbidden;
    // What takes least time comes first, and most layouts are given up before their helices are known. Curves that are
    // multiplied less because of these hardly ever have a lower price.
    Layout_curves curves(m_quantization, m_quantization.length);
    const int most_quads = static_cast<int>(Layout_goals::looked_at * m_goals.most_quads());
    Density d = density_of(curves, curves.multiplicities_within(most_quads));
    auto misfit = [&] { return Layout_weights::features * curves.feature_misfit(m_bends, d.multiplicities); };
    double cost = d.price + misfit();
    if(cost + m_goals.price_of_structure(0, 0, d.quads) > limit)
      return cost + m_goals.price_of_structure(0, 0, d.quads);
    const Layout_realization r = realization();
    const int patches = number_of_base_complex_patches(r.mesh);
    if(patches > m_largest_patches)
      return forbidden;
    if(cost + m_goals.price_of_structure(0, patches, d.quads) > limit)
      return cost + m_goals.price_of_structure(0, patches, d.quads);
    const Layout_helices helices(r, curves);
    d = density(curves, helices, most_quads, std::move(d));
    cost = d.price + misfit() + m_goals.price_of_structure(d.helices, patches, d.quads);
    if(cost > limit)
      return cost;
    const int crossings =
      (std::max)(Layout_weights::least_crossings, static_cast<int>(m_structure.number_of_helices_with_crossings));
    return cost + Layout_weights::crossings * helices.number_of_helices_with_crossings(d.multiplicities) / crossings;
  }

  // Whether the layout reaches all goals.
  bool has_reached_goals() const
  {
    Layout_curves curves(m_quantization, m_quantization.length);
    const Layout_realization r = realization();
    const Density d = density(curves, Layout_helices(r, curves), m_goals.most_quads());
    return m_goals.are_reached(d.helices, number_of_base_complex_patches(r.mesh), d.quads, d.growth);
  }

  // How many parallel ones replace each curve, and what this gives. `growth` is that of the squared deviation.
  struct Density
  {
    std::vector<int> multiplicities;
    double helices = 0, quads = 0, growth = 0, price = 0;
  };

  // About the lengths of the edges of the input; the cheaper way of two: curves with helices are multiplied like
  // others, or only as far as helices are tolerated. Limits the multiplicities of the curves if it is the second one.
  Density density(Layout_curves& curves, const Layout_helices& helices, int most_quads) const
  {
    return density(curves, helices, most_quads, density_of(curves, curves.multiplicities_within(most_quads)));
  }

  // The same; `free` is what the first way gives.
  Density density(Layout_curves& curves, const Layout_helices& helices, int most_quads, Density free) const
  {
    free.helices = helices.number_of_helices(free.multiplicities);
    if(free.helices <= m_goals.most_helices())
      return free;
    curves.limit_multiplicities(helices.largest_multiplicities(m_goals.most_helices()));
    Density limited = density_of(curves, curves.multiplicities_within(most_quads));
    limited.helices = helices.number_of_helices(limited.multiplicities);
    if(limited.price + m_goals.price_of_structure(limited.helices, 0, limited.quads) <=
       free.price + m_goals.price_of_structure(free.helices, 0, free.quads))
      return limited;
    curves.limit_multiplicities(std::vector<int>(curves.number_of_curves(), Layout_curves::any_multiplicity));
    return free;
  }

private:
  // All but the helices.
  Density density_of(const Layout_curves& curves, std::vector<int> multiplicities) const
  {
    Density d;
    const std::vector<int> length = curves.lengths(multiplicities);
    d.quads = m_quantization.number_of_quads(length);
    d.growth = Layout_weights::squared_degrees * m_distortion(length);
    d.price = m_goals.price_of_growth(m_caution * d.growth);
    d.multiplicities = std::move(multiplicities);
    return d;
  }

  Layout_realization realization() const
  {
    return Layout_realization(m_mesh, m_quantization, m_quantization.length, m_is_fixed, Layout_realization::TOPOLOGY);
  }

  const Indexed_quad_mesh& m_mesh;
  const Quad_mesh_structure& m_structure; // of this mesh
  Layout_goals m_goals;
  const Layout_quantization& m_quantization;
  const Feature_bends& m_bends;
  const std::vector<char>& m_is_fixed;
  Layout_distortion m_distortion;
  double m_caution = 1;
  int m_largest_patches = 0;
  double m_largest_quads = 0;
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
  // The first scale, as a part of the one at which a mesh would have so few quads if all its arcs became shorter alike.
  // Factor between two scales, the largest one, and after how many at which nothing has become shorter no more are
  // tried.
  static constexpr double first_scale = 0.35, scale_step = 1.05, largest_scale = 100;
  static constexpr int futile_scales = 15;
  // A worse layout is taken with probability exp(-difference / temperature), the temperature falling by the same factor
  // from step to step.
  static constexpr double first_temperature = 1.5, last_temperature = 0.15;
  // How often the search begins anew, with the best layout so far, as long as more helices are left than are tolerated
  // or the shape is not accepted; less often on large meshes, whose layouts take longer: as often as they have together
  // so many quads.
  static constexpr int largest_number_of_rounds = 4, quads_of_all_rounds = 60000;
  // And how often before the shape is looked at.
  static constexpr int rounds_at_once = 2;
  // Number of arcs above which more layouts are tried, in proportion, and how many times as many at most.
  static constexpr double easy_arcs = 200, most_effort = 2;
  // How many layouts of each round are kept for the case that the best one does not fit the shape.
  static constexpr int largest_number_of_runners_up = 24;

  Layout_search(const Indexed_quad_mesh& mesh, const Quad_mesh_structure& structure, const Layout_goals& goals,
                Layout_quantization& quantization, const Feature_bends& bends, const std::vector<char>& is_fixed,
                Any_visitor& visitor)
    : m_quantization(quantization)
    , m_cost(mesh, structure, goals, quantization, bends, is_fixed, visitor)
    , m_effort((std::min)(most_effort, (std::max)(1., double(quantization.length.size()) / easy_arcs)))
    , m_most_rounds((std::max)(1, (std::min)(largest_number_of_rounds, quads_of_all_rounds / mesh.number_of_faces())))
  {
  }

  int number_of_rounds() const { return m_most_rounds; }
  const Layout_cost& cost() const { return m_cost; }

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
    if(quads > 0)
      m_scale =
        (std::max)(1., first_scale * std::sqrt(double(m_quantization.number_of_quads(m_quantization.length)) / quads));
    std::vector<int> before;
    for(int futile = 0; futile < futile_scales && m_scale < largest_scale && !is_coarse() && go_further();)
    {
      before = m_quantization.length;
      m_scale *= scale_step;
      m_quantization.shorten(m_scale, go_further);
      record();
      futile = m_quantization.length == before ? futile + 1 : 0;
    }
  }

  // Tries so many layouts in each round; ends with the best one. `runners_up` gets what was the best one for a while,
  // the best last.
  template <typename GoFurther>
  void anneal(int attempts, std::size_t target_patches, std::vector<std::vector<int>>& runners_up,
              const GoFurther& go_further)
  {
    m_cost.start(target_patches);
    anneal_further(attempts, runners_up, go_further);
  }

  // Goes on, with less distortion if the shape of those so far was not accepted; false if there have been too many
  // rounds.
  template <typename GoFurther>
  bool anneal_again(int attempts, bool with_caution, std::vector<std::vector<int>>& runners_up,
                    const GoFurther& go_further)
  {
    if(m_rounds >= m_most_rounds)
      return false;
    m_cost.allow_more_quads();
    if(with_caution)
      m_cost.avoid_distortion();
    anneal_further(attempts, runners_up, go_further);
    return true;
  }

private:
  template <typename GoFurther>
  void anneal_further(int attempts, std::vector<std::vector<int>>& runners_up, const GoFurther& go_further)
  {
    if(m_quantization.length.empty())
      return;
    bool again = true;
    for(int round = 0; round < rounds_at_once && again && go_further(); ++round)
    {
      anneal_once(static_cast<int>((m_rounds < rounds_at_once ? 1 : m_effort) * attempts), runners_up, go_further);
      again = ++m_rounds < m_most_rounds && !m_cost.has_reached_goals();
    }
    if(runners_up.empty() || runners_up.back() != m_quantization.length)
      runners_up.push_back(m_quantization.length);
  }

  template <typename GoFurther>
  void anneal_once(int attempts, std::vector<std::vector<int>>& runners_up, const GoFurther& go_further)
  {
    std::vector<int>& length = m_quantization.length;
    double now = m_cost(Layout_cost::forbidden), best = now;
    std::vector<int> best_length = length, before;
    std::vector<double> price = m_cost.distortion().prices(length);
    for(int i = 0; i < attempts && go_further(); ++i)
    {
      before = length;
      const int paths = m_random.get_double() < 0.6 ? 1 : 2;
      bool changed = true;
      for(int k = 0; k < paths && changed; ++k)
      {
        const double r = m_random.get_double();
        const int arc = m_random.get_int(0, static_cast<int>(length.size()));
        const int by = m_random.get_bool() ? 1 : -1;
        changed = m_quantization.change(
          arc, by, [&](std::size_t a, int change) { return change * price[a]; }, Layout_weights::largest_edge * r * r,
          false);
      }
      const double temperature =
        first_temperature * std::pow(last_temperature / first_temperature, double(i) / attempts);
      const double limit = now - temperature * std::log(1 - m_random.get_double());
      const double c = changed ? m_cost(limit) : Layout_cost::forbidden;
      if(c <= limit)
      {
        now = c;
        price = m_cost.distortion().prices(length);
      }
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
  double m_scale = 1, m_effort;
  int m_most_rounds, m_rounds = 0;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_STRUCTURE_INTERNAL_LAYOUT_SEARCH_H
