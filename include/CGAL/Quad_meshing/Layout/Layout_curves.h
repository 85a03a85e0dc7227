// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_LAYOUT_LAYOUT_CURVES_H
#define CGAL_QUAD_MESHING_LAYOUT_LAYOUT_CURVES_H

#include <CGAL/Quad_meshing/Layout/Arc_subdivision.h>
#include <CGAL/Quad_meshing/Layout/Feature_bends.h>
#include <CGAL/Quad_meshing/Layout/Layout_quantization.h>
#include <CGAL/Quad_meshing/Layout/Motorcycle_complex.h>
#include <CGAL/Quad_meshing/internal/Disjoint_sets.h>
#include <CGAL/Quad_meshing/internal/Dual_lines.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The dual curves of a layout. Each of them can be replaced by any number of parallel ones, which changes the
// number of quads but nothing in the structure. All edges that a curve crosses are divided into the same number then;
// so it is good if their lengths in the input are about the same.
class Layout_curves
{
public:
  // Largest distance of a chord of a feature from it, in edges of the mesh that is made, and how much of one
  // may be missing in the number of chords that this takes.
  static constexpr double feature_distance = 0.1, spared_chord = 0.2;

  // No limit for the number of parallel curves.
  static constexpr int any_multiplicity = (std::numeric_limits<int>::max)();

  std::vector<int> of_edge;        // per edge of the subdivision of the arcs
  std::vector<double> edge_length; // per curve: mean length of the edges that it crosses, in edges of the input

  Layout_curves(const Layout_quantization& quantization, const std::vector<int>& length)
    : m_quantization(quantization), m_length(length)
  {
    const Motorcycle_complex& complex = quantization.complex();
    const Arc_subdivision s = quantization.subdivision(length);
    Disjoint_sets curves(s.number_of_edges());
    std::vector<int> one, other;
    for(const Motorcycle_complex::Patch& p : complex.patches)
      for(int k = 0; k < 2; ++k)
      {
        s.edges_of(p.sides[k], one);
        s.edges_of(p.sides[k + 2], other);
        for(std::size_t i = 0; i < one.size(); ++i)
          curves.join(one[i], other[one.size() - 1 - i]);
      }
    of_edge.resize(s.number_of_edges());
    std::vector<int> crossings;
    for(int e = 0; e < s.number_of_edges(); ++e)
    {
      const int root = curves.smallest(e);
      of_edge[e] = root == e ? static_cast<int>(crossings.size()) : of_edge[root];
      if(root == e)
        crossings.push_back(0);
      ++crossings[of_edge[e]];
    }

    edge_length.assign(crossings.size(), 0);
    m_largest.assign(crossings.size(), any_multiplicity);
    m_bend.assign(crossings.size(), 0);
    for_each_edge([&](int curve, double l) { edge_length[curve] += l / crossings[curve]; });
  }

  // Asks for as many parallel curves as it takes to follow the features of the input where they bend.
  void follow(const Feature_bends& bends)
  {
    for_each_feature_edge(bends,
                          [&](int curve, double, double bend) { m_bend[curve] = (std::max)(m_bend[curve], bend); });
  }

  // Limits how many parallel ones replace each curve, unless it takes more to follow a feature.
  void limit_multiplicities(std::vector<int> largest) { m_largest = std::move(largest); }

  const std::vector<int>& largest_multiplicities() const { return m_largest; }

  // How far features are from the edges when each curve is replaced by so many: by how much their distance exceeds
  // the largest one, in units of this; mean over the length of the features.
  double feature_misfit(const Feature_bends& bends, const std::vector<int>& multiplicity) const
  {
    double sum = 0, length = 0;
    for_each_feature_edge(bends,
                          [&](int curve, double l, double bend)
                          {
                            const double distance = bend / (8 * multiplicity[curve] * multiplicity[curve]);
                            sum += l * (std::max)(0., distance / feature_distance - 1);
                            length += l;
                          });
    return length > 0 ? sum / length : 0;
  }

  int number_of_curves() const { return static_cast<int>(edge_length.size()); }

  // The lengths of the arcs when each curve is replaced by so many.
  std::vector<int> lengths(const std::vector<int>& multiplicity) const
  {
    std::vector<int> result(m_length.size(), 0);
    for(std::size_t a = 0, e = 0; a < m_length.size(); ++a)
      for(int i = 0; i < m_length[a]; ++i, ++e)
        result[a] += multiplicity[of_edge[e]];
    return result;
  }

  // The curve that crosses each edge of the subdivision of the arcs when each curve is replaced by so many.
  std::vector<int> curves_of_edges(const std::vector<int>& multiplicity) const
  {
    std::vector<int> result;
    for(std::size_t a = 0, e = 0; a < m_length.size(); ++a)
      for(int i = 0; i < m_length[a]; ++i, ++e)
        result.insert(result.end(), multiplicity[of_edge[e]], of_edge[e]);
    return result;
  }

  // The lengths such that edges get about a given length.
  std::vector<int> lengths(double aim) const { return lengths(multiplicities(aim)); }

  std::vector<int> multiplicities(double aim) const
  {
    std::vector<int> result;
    for(std::size_t c = 0; c < edge_length.size(); ++c)
    {
      const int even =
        (std::min)((std::max)(1, static_cast<int>(std::floor(edge_length[c] / aim + 0.5))), m_largest[c]);
      result.push_back((std::max)(even, number_of_chords(static_cast<int>(c), aim)));
    }
    return result;
  }

  // Whether a curve may be replaced by so many parallel ones.
  bool allows(int curve, int multiplicity) const
  {
    return multiplicity <= m_largest[curve] && multiplicity >= (std::max)(1, number_of_chords(curve, 1));
  }

  // About the lengths of the input, but no more quads than that.
  std::vector<int> multiplicities_within(int most_quads) const
  {
    // How often the aim is corrected, and by how much more than needed.
    constexpr int corrections = 5;
    constexpr double margin = 1.02;
    double aim = 1;
    std::vector<int> result = multiplicities(aim);
    for(int i = 0; i < corrections; ++i)
    {
      const double quads = m_quantization.number_of_quads(lengths(result));
      if(quads <= most_quads)
        break;
      aim *= margin * std::sqrt(quads / most_quads);
      result = multiplicities(aim);
    }
    return result;
  }

private:
  // How many chords follow the bends of the features that a curve crosses, with edges of about a given length.
  int number_of_chords(int curve, double aim) const
  {
    return static_cast<int>(std::ceil(std::sqrt(m_bend[curve] / (8 * feature_distance * aim)) - spared_chord));
  }

  // Calls f(curve, length in the input) for all edges.
  template <typename Function>
  void for_each_edge(const Function& f) const
  {
    for(std::size_t a = 0, e = 0; a < m_length.size(); ++a)
      for(int i = 0; i < m_length[a]; ++i, ++e)
        f(of_edge[e], double(m_quantization.complex().arcs[a].length()) / m_length[a]);
  }

  // Calls f(curve, length, bend) for the edges of features.
  template <typename Function>
  void for_each_feature_edge(const Feature_bends& bends, const Function& f) const
  {
    for(std::size_t a = 0, e = 0; a < m_length.size(); e += m_length[a], ++a)
      if(!bends.is_straight(a))
        for(int i = 0; i < m_length[a]; ++i)
        {
          const double step = double(m_quantization.complex().arcs[a].length()) / m_length[a];
          const double from = i * step,
                       to = i + 1 == m_length[a] ? m_quantization.complex().arcs[a].length() : (i + 1) * step;
          f(of_edge[e + i], bends.length(a, from, to), bends.bend(a, from, to));
        }
  }

  const Layout_quantization& m_quantization;
  const std::vector<int>& m_length;
  std::vector<int> m_largest; // per curve: largest number of parallel ones
  std::vector<double> m_bend; // per curve: largest bend of a feature edge that it crosses and has to follow
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_LAYOUT_LAYOUT_CURVES_H
