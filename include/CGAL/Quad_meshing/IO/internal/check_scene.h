// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_IO_INTERNAL_CHECK_SCENE_H
#define CGAL_QUAD_MESHING_IO_INTERNAL_CHECK_SCENE_H

#include <CGAL/Quad_meshing/IO/Scene.h>
#include <CGAL/Quad_meshing/IO/Scene_writing_result.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// What keeps a layer from being shown; empty if nothing does.
inline std::string defect_of_layer(const Scene_layer& layer)
{
  if(layer.first_corner.empty() || layer.first_corner.front() != 0 || layer.first_corner.back() != layer.corners.size())
    return "the first corners do not begin with 0 and end with the number of all corners";
  const std::size_t fewest = layer.kind == Scene_layer_kind::FACES ? 3 : layer.kind == Scene_layer_kind::LINES ? 2 : 1;
  for(std::size_t i = 0; i < layer.size(); ++i)
    if(layer.first_corner[i + 1] < layer.first_corner[i] + fewest)
      return "element " + std::to_string(i) + " has fewer than " + std::to_string(fewest) + " corners";
  if(std::any_of(layer.corners.begin(), layer.corners.end(), [&](std::size_t c) { return c >= layer.points.size(); }))
    return "a corner names a point that is not there";
  for(const std::array<double, 3>& p : layer.points)
    if(!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2]))
      return "a coordinate is not finite";
  if(!layer.grid.empty() && layer.grid.size() != layer.corners.size())
    return "there are not as many pairs of grid coordinates as corners";
  for(const Scene_numbers& n : layer.numbers)
    if(n.values.size() != layer.size())
      return "there are not as many values of '" + n.name + "' as elements";
  if(layer.colored_by < -1 || layer.colored_by >= static_cast<int>(layer.numbers.size()))
    return "the numbers that color it are not there";
  return std::string();
}

// Whether all layers of a scene are consistent.
inline Scene_writing_result check_scene(const Scene& scene)
{
  Scene_writing_result result;
  for(const Scene_layer& layer : scene.layers)
  {
    const std::string defect = defect_of_layer(layer);
    if(!defect.empty())
    {
      result.status = Scene_writing_status::INVALID_SCENE;
      result.message = "The layer '" + layer.name + "' cannot be written: " + defect + ".";
      return result;
    }
  }
  return result;
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_IO_INTERNAL_CHECK_SCENE_H
