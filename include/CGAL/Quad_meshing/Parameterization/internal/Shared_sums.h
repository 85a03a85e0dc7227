// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PARAMETERIZATION_INTERNAL_SHARED_SUMS_H
#define CGAL_QUAD_MESHING_PARAMETERIZATION_INTERNAL_SHARED_SUMS_H

#include <CGAL/Quad_meshing/Parameterization/internal/Seamless_coordinates.h>

#include <array>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The coordinates of a seamless map in short sums.
//
// Beyond a cut, a coordinate is that of its vertex plus a translation, which may be a sum of hundreds of integers: of
// those that were left when the relations around the irregular vertices were eliminated. The same sum occurs all along
// the cut. Here it is one term.
class Shared_sums
{
public:
  typedef Seamless_coordinates::Term Term;
  typedef std::vector<Term> Sum;

  explicit Shared_sums(const Seamless_coordinates& coordinates)
    : m_coordinates(coordinates), m_place(coordinates.coordinates.size(), { { -1, -1 } })
  {
    std::map<Sum, int> number;
    for(std::size_t w = 0; w < coordinates.coordinates.size(); ++w)
      for(int c = 0; c < 2; ++c)
        shorten(coordinates.coordinates[w][c], m_place[w][c], number);
    m_sums.resize(number.size());
    for(const auto& s : number)
      m_sums[s.second] = s.first;
  }

  int number_of_variables() const { return m_coordinates.number_of_variables(); }
  const std::vector<bool>& is_integer() const { return m_coordinates.is_integer; }

  // The terms of a coordinate of a wedge. Their numbers are those of variables and, from `number_of_variables()` on,
  // those of the sums.
  const Sum& terms(int wedge, int coordinate) const
  {
    const int place = m_place[wedge][coordinate];
    return place == -1 ? m_coordinates.coordinates[wedge][coordinate] : m_short[place];
  }

  const std::vector<Sum>& sums() const { return m_sums; }

private:
  void shorten(const Sum& terms, int& place, std::map<Sum, int>& number)
  {
    const std::size_t few = 2; // integers, that are left as they are
    Sum integers, rest;
    for(const Term& t : terms)
      (m_coordinates.is_integer[t.first] ? integers : rest).push_back(t);
    if(integers.size() <= few)
      return;
    const int next = static_cast<int>(number.size());
    rest.push_back(
      Term(number_of_variables() + number.insert(std::make_pair(std::move(integers), next)).first->second, 1.));
    place = static_cast<int>(m_short.size());
    m_short.push_back(std::move(rest));
  }

  const Seamless_coordinates& m_coordinates;
  std::vector<std::array<int, 2>> m_place; // per wedge and coordinate: in m_short; -1 if it is short by itself
  std::vector<Sum> m_short, m_sums;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_PARAMETERIZATION_INTERNAL_SHARED_SUMS_H
