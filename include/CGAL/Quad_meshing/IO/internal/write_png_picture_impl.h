// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_IO_INTERNAL_WRITE_PNG_PICTURE_IMPL_H
#define CGAL_QUAD_MESHING_IO_INTERNAL_WRITE_PNG_PICTURE_IMPL_H

#include <CGAL/Quad_meshing/IO/internal/Png_encoder.h>
#include <CGAL/Quad_meshing/IO/internal/Scene_rasterizer.h>
#include <CGAL/Quad_meshing/IO/internal/check_scene.h>
#include <CGAL/Quad_meshing/IO/write_png_picture.h>

#include <algorithm>
#include <cstddef>
#include <ostream>

namespace CGAL {
namespace Quad_meshing {

CGAL_QUAD_MESHING_INLINE Scene_writing_result write_png_picture(std::ostream& os, const Scene& scene,
                                                                const Png_picture_options& options)
{
  Scene_writing_result result = internal::check_scene(scene);
  if(!result.is_valid())
    return result;
  const int width = (std::max)(options.width, 1), height = (std::max)(options.height, 1);
  internal::Scene_rasterizer rasterizer(width, height);
  rasterizer.draw(scene, options.side);
  internal::Png_encoder::write(os, rasterizer.pixels(), static_cast<std::size_t>(width));
  os.flush();
  result.message = "The picture was written.";
  if(!os)
  {
    result.status = Scene_writing_status::WRITING_FAILED;
    result.message = "The picture could not be written.";
  }
  return result;
}

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_IO_INTERNAL_WRITE_PNG_PICTURE_IMPL_H
