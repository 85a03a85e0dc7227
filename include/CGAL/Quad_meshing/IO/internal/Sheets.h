// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_IO_INTERNAL_SHEETS_H
#define CGAL_QUAD_MESHING_IO_INTERNAL_SHEETS_H

#include <CGAL/Quad_meshing/IO/Mesh_reading_result.h>
#include <CGAL/Quad_meshing/IO/internal/Side_groups.h>
#include <CGAL/Quad_meshing/IO/internal/Signed_sets.h>
#include <CGAL/Quad_meshing/IO/internal/Soup_triangles.h>
#include <CGAL/Quad_meshing/IO/internal/soup_geometry.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Joins the triangles of a soup at their sides and orients them, without moving anything:
//
//  1. two sides that no other triangle shares, between the same two vertices of the file, are joined;
//  2. of the sides that are left, two that lie between the same places and no third one are joined;
//  3. at an edge with more sides these are paired: where they alternate, as at solids that touch along an edge, around
//     the material between them, else by straightness; a side without a partner stays at the border.
//
// Joined triangles get one orientation, that of the majority of them in the file. Where 1 makes a surface with one side
// only the soup is refused, and where 2 joins different parts of the file to such a surface. A border of the file that
// would have to be closed to one side only, as the cut of a Moebius strip, stays open, and so does a pair of 3.
class Sheets
{
  Soup_triangles& m_triangles;
  const Mesh_repairs& m_repairs;
  std::vector<Soup_index> m_partner; // per side: the one it is joined to
  Signed_sets m_orientation{ 0 };
  std::vector<Soup_index> m_part; // per triangle: its part of the surface as the file joins it
  std::vector<char> m_is_turned;  // per triangle: whether its orientation changes; empty: none

  struct Fan
  {
    Soup_index low, high;
    std::vector<Soup_index> sides;
  };
  std::vector<Fan> m_fans;

public:
  std::size_t reversed_faces = 0;
  bool joins_places = false; // whether sides between different vertices were joined

  Sheets(Soup_triangles& triangles, const Mesh_repairs& repairs) : m_triangles(triangles), m_repairs(repairs) {}

  // `joined` are pairs of sides that belong together whatever other sides there are; `groups` are the sides between the
  // same vertices of the file. Returns false if the result says why not.
  bool operator()(const std::vector<std::array<Soup_index, 2>>& joined, const Side_groups& groups,
                  Mesh_reading_result& result)
  {
    m_partner.assign(m_triangles.number_of_sides(), no_index);
    for(const auto& pair : joined)
      join_sides(pair[0], pair[1]);
    const std::vector<Soup_index> left = join_sides_of_file(groups);
    if(m_is_oriented && left.empty() && m_triangles.other_side.empty())
      return true;
    m_orientation = Signed_sets(m_triangles.size());
    if(!orient_parts_of_file(result))
      return false;
    if(!join_sides_at_places(left, result))
      return false;
    if(!m_fans.empty() && !m_repairs.separate_sheets)
      return refuse(result, Mesh_reading_status::NEEDS_REPAIR,
                    "There " + std::string(m_fans.size() == 1 ? "is " : "are ") +
                      count_of(m_fans.size(), "edge", "edges") + " with more than two faces.");
    choose_orientations();
    pair_alternating_fans();
    pair_other_fans();
    choose_orientations();
    return turn_triangles(result);
  }

  std::vector<Soup_index>& partners() { return m_partner; }

  std::size_t number_of_fans() const { return m_fans.size(); }

private:
  bool m_is_oriented = true;

  static bool refuse(Mesh_reading_result& result, Mesh_reading_status status, const std::string& message)
  {
    result.status = status;
    result.message = message;
    return false;
  }

  bool runs_upwards(std::size_t side) const { return m_triangles.source_place(side) < m_triangles.target_place(side); }

  void join_sides(std::size_t a, std::size_t b)
  {
    m_partner[a] = static_cast<Soup_index>(b);
    m_partner[b] = static_cast<Soup_index>(a);
    m_is_oriented = m_is_oriented && runs_upwards(a) != runs_upwards(b);
    joins_places = joins_places ||
                   (m_triangles.source(a) != m_triangles.target(b) && m_triangles.source(a) != m_triangles.source(b)) ||
                   (m_triangles.target(a) != m_triangles.source(b) && m_triangles.target(a) != m_triangles.target(b));
  }

  // Returns the sides that may still find a partner.
  std::vector<Soup_index> join_sides_of_file(const Side_groups& groups)
  {
    std::vector<Soup_index> left, group;
    groups.for_each(
      [&](Soup_index, Soup_index, const std::vector<Soup_index>& sides)
      {
        group.clear();
        for(Soup_index s : sides)
          if(m_partner[s] == no_index)
            group.push_back(s);
        if(group.size() == 2)
          join_sides(group[0], group[1]);
        else if(group.size() > 2 || (group.size() == 1 && !m_triangles.place.empty()))
          left.insert(left.end(), group.begin(), group.end());
      });
    return left;
  }

  bool join_orientations(Soup_index a, Soup_index b)
  {
    return m_orientation.join(a / 3, b / 3, runs_upwards(a) == runs_upwards(b));
  }

  bool refuse_one_side(Mesh_reading_result& result) const
  {
    return refuse(
      result, Mesh_reading_status::NOT_ORIENTABLE,
      "The surface is not orientable: a strip of faces comes back to where it began with its other side up, as "
      "in a Moebius strip.");
  }

  bool orient_parts_of_file(Mesh_reading_result& result)
  {
    for(std::size_t s = 0; s < m_partner.size(); ++s)
      if(m_partner[s] != no_index && s < m_partner[s] && !join_orientations(static_cast<Soup_index>(s), m_partner[s]))
        return refuse_one_side(result);
    m_part.resize(m_triangles.size());
    for(std::size_t f = 0; f < m_part.size(); ++f)
      m_part[f] = m_orientation.find(f).first;
    return true;
  }

  bool join_sides_at_places(std::vector<Soup_index> left, Mesh_reading_result& result)
  {
    typedef std::pair<Soup_index, Soup_index> Ends;
    auto ends = [&](Soup_index s)
    {
      const Soup_index a = m_triangles.source_place(s), b = m_triangles.target_place(s);
      return Ends((std::min)(a, b), (std::max)(a, b));
    };
    std::sort(left.begin(), left.end(),
              [&](Soup_index s, Soup_index t) { return std::make_pair(ends(s), s) < std::make_pair(ends(t), t); });
    for(std::size_t i = 0, j; i < left.size(); i = j)
    {
      const Ends edge = ends(left[i]);
      for(j = i + 1; j < left.size() && ends(left[j]) == edge;)
        ++j;
      if(j - i > 2)
        m_fans.push_back({ edge.first, edge.second, std::vector<Soup_index>(left.begin() + i, left.begin() + j) });
      else if(j - i == 2)
      {
        if(join_orientations(left[i], left[i + 1]))
          join_sides(left[i], left[i + 1]);
        else if(m_part[left[i] / 3] != m_part[left[i + 1] / 3])
          return refuse_one_side(result);
      }
    }
    return true;
  }

  // Whether a triangle is turned: each set of joined triangles follows the majority of those that have only one side in
  // the file. Sets without such triangles are turned outwards where they are closed, and else stay as their first
  // triangle.
  void choose_orientations()
  {
    const std::size_t nf = m_triangles.size();
    struct Set
    {
      std::size_t number = 0, number_reversed = 0;
      double volume = 0;
      bool is_closed = true;
    };
    std::vector<Set> sets(nf);
    for(std::size_t f = 0; f < nf; ++f)
    {
      const auto found = m_orientation.find(f);
      Set& set = sets[found.first];
      if(m_triangles.other_side_of(f) == no_index)
      {
        ++set.number;
        set.number_reversed += found.second;
      }
      for(std::size_t k = 0; k < 3; ++k)
        set.is_closed = set.is_closed && m_partner[3 * f + k] != no_index;
      const Polygon_soup::Point& o = m_triangles.point(found.first, 0);
      const double volume =
        soup_dot(soup_difference(m_triangles.point(f, 0), o),
                 soup_cross(soup_difference(m_triangles.point(f, 1), o), soup_difference(m_triangles.point(f, 2), o)));
      set.volume += found.second ? -volume : volume;
    }
    m_is_turned.assign(nf, 0);
    for(std::size_t f = 0; f < nf; ++f)
    {
      const auto found = m_orientation.find(f);
      const Set& set = sets[found.first];
      const bool turns_set = set.number > 0 ? 2 * set.number_reversed > set.number : set.is_closed && set.volume < 0;
      m_is_turned[f] = found.second != turns_set;
    }
  }

  // The sides of a fan with their angle around the edge, sorted. Of two at one angle the one that runs upwards comes
  // first: there is nothing between them, so they bound the outside.
  struct Sheet
  {
    double angle;
    Soup_index side;
    bool upwards; // in the orientation chosen last
  };

  std::vector<Sheet> sorted_sheets(const Fan& fan) const
  {
    const Angles_around_edge angle(m_triangles.points[fan.low], m_triangles.points[fan.high]);
    std::vector<Sheet> sheets;
    for(Soup_index s : fan.sides)
      sheets.push_back({ angle(m_triangles.points[m_triangles.source(Soup_triangles::previous(s))]), s,
                         runs_upwards(s) != (m_is_turned[s / 3] != 0) });
    std::sort(sheets.begin(), sheets.end(),
              [](const Sheet& a, const Sheet& b) { return std::tie(a.angle, a.side) < std::tie(b.angle, b.side); });
    constexpr double same_angle = 1e-9; // radians
    for(std::size_t i = 0; i + 1 < sheets.size(); ++i)
      if(sheets[i + 1].angle - sheets[i].angle < same_angle && !sheets[i].upwards && sheets[i + 1].upwards)
        std::swap(sheets[i], sheets[i + 1]);
    return sheets;
  }

  // Counterclockwise about the edge, what follows an upward sheet is outside; so the material lies between it and the
  // downward sheet before it.
  void pair_alternating_fans()
  {
    for(Fan& fan : m_fans)
    {
      const std::vector<Sheet> sheets = sorted_sheets(fan);
      const std::size_t n = sheets.size();
      bool alternates = n % 2 == 0;
      for(std::size_t i = 0; i < n; ++i)
        alternates = alternates && sheets[i].upwards != sheets[(i + 1) % n].upwards;
      if(!alternates)
        continue;
      for(std::size_t i = 0; i < n; ++i)
        if(sheets[i].upwards)
          join_if_orientable(sheets[i].side, sheets[(i + n - 1) % n].side);
    }
  }

  void join_if_orientable(Soup_index a, Soup_index b)
  {
    if(m_partner[a] == no_index && m_partner[b] == no_index && join_orientations(a, b))
      join_sides(a, b);
  }

  // The straightest pair first. Before that, pairs of faces that are both there in one direction, or both in two: a
  // sheet with two sides that stands off a solid does not open it. Where the file orients its faces consistently, pairs
  // that agree with that come before those that would turn a part of the surface.
  void pair_other_fans()
  {
    struct Pair
    {
      bool is_mixed, turns;
      double bend;
      Soup_index a, b;
    };
    const bool is_reliable = std::find(m_is_turned.begin(), m_is_turned.end(), char(1)) == m_is_turned.end();
    auto has_two_sides = [&](const Sheet& sheet) { return m_triangles.other_side_of(sheet.side / 3) != no_index; };
    std::vector<Pair> pairs;
    for(const Fan& fan : m_fans)
    {
      pairs.clear();
      const std::vector<Sheet> sheets = sorted_sheets(fan);
      // Among many sheets each looks at those nearest to its continuation only.
      const std::size_t n = sheets.size();
      constexpr std::size_t many = 32, number_of_candidates = 8;
      for(std::size_t i = 0; i < n; ++i)
      {
        const double opposite = sheets[i].angle + (sheets[i].angle < CGAL_PI ? CGAL_PI : -CGAL_PI);
        const auto found = std::lower_bound(sheets.begin(), sheets.end(), opposite,
                                            [](const Sheet& sheet, double a) { return sheet.angle < a; });
        const std::size_t at = static_cast<std::size_t>(found - sheets.begin());
        const std::size_t first = n <= many ? i + 1 : at + n - number_of_candidates / 2;
        const std::size_t last = n <= many ? n : first + number_of_candidates;
        for(std::size_t k = first; k < last; ++k)
        {
          const std::size_t j = k % n;
          if(i == j || m_partner[sheets[i].side] != no_index || m_partner[sheets[j].side] != no_index)
            continue;
          pairs.push_back({ has_two_sides(sheets[i]) != has_two_sides(sheets[j]),
                            is_reliable && sheets[i].upwards == sheets[j].upwards,
                            std::abs(std::abs(sheets[i].angle - sheets[j].angle) - CGAL_PI),
                            (std::min)(sheets[i].side, sheets[j].side), (std::max)(sheets[i].side, sheets[j].side) });
        }
      }
      std::sort(
        pairs.begin(), pairs.end(),
        [](const Pair& s, const Pair& t)
        { return std::tie(s.is_mixed, s.turns, s.bend, s.a, s.b) < std::tie(t.is_mixed, t.turns, t.bend, t.a, t.b); });
      for(const Pair& pair : pairs)
        join_if_orientable(pair.a, pair.b);
    }
  }

  bool turn_triangles(Mesh_reading_result& result)
  {
    // Sides 0, 1, 2 of a triangle that is turned become sides 1, 0, 2.
    static constexpr std::array<std::size_t, 3> turned = { { 1, 0, 2 } };
    std::vector<Soup_index> partner(m_partner.size());
    auto new_number = [&](Soup_index s)
    { return s == no_index || !m_is_turned[s / 3] ? s : static_cast<Soup_index>(3 * (s / 3) + turned[s % 3]); };
    for(std::size_t s = 0; s < partner.size(); ++s)
      partner[new_number(static_cast<Soup_index>(s))] = new_number(m_partner[s]);
    m_partner.swap(partner);

    Soup_index last_face = no_index;
    for(std::size_t f = 0; f < m_triangles.size(); ++f)
    {
      if(!m_is_turned[f])
        continue;
      std::swap(m_triangles.corners[f][0], m_triangles.corners[f][2]);
      if(m_triangles.other_side_of(f) != no_index)
        m_triangles.file_face[f] = m_triangles.other_side[f]; // it is there in this direction too
      else if(m_triangles.file_face[f] != last_face)
      {
        last_face = m_triangles.file_face[f];
        ++reversed_faces;
      }
    }
    if(reversed_faces > 0 && !m_repairs.orient_faces)
      return refuse(result, Mesh_reading_status::NEEDS_REPAIR,
                    "The orientation of the faces is not consistent: " + count_of(reversed_faces, "face", "faces") +
                      " would have to be reversed.");
    return true;
  }
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_IO_INTERNAL_SHEETS_H
