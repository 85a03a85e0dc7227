// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PIPELINE_INTERNAL_GUIDE_LAYERS_H
#define CGAL_QUAD_MESHING_PIPELINE_INTERNAL_GUIDE_LAYERS_H

#include <CGAL/Quad_meshing/IO/scene_layers.h>
#include <CGAL/Quad_meshing/Pipeline/Quadrangulation_options.h>

#include <array>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Curves or strokes, as they were drawn.
template <typename Curve>
void add_layer_of_curves(Scene& scene, const std::vector<Curve>& curves, const std::string& name,
                         const std::string& color)
{
  std::vector<std::vector<Guide_curve::Point_3>> lines;
  for(const Curve& c : curves)
  {
    lines.push_back(c.points);
    if(c.is_closed && !c.points.empty())
      lines.back().push_back(c.points.front());
  }
  Scene_layer layer = make_polylines_layer(lines, name, "Guides");
  layer.color = color;
  if(layer.size() > 0)
    scene.layers.push_back(layer);
}

// What the user has drawn. Points are shown where they are given, before they are projected to the surface.
inline void add_layers_of_guides(Scene& scene, const Quadrangulation_options& options)
{
  add_layer_of_curves(scene, options.feature_curves, "curves as drawn", "#c000c0");
  add_layer_of_curves(scene, options.strokes, "strokes as drawn", "#008080");
  Scene_layer points;
  points.name = "places of irregular vertices";
  points.group = "Guides";
  points.kind = Scene_layer_kind::POINTS;
  Scene_numbers index;
  index.name = "index";
  index.unit = "quarters";
  index.scale = Scene_color_scale::SIGNED;
  for(const Index_guide& g : options.index_guides)
    if(!g.is_sum && !(g.radius > 0))
    {
      points.add_element(std::array<std::size_t, 1>{ { points.add_point(coordinates(g.point)) } });
      index.values.push_back(g.index);
    }
  points.numbers = { index };
  points.colored_by = 0;
  if(points.size() > 0)
    scene.layers.push_back(points);
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_PIPELINE_INTERNAL_GUIDE_LAYERS_H
