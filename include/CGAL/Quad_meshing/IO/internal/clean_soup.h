// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_IO_INTERNAL_CLEAN_SOUP_H
#define CGAL_QUAD_MESHING_IO_INTERNAL_CLEAN_SOUP_H

#include <CGAL/Quad_meshing/IO/internal/Soup_file_reader.h>

#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

typedef std::pair<std::size_t, std::size_t> Soup_edge; // its vertices in ascending order

inline Soup_edge soup_edge(const Polygon_soup::Polygon& polygon, std::size_t k)
{
  return std::minmax(polygon[k], polygon[k + 1 == polygon.size() ? 0 : k + 1]);
}

// How well the polygons of a soup fit together.
struct Soup_fit
{
  std::size_t border_edges = 0;        // edges with one polygon
  std::size_t non_manifold_edges = 0;  // edges with more than two polygons
};

inline Soup_fit fit_of_soup(const Polygon_soup& soup)
{
  std::vector<Soup_edge> edges;
  for(const Polygon_soup::Polygon& polygon : soup.polygons)
    for(std::size_t k = 0; k < polygon.size(); ++k)
      edges.push_back(soup_edge(polygon, k));
  std::sort(edges.begin(), edges.end());

  Soup_fit fit;
  for(std::size_t i = 0, j; i < edges.size(); i = j)
  {
    for(j = i; j < edges.size() && edges[j] == edges[i];)
      ++j;
    fit.border_edges += (j - i == 1);
    fit.non_manifold_edges += (j - i > 2);
  }
  return fit;
}

// Drops fins: pairs of polygons with the same vertices that bound nothing, as they stand off a
// surface that is complete without them. A pair of which one polygon would be missed, since another
// polygon needs it for a neighbor, stays. Returns the number of polygons dropped.
inline std::size_t drop_fins(Polygon_soup& soup)
{
  // Groups of polygons with the same vertices, in the order of their first polygon.
  std::map<Polygon_soup::Polygon, std::vector<std::size_t> > groups;
  {
    std::vector<std::pair<Polygon_soup::Polygon, std::size_t> > sorted;
    for(std::size_t f = 0; f < soup.polygons.size(); ++f)
    {
      Polygon_soup::Polygon key = soup.polygons[f];
      std::sort(key.begin(), key.end());
      sorted.emplace_back(std::move(key), f);
    }
    std::sort(sorted.begin(), sorted.end());
    for(std::size_t i = 0; i + 1 < sorted.size(); ++i)
      if(sorted[i].first == sorted[i + 1].first)
      {
        std::vector<std::size_t>& group = groups[sorted[i].first];
        if(group.empty())
          group.push_back(sorted[i].second);
        group.push_back(sorted[i + 1].second);
      }
  }

  struct Fin { std::size_t first, second; };
  std::vector<Fin> fins;
  for(const auto& group : groups)
    if(group.second.size() == 2)
      fins.push_back({ group.second[0], group.second[1] });
  if(fins.empty())
    return 0;

  // The number of polygons at the edges of fins once all fins are gone.
  std::map<Soup_edge, std::size_t> number_left;
  for(const Fin& fin : fins)
    for(std::size_t k = 0; k < soup.polygons[fin.first].size(); ++k)
      number_left[soup_edge(soup.polygons[fin.first], k)] = 0;
  std::vector<char> is_dropped(soup.polygons.size(), 0);
  for(const Fin& fin : fins)
    is_dropped[fin.first] = is_dropped[fin.second] = 1;
  for(std::size_t f = 0; f < soup.polygons.size(); ++f)
  {
    for(std::size_t k = 0; k < soup.polygons[f].size() && !is_dropped[f]; ++k)
    {
      const auto found = number_left.find(soup_edge(soup.polygons[f], k));
      if(found != number_left.end())
        ++found->second;
    }
  }

  // A pair with a lonely neighbor stays with one polygon, which may make others stay.
  for(bool changed = true; changed;)
  {
    changed = false;
    for(const Fin& fin : fins)
    {
      const Polygon_soup::Polygon& polygon = soup.polygons[fin.first];
      bool is_missed = false;
      for(std::size_t k = 0; k < polygon.size() && is_dropped[fin.first]; ++k)
        is_missed = is_missed || number_left[soup_edge(polygon, k)] == 1;
      if(!is_missed)
        continue;
      is_dropped[fin.first] = is_dropped[fin.second] = 0;
      for(std::size_t k = 0; k < polygon.size(); ++k)
        ++number_left[soup_edge(polygon, k)];
      changed = true;
    }
  }

  std::size_t kept = 0;
  for(std::size_t f = 0; f < soup.polygons.size(); ++f)
    if(!is_dropped[f])
    {
      if(kept != f)
        soup.polygons[kept] = std::move(soup.polygons[f]);
      ++kept;
    }
  const std::size_t dropped = soup.polygons.size() - kept;
  soup.polygons.resize(kept);
  return dropped;
}

// Makes polygons that visit each of their vertices once: repeated neighbors become one, polygons that
// pass through a vertex again are split there, and those with fewer than three vertices are dropped.
// Returns how many were dropped.
inline std::size_t make_polygons_simple(Polygon_soup& soup)
{
  typedef Polygon_soup::Polygon Polygon;

  auto drop_repetitions = [](Polygon& polygon)
  {
    polygon.erase(std::unique(polygon.begin(), polygon.end()), polygon.end());
    while(polygon.size() > 1 && polygon.front() == polygon.back())
      polygon.pop_back();
  };

  std::size_t dropped = 0, kept = 0;
  std::vector<Polygon> split_off;
  for(std::size_t f = 0; f < soup.polygons.size() + split_off.size(); ++f)
  {
    Polygon polygon = std::move(f < soup.polygons.size() ? soup.polygons[f] : split_off[f - soup.polygons.size()]);
    drop_repetitions(polygon);
    for(std::size_t i = 0; i < polygon.size(); ++i)
    {
      const auto begin = polygon.begin() + i;
      const auto again = std::find(begin + 1, polygon.end(), polygon[i]);
      if(again == polygon.end())
        continue;
      split_off.emplace_back(begin, again);
      polygon.erase(begin, again);
      drop_repetitions(polygon);
      --i;
    }
    if(polygon.size() < 3)
      ++dropped;
    else if(f < soup.polygons.size())
      soup.polygons[kept++] = std::move(polygon);
    else
      split_off[f - soup.polygons.size()] = std::move(polygon);
  }

  soup.polygons.resize(kept);
  for(Polygon& polygon : split_off)
    if(polygon.size() >= 3)
      soup.polygons.push_back(std::move(polygon));
  return dropped;
}

// Merges vertices at the same place, unless that harms. Returns how many polygons lost their shape by that.
inline std::size_t merge_vertices(Polygon_soup& soup, std::vector<std::string>& repairs)
{
  namespace PMP = Polygon_mesh_processing;

  {
    std::vector<Polygon_soup::Point_3> points = soup.points;
    std::vector<Polygon_soup::Polygon> no_polygons;
    if(PMP::merge_duplicate_points_in_polygon_soup(points, no_polygons) == 0)
      return 0;
  }

  // Merging is for gaps that the file format or a cut left, and for edges without length. Where sheets
  // that touch are told apart by their vertices alone it would destroy the surface, and where surfaces
  // meet in points only it changes nothing.
  Polygon_soup merged = soup;
  const std::size_t number_merged = PMP::merge_duplicate_points_in_polygon_soup(merged.points, merged.polygons);
  const std::size_t dropped = make_polygons_simple(merged);
  const Soup_fit before = fit_of_soup(soup), after = fit_of_soup(merged);
  if(after.non_manifold_edges > before.non_manifold_edges ||
     (after.border_edges >= before.border_edges && dropped == 0))
    return 0;
  repairs.push_back(count_of(number_merged, "vertex", "vertices") + " at the place of another one merged");
  soup = std::move(merged);
  return dropped;
}

// Merges vertices at the same place, drops vertices without a face, faces that are no polygons or
// are there twice, and fins. Says in `repairs` what it did.
inline void clean_soup(Polygon_soup& soup, std::vector<std::string>& repairs)
{
  namespace PMP = Polygon_mesh_processing;

  std::size_t dropped = make_polygons_simple(soup);
  dropped += merge_vertices(soup, repairs);
  const std::size_t fins = drop_fins(soup);
  dropped += PMP::merge_duplicate_polygons_in_polygon_soup(soup.points, soup.polygons);
  const std::size_t isolated = PMP::remove_isolated_points_in_polygon_soup(soup.points, soup.polygons);

  if(fins > 0)
    repairs.push_back(count_of(fins, "face", "faces") + " of fins without volume dropped");
  if(dropped > 0)
    repairs.push_back(count_of(dropped, "face", "faces") + " without a shape or equal to another one dropped");
  if(isolated > 0)
    repairs.push_back(count_of(isolated, "vertex", "vertices") + " without a face dropped");
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_IO_INTERNAL_CLEAN_SOUP_H
